"""The pencil of the profile editor: freehand strokes as real mouse and key events."""

import numpy as np
import pytest
from PySide6.QtCore import QEvent, QPointF, Qt

from app.hand.coordinates import ScreenPoint
from app.state.blank import blank_document
from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import Segment
from sgb_core.design.tracing.result import distances
from tests.app.profile_editor.bench import Bench, vase

N = Qt.Key.Key_N
_MOVE = QEvent.Type.MouseMove
# A vase as a hand draws it, foot first, in pixels from its foot on the axis; y upwards.
VASE = [
    [[52, 0], [60, 30], [118, 60], [118, 140]],
    [[118, 140], [118, 230], [44, 250], [44, 320]],
    [[44, 320], [44, 350], [60, 370], [76, 390]],
]


def silhouette(step=4.0):
    """Return the vase's outline as places a mouse reports: whole pixels, some apart."""
    curve = Profile.of([Segment(points) for points in VASE]).sample(200).reshape(-1, 2)
    along = np.append(0.0, np.cumsum(np.hypot(*np.diff(curve, axis=0).T)))
    marks = np.arange(0.0, along[-1], step)
    return np.round(np.stack([np.interp(marks, along, curve[:, k]) for k in (0, 1)], axis=1))


@pytest.fixture
def pencil(qtbot):
    bench = Bench(qtbot, blank_document())
    bench.key(N)
    return bench


def stroke(bench, places):
    """Draw through widget places (x, y)."""
    first, *rest = [QPointF(x, y) for x, y in places.tolist()]
    bench.press(first)
    for place in rest:
        bench.mouse(_MOVE, place)
    bench.release(rest[-1])


def on_screen(bench, pixels):
    """Return pixels from the foot on the axis as places of the widget."""
    x, y = bench.screen((0.0, 0.0)).toTuple()
    return pixels * (1.0, -1.0) + (round(x), round(y) - 60.0)


def test_a_vase_drawn_by_mouse_is_a_chain_of_few_segments_within_a_pixel_and_a_half(pencil):
    drawn = on_screen(pencil, silhouette())
    stroke(pencil, drawn)
    profile = pencil.document.profile
    assert pencil.undo_entries == ["Draw the profile by hand"]
    assert len(profile) <= 6
    transform = pencil.view.transform
    places = np.array([transform.to_design(_point(place)).pair for place in drawn])
    assert distances(profile, places).max() * transform.scale <= 1.5
    assert profile.segments[0].points[0, 1] < profile.segments[-1].points[3, 1]
    pencil.presenter.undo()
    assert pencil.document.profile == blank_document().profile


def test_a_part_of_it_is_drawn_anew_and_the_rest_stays(qtbot):
    bench = Bench(qtbot, vase())
    bench.key(N)
    before = bench.document.profile
    s = np.linspace(0.2, 0.9, 60)
    path = bench.view.transform.map(before.segments[0].point(s))
    path[:, 0] += 25.0 * np.sin(np.linspace(0.0, np.pi, len(s)))
    stroke(bench, np.round(path))
    assert bench.undo_entries == ["Redraw a part by hand"]
    after = bench.document.profile
    assert after.segments[-1] == before.segments[1]
    places = np.array([bench.view.transform.to_design(_point(place)).pair for place in path])
    away = distances(after, places)
    assert away.max() * bench.view.transform.scale < 3.0


def test_a_stroke_from_the_end_goes_on(qtbot):
    bench = Bench(qtbot, vase())
    bench.key(N)
    before = bench.document.profile
    end = bench.place(1, 3).toTuple()
    t = np.linspace(0.0, 1.0, 25)[:, None]
    stroke(bench, np.round(np.array(end) + np.hstack([60.0 * t, -20.0 * t**2])))
    assert bench.undo_entries == ["Draw on by hand"]
    assert bench.document.profile.segments[:2] == before.segments


def test_a_click_and_escape_draw_nothing(qtbot):
    bench = Bench(qtbot, vase())
    bench.key(N)
    bench.click(QPointF(200, 200))
    bench.press(QPointF(200, 200))
    bench.move(QPointF(260, 300))
    bench.key(Qt.Key.Key_Escape)
    bench.release(QPointF(260, 300))
    assert bench.undo_entries == []
    assert bench.presenter.view.tool == "pencil"
    bench.key(Qt.Key.Key_Escape)
    assert bench.presenter.view.tool == "select"


def test_the_keyboard_draws_too(pencil):
    pencil.key(Qt.Key.Key_Space)
    for key in (Qt.Key.Key_Up,) * 8 + (Qt.Key.Key_Right, Qt.Key.Key_Up) * 4:
        pencil.key(key)
    pencil.key(Qt.Key.Key_Return)
    assert pencil.undo_entries == ["Draw the profile by hand"]
    low, high = pencil.document.profile.bounds()
    assert (high[1] - low[1]) * pencil.view.transform.scale == pytest.approx(96.0, abs=2.0)


def _point(place):
    return ScreenPoint(*np.asarray(place).tolist())
