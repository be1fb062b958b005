"""From the path of a drawing to the sides of a profile: cut at the axis, foot to rim."""

from __future__ import annotations

from collections.abc import Sequence
from math import acos, atan2, degrees, hypot, tau

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.curves.roots import real_roots
from sgb_core.design.tracing.corners import CORNER_DEG
from sgb_core.findings.finding import Finding
from sgb_core.findings.sources import NoSource, Wall
from sgb_core.sources.errors import SourceError
from sgb_core.sources.options import Options
from sgb_core.sources.pieces import Arc, Bezier, Path, Piece, Sampled
from sgb_core.sources.reading import Frame, Half, Reading

# Of the path's width: what counts as on the axis.
_ON_AXIS = 1e-9
# Samples of each piece, and heights at which both sides are compared.
_SAMPLES, _HEIGHTS = 33, 41
# Places along the inside of a wall at which its thickness is measured.
_PLACES = 200
# Sides that differ by less of the width belong to one object, symmetric about its axis.
_SYMMETRIC = 0.08
# Whose middles lie so far beside the middle of all, in parts of the width, is one side: a wall.
_ASIDE = 0.25
# A line to the axis that leans by fewer degrees closes foot or rim; it is no profile.
_CLOSES_DEG = 20.0
# An inner end this far below the top is a floor: what lies between is a wall.
_FLOOR = 0.6
_MIRROR = np.diag([-1.0, 1.0])


def read_path(
    path: Path,
    options: Options,
    axis_line: float | None,
    scale: float,
    notes: Sequence[Finding] = (),
) -> Reading:
    """Return the sides that a path has about the upright axis.

    The path is in the source's coordinates, heights upwards, of which ``scale`` makes the unit.
    The axis, in the same coordinates, is the one asked for, else the one drawn
    (``axis_line``), else the path's own axis of symmetry, else 0. Raises SourceError where the
    path has no side.
    """
    asked = options.upright_axis()
    found = asked if asked is not None else axis_line
    if found is None:
        found = symmetry_axis(path)
    place = 0.0 if found is None else found
    frame = Frame((place, 0.0), scale)
    moved = path.mapped(scale * np.eye(2), np.array([-scale * place, 0.0]))
    low, high = moved.bounds
    width = max(abs(float(low[0])), abs(float(high[0])))
    if width == 0.0:
        raise SourceError(NoSource.ON_AXIS)
    beside = (low[0] > 0.0) == (high[0] > 0.0) and min(abs(low[0]), abs(high[0])) > (
        _ON_AXIS * width
    )
    if moved.closed and beside:
        ring = moved if low[0] > 0.0 else moved.mapped(_MIRROR, np.zeros(2))
        return Reading(_half(ring, True), None, (place,), None, (*notes,), frame)
    sides = {True: _side(moved, True, width), False: _side(moved, False, width)}
    both = all(side is not None for side in sides.values())
    halves: dict[bool, Half | None] = {True: None, False: None}
    said = list(notes)
    for right, side in sides.items():
        if side is None:
            continue
        half = side if right else side.mapped(_MIRROR, np.zeros(2))
        half = _upwards(half)
        if moved.closed:
            half, wall = (half, None) if both else _without_inside(half)
            half = _without_closing_lines(half, width) if both else half
            if wall is not None:
                said.append(Wall(*wall, options.unit.value))
        halves[right] = _half(half, False)
    if halves[True] is None and halves[False] is None:
        raise SourceError(NoSource.NO_SIDE)
    return Reading(halves[True], halves[False], (place,), None, tuple(said), frame)


def _half(path: Path, closed: bool) -> Half:
    corners = tuple(path.corners(_SAMPLES, CORNER_DEG))
    return Half(path.sampled(_SAMPLES), path, closed, corners)


