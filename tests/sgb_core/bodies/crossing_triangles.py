"""Which triangles of a mesh cross each other: decided in rational numbers, so there is no doubt.

Programs that decide it in floating point report triangles that merely lie in one plane.
"""

from __future__ import annotations

from fractions import Fraction
from itertools import combinations

import numpy as np

from sgb_core.surfaces.mesh import Mesh


def crossing_triangles(mesh: Mesh) -> list[tuple[int, int]]:
    """Return the pairs of triangles that share more than their common corners and edge."""
    faces = mesh.faces
    exact = [tuple(map(Fraction, point)) for point in mesh.positions.tolist()]
    return [
        (first, second)
        for first, second in _near_pairs(mesh.positions[faces])
        if _cross(exact, faces[first].tolist(), faces[second].tolist())
    ]


def _near_pairs(corners) -> list[tuple[int, int]]:
    """Return pairs whose boxes meet and that no plane of either clearly separates."""
    low, high = corners.min(axis=1), corners.max(axis=1)
    found = []
    for k in range(len(corners) - 1):
        later = (low[k + 1 :] <= high[k]).all(axis=1) & (high[k + 1 :] >= low[k]).all(axis=1)
        found += [(k, k + 1 + j) for j in np.flatnonzero(later).tolist()]
    pairs = np.array(found)
    kept = np.ones(len(pairs), dtype=bool)
    for one, other in ((0, 1), (1, 0)):
        a, b, c = np.moveaxis(corners[pairs[:, one]], 1, 0)
        normals = np.cross(b - a, c - a)
        sides = np.einsum("pkx,px->pk", corners[pairs[:, other]] - a[:, None], normals)
        slack = 1e-9 * np.abs(corners).max() * np.linalg.norm(normals, axis=1)
        kept &= ~((sides > slack[:, None]).all(axis=1) | (sides < -slack[:, None]).all(axis=1))
    return [(int(i), int(j)) for i, j in pairs[kept]]


def _cross(points, first, second) -> bool:
    shared = set(first) & set(second)
    if len(shared) == 3:
        return True
    if len(shared) == 2:
        # An edge in common: they overlap where one is folded back onto the other.
        a, b = (points[k] for k in shared)
        (c,), (d,) = ([points[k] for k in each if k not in shared] for each in (first, second))
        flat = _volume(a, b, c, d) == 0
        return flat and _dot(_cross_product(a, b, c), _cross_product(a, b, d)) > 0
    one, other = ([points[k] for k in each] for each in (first, second))
    for edges, triangle, own in ((first, other, one), (second, one, other)):
        for (i, p), (j, q) in combinations(zip(edges, own, strict=True), 2):
            if i not in shared and j not in shared and _meets(p, q, triangle):
                return True
    return False


def _meets(p, q, triangle) -> bool:
    """Whether the segment p q and a triangle have a point in common."""
    normal = _cross_product(*triangle)
    above, below = (_dot(normal, _minus(end, triangle[0])) for end in (p, q))
    if above * below > 0:
        return False
    drop = max(range(3), key=lambda k: abs(normal[k]))
    flat = [tuple(x for k, x in enumerate(each) if k != drop) for each in (*triangle, p, q)]
    corners, start, end = flat[:3], flat[3], flat[4]
    if above != below:
        share = above / (above - below)
        return _inside(tuple(s + share * (e - s) for s, e in zip(start, end, strict=True)), corners)
    sides = zip(corners, corners[1:] + corners[:1], strict=True)
    return _inside(start, corners) or any(_segments_meet(start, end, *side) for side in sides)


def _inside(point, corners) -> bool:
    turns = [_turn(a, b, point) for a, b in zip(corners, corners[1:] + corners[:1], strict=True)]
    return all(turn >= 0 for turn in turns) or all(turn <= 0 for turn in turns)


def _segments_meet(a, b, c, d) -> bool:
    """Whether two segments of a plane meet; those of one line do where their boxes meet."""
    if _turn(a, b, c) * _turn(a, b, d) > 0 or _turn(c, d, a) * _turn(c, d, b) > 0:
        return False
    return all(
        max(min(a[k], b[k]), min(c[k], d[k])) <= min(max(a[k], b[k]), max(c[k], d[k]))
        for k in range(2)
    )


def _turn(a, b, c):
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def _minus(a, b):
    return tuple(x - y for x, y in zip(a, b, strict=True))


def _dot(a, b):
    return sum(x * y for x, y in zip(a, b, strict=True))


def _cross_product(a, b, c):
    u, v = _minus(b, a), _minus(c, a)
    return tuple(u[k - 2] * v[k - 1] - u[k - 1] * v[k - 2] for k in range(3))


def _volume(a, b, c, d):
    return _dot(_cross_product(a, b, c), _minus(d, a))
