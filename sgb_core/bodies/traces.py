"""Many pieces of outlines at once: a section of thousands of segments is worked on as arrays."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TypeAlias

import numpy as np

from sgb_core.arrays import Floats, Ints
from sgb_core.bodies.outline import Piece, Trace
from sgb_core.surfaces.curvature import cross
from sgb_core.surfaces.normals import STILL
from sgb_core.surfaces.sections import Stretch, curves_at, joined_stretch
from sgb_core.values import dataclass

ValuesOf: TypeAlias = Callable[[Sequence[Piece], Floats, Ints], Floats]


@dataclass(frozen=True, slots=True, eq=False)
class Traces:
    """Traces as arrays: ``quartics`` (n, 5, 2), their stretch, ``offset`` and ``size`` (n,).

    Functions take places ``u`` and the numbers ``k`` of their traces, each (m,), and agree with
    those of the pieces.
    """

    pieces: tuple[Trace, ...]
    quartics: Floats
    stretch: Stretch | None
    offset: Floats
    size: Floats

    @classmethod
    def of(cls, pieces: Sequence[Trace]) -> Traces:
        """Return traces as arrays."""
        return cls(
            tuple(pieces),
            np.array([piece.quartic for piece in pieces]).reshape(-1, 5, 2),
            joined_stretch([piece.stretch for piece in pieces]),
            np.array([piece.offset for piece in pieces]),
            np.array([piece.size for piece in pieces]),
        )

    def _at(self, k: Ints, u: Floats, order: int = 0) -> Floats:
        return curves_at(self.quartics, self.stretch, k, u, order)

    def points(self, u: Floats, k: Ints) -> Floats:
        """Return the points, shape (m, 2)."""
        points = self._at(k, u)
        moved = np.flatnonzero(self.offset[k])
        if not len(moved):
            return points
        u, k = u[moved], k[moved]
        first = self._at(k, u, 1)
        pace = np.hypot(first[:, 0], first[:, 1])
        still = pace <= STILL * self.size[k]
        tangents = first / np.where(still, 1.0, pace)[:, None]
        points[moved] += self.offset[k, None] * np.stack([-tangents[:, 1], tangents[:, 0]], axis=1)
        for at in np.flatnonzero(still).tolist():
            points[moved[at]] = self.pieces[k[at]].points(u[at : at + 1])[0]
        return points

    def velocity(self, u: Floats, k: Ints) -> Floats:
        """Return dP/du, shape (m, 2)."""
        first = self._at(k, u, 1)
        moved = np.flatnonzero(self.offset[k])
        if not len(moved):
            return first
        u, k, plain = u[moved], k[moved], first[moved]
        pace = np.hypot(plain[:, 0], plain[:, 1])
        still = pace <= STILL * self.size[k]
        safe = np.where(still, 1.0, pace)
        turn = cross(plain, self._at(k, u, 2)) / safe**2
        first[moved] = plain - (self.offset[k] * turn / safe)[:, None] * plain
        for at in np.flatnonzero(still).tolist():
            first[moved[at]] = self.pieces[k[at]].velocity(u[at : at + 1])[0]
        return first


def points_of(pieces: Sequence[Piece], u: Floats, k: Ints) -> Floats:
    """Return the points at places ``u`` of the pieces numbered ``k``, each (m,), shape (m, 2)."""
    return _of_each(pieces, u, k, Traces.points, lambda piece: piece.points)


def velocities_of(pieces: Sequence[Piece], u: Floats, k: Ints) -> Floats:
    """Return dP/du in the same way."""
    return _of_each(pieces, u, k, Traces.velocity, lambda piece: piece.velocity)


def _of_each(
    pieces: Sequence[Piece],
    u: Floats,
    k: Ints,
    of_traces: Callable[[Traces, Floats, Ints], Floats],
    of_other: Callable[[Piece], Callable[[Floats], Floats]],
) -> Floats:
    are_traces = np.array([isinstance(piece, Trace) for piece in pieces], dtype=bool)
    number = np.cumsum(are_traces) - 1
    ours = are_traces[k]
    found = np.empty((len(u), 2))
    traces = Traces.of([piece for piece in pieces if isinstance(piece, Trace)])
    found[ours] = of_traces(traces, u[ours], number[k[ours]])
    rest = np.flatnonzero(~ours)
    order = rest[np.argsort(k[rest], kind="stable")]
    for same in np.split(order, np.flatnonzero(np.diff(k[order])) + 1):
        if len(same):
            found[same] = of_other(pieces[k[same[0]]])(u[same])
    return found


def ends_of(pieces: Sequence[Piece]) -> Floats:
    """Return the first and the last point of each piece's travel, shape (n, 2, 2)."""
    u = np.array([(piece.start, piece.end) for piece in pieces]).reshape(-1)
    return points_of(pieces, u, np.repeat(np.arange(len(pieces)), 2)).reshape(-1, 2, 2)