def symmetry_axis(path: Path) -> float | None:
    """Return the abscissa about which a path is symmetric, or None where it is not.

    That of a closed half section with a wall is the edge that its floor ends at.
    """
    points = path.sampled(_SAMPLES)
    low, high = points.min(axis=0), points.max(axis=0)
    width = float(high[0] - low[0])
    heights = np.linspace(float(low[1]), float(high[1]), _HEIGHTS + 2)[1:-1]
    extents = _extents(points, heights, path.closed)
    if len(extents) < _HEIGHTS // 2 or width == 0.0:
        return None
    middles = extents.mean(axis=1)
    axis = float(np.median(middles))
    off = (axis - float(low[0] + high[0]) / 2.0) / width
    if path.closed and abs(off) > _ASIDE:
        edge = float(low[0] if off > 0.0 else high[0])
        if any(_is_upright_at(piece, edge, _ON_AXIS * width) for piece in path.pieces):
            return edge
    # One side only has hardly a width of its own.
    if float(np.median(np.ptp(extents, axis=1))) < 0.1 * width:
        return None
    return axis if float(np.sqrt(((middles - axis) ** 2).mean())) < _SYMMETRIC * width else None


def _is_upright_at(piece: Piece, place: float, within: float) -> bool:
    """Whether a piece is a straight line that stands at an abscissa."""
    return piece.is_line and bool((np.abs(piece.ends[:, 0] - place) <= within).all())


def _extents(points: Floats, heights: Floats, closed: bool) -> Floats:
    """Return the least and greatest abscissa of a path at heights where it has two or more."""
    found = []
    ring = np.concatenate([points, points[:1]]) if closed else points
    for height in heights:
        above = ring[:, 1] > height
        crossing = np.flatnonzero(above[1:] != above[:-1])
        if len(crossing) < 2:
            continue
        start, end = ring[crossing], ring[crossing + 1]
        part = (height - start[:, 1]) / (end[:, 1] - start[:, 1])
        places = start[:, 0] + part * (end[:, 0] - start[:, 0])
        found.append((float(places.min()), float(places.max())))
    return np.array(found).reshape(-1, 2)


def _side(path: Path, right: bool, width: float) -> Path | None:
    """Return the longest run of pieces on one side of r = 0, or None."""
    runs: list[list[Piece]] = [[]]
    for piece in path.pieces:
        for part in _cut_at_axis(piece):
            middle = part.sampled(3)[1]
            apart = abs(float(np.abs(part.sampled(5)[:, 0]).max())) > _ON_AXIS * width
            if apart and (middle[0] > 0.0) == right:
                runs[-1].append(part)
            elif runs[-1]:
                runs.append([])
    if path.closed and len(runs) > 1 and runs[0] and runs[-1]:
        # A closed path may begin in the middle of a side.
        start, end = runs[0][0].ends[0], runs[-1][-1].ends[1]
        if hypot(*(start - end)) <= _ON_AXIS * width:
            runs[0] = [*runs.pop(), *runs[0]]
    runs = [run for run in runs if run]
    if not runs:
        return None
    best = max(runs, key=lambda run: _length(run))
    return Path(tuple(best), False, path.name)


def _length(run: Sequence[Piece]) -> float:
    return float(sum(np.hypot(*np.diff(piece.sampled(9), axis=0).T).sum() for piece in run))


def _cut_at_axis(piece: Piece) -> list[Piece]:
    if isinstance(piece, Bezier):
        coefficients = piece.points[:, 0].tolist()
        places = real_roots(coefficients) if len(coefficients) > 1 else []
    elif isinstance(piece, Arc):
        places = _arc_crossings(piece)
    else:
        places = _sample_crossings(piece)
    parts: list[Piece] = []
    rest, done = piece, 0.0
    for s in (s for s in places if 1e-9 < s < 1.0 - 1e-9):
        before, rest = rest.cut((s - done) / (1.0 - done))
        parts.append(before)
        done = s
    return [*parts, rest]


