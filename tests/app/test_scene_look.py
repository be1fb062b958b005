"""The looks in pixels, drawn off screen."""

import numpy as np
import pytest
from vtkmodules.vtkRenderingCore import vtkRenderer

from app.palette import LIGHT
from app.scene import Scene
from app.scene_offscreen import offscreen_window, render_image
from app.view_state import ViewState
from sgb_core.document import edits
from sgb_core.document.appearance import (
    ColourMap,
    Layer,
    LayerKind,
    Lighting,
    MapKind,
    MaterialName,
    Texture,
)
from sgb_core.document.body_state import body_state
from sgb_core.document.evaluation import evaluate
from tests.app.viewport_helpers import document, near

SIZE = (160, 180)
BARE = ViewState(segment=-1, show=frozenset({"surface"}))


def drawn(size=SIZE, doc=None, direction="iso", **changes):
    found = edits.set_appearance(document() if doc is None else doc, **changes)
    return render_image(evaluate(found), BARE, size, direction=direction).astype(int)


def middle(image):
    """The colour of the belly, left of the middle."""
    return np.median(image[120:135, 55:75, :3].reshape(-1, 3), axis=0)


def test_the_default_look_is_the_clay_of_the_theme():
    plain = render_image(evaluate(document()), BARE, SIZE, palette=LIGHT)
    red, green, blue = middle(plain.astype(int))
    assert green > red
    assert green > blue
    own = drawn(color="#d05040")
    red, green, blue = middle(own)
    assert red > 1.4 * green


def test_materials_and_lights_all_differ():
    pictures = [drawn(material=material) for material in MaterialName]
    pictures += [drawn(material="plaster", lighting=light) for light in list(Lighting)[1:]]
    for k, first in enumerate(pictures):
        for second in pictures[k + 1 :]:
            assert np.abs(first - second).mean() > 0.3


def test_a_shadow_darkens_the_ground_and_nothing_else():
    without, with_shadow = drawn(material="plaster"), drawn(material="plaster", shadow=True)
    change = (with_shadow - without)[..., :3].sum(axis=-1)
    assert change.min() < -60
    assert change.max() <= 6
    rows = np.flatnonzero((change < -30).any(axis=1))
    assert rows.min() > SIZE[1] // 2


@pytest.mark.parametrize(
    ("background", "wanted"), [("white", (255, 255, 255)), ("dark", (23, 25, 27))]
)
def test_backgrounds(background, wanted):
    assert drawn(background=background)[2, 2, :3].tolist() == list(wanted)


def test_a_transparent_ground_is_empty():
    image = drawn(background="transparent")
    assert image[2, 2, 3] == 0
    assert image[120, 60, 3] == 255


def test_a_band_is_seen_where_it_is_painted():
    layer = Layer(LayerKind.BAND, "#c00000", 0.4, 0.6)
    image = drawn(material="plaster", drawing=(layer,), direction="front")
    red = (image[..., 0] > 1.6 * image[..., 1]) & (image[..., 0] > 60)
    surface = np.abs(image - drawn(material="plaster", direction="back"))[..., 0] >= 0
    assert surface.any()
    rows = np.flatnonzero(red.sum(axis=1) > 10)
    # Seen from the front, the vase is fitted from top to bottom with the margin around.
    assert 0.36 < (SIZE[1] - rows.max()) / SIZE[1] < 0.48
    assert 0.52 < (SIZE[1] - rows.min()) / SIZE[1] < 0.62


def test_the_texture_has_no_seam():
    texture = Texture("brick", repeat=(8.0, 4.0))
    # The very same after a turn by one repeat, wherever the seam is.
    doc = edits.set_revolution(document(), start_deg=45.0)
    first, second = (drawn(doc=each, textures=(texture,)) for each in (document(), doc))
    assert np.abs(first - second).mean() < 0.4


def test_a_map_is_drawn_in_its_colours_with_a_bar():
    image = drawn((400, 300), map=ColourMap(MapKind.HEIGHT))
    # Viridis from foot to lip, lit a little.
    assert near(image[..., :3], "#fde725", 60) > 100
    plain = drawn((400, 300))
    change = np.abs(image - plain).sum(axis=-1)[:, :60]
    assert (change > 30).sum() > 400
    assert near(image[:, :60, :3], "#440154", 30) > 20


def test_zebra_stripes_are_black_and_white():
    image = drawn(map=ColourMap(MapKind.ZEBRA))
    belly = image[100:150, 40:120, 0]
    assert (belly < 60).mean() > 0.15
    assert (belly > 170).mean() > 0.15


def test_outlines_are_dark():
    image = drawn(material="plaster", background="white", silhouette=True, features=True)
    without = drawn(material="plaster", background="white")
    assert near(image, "#1a1c1f", 50) > near(without, "#1a1c1f", 50) + 60


def test_flat_shading_shows_facets():
    smooth, flat = drawn(material="plaster"), drawn(material="plaster", shading="flat")
    assert 0.05 < np.abs(smooth - flat).mean() < 10


def test_an_unknown_texture_leaves_a_grey_surface():
    image = drawn(textures=(Texture("of-another-version"),))
    red, green, blue = middle(image)
    assert max(red, green, blue) - min(red, green, blue) < 12


def test_a_body_wears_the_paint_of_its_surface():
    band = Layer(LayerKind.BAND, "#c00000", 0.4, 0.6)
    doc = edits.set_appearance(document(), material="plaster", drawing=(band,))
    vessel = edits.set_body(doc, kind="vessel", wall=2.0, base=2.0)
    bare, body = (
        render_image(
            evaluate(each),
            BARE,
            SIZE,
            direction="front",
            body=body_state(each, each.surface, fine=True),
        ).astype(int)
        for each in (doc, vessel)
    )
    red = [(image[..., 0] > 1.6 * image[..., 1]) for image in (bare, body)]
    assert red[0].sum() > 500
    assert (red[0] != red[1]).sum() < 0.1 * red[0].sum()


def test_a_fine_picture_is_painted_aside_and_then_taken_as_it_is(monkeypatch):
    doc = edits.set_appearance(document(), textures=(Texture("lotus"),))
    evaluation = evaluate(doc)
    renderer = vtkRenderer()
    window = offscreen_window()
    window.AddRenderer(renderer)
    scene = Scene(renderer, LIGHT)
    view = ViewState(segment=-1, show=frozenset({"surface"}))
    scene.update(evaluation, view)
    work = scene.look.fine_work(evaluation)
    assert work is not None
    work()
    assert scene.look.fine_work(evaluation) is None
    monkeypatch.setattr("app.scene_texture.paint", None)
    scene.update(evaluation, view, fine=True)
    assert scene.look.fine_work(evaluation) is None
    plain = evaluate(document())
    assert scene.look.fine_work(plain) is None
    window.Finalize()
