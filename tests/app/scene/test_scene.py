"""What is drawn, judged by its pixels, off screen."""

import subprocess
import sys
from dataclasses import replace

import numpy as np
import pytest
import pyvista
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkRenderingCore import vtkRenderer, vtkRenderWindow, vtkWindowToImageFilter

from app.scene.actors import COARSE, FINE, LIVE, MAGNIFIED, MAGNIFIED_FROM
from app.scene.camera import standard_pose
from app.scene.offscreen import png_bytes, render_image, render_png
from app.scene.scene import Scene
from app.state.overlays import Overlay
from app.state.view_state import Hover, ViewState
from app.theme.palette import DARK, LIGHT
from sgb_core.document.evaluation import evaluate
from sgb_core.document.model import Revolution
from sgb_core.surfaces.revolution import Axis
from tests.app.viewport.helpers import DRUM, VASE, document, near, reshaped
from tests.benchmarks.window import chain

SIZE = (360, 270)
CHOSEN_NONE = ViewState(segment=-1)


def image(doc, view=CHOSEN_NONE, **options):
    return render_image(evaluate(doc), view, SIZE, **options)


def only(*overlays):
    return replace(CHOSEN_NONE, show=frozenset(overlays))


class Live:
    """A scene in a window that stays, as the viewport has one."""

    def __init__(self, doc, view=CHOSEN_NONE, *, quiet=False):
        self.window = vtkRenderWindow()
        self.window.OffScreenRenderingOn()
        self.window.SetMultiSamples(0)
        self.window.SetSize(*SIZE)
        renderer = vtkRenderer()
        self.window.AddRenderer(renderer)
        self.scene = Scene(renderer, LIGHT, quiet=quiet)
        self.scene.update(evaluate(doc), view)
        self.scene.fit(SIZE[0] / SIZE[1])

    def pixels(self):
        self.window.Render()
        grabber = vtkWindowToImageFilter()
        grabber.SetInput(self.window)
        grabber.ReadFrontBufferOff()
        grabber.ShouldRerenderOff()
        grabber.Update()
        flat = vtk_to_numpy(grabber.GetOutput().GetPointData().GetScalars())
        return flat.reshape(SIZE[1], SIZE[0], 3)[::-1].copy()


def green(pixels):
    """Where the picture is green, shape (h, w)."""
    red, middle, blue = (pixels[..., k].astype(int) for k in range(3))
    return (middle > red + 12) & (middle > blue + 12)


def test_the_surface_is_green_and_fills_the_picture():
    pixels = image(document(), only("surface"))
    share = green(pixels).mean()
    assert 0.12 < share < 0.6
    rows = np.flatnonzero(green(pixels).any(axis=1))
    assert rows[0] > 5
    assert rows[-1] < SIZE[1] - 5


@pytest.mark.parametrize("palette", [LIGHT, DARK])
def test_each_overlay_has_its_own_colour(palette):
    for overlay, colour in (
        ("generatrix", palette.generatrix),
        ("polygon", palette.polygon),
        ("circles", palette.circle_p1),
        ("circles", palette.circle_p2),
    ):
        shown = near(image(document(), only(overlay), palette=palette), colour)
        hidden = near(image(document(), only("surface"), palette=palette), colour)
        assert shown > hidden + 30, overlay


# What is only there where a vessel's body or a printer's path has been made.
MADE_APART = {Overlay.LIQUID, Overlay.PRINT}


@pytest.mark.parametrize(
    "overlay", [each for each in Overlay if each.in_viewport and each not in MADE_APART]
)
def test_every_overlay_can_be_shown_and_hidden(overlay):
    everything = {each for each in Overlay if each.in_viewport} - MADE_APART
    doc, pose = document(), standard_pose(Axis.Z)
    pose = replace(pose, distance=420.0, focal=(0.0, 0.0, 60.0))
    shown = image(doc, only(*everything), pose=pose)
    hidden = image(doc, only(*(everything - {overlay})), pose=pose)
    assert not np.array_equal(shown, hidden)


def test_marks_of_the_two_circles_differ_in_shape():
    drum = document(DRUM, axis="x")
    coloured = replace(LIGHT, circle_p2=LIGHT.circle_p1)
    pixels = image(drum, only("circles"), palette=coloured, direction="front")
    # Seen from the front both circles are lines of marks, P1's low and P2's high.
    dark = np.abs(pixels[..., :3].astype(int) - pixels[0, 0, :3]).max(axis=-1) > 60
    rows = np.flatnonzero(dark.any(axis=1))
    low, high = dark[rows[-1] - 12 : rows[-1] + 1], dark[rows[0] : rows[0] + 13]
    assert low.sum() != high.sum()


