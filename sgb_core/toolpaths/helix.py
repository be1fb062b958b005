"""The wall: one helix from the bed or the floor to the rim, one level turn at its end."""

from __future__ import annotations

from collections.abc import Callable
from math import pi

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.findings.toolpaths import NoPath
from sgb_core.surfaces.curvature import cross
from sgb_core.toolpaths.errors import ToolpathError
from sgb_core.toolpaths.moved_wall import MovedWall
from sgb_core.toolpaths.settings import Plan
from sgb_core.toolpaths.strand import Part, Strand, strand
from sgb_core.values import dataclass

TURN = 2.0 * pi
# The part of a turn in which the path goes over from one bead of the wall to the next.
_RAMP = 1.0 / 16.0
# Heights at which a wall is looked at for its lean, and angles.
_HEIGHTS, _ROWS = 2_000, 48
# Where a twist turns a section by more than this (radians) from turn to turn, the turn below a
# place is not found under it.
_MOST_TWIST = pi / 6.0


@dataclass(frozen=True, slots=True, eq=False)
class Climb:
    """Height by the angle turned: from ``start`` (mm) to ``top``, reached at the angle ``end``.

    ``angles`` and ``heights`` (k,) are places between which it climbs evenly.
    """

    start: float
    top: float
    end: float
    angles: Floats
    heights: Floats

    def at(self, angle: Floats) -> Floats:
        """Return heights; before the first angle it is the start's, after the last the top's."""
        return np.asarray(np.interp(angle, self.angles, self.heights))


def climb(walls: tuple[MovedWall, ...], plan: Plan, start: float, way: float) -> Climb:
    """Return how the wall climbs from the height ``start`` to its rim, or to where it closes.

    One layer in each turn of all its beads, which run round by ``way`` (+1 or −1); where adaptive,
    by as much that the turns are a layer apart along the surface on average, within the printer's
    limits. Raises ToolpathError where a twist turns too far from turn to turn.
    """
    top = _top(walls[-1], plan, start)
    if top - start < 0.5 * plan.layer:
        raise ToolpathError(NoPath.TOO_LOW)
    wall = walls[0].wall
    heights = np.linspace(start, top, _HEIGHTS)
    if plan.wanted.adaptive:
        limits = plan.printer.layer
        lean = _lean(walls[0], heights)
        layers = np.clip(plan.layer / np.sqrt(1.0 + lean**2), limits.least, limits.most)
        slowness = TURN * plan.walls / layers
        steps = np.diff(heights) * (slowness[1:] + slowness[:-1]) / 2.0
        angles = np.concatenate([[0.0], np.cumsum(steps)])
    else:
        heights = heights if wall.twisting is not None else heights[[0, -1]]
        angles = (heights - start) * (TURN * plan.walls / plan.layer)
    # A layer a turn about the axis: what the twist turns on by is no part of the angle.
    turned = wall.turned(heights)
    if (np.abs(np.diff(turned)) > _MOST_TWIST * np.diff(angles) / TURN).any():
        raise ToolpathError(NoPath.TWIST)
    angles = angles - way * (turned - turned[0])
    return Climb(start, top, float(angles[-1]), angles, heights)


def _rows(wall: MovedWall) -> np.ndarray:
    count = len(wall.nodes)
    return np.unique(np.linspace(0, count - 1, min(count, _ROWS)).astype(np.intp))


def _top(wall: MovedWall, plan: Plan, start: float) -> float:
    """Return the height of the rim, or that at which the wall is too narrow for a bead."""
    rim, rows = wall.wall.rim, _rows(wall)
    if rim <= start:
        raise ToolpathError(NoPath.TOO_LOW)
    heights = np.linspace(start, rim, _HEIGHTS)
    radii = np.min([wall.at(heights, np.full(_HEIGHTS, row))[:, 0] for row in rows], axis=0)
    wide = radii >= plan.bead / 2.0
    if wide[-1]:
        return rim
    if not wide.any():
        raise ToolpathError(NoPath.TOO_NARROW)
    return float(heights[np.flatnonzero(wide)[-1]])


