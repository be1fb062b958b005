"""A mesh cut by half planes through its axis: points of its section, half plane by half plane."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from sgb_core.arrays import Floats, Ints
from sgb_core.sources.mesh_axis import AxisLine
from sgb_core.values import dataclass

PLANES = 60
# Triangles that the axis passes through, or nearly, may cross all half planes.
_WIDE = 0.9 * np.pi
_CHUNK = 1_000_000


@dataclass(frozen=True, slots=True)
class Slices:
    """Segments of the sections: ends (N, 2, 2) as (r, h), and the half plane of each, (N,)."""

    ends: Floats
    plane: NDArray[np.intp]

    def sampled(self, step: float) -> tuple[Floats, NDArray[np.intp]]:
        """Return points at most ``step`` apart on all segments, (M, 2), and their planes, (M,)."""
        length = np.hypot(*(self.ends[:, 1] - self.ends[:, 0]).T)
        counts = np.ceil(length / step).astype(np.intp) + 1
        owner = np.repeat(np.arange(len(counts)), counts)
        first = np.cumsum(counts) - counts
        part = (np.arange(len(owner)) - first[owner]) / np.maximum(counts[owner] - 1, 1)
        start, end = self.ends[owner, 0], self.ends[owner, 1]
        return start + part[:, None] * (end - start), self.plane[owner]

    def noise(self, step: float) -> float:
        """Return how far sections usually are from others, measured at places ``step`` apart."""
        from scipy.spatial import cKDTree

        points, plane = self.sampled(step)
        found = []
        for first in range(0, PLANES, 7):
            own, other = points[plane == first], points[plane == (first + PLANES // 3) % PLANES]
            if len(own) and len(other):
                found.append(float(np.median(cKDTree(other).query(own)[0])))
        return float(np.median(found)) if found else 0.0


def sliced(vertices: Floats, faces: Ints, axis: AxisLine) -> Slices:
    """Return the sections of a mesh by half planes at equal angles about the axis."""
    places = (vertices - axis.point) @ axis.frame().T
    angle = np.arctan2(places[:, 1], places[:, 0])
    found = [
        _crossings(places, angle, faces[start : start + _CHUNK])
        for start in range(0, len(faces), _CHUNK)
    ]
    return Slices(
        np.concatenate([ends for ends, _ in found]), np.concatenate([p for _, p in found])
    )


def _crossings(places: Floats, angle: Floats, faces: Ints) -> tuple[Floats, NDArray[np.intp]]:
    three = angle[faces]
    # Unwrapped about the first corner, so that a triangle across ±π spans what it does.
    three = three[:, :1] + np.angle(np.exp(1j * (three - three[:, :1])))
    low, high = three.min(axis=1), three.max(axis=1)
    wide = high - low > _WIDE
    step = 2.0 * np.pi / PLANES
    # Half planes lie between the angles at which meshes usually have their corners.
    first = np.ceil(low / step - 0.5).astype(np.intp)
    last = np.floor(high / step - 0.5).astype(np.intp)
    first, last = np.where(wide, 0, first), np.where(wide, PLANES - 1, last)
    counts = np.maximum(last - first + 1, 0)
    owner = np.repeat(np.arange(len(faces)), counts)
    offset = np.arange(len(owner)) - (np.cumsum(counts) - counts)[owner]
    plane = (first[owner] + offset) % PLANES
    turn = (plane + 0.5) * step
    cosine, sine = np.cos(turn)[:, None], np.sin(turn)[:, None]
    corner = places[faces[owner]]
    along = corner[..., 0] * cosine + corner[..., 1] * sine
    across = corner[..., 1] * cosine - corner[..., 0] * sine
    above = across > 0.0
    crossing = above.any(axis=1) & ~above.all(axis=1)
    along, across, above = along[crossing], across[crossing], above[crossing]
    height, plane = corner[crossing][..., 2], plane[crossing]
    # The corner that lies alone on its side is an end of both edges that cross.
    alone = np.where(above.sum(axis=1) == 1, above.argmax(axis=1), (~above).argmax(axis=1))
    rows = np.arange(len(alone))
    ends = np.empty((len(alone), 2, 2))
    for k in range(2):
        other = (alone + 1 + k) % 3
        span = across[rows, alone] - across[rows, other]
        part = across[rows, alone] / span
        for axis_number, values in enumerate((along, height)):
            at = values[rows, alone]
            ends[:, k, axis_number] = at + part * (values[rows, other] - at)
    return _beyond_axis(ends, plane)


def _beyond_axis(ends: Floats, plane: NDArray[np.intp]) -> tuple[Floats, NDArray[np.intp]]:
    """Return the parts of segments that lie on the half plane's own side of the axis."""
    inside = (ends[..., 0] > 0.0).any(axis=1)
    ends, plane = ends[inside], plane[inside]
    start, end = ends[:, 0], ends[:, 1]
    for near, far in ((start, end), (end, start)):
        beyond = near[:, 0] < 0.0
        part = near[beyond, 0] / (near[beyond, 0] - far[beyond, 0])
        near[beyond] += part[:, None] * (far[beyond] - near[beyond])
    return ends, plane