def test_crowded_marks_stay_apart():
    live = Live(document())
    live.pixels()
    for part in (live.scene.profile.marks["stars"], live.scene.profile.marks["rings"]):
        glyphs = part._array.reshape(len(part._centres), -1, 3)
        reach = np.linalg.norm(glyphs - part._centres[:, None], axis=-1).max(axis=1)
        gaps = np.linalg.norm(np.diff(part._centres.reshape(3, -1, 3), axis=1), axis=-1)
        assert (reach.reshape(3, -1)[:, 1:] < 0.55 * gaps).all()


def test_the_chosen_segment_is_marked_on_curve_and_polygon():
    doc = document()
    for overlay in ("generatrix", "polygon"):
        view = replace(only(overlay), segment=1)
        assert near(image(doc, view), LIGHT.selection) > 30
        assert near(image(doc, only(overlay)), LIGHT.selection) == 0


def test_a_single_segment_needs_no_mark():
    assert near(image(document(DRUM), replace(only("generatrix"), segment=0)), LIGHT.selection) == 0


def test_a_hovered_slider_lights_up_its_leg_and_circle():
    for overlay in (only("surface"), only("surface", "polygon")):
        lit = near(image(document(), replace(overlay, hover=Hover("lambda1", 0))), LIGHT.quartic)
        more = near(image(document(), replace(overlay, hover=Hover("omega", None))), LIGHT.quartic)
        assert more > lit > 60
        assert near(image(document(), overlay), LIGHT.quartic) < 30


def test_stretches_beyond_the_axis_are_red():
    crossing = document((((1.2, 0), (-0.6, 0.3), (-0.6, 0.7), (1.2, 1)),))
    assert near(image(crossing, only("generatrix")), LIGHT.error) > 20
    assert near(image(document(), only("generatrix")), LIGHT.error) == 0


