"""From a body's outlines to a watertight mesh: rows with exact normals, swept, and end faces."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace

import numpy as np
import shapely

from sgb_core.arrays import Floats, Ints
from sgb_core.bodies.cross_section import CrossSection
from sgb_core.bodies.helicoid import on_helicoid
from sgb_core.bodies.meridian import SolidError
from sgb_core.bodies.outer_face import OuterFace
from sgb_core.bodies.outline import Line, Piece, Ring, Role
from sgb_core.bodies.region import parameters
from sgb_core.findings.bodies import NoBodyFor
from sgb_core.surfaces.displacement import Relief
from sgb_core.surfaces.mesh import UNKNOWN, Mesh, Topology, compact
from sgb_core.surfaces.revolution import RevolutionSurface
from sgb_core.surfaces.section import AXIS, MERGE, Rows, Section, joined, snapped, thinned
from sgb_core.surfaces.tessellation import swept_arrays, topology_of
from sgb_core.surfaces.turn import Turn
from sgb_core.values import dataclass


@dataclass(frozen=True, slots=True, eq=False)
class PieceRows(Rows):
    """The rows of one piece of an outline, whose normals point outward."""

    role: Role


def piece_rows(
    role: Role, points: Floats, normals: Floats, size: float, shares: Floats | None = None
) -> PieceRows:
    """Return the rows of samples (M, k, 2) with normals (M, k, 3) and ``shares`` of the length.

    Radii within 1e-9·size of the axis become 0; lengths are those of the versions' mean, by chords.
    """
    steps = np.diff(points.mean(axis=0), axis=0)
    lengths = np.concatenate([[0.0], np.cumsum(np.hypot(steps[:, 0], steps[:, 1]))])
    return PieceRows(snapped(points, size), normals, lengths[None], role, shares=shares)


def rows_of(
    ring: Ring,
    size: float,
    parameters: Callable[[Piece], Floats],
    face: OuterFace | None = None,
) -> list[PieceRows]:
    """Return the rows of an outline, sampled at the given parameters of each piece.

    With a ``face`` they know where on it they lie.
    """
    result = []
    for piece in ring:
        u = parameters(piece)
        normals = piece.normals(u)
        turned = np.stack([normals[:, 0], np.zeros(len(u)), normals[:, 1]], axis=1)
        shares = None if face is None else face.shares(piece.role, piece.place, u)
        rows = piece_rows(piece.role, piece.points(u)[None], turned[None], size, shares)
        if isinstance(piece, Line) and not rows.points[..., 0].any():
            rows = replace(rows, role=Role.AXIS)
        result.append(rows)
    return result


def ring_section(rows: Sequence[PieceRows], size: float) -> Section:
    """Return the section of a closed outline: consecutive pieces share a ring at their corner.

    Stretches along the axis sweep nothing and are left out. Samples closer than 1e-6·size become
    one, so that single precision tells all rows apart.
    """
    merge = MERGE * size
    kept = [thin for piece in rows if (thin := thinned(piece, merge))]
    breaks = [k for k, piece in enumerate(kept) if piece.role is Role.AXIS]
    if breaks:
        first = breaks[0]
        kept = [*kept[first + 1 :], *kept[: first + 1]]
    pieces: list[PieceRows] = []
    shared: list[bool] = []
    for k, piece in enumerate(kept):
        if piece.role is Role.AXIS:
            continue
        begins = kept[k - 1].role is Role.AXIS
        ends = kept[(k + 1) % len(kept)].role is Role.AXIS
        if pieces:
            shared.append(not begins)
        pieces.append(_on_axis(piece, begins, ends))
    return joined(pieces, shared, not breaks, merge)


def _on_axis(piece: PieceRows, begins: bool, ends: bool) -> PieceRows:
    """Return a piece whose ends beside the axis lie on it: what led there may have vanished."""
    if not ((begins and piece.points[:, 0, 0].any()) or (ends and piece.points[:, -1, 0].any())):
        return piece
    points = piece.points.copy()
    if begins:
        points[:, 0, 0] = 0.0
    if ends:
        points[:, -1, 0] = 0.0
    return replace(piece, points=points)


def loop_of(rows: Sequence[PieceRows], version: int, size: float) -> Floats:
    """Return a ring's points in one version, each corner once."""
    points = np.concatenate([piece.points[version, :-1] for piece in rows])
    steps = points - np.roll(points, 1, axis=0)
    return np.asarray(points[np.hypot(steps[:, 0], steps[:, 1]) > AXIS * size])


