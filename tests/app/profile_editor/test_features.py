"""Wall, floor and painted bands, dragged in the profile editor where they are seen."""

import pytest
from hypothesis import given
from hypothesis import strategies as st
from PySide6.QtCore import QPointF, Qt

from app.hand.features import Feature, Kind, edge_places, length_share, share_at, textures
from sgb_core.curves.primitives import line
from sgb_core.curves.profile import Profile
from sgb_core.document import edits
from sgb_core.document.appearance.model import Layer, Texture
from sgb_core.document.body_state import body_state
from sgb_core.document.model import Document
from tests.app.profile_editor.bench import Bench, vase

CUP = edits.set_solid(
    Document(Profile.of([line((0, 0), (30, 0)), line((30, 0), (40, 80))])),
    kind="vessel",
    wall=5,
    base=8,
)
BAND = edits.set_appearance(vase(), drawing=(Layer("band", color="#aa3311", start=0.25, end=0.75),))


def shown(qtbot, document):
    bench = Bench(qtbot, document)
    refresh(bench)
    return bench


def refresh(bench):
    document = bench.document
    bench.presenter.set_body(body_state(document, document.surface, fine=False))
    bench.settle()


def hover(bench, at):
    bench.move(at, Qt.MouseButton.NoButton)
    return bench.view.active


def test_the_floor_is_dragged_by_its_edge(qtbot):
    bench = shown(qtbot, CUP)
    at = bench.screen((15.0, 8.0))
    found = hover(bench, at)
    assert found.feature.kind is Kind.FLOOR
    assert bench.view.cursor().shape() is Qt.CursorShape.SizeVerCursor
    bench.drag(at, bench.screen((15.0, 14.0)))
    assert bench.document.solid.base == pytest.approx(14.0, abs=0.3)
    assert bench.document.solid.wall == 5.0
    assert bench.undo_entries == ["Floor"]


def test_the_wall_is_dragged_by_its_inner_side(qtbot):
    bench = shown(qtbot, CUP)
    middle, across = (35.0 - 4.96, 40.0 + 0.62), (35.0 - 8.93, 40.0 + 1.12)
    assert hover(bench, bench.screen(middle)).feature.kind is Kind.WALL
    bench.drag(bench.screen(middle), bench.screen(across))
    assert bench.document.solid.wall == pytest.approx(9.0, abs=0.3)
    assert bench.undo_entries == ["Wall"]
    # Through the drawn line and beyond there is still a wall.
    refresh(bench)
    assert bench.document.solid.wall > 0.0


@pytest.mark.parametrize(("upper", "share"), [(True, 0.75), (False, 0.25)])
def test_a_painted_band_is_dragged_by_its_edges(qtbot, upper, share):
    bench = Bench(qtbot, BAND)
    place = edge_places(BAND.profile, BAND.appearance.drawing[0], upper=upper)[0]
    assert share_at(BAND.profile, BAND.appearance.drawing[0], place) == pytest.approx(share)
    assert hover(bench, bench.screen(place)).feature.upper is upper
    bench.drag(bench.screen(place), bench.screen((place[0], place[1] + 10.0)))
    layer = bench.document.appearance.drawing[0]
    moved, kept = (layer.end, layer.start) if upper else (layer.start, layer.end)
    low, high = (corner[1] for corner in BAND.profile.bounds())
    assert moved == pytest.approx(share + 10.0 / (high - low), abs=0.01)
    assert kept == (0.25 if upper else 0.75)
    assert bench.undo_entries == ["Painted band"]


def test_escape_puts_the_wall_back(qtbot):
    bench = shown(qtbot, CUP)
    before = bench.document
    at = bench.screen((15.0, 8.0))
    bench.press(at)
    bench.move(at - QPointF(0.0, 40.0))
    assert bench.document.solid.base > 8.0
    bench.key(Qt.Key.Key_Escape)
    assert bench.document is before


@given(
    st.sampled_from(["height", "length"]),
    st.floats(0.0, 1.0),
    st.floats(0.0, 1.0),
    st.tuples(st.floats(-500.0, 500.0), st.floats(-500.0, 500.0)),
    st.booleans(),
)
def test_wherever_the_hand_goes_a_band_stays_a_band(by, first, second, to, upper):
    low, high = sorted((first, second))
    layer = Layer("band", color="#aa3311", start=low, end=high, by=by)
    document = edits.set_appearance(vase(), drawing=(layer,))
    dragged = Feature(Kind.BAND, (0.0, 0.0), upper=upper).dragged(document, to)
    moved = dragged.appearance.drawing[0]
    assert 0.0 <= moved.start <= moved.end <= 1.0
    assert (moved.start if upper else moved.end) == (low if upper else high)


@given(st.tuples(st.floats(-500.0, 500.0), st.floats(-500.0, 500.0)))
def test_wherever_the_hand_goes_there_is_a_wall_and_no_hole_for_a_floor(to):
    assert Feature(Kind.WALL, (0.0, 0.0)).dragged(CUP, to).solid.wall > 0.0
    assert Feature(Kind.FLOOR, (0.0, 8.0)).dragged(CUP, to).solid.base >= 0.0


@pytest.mark.parametrize("turn", [0.0, 90.0])
def test_a_texture_is_dragged_along_the_curve(qtbot, turn):
    texture = Texture("lotus", repeat=(6.0, 3.0), rotate_deg=turn)
    bench = Bench(qtbot, edits.set_appearance(vase(), textures=(texture,)))
    (before,) = textures(bench.document)
    assert hover(bench, bench.screen(before.at)).feature.kind is Kind.TEXTURE
    share = length_share(bench.document.profile, before.at)
    goal = tuple(edge_places(vase().profile, by_length(share + 0.05), upper=False)[0])
    bench.drag(bench.screen(before.at), bench.screen(goal))
    moved = textures(bench.document)[0].at
    assert length_share(bench.document.profile, moved) == pytest.approx(share + 0.05, abs=0.01)
    assert bench.undo_entries == ["Texture"]
    bench.presenter.undo()
    assert bench.document.appearance.textures == (texture,)


def by_length(start):
    return Layer("band", start=start, by="length")
