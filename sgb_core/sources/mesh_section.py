"""The section that most of the turn agrees on: the outer wall of a mesh, foot to rim."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from sgb_core.arrays import Floats
from sgb_core.findings.sources import NoSource
from sgb_core.sources.errors import SourceError
from sgb_core.sources.mesh_edges import with_edges
from sgb_core.sources.mesh_slices import PLANES, Slices
from sgb_core.values import dataclass

# Cells along the larger side of the section, and of the noise one has at least.
_CELLS, _OF_NOISE = 400, 1.5
# Noise is measured down to this part of the size.
_FINE = 5e-4
# What fewer of the half planes show, in parts of what the best place has, is no wall: a handle.
_VOTES = 0.35
# A hollow open to the axis deeper than this part of the height is the inside of a vessel.
_DEEP = 0.4
# A closed section that fills this much of its convex hull is a ring, no wall with a hole.
_RING = 0.5
# What encloses nothing is looked at again with gaps of twice so many cells closed,
_GAPS = (3, 6)
# and is no sheet but parts that do not touch where so many times more is inside than wall.
_ENCLOSES = 3.0
# Surface so many cells from the outline is its own; rounds of moving the outline onto it.
_BAND, _ROUNDS = 3.0, 3
# Cells at an end without surface beyond that are found anew, and looked at for where it ends.
_END, _LOOK = 3, 8
# A mesh that strays by fewer cells has corners of its own.
_CLEAN = 0.3
# Of the outline's length: so much surface within is an inner wall.
_INNER = 0.3
# More of the outermost surface away from the outline than this is no handle, nor what is missing.
_LOOSE = 0.3


@dataclass(frozen=True, slots=True)
class Section:
    """The outer wall (N, 2) as (r, h), foot to rim, and how far the turn departs from it.

    ``rms`` and ``largest`` are departures along its normals, of the surface near the wall; where
    much of the turn has none near it, as a cube has, of the outermost surface. ``wall`` is the
    median thickness and the spread of its middle half, None where there is no inner wall.
    """

    points: Floats
    closed: bool
    rms: float
    largest: float
    wall: tuple[float, float] | None


def section_of(slices: Slices) -> Section:
    """Return the median section of slices.

    Raises SourceError where nothing turns about the axis.
    """
    if not len(slices.ends):
        raise SourceError(NoSource.NO_SIDE)
    low, high = slices.ends.min(axis=(0, 1)), slices.ends.max(axis=(0, 1))
    size = max(float((high - low).max()), float(high[0]))
    noise = slices.noise(size * _FINE)
    cell = max(size / _CELLS, _OF_NOISE * noise)
    if not cell > 0.0:
        raise SourceError(NoSource.ONE_PLACE)
    points, plane = slices.sampled(0.7 * cell)
    votes = _votes(points, plane, float(low[1]), high, cell)
    wall = votes >= _VOTES * float(np.percentile(votes[votes > 0], 98.0))
    solid, ring, lidded = _filled(wall)
    for gap in _GAPS:
        if solid.sum() > _ENCLOSES * wall.sum():
            break
        closer = _filled(_closed(wall, gap))
        if closer[0].sum() > _ENCLOSES * wall.sum():
            solid, ring, lidded = closer
    outline = _outline(solid, ring) * cell + np.array([0.0, float(low[1]) - 2.0 * cell])
    found = _settled(outline, points, plane, cell, ring)
    line, supported, off = found
    if not ring:
        line, off = _cut(line, supported, off, points, plane, cell, lidded)
    rms, largest = _departure(line, off, points, plane, cell)
    if noise <= _CLEAN * cell:
        line = with_edges(line, slices, cell, ring=ring, lidded=lidded)
    inner = _inner_wall(line, points, cell, float(line[:, 1].max())) if not ring else None
    return Section(line, ring, rms, largest, inner)


def _votes(
    points: Floats, plane: NDArray[np.intp], low: float, high: Floats, cell: float
) -> NDArray[np.intp]:
    """Return in how many half planes surface is seen in or beside each cell, (rows, columns)."""
    columns = int(high[0] / cell) + 5
    rows = int((float(high[1]) - low) / cell) + 5
    seen = np.zeros((PLANES, rows, columns), dtype=bool)
    row = ((points[:, 1] - low) / cell + 2.0).astype(np.intp)
    column = (np.maximum(points[:, 0], 0.0) / cell).astype(np.intp)
    for up in (-1, 0, 1):
        for out in (-1, 0, 1):
            seen[plane, row + up, np.maximum(column + out, 0)] = True
    return np.asarray(seen.sum(axis=0))


def _filled(wall: NDArray[np.bool_]) -> tuple[NDArray[np.bool_], bool, bool]:
    """Return what cannot be reached from outside, whether it is a ring, and whether it got a lid.

    Mouth and open foot are closed first: the inside of a vessel is not outside.
    """
    from scipy import ndimage

    def outside(closed: NDArray[np.bool_]) -> NDArray[np.bool_]:
        label, _ = ndimage.label(~closed)
        return np.asarray(label == label[0, -1])

    rows = np.flatnonzero(wall.any(axis=1))
    bottom, top = int(rows[0]), int(rows[-1])
    reached = outside(wall)
    if reached[bottom : top + 1, 0].all():
        solid = ~reached
        if solid.sum() > _RING * _hull_area(solid) and solid.sum() > 1.5 * wall.sum():
            return solid, True, False
    wall = wall.copy()
    lidded = False
    for row, inwards in ((top, -1), (bottom, 1)):
        column = reached[:, 0][row::inwards]
        blocked = np.flatnonzero(~column)
        depth = int(blocked[0]) if len(blocked) else top - bottom
        if depth > _DEEP * (top - bottom):
            wall[row, : int(np.flatnonzero(wall[row])[0])] = True
            lidded = lidded or inwards < 0
            reached = outside(wall)
    return ~reached, False, lidded


def _closed(wall: NDArray[np.bool_], gap: int) -> NDArray[np.bool_]:
    """Return a wall whose parts are joined where they are no more than twice ``gap`` apart."""
    from scipy import ndimage

    wide = np.pad(np.concatenate([wall[:, ::-1], wall], axis=1), gap)
    joined = ndimage.binary_closing(wide, ndimage.generate_binary_structure(2, 1), gap)
    return np.asarray(joined[gap:-gap, gap + wall.shape[1] : -gap])


def _hull_area(solid: NDArray[np.bool_]) -> float:
    from scipy.spatial import ConvexHull

    rows, columns = np.nonzero(solid)
    corners = np.stack([rows, columns], axis=1)
    around = np.concatenate([np.add(corners, (dy, dx)) for dy in (0, 1) for dx in (0, 1)])
    return float(ConvexHull(around).volume)


def _outline(solid: NDArray[np.bool_], ring: bool) -> Floats:
    """Return the outline of the largest solid part in cells, (r, h), anticlockwise from below."""
    from contourpy import contour_generator
    from scipy import ndimage

    label, _ = ndimage.label(solid)
    sizes = np.bincount(label.ravel())
    sizes[0] = 0
    part = (label == int(np.argmax(sizes))).astype(np.float64)
    rows, columns = part.shape
    whole = part if ring else np.concatenate([part[:, ::-1], part], axis=1)
    lines = contour_generator(z=ndimage.gaussian_filter(whole, 1.0)).lines(0.5)
    # Cells have their middles half a cell from their corners.
    shift = np.array([-0.5 if ring else columns - 0.5, -0.5])
    # What does not reach the axis has a mirror image of its own, which is not wanted.
    line = max((each - shift for each in lines), key=lambda each: int((each[:, 0] >= 0.0).sum()))
    line = np.asarray(line[:-1], dtype=np.float64)
    if not ring:
        line = np.roll(line, -int(np.argmin(line[:, 1] + rows * (line[:, 0] > 0.0))), axis=0)
    r, h = line.T
    line = line if float((r * np.roll(h, -1) - np.roll(r, -1) * h).sum()) > 0.0 else line[::-1]
    return line if ring else np.asarray(line[line[:, 0] >= 0.0])


def _settled(
    line: Floats, points: Floats, plane: NDArray[np.intp], cell: float, ring: bool
) -> tuple[Floats, NDArray[np.bool_], Floats]:
    """Return the outline moved onto the surface, where it has one, and each half plane's offset."""
    from scipy.spatial import cKDTree

    for number in range(_ROUNDS):
        line = _even(line, cell, ring)
        normals = _normals(line, cell if number else 2.0 * cell, ring)
        band = _BAND if number == 0 else 0.6 * _BAND
        away, near = cKDTree(line).query(points, distance_upper_bound=(band + 1.0) * cell)
        known = np.isfinite(away)
        near, own = near[known], plane[known]
        offset = ((points[known] - line[near]) * normals[near]).sum(axis=1)
        inside = np.abs(offset) <= band * cell
        key = near[inside] * PLANES + own[inside]
        total = np.bincount(key, offset[inside], len(line) * PLANES)
        count = np.bincount(key, minlength=len(line) * PLANES)
        with np.errstate(invalid="ignore"):
            off = (total / np.where(count, count, np.nan)).reshape(-1, PLANES)
        seen = np.isfinite(off).sum(axis=1)
        supported = seen >= _VOTES * np.percentile(seen, 90.0)
        off[~supported] = np.nan
        shift = np.zeros(len(line))
        shift[supported] = np.nanmedian(off[supported], axis=1)
        line = line + shift[:, None] * normals
        line[:, 0] = np.maximum(line[:, 0], 0.0)
        off = off - shift[:, None]
    return line, supported, off


