"""From a surface to a mesh: equal angles, exact normals, welded seam, poles and joints."""

from __future__ import annotations

import numpy as np

from sgb_core.arrays import Floats, Ints
from sgb_core.findings.errors import FindingError
from sgb_core.findings.relief import ReliefMeets
from sgb_core.findings.surfaces import NoSurface
from sgb_core.surfaces.deviation import deviation
from sgb_core.surfaces.displacement import Relief
from sgb_core.surfaces.fineness import Fineness
from sgb_core.surfaces.meeting import meeting
from sgb_core.surfaces.mesh import UNKNOWN, Mesh, Topology, compact, topology
from sgb_core.surfaces.revolution import RevolutionSurface
from sgb_core.surfaces.sampling import check_triangle_count, samples_for_tolerance
from sgb_core.surfaces.section import MERGE, Section, section_of
from sgb_core.surfaces.turn import Spacing, Turn, closed_up, turn_of

# Columns that stand for all: of two, a step there and one back would be alike.
_FEW = 5

__all__ = [
    "deviation",
    "samples_for_tolerance",
    "sweep",
    "swept_arrays",
    "tessellate",
    "topology_of",
]


def tessellate(
    surface: RevolutionSurface,
    *,
    tolerance: float | None = None,
    samples: tuple[int, int] | None = None,
    spacing: Spacing = "angle",
    relief: Relief | None = None,
) -> Mesh:
    """Return the mesh of a surface, oriented outward, every normal exact; with its relief.

    ``tolerance`` (in the profile's unit, default 1e-3 of its size) bounds the distance to the true
    surface; ``samples`` = (NS, NT) fixes NS intervals per segment and NT over the sweep instead.
    ``spacing`` "rational" places columns at equal steps of t, (24), instead of equal angles. UV: u
    is the share of the sweep, v that of the section's length.

    Raises FindingError, a ValueError, where both are given, where there is no surface (all points
    coincide), for too few intervals, and for more than 20 million triangles.

    >>> cylinder = sgb.Document(sgb.Profile.of([sgb.line((10, 0), (10, 60))]))
    >>> mesh = sgb.tessellate(cylinder.surface, samples=(4, 32))
    >>> len(mesh.triangles), mesh.is_watertight
    (256, False)
    """
    wanted = Fineness(tolerance, samples)
    size = surface.profile.size
    if samples is not None:
        per_segment, columns = samples
        counts: tuple[int, ...] = (per_segment,) * len(surface.profile)
        merge = MERGE * size
    else:
        limit = wanted.within(size)
        counts, columns = samples_for_tolerance(surface, limit, spacing)
        # Finer than a tenth of the tolerance, yet coarse enough for single precision.
        merge = min(max(0.1 * limit, 0.12 * MERGE * size), MERGE * size)
    if relief is None:
        check_triangle_count(sum(counts), columns)
    reach = float(np.abs(surface.profile.control_points[..., 0]).max())
    surface = closed_up(surface, reach, merge)
    turn = turn_of(surface, columns, spacing, None if relief is None else relief.columns)
    section = section_of(surface, counts, turn, merge, relief)
    if relief is not None:
        relief.check_count(len(section.rings), len(turn.angles))
    return sweep(section, turn, surface, relief)


def sweep(
    section: Section, turn: Turn, surface: RevolutionSurface, relief: Relief | None = None
) -> Mesh:
    """Return the mesh of any section turned about the axis of ``surface``.

    The surface gives axis, angles, placement and which side is out; its profile is not used
    otherwise. Seam, poles, corners and coincident rows are welded; triangles that would have no
    area are left out.
    """
    flip = surface.flips
    positions, corners, normals, uv, triangles = swept_arrays(section, turn, surface, flip, relief)
    if flip:
        np.negative(normals, out=normals)
    arrays = (positions, corners.ravel(), normals, uv, triangles)
    mesh = compact(*arrays, topology_of(section, turn))
    if len(mesh.triangles) == 0:
        raise FindingError(NoSurface.ON_AXIS)
    return mesh


def swept_arrays(
    section: Section,
    turn: Turn,
    surface: RevolutionSurface,
    flip: bool,
    relief: Relief | None = None,
) -> tuple[Floats, Ints, Floats, Floats, Ints]:
    """Return positions, corner positions (R, C), normals, UV and triangles of a swept section.

    Triangles face along ∂S/∂θ × ∂S/∂s, with ``flip`` the other way; normals are as the section has
    them. Some triangles may repeat a position, some positions go unused.
    """
    first_rows, first_columns = np.unique(section.rings, return_index=True)[1], turn.first_of_each
    if relief is None and surface.twisting is None:
        # Each position once, and nothing to be copied.
        directions = surface.directions(surface.start + turn.angles)
        points = section.points[:, first_rows]
        points = points if len(points) == 1 else points[first_columns]
        positions = _swept(points, directions[first_columns, ::2])
        positions += surface.placement.translation
        normals = _swept(section.normals, directions)
    else:
        places, normals = _placed(section, turn, surface)
        if relief is not None:
            smooth = places
            places, normals = relief.displaced(section, turn, places, normals, flip)
            depth = relief.heights.source.reach[1]
            height = meeting(smooth, places, surface, depth) if depth > 0.0 else None
            if height is not None:
                raise FindingError(ReliefMeets(depth, height))
        positions = places[first_rows][:, first_columns]
    uv = np.empty((*normals.shape[:2], 2))
    uv[..., 0] = turn.fraction
    uv[..., 1] = np.clip(section.lengths, 0.0, 1.0).T
    triangles = _triangles(section, turn, flip)
    corners = _welded(section, turn)
    return positions.reshape(-1, 3), corners, normals.reshape(-1, 3), uv.reshape(-1, 2), triangles


