"""Curves of the profile half-plane as a CAD kernel holds them: splines and parts of circles."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import TypeAlias

import numpy as np

from sgb_core.arrays import Floats, frozen
from sgb_core.bodies.outline import Arc, Line, Piece, Trace
from sgb_core.curves.search import sign_change
from sgb_core.curves.subdivision import de_casteljau
from sgb_core.exchange.errors import ExportError
from sgb_core.findings.exports import NoStep
from sgb_core.values import dataclass

# Fits are quintic: between simple knots their curvature changes smoothly.
FIT_DEGREE = 5
# Between neighbouring sites so many places are compared.
_CHECKED = 7
# A fit that needs more sites follows no smooth curve.
MOST_SITES = 3000
# A fit aims at this part of the tolerance: between the places compared it may be a little off.
_AIM = 0.25
_ROUNDING = 1e-14
# Shares at which a fold at an end is looked for, and how deep, as a part of the size, one can be
# that samples of a section miss.
_FOLD = np.concatenate([np.logspace(-7.0, -2.0, 60), np.linspace(0.0, 1.0, 65)[1:]])
_UNSEEN = 1e-3


@dataclass(frozen=True, slots=True, eq=False)
class Spline:
    """A B-spline curve in the half-plane: poles (k, 2), a clamped knot vector (k + degree + 1,).

    ``deviation`` is how far it is at most from what it stands for.
    """

    poles: Floats
    knots: Floats
    degree: int
    deviation: float = 0.0

    def __post_init__(self) -> None:
        object.__setattr__(self, "poles", frozen(self.poles))
        object.__setattr__(self, "knots", frozen(self.knots))

    @property
    def ends(self) -> Floats:
        """The first and the last point, (2, 2)."""
        return self.poles[[0, -1]]

    @property
    def on_axis(self) -> bool:
        """Whether it lies on the axis all along."""
        return not self.poles[:, 0].any()

    def between(self, first: Floats, last: Floats) -> Spline:
        """Return the curve with its ends moved to points (2,)."""
        poles = self.poles.copy()
        poles[0], poles[-1] = first, last
        return replace(self, poles=poles)

    def mirrored(self) -> Spline:
        """Return the curve on the other side of the axis."""
        return replace(self, poles=self.poles * (-1.0, 1.0))


@dataclass(frozen=True, slots=True, eq=False)
class Circular:
    """Part of a circle about ``centre``, run from the angle ``low`` to ``high``, in radians."""

    centre: tuple[float, float]
    radius: float
    low: float
    high: float
    deviation: float = 0.0

    @property
    def ends(self) -> Floats:
        """The first and the last point, (2, 2)."""
        angles = np.array([self.low, self.high])
        spokes = np.stack([np.cos(angles), np.sin(angles)], axis=1)
        points = np.asarray(self.centre) + self.radius * spokes
        # A circle about a pole begins on the axis, whatever the rounding.
        points[np.abs(points[:, 0]) <= _ROUNDING * self.radius, 0] = 0.0
        return np.asarray(points)

    @property
    def on_axis(self) -> bool:
        """Whether it lies on the axis all along."""
        return False

    def between(self, first: Floats, last: Floats) -> Circular:
        """Return the curve as it is: its ends are where its neighbours' are, to rounding."""
        return self

    def mirrored(self) -> Circular:
        """Return the curve on the other side of the axis."""
        centre = (-self.centre[0], self.centre[1])
        return replace(self, centre=centre, low=np.pi - self.low, high=np.pi - self.high)


Curve: TypeAlias = Spline | Circular


def bezier(points: Floats) -> Spline:
    """Return the Bézier curve of points (k, 2)."""
    degree = len(points) - 1
    return Spline(points, np.repeat([0.0, 1.0], degree + 1), degree)


def curve_of(piece: Piece, tolerance: float) -> Curve:
    """Return a piece of an outline, run its own way.

    Drawn curves, lines and arcs are exact; a moved curve is fitted within ``tolerance``, or
    ExportError raised where none can be.
    """
    if isinstance(piece, Line):
        return bezier(piece.ends)
    if isinstance(piece, Arc):
        turn = piece.high - piece.low
        low, high = piece.low + turn * piece.start, piece.low + turn * piece.end
        return Circular(piece.centre, piece.radius, low, high)
    assert isinstance(piece, Trace)
    if piece.offset == 0.0:
        return bezier(_stretch(piece))
    return _moved(piece, tolerance)