def are_simple(loops: Sequence[Floats]) -> bool:
    """Whether a part's outer ring and holes, sampled, neither cross nor vanish."""
    if min(map(len, loops)) < 3:
        return False
    return bool(shapely.Polygon(loops[0], list(loops[1:])).is_valid)


def thick_parts(
    parts: Sequence[list[list[PieceRows]]], versions: Iterable[int], size: float
) -> list[list[list[PieceRows]]]:
    """Return the parts whose two sides a mesh can tell apart in one of the ``versions``.

    Raises SolidError where there is none.
    """
    kept = [
        part for part in parts if any(_is_thick(loop_of(part[0], k, size), size) for k in versions)
    ]
    if not kept:
        raise SolidError(NoBodyFor.TOO_FLAT)
    return kept


def _is_thick(loop: Floats, size: float) -> bool:
    if len(loop) < 3:
        return False
    ring = shapely.Polygon(loop)
    return bool(2.0 * ring.area > MERGE * size * ring.length)


def widest(section: CrossSection) -> float:
    """Return the largest distance of the body from the axis, in unit."""
    return max(
        float(np.abs(piece.points(parameters(piece, section.grids))[:, 0]).max())
        for outline in section.outlines
        for piece in outline.exterior
    )


def sweep_rings(
    sections: Sequence[tuple[Section, ...]],
    turn: Turn,
    surface: RevolutionSurface,
    mirrored: bool,
    relief: Relief | None = None,
) -> Mesh:
    """Return the watertight mesh of outlines: for each part its outer ring and its holes.

    A partial sweep gets its end faces, which follow a twist. ``mirrored`` puts the outlines on the
    side r < 0. Their outer face is moved by a ``relief``.
    """
    arrays: list[tuple[Floats, Ints, Floats, Floats, Ints]] = []
    position_base = corner_base = 0
    same: dict[int, int] = {}

    def add(positions: Floats, corners: Ints, normals: Floats, uv: Floats, faces: Ints) -> None:
        nonlocal position_base, corner_base
        # What was made for this alone is numbered in place.
        faces += corner_base
        arrays.append((positions, corners, normals, uv, faces))
        position_base += len(positions)
        corner_base += len(corners)

    for part in sections:
        placed: list[tuple[Section, Ints]] = []
        for section in part:
            turned = _mirrored(section) if mirrored else section
            positions, corners, normals, uv, faces = swept_arrays(
                turned, turn, surface, False, relief
            )
            if len(section.points) > 1:
                corners = _varying_corners(section, turn)
            corners += position_base
            placed.append((section, corners))
            add(positions, corners.ravel(), normals, uv, faces)
        if not surface.is_full_turn:
            for end in (0, -1):
                add(*_end_face(placed, turn, surface, end, mirrored, same, position_base))
    positions, corners, normals, uv, faces = (
        np.concatenate(parts) if len(parts) > 1 else parts[0] for parts in zip(*arrays, strict=True)
    )
    if same:
        number = np.arange(len(positions))
        number[list(same)] = list(same.values())
        corners = number[corners]
    known = UNKNOWN
    if surface.is_full_turn:
        # Rings share no positions.
        each = [topology_of(section, turn) for part in sections for section in part]
        sure = all(one.closed is not None for one in each)
        closed = all(one.closed for one in each) if sure else None
        known = Topology(closed, whole=all(one.whole for one in each))
    return compact(positions, corners, normals, uv, faces, known)


