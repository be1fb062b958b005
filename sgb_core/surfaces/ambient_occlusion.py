"""The soft light that is left in the hollows of a form and on the ground below it.

The form is coarsened to a few dozen edges for that; what it gives is smooth, so that it may be
interpolated to any grid or mesh. Where laws hold the section at the start angle stands for all.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from math import pi

import numpy as np
import shapely
from numpy.typing import NDArray

from sgb_core.arrays import Floats, between
from sgb_core.surfaces.mesh import Mesh
from sgb_core.surfaces.normals import radius_signs
from sgb_core.surfaces.occlusion_rays import Edges, Floor, ambient_occlusion
from sgb_core.surfaces.revolution import RevolutionSurface
from sgb_core.values import dataclass

# Edges that meet at a smaller angle than this belong to one smooth surface.
_SMOOTH = np.cos(np.radians(30.0))
# Circles of the ground, and angles at which a part turn's ground is looked at.
_CIRCLES, _WAYS = 24, 24
# How much a normal counts beside a place, in sizes of the form, where a mesh looks for its edge.
_NORMAL = 0.1
# Parts of the size to which a section is simplified.
_SIMPLER = 2e-3
# Steps of the size to which corners of a mesh are told apart, and how many are looked up at once.
_STEPS, _ROWS = 1 << 15, 2048
# What faces along the turn more than this is the end face of a part turn.
_END_FACE = 0.7


@dataclass(frozen=True, slots=True)
class RayCounts:
    """Edges in all, least a segment and most; rays around and outward; angles of a part turn.

    Each edge is seen from each, so a chain that would have more than ``most`` shares them out
    along its whole run, whatever its joints.
    """

    edges: int
    least: int
    most: int
    rays: tuple[int, int]
    angles: int


# While the hand moves, and when it rests.
QUICK = RayCounts(32, 4, 64, (8, 6), 5)
FULL = RayCounts(72, 8, 144, (8, 12), 9)


@dataclass(frozen=True, slots=True, eq=False)
class Ground:
    """How bright level ground is at ``height``: shape (circles, angles), as seen from above.

    The circles are at ``distances`` from the axis, the angles go evenly once around from the
    absolute angle ``start``; a full turn has one.
    """

    height: float
    distances: Floats
    brightness: Floats
    start: float = 0.0

    def moved_under(self, edges: Edges) -> Ground:
        """Return the ground as it nearly is below a form that has changed a little."""
        height, distances = _circles(edges)
        return Ground(height, distances, self.brightness, self.start)

    @property
    def floor(self) -> Floor:
        """What is seen of it from the form, all around alike."""
        return Floor(self.height, self.distances, self.brightness.mean(axis=1))


def ground_under(edges: Edges, fineness: RayCounts, start: float = 0.0) -> Ground:
    """Return the ground below a form turned from ``start``, as far as it is shaded."""
    height, distances = _circles(edges)
    full = edges.sweep >= 2.0 * pi
    angles = None if full else np.linspace(0.0, 2.0 * pi, _WAYS, endpoint=False)
    places = np.stack([distances, np.full_like(distances, height)], axis=-1)
    upward = np.broadcast_to([0.0, 1.0], places.shape)
    brightness = ambient_occlusion(edges, places, upward, fineness.rays, angles)
    return Ground(height, distances, brightness, start)


def _circles(edges: Edges) -> tuple[float, Floats]:
    """Return the height of the ground, and the circles on it: dense where the form stands."""
    points = np.concatenate([edges.starts, edges.ends])
    r, h = np.abs(points[:, 0]), points[:, 1]
    low, widest = float(h.min()), float(r.max())
    reach = widest + 0.5 * max(widest, float(np.ptp(h)))
    foot = float(r[h <= low + 0.06 * (h.max() - low)].max())
    apart = np.linspace(-1.0, 1.0, _CIRCLES)
    outward = np.where(apart < 0.0, foot, reach - foot) * apart * np.abs(apart)
    return low, np.maximum(foot + outward, 0.0)


@dataclass(frozen=True, slots=True, eq=False)
class SurfaceLight:
    """The ambient occlusion of both sides of a surface, outer and inner, 1 where none is.

    ``sides`` has the shape (segments, edges, angles, 2), where the edges are shared out along the
    run of all ``segments`` (1, edges, angles, 2).
    """

    edges: Edges
    sides: Floats
    ground: Ground | None
    segments: int

    def on_rows(self, per_segment: int, columns: int) -> Floats:
        """Return it on a sweep grid, shape (rows, columns + 1, 2)."""
        count, here = self.sides.shape[:2]
        if count != self.segments:
            return self._around(self._along_run(per_segment), columns)
        # From the middles of the edges to their ends, straight on beyond the last ones.
        low, beyond = between(np.linspace(-0.5, here - 0.5, per_segment + 1), here)
        part = beyond[:, None, None]
        rows = self.sides[:, low] * (1.0 - part) + self.sides[:, low + 1] * part
        normals = self.edges.normals.reshape(count, here, 2)
        for k in range(count - 1):
            if normals[k, -1] @ normals[k + 1, 0] > _SMOOTH:
                rows[k, -1] = rows[k + 1, 0] = (rows[k, -1] + rows[k + 1, 0]) / 2.0
        return self._around(rows.reshape(-1, *self.sides.shape[2:]), columns)

    def _along_run(self, per_segment: int) -> Floats:
        """Return it on all rows where the edges are shared out, (rows, angles, 2)."""
        here = self.sides.shape[1]
        run = np.arange(self.segments)[:, None] + np.linspace(0.0, 1.0, per_segment + 1)
        low, beyond = between(run.ravel() * (here / self.segments) - 0.5, here)
        part = beyond[:, None, None]
        return np.asarray(self.sides[0, low] * (1.0 - part) + self.sides[0, low + 1] * part)

    def _around(self, rows: Floats, columns: int) -> Floats:
        """Return rows (rows, angles, 2) at the angles of a grid, (rows, columns + 1, 2)."""
        rows = np.clip(rows, 0.0, 1.0)
        if rows.shape[1] == 1:
            return np.repeat(rows, columns + 1, axis=1)
        angles = rows.shape[1]
        low, beyond = between(np.linspace(0.0, angles - 1.0, columns + 1), angles)
        part = beyond[:, None]
        return np.asarray(rows[:, low] * (1.0 - part) + rows[:, low + 1] * part)


def surface_edges(surface: RevolutionSurface, fineness: RayCounts) -> Edges:
    """Return a surface's meridian in as many edges for each segment, or shared out along it."""
    section = surface.section
    each = max(fineness.least, fineness.edges // len(section))
    if each * len(section) > fineness.most:
        run = np.linspace(0.0, float(len(section)), fineness.most + 1)
        number = np.minimum(run.astype(np.intp), len(section) - 1)
        chain = section[number].of_each(run - number)
        return Edges(chain[:-1], chain[1:], surface.sweep)
    points = section.on(np.linspace(0.0, 1.0, each + 1))
    starts, ends = points[:, :-1].reshape(-1, 2), points[:, 1:].reshape(-1, 2)
    return Edges(starts, ends, surface.sweep)


def surface_light(
    surface: RevolutionSurface,
    fineness: RayCounts,
    *,
    grounded: bool,
    wedge: tuple[float, float] | None = None,
) -> SurfaceLight:
    """Return what soft light reaches a surface; ``grounded`` puts it on level ground.

    Between the absolute angles of the ``wedge`` a full turn is left away, and light comes in.
    """
    edges = surface_edges(surface, fineness)
    opened, angles, start = _opened(edges, surface, fineness, wedge)
    ground = ground_under(opened, fineness, start) if grounded else None
    middles, outer = edges.middles, edges.normals * (-1.0 if surface.flips else 1.0)
    # In the half-plane that a point lies in, whatever the sign of its radius.
    mirror = radius_signs(middles[:, 0], edges.size)
    places = np.stack([np.abs(middles[:, 0]), middles[:, 1]], axis=-1)
    # The normal of what runs on the axis' other side is turned twice.
    outer = outer * np.stack([np.ones_like(mirror), mirror], axis=-1)
    found = ambient_occlusion(
        opened,
        np.concatenate([places, places]),
        np.concatenate([outer, -outer]),
        fineness.rays,
        angles,
        None if ground is None else ground.floor,
    )
    sides = np.stack(np.split(found, 2), axis=-1)
    count = len(surface.profile)
    parts = 1 if len(middles) % count or len(middles) // count < fineness.least else count
    return SurfaceLight(edges, sides.reshape(parts, -1, *sides.shape[1:]), ground, count)


def _opened(
    edges: Edges,
    surface: RevolutionSurface,
    fineness: RayCounts,
    wedge: tuple[float, float] | None,
) -> tuple[Edges, Floats | None, float]:
    """Return the edges as they are turned, at which angles to look (None: any), and from where."""
    if not surface.is_full_turn:
        return edges, np.linspace(0.0, surface.sweep, fineness.angles), surface.start
    if wedge is None:
        return edges, None, surface.start
    low, high = wedge
    here = surface.start + np.linspace(0.0, 2.0 * pi, 2 * fineness.angles)
    return replace(edges, sweep=2.0 * pi - (high - low)), np.mod(here - high, 2.0 * pi), high


@dataclass(frozen=True, slots=True, eq=False)
class BodyLight:
    """The ambient occlusion of a body at the middles of its section's ``edges``.

    ``found`` has the shape (edges, angles).
    """

    edges: Edges
    found: Floats
    ground: Ground | None

    def on_corners(self, mesh: Mesh, surface: RevolutionSurface) -> Floats:
        """Return it at the corners of the body's mesh, shape (V,); end faces are open."""
        frame = surface.directions(np.array([surface.start]))[0]
        local = (mesh.positions - np.asarray(surface.placement.translation)) @ frame.T
        local = local[mesh.corner_positions]
        outward, along, up = (mesh.normals @ frame.T).T
        angle = np.arctan2(local[:, 1], local[:, 0])
        weight = _NORMAL * self.edges.size
        # Two edges at one place are told apart by the way they face.
        wanted = np.stack(
            [
                np.hypot(local[:, 0], local[:, 1]),
                local[:, 2],
                weight * (outward * np.cos(angle) + along * np.sin(angle)),
                weight * up,
            ],
            axis=-1,
        )
        known = np.concatenate([self.edges.middles, weight * self.edges.normals], axis=-1)
        places, place_of = _distinct(wanted, self.edges.size)
        edges, apart = _two_nearest(known, places)
        nearest = edges[place_of]
        share = (apart[:, 0] / np.maximum(apart.sum(axis=1), 1e-300))[place_of]
        turn = np.mod(angle, 2.0 * pi) / max(self.edges.sweep, 1e-300)
        values = _around(self.found, turn, nearest)
        found = values[:, 0] * (1.0 - share) + values[:, 1] * share
        across = along * np.cos(angle) - outward * np.sin(angle)
        return np.where(np.abs(across) > _END_FACE, 1.0, found)


def body_light(
    loops: Sequence[Floats],
    surface: RevolutionSurface,
    fineness: RayCounts,
    *,
    grounded: bool,
    wedge: tuple[float, float] | None = None,
) -> BodyLight:
    """Return what soft light reaches the body of a surface with these loops for its section.

    Each loop (k, 2) has the body on the left of its way and repeats no point; where r is negative
    it stands for its mirror image. ``grounded`` and ``wedge`` are as in :func:`surface_light`.
    """
    starts, ends = [], []
    size = max(float(np.ptp(np.concatenate(loops), axis=0).max()), 1e-300)
    for loop in loops:
        right = loop if loop[:, 0].sum() >= 0.0 else loop[::-1] * (-1.0, 1.0)
        ring = shapely.LinearRing(right).simplify(_SIMPLER * size)
        points = shapely.get_coordinates(shapely.segmentize(ring, 4.0 * size / fineness.edges))
        starts.append(points[:-1])
        ends.append(points[1:])
    edges = Edges(np.concatenate(starts), np.concatenate(ends), surface.sweep)
    opened, angles, start = _opened(edges, surface, fineness, wedge)
    ground = ground_under(opened, fineness, start) if grounded else None
    floor = None if ground is None else ground.floor
    found = ambient_occlusion(opened, edges.middles, edges.normals, fineness.rays, angles, floor)
    return BodyLight(edges, found, ground)


def _distinct(rows: Floats, size: float) -> tuple[Floats, NDArray[np.intp]]:
    """Return rows of shape (k, 4) without what repeats around, and which of them each row is."""
    steps = np.rint((rows - rows.min(axis=0)) * (_STEPS / size)).astype(np.int64)
    code = np.zeros(len(rows), dtype=np.int64)
    for column in np.minimum(steps, _STEPS - 1).T:
        code = code * _STEPS + column
    _, first, which = np.unique(code, return_index=True, return_inverse=True)
    return rows[first], which


def _two_nearest(known: Floats, rows: Floats) -> tuple[NDArray[np.intp], Floats]:
    """Return the numbers of the two nearest of ``known`` for each row, and their distances."""
    nearest = np.empty((len(rows), 2), dtype=np.intp)
    apart = np.empty((len(rows), 2))
    for start in range(0, len(rows), _ROWS):
        part = slice(start, start + _ROWS)
        squares = ((rows[part, None] - known) ** 2).sum(axis=-1)
        nearest[part] = np.argsort(squares, axis=1)[:, :2]
        apart[part] = np.sqrt(np.take_along_axis(squares, nearest[part], axis=1))
    return nearest, apart


def _around(found: Floats, turn: Floats, nearest: NDArray[np.intp]) -> Floats:
    """Return values (edges, angles) at shares of the sweep, for edges of shape (V, n)."""
    angles = found.shape[1]
    if angles == 1:
        return np.asarray(found[nearest, 0])
    low, part = between(np.clip(turn, 0.0, 1.0)[:, None] * (angles - 1), angles)
    return np.asarray(found[nearest, low] * (1.0 - part) + found[nearest, low + 1] * part)