def _stretch(piece: Trace) -> Floats:
    """Return the Bézier points of the stretch of a quartic that a piece runs along."""
    low, high = min(piece.start, piece.end), max(piece.start, piece.end)
    points = piece.quartic
    if high < 1.0:
        points = de_casteljau(points, high)[0]
    if low > 0.0:
        points = de_casteljau(points, low / high)[1]
    return points if piece.end >= piece.start else points[::-1]


def _moved(piece: Trace, tolerance: float) -> Spline:
    """Return the fit of a moved curve, which leaves and reaches its ends as the curve does."""
    first, last = _unfolded(piece, 0), _unfolded(piece, 1)
    way = 1.0 if piece.end >= piece.start else -1.0
    tangents = way * piece.tangents(np.array([piece.start, piece.end]))
    return fitted(
        lambda share: piece.points(first + (last - first) * share), tolerance, piece.ends, tangents
    )


def _unfolded(piece: Trace, which: int) -> float:
    """Return where a moved curve begins, seen from one end, without a fold too small to see.

    Where a curve ends with a vanishing derivative its curvature is unbounded: moved to the inside
    it runs back at first, until it comes abreast of the end again. Of such a fold the section
    keeps what its samples do not resolve.
    """
    end, other = (piece.start, piece.end) if which == 0 else (piece.end, piece.start)
    corner = piece.points(np.array([end]))[0]
    inward = piece.tangents(np.array([end]))[0] * (1.0 if other >= end else -1.0)

    def ahead(u: Floats) -> Floats:
        return np.asarray((piece.points(u) - corner) @ inward)

    u = end + (other - end) * _FOLD
    distances = ahead(u)
    if distances[0] >= 0.0:
        return end
    again = np.flatnonzero(distances >= 0.0)
    if len(again) == 0 or -distances[: again[0]].min() > _UNSEEN * piece.size:
        return end
    return sign_change(ahead, float(u[again[0] - 1]), float(u[again[0]]))


def fitted(
    points: Callable[[Floats], Floats], tolerance: float, ends: Floats, tangents: Floats
) -> Spline:
    """Return the quintic through points of a curve, (k, 2) at shares 0 to 1, within a tolerance.

    It runs between ``ends`` (2, 2) along unit ``tangents`` there, so that it touches what the curve
    touches. Sites are halved where the curve between them is off. Raises ExportError where there
    would be too many of them.
    """
    # Most commands write no STEP, and need not wait for it.
    from scipy.interpolate import make_interp_spline

    sites = np.linspace(0.0, 1.0, FIT_DEGREE + 1)
    shares = (np.arange(_CHECKED) + 1.0) / (_CHECKED + 1.0)
    # Where the curve is left out up to a fold's end, no fit is nearer than that.
    gaps = np.linalg.norm(points(np.array([0.0, 1.0])) - ends, axis=1)
    aim = _AIM * tolerance + float(gaps.max())
    while True:
        spline = make_interp_spline(sites, points(sites), k=FIT_DEGREE)
        _direct(spline.c, ends, tangents)
        places = sites[:-1, None] + np.diff(sites)[:, None] * shares
        off = np.linalg.norm(points(places.ravel()) - spline(places.ravel()), axis=1)
        off = off.reshape(places.shape).max(axis=1)
        if off.max() <= aim:
            return Spline(spline.c, spline.t, FIT_DEGREE, float(max(off.max(), gaps.max())))
        sites = halved(sites, off > aim)
        if len(sites) > MOST_SITES:
            raise ExportError(NoStep.NO_FIT)


def _direct(poles: Floats, ends: Floats, tangents: Floats) -> None:
    """Put a spline's outer poles on its ends, and those next to them straight ahead."""
    for end, tangent, (outer, inner) in zip(ends, tangents, ((0, 1), (-1, -2)), strict=True):
        ahead = (poles[inner] - end) @ tangent
        poles[outer], poles[inner] = end, end + ahead * tangent


def halved(sites: Floats, wrong: np.ndarray[tuple[int], np.dtype[np.bool_]]) -> Floats:
    """Return sites with the ``wrong`` steps between them halved, and their neighbours with them.

    So steps never differ much from the next ones, which would let the fit swing.
    """
    wide = wrong.copy()
    wide[1:] |= wrong[:-1]
    wide[:-1] |= wrong[1:]
    middle = (sites[1:] + sites[:-1]) / 2.0
    return np.sort(np.concatenate([sites, middle[wide]]))
