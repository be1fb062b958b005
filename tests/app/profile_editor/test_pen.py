"""The pen of the profile editor, worked by real mouse and key events."""

import numpy as np
import pytest
from PySide6.QtCore import QPointF, Qt

from app.hand.coordinates import ScreenPoint
from app.profile_editor.tools.table import TOOLS
from app.state import preferences
from app.state.blank import blank_document, is_blank
from sgb_core.curves.segment import ShapeParameters
from sgb_core.document import edits
from tests.app.profile_editor.bench import ALT, CTRL, SHIFT, Bench, near, vase

P = Qt.Key.Key_P


@pytest.fixture
def pen(qtbot):
    """A blank document with the pen in hand."""
    bench = Bench(qtbot, blank_document())
    bench.key(P)
    return bench


def stroke(bench, place, handle=None, modifiers=CTRL):
    """Click at (r, h), or drag a smooth point's handle to another; Ctrl: without snapping."""
    at = bench.screen(place)
    bench.move(at, Qt.MouseButton.NoButton, modifiers)
    if handle is None:
        bench.click(at, modifiers)
    else:
        bench.drag(at, bench.screen(handle), modifiers=modifiers)


def test_each_tool_has_a_key_a_button_and_a_place_in_the_view(qtbot):
    bench = Bench(qtbot, vase())
    for kind in (*TOOLS[1:], TOOLS[0]):
        bench.key(kind.key)
        assert bench.presenter.view.tool == kind.name
        pressed = [n for n, b in bench.view._buttons.buttons.items() if b.isChecked()]
        assert pressed == [kind.name]
    bench.view._buttons.buttons["pen"].click()
    bench.settle()
    assert bench.presenter.view.tool == "pen"


def test_nothing_enters_the_document_before_its_first_segment(pen):
    before = pen.document
    stroke(pen, (0, 0))
    assert pen.document is before
    assert pen.undo_entries == []
    stroke(pen, (40, 0))
    assert pen.undo_entries == ["Draw segment 1"]
    assert len(pen.document.profile) == 1
    assert np.allclose(pen.point(0, 3), (40, 0), atol=0.5)
    assert pen.document.profile.segments[0].shape == ShapeParameters(1, 3, 1, 1)


@pytest.mark.parametrize("free", [False, True])
def test_a_click_lands_on_round_numbers_near_by_and_with_ctrl_where_it_is(pen, free):
    scale = pen.view.transform.scale
    assert 3.0 < scale < 6.0
    aside = 1.4 / scale
    modifiers, off = (CTRL, aside) if free else (Qt.KeyboardModifier.NoModifier, 0.0)
    stroke(pen, (20 - aside, 10 + aside), modifiers=modifiers)
    stroke(pen, (36 - aside, 52 + aside), (46 - aside, 71 + aside), modifiers=modifiers)
    pixel = 0.51 / scale if free else 1e-9
    assert np.allclose(pen.point(0, 0), (20 - off, 10 + off), atol=pixel)
    assert np.allclose(pen.point(0, 3), (36 - off, 52 + off), atol=pixel)
    # The handle behind a smooth point mirrors what was drawn out of it.
    assert np.allclose(pen.point(0, 2), (26 - off, 33 + off), atol=3.0 * pixel)


def test_an_upright_handle_is_as_long_as_a_round_number(pen):
    aside = 1.4 / pen.view.transform.scale
    stroke(pen, (20, 10), modifiers=Qt.KeyboardModifier.NoModifier)
    stroke(pen, (36, 52), (36 + aside, 71 + aside), modifiers=Qt.KeyboardModifier.NoModifier)
    assert np.allclose(pen.point(0, 2), (36, 33), atol=1e-9)


def test_undo_takes_back_stroke_by_stroke_and_the_pen_goes_on(pen):
    for place in ((0, 0), (40, 0), (50, 60), (30, 90)):
        stroke(pen, place)
    assert pen.undo_entries == ["Draw segment 1", "Draw segment 2", "Draw segment 3"]
    pen.presenter.undo()
    pen.settle()
    stroke(pen, (20, 70))
    assert len(pen.document.profile) == 3
    assert near(pen.place(2, 3), pen.screen((20, 70)))
    pen.key(Qt.Key.Key_Backspace)
    assert len(pen.document.profile) == 2
    for _ in range(2):
        pen.key(Qt.Key.Key_Backspace)
    assert is_blank(pen.document)
    stroke(pen, (20, 70))
    assert len(pen.document.profile) == 1
    assert near(pen.place(0, 0), pen.screen((0, 0)))


