"""Where the holes of cut-outs lie in a vessel's wall, and why some cannot."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from math import pi

import numpy as np
import shapely

from sgb_core.arrays import Floats, frozen
from sgb_core.bodies.cut_outs import CutOut, HoleShape
from sgb_core.bodies.meridian import Meridian, SolidError, meridian_of
from sgb_core.bodies.solid import BodyKind, Solid, WallSide
from sgb_core.findings.cut_outs import HolesTooNear, HoleTooLarge, NoCutOuts, NoRoomForHoles
from sgb_core.surfaces.revolution import RevolutionSurface
from sgb_core.values import dataclass

# Samples of each segment by which lengths along the wall are told.
_SAMPLES = 257
# A hole is narrower than this part of the body: a wider one would leave the wall sideways.
_WIDEST = 0.8


@dataclass(frozen=True, slots=True, eq=False)
class Hole:
    """A prism through the wall: ``outline`` (k, 2) in the plane of ``across`` and ``up``.

    ``centre``, ``across``, ``up`` and ``out`` (3,) are placed; it reaches from ``inner`` behind the
    centre to ``outer`` before it, along ``out``.
    """

    outline: Floats
    shape: HoleShape
    centre: Floats
    across: Floats
    up: Floats
    out: Floats
    inner: float
    outer: float


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


def _wall(surface: RevolutionSurface, theta: float | None) -> _Wall:
    meridian = meridian_of(surface, None if theta is None else surface.sections(theta))
    s = np.linspace(0.0, 1.0, _SAMPLES)
    points = meridian.curves.on(s).reshape(-1, 2)
    tangents = meridian.curves.tangents_on(s, meridian.size).reshape(-1, 2)
    steps = np.hypot(*np.diff(points, axis=0).T)
    return _Wall(meridian, frozen(np.concatenate([[0.0], np.cumsum(steps)])), points, tangents)


def holes(surface: RevolutionSurface, solid: Solid, cut_outs: Sequence[CutOut]) -> tuple[Hole, ...]:
    """Return all holes of the patterns.

    Raises SolidError for a body without a wall, and where a pattern would pierce rim or foot,
    leaves too little between its holes, or asks for holes too wide for the body.
    """
    if not cut_outs:
        return ()
    if solid.kind is not BodyKind.VESSEL:
        raise SolidError(NoCutOuts.NO_VESSEL)
    walls: dict[float | None, _Wall] = {}

    def wall_at(theta: float) -> _Wall:
        key = theta if surface.laws else None
        if key not in walls:
            walls[key] = _wall(surface, key)
        return walls[key]

    if wall_at(0.0).meridian.closed:
        raise SolidError(NoCutOuts.RING)
    return tuple(
        hole
        for number, pattern in enumerate(cut_outs)
        for hole in _pattern(surface, solid, pattern, number, wall_at)
    )


def _pattern(
    surface: RevolutionSurface,
    solid: Solid,
    pattern: CutOut,
    number: int,
    wall_at: Callable[[float], _Wall],
) -> list[Hole]:
    outline, found = frozen(pattern.outline()), []
    step = surface.sweep / pattern.around
    for row in range(pattern.rows):
        shifted = pattern.stagger and row % 2 == 1
        angles = step * (np.arange(pattern.around) + (1.0 if shifted else 0.5))
        if shifted and not surface.is_full_turn:
            angles = angles[:-1]
        for place, angle in enumerate(angles.tolist()):
            wall = wall_at(angle)
            if surface.laws or (row == 0 and place == 0):
                levels = _levels(wall, solid, pattern, number)
            if surface.laws or place == 0:
                _check_row(wall, pattern, number, row, levels, step)
            found.append(_hole(surface, solid, pattern, outline, wall, levels[row], angle))
    return found


def _levels(wall: _Wall, solid: Solid, pattern: CutOut, number: int) -> Floats:
    """Return how far from the foot the middles of the rows lie, along the wall."""
    meridian = wall.meridian
    inside = solid.side is WallSide.INSIDE
    low = meridian.lowest if meridian.foot_on_axis else float(meridian.foot[1])
    floor = low + (solid.base if inside else 0.0)
    start = wall.above(floor) + pattern.foot_margin
    end = float(wall.lengths[-1]) - pattern.rim_margin
    height = pattern.extent[1]
    if end - start < height:
        raise SolidError(NoRoomForHoles(number, height, end - start))
    if pattern.rows == 1:
        return np.array([(start + end) / 2.0])
    return np.linspace(start + height / 2.0, end - height / 2.0, pattern.rows)


def _check_row(
    wall: _Wall, pattern: CutOut, number: int, row: int, levels: Floats, step: float
) -> None:
    """Raise SolidError where a row's holes are too wide, or too near to each other or the next."""
    width, height = pattern.extent
    low, high = levels[row] - height / 2.0, levels[row] + height / 2.0
    radius = float(wall.at(np.linspace(low, high, 33))[0][:, 0].min())
    if width > _WIDEST * 2.0 * radius:
        raise SolidError(HoleTooLarge(number, row, width, 2.0 * radius))
    shape = shapely.Polygon(pattern.outline())
    beside = 2.0 * radius * np.sin(min(step, pi) / 2.0) if pattern.around > 1 else np.inf
    shifts = [(beside, 0.0)] if np.isfinite(beside) else []
    if row + 1 < len(levels):
        (here, above), _ = wall.at(levels[row : row + 2])
        rise = float(np.hypot(*(above - here)))
        least = min(radius, float(above[0]))
        aside = 2.0 * least * np.sin(min(step, pi) / 4.0) if pattern.stagger else 0.0
        shifts.append((aside, rise))
    for shift in shifts:
        bridge = _gap(shape, shift)
        if bridge < pattern.bridge or bridge <= 0.0:
            raise SolidError(HolesTooNear(number, row, bridge, pattern.bridge))


def _gap(shape: shapely.Polygon, shift: tuple[float, float]) -> float:
    """Return how far a shape is from itself shifted; where they overlap, minus their width."""
    moved = shapely.transform(shape, lambda points: points + shift)
    gap = float(shapely.distance(shape, moved))
    if gap > 0.0:
        return gap
    return -float(np.sqrt(shape.intersection(moved).area))


def _hole(
    surface: RevolutionSurface,
    solid: Solid,
    pattern: CutOut,
    outline: Floats,
    wall: _Wall,
    level: float,
    angle: float,
) -> Hole:
    width, height = pattern.extent
    (point,), (tangent,) = wall.at(np.array([level]))
    normal = np.array([tangent[1], -tangent[0]])
    around = wall.at(np.linspace(level - height / 2.0, level + height / 2.0, 33))[0]
    bulge = float(np.abs((around - point) @ normal).max())
    r = float(point[0])
    sag = r - np.sqrt(max(r * r - width * width / 4.0, 0.0))
    spare = 0.1 * solid.wall
    inner, outer = sag + bulge + spare, bulge + spare
    if solid.side is WallSide.INSIDE:
        inner += solid.wall
    else:
        outer += solid.wall + sag
    side = -1.0 if wall.meridian.mirrored else 1.0
    radial, turned, axial = surface.directions(np.array(surface.start + angle))
    radial, turned = side * radial, side * turned
    centre = point[0] * radial + point[1] * axial + np.asarray(surface.placement.translation)
    up, out = (pair[0] * radial + pair[1] * axial for pair in (tangent, normal))
    return Hole(outline, pattern.shape, centre, turned, up, out, inner, outer)
