"""The corners that a mesh itself has along its section, where one slice shows it whole."""

from __future__ import annotations

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.sources.mesh_slices import PLANES, Slices

# In cells: ends this near are one; how far a slice may be from the median section anywhere, how far
# its own ends may be from that one's, and how much lower than the top the rim's corner may be.
_SAME, _NEAR, _ENDS, _LEVEL = 1e-4, 2.0, 5.0, 0.02
# A slice that is one line, of which the median section shows so much, is a sheet and all profile.
_WHOLE, _SHOWN = 0.99, 0.8


def with_edges(line: Floats, slices: Slices, cell: float, *, ring: bool, lidded: bool) -> Floats:
    """Return the one of the slices that shows all of a section, else the section itself.

    ``line`` (N, 2) runs from foot to rim; ``cell`` is what it is exact to. The slice's corners,
    and its ends, are those of the mesh. A sheet, which has no inside, is taken whole: what turns
    under at foot or rim, and eaves, are profile too.
    """
    from scipy.spatial import cKDTree

    for plane in range(0, PLANES, 7):
        own = slices.ends[slices.plane == plane]
        chain = _longest(own, _SAME * cell)
        if chain is None:
            continue
        dense = _dense(chain, 0.5 * cell)
        stray = float(cKDTree(dense).query(line)[0].max())
        if not ring and stray <= _ENDS * cell and _is_sheet(chain, dense, own, line, cell):
            return dense if dense[0, 1] <= dense[-1, 1] else dense[::-1]
        if stray > _NEAR * cell:
            continue
        part = _closed_part(chain) if ring else _part(chain, line, cell, lidded)
        if part is None:
            continue
        dense = _dense(part, 0.5 * cell)
        if float(cKDTree(line).query(dense)[0].max()) <= _ENDS * cell:
            return dense
    return line


def _longest(ends: Floats, reach: float) -> Floats | None:
    """Return the points (M, 2) of the longest chain of segments, ends (N, 2, 2)."""
    if len(ends) < 2:
        return None
    corners, number = _merged(ends.reshape(-1, 2), reach)
    pairs = number.reshape(-1, 2)
    beside: dict[int, list[int]] = {}
    for first, second in pairs[pairs[:, 0] != pairs[:, 1]].tolist():
        beside.setdefault(first, []).append(second)
        beside.setdefault(second, []).append(first)
    best: list[int] = []
    left = set(beside)
    # Open chains begin at their ends; what is left after them goes round.
    for start in sorted(beside, key=lambda corner: len(beside[corner]) != 1):
        if start not in left:
            continue
        chain = [start]
        left.discard(start)
        while following := [corner for corner in beside[chain[-1]] if corner in left]:
            chain.append(following[0])
            left.discard(following[0])
        if len(chain) > 2 and chain[0] in beside[chain[-1]]:
            chain.append(chain[0])
        if len(chain) > len(best):
            best = chain
    return corners[best] if len(best) > 2 else None


def _merged(points: Floats, reach: float) -> tuple[Floats, np.ndarray]:
    """Return the different points, and which of them each one is."""
    from scipy.sparse import coo_array
    from scipy.sparse.csgraph import connected_components
    from scipy.spatial import cKDTree

    pairs = cKDTree(points).query_pairs(reach, output_type="ndarray")
    graph = coo_array((np.ones(len(pairs)), (pairs[:, 0], pairs[:, 1])), (len(points),) * 2)
    count, number = connected_components(graph, directed=False)
    merged = np.empty((count, 2))
    merged[number] = points
    return merged, number


def _is_sheet(chain: Floats, dense: Floats, ends: Floats, line: Floats, cell: float) -> bool:
    """Whether a chain, also given ``dense``, is all that a slice shows, and open like no solid."""
    from scipy.spatial import cKDTree

    # A solid's slice goes round, or from axis to axis; a wall without a floor ends beside itself.
    apart = float(np.hypot(*(chain[-1] - chain[0])))
    if max(chain[0, 0], chain[-1, 0]) <= cell or apart <= _ENDS * cell:
        return False
    whole = float(np.hypot(*(ends[:, 1] - ends[:, 0]).T).sum())
    if float(np.hypot(*np.diff(chain, axis=0).T).sum()) < _WHOLE * whole:
        return False
    return float((cKDTree(line).query(dense)[0] <= _NEAR * cell).mean()) >= _SHOWN


def _closed_part(chain: Floats) -> Floats | None:
    return chain[:-1] if np.array_equal(chain[0], chain[-1]) else None


def _part(chain: Floats, line: Floats, cell: float, lidded: bool) -> Floats | None:
    """Return the part of a chain from the foot to the rim of a section."""
    if np.array_equal(chain[0], chain[-1]):
        start = int(np.argmin(np.hypot(*(chain[:-1] - line[0]).T)))
        chain = np.roll(chain[:-1], -start, axis=0)
    middle = line[len(line) // 4]
    # The foot comes first, and the outer wall next to it.
    away = np.hypot(*(chain - middle).T)
    foot = np.hypot(*(chain - line[0]).T)
    if int(np.argmin(foot)) > int(np.argmin(away)):
        chain = chain[::-1]
        foot = foot[::-1]
    first = int(np.argmin(foot))
    first = 0 if foot[0] <= _ENDS * cell else first
    if lidded:
        top = np.flatnonzero(chain[first:, 1] >= float(chain[:, 1].max()) - _LEVEL * cell)
        last = first + int(top[0])
    else:
        rim = np.hypot(*(chain - line[-1]).T)
        last = len(chain) - 1 if rim[-1] <= _ENDS * cell else int(np.argmin(rim))
    return chain[first : last + 1] if last - first >= 1 else None


def _dense(chain: Floats, step: float) -> Floats:
    """Return a chain with points at most ``step`` apart on its segments."""
    lengths = np.hypot(*np.diff(chain, axis=0).T)
    counts = np.maximum(np.ceil(lengths / step), 1.0).astype(np.intp)
    owner = np.repeat(np.arange(len(counts)), counts)
    part = (np.arange(len(owner)) - (np.cumsum(counts) - counts)[owner]) / counts[owner]
    even = chain[owner] + part[:, None] * np.diff(chain, axis=0)[owner]
    return np.concatenate([even, chain[-1:]])
