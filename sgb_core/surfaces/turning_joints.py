"""What joints truly are over the whole turn, where laws let them vary with the angle.

The leg fractions depend on the angle, and the radius by a factor. A class drops at single angles
only where an end derivative vanishes, which happens at an extreme, a key or a break of a law;
these are looked at exactly. What varies smoothly is followed from there to its largest.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from itertools import pairwise
from math import degrees, log, pi

import numpy as np

from sgb_core.curves import basis
from sgb_core.curves.continuity import (
    EndView,
    JointClass,
    JointReport,
    end_view,
    measure_ends,
    measure_joint,
    start_view,
    stretched,
)
from sgb_core.surfaces.angular import angle_edges, different_angles
from sgb_core.surfaces.revolution import RevolutionSurface
from sgb_core.surfaces.variation import parameters, radius_factors

# Angles looked at between two special ones.
_BETWEEN = 7
# The search for a largest value: rounds of so many angles inside the bracket, each of which leaves
# two parts of it; the value is then known to the square of what is left.
_ROUNDS = 5
_INSIDE = 15

Measure = Callable[[Sequence[float]], list[JointReport]]


def measure_turning_joints(surface: RevolutionSurface) -> tuple[JointReport, ...]:
    """Return what every joint truly is over θ in [0, sweep], in order.

    Without laws the joints of the profile. With laws each report has the lowest class at any
    angle, the largest kink and curvature jump (in size), and the speed ratio farthest from 1, in
    its logarithm; None where one is not bounded. ``at_deg`` is the angle where the class is
    lowest; of several the one with the largest kink, then the smallest angle.
    """
    profile = surface.profile
    if not surface.laws:
        return tuple(measure_joint(profile, joint) for joint in profile.joints)
    special = _special_angles(surface)
    return tuple(_over_turn(surface, joint, special) for joint in profile.joints)


def _special_angles(surface: RevolutionSurface) -> list[float]:
    """Return breaks, keys and extremes of the laws in what the turn repeats, both ends included."""
    edges = angle_edges(surface, bare=True)
    _, _, last = different_angles(surface, np.zeros(1))
    if np.isfinite(last) and surface.is_full_turn:
        edges = np.append(edges[edges < last - 1e-9], last)
    return [float(edge) for edge in edges]


def _over_turn(surface: RevolutionSurface, joint: int, special: Sequence[float]) -> JointReport:
    profile = surface.profile
    first, second = profile.neighbours(joint)
    rule, size = profile.rules[joint], profile.size
    if not any(law.applies_to(k) for law in surface.laws for k in (first, second)):
        return replace(measure_joint(profile, joint), at_deg=0.0)
    before, after = end_view(profile.segments[first]), start_view(profile.segments[second])

    def at(angles: Sequence[float]) -> list[JointReport]:
        values = parameters(profile, surface.laws, angles, numbers=(first, second))[0]
        factors = radius_factors(profile, surface.laws, angles, numbers=(first, second))[0]
        found = []
        for (one, other), (near, far) in zip(values.tolist(), factors.tolist(), strict=True):
            a1, b1, c1 = basis.leg_fractions(*one)
            a2, b2, c2 = basis.leg_fractions(*other)
            back = stretched(EndView(before.at, before.legs, c1, b1, a1), near)
            ahead = stretched(EndView(after.at, after.legs, a2, 1.0 - b2, c2), far)
            found.append(measure_ends(back, ahead, joint, rule, size))
        return found

    between = [np.linspace(low, high, _BETWEEN + 2)[:-1] for low, high in pairwise(special)]
    angles = [*np.concatenate(between).tolist(), special[-1]]
    return _worst(at, list(zip(angles, at(angles), strict=True)))


def _worst(at: Measure, reports: list[tuple[float, JointReport]]) -> JointReport:
    """Return the report of the worst of a joint's reports at increasing angles."""
    order = list(JointClass)
    lowest = min((report.measured for _, report in reports), key=order.index)
    kink_at, kink = _largest(at, reports, lambda r: r.kink_deg)
    _, jump = _largest(at, reports, lambda r: _size(r.curvature_jump))
    _, ratio = _largest(at, reports, lambda r: _off(r.speed_ratio))
    worst = [(theta, r) for theta, r in reports if r.measured is lowest]
    if lowest is JointClass.G0 and kink is not None:
        worst.append((kink_at, kink))
    # Kinks that differ by rounding alone are one.
    theta, report = min(worst, key=lambda each: (-round(each[1].kink_deg or 0.0, 9), each[0]))
    return replace(
        report,
        kink_deg=None if kink is None else kink.kink_deg,
        curvature_jump=None if jump is None else jump.curvature_jump,
        speed_ratio=None if ratio is None else ratio.speed_ratio,
        degenerate=any(r.degenerate for _, r in reports),
        at_deg=degrees(theta) % 360.0 if theta < 2.0 * pi else 360.0,
    )


def _size(value: float | None) -> float | None:
    return None if value is None else abs(value)


def _off(ratio: float | None) -> float | None:
    return None if ratio is None or ratio == 0.0 else abs(log(ratio))


def _largest(
    at: Measure,
    reports: list[tuple[float, JointReport]],
    value: Callable[[JointReport], float | None],
) -> tuple[float, JointReport | None]:
    """Return where a value is largest, and the report there; None where it is not bounded."""
    values = [value(report) for _, report in reports]
    if any(each is None for each in values):
        return 0.0, None
    known = [float(each or 0.0) for each in values]
    # Rounding alone makes no angle better than an earlier one.
    top = next(k for k, each in enumerate(known) if each >= max(known) * (1.0 - 1e-12))
    if min(known) >= known[top] * (1.0 - 1e-12):
        return reports[top]
    low, high = reports[max(top - 1, 0)][0], reports[min(top + 1, len(reports) - 1)][0]
    best = (known[top], *reports[top])
    for _ in range(_ROUNDS):
        inner = np.linspace(low, high, _INSIDE + 2).tolist()
        found = list(zip(inner, at(inner), strict=True))
        sizes = [float(value(report) or 0.0) for _, report in found]
        k = max(range(len(sizes)), key=sizes.__getitem__)
        if sizes[k] > best[0] * (1.0 + 1e-12):
            best = (sizes[k], *found[k])
        low, high = inner[max(k - 1, 0)], inner[min(k + 1, len(inner) - 1)]
    return best[1], best[2]
