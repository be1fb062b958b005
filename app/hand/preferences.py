"""How the user's preferences enter what the hand does: the snap step, the wheel's direction."""

from __future__ import annotations

from app.hand.coordinates import GridSteps
from app.state import preferences


def snap_steps(scale: float) -> GridSteps:
    """Return what dragged points snap to at a scale: the preferred step, or the grid's own."""
    step = preferences.current().snap_step
    return GridSteps(5.0 * step, step) if step > 0.0 else GridSteps.at(scale)


def wheel_turn(delta: float) -> float:
    """Return a wheel's turn as the user means it, above 0 to come nearer."""
    return -delta if preferences.current().invert_wheel else delta
