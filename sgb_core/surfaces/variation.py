"""Sections of a surface whose shape parameters depend on the rotation angle by laws."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike

from sgb_core.arrays import Floats
from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import ParameterName
from sgb_core.surfaces.laws.law import Law

__all__ = ["PARAMETERS", "Law", "parameters", "varying_quartics"]

PARAMETERS: tuple[ParameterName, ...] = ("lambda1", "lambda2", "lambda3", "omega")


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
    shapes = [profile.segments[number].shape for number in wanted]
    stored = np.array(
        [[getattr(shape, name) for name in PARAMETERS] for shape in shapes], np.float64
    )
    values = np.broadcast_to(stored, (*theta.shape, *stored.shape)).copy()
    rates = np.zeros_like(values)
    for law in laws:
        k = PARAMETERS.index(law.parameter)
        span = law.end - law.start
        value = law.start + span * law.fraction(theta)
        value = np.clip(value, min(law.start, law.end), max(law.start, law.end))
        rate = span * law.fraction_rate(theta, side)
        for place, number in enumerate(wanted):
            if law.applies_to(number):
                values[..., place, k] = value
                rates[..., place, k] = rate
    return values, rates


def varying_quartics(
    profile: Profile,
    laws: Sequence[Law],
    theta: ArrayLike,
    side: ArrayLike = 1,
    numbers: Sequence[int] | None = None,
) -> tuple[Floats, Floats]:
    """Return the sections' quartic points and their ∂/∂θ, each shape (*θ.shape, n, 5, 2).

    Only Q1, Q2 and Q3 depend on θ: they slide along their legs. ``numbers`` as for
    :func:`parameters`.
    """
    values, rates = parameters(profile, laws, theta, side, numbers)
    l1, l2, l3, w = np.moveaxis(values, -1, 0)
    d1, d2, d3, dw = np.moveaxis(rates, -1, 0)
    p = profile.control_points if numbers is None else profile.control_points[list(numbers)]
    quartics = np.empty((*l1.shape, 5, 2))
    change = np.zeros_like(quartics)
    quartics[..., 0, :], quartics[..., 4, :] = p[:, 0], p[:, 3]
    legs = (
        ((3.0 + w * (1.0 - l1)) / 4.0, (dw * (1.0 - l1) - w * d1) / 4.0, 0, 1),
        ((3.0 + w * (l2 - 3.0)) / 6.0, (dw * (l2 - 3.0) + w * d2) / 6.0, 2, 1),
        ((3.0 + w * (1.0 - l3)) / 4.0, (dw * (1.0 - l3) - w * d3) / 4.0, 3, 2),
    )
    for k, (fraction, rate, near, far) in enumerate(legs, start=1):
        leg = p[:, far] - p[:, near]
        quartics[..., k, :] = p[:, near] + fraction[..., None] * leg
        change[..., k, :] = rate[..., None] * leg
    return quartics, change
