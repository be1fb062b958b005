"""The speed of a generatrix, its cusps and standstills, and how it turns, exact near them too.

L' = (r', h') is read as the complex cubic q = r' + i h' = lead · ∏ (s − z). Then |L'| = |q| and
κ |L'| = Im(q'/q) = Σ Im z / |s − z|²: no difference of nearly equal numbers is left, so that a
curvature of 1e12 near a cusp keeps its digits. The zeros near the real axis also say where
quadrature needs short panels. Each half of a segment, counted from its own end, keeps the zeros
near that end exact. All halves are worked on at once: a profile may have thousands.
"""

from __future__ import annotations

from functools import lru_cache
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

from sgb_core.arrays import Floats, Ints
from sgb_core.curves import basis
from sgb_core.curves.profile import Profile
from sgb_core.surfaces.quadrature import Panels
from sgb_core.values import dataclass

Complex = NDArray[np.complex128]
_Values = TypeVar("_Values", Floats, Complex)

# Gauss panels of 12 points reach rounding when nothing singular is nearer than this many widths.
_CLEAR = 0.75
_MOST_HALVINGS = 60
# A coefficient smaller than this part of the largest is rounding: the degree is lower.
_ROUNDING = 4e-16
_TINY = float(np.finfo(np.float64).tiny)
_POLISH = 4
# A step smaller than this part of the size is none: the square of the curvature beside it, which
# has no weight, would be beyond all numbers.
_NO_STEP = 1e-75
# Zeros nearer to each other than this are left as they are found.
_ALONE = 1e-3


