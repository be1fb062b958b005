"""The outline of the object that a picture shows, its axis, and its two sides."""

from __future__ import annotations

from math import atan, cos, radians, sin, tan

import numpy as np
from numpy.typing import NDArray

from sgb_core.arrays import Floats, Singles
from sgb_core.findings.sources import NoSource
from sgb_core.sources.errors import SourceError
from sgb_core.values import dataclass

# Smoothing before the outline is drawn, in pixels; the least difference of brightness.
_SMOOTH, _CONTRAST = 0.8, 0.08
# Bins of the histogram that the threshold comes from.
_BINS = 256
# An object has at least this part of the picture.
_LEAST_AREA = 1e-4
# What lies so many pixels from the picture's edge is cut by it.
_EDGE = 1.5
# Rounds of the fit of the axis through the middles of rows, and its lean at most.
_ROUNDS, _MOST_LEAN = 30, radians(20.0)
# How often the outline is turned upright by what was found, and looked at again.
_TURNS = 3
# A level line from the axis to the first corner is no profile: its lean at most, how far it may
# be from straight in pixels (or parts of its length), and how much the outline turns after it.
_LEVEL, _STRAIGHT, _STRAIGHT_PART = tan(radians(20.0)), 2.0, 0.01
_CORNER, _LOOK = radians(30.0), 8.0
# So many pixels about a corner smoothing and the picture itself round it off.
_BLUR = 3.0
# A line that is left by so many pixels before its end ends in a bend, not in a corner.
_ROUND = 0.5


@dataclass(frozen=True, slots=True)
class Outline:
    """A closed outline, shape (N, 2), and which of its points lie at the picture's edge.

    ``middle`` is the row half way up the picture: where the axis has its abscissa.
    """

    points: Floats
    at_edge: NDArray[np.bool_]
    middle: float


def largest_outline(grey: Singles, threshold: float | None = None) -> Outline:
    """Return the outline of the largest thing that stands out from the picture's ground.

    ``threshold`` in (0, 1) is how far from the ground's brightness towards the object's the
    outline lies, by default as the histogram divides best (Otsu). Raises SourceError where
    nothing stands out.
    """
    # Imported late: they take a while to load.
    from contourpy import contour_generator
    from scipy import ndimage

    rim = np.concatenate([grey[0], grey[-1], grey[:, 0], grey[:, -1]])
    ground = float(np.median(rim))
    away = np.abs(grey - ground)
    if float(away.max()) < _CONTRAST:
        raise SourceError(NoSource.ONE_COLOUR)
    level = _otsu(away) if threshold is None else threshold * float(away.max())
    # A margin of ground closes what the picture's edge cuts.
    padded = np.pad(away, 2)
    smooth = ndimage.gaussian_filter(padded, _SMOOTH)
    lines = [np.asarray(line) for line in contour_generator(z=smooth).lines(level)]
    areas = [abs(_area(line)) for line in lines]
    if not areas or max(areas) < _LEAST_AREA * grey.size:
        raise SourceError(NoSource.NOTHING_SEEN)
    points = np.asarray(lines[int(np.argmax(areas))], dtype=np.float64) - 2.0
    rows, columns = grey.shape
    x, y = points.T
    edge = (x < _EDGE) | (y < _EDGE) | (x > columns - 1 - _EDGE) | (y > rows - 1 - _EDGE)
    return Outline(points[:-1], edge[:-1], (rows - 1) / 2.0)


def upright(outline: Outline) -> tuple[float, float]:
    """Return the axis of an outline: its abscissa half way up the picture, and its lean.

    The lean is the angle from upright, positive where the axis goes to the right downwards.
    """
    place = lean = 0.0
    points = outline.points - np.array([0.0, outline.middle])
    for _ in range(_TURNS):
        turn = np.array([[cos(lean), -sin(lean)], [sin(lean), cos(lean)]])
        shift, slope = _axis_of_rows((points - np.array([place, 0.0])) @ turn.T)
        place, lean = place + shift / cos(lean), lean + atan(slope)
    return (place, lean) if abs(lean) <= _MOST_LEAN else (place, 0.0)