def topology_of(section: Section, turn: Turn) -> Topology:
    """Return what is known of the mesh of a section swept all round.

    Where no law holds all columns are alike, and a few of them tell as much as all.
    """
    around = turn.welded_count
    whole = np.append(np.arange(around), 0)
    alike = len(section.points) == 1 and bool(turn.linked.all())
    if not alike or len(turn.ids) != around + 1 or (turn.ids != whole).any():
        return UNKNOWN
    count = min(around, _FEW)
    few = Turn(
        angles=np.zeros(count + 1),
        ids=np.append(np.arange(count), 0),
        sides=np.ones(count + 1),
        linked=np.ones(count, dtype=np.bool_),
        fraction=np.zeros(count + 1),
        step=0.0,
    )
    corners = _welded(section, few).ravel()
    positions = count * (int(section.rings.max()) + 1)
    return topology(_triangles(section, few, False), corners, positions)


def _placed(section: Section, turn: Turn, surface: RevolutionSurface) -> tuple[Floats, Floats]:
    """Return points and normals in space, shape (R, C, 3) each."""
    moved = np.asarray(surface.placement.translation)
    angles = surface.start + turn.angles
    if surface.twisting is None:
        directions = surface.directions(angles)
        return _swept(section.points, directions[:, ::2]) + moved, _swept(
            section.normals, directions
        )
    # Versions (1 or one per column), rows: every place has an angle of its own.
    columns = (len(angles), section.points.shape[1])
    places = np.broadcast_to(section.points, (*columns, 2))
    leaning = surface.twisting.normals(section.normals, section.points)
    directions = surface.directions(surface.turned(angles[:, None], places[..., 1]))
    points = np.einsum("crk,crkx->rcx", places, directions[..., ::2, :])
    normals = np.einsum("crk,crkx->rcx", np.broadcast_to(leaning, (*columns, 3)), directions)
    return points + moved, normals


def _swept(section: Floats, directions: Floats) -> Floats:
    """Return components of shape (M, R, k) on per-column vectors (C, k, 3), shape (R, C, 3)."""
    if len(section) == 1:
        around = np.swapaxes(directions, 0, 1).reshape(section.shape[-1], -1)
        swept: Floats = (section[0] @ around).reshape(-1, *directions.shape[::2])
        return swept
    return np.ascontiguousarray(np.swapaxes(section @ directions, 0, 1))


def _welded(section: Section, turn: Turn) -> Ints:
    """Return the position number of every corner, shape (R, C)."""
    count = turn.welded_count
    numbers = section.rings[:, None] * count + np.arange(count)
    points = section.points if len(section.points) == 1 else section.points[turn.first_of_each]
    on_axis = points[..., 0] == 0.0
    poles = on_axis.all(axis=0) & (np.ptp(points[..., 1], axis=0) <= section.merge)
    numbers[poles] = section.rings[poles, None] * count
    if len(points) > 1:
        _weld_samples(numbers, np.swapaxes(points, 0, 1), section)
    return np.asarray(numbers[:, turn.ids])


def _weld_samples(numbers: Ints, points: Floats, section: Section) -> None:
    """Weld, column by column, samples of one piece that coincide at that angle only.

    From both ends of each piece inwards, so that rings shared with others stay as they are.
    ``numbers`` has shape (R, columns), ``points`` (R, columns, 2).
    """
    stops = [start - 1 for start in section.starts[1:]] + [len(points) - 1]
    for start, stop in zip(section.starts, stops, strict=True):
        middle = (start + stop) // 2
        anchors: list[Floats] = []
        for way in (range(start, middle), range(stop, middle + 1, -1)):
            anchor = points[way.start].copy()
            for row in way:
                after = row + way.step
                close = _close(points[after], anchor, section.merge)
                numbers[after] = np.where(close, numbers[row], numbers[after])
                anchor = np.where(close[:, None], anchor, points[after])
            anchors.append(anchor)
        # Where the two ways meet, the number of an end must survive.
        for column in np.flatnonzero(_close(anchors[0], anchors[1], section.merge)):
            kept, dropped = numbers[middle, column], numbers[middle + 1, column]
            if dropped == numbers[stop, column]:
                kept, dropped = dropped, kept
            inside = numbers[start : stop + 1, column]
            inside[inside == dropped] = kept


def _close(
    first: Floats, second: Floats, merge: float
) -> np.ndarray[tuple[int], np.dtype[np.bool_]]:
    step = first - second
    return np.asarray(np.hypot(step[:, 0], step[:, 1]) <= merge)


def _triangles(section: Section, turn: Turn, flip: bool) -> Ints:
    columns = len(turn.angles)
    row = np.flatnonzero(section.linked)[:, None]
    corner = row * columns + np.flatnonzero(turn.linked)
    triangles = np.empty((*corner.shape, 2, 3), dtype=np.int64)
    # Steps from a quad's first corner to those of its two triangles.
    steps = ((0, 1, columns + 1), (0, columns + 1, columns))
    for half, around in enumerate(steps):
        for place, step in enumerate(around[::-1] if flip else around):
            np.add(corner, step, out=triangles[..., half, place])
    return triangles.reshape(-1, 3)
