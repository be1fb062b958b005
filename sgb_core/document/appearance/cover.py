"""Where a layer of the drawing lies: the one source of what is painted and of what is raised.

Rows stand at shares v of the generatrix' length, columns at shares u of the sweep. How soft an
edge is says whoever asks: about a pixel wide for paint, some millimetres wide for relief.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from sgb_core.arrays import Floats
from sgb_core.document.appearance.model import Along, Layer, LayerKind
from sgb_core.surfaces.uv import UVMap
from sgb_core.values import dataclass

# Half of the way over which an edge fades, as a part of it.
_HALF = 0.5


@dataclass(frozen=True, slots=True, eq=False)
class Ground:
    """Columns ``u`` (w,) and rows ``v`` (h,) of the unrolled surface.

    ``heights`` (h,) are shares of the whole height, ``segments`` (h,) the rows' segments.
    """

    u: Floats
    v: Floats
    heights: Floats
    segments: NDArray[np.intp]

    def measured(self, by: Along) -> Floats:
        """Return the rows' positions as a layer counts them, (h,)."""
        return self.heights if by is Along.HEIGHT else self.v

    def part(self, rows: slice) -> Ground:
        """Return some of the rows."""
        return Ground(self.u, self.v[rows], self.heights[rows], self.segments[rows])


@dataclass(frozen=True, slots=True, eq=False)
class Edge:
    """How wide the edge of a layer is: in its positions (h,), and in its stripes, (h, 1).

    ``borders`` are the shares of the length at which segments begin, and 1, with the width of an
    edge there in shares; None: segments end sharply, between two rows.
    """

    along: Floats
    around: Floats
    borders: tuple[Floats, float] | None = None


def ground_at(uv_map: UVMap, u: Floats, v: Floats) -> Ground:
    """Return the places of columns and rows on an unrolled surface."""
    last = len(uv_map.borders) - 2
    return Ground(
        u,
        v,
        np.interp(v, uv_map.shares, uv_map.heights),
        np.clip(np.searchsorted(uv_map.borders, v, side="right") - 1, 0, last),
    )


def pixel_edge(layer: Layer, ground: Ground) -> Edge:
    """Return an edge as wide as a pixel of a picture with these columns and rows."""
    place = ground.measured(layer.by)
    step = np.abs(np.gradient(place)) if len(place) > 1 else np.ones(1)
    return Edge(step, np.array([[layer.count / len(ground.u)]]))


def cover(layer: Layer, ground: Ground, edge: Edge) -> Floats:
    """Return how far a layer covers each place, 0 to 1, shape (h, 1) or (h, w)."""
    if layer.kind is LayerKind.SEGMENTS:
        return _segments(layer, ground, edge)[:, None]
    place = ground.measured(layer.by)
    low, high = sorted((layer.start, layer.end))
    inside = between(place, low, high, edge.along)
    if layer.kind is LayerKind.RINGS:
        step = (high - low) / layer.count
        half = 0.5 * layer.width * step
        covered = np.zeros_like(place)
        for ring in range(layer.count):
            middle = low + (ring + 0.5) * step
            covered = np.maximum(covered, between(place, middle - half, middle + half, edge.along))
        return covered[:, None]
    if layer.kind is LayerKind.STRIPES:
        return inside[:, None] * _stripes(layer, ground, edge)
    return inside[:, None]


def share_between(layer: Layer, ground: Ground) -> Floats:
    """Return how far each row lies on the way from the lower to the upper position, (h,)."""
    low, high = sorted((layer.start, layer.end))
    place = ground.measured(layer.by)
    return (place - low) / (high - low) if high > low else np.zeros_like(place)


def between(place: Floats, low: float, high: float, soft: Floats) -> Floats:
    """Return how far places lie between two others, fading over ``soft`` at both."""
    soft = np.maximum(soft, 1e-9)
    # What reaches an end covers it wholly.
    rising = np.clip(_HALF + (place - low) / soft, 0.0, 1.0) if low > 0.0 else 1.0
    falling = np.clip(_HALF + (high - place) / soft, 0.0, 1.0) if high < 1.0 else 1.0
    return np.asarray(np.ones_like(place) * rising * falling)


def _stripes(layer: Layer, ground: Ground, edge: Edge) -> Floats:
    turns = layer.count * (ground.u + layer.twist * share_between(layer, ground)[:, None])
    if layer.width >= 1.0:
        return np.ones_like(turns)
    distance = np.abs(turns - np.round(turns)) - layer.width / 2.0
    return np.clip(_HALF - distance / edge.around, 0.0, 1.0)


def _segments(layer: Layer, ground: Ground, edge: Edge) -> Floats:
    if edge.borders is None:
        return np.isin(ground.segments, layer.segments).astype(np.float64)
    borders, soft = edge.borders
    covered = np.zeros_like(ground.v)
    painted = np.isin(np.arange(len(borders) - 1), layer.segments)
    # Neighbours have no edge between them.
    steps = np.diff(np.concatenate([[0], painted.astype(np.int64), [0]]))
    for first, last in zip(np.flatnonzero(steps > 0), np.flatnonzero(steps < 0), strict=True):
        low, high = float(borders[first]), float(borders[last])
        covered = np.maximum(covered, between(ground.v, low, high, np.array(soft)))
    return covered
