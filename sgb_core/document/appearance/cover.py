"""Where a layer of the drawing lies: the one source of what is painted and of what is raised.

Rows stand at shares v of the generatrix' length, columns at shares u of the sweep. How soft an
edge is says whoever asks: about a pixel wide for paint, some millimetres wide for relief.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from sgb_core.arrays import Floats
from sgb_core.document.appearance.model import Along, Layer, LayerKind
from sgb_core.lettering.distances import REACH, text_distances
from sgb_core.surfaces.uv import UVMap
from sgb_core.values import dataclass

# Half of the way over which an edge fades, as a part of it.
_HALF = 0.5


@dataclass(frozen=True, slots=True, eq=False)
class Ground:
    """Columns ``u`` (w,) and rows ``v`` (h,) of the unrolled surface.

    ``heights`` (h,) are shares of the whole height, ``segments`` (h,) the rows' segments.
    ``uv_map`` is that of the whole surface, around which there is room for ``around`` such columns.
    """

    u: Floats
    v: Floats
    heights: Floats
    segments: NDArray[np.intp]
    uv_map: UVMap
    around: int

    def measured(self, by: Along) -> Floats:
        """Return the rows' positions as a layer counts them, (h,)."""
        return self.heights if by is Along.HEIGHT else self.v

    def part(self, rows: slice) -> Ground:
        """Return some of the rows."""
        heights, segments = self.heights[rows], self.segments[rows]
        return Ground(self.u, self.v[rows], heights, segments, self.uv_map, self.around)


@dataclass(frozen=True, slots=True, eq=False)
class Edge:
    """How wide the edge of a layer is: in its positions (h,), and in its stripes, (h, 1).

    ``width`` is that on the surface, in the unit. ``borders`` are the shares of the length at which
    segments begin, and 1, with the width of an edge there in shares; None: segments end sharply,
    between two rows.
    """

    along: Floats
    around: Floats
    width: float
    borders: tuple[Floats, float] | None = None


def ground_at(uv_map: UVMap, u: Floats, v: Floats, parts: int = 1) -> Ground:
    """Return the places of columns and rows on an unrolled surface.

    The columns fill one of so many ``parts`` of the sweep.
    """
    last = len(uv_map.borders) - 2
    return Ground(
        u,
        v,
        np.interp(v, uv_map.shares, uv_map.heights),
        np.clip(np.searchsorted(uv_map.borders, v, side="right") - 1, 0, last),
        uv_map,
        len(u) * parts,
    )


def pixel_edge(layer: Layer, ground: Ground) -> Edge:
    """Return an edge as wide as a pixel of a picture with these columns and rows."""
    place = ground.measured(layer.by)
    step = np.abs(np.gradient(place)) if len(place) > 1 else np.ones(1)
    pixel = max(ground.uv_map.width / ground.around, ground.uv_map.length / len(ground.v))
    return Edge(step, np.array([[layer.count / ground.around]]), pixel)


def cover(layer: Layer, ground: Ground, edge: Edge) -> Floats:
    """Return how far a layer covers each place, 0 to 1, shape (h, 1) or (h, w)."""
    if layer.kind is LayerKind.SEGMENTS:
        return _segments(layer, ground, edge)[:, None]
    if layer.kind is LayerKind.TEXT:
        return _text(layer, ground, edge)
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


def _text(layer: Layer, ground: Ground, edge: Edge) -> Floats:
    distances = text_distances(layer.text, layer.font)
    line = text_line(layer, ground.uv_map)
    if distances is None or line is None:
        return np.zeros((len(ground.v), 1))
    low, high = sorted((layer.start, layer.end))
    up = (ground.measured(layer.by) - low) / (high - low)
    if line.falls:
        up = 1.0 - up
    # From the middle of the copy nearest, in parts of the turn.
    turns = layer.count * (ground.u - layer.shift) - _HALF
    aside = (turns - np.round(turns)) / layer.count
    x = distances.middle + aside * line.around / line.height
    rows = np.flatnonzero((up > -1.0) & (up < 2.0))
    covered = np.zeros((len(ground.v), len(ground.u)))
    soft = max(edge.width / line.height, 1e-9)
    # No soft edge is known farther out than distances are.
    soft = min(soft, 2.0 * REACH)
    found = distances.at(x[None, :], up[rows, None])
    covered[rows] = np.clip(_HALF + found / soft, 0.0, 1.0)
    return covered


@dataclass(frozen=True, slots=True)
class TextLine:
    """How a line of text lies: the ``height`` of its capitals and the way ``around``, in the unit.

    ``falls`` says that what its positions count runs downwards there.
    """

    height: float
    around: float
    falls: bool


def text_line(layer: Layer, uv_map: UVMap) -> TextLine | None:
    """Return how a layer's text lies on a surface; None where it has no height or no way around."""
    low, high = sorted((layer.start, layer.end))
    places = uv_map.heights if layer.by is Along.HEIGHT else uv_map.shares
    middle = (low + high) / 2.0
    steps = np.diff(places)
    passed = np.flatnonzero((places[:-1] - middle) * (places[1:] - middle) <= 0.0)
    passed = passed[steps[passed] != 0.0]
    if high <= low or len(passed) == 0:
        return None
    # Where the profile passes the middle of the line more than once, outermost.
    radius = np.abs(uv_map.points[passed, 0])
    at = int(passed[np.argmax(radius)])
    way = float(uv_map.lengths[at + 1] - uv_map.lengths[at])
    height = (high - low) * way / abs(float(steps[at]))
    widest = float(np.abs(uv_map.points[:, 0]).max())
    around = uv_map.width * float(radius.max()) / widest if widest > 0.0 else 0.0
    if height <= 0.0 or around <= 0.0:
        return None
    rises = float(uv_map.points[at + 1, 1] - uv_map.points[at, 1]) * float(steps[at])
    return TextLine(height, around, rises < 0.0)


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
