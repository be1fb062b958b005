"""Where a profile crosses the axis, and what its control polygon alone rules out.

Where the profile crosses itself: :mod:`sgb_core.curves.intersections`.
"""

from __future__ import annotations

from itertools import pairwise
from math import atan2, tau

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.curves.intersections import self_intersections
from sgb_core.curves.profile import Profile
from sgb_core.curves.roots import evaluate, real_roots
from sgb_core.findings.profile import BeyondAxis, Crossing
from sgb_core.values import dataclass

__all__ = [
    "BeyondAxis",
    "Certificates",
    "Crossing",
    "axis_crossings",
    "certificates",
    "self_intersections",
]

# Less than this part of the largest coordinate is rounding.
_ROUNDING = 1e-12


@dataclass(frozen=True, slots=True)
class Certificates:
    """What holds at every setting of λ and ω that moves no control point.

    Read off the control polygon: corner cutting keeps these properties. Sufficient, not
    necessary. ``convex`` is of the curve closed by its chord.
    """

    never_crosses_axis: bool
    height_monotone: bool
    convex: bool


def axis_crossings(profile: Profile) -> tuple[BeyondAxis, ...]:
    """Return the stretches on the far side of the axis r = 0, in order.

    The near side is the one on which most of the profile lies (the sign of Σ∫ r ds). The ends
    of the stretches are the exact roots of the quartic r(s); touching the axis, and dipping
    below it by rounding only, does not count.

    >>> beyond = sgb.Segment([(10, 0), (-10, 0), (-10, 60), (10, 60)])
    >>> [stretch] = sgb.axis_crossings(sgb.Profile.of([beyond]))
    >>> round(stretch.s0, 3), round(stretch.s1, 3)
    (0.211, 0.789)
    """
    radii = profile.quartics[:, :, 0]
    if radii.sum() < 0.0:
        radii = -radii
    tolerance = _ROUNDING * max(profile.size, float(np.abs(profile.control_points).max()))
    found: list[BeyondAxis] = []
    for number, row in enumerate(radii):
        if row.min() >= -tolerance:
            continue  # The curve lies in the hull of its quartic points.
        coefficients = row.tolist()
        slopes = np.diff(row).tolist()
        extrema = [(s, evaluate(coefficients, s)) for s in (0.0, *real_roots(slopes), 1.0)]
        marks = sorted({0.0, *real_roots(coefficients), 1.0})
        for s0, s1 in pairwise(marks):
            # Between two roots the radius is most negative at an extremum or an end.
            if min((r for s, r in extrema if s0 <= s <= s1), default=0.0) < -tolerance:
                middle = evaluate(coefficients, 0.5 * (s0 + s1))
                if middle < 0.0:
                    found.append(BeyondAxis(number, s0, s1))
    return tuple(found)


def certificates(profile: Profile) -> Certificates:
    """Return what the control polygon alone guarantees about the curve.

    >>> sgb.certificates(sgb.Profile.of([sgb.line((20, 0), (25, 60))])).height_monotone
    True
    """
    points = profile.control_points.reshape(-1, 2)
    radii, rises = points[:, 0], np.diff(points[:, 1])
    return Certificates(
        never_crosses_axis=bool((radii >= 0.0).all() or (radii <= 0.0).all()),
        height_monotone=bool((rises >= 0.0).all() or (rises <= 0.0).all()),
        convex=_is_convex(points, _ROUNDING * profile.size),
    )


def _is_convex(points: Floats, tolerance: float) -> bool:
    """Whether a polygon, closed by its chord, turns one way only and once around."""
    steps = np.diff(points, axis=0, append=points[:1])
    steps = steps[np.hypot(steps[:, 0], steps[:, 1]) > tolerance]
    if len(steps) < 3:
        return True
    following = np.roll(steps, -1, axis=0)
    cross = steps[:, 0] * following[:, 1] - steps[:, 1] * following[:, 0]
    turns = [
        atan2(c, d)
        for c, d in zip(cross.tolist(), (steps * following).sum(axis=1).tolist(), strict=True)
    ]
    # A turn by ±180° has no side of its own.
    sides = {t > 0.0 for t in turns if 1e-9 < abs(t) < tau / 2 - 1e-9}
    return len(sides) <= 1 and sum(map(abs, turns)) <= tau + 1e-6