@dataclass(frozen=True, slots=True, eq=False)
class Halves:
    """The 2n halves of n segments, each from an end to the middle, s in [0, ½] from that end.

    Half 2k starts where segment k does, half 2k + 1 where it ends. ``radii`` are the Bernstein
    coefficients of r, shape (2n, 5), ``velocity`` the power coefficients of q, lowest first,
    (2n, 4), ``lead`` the highest that counts, (2n,), ``zeros`` those of q, (2n, 3), and
    ``singular`` those of q and of r, (2n, 7). Where the degree is lower, zeros are infinite.

    Functions take places ``s`` and the numbers ``k`` of their halves, each of shape (m,).
    """

    radii: Floats
    velocity: Complex
    lead: Complex
    zeros: Complex
    singular: Complex

    @classmethod
    def of(cls, profile: Profile, size: float) -> Halves:
        """Return both halves of each segment, in units of ``size``."""
        points, quartics = _both_ways(profile)
        # The end steps are the legs' parts themselves: differences would lose their digits.
        fractions = _end_fractions(profile)
        steps = np.stack(
            [
                fractions[:, :1] * (points[:, 1] - points[:, 0]),
                quartics[:, 2] - quartics[:, 1],
                quartics[:, 3] - quartics[:, 2],
                fractions[:, 1:] * (points[:, 3] - points[:, 2]),
            ],
            axis=1,
        )
        # Divided as real numbers: a complex quotient overflows for the smallest of sizes.
        steps = steps / size
        velocity = np.where(np.abs(steps) < _NO_STEP, 0.0, steps) @ np.array([1.0, 1j])
        power = np.stack(
            [
                factor * np.diff(velocity, order, axis=1)[:, 0]
                for order, factor in enumerate((4.0, 12.0, 12.0, 4.0))
            ],
            axis=1,
        )
        radii = quartics[:, :, 0] / size
        zeros, lead = _zeros(power)
        return cls(radii, power, lead, zeros, np.hstack([zeros, _zeros(_power(radii))[0]]))

    def __len__(self) -> int:
        return len(self.radii)

    def radius(self, s: Floats, k: Ints) -> Floats:
        """Return r, by Horner's scheme in Bernstein form."""
        t, row = 1.0 - s, list(self.radii[k].T)
        for level in range(4, 0, -1):
            row = [t * row[j] + s * row[j + 1] for j in range(level)]
        return np.asarray(row[0])

    def speed(self, s: Floats, k: Ints) -> Floats:
        """Return |L'|."""
        away = np.abs(s[:, None] - self.zeros[k])
        return np.asarray(np.abs(self.lead)[k] * np.where(np.isinf(away), 1.0, away).prod(axis=1))

    def derivative(self, s: Floats, k: Ints, order: int) -> Complex:
        """Return a derivative of r + i h of order 1 to 4."""
        power = self.velocity
        for _ in range(order - 1):
            power = power[:, 1:] * np.arange(1, power.shape[1])
        return _value(power[k], s)

    def climb(self, s: Floats, k: Ints) -> Floats:
        """Return h'."""
        return _value(self.velocity.imag[k], s)

    def turning(self, s: Floats, k: Ints) -> Floats:
        """Return κ |L'|, the angle by which the tangent turns per unit of s."""
        zeros = self.zeros[k]
        distance = (s[:, None] - zeros.real) ** 2 + zeros.imag**2
        on_it = distance == 0.0
        return np.asarray(
            np.where(on_it, 0.0, zeros.imag / np.where(on_it, 1.0, distance)).sum(axis=1)
        )

    def panels(self, breaks: Floats | None = None, of: Ints | None = None) -> Panels:
        """Return panels over [0, ½] of each half that halve towards everything singular.

        That are the zeros of q and of r, real or not. At ``breaks`` in the halves ``of``, each of
        shape (m,), panels end too.
        """
        low, which = np.zeros(len(self)), np.arange(len(self))
        if breaks is not None and of is not None:
            inside = (breaks > 0.0) & (breaks < 0.5)
            edges = np.stack([np.append(which, of[inside]), np.append(low, breaks[inside])])
            # Asked for its indices, numpy need not load its masked arrays.
            (which, low), _ = np.unique(edges, axis=1, return_index=True)
            which = which.astype(np.int64)
        last = np.append(which[1:] != which[:-1], True)
        high = np.where(last, 0.5, np.append(low[1:], 0.5))
        done: list[Panels] = []
        for _ in range(_MOST_HALVINGS):
            near = self.singular[which]
            # Zeros of a lower degree are infinitely far away.
            beside = np.clip(near.real, low[:, None], high[:, None])
            gap = np.hypot(near.real - beside, near.imag).min(axis=1)
            close = gap < _CLEAR * (high - low)
            done.append((low[~close], high[~close], which[~close]))
            low, high, which = low[close], high[close], which[close]
            if not len(low):
                break
            middle = (low + high) / 2.0
            low, high = np.concatenate([low, middle]), np.concatenate([middle, high])
            which = np.tile(which, 2)
        done.append((low, high, which))
        low, high, which = (np.concatenate(parts) for parts in zip(*done, strict=True))
        order = np.lexsort((low, which))
        # Halving neighbouring numbers leaves panels without width.
        order = order[(low < high)[order]]
        return low[order], high[order], which[order]


@lru_cache(maxsize=4)
def halves(profile: Profile, size: float) -> Halves:
    """Return both halves of each segment of a profile, in units of ``size``.

    Kept for the next measure of the same profile: finding the zeros takes most of the time.
    """
    return Halves.of(profile, size)


def _both_ways(profile: Profile) -> tuple[Floats, Floats]:
    """Return points (2n, 4, 2) and quartics (2n, 5, 2) of each segment run forth and back."""
    points = profile.control_points
    back = points[:, ::-1]
    l1, l2, l3, omega = _parameters(profile)
    turned = basis.quartic_points(back, basis.leg_fractions(l3, 6.0 - l2, l1, omega))
    return (
        np.stack([points, back], axis=1).reshape(-1, 4, 2),
        np.stack([profile.quartics, turned], axis=1).reshape(-1, 5, 2),
    )


def _end_fractions(profile: Profile) -> Floats:
    """Return the fractions of the first and the last leg of each half, shape (2n, 2)."""
    a, _, c = basis.leg_fractions(*_parameters(profile))
    return np.stack([a, c, c, a], axis=1).reshape(-1, 2)