def test_a_drag_makes_a_smooth_joint(pen):
    stroke(pen, (0, 0))
    stroke(pen, (40, 10), (50, 30))
    stroke(pen, (30, 70), (25, 80))
    assert [str(report.measured) for report in pen.document.joints] == ["C1"]
    assert [str(rule) for rule in pen.document.profile.rules] == ["G1"]
    assert near(pen.place(1, 1), pen.screen((50, 30)))
    assert near(pen.place(0, 2), pen.screen((30, -10)))


def test_alt_breaks_the_handle_in_the_middle_of_a_drag(pen):
    stroke(pen, (0, 0))
    at, mid, end = (pen.screen(p) for p in ((40, 10), (50, 30), (60, 10)))
    pen.press(at, modifiers=CTRL)
    pen.move(mid, modifiers=CTRL)
    pen.move(end, modifiers=CTRL | ALT)
    pen.release(end, modifiers=CTRL | ALT)
    stroke(pen, (30, 70))
    assert near(pen.place(0, 2), pen.screen((30, -10)))
    assert near(pen.place(1, 1), end)
    assert [str(rule) for rule in pen.document.profile.rules] == ["G0"]


def test_escape_in_a_stroke_drops_it_and_then_ends_the_run_and_then_the_tool(pen):
    stroke(pen, (10, 0))
    stroke(pen, (40, 0))
    kept = pen.document
    pen.press(pen.screen((50, 40)), modifiers=CTRL)
    pen.move(pen.screen((60, 60)), modifiers=CTRL)
    assert len(pen.document.profile) == 2
    pen.key(Qt.Key.Key_Escape)
    assert pen.document is kept
    pen.release(pen.screen((60, 60)))
    assert pen.view.tool.run is not None
    pen.key(Qt.Key.Key_Escape)
    assert pen.view.tool.run is None
    pen.key(Qt.Key.Key_Escape)
    assert pen.presenter.view.tool == "select"
    assert pen.document is kept


def test_a_click_on_the_start_closes_a_ring(pen):
    for place in ((40, 0), (60, 20), (40, 40)):
        stroke(pen, place)
    stroke(pen, (40, 0))
    profile = pen.document.profile
    assert profile.closed
    assert len(profile) == 3
    assert pen.view.tool.run is None
    assert pen.undo_entries[-1] == "Close the ring"


def test_the_axis_attracts_and_a_pole_ends_the_run(pen):
    stroke(pen, (30, 0), (50, 20))
    at = pen.screen((0, 80)) + QPointF(4, 0)
    pen.click(at)
    assert pen.point(0, 3)[0] == 0.0
    assert pen.view.tool.run is None
    # Round: it arrives level.
    assert pen.point(0, 2)[1] == pen.point(0, 3)[1]


def test_the_pen_goes_on_from_either_end(qtbot):
    bench = Bench(qtbot, vase())
    bench.key(P)
    bench.click(bench.place(1, 3))
    stroke(bench, (40, 118))
    assert len(bench.document.profile) == 3
    assert bench.document.joints[1].measured == "C1"
    bench.key(Qt.Key.Key_Return)
    bench.click(bench.place(0, 0), modifiers=ALT)
    stroke(bench, (0, 0))
    profile = bench.document.profile
    assert len(profile) == 4
    assert near(bench.place(0, 0), bench.screen((0, 0)))
    assert np.array_equal(profile.segments[0].points[3], profile.segments[1].points[0])


def test_a_click_on_the_curve_inserts_a_joint(qtbot):
    bench = Bench(qtbot, vase())
    bench.key(P)
    bench.click(bench.screen(bench.document.profile.point(0, 0.4)))
    assert len(bench.document.profile) == 3
    assert bench.presenter.view.tool == "pen"


def test_a_click_on_bare_paper_does_nothing_to_a_profile_that_is_there(qtbot):
    bench = Bench(qtbot, vase())
    bench.key(P)
    bench.click(bench.screen((70, 60)))
    assert bench.undo_entries == []
    assert bench.view.tool.told()[1] == ["Begin at an end, or on the curve"]


def test_shift_holds_eighths_of_a_turn(pen):
    stroke(pen, (10, 0))
    stroke(pen, (40, 3), modifiers=SHIFT | CTRL)
    assert pen.point(0, 3)[1] == pen.point(0, 0)[1]


