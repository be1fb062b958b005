"""What is seen of a mesh from one side: its contours, its creases and its borders, nothing hidden.

A contour is where the surface turns away from the eye, n · v = 0 (v the direction of sight), taken
between the corners of a mesh with true normals; a crease is an edge at which the normals differ.
"""

from __future__ import annotations

from collections.abc import Iterator
from math import cos, radians

import numpy as np
import shapely

from sgb_core.arrays import Floats, Ints, Mask
from sgb_core.bodies.side_view import EDGE_DEG
from sgb_core.surfaces.mesh import Mesh
from sgb_core.values import dataclass

# Times the tolerance by which what may be seen is moved off the surface before others may hide it.
_OFF = 3.0
# What faces the eye by less stands edge on.
_LEVEL = 1e-9
# What is seen is told for parts of lines so short that so many of them cross the picture.
_STEPS = 400
_AT_ONCE = 20_000


@dataclass(frozen=True, slots=True, eq=False)
class _Segments:
    """Straight parts of lines: ends (n, 2, 3), outward directions (n, 3), keys of both ends."""

    ends: Floats
    normals: Floats
    keys: Ints


def seen_lines(mesh: Mesh, frame: Floats, tolerance: float) -> list[Floats]:
    """Return the lines that are seen of a mesh, each (k, 2) across and up.

    The rows of ``frame`` (3, 3) are the unit directions across, up and towards the eye, which is
    infinitely far away. ``tolerance`` is how far the mesh may be from what it stands for.
    """
    points, normals = mesh.positions @ frame.T, mesh.normals @ frame.T
    found: list[Floats] = []
    triangles = _Triangles(points[mesh.faces])
    step = float(np.ptp(points[:, :2], axis=0).max()) / _STEPS
    for whole in (_contours(mesh, points, normals), _creases(mesh, points, normals)):
        parts = _cut(whole, step)
        middles = parts.ends.mean(axis=1) + _OFF * tolerance * parts.normals
        shown = ~triangles.hide(middles)
        found += _chained(parts.ends[shown][..., :2], parts.keys[shown])
    return found


def _cut(parts: _Segments, longest: float) -> _Segments:
    """Return the parts in pieces that are seen wholly or not at all, as far as one can tell."""
    along = parts.ends[:, 1] - parts.ends[:, 0]
    counts = np.maximum(1, np.ceil(np.hypot(along[:, 0], along[:, 1]) / longest)).astype(int)
    of = np.repeat(np.arange(len(counts)), counts)
    number = np.arange(len(of)) - np.repeat(np.cumsum(counts) - counts, counts)
    shares = np.stack([number, number + 1], axis=1) / counts[of, None]
    ends = parts.ends[of, None, 0] + shares[..., None] * along[of, None]
    # Between the pieces of one part lie places of their own, numbered below 0.
    keys = np.stack([-np.arange(len(of)) - 1, -np.arange(len(of)) - 2], axis=1)
    first, last = number == 0, number == counts[of] - 1
    keys[first, 0], keys[last, 1] = parts.keys[:, 0], parts.keys[:, 1]
    return _Segments(ends, parts.normals[of], keys)


class _Triangles:
    """The faces of a mesh, which answer what they hide."""

    def __init__(self, corners: Floats) -> None:
        flat = corners[..., :2]
        a, b = flat[:, 1] - flat[:, 0], flat[:, 2] - flat[:, 0]
        self._area = a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]
        self._corners = corners
        low, high = flat.min(axis=1), flat.max(axis=1)
        self._tree = shapely.STRtree(shapely.box(*low.T, *high.T))

    def hide(self, places: Floats) -> Mask:
        """Return whether places (n, 3) lie behind a face, (n,)."""
        hidden = np.zeros(len(places), dtype=bool)
        for first in range(0, len(places), _AT_ONCE):
            part = places[first : first + _AT_ONCE]
            which, face = self._tree.query(shapely.points(part[:, :2]))
            level = self._area[face] != 0.0
            which, face = which[level], face[level]
            away = part[which, :2] - self._corners[face, 0, :2]
            a, b = (self._corners[face, k] - self._corners[face, 0] for k in (1, 2))
            u = (away[:, 0] * b[:, 1] - away[:, 1] * b[:, 0]) / self._area[face]
            v = (a[:, 0] * away[:, 1] - a[:, 1] * away[:, 0]) / self._area[face]
            depth = self._corners[face, 0, 2] + u * a[:, 2] + v * b[:, 2]
            over = (u >= 0.0) & (v >= 0.0) & (u + v <= 1.0) & (depth > part[which, 2])
            hidden[first + which[over]] = True
        return hidden


