"""The turn panel: axis, angles, unit, size, scale, by real events."""

import pytest
from PySide6.QtCore import QPointF, Qt

from app.panels.turn.panel import TurnPanel
from app.state.presenter import Presenter
from sgb_core.document.session import Session
from sgb_core.surfaces.revolution import Axis
from tests.app.helpers import tower
from tests.app.mouse import LEFT, drag, move, press, release, wheel
from tests.app.waiting import let_turn, show

Key = Qt.Key


@pytest.fixture
def panel(qtbot):
    presenter = Presenter(Session(tower()))
    panel = TurnPanel(presenter)
    presenter.add_view(panel)
    show(qtbot, panel, 300, 420)
    return panel


@pytest.fixture
def session(panel):
    return panel._presenter.session


def type_in(qtbot, field, text):
    field.setFocus()
    field.selectAll()
    qtbot.keyClicks(field, text)
    qtbot.keyClick(field, Key.Key_Return)
    let_turn()


def bounds(session):
    return session.document.profile.bounds()


def height(session):
    low, high = bounds(session)
    return high[1] - low[1]


def diameter(session):
    low, high = bounds(session)
    return 2 * max(abs(low[0]), abs(high[0]))


def test_axis_buttons(qtbot, panel, session):
    assert panel.axis_buttons[Axis.Z].isChecked()
    qtbot.mouseClick(panel.axis_buttons[Axis.X], LEFT)
    assert session.document.revolution.axis == Axis.X
    assert session.undo_label == "Axis x"
    session.undo()
    let_turn()
    assert panel.axis_buttons[Axis.Z].isChecked()
    assert not panel.axis_buttons[Axis.X].isChecked()


def test_axis_by_keyboard(qtbot, panel, session):
    panel.axis_buttons[Axis.Y].setFocus()
    qtbot.keyClick(panel.axis_buttons[Axis.Y], Key.Key_Space)
    assert session.document.revolution.axis == Axis.Y


def test_sweep_by_slider_reaches_a_full_turn_exactly(qtbot, panel, session):
    type_in(qtbot, panel.sweep.field, "1/4 turn")
    assert session.document.revolution.sweep_deg == 90.0
    slider = panel.sweep.slider
    assert slider.number == 90.0
    end = QPointF(slider.width() + 9, slider.height() / 2)
    drag(slider, slider.handle_centre(), end)
    assert session.document.revolution.sweep_deg == 360.0
    assert [entry.label for entry in session.history[1:]] == ["Sweep", "Sweep"]


def test_a_drag_of_the_sweep_lands_on_half_degrees(qtbot, panel, session):
    slider = panel.sweep.slider
    start = slider.handle_centre()
    press(slider, start)
    move(slider, start - QPointF(37, 0))
    value = session.document.revolution.sweep_deg
    assert value < 360.0
    assert value * 2 == round(value * 2)
    qtbot.keyClick(slider, Key.Key_Escape)
    release(slider, start)
    assert session.document.revolution.sweep_deg == 360.0
    assert len(session.history) == 1


@pytest.mark.parametrize("text", ["0", "361", "-90"])
def test_a_sweep_out_of_range_is_refused(qtbot, panel, session, text):
    notices = []
    panel._presenter.noticed.connect(notices.append)
    type_in(qtbot, panel.sweep.field, text)
    assert len(session.history) == 1
    assert "above 0 and at most 360" in notices[0].text


def test_any_start_angle_can_be_typed(qtbot, panel, session):
    type_in(qtbot, panel.start.field, "720+45")
    assert session.document.revolution.start_deg == 765.0
    assert panel.start.slider.handle_centre() == panel.start.slider.handle_centre(180.0)


def test_height_and_diameter_by_number(qtbot, panel, session):
    type_in(qtbot, panel.height_field, "5cm")
    assert height(session) == pytest.approx(50.0, rel=1e-12)
    before = height(session)
    type_in(qtbot, panel.diameter_field, "40")
    assert diameter(session) == pytest.approx(40.0, rel=1e-12)
    assert height(session) == pytest.approx(before)
    assert [entry.label for entry in session.history[1:]] == ["Height", "Largest diameter"]
    assert panel.diameter_field.text() == "40"


def test_a_run_of_wheel_steps_on_the_height_is_one_entry(qtbot, panel, session):
    before = height(session)
    for _ in range(3):
        wheel(panel.height_field)
    assert height(session) == pytest.approx(before + 3.0)
    panel.height_field.finish()
    assert len(session.history) == 2


def test_scale_by_number_and_button(qtbot, panel, session):
    start = height(session)
    type_in(qtbot, panel.scale_field, "3/2")
    assert height(session) == pytest.approx(1.5 * start)
    assert panel.scale_field.value == 1.0
    assert panel.scale_field.text() == "1"
    for button in panel.findChildren(type(panel.axis_buttons[Axis.X])):
        if button.accessibleName() == "Scale by 2":
            qtbot.mouseClick(button, LEFT)
    assert height(session) == pytest.approx(3.0 * start)
    assert len(session.history) == 3


def test_escape_takes_back_a_scale_under_way(qtbot, panel, session):
    before = session.document
    wheel(panel.scale_field, 2)
    assert session.document is not before
    panel.scale_field.setFocus()
    qtbot.keyClick(panel.scale_field, Key.Key_Escape)
    assert session.document is before
    assert panel.scale_field.value == 1.0


def test_flip_turns_the_profile_upside_down(qtbot, panel, session):
    first = session.document.profile.segments[0].points[0, 0]
    qtbot.mouseClick(panel.flip, LEFT)
    assert session.undo_label == "Flip upside down"
    ends = {session.document.profile.point(0, 0.0)[0], session.document.profile.point(2, 1.0)[0]}
    assert first in ends


@pytest.mark.parametrize("keep", [True, False])
def test_the_unit_with_or_without_conversion(qtbot, panel, session, keep):
    before = height(session)
    panel.keep_size.setChecked(keep)
    panel.unit.setFocus()
    qtbot.keyClick(panel.unit, Key.Key_Down)
    let_turn()
    assert session.document.unit == "cm"
    assert height(session) == pytest.approx(before / 10 if keep else before)
    type_in(qtbot, panel.height_field, "50mm")
    assert height(session) == pytest.approx(5.0)
    assert session.history[1].label == "Unit cm"


@pytest.mark.parametrize("width", [236, 260, 340])
def test_nothing_is_clipped(qtbot, panel, width):
    panel.resize(width, 420)
    let_turn()
    assert panel.width() == width
    for row in (panel.start, panel.sweep):
        assert row.slider.width() >= 60
        assert row.field.geometry().right() <= row.width()
