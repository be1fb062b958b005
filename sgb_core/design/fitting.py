"""Fitting a profile to a target curve by least largest deviation, or by least squares.

The paper varies ω alone (its section 5.2); freeing all shape parameters, or the control polygon
as well, comes far nearer. Deviation is measured along the target's normal.
"""

from __future__ import annotations

from collections.abc import Callable
from enum import StrEnum
from functools import partial

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.curves.basis import bernstein
from sgb_core.curves.profile import Profile
from sgb_core.curves.search import least
from sgb_core.curves.segment import ShapeParameters
from sgb_core.design.fit_unknowns import Unknowns
from sgb_core.design.least_largest import least_largest, least_squares
from sgb_core.design.target_curves import TargetCurve
from sgb_core.findings.edits import NoFit
from sgb_core.findings.errors import FindingError
from sgb_core.values import dataclass

# Samples per segment when the result's deviation is stated; a search has fewer.
_STATED_SAMPLES = 4001
_SEED = 20
# Steps of least squares from every start; of how many of the nearest these are brought to an end,
# and how many of those are followed to the least largest.
_ROUGH, _KEPT, _FOLLOWED = 15, 3, 2
# As near as this, in the target's size, no other start is tried.
_CLOSE = 1e-8


class Freedom(StrEnum):
    """What a fit may change."""

    OMEGA = "omega"
    SHAPE = "shape"
    POLYGON = "polygon"


@dataclass(frozen=True, slots=True)
class Deviation:
    """The largest distance from a target, where on the profile it occurs, and the rms distance."""

    largest: float
    segment: int
    s: float
    point: tuple[float, float]
    rms: float


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
        float(distances[segment, index]),
        int(segment),
        float(s[index]),
        (float(r), float(h)),
        float(np.sqrt(np.mean(distances**2))),
    )


def fit(
    profile: Profile,
    target: TargetCurve,
    freedom: Freedom,
    starts: int = 12,
    *,
    keep_ends: bool = False,
    slide_poles: bool = False,
    squares: bool = False,
    report: Callable[[float], None] = lambda _: None,
) -> Fit:
    """Return the profile that deviates least, in the largest deviation, from ``target``.

    OMEGA varies one ω for all segments, SHAPE all leg fractions, POLYGON also the control
    points but for the two ends of an open chain, which are put on the target's ends; joints
    stay joined, and smooth where their rule is G1 or stricter. Where the chain and its rules are
    symmetric, as targets are, so is the polygon. There are poor local minima, so the search
    starts from the profile itself, from the target's own course and from up to ``starts`` places
    more, always the same ones. With ``keep_ends`` POLYGON keeps the directions of the first and
    the last leg, so that a profile that meets the axis at a right angle stays smooth at its pole;
    with ``slide_poles`` the ends move along the axis. With ``squares`` the sum of squares counts
    instead of the largest deviation. ``report`` is told the part done, 0 to 1, at every step; what
    it raises ends the search. Raises FindingError for POLYGON of a closed profile with an open
    target, or the other way round.
    """
    if freedom is Freedom.OMEGA:
        return _fit_omega(profile, target, squares)
    if freedom is Freedom.POLYGON and profile.closed != target.closed:
        raise FindingError(NoFit.OPEN_AND_CLOSED)
    polygon = freedom is Freedom.POLYGON
    unknowns = Unknowns(profile, target, polygon, keep_ends, slide_poles)
    rng = np.random.default_rng(_SEED)
    places = [*([unknowns.along] if polygon else []), unknowns.start]
    places += [unknowns.scattered(rng) for _ in range(starts)]
    best = _search(unknowns, places, squares, report)
    report(1.0)
    fitted = unknowns.profile(best)
    result = Fit(fitted, freedom, deviation(fitted, target))
    if polygon:
        return result
    # The samples of the search are coarser than those of the stated deviation.
    simple = _fit_omega(profile, target, squares)
    if _size(simple.deviation, squares) < _size(result.deviation, squares):
        return Fit(simple.profile, freedom, simple.deviation)
    return result


def _search(
    unknowns: Unknowns, places: list[Floats], squares: bool, report: Callable[[float], None]
) -> Floats:
    """Return the best that is found from some places: roughly from all, then from the nearest."""
    measure = unknowns.squares if squares else unknowns.largest
    steps = len(places) + 2 * _KEPT
    rough: list[Floats] = []
    for number, place in enumerate(places):
        stepped = partial(report, number / steps)
        rough.append(least_squares(unknowns, place, stepped, _ROUGH))
        if unknowns.largest(rough[-1]) <= _CLOSE:
            break
    # The first is the target's own course, which few steps may not show to be the best.
    near = [rough[0], *sorted([unknowns.start, *rough[1:]], key=measure)[: _KEPT - 1]]
    for number, place in enumerate(near):
        stepped = partial(report, (len(places) + number) / steps)
        near[number] = least_squares(unknowns, place, stepped)
    near.sort(key=measure)
    if squares:
        return near[0]
    for number, place in enumerate(near[:_FOLLOWED]):
        stepped = partial(report, (len(places) + _KEPT + number) / steps)
        near.append(least_largest(unknowns, place, stepped))
    return min(near, key=measure)


def _size(found: Deviation, squares: bool) -> float:
    return found.rms if squares else found.largest


def _fit_omega(profile: Profile, target: TargetCurve, squares: bool) -> Fit:
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
        return _size(deviation(at(omega), target, samples=401), squares)

    scan = np.linspace(0.0, 1.0, 65)
    middle = int(np.argmin([largest(omega) for omega in scan]))
    low, high = scan[max(middle - 1, 0)], scan[min(middle + 1, 64)]
    omega = least(largest, float(low), float(scan[middle]), float(high))
    return Fit(at(omega), Freedom.OMEGA, deviation(at(omega), target))
