"""The picture that explains the method: a leg lit up, an arrow on it, a fan of curves."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from app.profile_canvas import Canvas
from app.view_state import Hover
from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import PARAMETER_RANGES, ParameterName, Segment

SLIDERS: tuple[ParameterName, ...] = ("lambda1", "lambda2", "lambda3")
SYMBOLS: dict[ParameterName, str] = {
    "lambda1": "λ1",
    "lambda2": "λ2",
    "lambda3": "λ3",
    "omega": "ω",
}
_FAN = 9
_CLEAR = 10.0
_LEGS = ((0, 1), (1, 2), (2, 3))


def draw_hover(canvas: Canvas, profile: Profile, hover: Hover) -> None:
    """Draw the range of one parameter, for one segment or for all."""
    chosen = range(len(profile)) if hover.segment is None else (hover.segment,)
    for index in chosen:
        if 0 <= index < len(profile):
            _draw_range(canvas, profile.segments[index], hover.parameter)


def range_of(segment: Segment, parameter: ParameterName, count: int) -> list[Segment]:
    """Return the segment at ``count`` equal steps of one parameter over its whole range."""
    low, high = PARAMETER_RANGES[parameter]
    return [
        segment.with_shape(replace(segment.shape, **{parameter: float(value)}))
        for value in np.linspace(low, high, count)
    ]


def _draw_range(canvas: Canvas, segment: Segment, parameter: ParameterName) -> None:
    fan = range_of(segment, parameter, _FAN)
    fine = canvas.pen("quartic", 1.2, 105)
    for shaped in fan[1:-1]:
        canvas.quartic(shaped.quartic, fine)
    for shaped in (fan[0], fan[-1]):
        canvas.quartic(shaped.quartic, canvas.pen("quartic", 1.5, 190))
    places = canvas.transform.map(segment.points)
    idle = parameter != "omega" and segment.shape.omega == 0.0
    moving = range(3) if parameter == "omega" else (SLIDERS.index(parameter),)
    for which in moving:
        near, far = _LEGS[which]
        canvas.line(places[near], places[far], canvas.pen("quartic", 5.0, 85))
        # The arrow runs as the parameter grows, over all that the quartic point can reach.
        start, end = canvas.transform.map(
            np.stack((fan[0].quartic[which + 1], fan[-1].quartic[which + 1]))
        )
        length = float(np.hypot(*(end - start)))
        if length > 3.0 * _CLEAR:
            # The mark of a control point must not hide the arrow's head.
            end = end + (start - end) * (_CLEAR / length)
        canvas.arrow(start, end, canvas.pen("quartic", 2.2), 9.0)
        if idle:
            text = f"{SYMBOLS[parameter]} acts when ω > 0"
            middle = (places[near] + places[far]) / 2.0
            canvas.label(middle, text, canvas.color("quartic"), 12.0)
