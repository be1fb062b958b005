"""From a body's outlines to a watertight mesh: rows with exact normals, swept, and end faces."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
import shapely

from sgb_core.arrays import Floats, Ints
from sgb_core.bodies.meridian import SolidError
from sgb_core.bodies.outline import Line, Piece, Ring, Role
from sgb_core.findings.bodies import NoBodyFor
from sgb_core.surfaces.mesh import Mesh, compact
from sgb_core.surfaces.revolution import RevolutionSurface
from sgb_core.surfaces.section import AXIS, MERGE, Section
from sgb_core.surfaces.tessellation import swept_arrays
from sgb_core.surfaces.turn import Turn


@dataclass(frozen=True, slots=True, eq=False)
class Rows:
    """The samples of one piece of an outline: M versions (1, or one per column) of k rows.

    ``points`` (M, k, 2), outward ``normals`` (M, k, 3) on e_ρ, e_θ, e_h.
    """

    role: Role
    points: Floats
    normals: Floats


def rows_of(ring: Ring, size: float, parameters: Callable[[Piece], Floats]) -> list[Rows]:
    """Return the rows of an outline, sampled at the given parameters of each piece."""
    result = []
    for piece in ring:
        u = parameters(piece)
        points, normals = piece.points(u), piece.normals(u)
        points[np.abs(points[:, 0]) <= AXIS * size, 0] = 0.0
        turned = np.stack([normals[:, 0], np.zeros(len(u)), normals[:, 1]], axis=1)
        on_axis = isinstance(piece, Line) and not points[:, 0].any()
        result.append(Rows(Role.AXIS if on_axis else piece.role, points[None], turned[None]))
    return result


def ring_section(rows: Sequence[Rows], size: float) -> Section:
    """Return the section of a closed outline: consecutive pieces share a ring at their corner.

    Stretches along the axis sweep nothing and are left out. Samples closer than 1e-6·size become
    one, so that single precision tells all rows apart.
    """
    merge = MERGE * size
    kept = [thin for piece in rows if (thin := _thinned(piece, merge)) is not None]
    breaks = [k for k, piece in enumerate(kept) if piece.role is Role.AXIS]
    if breaks:
        first = breaks[0]
        kept = [*kept[first + 1 :], *kept[: first + 1]]
    rings: list[Ints] = []
    linked: list[np.ndarray[tuple[int], np.dtype[np.bool_]]] = []
    pieces: list[Rows] = []
    count, fresh = 0, True
    for piece in kept:
        if piece.role is Role.AXIS:
            fresh = True
            continue
        start = count if fresh else count - 1
        rings.append(start + np.arange(piece.points.shape[1]))
        count = int(rings[-1][-1]) + 1
        on_axis = (piece.points[..., 0] == 0.0).all(axis=0)
        linked.extend([np.zeros(min(len(pieces), 1), dtype=bool), ~(on_axis[1:] & on_axis[:-1])])
        pieces.append(piece)
        fresh = False
    if not breaks:
        rings[-1][-1] = 0
    points = np.concatenate([piece.points for piece in pieces], axis=1)
    steps = np.diff(points.mean(axis=0), axis=0)
    lengths = np.concatenate([[0.0], np.cumsum(np.hypot(steps[:, 0], steps[:, 1]))])
    counts = [len(each) for each in rings[:-1]]
    return Section(
        points=points,
        normals=np.concatenate([piece.normals for piece in pieces], axis=1),
        lengths=(lengths / lengths[-1])[None],
        rings=np.concatenate(rings),
        linked=np.concatenate(linked),
        starts=tuple(int(start) for start in np.concatenate([[0], np.cumsum(counts)])),
        merge=merge,
    )


def _thinned(piece: Rows, merge: float) -> Rows | None:
    """Return the piece without samples that no version holds apart, or None if it vanishes."""
    points = piece.points
    last = points.shape[1] - 1
    kept = [0]
    for k in range(1, last):
        if _apart(points, k, kept[-1], merge) and _apart(points, k, last, merge):
            kept.append(k)
    if len(kept) == 1 and not _apart(points, 0, last, merge):
        return None
    kept.append(last)
    return Rows(piece.role, points[:, kept], piece.normals[:, kept])


def _apart(points: Floats, first: int, second: int, merge: float) -> bool:
    step = points[:, first] - points[:, second]
    return bool((np.hypot(step[:, 0], step[:, 1]) > merge).any())


def sweep_rings(
    sections: Sequence[tuple[Section, ...]], turn: Turn, surface: RevolutionSurface, mirrored: bool
) -> Mesh:
    """Return the watertight mesh of outlines: for each part its outer ring and its holes.

    A partial sweep gets its planar end faces. ``mirrored`` puts the outlines on the side r < 0.
    """
    arrays: list[tuple[Floats, Ints, Floats, Floats, Ints]] = []
    position_base = corner_base = 0

    def add(positions: Floats, corners: Ints, normals: Floats, uv: Floats, faces: Ints) -> None:
        nonlocal position_base, corner_base
        arrays.append((positions, corners, normals, uv, faces + corner_base))
        position_base += len(positions)
        corner_base += len(corners)

    for part in sections:
        placed: list[tuple[Section, Ints]] = []
        for section in part:
            turned = _mirrored(section) if mirrored else section
            positions, corners, normals, uv, faces = swept_arrays(turned, turn, surface, False)
            if len(section.points) > 1:
                corners = _varying_corners(section, turn)
            placed.append((section, corners + position_base))
            add(positions, corners.ravel() + position_base, normals, uv, faces)
        if not surface.is_full_turn:
            for end in (0, -1):
                empty = np.zeros((0, 3))
                add(empty, *_end_face(placed, turn, surface, end, mirrored))
    joined = [np.concatenate(parts) for parts in zip(*arrays, strict=True)]
    return compact(joined[0], joined[1], joined[2], joined[3], joined[4])


def _mirrored(section: Section) -> Section:
    return Section(
        section.points * (-1.0, 1.0),
        section.normals * (-1.0, 1.0, 1.0),
        section.lengths,
        section.rings,
        section.linked,
        section.starts,
        section.merge,
    )


def _end_face(
    rings: Sequence[tuple[Section, Ints]],
    turn: Turn,
    surface: RevolutionSurface,
    end: int,
    mirrored: bool,
) -> tuple[Ints, Floats, Floats, Ints]:
    """Return corner positions, normals, UV and triangles of the end face at one end."""
    loops, numbers = [], []
    for section, corners in rings:
        column = corners[:, end]
        # Equal neighbours are the two sides of a corner, or samples welded at this angle only.
        keep = np.append(column[1:] != column[:-1], column[-1] != column[0])
        loops.append(section.points[end if len(section.points) > 1 else 0][keep])
        numbers.append(column[keep])
    points, positions = np.concatenate(loops), np.concatenate(numbers)
    triangles = triangulate(loops)
    low, reach = points.min(axis=0), np.ptp(points, axis=0)
    uv = (points - low) / np.where(reach > 0.0, reach, 1.0)
    side = (1.0 if end else -1.0) * (-1.0 if mirrored else 1.0)
    angle = surface.start + turn.angles[end]
    normal = side * surface.directions(np.array(angle))[1]
    normals = np.broadcast_to(normal, (len(points), 3))
    return positions, normals, uv, triangles[:, ::-1] if end else triangles


def triangulate(loops: Sequence[Floats]) -> Ints:
    """Return triangles, counter-clockwise, of a polygon with holes, over its own vertices.

    ``loops`` are the outer ring and the holes, (k, 2) each; indices count through all of them.
    Raises SolidError where the loops cross.
    """
    polygon = shapely.Polygon(loops[0], [loop for loop in loops[1:] if len(loop) > 2])
    if not polygon.is_valid:
        raise SolidError(NoBodyFor.CROSSING_SAMPLES)
    points = np.concatenate(loops)
    index = {(r + 0.0, h + 0.0): k for k, (r, h) in enumerate(points.tolist())}
    parts = shapely.get_parts(shapely.constrained_delaunay_triangles(polygon))
    corners = shapely.get_coordinates(parts).reshape(-1, 4, 2)[:, :3]
    triangles = np.array(
        [index[r + 0.0, h + 0.0] for r, h in corners.reshape(-1, 2).tolist()], dtype=np.int64
    ).reshape(-1, 3)
    a, b, c = corners[:, 0], corners[:, 1], corners[:, 2]
    turn = (b[:, 0] - a[:, 0]) * (c[:, 1] - a[:, 1]) - (b[:, 1] - a[:, 1]) * (c[:, 0] - a[:, 0])
    triangles[turn < 0.0] = triangles[turn < 0.0][:, ::-1]
    return triangles


def _varying_corners(section: Section, turn: Turn) -> Ints:
    """Return the position numbers (R, C) of a section that varies with the angle."""
    count = turn.welded_count
    numbers = section.rings[:, None] * count + np.arange(count)
    points = section.points[turn.first_of_each]
    poles = (points[..., 0] == 0.0).all(axis=0)
    numbers[poles] = section.rings[poles, None] * count
    welded = _welded_columns(numbers, np.swapaxes(points, 0, 1), section.merge)
    return np.asarray(welded[:, turn.ids])


def _welded_columns(numbers: Ints, points: Floats, merge: float) -> Ints:
    """Return position numbers with rows welded that coincide at single columns.

    ``numbers`` (R, columns) are those of the rows in order round a closed outline, ``points``
    (R, columns, 2). Rows on the axis keep their pole's number.
    """
    result = numbers.copy()
    step = np.diff(points, axis=0)
    close = np.hypot(step[..., 0], step[..., 1]) <= merge
    for column in np.flatnonzero(close.any(axis=0)).tolist():
        own = result[:, column]
        for row in np.flatnonzero(close[:, column]).tolist():
            first, second = own[row], own[row + 1]
            if first != second:
                pole = points[row + 1, column, 0] == 0.0
                own[own == (first if pole else second)] = second if pole else first
    return result
