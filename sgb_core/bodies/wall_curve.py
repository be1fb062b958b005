"""The wall's other curve: the drawn profile moved along its normal, cut or extended at its ends."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import field, replace
from itertools import count
from math import atan2, pi

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.bodies.meridian import Meridian
from sgb_core.bodies.outline import Arc, Line, Piece, Role, Trace, line
from sgb_core.bodies.region import parameters
from sgb_core.bodies.traces import ends_of
from sgb_core.curves.search import sign_change
from sgb_core.findings.bodies import DoubtfulPlace, End, EndCutSquare, TightCurve
from sgb_core.surfaces.curvature import cross
from sgb_core.values import dataclass

# A wall's curve is extended by at most so many walls and bases: beyond, its end is cut square.
LONGEST_EXTENSION = 10.0
# Kinks below this angle (radians) are rounding.
SMOOTH = 1e-7


@dataclass(slots=True, eq=False)
class WallBuilder:
    """Builds the curves of one meridian's wall; ``offset`` is positive to the left of the run."""

    meridian: Meridian
    offset: float
    grids: Mapping[int, Floats]
    _findings: list[DoubtfulPlace] = field(default_factory=list)
    _numbers: count[int] = field(default_factory=count)

    @property
    def findings(self) -> tuple[DoubtfulPlace, ...]:
        """What is to be looked at, in the order in which it was found."""
        return tuple(self._findings)

    def note(self, *findings: DoubtfulPlace) -> None:
        """Remember what is to be looked at."""
        self._findings += findings

    def number(self, piece: Piece) -> Piece:
        """Return the piece with a source number of its own."""
        return replace(piece, source=next(self._numbers))

    def line(self, role: Role, first: Floats, last: Floats, place: int = 0) -> Piece:
        """Return a numbered straight line."""
        return self.number(replace(line(role, first, last), place=place))

    def traces(self, offset: float, role: Role) -> list[Piece]:
        """Return the profile's segments from foot to rim, moved by ``offset``."""
        meridian = self.meridian
        return [
            self.number(
                Trace(
                    role,
                    place=2 * k,
                    quartic=quartic,
                    stretch=None if meridian.stretch is None else meridian.stretch[k],
                    size=meridian.size,
                    offset=offset,
                    segment=number,
                )
            )
            for k, (quartic, number) in enumerate(
                zip(meridian.quartics, meridian.numbers, strict=True)
            )
        ]

    def path(self) -> list[Piece]:
        """Return the moved curve from foot to rim, with arcs about kinks and about poles.

        About a kink an arc is the true offset on the convex side; on the other side a line closes
        the curve, and the region's winding number removes it with the loop that it is part of.
        """
        meridian, offset = self.meridian, self.offset
        moved = self.traces(offset, Role.WALL)
        starts, ends = meridian.end_directions()
        pieces: list[Piece] = []
        if meridian.foot_on_axis:
            pieces += self._pole_arc(meridian.foot, starts[0], at_foot=True)
        for k, piece in enumerate(moved):
            pieces.append(piece)
            after = k + 1 if k + 1 < len(moved) else 0
            if after or meridian.closed:
                pieces += self._joint(k, ends[k], starts[after])
        if meridian.rim_on_axis:
            pieces += self._pole_arc(meridian.rim, ends[-1], at_foot=False)
        return pieces

    def _joint(self, k: int, before: Floats, after: Floats) -> list[Piece]:
        joint, place = self.meridian.ends[1][k], 2 * k + 1
        turn = atan2(float(cross(before, after)), float(before @ after))
        if abs(turn) < SMOOTH:
            return []
        if pi - abs(turn) < 1e-6:
            turn = -abs(turn) if self.offset > 0.0 else abs(turn)
        low = self._normal_angle(before)
        if turn * self.offset > 0.0:
            spokes = np.array([(np.cos(a), np.sin(a)) for a in (low, low + turn)])
            first, last = joint + abs(self.offset) * spokes
            return [self.line(Role.WALL, first, last, place)]
        return [self._arc(Role.WALL, joint, abs(self.offset), low, low + turn, place)]

    def _pole_arc(self, pole: Floats, tangent: Floats, at_foot: bool) -> list[Piece]:
        """Return the arc from the axis to the moved end, or back to it."""
        upward = (self.offset > 0.0) == at_foot
        axis = pi / 2.0 if upward else -pi / 2.0
        normal = self._normal_angle(tangent)
        turn = (normal - axis + pi) % (2.0 * pi) - pi
        # An end beyond the axis needs none: the curve crosses the axis by itself.
        if abs(turn) < SMOOTH or np.cos(normal) < 0.0:
            return []
        low, high = (axis, axis + turn) if at_foot else (axis + turn, axis)
        place = -1 if at_foot else 2 * len(self.meridian.quartics) - 1
        return [self._arc(Role.WALL, pole, abs(self.offset), low, high, place)]

    def _normal_angle(self, tangent: Floats) -> float:
        left = atan2(float(tangent[0]), -float(tangent[1]))
        return left if self.offset > 0.0 else left + pi

    def _arc(
        self, role: Role, centre: Floats, radius: float, low: float, high: float, place: int
    ) -> Piece:
        middle = (float(centre[0]), float(centre[1]))
        return self.number(Arc(role, place=place, centre=middle, radius=radius, low=low, high=high))

    def _extension(self, end: Floats, stop: Floats, at_rim: bool) -> Piece:
        """Return the line that carries the path on from its end, run towards the path."""
        if at_rim:
            place = 2 * len(self.meridian.quartics) + 1
            return self.line(Role.WALL, end, stop, place).reversed()
        return self.line(Role.WALL, stop, end, -3)

    def cut_at_rim(self, path: list[Piece]) -> list[Piece]:
        """Return the path cut by the plane through the rim, or extended to it."""
        tangent = self.meridian.end_directions()[1][-1]
        level = float(self.meridian.rim[1])
        backwards = [piece.reversed() for piece in reversed(path)]
        cut = self._cut_end(backwards, level, tangent, "rim")
        return [piece.reversed() for piece in reversed(cut)]

    def cut_at_foot(self, path: list[Piece], reach: float) -> list[Piece]:
        """Return the path cut by the plane through the foot, or extended to the height ``reach``.

        Inside, an end between the two planes stays as it is: the floor covers it. An outer wall
        that comes down to its foot goes on to the floor's underside, wherever its end lies.
        """
        tangent = -self.meridian.end_directions()[0][0]
        level = float(self.meridian.foot[1])
        end = float(path[0].ends[0, 1])
        if tangent[1] < 0.0 and self.offset < 0.0:
            return self._cut_end(path, reach, tangent, "foot", level - reach)
        if tangent[1] < 0.0 and min(level, reach) <= end <= max(level, reach):
            return path
        beyond_level = tangent[1] < 0.0 and (end > level) == (reach > level)
        return self._cut_end(path, reach if beyond_level else level, tangent, "foot")

    def _cut_end(
        self, path: list[Piece], level: float, outward: Floats, name: End, depth: float = 0.0
    ) -> list[Piece]:
        """Cut or extend a path that starts at an open end, where ``outward`` leads on from it."""
        size = self.meridian.size
        end = path[0].ends[0]
        way = 1.0 if outward[1] >= 0.0 else -1.0
        short = (level - float(end[1])) * way
        if abs(short) <= 1e-12 * size:
            return path
        # Where a lip hangs or a foot curls up a little, the plane would cut off all of it.
        curled = (way > 0.0) == (name == "foot")
        if short > 0.0 or curled:
            longest = LONGEST_EXTENSION * (abs(self.offset) + depth)
            if self.offset < 0.0 and name == "foot" and outward[0] < 0.0:
                # Beyond the axis there would be a tip below the floor instead of its underside.
                longest = min(longest, -float(end[0] / outward[0]))
            if abs(short) > abs(outward[1]) * longest:
                if abs(outward[1]) > 1e-6:
                    self.note(EndCutSquare((float(end[0]), float(end[1])), name))
                return self._without_loop(path, outward, name == "rim")
        if short > 0.0:
            stop = end + outward * (short / abs(float(outward[1])))
            stop[1] = level
            return [self._extension(end, stop, name == "rim"), *path]
        found = self._first_at_level(path, level)
        if found is None:
            return path
        number, u = found
        return [replace(path[number], start=u), *path[number + 1 :]]

    def _first_at_level(self, path: Sequence[Piece], level: float) -> tuple[int, float] | None:
        first: tuple[int, float] | None = None
        for found in self._crossings(path, lambda points: points[:, 1] - level):
            if not _runs_back(path[found[0]], found[1]):
                return found
            first = first or found
        return first

    def _without_loop(self, path: list[Piece], outward: Floats, at_rim: bool) -> list[Piece]:
        """Return a path cut square at its start, without the loop that a tight lip leaves there.

        Where the lip curves more tightly than the wall allows, the path runs back at first. It is
        led straight to where the line that carries it on would meet it again.
        """
        if not _runs_back(path[0], path[0].start):
            return path
        end = path[0].ends[0]

        def aside(points: Floats) -> Floats:
            return cross(np.broadcast_to(outward, points.shape), points - end)

        slack = 1e-9 * self.meridian.size
        for number, u in self._crossings(path, aside):
            corner = path[number].points(np.array([u]))[0]
            along = float((corner - end) @ outward)
            if along > slack and not _runs_back(path[number], u):
                rest = [replace(path[number], start=u), *path[number + 1 :]]
                return [self._extension(corner, end, at_rim), *rest]
        return path

    def _crossings(
        self, path: Sequence[Piece], value: Callable[[Floats], Floats]
    ) -> Iterator[tuple[int, float]]:
        """Yield (piece number, u) where a function of the points changes its sign, in order."""
        for number, piece in enumerate(path):
            u = parameters(piece, self.grids)
            negative = value(piece.points(u)) < 0.0
            for k in np.flatnonzero(negative[:-1] != negative[1:]).tolist():

                def at(places: Floats, piece: Piece = piece) -> Floats:
                    return value(piece.points(places))

                yield number, sign_change(at, float(u[k]), float(u[k + 1]))

    def round_rim(
        self, drawn: list[Piece], path: list[Piece]
    ) -> tuple[list[Piece], list[Piece], list[Piece]] | None:
        """Return drawn curve, moved path and the half circle between them, or None.

        The half circle has the wall as its diameter and touches both curves; its highest point (at
        a rim that points downwards its lowest) is as high as the drawn rim. It runs from the right
        of the profile to the left, in two pieces that meet at that point. None where the rim is
        shorter than the circle.
        """
        meridian = self.meridian
        radius = abs(self.offset) / 2.0
        level = float(meridian.rim[1])
        way = 1.0 if meridian.end_directions()[1][-1, 1] >= -1e-9 else -1.0

        for k in reversed(range(len(drawn))):
            middle = replace(_trace(drawn[k]), offset=self.offset / 2.0)

            def excess(s: Floats, middle: Trace = middle) -> Floats:
                return np.asarray((middle.points(s)[:, 1] - level) * way + radius)

            grid = self.grids[middle.segment][::-1]
            values = excess(grid)
            if values[0] <= 0.0 and k == len(drawn) - 1:
                s = 1.0
            else:
                below = np.flatnonzero(values <= 0.0)
                if len(below) == 0:
                    continue
                at = int(below[0])
                s = sign_change(excess, float(grid[at]), float(grid[at - 1])) if at else 1.0
            centre = middle.points(np.array([s]))[0]
            tangent = middle.tangents(np.array([s]))[0]
            low = atan2(-float(tangent[0]), float(tangent[1]))
            top = ((way * pi / 2.0 - low) % (2.0 * pi)) / pi
            share = top if 1e-6 < top < 1.0 - 1e-6 else 0.5
            arcs = [
                self._arc(Role.RIM, centre, radius, low, low + pi * share, 0),
                self._arc(Role.RIM, centre, radius, low + pi * share, low + pi, 1),
            ]
            source = drawn[k].source
            where = next(
                number
                for number, piece in enumerate(path)
                if isinstance(piece, Trace) and piece.segment == middle.segment
            )
            kept = [*drawn[:k], replace(drawn[k], end=s)]
            assert source == kept[-1].source
            return kept, [*path[:where], replace(path[where], end=s)], arcs
        return None

    def find_tight_curves(self) -> None:
        """Add a finding for each stretch that curves more tightly than the wall allows."""
        meridian = self.meridian
        grids = [self.grids[number] for number in meridian.numbers]
        of = np.repeat(np.arange(len(grids)), [len(s) for s in grids])
        s = np.concatenate(grids)
        first, second = (meridian.at_each(of, s, order) for order in (1, 2))
        speed = np.hypot(first[:, 0], first[:, 1])
        still = speed <= 1e-9 * meridian.size
        curvature = cross(first, second) / np.where(still, 1.0, speed) ** 3
        tight = np.flatnonzero(~still & (self.offset * curvature > 1.0 + 1e-9))
        for at in np.split(tight, np.flatnonzero(np.diff(of[tight])) + 1):
            if not len(at):
                continue
            half, k = s[at[len(at) // 2]], int(of[at[0]])
            middle = meridian.curves[k].on(half[None])[0]
            span = (float(s[at[0]]), float(s[at[-1]]))
            span = (1.0 - span[1], 1.0 - span[0]) if meridian.reverse else span
            where = (float(middle[0]), float(middle[1]))
            self.note(TightCurve(where, abs(self.offset), meridian.numbers[k], span))


def closing_lines(path: Sequence[Piece], builder: WallBuilder, role: Role) -> list[Piece]:
    """Return the path with lines put in where consecutive pieces do not meet."""
    ends = ends_of(path)
    gaps = ends[1:, 0] - ends[:-1, 1]
    apart = np.hypot(gaps[:, 0], gaps[:, 1]) > 1e-9 * builder.meridian.size
    result: list[Piece] = [path[0]]
    for k, after in enumerate(path[1:]):
        if apart[k]:
            result.append(builder.line(role, ends[k, 1], ends[k + 1, 0]))
        result.append(after)
    return result


def _runs_back(piece: Piece, u: float) -> bool:
    """Whether the moved curve runs against the drawn one there, as it does within its loops."""
    if not isinstance(piece, Trace):
        return isinstance(piece, Line)
    at = np.array([min(max(u, 1e-6), 1.0 - 1e-6)])
    return bool((piece.velocity(at) * piece.tangents(at)).sum() < 0.0)


def _trace(piece: Piece) -> Trace:
    assert isinstance(piece, Trace)
    return piece