def _parameters(profile: Profile) -> tuple[Floats, Floats, Floats, Floats]:
    """Return λ1, λ2, λ3 and ω of each segment, each of shape (n,)."""
    shapes = [segment.shape for segment in profile.segments]
    return (
        np.array([shape.lambda1 for shape in shapes]),
        np.array([shape.lambda2 for shape in shapes]),
        np.array([shape.lambda3 for shape in shapes]),
        np.array([shape.omega for shape in shapes]),
    )


def _power(bernstein: Floats) -> Complex:
    """Return the power coefficients of quartics in Bernstein form, lowest first, (m, 5)."""
    row, factors, power = bernstein, (1.0, 4.0, 6.0, 4.0, 1.0), []
    for factor in factors:
        power.append(factor * row[:, 0])
        row = np.diff(row, axis=1)
    return np.stack(power, axis=1).astype(np.complex128)


def _value(power: _Values, z: Floats | Complex) -> _Values:
    """Return polynomials of coefficients (m, degree + 1) at ``z``, (m, ...), by Horner's scheme."""
    shape = (len(z),) + (1,) * (z.ndim - 1)
    value = np.broadcast_to(power[:, -1].reshape(shape), z.shape)
    for coefficient in power.T[-2::-1]:
        value = value * z + coefficient.reshape(shape)
    return value


def _zeros(power: Complex) -> tuple[Complex, Complex]:
    """Return the zeros of polynomials (m, d + 1), shape (m, d), and the leads that count, (m,).

    Those that stand alone are polished by Newton's method. Of several that are close together each
    one is known badly and their product well: as they come from the companion matrix their errors
    undo each other. Where the degree is lower than d, further zeros are infinite.
    """
    many, most = power.shape[0], power.shape[1] - 1
    scale = np.abs(power).max(axis=1)
    counts = np.abs(power) > _ROUNDING * scale[:, None]
    degree = np.where(counts.any(axis=1), most - np.argmax(counts[:, ::-1], axis=1), 0)
    # Below the smallest normal number a part is a point: its digits are gone, quotients overflow.
    degree = np.where(scale < _TINY, 0, degree)
    lead = power[np.arange(many), degree]
    # Zeros at 0 are split off; they are exact.
    whole = power != 0.0
    at_zero = np.where(whole.any(axis=1), np.argmax(whole, axis=1), 0)
    zeros = np.full((many, most), np.inf, dtype=np.complex128)
    for degrees, split in {*zip(degree.tolist(), at_zero.tolist(), strict=True)}:
        ours = (degree == degrees) & (at_zero == split)
        if degrees:
            kept = power[ours, : degrees + 1] / scale[ours, None]
            zeros[ours, :degrees] = _polished(kept, _roots(kept, split))
    return zeros, lead


def _roots(power: Complex, split: int) -> Complex:
    """Return the zeros of polynomials (m, d + 1) with ``split`` zeros at 0, shape (m, d)."""
    many, degree = power.shape[0], power.shape[1] - 1 - split
    zeros = np.zeros((many, degree + split), dtype=np.complex128)
    companion = np.zeros((many, degree, degree), dtype=np.complex128)
    companion[:, np.arange(1, degree), np.arange(degree - 1)] = 1.0
    if degree:
        companion[:, 0] = -power[:, -2 : split - 1 if split else None : -1] / power[:, -1:]
        zeros[:, :degree] = np.linalg.eigvals(companion)
    return zeros


def _polished(power: Complex, zeros: Complex) -> Complex:
    degree = zeros.shape[1]
    gaps = np.abs(zeros[:, :, None] - zeros[:, None, :]) + np.diag(np.full(degree, np.inf))
    alone = gaps.min(axis=2) > _ALONE * np.maximum(1.0, np.abs(zeros))
    rates = np.arange(1, degree + 1) * power[:, 1:]
    for _ in range(_POLISH):
        slope = np.where(alone, _value(rates, zeros), 1.0)
        zeros = np.where(alone, zeros - _value(power, zeros) / slope, zeros)
    return zeros
