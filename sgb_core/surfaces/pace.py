"""The speed of a generatrix, its cusps and standstills, and how it turns, exact near them too.

L' = (r', h') is read as the complex cubic q = r' + i h' = lead · ∏ (s − z). Then |L'| = |q| and
κ |L'| = Im(q'/q) = Σ Im z / |s − z|²: no difference of nearly equal numbers is left, so that a
curvature of 1e12 near a cusp keeps its digits. The zeros near the real axis also say where
quadrature needs short panels. One half of a segment at a time, counted from its own end, keeps
the zeros near that end exact.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from sgb_core.arrays import Floats
from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import Segment

Complex = NDArray[np.complex128]

# Gauss panels of 12 points reach rounding when nothing singular is nearer than this many widths.
_CLEAR = 0.75
_MOST_HALVINGS = 60
# A coefficient smaller than this part of the largest is rounding: the degree is lower.
_ROUNDING = 4e-16
_TINY = float(np.finfo(np.float64).tiny)
_POLISH = 4
# Zeros nearer to each other than this are left as they are found.
_ALONE = 1e-3


@dataclass(frozen=True, slots=True, eq=False)
class HalfSegment:
    """A segment from one of its ends to its middle, s in [0, ½] counted from that end.

    ``radii`` are the Bernstein coefficients of r, shape (5,), ``velocity`` the power coefficients
    of q, lowest first, ``zeros`` the zeros of q, and ``singular`` those of q and of r.
    """

    radii: Floats
    velocity: Complex
    zeros: Complex
    singular: Complex

    @classmethod
    def of(cls, segment: Segment, size: float) -> HalfSegment:
        """Return the half at the start of a segment, in units of ``size``."""
        a, _, c = segment.shape.leg_fractions
        points, quartic = segment.points, segment.quartic
        # The end steps are the legs' parts themselves: differences would lose their digits.
        steps = np.array(
            [
                a * (points[1] - points[0]),
                quartic[2] - quartic[1],
                quartic[3] - quartic[2],
                c * (points[3] - points[2]),
            ]
        )
        # Divided as real numbers: a complex quotient overflows for the smallest of sizes.
        velocity = (steps / size) @ np.array([1.0, 1j])
        power = np.array([4.0, 12.0, 12.0, 4.0]) * [
            np.diff(velocity, order)[0] for order in range(4)
        ]
        radii, zeros = quartic[:, 0] / size, _zeros(power)
        return cls(radii, power, zeros, np.concatenate([zeros, _zeros(_power(radii))]))

    def radius(self, s: Floats) -> Floats:
        """Return r at ``s``, by Horner's scheme in Bernstein form."""
        t, row = 1.0 - s, [np.full(s.shape, value) for value in self.radii]
        for level in range(4, 0, -1):
            row = [t * row[k] + s * row[k + 1] for k in range(level)]
        return row[0]

    def speed(self, s: Floats) -> Floats:
        """Return |L'|."""
        lead = self.velocity[len(self.zeros)]
        return np.asarray(abs(lead) * np.abs(s[:, None] - self.zeros).prod(axis=1))

    def derivative(self, s: Floats, order: int) -> Complex:
        """Return a derivative of r + i h of order 1 to 4."""
        power: Complex = np.asarray(np.polynomial.polynomial.polyder(self.velocity, order - 1))
        return _value(power, s.astype(np.complex128))

    def climb(self, s: Floats) -> Floats:
        """Return h'."""
        return np.asarray(np.polynomial.polynomial.polyval(s, self.velocity.imag))

    def turning(self, s: Floats) -> Floats:
        """Return κ |L'|, the angle by which the tangent turns per unit of s."""
        away = s[:, None] - self.zeros
        distance = (away * away.conj()).real
        on_it = distance == 0.0
        return np.asarray(
            np.where(on_it, 0.0, self.zeros.imag / np.where(on_it, 1.0, distance)).sum(axis=1)
        )

    def edges(self, breaks: Floats) -> Floats:
        """Return the edges of panels over [0, ½] that halve towards everything singular.

        That are the zeros of q and of r, real or not; ``breaks`` are further edges.
        """
        near = self.singular
        inside = breaks[(breaks > 0.0) & (breaks < 0.5)]
        low = np.unique(np.concatenate([[0.0], inside]))
        high = np.append(low[1:], 0.5)
        done = [np.array([0.5])]
        for _ in range(_MOST_HALVINGS):
            beside = np.clip(near.real, low[:, None], high[:, None])
            gap = np.abs(near - beside).min(axis=1, initial=np.inf)
            close = gap < _CLEAR * (high - low)
            done.append(low[~close])
            middle = (low[close] + high[close]) / 2.0
            low, high = np.concatenate([low[close], middle]), np.concatenate([middle, high[close]])
            if not len(low):
                break
        return np.unique(np.concatenate([*done, low]))


@lru_cache(maxsize=4)
def halves(profile: Profile, size: float) -> tuple[tuple[HalfSegment, HalfSegment], ...]:
    """Return both halves of each segment, the second one run backwards, in units of ``size``.

    Kept for the next measure of the same profile: finding the zeros takes most of the time.
    """
    return tuple(
        (HalfSegment.of(segment, size), HalfSegment.of(segment.reversed(), size))
        for segment in profile.segments
    )


def _power(bernstein: Floats) -> Complex:
    """Return the power coefficients of a quartic in Bernstein form, lowest first."""
    row, factors, power = bernstein, (1.0, 4.0, 6.0, 4.0, 1.0), []
    for factor in factors:
        power.append(factor * row[0])
        row = np.diff(row)
    return np.array(power, dtype=np.complex128)


def _value(power: Complex, z: Complex) -> Complex:
    """Return a polynomial's value by Horner's scheme."""
    value = np.full(z.shape, power[-1])
    for coefficient in power[-2::-1]:
        value = value * z + coefficient
    return value


def _zeros(power: Complex) -> Complex:
    """Return the zeros of a polynomial, those that stand alone polished by Newton's method.

    Of several that are close together each one is known badly and their product well: as they
    come from the companion matrix their errors undo each other.
    """
    scale = float(np.abs(power).max())
    degree = len(power) - 1
    while degree > 0 and abs(power[degree]) <= _ROUNDING * scale:
        degree -= 1
    # Below the smallest normal number a part is a point: its digits are gone, quotients overflow.
    if scale < _TINY or degree == 0:
        return np.zeros(0, dtype=np.complex128)
    kept = power[: degree + 1] / scale
    found = np.asarray(np.roots(kept[::-1]), dtype=np.complex128)
    gaps = np.abs(found[:, None] - found) + np.diag(np.full(degree, np.inf))
    alone = gaps.min(axis=1) > _ALONE * np.maximum(1.0, np.abs(found))
    rates = np.arange(1, degree + 1) * kept[1:]
    for _ in range(_POLISH):
        z = found[alone]
        found[alone] = z - _value(kept, z) / _value(rates, z)
    return found
