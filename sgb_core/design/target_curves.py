"""Curves that a profile can be fitted to: arcs of ellipses and superellipses."""

from __future__ import annotations

from dataclasses import field
from typing import Protocol

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.fields.kinds import COORDINATE, POSITIVE_LENGTH, Range
from sgb_core.fields.lists import OrNone
from sgb_core.fields.record import Record, check, says
from sgb_core.values import dataclass

# Newton steps to the foot of a perpendicular: from a start this dense they reach rounding.
_NEWTON_STEPS = 8
_DENSE_ELLIPSE = 91
# A superellipse may bend sharply, and its parameter runs unevenly.
_DENSE = 721
_NARROWING_STEPS = 26


class TargetCurve(Protocol):
    """A curve in the profile half-plane, from one end to the other."""

    @property
    def ends(self) -> Floats:
        """The first and the last point, shape (2, 2)."""
        ...

    @property
    def size(self) -> float:
        """A length to measure deviations against: for a circle its radius."""
        ...

    def points(self, count: int) -> Floats:
        """Return ``count`` points along the curve, shape (count, 2)."""
        ...

    @property
    def closed(self) -> bool:
        """Whether the curve runs back into its start."""
        ...

    @property
    def middle(self) -> float:
        """The height about which the curve is its own mirror image."""
        ...

    def signed_distance(self, points: Floats) -> Floats:
        """Return each point's distance along the curve's normal, positive on its right side.

        Seen in the direction of travel; for an arc that runs upwards that is outside.
        """
        ...

    def distance_and_normal(self, points: Floats) -> tuple[Floats, Floats]:
        """Return :meth:`signed_distance` and its gradient, a unit vector, at each point."""
        ...