def _axis_of_rows(points: Floats) -> tuple[float, float]:
    """Return place and slope of the axis that the middles of rows tell, robustly.

    Of a body of radius r(y) whose axis is x = p + s y, the middle of row y is p + s (y + r r').
    """
    y = points[:, 1]
    rows = np.arange(np.ceil(y.min()) + 1.0, np.floor(y.max()))
    if len(rows) < 4:
        raise SourceError(NoSource.NO_HEIGHT)
    left, right = _row_extents(points, rows)
    middles, radii = (left + right) / 2.0, (right - left) / 2.0
    levers = rows + np.gradient(radii**2 / 2.0)
    matrix = np.stack([np.ones_like(levers), levers], axis=1)
    weights = np.ones(len(rows))
    shift = slope = 0.0
    for _ in range(_ROUNDS):
        normal = matrix.T @ (weights[:, None] * matrix)
        shift, slope = np.linalg.solve(normal, matrix.T @ (weights * middles)).tolist()
        off = np.abs(middles - shift - slope * levers)
        scale = max(1.5 * float(np.median(off)), 0.5)
        weights = 1.0 / (1.0 + (off / scale) ** 2)
    return float(shift), float(slope)


def sides_of(outline: Outline) -> tuple[Floats | None, Floats | None, bool]:
    """Return the right and the left side of an upright outline about r = 0, and if one was cut.

    Each is (r, h) with r ≥ 0, shape (N, 2), from foot to rim, without level lines to the axis
    and without what the picture's edge cuts.
    """
    found: list[Floats | None] = []
    cut = False
    for sign in (1.0, -1.0):
        points = outline.points * np.array([sign, 1.0])
        side, at_edge = _run(points, outline.at_edge)
        if side is None:
            found.append(None)
            continue
        cut = cut or bool(at_edge.any())
        for end in (slice(None), slice(None, None, -1)):
            here, there = side[end][[0, -1], 1].tolist()
            first, corner = _level_part(side[end], mouth=here > there)
            side, at_edge = side[end][first:][end], at_edge[end][first:][end]
            if corner is not None:
                side, at_edge = side.copy(), at_edge.copy()
                side[0 if end.step is None else -1] = corner
        # Where a belly is cut the parts above and below it stay.
        side = side[~at_edge]
        if len(side) < 2:
            found.append(None)
            continue
        found.append(side if side[0, 1] <= side[-1, 1] else side[::-1])
    return found[0], found[1], cut


def _otsu(values: Singles) -> float:
    """Return the threshold with the greatest variance between the two classes (Otsu)."""
    counts, edges = np.histogram(values, _BINS)
    middles = (edges[:-1] + edges[1:]) / 2.0
    below = np.cumsum(counts)
    above = below[-1] - below
    sums = np.cumsum(counts * middles)
    with np.errstate(divide="ignore", invalid="ignore"):
        between = below * above * (sums / below - (sums[-1] - sums) / above) ** 2
    between = np.nan_to_num(between)
    # Between two colours all thresholds are equally good: the middle one is taken.
    best = np.flatnonzero(between >= between.max() * (1.0 - 1e-9))
    return float((edges[best[0] + 1] + edges[best[-1] + 1]) / 2.0)


def _area(line: Floats) -> float:
    x, y = line.T
    return 0.5 * float((x[:-1] * y[1:] - x[1:] * y[:-1]).sum())


def _row_extents(points: Floats, rows: Floats) -> tuple[Floats, Floats]:
    """Return the least and greatest abscissa of a closed outline at rows."""
    ring = np.concatenate([points, points[:1]])
    start, end = ring[:-1], ring[1:]
    left, right = np.full(len(rows), np.inf), np.full(len(rows), -np.inf)
    low = np.minimum(start[:, 1], end[:, 1])
    high = np.maximum(start[:, 1], end[:, 1])
    first = np.searchsorted(rows, low, side="left")
    last = np.searchsorted(rows, high, side="right")
    for k in np.flatnonzero(last > first):
        for row in range(int(first[k]), int(last[k])):
            rise = end[k, 1] - start[k, 1]
            part = (rows[row] - start[k, 1]) / rise if rise else 0.0
            x = start[k, 0] + part * (end[k, 0] - start[k, 0])
            left[row], right[row] = min(left[row], x), max(right[row], x)
    good = np.isfinite(left)
    return np.where(good, left, 0.0), np.where(good, right, 0.0)


def _run(points: Floats, at_edge: NDArray[np.bool_]) -> tuple[Floats | None, NDArray[np.bool_]]:
    """Return the longest run with r > 0 of a closed outline, ended on the axis exactly."""
    inside = points[:, 0] > 0.0
    if not inside.any():
        return None, at_edge[:0]
    if inside.all():
        return points, at_edge
    # Begin outside, so that no run goes round the end.
    begin = int(np.flatnonzero(~inside)[0])
    points, at_edge = np.roll(points, -begin, axis=0), np.roll(at_edge, -begin)
    inside = points[:, 0] > 0.0
    borders = np.flatnonzero(np.diff(np.concatenate([[False], inside, [False]]).astype(int)))
    runs = borders.reshape(-1, 2)
    first, last = runs[int(np.argmax(np.ptp(runs, axis=1)))]
    before = _on_axis(points[first - 1], points[first])
    after = _on_axis(points[last - 1], points[last % len(points)])
    side = np.concatenate([[before], points[first:last], [after]])
    edge = np.concatenate([[at_edge[first]], at_edge[first:last], [at_edge[last - 1]]])
    return side, edge


