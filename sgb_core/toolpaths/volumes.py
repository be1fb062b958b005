"""What the printed wall and floor hold, by the area of what the beads follow: no sum over moves."""

from __future__ import annotations

from math import pi

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.toolpaths.helix import Angles, Climb
from sgb_core.toolpaths.moved_wall import MovedWall
from sgb_core.toolpaths.settings import Plan
from sgb_core.toolpaths.strand import Strand

_HEIGHTS = 3_001


def printed_volume(
    walls: tuple[MovedWall, ...], plan: Plan, way_up: Climb, angles: Angles, ground: list[Strand]
) -> float:
    """Return the volume of wall and floor in mm³.

    That of a wall's bead is the area of the surface along its middle times its width; the floor
    reaches half a bead beyond the outline that its outermost turn follows.
    """
    heights = np.linspace(way_up.start, way_up.top, _HEIGHTS)
    found = sum(plan.bead * _area(wall, angles, heights) for wall in walls)
    below = 0.0
    for z in sorted({float(piece.points[-1, 2]) for piece in ground}):
        found += (z - below) * _disc(walls[0], angles, z, plan.bead / 2.0)
        below = z
    return float(found)


def _area(wall: MovedWall, angles: Angles, heights: Floats) -> float:
    if not angles.varying:
        nodes = wall.nodes[0, :, 2]
        inside = nodes[(nodes > heights[0]) & (nodes < heights[-1])]
        heights = np.unique(np.concatenate([heights, inside]))
        r = np.clip(wall.at(heights, np.zeros(len(heights), dtype=np.intp))[:, 0], 0.0, None)
        slant = np.hypot(np.diff(r), np.diff(heights))
        return float(pi * ((r[1:] + r[:-1]) * slant).sum())
    few = heights[:: len(heights) // 300]
    grid = _outlines(wall, angles, few)
    level = np.broadcast_to(few[:, None, None], (*grid.shape[:2], 1))
    grid = np.concatenate([grid, level], axis=2)
    along, around = np.diff(grid, axis=0), np.roll(grid, -1, axis=1) - grid
    middle_along = (along + np.roll(along, -1, axis=1)) / 2.0
    middle_around = (around[1:] + around[:-1]) / 2.0
    return float(np.linalg.norm(np.cross(middle_along, middle_around), axis=-1).sum())


def _outlines(wall: MovedWall, angles: Angles, heights: Floats) -> Floats:
    """Return the sections' outlines, shape (heights, angles, 2)."""
    count = len(angles.of_turn)
    rows = np.arange(count) if angles.varying else np.zeros(count, dtype=np.intp)
    many = len(heights)
    found = wall.at(np.repeat(heights, count), np.tile(rows, many))
    return angles.place(np.tile(angles.of_turn, many), found).reshape(many, count, 2)


def _disc(wall: MovedWall, angles: Angles, z: float, beyond: float) -> float:
    """Return the area within a section and a band around it, in mm²."""
    if not angles.varying:
        r = float(wall.at(np.array([z]), np.zeros(1, dtype=np.intp))[0, 0])
        return pi * (r + beyond) ** 2
    ring = _outlines(wall, angles, np.array([z]))[0]
    after = np.roll(ring, -1, axis=0)
    twice = (ring[:, 0] * after[:, 1] - ring[:, 1] * after[:, 0]).sum()
    edge = np.hypot(*(after - ring).T).sum()
    return float(abs(twice) / 2.0 + edge * beyond + pi * beyond**2)