def _lean(wall: MovedWall, heights: Floats) -> Floats:
    """Return how far the wall goes sideways per climb, the mean over the turn, shape (k,)."""
    step = (heights[1] - heights[0]) / 2.0
    found = []
    for row in _rows(wall):
        rows = np.full(len(heights), row)
        high = wall.at(np.clip(heights + step, heights[0], heights[-1]), rows)
        low = wall.at(np.clip(heights - step, heights[0], heights[-1]), rows)
        width = np.full(len(heights), 2.0 * step)
        width[[0, -1]] = step
        found.append(np.hypot(*(high - low)[:, :2].T) / width)
    return np.asarray(np.mean(found, axis=0))


@dataclass(frozen=True, slots=True, eq=False)
class Angles:
    """The angles of a turn at which there are points: ``of_turn`` (m,) in [0, 2π), rising.

    The path starts at angle 0 and turns by ``way`` (+1 or −1) times them; ``rows`` says whether
    each has a section of its own.
    """

    of_turn: Floats
    way: float
    varying: bool

    def until(self, end: float) -> tuple[Floats, np.ndarray]:
        """Return all angles turned from 0 to ``end``, and the rows of their sections."""
        turns = int(end // TURN) + 2
        count = len(self.of_turn)
        all_angles = (np.arange(turns)[:, None] * TURN + self.of_turn).ravel()
        rows = np.tile(np.arange(count), turns)
        kept = all_angles <= end + 1e-9
        rows = rows[kept] if self.varying else np.zeros(int(kept.sum()), dtype=np.intp)
        return all_angles[kept], rows

    def place(self, angle: Floats, found: Floats) -> Floats:
        """Return x and y, shape (k, 2), of what :meth:`MovedWall.at` found."""
        theta = self.way * angle + found[:, 2]
        r, aside = np.clip(found[:, 0], 0.0, None), found[:, 1]
        return np.stack(
            [r * np.cos(theta) - aside * np.sin(theta), r * np.sin(theta) + aside * np.cos(theta)],
            axis=-1,
        )


@dataclass(frozen=True, slots=True, eq=False)
class WallPath:
    """The wall's piece, and per point how far it lies sideways of the turn below (mm)."""

    strand: Strand
    steps: Floats
    turns: np.ndarray


def wall_path(
    walls: tuple[MovedWall, ...],
    plan: Plan,
    way_up: Climb,
    angles: Angles,
    checkpoint: Callable[[], None],
) -> WallPath:
    """Return the wall: the helix, then a level turn of each bead, with the flow of its volume.

    The bead's cross-section is its width times the distance along the surface to the turn below;
    it grows from nothing in the first turn and falls to nothing in the last.
    """
    count = len(walls)
    angle, row = angles.until(way_up.end + TURN * count)
    z, below = way_up.at(angle), way_up.at(angle - TURN * count)
    turn = np.minimum(angle // TURN, angle[-1] // TURN).astype(np.intp)
    bead = turn % count
    xy, gap, step = np.empty((len(z), 2)), np.empty(len(z)), np.empty(len(z))
    for k, wall in enumerate(walls):
        checkpoint()
        mine = np.flatnonzero(bead == k)
        places = z[mine], below[mine]
        if angles.varying:
            under = _turn_below(bead, count * len(angles.of_turn), mine)
            xy[mine], gap[mine], step[mine] = _apart_varying(
                wall, angles, (angle[mine], row[mine]), places, under
            )
        else:
            xy[mine], gap[mine], step[mine] = _apart(wall, angles, angle[mine], places)
    if count > 1:
        _go_over(walls, angles, (angle, row, z, turn, bead), xy)
    points = np.column_stack([xy, z])
    layers = (turn // count).astype(np.intp)
    return WallPath(strand(Part.WALL, points, plan.bead * gap, layers), step, turn)


def _apart(
    wall: MovedWall, angles: Angles, angle: Floats, places: tuple[Floats, Floats]
) -> tuple[Floats, Floats, Floats]:
    """Return x and y, distance along the surface and sideways step, where no law holds.

    The distance is the length of the meridian between the heights (z, below) of ``places``.
    """
    z, below = places
    zero = np.zeros(len(z), dtype=np.intp)
    radius = wall.at(z, zero)
    nodes = wall.nodes[0, :, 2]
    between = nodes[(nodes > z[0]) & (nodes < z[-1])]
    extra = wall.at(between, zero[:1].repeat(len(between)))[:, 0]
    heights, first = np.unique(np.concatenate([z, between, below[:1]]), return_index=True)
    start = wall.at(below[:1], zero[:1])[:, 0]
    r = np.concatenate([radius[:, 0], extra, start])[first]
    along = np.concatenate([[0.0], np.cumsum(np.hypot(np.diff(r), np.diff(heights)))])
    gap = np.interp(z, heights, along) - np.interp(below, heights, along)
    step = np.abs(radius[:, 0] - np.interp(below, heights, r))
    return angles.place(angle, radius), gap, step


def _turn_below(bead: np.ndarray, turn: int, mine: np.ndarray) -> np.ndarray:
    """Return which of a bead's places lies ``turn`` places before each of them; −1: none does."""
    number = np.full(len(bead), -1)
    number[mine] = np.arange(len(mine))
    before = mine - turn
    return np.where(before >= 0, number[np.maximum(before, 0)], -1)


def _apart_varying(
    wall: MovedWall,
    angles: Angles,
    at: tuple[Floats, np.ndarray],
    places: tuple[Floats, Floats],
    under: np.ndarray,
) -> tuple[Floats, Floats, Floats]:
    """Return the same where laws hold: the distance is that square to the path.

    ``under`` are the numbers of the places a turn before, −1 where there is none. Richardson's
    step leads from one chord and two to the arc at one angle.
    """
    (angle, row), (z, below) = at, places
    upper = angles.place(angle, wall.at(z, row))
    lower = upper[under]
    first = np.flatnonzero(under < 0)
    lower[first] = angles.place(angle[first], wall.at(below[first], row[first]))
    middle = angles.place(angle, wall.at((z + below) / 2.0, row, exact=False))
    half = (z - below) / 2.0
    halves = _long(upper - middle, half) + _long(middle - lower, half)
    whole = _long(upper - lower, 2.0 * half)
    gap = halves + (halves - whole) / 3.0
    # Where the section is no circle the two turns are not opposite each other at one angle.
    ahead = np.gradient(np.column_stack([upper, z]), axis=0)
    ahead /= np.linalg.norm(ahead, axis=1)[:, None]
    across = (
        np.column_stack([upper - lower, 2.0 * half]) / np.where(whole > 0.0, whole, 1.0)[:, None]
    )
    slant = (ahead * across).sum(axis=1)
    # Sideways is square to the path, as seen from above.
    speed = np.hypot(*ahead[:, :2].T)
    onwards = ahead[:, :2] / np.where(speed > 0.0, speed, 1.0)[:, None]
    return (
        upper,
        gap * np.sqrt(np.clip(1.0 - slant**2, 0.0, 1.0)),
        np.abs(cross(onwards, upper - lower)),
    )


def _long(sideways: Floats, up: Floats) -> Floats:
    return np.asarray(np.sqrt((sideways**2).sum(axis=-1) + up**2))


def _go_over(
    walls: tuple[MovedWall, ...],
    angles: Angles,
    path: tuple[Floats, np.ndarray, Floats, np.ndarray, np.ndarray],
    xy: Floats,
) -> None:
    """Lead the path over from bead to bead at the beginning of each turn but the first."""
    angle, row, z, turn, bead = path
    share = (angle / TURN - turn) / _RAMP
    for k in range(len(walls)):
        crossing = np.flatnonzero((bead == k) & (turn > 0) & (share < 1.0))
        before = walls[(k - 1) % len(walls)]
        left = angles.place(angle[crossing], before.at(z[crossing], row[crossing]))
        part = share[crossing, None]
        xy[crossing] = left + part * (xy[crossing] - left)