def _on_axis(first: Floats, second: Floats) -> Floats:
    part = first[0] / (first[0] - second[0]) if first[0] != second[0] else 0.0
    return np.array([0.0, first[1] + part * (second[1] - first[1])])


def _level_part(side: Floats, *, mouth: bool) -> tuple[int, Floats | None]:
    """Return with which point a side begins after a level line from the axis, and where that is.

    The line ends at a corner, which the picture's blur rounds off: it lies where the line and
    the side meet. A bottom that bends up smoothly is no line: then 0 and None. Across a ``mouth``
    there is one all the same: up to where the lip bends away from it.
    """
    none: tuple[int, Floats | None] = (0, None)
    if abs(float(side[0, 0])) > _STRAIGHT or len(side) <= 8:
        return none
    along = np.append(0.0, np.cumsum(np.hypot(*np.diff(side, axis=0).T)))
    off = side - side[0]
    reach = np.hypot(off[:, 0], off[:, 1])
    best = 0
    for end in range(2, len(side)):
        if reach[end] < _LOOK:
            continue
        direction = off[end] / reach[end]
        if abs(direction[1]) > _LEVEL * abs(direction[0]):
            break
        across = np.abs(off[: end + 1, 0] * direction[1] - off[: end + 1, 1] * direction[0])
        if across.max() > max(_STRAIGHT, _STRAIGHT_PART * reach[end]):
            break
        best = end
    if best < 2 or best >= len(side) - 2:
        return none
    ahead = int(np.searchsorted(along, along[best] + _LOOK))
    further = int(np.searchsorted(along, along[best] + 2.0 * _LOOK))
    if further >= len(side):
        return none
    line, on = off[best], side[further] - side[ahead]
    turn = abs(np.arctan2(line[0] * on[1] - line[1] * on[0], float(line @ on)))
    if turn < _CORNER:
        return none
    # The straight part reached a little round the corner, which is farthest from the chord.
    back = 2.0 * (_LOOK + _STRAIGHT_PART * reach[best])
    start = int(np.searchsorted(along, along[best] - back))
    chord = side[further] - side[start]
    away = side[start : further + 1] - side[start]
    tip = start + int(np.argmax(np.abs(away[:, 0] * chord[1] - away[:, 1] * chord[0])))
    before = (along >= along[tip] - _LOOK) & (along <= along[tip] - _BLUR)
    after = (along >= along[tip] + _BLUR) & (along <= along[tip] + 2.0 * _LOOK)
    place = _meeting(side[before], side[after], along[after] - along[tip])
    middle = int(np.searchsorted(along, 0.7 * along[tip]))
    level = off[middle] / max(reach[middle], 1e-9)
    from_level = np.abs(off[:, 0] * level[1] - off[:, 1] * level[0])
    if place is None or from_level[before].max() > _ROUND:
        if not mouth:
            return none
        leaves = np.flatnonzero(from_level[middle:] > _ROUND)
        return max(middle + int(leaves[0]) - 1, 1) if len(leaves) else max(tip, 1), None
    return max(int(np.flatnonzero(after)[0]) - 1, 1), place


def _meeting(level: Floats, side: Floats, along: Floats) -> Floats | None:
    """Return where the line through a run of points meets the parabola along another one.

    ``along`` says how far the points of ``side`` are from about there; None for too few points,
    or where they do not meet near it.
    """
    if len(level) < 3 or len(side) < 4:
        return None
    middle = level.mean(axis=0)
    across = np.linalg.svd(level - middle)[2][1]
    powers = np.polynomial.polynomial.polyfit(along, side, 2)
    off = (powers - np.outer([1.0, 0.0, 0.0], middle)) @ across
    roots = np.polynomial.polynomial.polyroots(off)
    near = roots[np.abs(roots.imag) < 1e-9].real
    if not len(near):
        return None
    t = float(near[np.argmin(np.abs(near))])
    return np.asarray(np.polynomial.polynomial.polyval(t, powers)) if abs(t) <= _BLUR else None
