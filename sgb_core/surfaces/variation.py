"""Laws by which a shape parameter depends on the rotation angle."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from enum import StrEnum
from math import pi

import numpy as np
from numpy.typing import ArrayLike

from sgb_core.arrays import Floats
from sgb_core.curves import basis
from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import NO_EXTRA, PARAMETERS, ParameterName
from sgb_core.surfaces.transfinite import half_turn_parameter


class LawKind(StrEnum):
    """The shapes of f(θ) in value = from + (to − from)·f(θ); θ counts from the start angle."""

    PAPER = "paper"
    RAISED_COSINE = "raised-cosine"
    COSINE = "cosine"
    KEYFRAMES = "keyframes"


@dataclass(frozen=True, slots=True)
class Law:
    """One shape parameter of some segments as a function of the angle.

    ``segments`` is None for all of them. ``count`` is the n of the n-fold cosine and
    ``keyframes`` holds (degrees, f) pairs, f in [0, 1].
    """

    parameter: ParameterName
    kind: LawKind
    start: float
    end: float
    segments: tuple[int, ...] | None = None
    count: int = 1
    keyframes: tuple[tuple[float, float], ...] = ()
    extra: Mapping[str, object] = field(default_factory=lambda: NO_EXTRA, repr=False, hash=False)

    def fraction(self, theta: ArrayLike) -> Floats:
        """Return f(θ) in [0, 1], θ in radians from the start angle; period 2π."""
        theta = np.asarray(theta, dtype=np.float64)
        match self.kind:
            case LawKind.PAPER:
                return half_turn_parameter(pi - np.abs(np.mod(theta, 2.0 * pi) - pi))
            case LawKind.RAISED_COSINE:
                return np.asarray((1.0 - np.cos(theta)) / 2.0)
            case LawKind.COSINE:
                return np.asarray((1.0 - np.cos(self.count * theta)) / 2.0)
            case LawKind.KEYFRAMES:
                return _keyframe_curve(self.keyframes, theta)[0]

    def fraction_rate(self, theta: ArrayLike, side: ArrayLike = 1) -> Floats:
        """Return df/dθ per radian; ``side`` (+1 or −1) picks the one at the paper's creases."""
        theta = np.asarray(theta, dtype=np.float64)
        match self.kind:
            case LawKind.PAPER:
                # A step far below any sample distance decides which half turn is meant.
                turn = np.mod(theta + 1e-12 * np.asarray(side), 2.0 * pi)
                t = self.fraction(theta)
                return np.where(turn < pi, 0.5, -0.5) * (2.0 * t * t - 2.0 * t + 1.0)
            case LawKind.RAISED_COSINE:
                return np.asarray(np.sin(theta) / 2.0)
            case LawKind.COSINE:
                return np.asarray(self.count * np.sin(self.count * theta) / 2.0)
            case LawKind.KEYFRAMES:
                return _keyframe_curve(self.keyframes, theta)[1]

    @property
    def breaks(self) -> tuple[float, ...]:
        """The angles in [0, 2π) where f is not smooth: creases and keyframes, in radians."""
        if self.kind is LawKind.PAPER:
            return (0.0, pi)
        if self.kind is LawKind.KEYFRAMES:
            return tuple(_knots(self.keyframes)[0])
        return ()

    def applies_to(self, segment: int) -> bool:
        """Whether the law governs this segment."""
        return self.segments is None or segment in self.segments


def _knots(keyframes: Sequence[tuple[float, float]]) -> tuple[Floats, Floats]:
    """Return the keys' angles in [0, 2π), increasing, and their values."""
    turned = {degrees % 360.0: value for degrees, value in keyframes}
    order = sorted(turned)
    return np.deg2rad(order), np.array([turned[degrees] for degrees in order])


def _keyframe_curve(
    keyframes: Sequence[tuple[float, float]], theta: Floats
) -> tuple[Floats, Floats]:
    """Return the periodic interpolant of the keys and its rate.

    Piecewise cubic Hermite, C1, with the slopes of Fritsch and Butland (1984): zero at a key
    that is a local extreme, else the weighted harmonic mean of the two neighbouring secants.
    Such slopes satisfy Fritsch and Carlson's condition, so each piece is monotone and stays
    between its two keys.
    """
    angles, values = _knots(keyframes)
    if len(angles) == 1:
        return np.full(theta.shape, values[0]), np.zeros(theta.shape)
    steps = np.diff(angles, append=angles[0] + 2.0 * pi)
    secants = np.diff(values, append=values[0]) / steps
    slopes = _monotone_slopes(np.roll(steps, 1), steps, np.roll(secants, 1), secants)
    turn = np.mod(theta - angles[0], 2.0 * pi)
    piece = np.clip(np.searchsorted(angles - angles[0], turn, side="right") - 1, 0, None)
    after = (piece + 1) % len(angles)
    step = steps[piece]
    x = (turn - (angles[piece] - angles[0])) / step
    y0, y1, m0, m1 = values[piece], values[after], slopes[piece] * step, slopes[after] * step
    rise = y1 - y0
    cubic, square = m0 + m1 - 2.0 * rise, 3.0 * rise - 2.0 * m0 - m1
    curve = y0 + x * (m0 + x * (square + x * cubic))
    curve = np.clip(curve, np.minimum(y0, y1), np.maximum(y0, y1))
    return curve, (m0 + x * (2.0 * square + 3.0 * x * cubic)) / step


def _monotone_slopes(before: Floats, after: Floats, left: Floats, right: Floats) -> Floats:
    w1, w2 = 2.0 * after + before, after + 2.0 * before
    same = left * right > 0.0
    below = np.where(same, w1 * right + w2 * left, 1.0)
    return np.where(same, (w1 + w2) * (left * right) / below, 0.0)


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
    shapes = np.moveaxis(values, -1, 0)
    by_lambda, by_omega = basis.leg_fraction_rates(*shapes)
    p = profile.control_points if numbers is None else profile.control_points[list(numbers)]
    quartics = basis.quartic_points(p, basis.leg_fractions(*shapes))
    change = np.zeros_like(quartics)
    for leg, (near, far) in enumerate(basis.LEGS):
        rate = by_lambda[leg] * rates[..., leg] + by_omega[leg] * rates[..., 3]
        change[..., leg + 1, :] = rate[..., None] * (p[:, far] - p[:, near])
    return quartics, change
