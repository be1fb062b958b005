"""A parameter asked to animate swings over its range and leaves no trace."""

import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest

from app.panels.turn.panel import TurnPanel
from app.state import parameter_animation
from sgb_core.curves.segment import PARAMETER_RANGES
from tests.app.helpers import tower
from tests.app.mouse import LEFT
from tests.app.panels.shape.helpers import SHAPE, open_panel, row, shape
from tests.app.waiting import let_turn


@pytest.fixture
def panel(qtbot, monkeypatch):
    monkeypatch.setattr(parameter_animation, "SWING_SECONDS", 0.6)
    return open_panel(qtbot, tower(SHAPE, rule="G0"))


def animate(part):
    """Take Animate in the context menu of a row."""
    menu = part.field.menu(part)
    next(action for action in menu.actions() if action.text() == "Animate").trigger()


@pytest.mark.parametrize("parameter", list(PARAMETER_RANGES))
def test_a_swing_runs_over_the_range_and_back_and_leaves_no_trace(qtbot, panel, parameter):
    session = panel._presenter.session
    before, seen = session.document, []
    session.subscribe(
        lambda _old, new: seen.append(getattr(new.profile.segments[1].shape, parameter))
    )
    animate(row(panel, 1, parameter))
    assert panel.sway.running
    assert not session.is_modified
    qtbot.waitUntil(lambda: not panel.sway.running)
    low, high = PARAMETER_RANGES[parameter]
    assert max(seen) - min(seen) > 0.5 * (high - low)
    assert session.document is before
    assert len(session.history) == 1
    assert not session.is_modified


def test_all_segments_swing_where_all_are_chosen(qtbot, panel):
    presenter = panel._presenter
    presenter.set_view(all_segments=True)
    let_turn()
    animate(row(panel, 0, "lambda2"))
    start = presenter.session.gesture_start

    def moved():
        return all(
            now.shape.lambda2 != then.shape.lambda2
            for now, then in zip(
                presenter.document.profile.segments, start.profile.segments, strict=True
            )
        )

    qtbot.waitUntil(moved)
    panel.sway.stop()
    assert presenter.document is start


def test_escape_ends_a_swing_and_nothing_else(qtbot, panel):
    session = panel._presenter.session
    before = session.document
    animate(row(panel, 1, "omega"))
    qtbot.waitUntil(lambda: session.document is not before)
    QTest.keyClick(panel, Qt.Key.Key_Escape)
    assert not panel.sway.running
    assert session.document is before


def test_a_press_on_a_slider_ends_a_swing_and_its_drag_counts(qtbot, panel):
    session = panel._presenter.session
    before = shape(session, 1).omega
    animate(row(panel, 1, "lambda1"))
    qtbot.waitUntil(lambda: shape(session, 1).lambda1 != SHAPE.lambda1)
    slider = row(panel, 1, "omega").slider
    QTest.mouseClick(slider, LEFT, pos=QPoint(slider.width() - 12, slider.height() // 2))
    assert not panel.sway.running
    assert shape(session, 1).lambda1 == SHAPE.lambda1
    assert shape(session, 1).omega != before
    assert len(session.history) == 2


def test_the_sweep_swings_too(qtbot, panel):
    turn = TurnPanel(panel._presenter)
    qtbot.addWidget(turn)
    panel._presenter.add_view(turn)
    turn.show()
    before = panel._presenter.document
    animate(turn.sweep)
    qtbot.waitUntil(lambda: panel._presenter.document.revolution.sweep_deg != 360.0)
    turn.sway.stop()
    let_turn()
    assert panel._presenter.document is before