def _sample_crossings(piece: Sampled) -> list[float]:
    """Return where chords cross r = 0, as parts of the numbers of points."""
    r = piece.points[:, 0]
    before = np.flatnonzero((r[:-1] > 0.0) != (r[1:] > 0.0))
    parts = before + r[before] / (r[before] - r[before + 1])
    return [float(part) for part in parts / (len(r) - 1)]


def _arc_crossings(piece: Arc) -> list[float]:
    """Return where cx + a cos t + b sin t = 0, as parts of the parameter's range."""
    a, b = piece.frame[0].tolist()
    size = hypot(a, b)
    if size == 0.0 or abs(float(piece.center[0])) > size:
        return []
    middle, half = atan2(b, a), acos(-float(piece.center[0]) / size)
    sweep = piece.end - piece.start
    found = []
    for angle in (middle - half, middle + half):
        for turn in range(-2, 3):
            part = (angle + turn * tau - piece.start) / sweep
            if 0.0 < part < 1.0:
                found.append(part)
    return sorted(set(found))


def _upwards(path: Path) -> Path:
    """Return a path from its lower end to its upper one."""
    start, end = path.pieces[0].ends[0], path.pieces[-1].ends[1]
    return path if start[1] <= end[1] else path.reversed()


def _without_closing_lines(path: Path, width: float) -> Path:
    """Return a path without straight, level lines to the axis at its ends."""
    pieces = list(path.pieces)
    for end in (0, -1):
        while len(pieces) > 1:
            piece = pieces[end]
            outer = piece.ends[0 if end == 0 else 1]
            if not piece.is_line or abs(float(outer[0])) > _ON_AXIS * width:
                break
            step = piece.ends[1] - piece.ends[0]
            if degrees(atan2(abs(step[1]), abs(step[0]))) > _CLOSES_DEG:
                break
            pieces.pop(end)
            break
    return Path(tuple(pieces), False, path.name)


def _without_inside(path: Path) -> tuple[Path, tuple[float, float] | None]:
    """Return the outer line of a half section, and the wall's median and spread if it has one.

    The path runs from the axis over foot, rim and inside back to the axis, or is all outside.
    """
    points = path.sampled(_SAMPLES)
    bottom, top = float(points[:, 1].min()), float(points[:, 1].max())
    if points[-1, 1] > bottom + _FLOOR * (top - bottom):
        return path, None
    ends = np.array([piece.ends[1] for piece in path.pieces])
    # The rim ends where the path has climbed as high as it does; its outer corner comes first.
    split = int(np.argmax(ends[:, 1] >= top - 1e-9 * (top - bottom))) + 1
    if split >= len(path.pieces):
        return path, None
    outer = Path(path.pieces[:split], False, path.name)
    inner = _even(Path(path.pieces[split:], False, path.name).sampled(_SAMPLES))
    side = outer.sampled(_SAMPLES)
    inner = inner[inner[:, 1] > inner[:, 1].min() + 0.2 * (top - float(inner[:, 1].min()))]
    gaps = np.array([_gap(side, point) for point in inner])
    low, middle, high = np.percentile(gaps, [25.0, 50.0, 75.0]).tolist()
    return outer, (middle, high - low)


def _even(points: Floats) -> Floats:
    """Return places at equal steps of the length of a line through points."""
    along = np.append(0.0, np.cumsum(np.hypot(*np.diff(points, axis=0).T)))
    marks = np.linspace(0.0, float(along[-1]), _PLACES)
    return np.stack([np.interp(marks, along, points[:, k]) for k in range(2)], axis=1)


def _gap(line: Floats, point: Floats) -> float:
    """Return the distance of a point from a line through points."""
    start, step = line[:-1], np.diff(line, axis=0)
    square = np.maximum((step**2).sum(axis=1), 1e-300)
    part = np.clip(((point - start) * step).sum(axis=1) / square, 0.0, 1.0)
    return float(np.hypot(*(start + part[:, None] * step - point).T).min())
