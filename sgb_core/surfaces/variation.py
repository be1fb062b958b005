"""Sections of a surface whose shape parameters or radius depend on the rotation angle by laws."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike

from sgb_core.arrays import Floats
from sgb_core.curves import basis
from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import PARAMETERS
from sgb_core.surfaces.laws.law import RADIUS, Law

__all__ = [
    "Law",
    "departures",
    "law_value",
    "parameters",
    "radius_factors",
    "varying_quartics",
]


def parameters(
    profile: Profile,
    laws: Sequence[Law],
    theta: ArrayLike,
    side: ArrayLike = 1,
    numbers: Sequence[int] | None = None,
) -> tuple[Floats, Floats]:
    """Return the segments' parameters and their ∂/∂θ, each shape (*θ.shape, n, 4).

    The last axis is λ1, λ2, λ3, ω. θ is in radians from the start angle. Where two laws name
    the same parameter of a segment the later one counts; values stay between ``start`` and
    ``end`` to the last bit. ``numbers`` are the segments wanted, by default all.
    """
    theta = np.asarray(theta, dtype=np.float64)
    wanted = range(len(profile)) if numbers is None else numbers
    stored = profile.shape_values if numbers is None else profile.shape_values[list(numbers)]
    values = np.broadcast_to(stored, (*theta.shape, *stored.shape)).copy()
    rates = np.zeros_like(values)
    for law in laws:
        if law.parameter == RADIUS:
            continue
        k = PARAMETERS.index(law.parameter)
        value, rate = _value(law, theta, side)
        for place, number in enumerate(wanted):
            if law.applies_to(number):
                values[..., place, k] = value
                rates[..., place, k] = rate
    return values, rates


def _value(law: Law, theta: Floats, side: ArrayLike) -> tuple[Floats, Floats]:
    """Return a law's value and its rate."""
    rate = (law.end - law.start) * law.fraction_rate(theta, side)
    return law_value(law, theta), rate if law.steady is None else law.steady * rate


def law_value(law: Law, theta: Floats) -> Floats:
    """Return a law's value at angles, between its ends to the last bit, the shape of ``theta``.

    With its strength, where that is the same at every height.
    """
    value = law.start + (law.end - law.start) * law.fraction(theta)
    value = np.clip(value, min(law.start, law.end), max(law.start, law.end))
    strength = law.steady
    return value if strength is None or strength == 1.0 else 1.0 + strength * (value - 1.0)


def radius_factors(
    profile: Profile,
    laws: Sequence[Law],
    theta: ArrayLike,
    side: ArrayLike = 1,
    numbers: Sequence[int] | None = None,
) -> tuple[Floats, Floats]:
    """Return what the segments' radii are multiplied by and its ∂/∂θ, each (*θ.shape, n).

    The product of all laws of the radius that govern a segment, 1 where there is none; those
    whose strength changes along the height are left to :func:`departures`. Arguments as for
    :func:`parameters`.
    """
    theta = np.asarray(theta, dtype=np.float64)
    wanted = range(len(profile)) if numbers is None else numbers
    factors = np.ones((*theta.shape, len(wanted)))
    rates = np.zeros_like(factors)
    for law in laws:
        if law.parameter != RADIUS or law.steady is None:
            continue
        value, rate = _value(law, theta, side)
        for place, number in enumerate(wanted):
            if law.applies_to(number):
                rates[..., place] = rates[..., place] * value + factors[..., place] * rate
                factors[..., place] *= value
    return factors, rates


def departures(
    profile: Profile,
    laws: Sequence[Law],
    theta: ArrayLike,
    side: ArrayLike = 1,
    numbers: Sequence[int] | None = None,
) -> tuple[Floats, Floats]:
    """Return how far each of ``laws`` of the radius is from 1, and its ∂/∂θ, (*θ.shape, n, m).

    0 where a law does not govern a segment. Arguments as for :func:`parameters`.
    """
    theta = np.asarray(theta, dtype=np.float64)
    wanted = range(len(profile)) if numbers is None else numbers
    away = np.zeros((*theta.shape, len(wanted), len(laws)))
    rates = np.zeros_like(away)
    for k, law in enumerate(laws):
        value, rate = _value(law, theta, side)
        for place, number in enumerate(wanted):
            if law.applies_to(number):
                away[..., place, k], rates[..., place, k] = value - 1.0, rate
    return away, rates


def varying_quartics(
    profile: Profile,
    laws: Sequence[Law],
    theta: ArrayLike,
    side: ArrayLike = 1,
    numbers: Sequence[int] | None = None,
) -> tuple[Floats, Floats]:
    """Return the sections' quartic points and their ∂/∂θ, each shape (*θ.shape, n, 5, 2).

    Q1, Q2 and Q3 slide along their legs; laws of the radius stretch all five away from the axis,
    but for those whose strength changes along the height: see :class:`Sections`.
    ``numbers`` as for :func:`parameters`.
    """
    values, rates = parameters(profile, laws, theta, side, numbers)
    shapes = np.moveaxis(values, -1, 0)
    by_lambda, by_omega = basis.leg_fraction_rates(*shapes)
    p = profile.control_points if numbers is None else profile.control_points[list(numbers)]
    quartics = basis.quartic_points(p, basis.leg_fractions(*shapes))
    change = np.zeros_like(quartics)
    for leg, (near, far) in enumerate(basis.LEGS):
        rate = by_lambda[leg] * rates[..., leg] + by_omega[leg] * rates[..., 3]
        change[..., leg + 1, :] = rate[..., None] * (p[:, far] - p[:, near])
    if any(law.parameter == RADIUS for law in laws):
        factors, turned = radius_factors(profile, laws, theta, side, numbers)
        change[..., 0] = change[..., 0] * factors[..., None] + quartics[..., 0] * turned[..., None]
        quartics[..., 0] *= factors[..., None]
    return quartics, change