def _departure(
    line: Floats, off: Floats, points: Floats, plane: NDArray[np.intp], cell: float
) -> tuple[float, float]:
    """Return the rms and the largest departure of the turn from the outline."""
    from scipy.spatial import cKDTree

    row = ((points[:, 1] - points[:, 1].min()) / cell).astype(np.intp)
    place = row * PLANES + plane
    # The last of each place, in order of radius, is the outermost.
    order = np.lexsort((points[:, 0], place))
    outermost = points[order[np.append(np.diff(place[order]) > 0, True)]]
    away, _ = cKDTree(line).query(outermost)
    if np.mean(away > _BAND * cell) > _LOOSE:
        return float(np.sqrt(np.mean(away**2))), float(away.max())
    told = off[np.isfinite(off).any(axis=1)]
    spread = told - np.nanmedian(told, axis=1)[:, None]
    return float(np.sqrt(np.nanmean(spread**2))), float(np.nanmax(np.abs(spread)))


def _cut(
    line: Floats,
    supported: NDArray[np.bool_],
    off: Floats,
    points: Floats,
    plane: NDArray[np.intp],
    cell: float,
    lidded: bool,
) -> tuple[Floats, Floats]:
    """Return the line without what closes mouth and foot, ended where the surface ends."""
    told = np.flatnonzero(supported)
    if len(told) < 4:
        raise SourceError(NoSource.NO_SIDE)
    first, last = int(told[0]), int(told[-1])
    if lidded:
        rim = np.flatnonzero(line[:, 1] >= float(line[told, 1].max()) - 0.5 * cell)
        last = min(last, int(rim[rim >= first][0]))
    ends: list[Floats | None] = [None, None]
    for number, (own, beyond, step) in enumerate(
        ((first, first > 1, 1), (last, last < len(line) - 2, -1))
    ):
        if not beyond:
            continue
        inner = own + step * _END
        inner = min(max(inner, 0), len(line) - 1)
        back = min(max(inner + step * _LOOK, 0), len(line) - 1)
        ends[number] = _end(line[inner], line[back], points, plane, cell)
        first, last = (inner, last) if number == 0 else (first, inner)
    kept, kept_off = line[first : last + 1], off[first : last + 1]
    if ends[0] is not None:
        kept = np.concatenate([[ends[0]], kept])
        kept_off = np.concatenate([kept_off[:1], kept_off])
    if ends[1] is not None:
        kept = np.concatenate([kept, [ends[1]]])
        kept_off = np.concatenate([kept_off, kept_off[-1:]])
    if kept[0, 0] < cell:
        kept[0, 0] = 0.0
    if kept[-1, 0] < cell:
        kept[-1, 0] = 0.0
    return kept, kept_off