def _contours(mesh: Mesh, points: Floats, normals: Floats) -> _Segments:
    """Return where the normals are level with the paper, straight across each triangle."""
    facing = normals[mesh.triangles, 2]
    above = facing > _LEVEL
    split = np.flatnonzero(above.any(axis=1) & ~above.all(axis=1))
    corners, above, facing = mesh.triangles[split], above[split], facing[split]
    # The corner that stands alone on its side, and from it to the two others.
    alone = np.where(above.sum(axis=1) == 1, above.argmax(axis=1), (~above).argmax(axis=1))
    rows = np.arange(len(split))
    ends, leans, keys = [], [], []
    for step in (1, 2):
        other = (alone + step) % 3
        f0, f1 = facing[rows, alone], facing[rows, other]
        share = np.clip(f0 / (f0 - f1), 0.0, 1.0)[:, None]
        first, last = corners[rows, alone], corners[rows, other]
        p, q = mesh.corner_positions[first], mesh.corner_positions[last]
        ends.append(points[p] + share * (points[q] - points[p]))
        leans.append(normals[first] + share * (normals[last] - normals[first]))
        keys.append(np.minimum(p, q) * len(points) + np.maximum(p, q))
    lean = leans[0] + leans[1]
    lean /= np.maximum(np.linalg.norm(lean, axis=1), 1e-300)[:, None]
    return _Segments(np.stack(ends, axis=1), lean, np.stack(keys, axis=1))


def _creases(mesh: Mesh, points: Floats, normals: Floats) -> _Segments:
    """Return the edges at which two faces' normals differ, and those of one face only."""
    corners = np.stack([mesh.triangles, np.roll(mesh.triangles, -1, axis=1)], axis=-1)
    corners = corners.reshape(-1, 2)
    ends = mesh.corner_positions[corners]
    turned = ends[:, 0] > ends[:, 1]
    ends[turned], corners[turned] = ends[turned][:, ::-1], corners[turned][:, ::-1]
    order = np.lexsort((ends[:, 1], ends[:, 0]))
    ends, corners = ends[order], corners[order]
    starts = np.flatnonzero(np.append(True, (ends[1:] != ends[:-1]).any(axis=1)))
    counts = np.diff(np.append(starts, len(ends)))
    first, last = corners[starts], corners[starts + counts - 1]
    alike = np.einsum("nkx,nkx->nk", normals[first], normals[last]).min(axis=1)
    kept = (counts == 1) | (alike < cos(radians(EDGE_DEG)))
    keys = ends[starts][kept]
    outward = (normals[first[kept]] + normals[last[kept]]).sum(axis=1)
    outward /= np.maximum(np.linalg.norm(outward, axis=1), 1e-300)[:, None]
    return _Segments(points[keys], outward, keys)


def _chained(ends: Floats, keys: Ints) -> list[Floats]:
    """Return lines made of parts (n, 2, 2) that share ends, told by keys (n, 2)."""
    at: dict[int, list[int]] = {}
    for number, pair in enumerate(keys.tolist()):
        for key in pair:
            at.setdefault(key, []).append(number)
    used = np.zeros(len(keys), dtype=bool)
    lines = []
    # From ends and branches first: what is left then is closed.
    begin = [(key, parts) for key, parts in at.items() if len(parts) != 2]
    for key, parts in (*begin, *at.items()):
        for number in parts:
            if not used[number]:
                lines.append(np.array(list(_followed(key, number, ends, keys, at, used))))
    return lines


def _followed(
    key: int, number: int, ends: Floats, keys: Ints, at: dict[int, list[int]], used: Mask
) -> Iterator[Floats]:
    side = int(keys[number, 0] != key)
    yield ends[number, side]
    while True:
        used[number] = True
        key = int(keys[number, 1 - side])
        yield ends[number, 1 - side]
        after = at[key]
        if len(after) != 2:
            return
        number = after[0] if after[1] == number else after[1]
        if used[number]:
            return
        side = int(keys[number, 0] != key)
