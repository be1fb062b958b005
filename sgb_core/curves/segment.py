"""One SG-Bézier segment: four control points and the parameters that reshape it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field, replace
from math import isfinite
from types import MappingProxyType
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike

from sgb_core.arrays import Floats, frozen
from sgb_core.curves import basis
from sgb_core.fields.extra import NO_EXTRA, take_extra
from sgb_core.fields.kinds import COORDINATE, MAX_COORDINATE, Flag, Range
from sgb_core.fields.lists import Fixed, Several
from sgb_core.fields.record import Part, Record, check, says
from sgb_core.values import dataclass

ParameterName = Literal["lambda1", "lambda2", "lambda3", "omega"]

PARAMETER_RANGES: Mapping[ParameterName, tuple[float, float]] = MappingProxyType(
    {
        "lambda1": basis.LAMBDA1_RANGE,
        "lambda2": basis.LAMBDA2_RANGE,
        "lambda3": basis.LAMBDA3_RANGE,
        "omega": basis.OMEGA_RANGE,
    }
)
PARAMETERS: tuple[ParameterName, ...] = tuple(PARAMETER_RANGES)
# Of the legs 0, 1 and 2: the parameter that alone, besides ω, decides its fraction.
LAMBDAS = PARAMETERS[:3]
# What people read for a parameter.
SYMBOLS: Mapping[ParameterName, str] = MappingProxyType(
    {"lambda1": "λ1", "lambda2": "λ2", "lambda3": "λ3", "omega": "ω"}
)


_RANGES = {name: Range(*limits) for name, limits in PARAMETER_RANGES.items()}
_VALUES = {
    name: replace(allowed, said=f"a value of {name} from {allowed.low:g} to {allowed.high:g}")
    for name, allowed in _RANGES.items()
}


def parameter_range(name: ParameterName) -> Range:
    """Return what a shape parameter may be."""
    return _RANGES[name]


def parameter_value(name: ParameterName) -> Range:
    """Return the same for a field that is not called as the parameter is: it says which."""
    return _VALUES[name]


# An end is degenerate when leg fraction × leg length is below this part of the size.
DEGENERATE_LEG = 1e-12


@dataclass(frozen=True, slots=True)
class ShapeParameters:
    """λ1, λ3 in [0, 4], λ2 in [0, 6] and ω in [0, 1] of one segment.

    The default is neutral: the plain cubic Bézier curve. Raises RefusalError, a ValueError,
    outside the ranges.

    >>> sgb.ShapeParameters(lambda2=4.5, omega=1.0).leg_fractions
    (0.75, 0.75, 0.75)
    """

    RECORD = Record("")

    lambda1: float = field(default=1.0, metadata=says(_RANGES["lambda1"], label=SYMBOLS["lambda1"]))
    lambda2: float = field(default=3.0, metadata=says(_RANGES["lambda2"], label=SYMBOLS["lambda2"]))
    lambda3: float = field(default=1.0, metadata=says(_RANGES["lambda3"], label=SYMBOLS["lambda3"]))
    omega: float = field(default=0.0, metadata=says(_RANGES["omega"], label=SYMBOLS["omega"]))

    def __post_init__(self) -> None:
        check(self)

    @property
    def leg_fractions(self) -> tuple[float, float, float]:
        """(a, b, c): how far along its leg each inner quartic point lies."""
        return basis.leg_fractions(self.lambda1, self.lambda2, self.lambda3, self.omega)

    @property
    def is_neutral(self) -> bool:
        """Whether all λ are neutral, so that ω leaves the cubic curve alone."""
        return all(getattr(self, name) == getattr(NEUTRAL, name) for name in LAMBDAS)

    @classmethod
    def from_leg_fractions(cls, a: float, b: float, c: float) -> ShapeParameters:
        """Return the parameters at ω = 1 with these leg fractions, each in [0, 1]."""
        lambda1, lambda2, lambda3 = (
            basis.lambda_at(leg, fraction, 1.0) for leg, fraction in enumerate((a, b, c))
        )
        return cls(lambda1, lambda2, lambda3, 1.0)

    def reversed(self) -> ShapeParameters:
        """Return the parameters of the same curve run backwards: λ1 ↔ λ3, λ2 → 6 − λ2."""
        return ShapeParameters(self.lambda3, 6.0 - self.lambda2, self.lambda1, self.omega)


NEUTRAL = ShapeParameters()
# The same cubic curve, with every λ in effect: of each segment that is made anew.
READY = ShapeParameters(omega=1.0)
SEGMENT_KEYS = ("points", "lambda", "omega", "holds")
POINTS = Several(Fixed((COORDINATE, COORDINATE), "a point [r, h]"), "points [r, h]", 4, 4)
# A coordinate that is larger than allowed by less is so by rounding.
_ROUNDED = MAX_COORDINATE * (1.0 + 1e-12)
_POINTS_PATH = ("segment", "points")


def neutral(parameter: ParameterName) -> float:
    """Return the value at which a parameter leaves the cubic curve alone: 1, 3, 1 and 0."""
    return float(getattr(NEUTRAL, parameter))


@dataclass(frozen=True, slots=True, eq=False)
class Segment:
    """A curve L(s), s in [0, 1], in the profile half-plane.

    ``points`` is a read-only array of shape (4, 2): rows are (r, h), r the signed distance
    from the rotation axis, h the height along it. ``quartic``, shape (5, 2), is the same curve
    exactly as a quartic Bézier curve. An end that ``holds`` does not yield to the rule of its
    joint where the other side can. ``extra`` carries unknown keys of the project file.

    Raises RefusalError, a ValueError, where ``points`` has another shape, is not finite or lies
    beyond 1e9.

    >>> wall = sgb.Segment([(20, 0), (55, 10), (50, 60), (25, 80)])
    >>> wall.point(0.5).tolist()
    [45.0, 36.25]
    >>> fuller = wall.with_shape(sgb.ShapeParameters(lambda2=5.0, omega=0.8))
    >>> fuller.point(0.5).round(3).tolist()
    [45.5, 31.25]
    """

    points: Floats
    shape: ShapeParameters = NEUTRAL
    extra: Mapping[str, object] = field(default_factory=lambda: NO_EXTRA, repr=False, hash=False)
    holds_start: bool = False
    holds_end: bool = False
    quartic: Floats = field(init=False, repr=False)

    def __post_init__(self) -> None:
        points = _as_points(self.points)
        # As basis.quartic_points, but in plain floats: a slider builds segments at each tick, and
        # numpy costs ten times as much.
        (x0, y0), (x1, y1), (x2, y2), (x3, y3) = points.tolist()
        size = max(x0, y0, x1, y1, x2, y2, x3, y3, -min(x0, y0, x1, y1, x2, y2, x3, y3))
        # A sum is finite only where all its parts are.
        if not (size <= MAX_COORDINATE and isfinite(x0 + x1 + x2 + x3 + y0 + y1 + y2 + y3)):
            points = _rounded(points)
            (x0, y0), (x1, y1), (x2, y2), (x3, y3) = points.tolist()
        _check_fields(self)
        a, b, c = self.shape.leg_fractions
        quartic = np.array(
            [
                (x0, y0),
                (x0 + a * (x1 - x0), y0 + a * (y1 - y0)),
                (x2 + b * (x1 - x2), y2 + b * (y1 - y2)),
                (x3 + c * (x2 - x3), y3 + c * (y2 - y3)),
                (x3, y3),
            ]
        )
        quartic.flags.writeable = False
        object.__setattr__(self, "points", points)
        object.__setattr__(self, "quartic", quartic)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Segment):
            return NotImplemented
        return (
            np.array_equal(self.points, other.points)
            and self.shape == other.shape
            and (self.holds_start, self.holds_end) == (other.holds_start, other.holds_end)
            and dict(self.extra) == dict(other.extra)
        )

    def __hash__(self) -> int:
        return hash((self.points.tobytes(), self.shape))

    def with_points(self, points: ArrayLike) -> Segment:
        """Return this segment with other control points, shape (4, 2)."""
        return replace(self, points=np.asarray(points, dtype=np.float64))

    def with_shape(self, shape: ShapeParameters) -> Segment:
        """Return this segment with other shape parameters."""
        return replace(self, shape=shape)

    def point(self, s: ArrayLike) -> Floats:
        """Return L(s), shape (*s.shape, 2)."""
        return basis.bernstein(4, s) @ self.quartic

    def derivative(self, s: ArrayLike, order: int = 1) -> Floats:
        """Return the ``order``-th derivative of L at ``s``, exact, shape (*s.shape, 2)."""
        if order < 0:
            raise ValueError("order must not be negative")
        control = self.quartic
        factor = 1.0
        for k in range(order):
            if k == 4:
                return np.zeros((*np.shape(s), 2))
            factor *= 4 - k
            control = np.diff(control, axis=0)
        return factor * (basis.bernstein(4 - order, s) @ control)

    def curvature(self, s: ArrayLike) -> Floats:
        """Return the signed curvature (r'h'' − r''h')/|L'|³ at ``s``.

        Positive where the curve turns from +r towards +h. Where the derivative vanishes the
        value is nan: the curvature is not defined there.
        """
        d1, d2 = self.derivative(s), self.derivative(s, 2)
        speed = np.hypot(d1[..., 0], d1[..., 1])
        cross = d1[..., 0] * d2[..., 1] - d1[..., 1] * d2[..., 0]
        degenerate = speed <= DEGENERATE_LEG * self.size
        safe = np.where(degenerate, 1.0, speed)
        return np.where(degenerate, np.nan, cross / safe**3)

    @property
    def size(self) -> float:
        """The diagonal of the box around the control points."""
        extent = self.points.max(axis=0) - self.points.min(axis=0)
        return float(np.hypot(extent[0], extent[1]))

    def start_tangent(self, size: float | None = None) -> Floats:
        """Return the true unit tangent at s = 0, shape (2,).

        It points to the first quartic point that differs from the start by at least 1e-12 of
        ``size`` (default: the segment's own); (0, 0) where the whole segment is one point.
        """
        return _first_direction(self.quartic, self.size if size is None else size)

    def end_tangent(self, size: float | None = None) -> Floats:
        """Return the true unit tangent at s = 1, in the direction of travel, shape (2,)."""
        return -_first_direction(self.quartic[::-1], self.size if size is None else size)

    def reversed(self) -> Segment:
        """Return the same curve run from its end to its start."""
        return replace(
            self,
            points=self.points[::-1],
            shape=self.shape.reversed(),
            holds_start=self.holds_end,
            holds_end=self.holds_start,
        )


def _as_points(given: ArrayLike) -> Floats:
    try:
        points = frozen(given)
    except (TypeError, ValueError):
        points = frozen(POINTS.take(given, _POINTS_PATH))
    if points.shape != (4, 2):
        POINTS.take(given, _POINTS_PATH)
    return points


def _rounded(points: Floats) -> Floats:
    """Return points of which one seems to be too far, moved by no more than rounding."""
    if np.abs(points).max() <= _ROUNDED:
        return frozen(np.clip(points, -MAX_COORDINATE, MAX_COORDINATE))
    return frozen(POINTS.take(points.tolist(), _POINTS_PATH))


def _check_fields(segment: Segment) -> None:
    """Check what is no point; a slider makes segments at each tick."""
    if type(segment.shape) is not ShapeParameters:
        Part(ShapeParameters).take(segment.shape, ("segment", "shape"))
    if type(segment.holds_start) is not bool or type(segment.holds_end) is not bool:
        for name in ("holds_start", "holds_end"):
            Flag().take(getattr(segment, name), ("segment", name))
    if segment.extra is not NO_EXTRA:
        extra = take_extra(segment.extra, SEGMENT_KEYS, ("segment",))
        object.__setattr__(segment, "extra", extra)


def _first_direction(points: Floats, size: float) -> Floats:
    steps = points[1:] - points[0]
    lengths = np.hypot(steps[:, 0], steps[:, 1])
    apart = np.flatnonzero((lengths > 0.0) & (lengths >= DEGENERATE_LEG * size))
    if len(apart) == 0:
        return np.zeros(2)
    k = apart[0]
    return np.asarray(steps[k] / lengths[k])
