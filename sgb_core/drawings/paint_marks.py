"""Paint as areas of a plate's outside."""

from __future__ import annotations

from math import pi

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.drawings.half_view import HalfView
from sgb_core.drawings.page import Area, Layer, Mark, Path, Stroke
from sgb_core.drawings.paint import Band, Painted, Stripe

_BAND_STEPS = 200
_TURN = 2.0 * pi


def paint_marks(
    painted: Painted, view: HalfView, origin: tuple[float, float], factor: float, mirror: float
) -> list[Mark]:
    """Return the marks of one painted place; arguments as for the marks of the view."""
    if isinstance(painted, Stripe):
        return _stripe_marks(painted, view, origin, factor, mirror)
    return _band_marks(painted, view, origin, factor, mirror)


def _band_marks(
    band: Band, view: HalfView, origin: tuple[float, float], factor: float, mirror: float
) -> list[Mark]:
    low, high = max(band.low, view.low), min(band.high, view.high)
    if low >= high:
        return []
    heights = np.linspace(low, high, _BAND_STEPS)
    side = -mirror * factor
    outer = _placed(view.outside_at(heights) * side, heights * factor, origin)
    axis = [(origin[0], outer[-1][1]), (origin[0], outer[0][1])]
    made: list[Mark] = [
        Area(Layer.PAINT, (Path.through([*outer, *axis], closed=True),), band.colour)
    ]
    if band.edged:
        for end, foot in ((outer[0], axis[1]), (outer[-1], axis[0])):
            made.append(Stroke.of(Layer.EDGES, Path.through((foot, end))))
    return made


def _stripe_marks(
    stripe: Stripe, view: HalfView, origin: tuple[float, float], factor: float, mirror: float
) -> list[Mark]:
    """Return what is seen of a stripe: the quarter turn between the eye and the outline."""
    # The section lies at the start, to the right for an eye that sees 180° to 270°; mirrored, one
    # that sees 90° to 180° (the frame of ``outside``).
    near, far = (pi, 1.5 * pi) if mirror > 0.0 else (0.5 * pi, pi)
    inside = (stripe.heights >= view.low) & (stripe.heights <= view.high)
    heights = stripe.heights[inside]
    if len(heights) < 2:
        return []
    radii = view.outside_at(heights)
    made: list[Mark] = []
    turns = range(
        int(np.floor((near - stripe.last.max()) / _TURN)),
        int(np.ceil((far - stripe.first.min()) / _TURN)) + 1,
    )
    for turn in turns:
        first, last = (
            np.clip(each[inside] + turn * _TURN, near, far) for each in (stripe.first, stripe.last)
        )
        if not (last > first).any():
            continue
        # Where it runs out of sight both sides meet on the axis or on the outline.
        sides = [
            _placed(-np.cos(angle) * radii * -mirror * factor, heights * factor, origin)
            for angle in (first, last)
        ]
        path = Path.through([*sides[0], *sides[1][::-1]], closed=True)
        made.append(Area(Layer.PAINT, (path,), stripe.colour))
    return made


def _placed(x: Floats, y: Floats, origin: tuple[float, float]) -> list[tuple[float, float]]:
    return [
        (origin[0] + across, origin[1] + up)
        for across, up in zip(x.tolist(), y.tolist(), strict=True)
    ]
