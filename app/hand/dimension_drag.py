"""A dimension line in the hand: the value that brings it there."""

from __future__ import annotations

from app.hand.coordinates import GridSteps, Paper
from app.hand.dimension_lines import dimension_lines
from app.state.presenter import Presenter
from sgb_core.design.locks.spans import Way
from sgb_core.document import edits


def measure(
    presenter: Presenter,
    number: int,
    step: tuple[float, float],
    paper: Paper,
    steps: GridSteps | None,
) -> None:
    """Give a dimension the value that moves its end by ``step``, in ``steps`` where there are.

    The line is that of the gesture's start, so that nothing adds up.
    """
    start = presenter.session.gesture_start
    lines = dimension_lines(start, paper)
    line = next((each for each in lines if each.number == number), None)
    if line is None:
        return
    end = line.span.end
    value = line.span.value_at((end[0] + step[0], end[1] + step[1]))
    if steps is not None:
        # Angles in whole degrees.
        turns = line.span.way is Way.TURN
        value = float(round(value)) if turns else steps.snapped(value) or value
    presenter.apply(lambda d: edits.set_dimension(d, number, value).document)
