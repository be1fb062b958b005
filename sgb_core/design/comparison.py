"""Other curves on the same control polygons: how fair they are, and how far from the SG-Bézier.

The plain cubic, λ = (1, 3, 1) and ω = 0; the quartic Bézier curve, the shape as it is with ω = 1;
and the rational cubic R(t) = Σ wᵢ Bᵢ(t) Pᵢ / Σ wᵢ Bᵢ(t) with end weights 1 whose two inner weights
bring it nearest to the SG-Bézier curve, by the mean square of its distance.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from enum import StrEnum

import numpy as np

from sgb_core.arrays import Floats, frozen
from sgb_core.curves import basis
from sgb_core.curves.nearest import distances
from sgb_core.curves.nodes import gauss
from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import NEUTRAL, Segment
from sgb_core.findings.fairing import JointInTheWay, MeasureInTheWay
from sgb_core.surfaces.energy import bending_energy
from sgb_core.values import dataclass

# Places by which a rational curve is fitted, and by which deviations are measured.
_FITTED, MEASURED = 49, 201
# Weights beyond have left the curve at a leg of the polygon.
_MOST_LOG = 7.0
_PANELS = 16
_NODES, _WEIGHTS = gauss(16)


class Kind(StrEnum):
    """Which curve: four on the same polygon, and the fairest of four kinds."""

    SG = "sg-bezier"
    CUBIC = "cubic"
    QUARTIC = "quartic"
    RATIONAL = "rational-cubic"
    FAIREST = "sg-bezier-fairest"
    FREED = "sg-bezier-freed"
    BEST_CUBIC = "best-cubic"
    BEST_QUARTIC = "best-quartic"


@dataclass(frozen=True, slots=True, eq=False)
class Compared:
    """One kind of curve on all polygons of a profile, or between its joints.

    ``points`` are samples of each segment, (n, 201, 2); ``energy`` is ∫ κ² dl in 1/unit, None
    where it diverges; ``deviation`` the largest distance (unit) of a sample from the SG-Bézier
    curve; ``polygons`` are the control points of each segment, (n, 4, 2) or (n, 5, 2); ``weights``
    the inner weights of each segment, empty unless rational; ``missed`` is what such a curve
    cannot keep, None where it keeps all.
    """

    kind: Kind
    points: Floats
    energy: float | None
    deviation: float
    polygons: Floats
    weights: tuple[tuple[float, float], ...] = ()
    missed: JointInTheWay | MeasureInTheWay | None = None


def compared(profile: Profile) -> tuple[Compared, ...]:
    """Return the SG-Bézier curve, the cubic, the quartic and the nearest rational cubic."""
    size = profile.size or 1.0
    # In parts of the size: powers of the least lengths there are would vanish.
    unit = profile.with_segments(each.with_points(each.points / size) for each in profile)
    return tuple(
        replace(
            each,
            points=frozen(each.points * size),
            energy=None if each.energy is None else each.energy / size,
            deviation=each.deviation * size,
            polygons=profile.control_points,
        )
        for each in _compared(unit)
    )


def _compared(profile: Profile) -> tuple[Compared, ...]:
    cubic = profile.with_segments(each.with_shape(NEUTRAL) for each in profile)
    quartic = profile.with_segments(
        each.with_shape(replace(each.shape, omega=1.0)) for each in profile
    )
    found = [
        _of_profile(kind, each, profile)
        for kind, each in ((Kind.SG, profile), (Kind.CUBIC, cubic), (Kind.QUARTIC, quartic))
    ]
    weights = tuple(nearest_weights(each) for each in profile)
    t = np.linspace(0.0, 1.0, MEASURED)
    curves = [
        rational_cubic(each.points, pair, t) for each, pair in zip(profile, weights, strict=True)
    ]
    energies = [
        _rational_energy(each.points, pair) for each, pair in zip(profile, weights, strict=True)
    ]
    rational = Compared(
        Kind.RATIONAL,
        frozen(curves),
        None if None in energies else float(sum(each for each in energies if each is not None)),
        farthest(profile, curves),
        profile.control_points,
        weights,
    )
    return (*found, rational)


def _of_profile(kind: Kind, profile: Profile, other: Profile) -> Compared:
    points = profile.sample(MEASURED)
    away = 0.0 if kind is Kind.SG else farthest(other, list(points))
    return Compared(kind, frozen(points), bending_energy(profile), away, profile.control_points)


def farthest(profile: Profile, curves: list[Floats]) -> float:
    """Return the largest distance of samples from the profile's segments, each from its own."""
    return max(
        float(distances(each, points).max()) for each, points in zip(profile, curves, strict=True)
    )


def rational_cubic(points: Floats, weights: tuple[float, float], t: Floats) -> Floats:
    """Return the rational cubic on a polygon (4, 2) with these inner weights, shape (N, 2)."""
    rows = basis.bernstein(3, t) * np.array([1.0, *weights, 1.0])
    return np.asarray(rows @ points / rows.sum(axis=1, keepdims=True))


def nearest_weights(segment: Segment) -> tuple[float, float]:
    """Return the inner weights of the rational cubic nearest to a segment.

    Found by the simplex method of Nelder and Mead in the logarithms of the weights, from 1 and 1.
    """
    from scipy.optimize import minimize

    size = segment.size
    if segment.shape.is_neutral or size == 0.0:
        return 1.0, 1.0
    unit = segment.with_points(segment.points / size)
    t = np.linspace(0.0, 1.0, _FITTED)

    def miss(logs: Floats) -> float:
        held = np.clip(logs, -_MOST_LOG, _MOST_LOG)
        first, last = np.exp(held).tolist()
        off = distances(unit, rational_cubic(unit.points, (first, last), t))
        return float((off * off).mean() + np.abs(logs - held).sum())

    options = {"xatol": 1e-5, "fatol": 1e-14, "maxiter": 300}
    best = minimize(miss, np.zeros(2), method="Nelder-Mead", options=options)
    first, last = np.exp(np.clip(best.x, -_MOST_LOG, _MOST_LOG)).tolist()
    return first, last


def _rational_energy(points: Floats, weights: tuple[float, float]) -> float | None:
    """Return ∫ κ² dl of a rational cubic, by Gauss' rule; None where it has no tangent."""
    w = np.array([1.0, *weights, 1.0])
    edges = np.linspace(0.0, 1.0, _PANELS + 1)
    t = (edges[:-1, None] + np.diff(edges)[:, None] * _NODES).ravel()
    share = np.tile(_WEIGHTS, _PANELS) / _PANELS
    top, below = _derivatives(w[:, None] * points, t), _derivatives(w[:, None], t)
    # (N/D)' and (N/D)'' by the quotient rule.
    place = top(0) / below(0)
    first = (top(1) - place * below(1)) / below(0)
    second = (top(2) - 2.0 * first * below(1) - place * below(2)) / below(0)
    speed = np.hypot(first[:, 0], first[:, 1])
    if float(speed.min()) <= 1e-9 * float(np.ptp(points, axis=0).max()):
        return None
    bend = first[:, 0] * second[:, 1] - first[:, 1] * second[:, 0]
    return float((share * bend**2 / speed**5).sum())


def _derivatives(control: Floats, t: Floats) -> Callable[[int], Floats]:
    def at(order: int) -> Floats:
        row, factor = control, 1.0
        for k in range(order):
            factor *= 3 - k
            row = np.diff(row, axis=0)
        return np.asarray(factor * (basis.bernstein(3 - order, t) @ row))

    return at