def test_the_inside_of_an_open_pot_has_another_tone():
    bowl = document((((0, 0), (2, 0), (3, 0.5), (3, 2)),))
    pixels = image(bowl, only("surface"), direction="top")
    inside = pixels[SIZE[1] // 2, SIZE[0] // 2, :3].astype(int)
    below = image(bowl, only("surface"), direction="bottom")
    outside = below[SIZE[1] // 2, SIZE[0] // 2, :3].astype(int)
    assert inside[1] > inside[0]
    assert outside[1] > inside[1] + 10


@pytest.mark.parametrize("axis", list(Axis))
def test_every_axis_stands_upright_and_looks_alike(axis):
    doc = document(DRUM)
    upright = image(doc, CHOSEN_NONE)
    turned = image(replace(doc, revolution=Revolution(axis)), CHOSEN_NONE)
    assert np.abs(upright.astype(int) - turned).max(axis=-1).astype(bool).mean() < 0.01


def test_a_partial_sweep_opens_the_body():
    whole = image(document(DRUM), only("surface"), direction="top")
    half = image(document(DRUM, sweep=180.0), only("surface"), direction="top")
    assert green(whole)[: SIZE[1] // 4].sum() > 0
    assert not np.array_equal(whole, half)


def test_writing_in_place_gives_the_pixels_of_a_new_scene():
    live = Live(document())

    def rested(stage, evaluation):
        # The light in hollows is that of the shape at rest.
        for fine in (True, False):
            stage.scene.update(evaluation, CHOSEN_NONE, fine=fine)
        return stage.pixels()

    first, second = evaluate(document()), evaluate(reshaped(document(), 0.9))
    before, after = rested(live, first), rested(live, second)
    assert not np.array_equal(before, after)
    fresh = Live(reshaped(document(), 0.9))
    fresh.scene.see_from(live.scene.pose)
    assert np.array_equal(after, rested(fresh, second))
    assert np.array_equal(before, rested(live, first))


def test_arrays_and_actors_stay_the_same_while_the_shape_changes():
    live = Live(document())
    level = live.scene._levels[False]
    address = level.grid.points.ctypes.data
    actors = live.scene.renderer.GetActors().GetNumberOfItems()
    for omega in (0.1, 0.4, 0.8):
        live.scene.update(evaluate(reshaped(document(), omega)), CHOSEN_NONE)
        live.pixels()
    assert live.scene._levels[False] is level
    assert level.grid.points.ctypes.data == address
    assert live.scene.renderer.GetActors().GetNumberOfItems() == actors


def test_another_number_of_segments_makes_another_topology():
    live = Live(document())
    live.pixels()
    longer = document((*VASE, ((26, 122), (30, 126), (30, 128), (34, 130))))
    live.scene.update(evaluate(longer), CHOSEN_NONE)
    after = live.pixels()
    fresh = Live(longer)
    fresh.scene.see_from(live.scene.pose)
    assert np.array_equal(after, fresh.pixels())


@pytest.mark.parametrize("segments", range(1, 26))
def test_a_window_refines_an_ordinary_shape_that_is_magnified_as_finely_as_a_file_does(segments):
    for sweep in np.linspace(0.05, 2.0 * np.pi, 40):
        assert MAGNIFIED.intervals(segments, sweep) == FINE.intervals(segments, sweep)


@pytest.mark.parametrize("segments", range(1, 26))
def test_what_is_not_magnified_is_refined_as_finely_as_pixels_tell(segments):
    _, around = LIVE.intervals(segments, 2.0 * np.pi)
    assert MAGNIFIED_FROM * (1.0 - np.cos(np.pi / around)) < 0.25


def test_a_window_draws_finer_what_is_magnified_and_coarser_what_moves_at_half_the_resolution():
    live, sizes = Live(document(), quiet=True), {}
    fitted = live.scene.fit(1.0)

    def points(fine):
        live.scene.update(evaluate(document()), CHOSEN_NONE, fine=fine)
        return len(live.scene.points_to_fit())

    sizes["rests"] = points(True)
    live.scene.see_from(replace(fitted, distance=0.05 * fitted.distance))
    sizes["magnified"] = points(True)
    live.scene.see_from(fitted)
    assert points(True) == sizes["rests"]
    sizes["moves"] = points(False)
    live.scene.halved = True
    sizes["moves, halved"] = points(False)
    assert sizes["moves, halved"] < sizes["moves"] < sizes["rests"] < sizes["magnified"]


@pytest.mark.parametrize("segments", [26, 100, 500, 2_000])
def test_a_long_chain_is_refined_as_finely_as_it_moves_and_with_no_more_quads_than_needed(segments):
    coarse, live, file = (d.intervals(segments, 2.0 * np.pi) for d in (COARSE, LIVE, FINE))
    assert all(a <= b <= c for a, b, c in zip(coarse, live, file, strict=True))
    most = max(LIVE.most_rows * LIVE.columns, segments * coarse[0] * coarse[1])
    assert segments * live[0] * live[1] <= most


def test_one_level_serves_a_very_long_chain_at_rest_and_in_motion():
    long, short = chain(900), document()
    live = Live(long, quiet=True)
    actors = live.scene.renderer.GetActors().GetNumberOfItems()
    for doc in (long, short, long, reshaped(long, 0.9), short):
        for fine in (False, True, False, True):
            live.scene.update(evaluate(doc), CHOSEN_NONE, fine=fine)
        fresh = Live(doc, quiet=True)
        fresh.scene.update(evaluate(doc), CHOSEN_NONE, fine=True)
        fresh.scene.see_from(live.scene.pose)
        assert np.array_equal(live.pixels(), fresh.pixels())
        counted = live.scene.renderer.GetActors().GetNumberOfItems()
        assert (counted == actors) == (doc is not short)


def test_refining_neither_moves_nor_recolours_the_picture():
    live = Live(document())
    plain = live.pixels().astype(int)
    live.scene.update(evaluate(document()), CHOSEN_NONE, fine=True)
    live.scene.set_smooth(True)
    smooth = live.pixels().astype(int)
    changed = np.abs(smooth - plain).max(axis=-1)
    assert changed.any()
    # What changes are edges; all areas keep their colour.
    assert (changed > 12).mean() < 0.08
    assert abs(smooth.mean() - plain.mean()) < 0.6


def test_off_screen_sizes_views_and_ground():
    png = render_png(document(), (200, 120), view="front")
    assert png.startswith(b"\x89PNG")
    clear = image(document(), CHOSEN_NONE, transparent=True)
    assert clear[2, 2, 3] == 0
    assert clear[SIZE[1] // 2, SIZE[0] // 2, 3] == 255
    opaque = image(document(), CHOSEN_NONE)
    assert opaque.shape == (SIZE[1], SIZE[0], 4)
    assert (opaque[..., 3] == 255).all()
    with pytest.raises(ValueError, match="iso, front"):
        render_png(document(), (20, 20), view="sideways")
    with pytest.raises(ValueError, match="8192"):
        render_png(document(), (9000, 20))


def test_png_keeps_rows_and_channels(tmp_path):
    pixels = np.zeros((3, 5, 4), np.uint8)
    pixels[0, 0] = (255, 0, 0, 255)
    pixels[2, 4] = (0, 0, 255, 128)
    path = tmp_path / "small.png"
    path.write_bytes(png_bytes(pixels))
    assert np.array_equal(
        np.asarray(pyvista.read(path).active_scalars).reshape(3, 5, 4)[::-1], pixels
    )


def test_drawing_off_screen_needs_neither_qt_nor_a_screen(monkeypatch):
    code = (
        "import sys\n"
        "from app.scene.offscreen import render_png\n"
        "from tests.app.viewport.helpers import document\n"
        "assert render_png(document(), (80, 60)).startswith(b'\\x89PNG')\n"
        "assert not any(name.startswith(('PySide6', 'pyvista')) for name in sys.modules)\n"
    )
    monkeypatch.delenv("DISPLAY", raising=False)
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    assert done.stderr == ""
