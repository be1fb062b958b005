"""Where the holes of cut-outs lie in a vessel's wall, and why some cannot."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import cached_property
from math import pi

import numpy as np
import shapely
from shapely.geometry.base import BaseGeometry

from sgb_core.arrays import Floats, frozen
from sgb_core.bodies.cut_outs import CutOut
from sgb_core.bodies.hole import DrilledChart, Hole, LaidChart, Sheet
from sgb_core.bodies.hole_pattern import Drawn, Pattern, drawn_of
from sgb_core.bodies.meridian import Meridian, SolidError, meridian_of
from sgb_core.bodies.solid import BodyKind, Solid, WallSide
from sgb_core.findings.cut_outs import HolesTooNear, HoleTooLarge, NoCutOuts, NoRoomForHoles
from sgb_core.surfaces.revolution import RevolutionSurface
from sgb_core.surfaces.sampling import samples_for_tolerance
from sgb_core.values import dataclass

# Samples of each segment by which lengths along the wall are told.
_SAMPLES = 257
# A drilled hole is narrower than this part of the body: a wider one would leave it sideways.
_WIDEST = 0.8
# How far a hole reaches beyond its wall, as a part of it.
_SPARE = 0.1
# Of the size: how far the sides of what is laid on a wall may always be from it.
_WITHIN = 2.5e-4
# Angles at which a wall that varies is looked up, at most.
_MOST_COLUMNS = 720


@dataclass(frozen=True, slots=True, eq=False)
class _Wall:
    """A meridian by its length from foot to rim: ``lengths`` (k,), ``points`` and ``tangents``."""

    meridian: Meridian
    lengths: Floats
    points: Floats
    tangents: Floats

    def at(self, length: Floats) -> tuple[Floats, Floats]:
        """Return points and unit tangents, (k, 2) each, at lengths from the foot."""
        points = np.stack([np.interp(length, self.lengths, each) for each in self.points.T], axis=1)
        along = np.stack(
            [np.interp(length, self.lengths, each) for each in self.tangents.T], axis=1
        )
        return points, along / np.hypot(*along.T)[:, None]

    def above(self, height: float) -> float:
        """Return the length at which the wall first rises above a height."""
        beyond = np.flatnonzero(self.points[:, 1] > height)
        return float(self.lengths[beyond[0]]) if len(beyond) else float(self.lengths[-1])

    def around(self, level: float, height: float) -> Floats:
        """Return points of the wall about a level, (33, 2), over a height along it."""
        return self.at(np.linspace(level - height / 2.0, level + height / 2.0, 33))[0]


@dataclass(eq=False)
class _Walls:
    """The walls of a body at angles from the start; one for all where no laws hold."""

    surface: RevolutionSurface
    made: dict[float | None, _Wall]

    def at(self, theta: float) -> _Wall:
        """Return the wall at an angle."""
        key = theta if self.surface.laws else None
        if key not in self.made:
            self.made[key] = _wall(self.surface, key)
        return self.made[key]

    def near(self, theta: float) -> _Wall:
        """Return the wall at the column nearest to an angle."""
        columns = self.columns
        if len(columns) == 1:
            return self.at(0.0)
        place = round(theta % self.surface.sweep / float(columns[1]))
        return self.at(float(columns[place]))

    @cached_property
    def columns(self) -> Floats:
        """Return the angles at which a wall that varies is looked up, even steps."""
        if not self.surface.laws:
            return np.zeros(1)
        limit = _WITHIN * self.surface.profile.size
        count = min(samples_for_tolerance(self.surface, limit)[1], _MOST_COLUMNS)
        return np.linspace(0.0, self.surface.sweep, count + 1)


def _wall(surface: RevolutionSurface, theta: float | None) -> _Wall:
    meridian = meridian_of(surface, None if theta is None else surface.sections(theta))
    s = np.linspace(0.0, 1.0, _SAMPLES)
    points = meridian.curves.on(s).reshape(-1, 2)
    tangents = meridian.curves.tangents_on(s, meridian.size).reshape(-1, 2)
    steps = np.hypot(*np.diff(points, axis=0).T)
    return _Wall(meridian, frozen(np.concatenate([[0.0], np.cumsum(steps)])), points, tangents)


def holes(
    surface: RevolutionSurface,
    solid: Solid,
    patterns: Sequence[Pattern],
    within: float | None = None,
) -> tuple[Hole, ...]:
    """Return all holes of the patterns, their outlines ``within`` so much of what was asked for.

    Raises SolidError for a body without a wall, and where a pattern would pierce rim or foot,
    leaves too little between its holes, or asks for holes too wide for the body.
    """
    if not patterns:
        return ()
    if solid.kind is not BodyKind.VESSEL:
        raise SolidError(NoCutOuts.NO_VESSEL)
    walls = _Walls(surface, {})
    if walls.at(0.0).meridian.closed:
        raise SolidError(NoCutOuts.RING)
    found: list[Hole] = []
    near = max(_WITHIN * surface.profile.size, within or 0.0)
    for number, pattern in enumerate(patterns):
        drawn = drawn_of(pattern, number, surface.is_full_turn, _lean(surface), within)
        layout = _Layout(walls, solid, pattern.cut_out, drawn, number, near)
        laid = pattern.cut_out.shape.is_drawn
        found += layout.laid() if laid else layout.drilled()
    return tuple(found)


@dataclass(frozen=True, slots=True, eq=False)
class _Layout:
    """A pattern on the walls of a body, the sides of bent holes ``within`` so much of theirs."""

    walls: _Walls
    solid: Solid
    cut_out: CutOut
    drawn: Drawn
    number: int
    within: float

    @property
    def step(self) -> float:
        """The angle from one place of a row to the next."""
        return self.walls.surface.sweep / self.cut_out.around

    def angles(self, row: int) -> list[float]:
        """Return the angles from the start of the places of a row."""
        shifted = self.cut_out.stagger and row % 2 == 1
        angles = self.step * (np.arange(self.cut_out.around) + (1.0 if shifted else 0.5))
        if shifted and not self.walls.surface.is_full_turn:
            angles = angles[:-1]
        return [float(angle) for angle in angles]

    def drilled(self) -> Iterator[Hole]:
        """Yield straight holes; raises SolidError as :func:`holes` does."""
        surface = self.walls.surface
        width, height = self.drawn.extent
        for row in range(self.cut_out.rows):
            for place, angle in enumerate(self.angles(row)):
                wall = self.walls.at(angle)
                if surface.laws or (row == 0 and place == 0):
                    levels = self.levels(wall)
                if surface.laws or place == 0:
                    radius = float(wall.around(levels[row], height)[:, 0].min())
                    if width > _WIDEST * 2.0 * radius:
                        raise SolidError(HoleTooLarge(self.number, row, width, 2.0 * radius))
                    chord = 2.0 * radius * np.sin(min(self.step, pi) / 2.0)
                    beside = chord if self.cut_out.around > 1 else np.inf
                    self.check_bridges(wall, row, levels, radius, beside)
                yield self.drill(wall, float(levels[row]), angle)

    def laid(self) -> Iterator[Hole]:
        """Yield the holes of shapes that follow the wall; raises SolidError as above."""
        columns = self.walls.columns
        walls = [self.walls.at(float(theta)) for theta in columns]
        levels = np.array([self.levels(wall) for wall in walls])
        height = self.drawn.extent[1]
        for row in range(self.cut_out.rows):
            near = [
                wall.around(level, height)
                for wall, level in zip(walls, levels[:, row], strict=True)
            ]
            # Wherever else it lies it is wider, and so are its bridges.
            radius = float(min(points[:, 0].min() for points in near))
            if radius <= 0.0:
                raise SolidError(HoleTooLarge(self.number, row, self.drawn.extent[0], 0.0))
            for wall, level in zip(walls, levels, strict=True):
                self.check_bridges(wall, row, level, radius, radius * self.step)
            sheet = self.sheet(walls, levels[:, row])
            for angle in self.angles(row):
                yield from self.lay(sheet, radius, angle)

    def levels(self, wall: _Wall) -> Floats:
        """Return how far from the foot the middles of the rows lie, along the wall."""
        meridian, solid = wall.meridian, self.solid
        low = meridian.lowest if meridian.foot_on_axis else float(meridian.foot[1])
        floor = low + (solid.base if solid.side is WallSide.INSIDE else 0.0)
        start = wall.above(floor) + self.cut_out.foot_margin
        end = float(wall.lengths[-1]) - self.cut_out.rim_margin
        height = self.drawn.extent[1]
        if end - start < height:
            raise SolidError(NoRoomForHoles(self.number, height, end - start))
        if self.cut_out.rows == 1:
            return np.array([(start + end) / 2.0])
        return np.linspace(start + height / 2.0, end - height / 2.0, self.cut_out.rows)

    def check_bridges(
        self, wall: _Wall, row: int, levels: Floats, radius: float, beside: float
    ) -> None:
        """Raise SolidError where a row's holes are too near to each other or to the next row's.

        ``beside`` is how far the next hole of the row lies, infinite where there is none.
        """
        shifts = [(beside, 0.0)] if np.isfinite(beside) else []
        if row + 1 < len(levels):
            (here, above), _ = wall.at(levels[row : row + 2])
            rise = float(np.hypot(*(above - here)))
            least = min(radius, float(above[0]))
            aside = 2.0 * least * np.sin(min(self.step, pi) / 4.0) if self.cut_out.stagger else 0.0
            shifts.append((aside, rise))
        twisting = self.walls.surface.twisting
        lean = 0.0 if twisting is None else radius * twisting.steepest()
        for shift in shifts:
            bridge = _gap(self.drawn.union, shift, lean)
            if bridge < self.cut_out.bridge or bridge <= 0.0:
                raise SolidError(HolesTooNear(self.number, row, bridge, self.cut_out.bridge))

    def drill(self, wall: _Wall, level: float, angle: float) -> Hole:
        """Return one straight hole at a level and an angle."""
        surface, solid = self.walls.surface, self.solid
        (point,), (tangent,) = wall.at(np.array([level]))
        low, high = self.reach(point, tangent, level, angle)
        spare = _SPARE * solid.wall
        inner, outer = spare - low, spare + high
        if solid.side is WallSide.INSIDE:
            inner += solid.wall
        else:
            outer += solid.wall
        chart = DrilledChart(surface, _side(wall), angle, point, tangent)
        # A twist bends what was straight.
        step = 0.0 if surface.twisting is None else _step(float(point[0]), self.within)
        return Hole(self.drawn.outlines[0], self.cut_out.shape, chart, inner, outer, step)

    def reach(
        self, point: Floats, tangent: Floats, level: float, angle: float
    ) -> tuple[float, float]:
        """Return how far the wall goes below and above the plane of a hole, within its outline."""
        width, height = self.drawn.extent
        # What bulges between the places looked at lies within the spare.
        turns = np.arcsin(np.clip(width / 2.0 / point[0], 0.0, 1.0)) * np.linspace(-1.0, 1.0, 9)
        normal = np.array([tangent[1], -tangent[0]])
        found = []
        for turn in turns:
            places = self.walls.near(angle + float(turn)).around(level, height)
            found.append((places * (np.cos(turn), 1.0) - point) @ normal)
        return float(np.min(found)), float(np.max(found))

    def lay(self, sheet: Sheet, radius: float, angle: float) -> Iterator[Hole]:
        """Yield the pieces of one shape that follows the wall, its middle at an angle."""
        surface, solid = self.walls.surface, self.solid
        step = _step(radius, self.within)
        # A chord of the ends may cut across a crease.
        spare = _SPARE * solid.wall + step / 2.0 * sheet.steepest
        inner = spare + (solid.wall if solid.side is WallSide.INSIDE else 0.0)
        outer = spare + (solid.wall if solid.side is WallSide.OUTSIDE else 0.0)
        chart = LaidChart(surface, _side(self.walls.at(0.0)), angle, radius, sheet)
        for outline in self.drawn.outlines:
            yield Hole(outline, self.cut_out.shape, chart, inner, outer, step)

    def sheet(self, walls: Sequence[_Wall], levels: Floats) -> Sheet:
        """Return the walls about a row, whose middle lies at the ``levels`` (K,) along each."""
        half = self.drawn.extent[1] / 2.0
        y = np.linspace(-half, half, _SAMPLES)
        found = [wall.at(level + y) for wall, level in zip(walls, levels, strict=True)]
        points = np.stack([each[0] for each in found])
        along = np.stack([each[1] for each in found])
        normals = np.stack([along[..., 1], -along[..., 0]], axis=-1)
        return Sheet(points, normals, self.walls.surface.sweep, -half, half)


def _side(wall: _Wall) -> float:
    return -1.0 if wall.meridian.mirrored else 1.0


def _step(radius: float, within: float) -> float:
    """Return the longest chord that stays within a distance of a circle of a radius."""
    return float(np.sqrt(8.0 * radius * within))


def _lean(surface: RevolutionSurface) -> float:
    """Return by how much at most a twist moves around what is higher by one."""
    if surface.twisting is None:
        return 0.0
    (low, _), (high, _) = surface.profile.bounds()
    return surface.twisting.steepest() * float(max(abs(low), abs(high)))


def _gap(shape: BaseGeometry, shift: tuple[float, float], lean: float) -> float:
    """Return how far a shape is from itself shifted; where they overlap, minus their width.

    Both lean by so much around for each unit up.
    """
    leaning = np.array([[1.0, 0.0], [lean, 1.0]])
    first, moved = (
        shapely.transform(shape, lambda points, by=by: (points + by) @ leaning)
        for by in ((0.0, 0.0), shift)
    )
    gap = float(shapely.distance(first, moved))
    if gap > 0.0:
        return gap
    return -float(np.sqrt(first.intersection(moved).area))
