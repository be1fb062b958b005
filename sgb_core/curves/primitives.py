"""Segments that are something familiar: a straight line, a cubic Bézier curve, an arc."""

from __future__ import annotations

from math import cos, pi, sin

import numpy as np
from numpy.typing import ArrayLike

from sgb_core.arrays import Floats
from sgb_core.curves import basis
from sgb_core.curves.segment import Segment, ShapeParameters
from sgb_core.fields.kinds import Said
from sgb_core.findings.errors import FindingError
from sgb_core.findings.refusal import Argument

# Where the radial error is watched, over half of the symmetric arc.
_WATCHED = 2001
_ROUNDS = 20
# So many samples next to the end have an error that is rounding, of either sign.
_UNSURE = 60
# The arc's error is a multiple of s²(1−s)²; these zeros nearly level its three extremes.
_FIRST_ZEROS = (0.186, 0.39)


def line(start: ArrayLike, end: ArrayLike) -> Segment:
    """Return the straight line from start to end (r, h), run at constant speed. Exact.

    >>> sgb.line((20, 0), (20, 60)).point(0.25).tolist()
    [20.0, 15.0]
    """
    p, q = np.asarray(start, dtype=np.float64), np.asarray(end, dtype=np.float64)
    return Segment(np.stack([p, p + (q - p) / 3.0, q + (p - q) / 3.0, q]))


def cubic(points: ArrayLike) -> Segment:
    """Return the cubic Bézier curve of control points of shape (4, 2). Exact.

    >>> sgb.cubic([(20, 0), (55, 10), (50, 60), (25, 80)]).point(1.0).tolist()
    [25.0, 80.0]
    """
    return Segment(np.asarray(points, dtype=np.float64))


def arc(center: ArrayLike, radius: float, start: float, end: float) -> tuple[Segment, float]:
    """Return (segment, deviation): the best single segment for a circular arc.

    Angles in radians from +r towards +h; a negative sweep runs the other way. The segment is
    symmetric, with the arc's own end points and end tangents; the two freedoms left (its leg
    fraction and its polygon's width) are spent on the least possible largest radial error,
    which is returned: three extremes of equal size, found by Remez' exchange. Raises ValueError
    for a radius that is not positive and for a sweep of 0 or above 270°, for which no single
    segment is close.

    >>> quarter, deviation = sgb.arc((0, 0), 10.0, 0.0, math.pi / 2)
    >>> quarter.point([0.0, 1.0]).round(9).tolist()
    [[10.0, 0.0], [0.0, 10.0]]
    >>> deviation < 1e-3
    True
    """
    sweep = end - start
    if not radius > 0.0:
        raise FindingError(Argument("the radius", radius, Said("above 0")))
    # The difference of the angles is rounded: 270° are not above 270°.
    if not 0.0 < abs(sweep) <= 1.5 * pi * (1.0 + 1e-12):
        raise FindingError(Argument("the sweep", sweep, Said("above 0 and at most 3π/2")))
    half = abs(sweep) / 2.0
    pull, width = _unit_arc(half)
    # The unit arc lies around angle 0, from −half to +half.
    first = np.array([np.cos(half), -np.sin(half)])
    along = np.array([np.sin(half), np.cos(half)])
    points = np.array(
        [first, first + width * along, first + width * along, first], dtype=np.float64
    )
    points[2:, 1] *= -1.0
    shape = ShapeParameters.from_leg_fractions(pull / width, 0.5, pull / width)
    if sweep < 0.0:
        points = points[::-1]
    middle = 0.5 * (start + end)
    turn = np.array([[np.cos(middle), np.sin(middle)], [-np.sin(middle), np.cos(middle)]])
    placed = np.asarray(center, dtype=np.float64) + radius * (points @ turn)
    segment = Segment(placed, shape)
    offset = segment.point(np.linspace(0.0, 1.0, _WATCHED)) - np.asarray(center)
    deviation = np.abs(np.hypot(offset[:, 0], offset[:, 1]) - radius).max()
    return segment, float(deviation)


def _unit_arc(half: float) -> tuple[float, float]:
    """Return (|Q1 − Q0|, |P1 − P0|) of the best segment for the unit arc of ±half."""
    s = np.linspace(0.0, 0.5, _WATCHED)
    weights = basis.bernstein(4, s)
    cosine, sine = cos(half), sin(half)
    # The quartic with the arc's own speed at the ends, through the arc's middle.
    pull = half / 2.0
    width = (16.0 - 16.0 * cosine - 8.0 * pull * sine) / (6.0 * sine)

    def error(pull: float, width: float) -> tuple[Floats, Floats]:
        """Return the radial error and its derivatives with respect to both freedoms."""
        x0, y0 = cosine, -sine
        r = weights @ np.array([x0, x0 + pull * sine, x0 + width * sine, x0 + pull * sine, x0])
        h = weights @ np.array([y0, y0 + pull * cosine, 0.0, -y0 - pull * cosine, -y0])
        distance = np.hypot(r, h)
        d_pull = (r * (weights[:, 1] + weights[:, 3]) * sine) + h * (
            weights[:, 1] - weights[:, 3]
        ) * cosine
        d_width = r * weights[:, 2] * sine
        return distance - 1.0, np.stack([d_pull, d_width], axis=1) / distance[:, None]

    # Zeros at fixed places first: between and beyond them lie the three extremes.
    zeros = (2.0 * (_WATCHED - 1) * np.array(_FIRST_ZEROS)).astype(int)
    for _ in range(_ROUNDS):
        value, slope = error(pull, width)
        step = np.linalg.lstsq(slope[zeros], -value[zeros], rcond=None)[0]
        pull, width = pull + float(step[0]), width + float(step[1])
    for _ in range(_ROUNDS):
        value, slope = error(pull, width)
        below = value[_UNSURE:] < 0.0
        changes = _UNSURE + np.flatnonzero(below[1:] != below[:-1])
        if len(changes) != 2 or np.abs(value).max() < 1e-13:
            break  # A short arc: the error is rounding.
        pieces = np.split(np.arange(_WATCHED), changes + 1)
        places = np.array([piece[np.argmax(np.abs(value[piece]))] for piece in pieces])
        matrix = np.column_stack([slope[places], -np.sign(value[places])])
        step = np.linalg.lstsq(matrix, -value[places], rcond=None)[0]
        pull, width = pull + float(step[0]), width + float(step[1])
    return pull, width