def test_it_all_goes_by_keyboard_alone(pen):
    arrows = Qt.Key.Key_Right, Qt.Key.Key_Up
    pen.key(arrows[0])
    pen.key(Qt.Key.Key_Space)
    for _ in range(3):
        pen.key(arrows[0], SHIFT)
    pen.key(Qt.Key.Key_Return)
    assert len(pen.document.profile) == 1
    for _ in range(3):
        pen.key(arrows[1], SHIFT)
    # While the space bar is down the arrows draw the handle out.
    pen.qtbot.keyPress(pen.view, Qt.Key.Key_Space)
    pen.key(arrows[1], SHIFT)
    pen.qtbot.keyRelease(pen.view, Qt.Key.Key_Space)
    pen.settle()
    assert len(pen.document.profile) == 2
    last = pen.document.profile.segments[1].points
    assert last[2][0] == last[3][0]
    assert last[2][1] < last[3][1]
    pen.key(Qt.Key.Key_Escape)
    assert pen.view.tool.run is None


def test_an_appended_segment_appears_in_view(qtbot):
    bench = Bench(qtbot, blank_document())
    bench.presenter.do("Append segment", edits.append_segment)
    bench.settle()
    end, area = bench.place(1, 3), bench.view.area
    assert area.left < end.x() < area.right
    assert area.top < end.y() < area.bottom


def test_the_blank_fades_until_its_first_segment_is_there(pen):
    assert not pen.view.tool.fades
    stroke(pen, (10, 0))
    assert pen.view.tool.fades
    pen.press(pen.screen((40, 20)))
    assert not pen.view.tool.fades
    pen.release(pen.screen((40, 20)))
    assert not pen.view.tool.fades


def test_the_pen_stops_at_the_axis(pen):
    stroke(pen, (20, 0))
    # A handle is as short as its mirror image has room.
    stroke(pen, (8, 40), (24, 60))
    points = pen.document.profile.segments[0].points
    assert np.allclose(points[2], (0, 30), atol=0.5)
    assert points[2, 0] >= 0.0
    stroke(pen, (-12, 60))
    assert np.allclose(pen.point(1, 3), (0, 60), atol=0.5)
    assert pen.point(1, 3)[0] == 0.0
    # That is a pole, and ends the run.
    assert not pen.view.tool.busy
    assert pen.presenter.frame.evaluation.axis_crossings == ()


def test_a_run_that_begins_beyond_the_axis_stays_there(pen):
    stroke(pen, (-10, 0))
    stroke(pen, (-8, 20))
    stroke(pen, (12, 30))
    assert np.allclose(pen.point(1, 3), (0, 30), atol=0.5)


def test_the_pen_goes_through_the_axis_where_the_preferences_let_points_do_so(pen):
    preferences.change(cross_axis=True)
    stroke(pen, (20, 0))
    stroke(pen, (-15, 40))
    assert np.allclose(pen.point(0, 3), (-15, 40), atol=0.5)


def test_the_cursor_of_the_keyboard_goes_far_in_even_steps(pen):
    """The picture moves with it: a picture that shrank would make each step larger."""
    pen.key(Qt.Key.Key_Up)
    scale, places = pen.view.transform.scale, []
    for _ in range(40):
        pen.key(Qt.Key.Key_Up, SHIFT)
        places.append(pen.view.tool._cursor.h)
        assert pen.view.area.contains(pen.view.transform.to_screen(pen.view.tool._cursor))
    assert pen.view.transform.scale == scale
    assert np.allclose(np.diff(places), places[1] - places[0])
    for _ in range(40):
        pen.key(Qt.Key.Key_Down, SHIFT)
    assert pen.view.area.contains(pen.view.transform.to_screen(pen.view.tool._cursor))


def test_the_buttons_are_painted_whole_where_a_wider_ruler_has_moved_them(pen, qtbot):
    tools = pen.view._buttons
    pen.view.zoom(0.001, ScreenPoint(100.0, 100.0))
    pen.settle()
    qtbot.waitUntil(lambda: tools.x() == round(pen.view.area.left) + 6)
    wide = tools.x()
    pen.view.fit()
    pen.settle()
    qtbot.waitUntil(lambda: tools.x() == round(pen.view.area.left) + 6)
    assert tools.x() < wide
