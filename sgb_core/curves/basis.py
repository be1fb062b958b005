"""Basis functions of one SG-Bézier segment and its exact quartic Bézier form.

The paper is "Shape-Adjustable Generalized Bézier Rotation Surfaces with Multiple Shape
Parameters"; numbers in parentheses are its equations.
"""

from __future__ import annotations

from functools import lru_cache
from math import comb
from typing import TypeVar

import numpy as np
from numpy.typing import ArrayLike

from sgb_core.arrays import Floats

LAMBDA1_RANGE = (0.0, 4.0)
LAMBDA2_RANGE = (0.0, 6.0)
LAMBDA3_RANGE = (0.0, 4.0)
OMEGA_RANGE = (0.0, 1.0)

Number = TypeVar("Number", float, Floats)


def leg_fractions(
    lambda1: Number, lambda2: Number, lambda3: Number, omega: Number
) -> tuple[Number, Number, Number]:
    """Return (a, b, c): how far along its leg each inner quartic point lies.

    a = (3 + ω(1−λ1))/4 places Q1 on P0P1, b = (3 + ω(λ2−3))/6 places Q2 on P2P1 and
    c = (3 + ω(1−λ3))/4 places Q3 on P3P2; each lies in [0, 1] on the whole parameter range.
    """
    return (
        (3.0 + omega * (1.0 - lambda1)) / 4.0,
        (3.0 + omega * (lambda2 - 3.0)) / 6.0,
        (3.0 + omega * (1.0 - lambda3)) / 4.0,
    )


def quartic_points(points: ArrayLike, fractions: tuple[ArrayLike, ArrayLike, ArrayLike]) -> Floats:
    """Return the quartic Bézier points Q0..Q4 of a segment, exactly the same curve.

    ``points`` has shape (..., 4, 2); each leg fraction broadcasts against its leading axes.
    The result has shape (..., 5, 2).
    """
    p = np.asarray(points, dtype=np.float64)
    a, b, c = (np.asarray(f, dtype=np.float64)[..., None] for f in fractions)
    p0, p1, p2, p3 = (p[..., k, :] for k in range(4))
    # Written from the near end, so that fraction 0 gives that end to the last bit.
    inner = (p0 + a * (p1 - p0), p2 + b * (p1 - p2), p3 + c * (p2 - p3))
    shape = np.broadcast_shapes(p0.shape, *(q.shape for q in inner))
    return np.stack([np.broadcast_to(q, shape) for q in (p0, *inner, p3)], axis=-2)


@lru_cache(maxsize=64)
def _binomials(degree: int) -> tuple[int, ...]:
    return tuple(comb(degree, k) for k in range(degree + 1))


def bernstein(degree: int, s: ArrayLike) -> Floats:
    """Return the Bernstein polynomials of ``degree`` at ``s``, shape (*s.shape, degree + 1)."""
    t = np.asarray(s, dtype=np.float64)[..., None]
    k = np.arange(degree + 1)
    return np.asarray(_binomials(degree)) * t**k * (1.0 - t) ** (degree - k)


def sg_basis(lambda1: float, lambda2: float, lambda3: float, omega: float, s: ArrayLike) -> Floats:
    """Return the basis functions l0..l3 of (13) at ``s``, shape (*s.shape, 4).

    They sum to 1 and are non-negative on the whole parameter range.
    """
    s = np.asarray(s, dtype=np.float64)
    r = 1.0 - s
    l1, l2, l3, w = lambda1, lambda2, lambda3, omega
    return np.stack(
        [
            (1.0 + (l1 - 1.0) * w * s) * r**3,
            (3.0 + w * (1.0 - l1) + w * (l1 + l2 - 4.0) * s) * s * r**2,
            (3.0 + (3.0 - l2) * w - w * (l3 - l2 + 2.0) * s) * s**2 * r,
            (1.0 + (l3 - 1.0) * w * r) * s**3,
        ],
        axis=-1,
    )


def power_matrix(lambda1: float, lambda2: float, lambda3: float, omega: float) -> Floats:
    """Return the 5×4 matrix M of (1): the basis is (1, s, s², s³, s⁴) M."""
    l1, l2, l3, w = lambda1, lambda2, lambda3, omega
    return np.array(
        [
            [1.0, 0.0, 0.0, 0.0],
            [w * (l1 - 1.0) - 3.0, 3.0 + w * (1.0 - l1), 0.0, 0.0],
            [
                3.0 - 3.0 * w * (l1 - 1.0),
                w * (3.0 * l1 + l2 - 6.0) - 6.0,
                3.0 + w * (3.0 - l2),
                0.0,
            ],
            [
                3.0 * w * (l1 - 1.0) - 1.0,
                3.0 - w * (3.0 * l1 + 2.0 * l2 - 9.0),
                w * (2.0 * l2 - l3 - 5.0) - 3.0,
                1.0 + w * (l3 - 1.0),
            ],
            [-w * (l1 - 1.0), w * (l1 + l2 - 4.0), w * (l3 - l2 + 2.0), -w * (l3 - 1.0)],
        ]
    )
