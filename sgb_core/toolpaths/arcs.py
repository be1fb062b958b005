"""Runs of moves that are arcs of circles within the chord's tolerance, for G2 and G3."""

from __future__ import annotations

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.toolpaths.strand import Part
from sgb_core.toolpaths.toolpath import Toolpath
from sgb_core.values import dataclass

# No arc takes more than this part of a turn's points: firmwares know few of half a turn.
_PART_OF_TURN = 4
# Straighter than this radius (mm) is a line.
_STRAIGHT = 1e5


@dataclass(frozen=True, slots=True)
class Run:
    """The moves after point ``start`` up to ``end``: an arc about ``centre``, None for lines."""

    start: int
    end: int
    centre: tuple[float, float] | None


def runs(path: Toolpath) -> list[Run]:
    """Return all moves of a path, from the first point on, as arcs and lines in their order.

    An arc goes through its first, middle and last point; all others lie within half the chord of
    it, sideways and in height.
    """
    points, parts, layers = path.points, path.parts, path.layers
    change = (np.diff(parts) != 0) | (np.diff(layers) != 0)
    edges = np.concatenate([[0], np.flatnonzero(change), [len(points) - 1]])
    most = max(2, int((layers == layers[-1]).sum()) // _PART_OF_TURN)
    found: list[Run] = []
    for start, end in zip(edges[:-1].tolist(), edges[1:].tolist(), strict=True):
        if end == start:
            continue
        if parts[end] == Part.TRAVEL:
            found.append(Run(start, end, None))
            continue
        for first in range(start, end, most):
            _split(points, first, min(first + most, end), path.plan.wanted.chord / 2.0, found)
    return found


def _split(points: Floats, start: int, end: int, slack: float, found: list[Run]) -> None:
    if end - start < 3:
        found.extend(Run(k, k + 1, None) for k in range(start, end))
        return
    middle = (start + end) // 2
    own = points[start : end + 1]
    centre = _centre(points[start, :2], points[middle, :2], points[end, :2])
    if centre is not None and _is_arc(own, np.array(centre), slack):
        found.append(Run(start, end, centre))
        return
    _split(points, start, middle, slack, found)
    _split(points, middle, end, slack, found)


def _is_arc(own: Floats, centre: Floats, slack: float) -> bool:
    """Whether points lie near a helix of constant radius, the first and last on it."""
    away = own[:, :2] - centre
    radii = np.hypot(away[:, 0], away[:, 1])
    angle = np.unwrap(np.arctan2(away[:, 1], away[:, 0]))
    swept = angle - angle[0]
    if not np.all(np.diff(swept) * np.sign(swept[-1]) > 0.0) or abs(swept[-1]) > np.pi:
        return False
    level = own[0, 2] + (own[-1, 2] - own[0, 2]) * swept / swept[-1]
    near = np.abs(radii - radii[0]).max() <= slack and np.abs(own[:, 2] - level).max() <= slack
    # Between the points too: the sagitta of what the chord was made for.
    return bool(near)


def _centre(a: Floats, b: Floats, c: Floats) -> tuple[float, float] | None:
    """Return the centre of the circle through three points; None where they lie on a line."""
    u, v = b - a, c - a
    twice = 2.0 * float(u[0] * v[1] - u[1] * v[0])
    if twice == 0.0:
        return None
    uu, vv = float(u @ u), float(v @ v)
    x = (float(v[1]) * uu - float(u[1]) * vv) / twice
    y = (float(u[0]) * vv - float(v[0]) * uu) / twice
    if x * x + y * y > _STRAIGHT**2:
        return None
    return float(a[0]) + x, float(a[1]) + y
