"""The picture behind the profile in the 3-D picture: upright in the profile's plane."""

import numpy as np
from vtkmodules.vtkRenderingCore import vtkRenderer, vtkRenderWindow

from app.scene.reference import ReferencePart
from sgb_core.document import edits
from tests.app.helpers import tower
from tests.app.profile_editor.test_reference import ORIGIN, SCALE, source


def corners(part):
    return np.array([part.actor.GetMapper().GetInput().GetPoint(k) for k in range(4)])


def test_it_stands_in_the_plane_where_the_turn_starts():
    renderer = vtkRenderer()
    vtkRenderWindow().AddRenderer(renderer)
    part = ReferencePart(renderer)
    document = edits.set_revolution(tower(), start_deg=90.0)
    part.update(None, document.surface)
    assert not part.actor.GetVisibility()
    part.update(source(), document.surface)
    assert part.actor.GetVisibility()
    places = corners(part)
    # At 90° the profile's plane is that of y and z.
    assert np.allclose(places[:, 0], 0.0, atol=1e-9)
    low = SCALE * np.array([-0.5 - ORIGIN[0], ORIGIN[1] - 99.5])
    high = SCALE * np.array([99.5 - ORIGIN[0], ORIGIN[1] + 0.5])
    assert np.allclose(places[:, 1:].min(axis=0), low)
    assert np.allclose(places[:, 1:].max(axis=0), high)
    part.update(source(opacity=0.25), document.surface)
    assert part.actor.GetProperty().GetOpacity() == 0.25
    part.update(None, document.surface)
    assert not part.actor.GetVisibility()