@dataclass(frozen=True, slots=True)
class SuperellipseArc:
    """|r/b|ⁿ + |(h − centre)/a|ⁿ = 1 for r ≥ 0, from the lower pole to the upper one.

    With ``radius``, the distance of the centre from the axis, it is the whole closed curve
    |(r − radius)/b|ⁿ + |(h − centre)/a|ⁿ = 1, a torus's section, run through anticlockwise.
    ``b`` is the half width, ``a`` the half height and ``exponent`` n (2: an ellipse; with
    a = b a circle). Raises RefusalError, a ValueError, unless a, b > 0 and 1 ≤ n ≤ 20.
    """

    RECORD = Record("target")

    b: float = field(metadata=says(POSITIVE_LENGTH, key="half_width", label="Half width b"))
    a: float = field(metadata=says(POSITIVE_LENGTH, key="half_height", label="Half height a"))
    centre: float = field(
        default=0.0, metadata=says(COORDINATE, label="Centre", tip="Height of the centre")
    )
    exponent: float = field(default=2.0, metadata=says(Range(1.0, 20.0), label="Exponent"))
    radius: float | None = field(
        default=None, metadata=says(OrNone(COORDINATE), label="Distance from the axis")
    )

    def __post_init__(self) -> None:
        check(self)

    @property
    def ends(self) -> Floats:
        """The two poles; of a closed curve twice its outermost point."""
        if self.radius is not None:
            return np.array([[self.radius + self.b, self.centre]] * 2)
        return np.array([[0.0, self.centre - self.a], [0.0, self.centre + self.a]])

    @property
    def size(self) -> float:
        """The larger half axis."""
        return max(self.a, self.b)

    @property
    def closed(self) -> bool:
        """Whether it is the whole closed curve."""
        return self.radius is not None

    @property
    def middle(self) -> float:
        """The height of the centre."""
        return self.centre

    def points(self, count: int) -> Floats:
        """Return points at equal steps of the angle parameter, shape (count, 2)."""
        if self.closed:
            return self._at(np.linspace(0.0, 2.0 * np.pi, count))
        return self._at(np.linspace(-np.pi / 2, np.pi / 2, count))

    def signed_distance(self, points: Floats) -> Floats:
        """Return distances along the normal, positive outside, shape of ``points`` less the last.

        A circle's are radial and exact. Otherwise the foot is found by Newton steps from the
        nearest of densely laid points; points with r < 0 are measured at |r|.
        """
        return self.distance_and_normal(points)[0]

    def distance_and_normal(self, points: Floats) -> tuple[Floats, Floats]:
        """Return the distances, and the outward unit normals at the feet, shape of ``points``."""
        # An arc on the axis measures points beyond it at |r|, by the symmetry of its quarters.
        offset = points - np.array([self.radius or 0.0, self.centre])
        if self.exponent == 2.0 and self.a == self.b:
            normal = offset
            distance = np.hypot(offset[..., 0], offset[..., 1]) - self.a
        else:
            near = np.abs(offset).reshape(-1, 2)
            foot = self._quarter(self._nearest(near[:, 0], near[:, 1]))
            apart = np.hypot(*(foot - near).T)
            outside = ((near / (self.b, self.a)) ** self.exponent).sum(axis=1) > 1.0
            distance = np.where(outside, apart, -apart).reshape(offset.shape[:-1])
            steep = (foot / (self.b, self.a)) ** (self.exponent - 1.0) / (self.b, self.a)
            normal = steep.reshape(offset.shape) * np.sign(offset)
        length = np.hypot(normal[..., 0], normal[..., 1])[..., None]
        return distance, np.asarray(normal / np.where(length > 0.0, length, 1.0))

    def _nearest(self, p: Floats, q: Floats) -> Floats:
        """Return the parameters φ of the feet of points in the quarter p, q ≥ 0."""
        # By symmetry one quarter serves all; φ in [0, π/2].
        angles = np.linspace(0.0, np.pi / 2, self._density)
        dense = self._quarter(angles)
        # Imported late: only fitting needs it, and it takes a while to load.
        from scipy.spatial import cKDTree

        near = cKDTree(dense).query(np.stack([p, q], axis=-1))[1]
        return self._foot(angles[near], p, q)

    @property
    def _density(self) -> int:
        return _DENSE_ELLIPSE if self.exponent == 2.0 else _DENSE

    def _foot(self, phi: Floats, p: Floats, q: Floats) -> Floats:
        """Refine the parameter of the nearest of the dense points, within its neighbours."""
        step = np.pi / 2 / (self._density - 1)
        low, high = np.clip(phi - step, 0, np.pi / 2), np.clip(phi + step, 0, np.pi / 2)
        if self.exponent != 2.0:
            return self._narrow(low, high, p, q)
        a, b = self.a, self.b
        for _ in range(_NEWTON_STEPS):
            c, s = np.cos(phi), np.sin(phi)
            slope = (b * c - p) * (-b * s) + (a * s - q) * (a * c)
            bend = b * b * s * s - (b * c - p) * b * c + a * a * c * c - (a * s - q) * a * s
            phi = np.clip(phi - slope / np.where(bend > 0.0, bend, np.inf), low, high)
        return phi

    def _narrow(self, low: Floats, high: Floats, p: Floats, q: Floats) -> Floats:
        """Bisection: the distance has one minimum between neighbouring dense points."""
        for _ in range(_NARROWING_STEPS):
            middle = (low + high) / 2.0
            x, y = self._quarter(middle).T
            # The slope of the squared distance, by a positive factor.
            falls = (y - q) * y * np.cos(middle) ** 2 < (x - p) * x * np.sin(middle) ** 2
            low, high = np.where(falls, middle, low), np.where(falls, high, middle)
        return (low + high) / 2.0

    def _quarter(self, phi: Floats) -> Floats:
        power = 2.0 / self.exponent
        # cos(π/2) is not quite 0 in floating point, and a small power would make it large.
        cosine = np.where(phi >= np.pi / 2, 0.0, np.cos(phi))
        return np.stack([self.b * cosine**power, self.a * np.sin(phi) ** power], axis=-1)

    def _at(self, phi: Floats) -> Floats:
        # The angle in its quarter; the arc's own lies in the two right ones.
        inner = np.abs(np.arctan2(np.sin(phi), np.abs(np.cos(phi))))
        quarter = self._quarter(inner)
        side = np.where(np.cos(phi) < 0.0, -1.0, 1.0)
        r = (self.radius or 0.0) + side * quarter[:, 0]
        return np.stack([r, self.centre + np.sign(np.sin(phi)) * quarter[:, 1]], axis=-1)
