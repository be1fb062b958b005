"""The looks in pixels, drawn off screen."""

from dataclasses import replace

import numpy as np
import pytest
from vtkmodules.vtkRenderingCore import vtkRenderer

import resources
from app.scene.offscreen import grabbed, offscreen_window, render_image
from app.scene.scene import Scene
from app.state.cut import Cut
from app.state.view_state import ViewState
from app.theme.palette import DARK, LIGHT
from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import Segment
from sgb_core.document import edits
from sgb_core.document.appearance.model import (
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
from sgb_core.document.file import project_file
from sgb_core.document.model import Document
from sgb_core.exchange.skin import skin_of
from sgb_core.surfaces.ambient_occlusion import SurfaceLight
from tests.app.viewport.helpers import document, near

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


@pytest.mark.parametrize("solid", [False, True], ids=["surface", "vessel"])
def test_paint_outlines_and_facets_leave_the_clay_as_it_was(solid):
    doc = document()
    doc = edits.set_solid(doc, kind="vessel", wall=3.0, base=3.0) if solid else doc
    body = body_state(doc, doc.surface, fine=True) if solid else None

    def seen(**changes):
        found = edits.set_appearance(doc, **changes)
        there = None if body is None else body_state(found, found.surface, fine=True)
        picture = render_image(evaluate(found), BARE, SIZE, direction="iso", body=there)
        return picture[..., :3].astype(int)

    plain = seen()
    band = Layer(LayerKind.BAND, "#c00000", 0.05, 0.15)
    red = seen(drawing=(band,))
    changed = np.abs(red - plain).max(axis=2)
    # Only the band differs, by more than the picture's rounding.
    rows = np.flatnonzero((changed > 6).any(axis=1))
    assert 3 < len(rows) < 0.3 * SIZE[1]
    assert rows.min() > 0.6 * SIZE[1]
    for lines in ({"silhouette": True}, {"shading": "flat"}):
        away = np.abs(seen(**lines) - plain).max(axis=2)[plain[..., 1] > plain[..., 0] + 15]
        assert np.median(away) <= 4


def test_the_influence_of_a_parameter_is_seen_on_what_is_painted():
    found = edits.set_appearance(document(), textures=(Texture("brick"),))
    view = replace(BARE, segment=0, influence="lambda2")
    bare = render_image(evaluate(document()), view, SIZE, direction="iso")
    assert np.array_equal(render_image(evaluate(found), view, SIZE, direction="iso"), bare)


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
    assert 0.03 < np.abs(smooth - flat).mean() < 10


def test_an_unknown_texture_leaves_a_grey_surface():
    image = drawn(textures=(Texture("of-another-version"),))
    red, green, blue = middle(image)
    assert max(red, green, blue) - min(red, green, blue) < 12


def test_a_body_wears_the_paint_of_its_surface():
    band = Layer(LayerKind.BAND, "#c00000", 0.4, 0.6)
    doc = edits.set_appearance(document(), material="plaster", drawing=(band,))
    vessel = edits.set_solid(doc, kind="vessel", wall=2.0, base=2.0)
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


def stage():
    """A scene off screen and its window."""
    renderer = vtkRenderer()
    window = offscreen_window()
    window.SetSize(*SIZE)
    window.AddRenderer(renderer)
    return Scene(renderer, LIGHT), window


def test_a_fine_picture_is_made_aside_and_then_taken_as_it_is(monkeypatch):
    doc = edits.set_appearance(document(), textures=(Texture("lotus"),))
    evaluation = evaluate(doc)
    scene, window = stage()
    scene.update(evaluation, BARE)
    work = scene.look.fine_work(evaluation, BARE, None)
    assert len(work) == 2
    for each in work:
        each()
    assert scene.look.fine_work(evaluation, BARE, None) == []
    monkeypatch.setattr("app.scene.coats.paint", None)
    monkeypatch.setattr("app.scene.ambient_occlusion.surface_light", None)
    scene.update(evaluation, BARE, fine=True)
    assert scene.look.fine_work(evaluation, BARE, None) == []
    window.Finalize()


@pytest.mark.parametrize("name", ["ceramic-pot", "earthen-house", "sphere"])
def test_looking_around_repaints_nothing(monkeypatch, name):
    doc = project_file.loads(resources.load_preset(name))
    if not doc.appearance.textures:
        doc = edits.set_appearance(doc, textures=(Texture("lotus"),))
    scene, window = stage()
    evaluation = evaluate(doc)
    scene.update(evaluation, BARE, fine=True)
    monkeypatch.setattr("app.scene.coats.paint", None)
    for fine in (False, True):
        scene.update(evaluation, BARE, fine=fine)
        assert scene.look.fine_work(evaluation, BARE, None) == []
    window.Finalize()


def test_a_drag_makes_no_light_of_its_own_and_rest_makes_it_anew(monkeypatch):
    scene, window = stage()
    scene.update(evaluate(document()), BARE, fine=True)
    dragged = evaluate(edits.set_shape_parameter(document(), 1, "omega", 0.9))
    with monkeypatch.context() as patch:
        patch.setattr("app.scene.ambient_occlusion.surface_light", None)
        scene.update(dragged, BARE)
    assert len(scene.look.fine_work(dragged, BARE, None)) == 1
    scene.update(dragged, BARE, fine=True)
    assert scene.look.fine_work(dragged, BARE, None) == []
    window.Finalize()


def test_refining_does_not_change_the_light():
    scene, window = stage()
    evaluation = evaluate(edits.set_appearance(document(), material="plaster", shadow=True))
    scene.update(evaluation, BARE, fine=True)
    scene.fit(SIZE[0] / SIZE[1])
    seen = []
    for fine in (True, False, True):
        scene.update(evaluation, BARE, fine=fine)
        window.Render()
        seen.append(grabbed(window, 1).astype(int))
    assert (seen[0] == seen[2]).all()
    assert np.median(np.abs(seen[0] - seen[1])) == 0
    assert (np.abs(seen[0] - seen[1]).max(axis=-1) > 6).mean() < 0.02
    window.Finalize()


def bowl(**changes):
    """A wide open bowl that is seen into."""
    profile = Profile.of([Segment([(8, 0), (60, 2), (70, 30), (72, 60)])])
    return edits.set_appearance(Document(profile), material="plaster", **changes)


@pytest.mark.parametrize("material", ["clay", "plaster", "porcelain"])
def test_hollows_are_darker(monkeypatch, material):
    """Against the same picture with all points open to the light."""
    doc = edits.set_appearance(bowl(), material=material)
    shaded = drawn(doc=doc)[..., :3]
    monkeypatch.setattr(SurfaceLight, "on_rows", lambda self, m, n: np.ones(((m + 1), n + 1, 2)))
    change = shaded - drawn(doc=doc)[..., :3]
    assert change.max() <= 1
    changed = change.min(axis=-1) < -4
    assert 0.05 < changed.mean() < 0.6
    # The inside is in the upper half of the picture.
    assert np.median(np.flatnonzero(changed.any(axis=1))) < 0.6 * SIZE[1]


def test_light_falls_into_what_is_cut_open():
    doc = bowl()
    shut, opened = (
        render_image(evaluate(doc), replace(BARE, cut=cut), SIZE, direction="top")[..., :3]
        for cut in (Cut.NONE, Cut.QUARTER)
    )
    # Beside the wedge, on the inner wall.
    both = (np.abs(shut.astype(int) - opened).sum(axis=-1) > 0) & (opened.sum(axis=-1) > 0)
    assert (opened.astype(int) - shut)[both].max() > 4


def test_a_map_keeps_its_colours_in_hollows(monkeypatch):
    doc = bowl(map=ColourMap(MapKind.HEIGHT))
    shaded = drawn(doc=doc)
    monkeypatch.setattr(SurfaceLight, "on_rows", lambda self, m, n: np.ones(((m + 1), n + 1, 2)))
    assert (shaded == drawn(doc=doc)).all()


def test_a_map_means_the_same_on_all_levels_and_in_files():
    # Its 5 % tail of flat places lies near enough to 0 to fall either way with the fineness.
    doc = project_file.loads(resources.load_preset("vase"))
    doc = edits.set_appearance(doc, map=ColourMap(MapKind.MEAN))
    scene, window = stage()
    limits = []
    for fine in (False, True):
        scene.update(evaluate(doc), BARE, fine=fine)
        bar = scene.look.bar.actor.GetLookupTable()
        limits.append(bar.GetRange())
    window.Finalize()
    skin = skin_of(doc)
    assert limits[0] == limits[1] == pytest.approx((skin.low, skin.high))


def test_the_letters_of_the_colour_bar_stand_out_from_their_ground():
    doc = edits.set_appearance(document(), map=ColourMap(MapKind.RADIUS))
    for background, palette, light in (
        ("theme", LIGHT, True),
        ("theme", DARK, False),
        ("white", DARK, True),
        ("dark", LIGHT, False),
        ("gradient", DARK, True),
    ):
        each = edits.set_appearance(doc, background=background)
        image = render_image(evaluate(each), BARE, (640, 480), palette=palette)
        # Above the bar stands its title.
        title = image[150:225, 20:110, :3].astype(int).sum(axis=-1)
        ground = np.median(title)
        assert (ground > 382) == light
        contrast = ground - title.min() if light else title.max() - ground
        assert contrast > 250


def test_the_letters_of_the_colour_bar_stand_out_from_the_object_too():
    # White letters over a pale object, where the picture is narrow.
    doc = edits.set_appearance(bowl(), map=ColourMap(MapKind.GAUSSIAN, -9.0, 9.0))
    doc = edits.set_appearance(doc, background="dark")
    image = render_image(evaluate(doc), BARE, (260, 480), direction="front")
    title = image[190:222, 8:180, :3].astype(int).sum(axis=-1)
    pale = drawn(doc=doc, size=(260, 480), direction="front")[240, 150, :3]
    assert pale.sum() > 560
    assert title.max() > 600
    assert np.quantile(title, 0.1) < 300
