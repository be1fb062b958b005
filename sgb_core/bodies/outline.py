"""Outlines of a body's cross-section: exact pieces of curves, and what integrals over them give.

A wall's section is bounded by stretches of the drawn profile, by the same curve moved along its
normal, by arcs about kinks and by straight lines. Each piece knows its points, tangents and
normals exactly, so that a mesh samples it as finely as it likes and measures integrate it as it is.
"""

from __future__ import annotations

from dataclasses import field, replace
from enum import StrEnum
from typing import TypeAlias

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.surfaces.curvature import cross
from sgb_core.surfaces.sections import Sections, Stretch
from sgb_core.values import dataclass


class Role(StrEnum):
    """What a piece of a section's outline is to the body."""

    DRAWN = "drawn"
    WALL = "wall"
    RIM = "rim"
    FLOOR = "floor"
    FOOT = "foot"
    HOLE = "hole"
    AXIS = "axis"
    LEVEL = "level"


@dataclass(frozen=True, slots=True)
class Piece:
    """A curve P(u) in the profile half-plane, run from u = ``start`` to u = ``end``.

    ``source`` numbers the curve it is a part of within its section; ``place`` + u grows along the
    profile and along its wall, at every angle alike. Material lies to the left of the travel.
    Subclasses give points, unit tangents along growing u, and dP/du, each (k, 2).
    """

    role: Role
    source: int = field(default=-1, kw_only=True)
    place: int = field(default=0, kw_only=True)
    start: float = field(default=0.0, kw_only=True)
    end: float = field(default=1.0, kw_only=True)

    def points(self, u: Floats) -> Floats:
        """Return P(u)."""
        raise NotImplementedError

    def tangents(self, u: Floats) -> Floats:
        """Return unit tangents along growing u."""
        raise NotImplementedError

    def velocity(self, u: Floats) -> Floats:
        """Return dP/du."""
        raise NotImplementedError

    def normals(self, u: Floats) -> Floats:
        """Return unit normals to the right of the travel: out of the material."""
        tangents = self.tangents(u) * (1.0 if self.end >= self.start else -1.0)
        return np.stack([tangents[:, 1], -tangents[:, 0]], axis=1)

    @property
    def ends(self) -> Floats:
        """The first and the last point of the travel, shape (2, 2)."""
        return self.points(np.array([self.start, self.end]))

    def reversed(self) -> Piece:
        """Return the same stretch run the other way."""
        return replace(self, start=self.end, end=self.start)


@dataclass(frozen=True, slots=True)
class Trace(Piece):
    """L(s) + offset · N(s): a segment moved to the left of its direction, u = s.

    ``segment`` is its number in the profile; ``quartic`` (5, 2) its Bézier points, which
    ``stretch`` maps where laws change along the height; ``size`` the profile's.
    """

    quartic: Floats = field(kw_only=True)
    size: float = field(kw_only=True)
    stretch: Stretch | None = field(default=None, kw_only=True)
    offset: float = field(default=0.0, kw_only=True)
    segment: int = field(default=0, kw_only=True)

    @property
    def curve(self) -> Sections:
        """The drawn curve."""
        return Sections(self.quartic, np.zeros((5, 2)), self.stretch)

    def tangents(self, u: Floats) -> Floats:
        """Return unit tangents of the drawn curve, which are those of the moved one."""
        return self.curve.tangents_on(u, self.size)

    def points(self, u: Floats) -> Floats:
        """Return the moved points."""
        points = self.curve.on(u)
        if self.offset == 0.0:
            return points
        tangents = self.tangents(u)
        return points + self.offset * np.stack([-tangents[:, 1], tangents[:, 0]], axis=1)

    def velocity(self, u: Floats) -> Floats:
        """Return L' − offset · κ|L'| · T, since N' = −κ |L'| T; zero where L' vanishes."""
        first = self.curve.on(u, 1)
        if self.offset == 0.0:
            return first
        square = (first * first).sum(axis=1)
        still = square <= (1e-14 * self.size) ** 2
        turn = cross(first, self.curve.on(u, 2)) / np.where(still, 1.0, square)
        return first - (self.offset * np.where(still, 0.0, turn))[:, None] * self.tangents(u)


@dataclass(frozen=True, slots=True)
class Arc(Piece):
    """Part of a circle: u runs from 0 to 1 as the angle goes from ``low`` to ``high`` (radians)."""

    centre: tuple[float, float] = field(kw_only=True)
    radius: float = field(kw_only=True)
    low: float = field(kw_only=True)
    high: float = field(kw_only=True)

    def _spokes(self, u: Floats) -> Floats:
        angles = self.low + (self.high - self.low) * u
        return np.stack([np.cos(angles), np.sin(angles)], axis=1)

    def points(self, u: Floats) -> Floats:
        """Return points of the circle."""
        return np.asarray(self.centre) + self.radius * self._spokes(u)

    def tangents(self, u: Floats) -> Floats:
        """Return tangents along growing u."""
        spokes = self._spokes(u) * (1.0 if self.high >= self.low else -1.0)
        return np.stack([-spokes[:, 1], spokes[:, 0]], axis=1)

    def velocity(self, u: Floats) -> Floats:
        """Return dP/du."""
        return self.tangents(u) * (self.radius * abs(self.high - self.low))


@dataclass(frozen=True, slots=True)
class Line(Piece):
    """The straight line from ``first`` (u = 0) to ``last`` (u = 1)."""

    first: tuple[float, float] = field(kw_only=True)
    last: tuple[float, float] = field(kw_only=True)

    def points(self, u: Floats) -> Floats:
        """Return points of the line; its ends to the last bit."""
        first, last = np.asarray(self.first), np.asarray(self.last)
        return np.asarray(first * (1.0 - u)[:, None] + last * u[:, None])

    def tangents(self, u: Floats) -> Floats:
        """Return the line's direction."""
        step = np.asarray(self.last) - np.asarray(self.first)
        length = float(np.hypot(step[0], step[1]))
        return np.broadcast_to(step / length if length else np.array([0.0, 1.0]), (len(u), 2))

    def velocity(self, u: Floats) -> Floats:
        """Return dP/du."""
        step = np.asarray(self.last) - np.asarray(self.first)
        return np.broadcast_to(step, (len(u), 2))


Ring: TypeAlias = tuple[Piece, ...]


def line(role: Role, first: Floats, last: Floats) -> Line:
    """Return the line between two points of shape (2,)."""
    return Line(
        role, first=(float(first[0]), float(first[1])), last=(float(last[0]), float(last[1]))
    )
