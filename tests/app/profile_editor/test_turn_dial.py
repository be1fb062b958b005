"""Both ends of the turn dragged on the dial in the editor's corner, by real events."""

from math import cos, radians, sin

import pytest
from PySide6.QtCore import QPointF, Qt
from PySide6.QtTest import QTest

from app.hand.turn import TurnEnd
from app.profile_editor.turn_dial import RADIUS, SIDE, TurnDial
from sgb_core.document import edits
from tests.app.mouse import hover, move, press, release
from tests.app.profile_editor.bench import Bench, vase


@pytest.fixture
def bench(qtbot):
    made = Bench(qtbot, vase())
    made.dial = made.view.findChild(TurnDial)
    return made


def at(degrees):
    """A place of the dial's circle, counted from the right upwards."""
    angle = radians(degrees)
    return QPointF(SIDE / 2 + RADIUS * cos(angle), SIDE / 2 - RADIUS * sin(angle))


def turn(bench):
    revolution = bench.document.revolution
    return revolution.start_deg, revolution.sweep_deg


def drag(bench, start, *goals, modifiers=Qt.KeyboardModifier.NoModifier):
    press(bench.dial, start)
    for goal in goals:
        QTest.mouseMove(bench.dial, goal.toPoint())
        move(bench.dial, goal)
    release(bench.dial, goals[-1], modifiers)


def test_the_end_is_dragged_to_a_round_angle_as_one_step(bench):
    hover(bench.dial, bench.dial.place(TurnEnd.END))
    assert bench.dial.cursor().shape() is Qt.CursorShape.OpenHandCursor
    assert bench.dial.told().startswith("Sweep 360.0°")
    drag(bench, bench.dial.place(TurnEnd.END), at(330), at(300), at(268))
    assert turn(bench) == (0.0, 270.0)
    assert bench.undo_entries == ["Sweep"]
    bench.presenter.undo()
    assert turn(bench) == (0.0, 360.0)


def test_the_start_turns_the_whole(bench):
    bench.presenter.do("Sweep", lambda d: edits.set_revolution(d, sweep_deg=180.0))
    bench.settle()
    drag(bench, bench.dial.place(TurnEnd.START), at(20), at(64))
    assert turn(bench) == (60.0, 180.0)
    assert bench.undo_entries[-1] == "Start angle"
    # Beyond the back of the dial the turns are counted.
    drag(bench, bench.dial.place(TurnEnd.START), at(120), at(175), at(199))
    assert turn(bench)[0] == -165.0


def test_escape_takes_it_back_and_a_click_does_nothing(bench):
    press(bench.dial, bench.dial.place(TurnEnd.END))
    move(bench.dial, at(300))
    assert turn(bench) != (0.0, 360.0)
    QTest.keyClick(bench.dial, Qt.Key.Key_Escape)
    assert turn(bench) == (0.0, 360.0)
    move(bench.dial, at(250))
    release(bench.dial, at(250))
    assert turn(bench) == (0.0, 360.0)
    press(bench.dial, bench.dial.place(TurnEnd.START))
    release(bench.dial, bench.dial.place(TurnEnd.START))
    assert bench.undo_entries == []
    assert not bench.presenter.session.in_gesture


def test_undo_in_the_middle_drops_the_drag(bench):
    press(bench.dial, bench.dial.place(TurnEnd.END))
    move(bench.dial, at(300))
    bench.presenter.cancel()
    bench.settle()
    move(bench.dial, at(200))
    release(bench.dial, at(200))
    assert turn(bench) == (0.0, 360.0)


def test_beside_the_handles_the_paper_is_left_alone(bench):
    press(bench.dial, at(180))
    move(bench.dial, at(150))
    release(bench.dial, at(150))
    assert turn(bench) == (0.0, 360.0)
    assert not bench.presenter.session.in_gesture
