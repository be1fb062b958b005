"""Following a drawn line: the darkest way from click to click."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

import numpy as np

from sgb_core.arrays import Floats, Singles
from sgb_core.fields.kinds import Said
from sgb_core.findings.refusal import Argument
from sgb_core.findings.sources import NoSource
from sgb_core.sources.errors import SourceError

# Smoothing of the ink, and how far a click may be from its line, both in pixels; where there is no
# ink as dark as this within the first reach, the second is looked at.
_SMOOTH, _SNAP, _DARK = 1.0, (12, 30), 0.3
# A step over paper costs so many times a step on ink; the power sharpens the preference for the
# darkest ink, so that grey frames and letters that shine through are left aside.
_PAPER, _SHARPNESS = 40.0, 3.0
# The ways searched reach this part of a leg beyond its ends, and so many pixels at least.
_BEYOND, _AROUND = 0.35, 60
_MOST_NODES = 4_000_000
# The line's middle is sought across it so far, in pixels, along this much of the way.
_ACROSS, _ALONG = 5, 9
# The steps of a way from pixel to pixel are smoothed over so many of them.
_STEPS = 2.0


def follow(grey: Singles, clicks: Sequence[tuple[float, float]]) -> Floats:
    """Return the middle of the ink from click to click, points (x, y) of shape (N, 2).

    ``grey`` is the brightness, shape (rows, columns). Raises SourceError where a click lies
    outside the picture or the legs between them are too long to search.
    """
    # Imported late: it takes a while to load.
    from scipy import ndimage

    rows, columns = grey.shape
    for x, y in clicks:
        if not (-0.5 <= x <= columns - 0.5 and -0.5 <= y <= rows - 0.5):
            raise SourceError(Argument("click", (x, y), Said("a place in the picture")))
    ink = ndimage.gaussian_filter(1.0 - grey, _SMOOTH)
    ink = np.clip((ink - float(np.median(ink))) / (float(ink.max()) or 1.0), 0.0, 1.0)
    if not ink.any():
        raise SourceError(NoSource.ONE_COLOUR)
    marks = [_snapped(ink, click) for click in clicks]
    cost = 1.0 + _PAPER * (1.0 - ink) ** _SHARPNESS
    legs = [_way(cost, start, end) for start, end in pairwise(marks)]
    path = np.concatenate([legs[0], *(leg[1:] for leg in legs[1:])]).astype(np.float64)
    return _centred(ink, path[:, ::-1])


def _snapped(ink: Floats, click: tuple[float, float]) -> tuple[int, int]:
    """Return the (row, column) of the best ink near a click: dark and not far."""
    for reach in _SNAP:
        place = _best_ink(ink, click, reach)
        if ink[place] >= _DARK:
            return place
    return _best_ink(ink, click, _SNAP[0])


def _best_ink(ink: Floats, click: tuple[float, float], reach: int) -> tuple[int, int]:
    column, row = round(click[0]), round(click[1])
    rows, columns = ink.shape
    r0, r1 = max(row - reach, 0), min(row + reach + 1, rows)
    c0, c1 = max(column - reach, 0), min(column + reach + 1, columns)
    y, x = np.mgrid[r0:r1, c0:c1]
    off = np.hypot(y - click[1], x - click[0])
    worth = np.where(off <= reach, ink[r0:r1, c0:c1] - 0.6 * off / reach, -np.inf)
    best = np.unravel_index(int(np.argmax(worth)), worth.shape)
    return r0 + int(best[0]), c0 + int(best[1])


def _way(cost: Floats, start: tuple[int, int], end: tuple[int, int]) -> Floats:
    """Return the cheapest way of 8-neighbours, (row, column) pairs of shape (N, 2)."""
    from scipy.sparse import coo_array
    from scipy.sparse.csgraph import dijkstra

    reach = np.hypot(end[0] - start[0], end[1] - start[1])
    around = int(max(_BEYOND * reach, _AROUND))
    r0, c0 = max(min(start[0], end[0]) - around, 0), max(min(start[1], end[1]) - around, 0)
    part = cost[r0 : max(start[0], end[0]) + around + 1, c0 : max(start[1], end[1]) + around + 1]
    rows, columns = part.shape
    if rows * columns > _MOST_NODES:
        raise SourceError(NoSource.FAR_CLICKS)
    numbers = np.arange(rows * columns).reshape(rows, columns)
    tails, heads, weights = [], [], []
    for dr, dc in ((0, 1), (1, 0), (1, 1), (1, -1)):
        a = numbers[: rows - dr, max(-dc, 0) : columns - max(dc, 0)]
        b = numbers[dr:, max(dc, 0) : columns - max(-dc, 0)]
        tails.append(a.ravel())
        heads.append(b.ravel())
        mean = (part.ravel()[a] + part.ravel()[b]) / 2.0
        weights.append(mean.ravel() * np.hypot(dr, dc))
    size = rows * columns
    graph = coo_array(
        (np.concatenate(weights), (np.concatenate(tails), np.concatenate(heads))), (size, size)
    ).tocsr()
    source = numbers[start[0] - r0, start[1] - c0]
    target = int(numbers[end[0] - r0, end[1] - c0])
    _, before = dijkstra(graph, directed=False, indices=int(source), return_predecessors=True)
    way = [target]
    while way[-1] != source:
        way.append(int(before[way[-1]]))
    found = np.array(way[::-1])
    return np.stack([found // columns + r0, found % columns + c0], axis=1)


def _centred(ink: Floats, path: Floats) -> Floats:
    """Return a path of pixels moved to the middle of the ink across it, ends included."""
    from scipy import ndimage

    smooth = ndimage.uniform_filter1d(path, min(_ALONG, len(path)), axis=0, mode="nearest")
    along = np.gradient(smooth, axis=0)
    length = np.hypot(along[:, 0], along[:, 1])
    length = np.where(length > 0.0, length, 1.0)
    normal = np.stack([along[:, 1], -along[:, 0]], axis=1) / length[:, None]
    offsets = np.linspace(-_ACROSS, _ACROSS, 4 * _ACROSS + 1)
    places = path[:, None, :] + offsets[:, None] * normal[:, None, :]
    dark = ndimage.map_coordinates(ink, [places[..., 1], places[..., 0]], order=1, mode="nearest")
    # Only the ink that hangs together with the path's own counts.
    middle = len(offsets) // 2
    own = dark[:, middle : middle + 1]
    bright = dark < 0.5 * own
    for k in range(1, middle + 1):
        bright[:, middle + k] |= bright[:, middle + k - 1]
        bright[:, middle - k] |= bright[:, middle - k + 1]
    weight = np.where(bright, 0.0, dark)
    weight[:, middle] += 1e-9
    shift = (weight @ offsets) / weight.sum(axis=1)
    shift = ndimage.median_filter(shift, min(_ALONG, len(shift)), mode="nearest")
    centred = path + shift[:, None] * normal
    smoothed = ndimage.gaussian_filter1d(centred, _STEPS, axis=0, mode="nearest")
    # A smoothed line is shorter at its ends, where the clicks are.
    smoothed[[0, -1]] = centred[[0, -1]]
    return np.asarray(smoothed)
