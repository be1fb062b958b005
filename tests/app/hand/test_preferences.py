import pytest

from app.hand.coordinates import GridSteps
from app.hand.preferences import snap_steps, wheel_turn
from app.state import preferences


def test_the_grid_that_is_seen_or_the_step_that_is_preferred():
    assert snap_steps(3.0) == GridSteps.at(3.0)
    preferences.change(snap_step=2.5)
    for scale in (0.1, 3.0, 200.0):
        assert snap_steps(scale).snapped(8.9) == pytest.approx(10.0)
        assert snap_steps(scale).snapped(-1.0) == pytest.approx(0.0)


def test_the_wheel_turns_as_preferred():
    assert wheel_turn(120) == 120
    preferences.change(invert_wheel=True)
    assert wheel_turn(120) == -120