def _mirrored(section: Section) -> Section:
    return replace(
        section, points=section.points * (-1.0, 1.0), normals=section.normals * (-1.0, 1.0, 1.0)
    )


def _end_face(
    rings: Sequence[tuple[Section, Ints]],
    turn: Turn,
    surface: RevolutionSurface,
    end: int,
    mirrored: bool,
    same: dict[int, int],
    base: int,
) -> tuple[Floats, Ints, Floats, Floats, Ints]:
    """Return new positions, corner positions, normals, UV and triangles of one end face.

    A twisted one is a helicoid: places inside it are new, numbered from ``base``. Where its
    outlines touch, one position of each face is to stand for all there: ``same`` is told which for
    which.
    """
    loops, numbers = [], []
    for section, corners in rings:
        column = corners[:, end]
        # Equal neighbours are the two sides of a corner, or samples welded at this angle only.
        keep = np.append(column[1:] != column[:-1], column[-1] != column[0])
        loops.append(section.points[end if len(section.points) > 1 else 0][keep])
        numbers.append(column[keep])
    points, positions = np.concatenate(loops), np.concatenate(numbers)
    triangles = triangulate(loops)
    there: dict[tuple[float, float], int] = {}
    for (r, h), position in zip(points.tolist(), positions.tolist(), strict=True):
        kept = there.setdefault((r + 0.0, h + 0.0), position)
        kept, position = same.get(kept, kept), same.get(position, position)
        if kept != position:
            same[position] = kept
    count, angle = len(points), surface.start + turn.angles[end]
    way = (-1.0 if mirrored else 1.0, 1.0)
    if surface.twisting is not None:
        near = MERGE * surface.profile.size
        finest = max(turn.step, 1e-3)
        points, triangles = on_helicoid(points, triangles, surface.twisting, finest, near)
        positions = np.append(positions, base + np.arange(len(points) - count))
    low, reach = points.min(axis=0), np.ptp(points, axis=0)
    uv = (points - low) / np.where(reach > 0.0, reach, 1.0)
    side = (1.0 if end else -1.0) * way[0]
    places = points * way
    frames = surface.directions(surface.turned(np.full(len(points), angle), places[:, 1]))
    flat = np.broadcast_to((0.0, side, 0.0), (len(points), 3))
    if surface.twisting is not None:
        flat = surface.twisting.normals(flat, places)
    normals = np.einsum("pk,pkx->px", flat, frames)
    inside = np.einsum("pk,pkx->px", places[count:], frames[count:, ::2])
    new = inside + np.asarray(surface.placement.translation)
    return new, positions, normals, uv, triangles[:, ::-1] if end else triangles


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
    kept = frozenset(numbers[poles, 0].tolist())
    welded = _welded_columns(numbers, np.swapaxes(points, 0, 1), section.merge, kept)
    return np.asarray(welded[:, turn.ids])


def _welded_columns(numbers: Ints, points: Floats, merge: float, poles: frozenset[int]) -> Ints:
    """Return position numbers with rows welded that coincide at single columns.

    ``numbers`` (R, columns) are those of the rows in order round a closed outline, ``points``
    (R, columns, 2). What is welded to a pole takes its number, one of ``poles``.
    """
    result = numbers.copy()
    step = np.diff(points, axis=0)
    close = np.hypot(step[..., 0], step[..., 1]) <= merge
    for column in np.flatnonzero(close.any(axis=0)).tolist():
        own = result[:, column]
        for row in np.flatnonzero(close[:, column]).tolist():
            first, second = own[row], own[row + 1]
            if first != second:
                kept, dropped = (second, first) if second in poles else (first, second)
                own[own == dropped] = kept
    return result
