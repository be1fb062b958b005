"""Relief in pixels: as shading before it is geometry, and never as both."""

from dataclasses import replace

import numpy as np
import pytest

from app.scene.offscreen import render_image
from app.state.view_state import ViewState
from sgb_core.curves.primitives import line
from sgb_core.curves.profile import Profile
from sgb_core.document import edits
from sgb_core.document.appearance.model import Layer, LayerKind
from sgb_core.document.body_state import body_state
from sgb_core.document.evaluation import evaluate
from sgb_core.document.model import Document

SIZE = (200, 240)
BARE = ViewState(segment=-1, show=frozenset({"surface"}))
TUBE = Document(Profile.of([line((40.0, 0.0), (40.0, 100.0))]))
TEXT = Layer(LayerKind.TEXT, start=0.35, end=0.65, count=6, text="HO", relief=1.5, edge=3.0)


def seen(document, body=None):
    picture = render_image(evaluate(document), BARE, SIZE, direction="front", body=body)
    # Where the tube's middle is: silhouettes differ by the depth.
    return picture[70:170, 60:140, :3].astype(float)


@pytest.mark.parametrize("depth", [1.5, -1.5])
@pytest.mark.parametrize("material", ["clay", "plaster", "metal"])
def test_relief_is_shading_before_it_is_geometry(material, depth):
    look = edits.set_appearance(
        TUBE, material=material, drawing=(replace(TEXT, relief=depth, color="#c0c0c0"),)
    )
    raised = edits.without_paint(look) if material == "clay" else look
    flat = edits.set_relief(raised, "layer", 0, depth=0.0)
    shaded, plain = seen(raised), seen(flat)
    made = seen(raised, body_state(raised, raised.surface, fine=True))
    # The letters' edges are seen, and where they are seen on the geometry.
    assert np.abs(made - plain).mean() > 1.0
    assert np.abs(made - shaded).mean() < 0.5 * np.abs(made - plain).mean()


def test_a_body_with_its_relief_is_not_shaded_as_if_it_had_another():
    solid = edits.set_solid(TUBE, kind="vessel", wall=4.0, base=4.0)
    raised = edits.set_appearance(solid, material="plaster", drawing=(TEXT,))
    coarse = body_state(raised, raised.surface, fine=False)
    fine = body_state(raised, raised.surface, fine=True)
    assert coarse.mesh is not None
    shaded, made = seen(raised, coarse), seen(raised, fine)
    flat = edits.set_relief(raised, "layer", 0, depth=0.0)
    plain = seen(flat, body_state(flat, flat.surface, fine=True))
    assert np.abs(made - shaded).mean() < 0.5 * np.abs(made - plain).mean()
