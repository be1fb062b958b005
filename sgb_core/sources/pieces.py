"""The pieces that drawings are made of, and paths of them: lines, Béziers and arcs."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from math import atan2, ceil, degrees, pi
from typing import TypeAlias

import numpy as np

from sgb_core.arrays import Floats, frozen
from sgb_core.curves.basis import bernstein
from sgb_core.curves.conversion import Leg, to_segment
from sgb_core.curves.primitives import arc
from sgb_core.curves.segment import READY, Segment
from sgb_core.fields.kinds import MAX_COORDINATE
from sgb_core.values import dataclass

# A quartic is a segment where one reaches it to this part of its size.
_REACHED = 1e-9
# The arcs that one segment follows, at most: a third of a turn.
_LARGEST_ARC = 2.0 * pi / 3.0
# Samples of a piece that tell its direction at an end.
_FINE = 1001
_NEUTRAL = READY


@dataclass(frozen=True, slots=True, eq=False)
class Bezier:
    """A Bézier curve: control points of shape (degree + 1, 2), degree at least 1."""

    points: Floats

    def __post_init__(self) -> None:
        object.__setattr__(self, "points", frozen(self.points))

    @property
    def is_line(self) -> bool:
        """Whether it is given as a straight line."""
        return len(self.points) == 2

    @property
    def is_exact(self) -> bool:
        """Whether a segment is the same curve by the theory: line, quadratic or cubic."""
        return len(self.points) <= 4

    @property
    def ends(self) -> Floats:
        """The first and the last point, shape (2, 2)."""
        return self.points[[0, -1]]

    def sampled(self, count: int) -> Floats:
        """Return ``count`` points at equal steps of the parameter, ends included."""
        return bernstein(len(self.points) - 1, np.linspace(0.0, 1.0, count)) @ self.points

    def mapped(self, matrix: Floats, shift: Floats) -> Bezier:
        """Return the affine image matrix·p + shift."""
        return Bezier(self.points @ matrix.T + shift)

    def reversed(self) -> Bezier:
        """Return the same curve run backwards."""
        return Bezier(self.points[::-1])

    def cut(self, s: float) -> tuple[Bezier, Bezier]:
        """Return the parts before and after ``s`` (de Casteljau)."""
        row = self.points
        left, right = [row[0]], [row[-1]]
        while len(row) > 1:
            row = row[:-1] + s * np.diff(row, axis=0)
            left.append(row[0])
            right.append(row[-1])
        return Bezier(np.array(left)), Bezier(np.array(right[::-1]))

    def segments(self) -> tuple[Segment, ...] | None:
        """Return the one segment that is this curve with ω = 1, or None where there is none."""
        p = self.points
        if len(p) == 2:
            return (Segment(np.linspace(p[0], p[1], 4), _NEUTRAL),)
        if len(p) == 3:
            inner = (p[0] + 2.0 * p[1]) / 3.0, (2.0 * p[1] + p[2]) / 3.0
            return (Segment(np.array([p[0], *inner, p[2]]), _NEUTRAL),)
        if len(p) == 4:
            return (Segment(p, _NEUTRAL),)
        if len(p) == 5:
            segment, error = to_segment(p, Leg(p[1] - p[0], 1.0), Leg(p[3] - p[4], 1.0))
            if np.abs(error).max() <= _REACHED * float(np.ptp(p, axis=0).max()):
                return (segment,)
        return None


@dataclass(frozen=True, slots=True, eq=False)
class Arc:
    """A piece of an ellipse: centre + frame·(cos t, sin t), t from ``start`` to ``end``.

    ``frame`` has shape (2, 2): its columns are conjugate half diameters.
    """

    center: Floats
    frame: Floats
    start: float
    end: float

    is_line = False
    is_exact = False

    def __post_init__(self) -> None:
        object.__setattr__(self, "center", frozen(self.center))
        object.__setattr__(self, "frame", frozen(self.frame))

    @classmethod
    def circular(cls, center: Sequence[float], radius: float, start: float, end: float) -> Arc:
        """Return an arc of a circle; angles in radians, a smaller end runs clockwise."""
        return cls(np.asarray(center, dtype=np.float64), radius * np.eye(2), start, end)

    @property
    def ends(self) -> Floats:
        """The first and the last point, shape (2, 2)."""
        return self._at(np.array([self.start, self.end]))

    def sampled(self, count: int) -> Floats:
        """Return ``count`` points at equal steps of the parameter, ends included."""
        return self._at(np.linspace(self.start, self.end, count))

    def mapped(self, matrix: Floats, shift: Floats) -> Arc:
        """Return the affine image matrix·p + shift."""
        return Arc(matrix @ self.center + shift, matrix @ self.frame, self.start, self.end)

    def reversed(self) -> Arc:
        """Return the same curve run backwards."""
        return Arc(self.center, self.frame, self.end, self.start)

    def cut(self, s: float) -> tuple[Arc, Arc]:
        """Return the parts before and after the part ``s`` of the parameter's range."""
        middle = self.start + s * (self.end - self.start)
        return (
            Arc(self.center, self.frame, self.start, middle),
            Arc(self.center, self.frame, middle, self.end),
        )

    def segments(self) -> tuple[Segment, ...] | None:
        """Return segments that follow the arc to 7e-6 of its radius.

        An affine image of the unit circle's best segments: the theory is affinely invariant.
        """
        sweep = self.end - self.start
        count = max(ceil(abs(sweep) / _LARGEST_ARC), 1)
        found = []
        for k in range(count):
            low = self.start + sweep * k / count
            unit, _ = arc((0.0, 0.0), 1.0, low, self.start + sweep * (k + 1) / count)
            found.append(unit.with_points(unit.points @ self.frame.T + self.center))
        return tuple(found)

    def _at(self, angle: Floats) -> Floats:
        circle = np.stack([np.cos(angle), np.sin(angle)], axis=-1)
        return np.asarray(circle @ self.frame.T + self.center)


