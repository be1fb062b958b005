"""Fitting a profile to a target curve by least largest deviation.

The paper varies ω alone (its section 5.2); freeing all shape parameters, or the control polygon
as well, comes far nearer. Deviation is measured along the target's normal.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from enum import StrEnum
from functools import partial

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.curves.basis import bernstein
from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import ShapeParameters
from sgb_core.design.fit_unknowns import Unknowns
from sgb_core.design.target_curves import TargetCurve

# Samples per segment when the result's deviation is stated; a search has fewer.
_STATED_SAMPLES = 4001
_SEED = 20


class Freedom(StrEnum):
    """What a fit may change."""

    OMEGA = "omega"
    SHAPE = "shape"
    POLYGON = "polygon"


@dataclass(frozen=True, slots=True)
class Deviation:
    """The largest distance from a target, and where on the profile it occurs."""

    largest: float
    segment: int
    s: float
    point: tuple[float, float]


@dataclass(frozen=True, slots=True)
class Fit:
    """A fitted profile and how far it still is from its target."""

    profile: Profile
    freedom: Freedom
    deviation: Deviation


def deviation(profile: Profile, target: TargetCurve, samples: int = _STATED_SAMPLES) -> Deviation:
    """Return the largest distance of a profile from a target over ``samples`` a segment."""
    s = np.linspace(0.0, 1.0, samples)
    points = bernstein(4, s) @ profile.quartics
    distances = np.abs(target.signed_distance(points))
    segment, index = np.unravel_index(int(np.argmax(distances)), distances.shape)
    r, h = points[segment, index]
    return Deviation(
        float(distances[segment, index]), int(segment), float(s[index]), (float(r), float(h))
    )


def fit(
    profile: Profile,
    target: TargetCurve,
    freedom: Freedom,
    starts: int = 12,
    *,
    keep_ends: bool = False,
    report: Callable[[float], None] = lambda _: None,
) -> Fit:
    """Return the profile that deviates least, in the largest deviation, from ``target``.

    OMEGA varies one ω for all segments, SHAPE all leg fractions, POLYGON also the control
    points but for the two ends of an open chain, which are put on the target's ends; joints
    stay joined, and smooth where their rule is G1 or stricter. There are poor local minima, so
    the search starts from the profile itself and from ``starts`` further places, always the
    same ones. With ``keep_ends`` POLYGON keeps the directions of the first and the last leg, so
    that a profile that meets the axis at a right angle stays smooth at its pole. ``report`` is
    told the part done, 0 to 1, at every step; what it raises ends the search. Raises ValueError
    for a closed profile with POLYGON.
    """
    if freedom is Freedom.OMEGA:
        return _fit_omega(profile, target)
    if freedom is Freedom.POLYGON and profile.closed:
        raise ValueError("the polygon of a closed profile cannot be fitted to an open target")
    unknowns = Unknowns(profile, target, freedom is Freedom.POLYGON, keep_ends)
    rng = np.random.default_rng(_SEED)
    best, least = unknowns.start, np.inf
    for number in range(starts + 1):
        unknowns.stepped = partial(report, number / (starts + 1))
        found = _least_largest(unknowns, unknowns.scattered(rng) if number else unknowns.start)
        if unknowns.largest(found) < least:
            best, least = found, unknowns.largest(found)
        report((number + 1) / (starts + 1))
    fitted = unknowns.profile(best)
    result = Fit(fitted, freedom, deviation(fitted, target))
    if freedom is Freedom.POLYGON:
        return result
    # The samples of the search are coarser than those of the stated deviation.
    simple = _fit_omega(profile, target)
    if simple.deviation.largest < result.deviation.largest:
        return Fit(simple.profile, freedom, simple.deviation)
    return result


def _fit_omega(profile: Profile, target: TargetCurve) -> Fit:
    """Scan ω, then narrow around the best of the scan by golden section."""

    def at(omega: float) -> Profile:
        shapes = [
            ShapeParameters(s.shape.lambda1, s.shape.lambda2, s.shape.lambda3, omega)
            for s in profile.segments
        ]
        return profile.with_segments(
            segment.with_shape(shape)
            for segment, shape in zip(profile.segments, shapes, strict=True)
        )

    def largest(omega: float) -> float:
        return deviation(at(omega), target, samples=401).largest

    scan = np.linspace(0.0, 1.0, 65)
    middle = int(np.argmin([largest(omega) for omega in scan]))
    low, high = scan[max(middle - 1, 0)], scan[min(middle + 1, 64)]
    omega = _golden(largest, float(low), float(high))
    omega = min((omega, float(scan[middle])), key=largest)
    return Fit(at(omega), Freedom.OMEGA, deviation(at(omega), target))


def _golden(function: Callable[[float], float], low: float, high: float) -> float:
    ratio = (np.sqrt(5.0) - 1.0) / 2.0
    for _ in range(60):
        first, second = high - ratio * (high - low), low + ratio * (high - low)
        low, high = (low, second) if function(first) < function(second) else (first, high)
    return (low + high) / 2.0


def _least_largest(unknowns: Unknowns, start: Floats) -> Floats:
    """Minimise the largest distance from one start: least squares first, then the bound itself.

    The second step is the epigraph form: the least t with −t ≤ dᵢ ≤ t for all samples.
    """
    # Imported late: only fitting needs it, and it takes a while to load.
    from scipy.optimize import Bounds, NonlinearConstraint, least_squares, minimize

    low, high = np.transpose(unknowns.bounds)
    inside = np.clip(start, low + 1e-9, high - 1e-9)
    rough = least_squares(
        unknowns.distances, inside, unknowns.slopes, bounds=(low, high), max_nfev=200
    ).x
    largest = unknowns.largest(rough)

    def room(vector: Floats) -> Floats:
        distances = unknowns.distances(vector[:-1])
        return np.concatenate([vector[-1] - distances, vector[-1] + distances])

    def room_slopes(vector: Floats) -> Floats:
        slopes = unknowns.slopes(vector[:-1])
        ones = np.ones((len(slopes), 1))
        return np.block([[-slopes, ones], [slopes, ones]])

    slope = np.append(np.zeros(len(rough)), 1.0)
    result = minimize(
        lambda vector: float(vector[-1]),
        np.append(rough, largest),
        jac=lambda _: slope,
        method="SLSQP",
        bounds=Bounds(np.append(low, 0.0), np.append(high, np.inf)),
        constraints=NonlinearConstraint(room, 0.0, np.inf, jac=room_slopes),
        options={"maxiter": 300, "ftol": 1e-12},
    ).x[:-1]
    return min(rough, np.clip(result, low, high), key=unknowns.largest)