def _end(
    inner: Floats, back: Floats, points: Floats, plane: NDArray[np.intp], cell: float
) -> Floats:
    """Return where the surface ends beyond a place, straight on from another before it."""
    onward = (inner - back) / max(float(np.hypot(*(inner - back))), 1e-300)
    off = points - inner
    along = off @ onward
    across = np.abs(off[:, 0] * onward[1] - off[:, 1] * onward[0])
    near = (across < cell) & (np.abs(along) < _LOOK * cell)
    reach = np.full(PLANES, -np.inf)
    np.maximum.at(reach, plane[near], along[near])
    reach = reach[np.isfinite(reach)]
    return np.asarray(inner + (float(np.median(reach)) if len(reach) else 0.0) * onward)


def _inner_wall(
    line: Floats, points: Floats, cell: float, top: float
) -> tuple[float, float] | None:
    """Return the median and spread of the distance of surface inside from the outer wall."""
    from scipy.spatial import cKDTree

    below = points[points[:, 1] < top - _BAND * cell]
    away, near = cKDTree(line).query(below)
    inside = (below[:, 0] < line[near, 0]) & (away > 1.5 * cell)
    if not inside.any() or inside.sum() < _INNER * len(below):
        return None
    low, middle, high = np.percentile(away[inside], [25.0, 50.0, 75.0]).tolist()
    return middle, high - low


def _even(line: Floats, cell: float, ring: bool) -> Floats:
    around = np.concatenate([line, line[:1]]) if ring else line
    apart = np.append(True, np.hypot(*np.diff(around, axis=0).T) > 1e-9 * cell)
    around = around[apart]
    along = np.append(0.0, np.cumsum(np.hypot(*np.diff(around, axis=0).T)))
    marks = np.linspace(0.0, float(along[-1]), max(int(along[-1] / cell), 8) + 1)
    even = np.stack([np.interp(marks, along, around[:, k]) for k in range(2)], axis=1)
    return even[:-1] if ring else even


def _normals(line: Floats, reach: float, ring: bool) -> Floats:
    """Return unit normals to the right of the line, smoothed over ``reach``."""
    from scipy import ndimage

    spacing = float(np.hypot(*np.diff(line, axis=0).T).mean())
    mode = "wrap" if ring else "nearest"
    smooth = ndimage.gaussian_filter1d(line, reach / spacing, axis=0, mode=mode)
    along = np.gradient(smooth, axis=0)
    length = np.hypot(along[:, 0], along[:, 1])
    return (
        np.stack([along[:, 1], -along[:, 0]], axis=1) / np.where(length > 0, length, 1.0)[:, None]
    )