@dataclass(frozen=True, slots=True, eq=False)
class Sampled:
    """A curve known by dense points alone, shape (N, 2)."""

    points: Floats

    is_line = False
    is_exact = False

    def __post_init__(self) -> None:
        object.__setattr__(self, "points", frozen(self.points))

    @property
    def ends(self) -> Floats:
        """The first and the last point, shape (2, 2)."""
        return self.points[[0, -1]]

    def sampled(self, count: int) -> Floats:
        """Return all points, or ``count`` at equal steps of their numbers if those are more."""
        if count <= len(self.points):
            return self.points
        marks = np.linspace(0.0, len(self.points) - 1.0, count)
        numbers = np.arange(len(self.points))
        return np.stack([np.interp(marks, numbers, self.points[:, k]) for k in range(2)], axis=1)

    def mapped(self, matrix: Floats, shift: Floats) -> Sampled:
        """Return the affine image matrix·p + shift."""
        return Sampled(self.points @ matrix.T + shift)

    def reversed(self) -> Sampled:
        """Return the same curve run backwards."""
        return Sampled(self.points[::-1])

    def cut(self, s: float) -> tuple[Sampled, Sampled]:
        """Return the parts before and after the part ``s`` of the numbers of points."""
        place = s * (len(self.points) - 1)
        before = int(np.ceil(place))
        part = place - (before - 1)
        middle = self.points[before - 1] + part * (self.points[before] - self.points[before - 1])
        after = self.points[before:]
        return (
            Sampled(np.concatenate([self.points[:before], [middle]])),
            Sampled(np.concatenate([[middle], after])),
        )

    def segments(self) -> tuple[Segment, ...] | None:
        """Return None: only tracing finds segments."""
        return None


Piece: TypeAlias = Bezier | Arc | Sampled


@dataclass(frozen=True, slots=True)
class Path:
    """Pieces that follow each other; ``name`` is what the source calls it."""

    pieces: tuple[Piece, ...]
    closed: bool = False
    name: str = ""

    @property
    def bounds(self) -> tuple[Floats, Floats]:
        """The lower and upper corner of the box around samples, each shape (2,)."""
        points = self.sampled(9)
        return points.min(axis=0), points.max(axis=0)

    def sampled(self, count: int) -> Floats:
        """Return the points of all pieces, ``count`` each, joints once."""
        runs = [piece.sampled(count) for piece in self.pieces]
        return np.concatenate([*(run[:-1] for run in runs), runs[-1][-1:]])

    def corners(self, count: int, turn_deg: float) -> list[int]:
        """Return which of the points of :meth:`sampled` are joints that turn by more degrees."""
        found, number = [], 0
        for piece, following in pairwise(self.pieces):
            number += len(piece.sampled(count)) - 1
            before, after = piece.sampled(_FINE), following.sampled(_FINE)
            (x1, y1), (x2, y2) = before[-1] - before[-2], after[1] - after[0]
            if degrees(abs(atan2(x1 * y2 - y1 * x2, x1 * x2 + y1 * y2))) > turn_deg:
                found.append(number)
        return found

    def mapped(self, matrix: Floats, shift: Floats) -> Path:
        """Return the affine image of the path."""
        return Path(
            tuple(piece.mapped(matrix, shift) for piece in self.pieces), self.closed, self.name
        )

    def reversed(self) -> Path:
        """Return the same path run backwards."""
        pieces = tuple(piece.reversed() for piece in reversed(self.pieces))
        return Path(pieces, self.closed, self.name)


def chained(pieces: Sequence[Piece], reach: float, name: str = "") -> list[Path]:
    """Return pieces put together where their ends lie within ``reach`` of each other.

    A piece may have to be turned round. The longest paths come first.
    """
    left = list(pieces)
    paths = []
    while left:
        chain = [left.pop(0)]
        grown = True
        while grown:
            grown = False
            for number, piece in enumerate(left):
                joined = _joined(chain, piece, reach)
                if joined is not None:
                    chain, grown = joined, True
                    left.pop(number)
                    break
        closed = len(chain) > 1 and _near(chain[0].ends[0], chain[-1].ends[1], reach)
        closed = closed or (len(chain) == 1 and _near(chain[0].ends[0], chain[0].ends[1], reach))
        paths.append(Path(tuple(chain), closed, name))
    return sorted(paths, key=lambda path: -_length(path))


def are_places(points: Floats) -> bool:
    """Whether all coordinates are such as a document can hold."""
    return bool((np.abs(points) <= MAX_COORDINATE).all())


def upright_line(pieces: Sequence[Piece]) -> float | None:
    """Return the abscissa of pieces that lie on one upright line, or None where they do not."""
    if not pieces:
        return None
    ends = np.concatenate([piece.ends for piece in pieces])
    level, upright = np.ptp(ends, axis=0).tolist()
    return float(ends[0, 0]) if level <= 1e-9 * upright else None


def _joined(chain: list[Piece], piece: Piece, reach: float) -> list[Piece] | None:
    start, end = chain[0].ends[0], chain[-1].ends[1]
    first, last = piece.ends
    if _near(end, first, reach):
        return [*chain, piece]
    if _near(end, last, reach):
        return [*chain, piece.reversed()]
    if _near(start, last, reach):
        return [piece, *chain]
    if _near(start, first, reach):
        return [piece.reversed(), *chain]
    return None


def _near(first: Floats, second: Floats, reach: float) -> bool:
    return float(np.hypot(*(first - second))) <= reach


def _length(path: Path) -> float:
    return float(np.hypot(*np.diff(path.sampled(9), axis=0).T).sum())
