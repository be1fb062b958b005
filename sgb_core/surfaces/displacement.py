"""Moving the rows of a swept section along their normals, as far as the surface allows it."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from sgb_core.arrays import Floats, Ints, Mask
from sgb_core.findings.errors import FindingError
from sgb_core.findings.surfaces import TooManyTriangles
from sgb_core.surfaces.relief import ReliefField
from sgb_core.surfaces.section import Section
from sgb_core.surfaces.turn import Turn
from sgb_core.values import dataclass

MOST_TRIANGLES = 4_000_000
# What is left of the way between two places when the surface moves towards its centre of
# curvature: less, and rounding would fold it.
_LEFT = 0.3


@dataclass(slots=True, eq=False)
class Relief:
    """The heights of an outer face on a mesh, with the rows and columns that they need.

    ``rows`` are by segment the parameters of more rows, ``columns`` more shares of the sweep.
    Whatever is displaced is noted: ``held_back`` is how much less than asked for the surface was
    moved at most, ``lowest`` how far down at most (0 or less), ``added`` the volume between before
    and after.
    """

    heights: ReliefField
    columns: Floats
    rows: Mapping[int, Floats]
    most: int = MOST_TRIANGLES
    held_back: float = 0.0
    lowest: float = 0.0
    added: float = 0.0

    @classmethod
    def of(cls, heights: ReliefField, tolerance: float, most: int) -> Relief:
        """Return heights with what they need to be within a tolerance."""
        u, v = heights.grid(tolerance)
        return cls(heights, u, heights.parameters(v), most)

    def check_count(self, rows: int, columns: int) -> None:
        """Raise FindingError where a mesh would have more than the ``most`` triangles."""
        if 2.0 * rows * columns > self.most:
            raise FindingError(TooManyTriangles(2.0 * rows * columns, self.most))

    def share(self, segment: int, s: Floats) -> Floats:
        """Return the shares of the generatrix' length at parameters of a segment."""
        return self.heights.uv_map.share(segment, s)

    def displaced(
        self, section: Section, turn: Turn, points: Floats, normals: Floats, flip: bool
    ) -> tuple[Floats, Floats]:
        """Return moved points and the normals there, (R, C, 3) each, of rows placed in space.

        ``flip`` says that outward is against the normals.
        """
        if section.shares is None:
            return points, normals
        rows = np.flatnonzero(np.isfinite(section.shares))
        # Rows in one piece with the one before, and the two sides of a joint.
        linked = section.linked[rows[:-1]] & (np.diff(rows) == 1)
        same = (np.diff(section.rings[rows]) == 0) & (np.diff(rows) == 1)
        wanted = self.heights.at(turn.fraction, section.shares[rows])
        if not wanted.any():
            return points, normals
        sign = -1.0 if flip else 1.0
        base, out = points[rows], sign * normals[rows]
        along = _shared(out, np.flatnonzero(same))
        steps = (linked, turn.linked)
        heights = _allowed(wanted, base, along, steps)
        # Both sides of a joint are moved alike, and so are both of the seam.
        for first in np.flatnonzero(same).tolist():
            heights[first] = heights[first + 1] = _smaller(heights[first], heights[first + 1])
        if self.heights.whole:
            heights[:, 0] = heights[:, -1] = _smaller(heights[:, 0], heights[:, -1])
        doubled = np.flatnonzero(~turn.linked)
        for first in doubled.tolist():
            both = _smaller(heights[:, first], heights[:, first + 1])
            heights[:, first] = heights[:, first + 1] = both
        self.held_back = max(self.held_back, float(np.abs(wanted - heights).max()))
        self.lowest = min(self.lowest, float(heights.min()))
        moved, leaning = points.copy(), normals.copy()
        moved[rows] += heights[..., None] * along
        self.added += _between(base, moved[rows], out, steps)
        leaning[rows] = sign * _leaning(heights, base, out, steps, self.heights.whole)
        return moved, leaning


def _shared(normals: Floats, joints: Ints) -> Floats:
    """Return normals (R, C, 3) with those of both sides of joints alike, as long as a mitre."""
    result = normals.copy()
    for first in joints.tolist():
        mean = normals[first] + normals[first + 1]
        mean /= np.maximum(np.linalg.norm(mean, axis=-1, keepdims=True), 1e-12)
        across = np.maximum((mean * normals[first]).sum(axis=-1, keepdims=True), 0.5)
        result[first] = result[first + 1] = mean / across
    return result


def _allowed(heights: Floats, points: Floats, along: Floats, steps: tuple[Mask, Mask]) -> Floats:
    """Return heights that fold nothing: of each step between neighbours a part is left.

    A step ΔP becomes ΔP + d ΔN; (ΔP + d ΔN)·ΔP must stay positive.
    """
    high = np.full(heights.shape, np.inf)
    low = np.full(heights.shape, -np.inf)
    for axis, linked in enumerate(steps):
        shape = (-1, 1) if axis == 0 else (1, -1)
        step, turn = np.diff(points, axis=axis), np.diff(along, axis=axis)
        square, change = np.einsum("rcx,rcx->rc", step, step), np.einsum("rcx,rcx->rc", step, turn)
        usable = linked.reshape(shape) & (square > 0.0) & (change != 0.0)
        most = np.full(square.shape, np.inf)
        np.divide((1.0 - _LEFT) * square, np.abs(change), out=most, where=usable)
        upward = np.where(change < 0.0, most, np.inf)
        downward = np.where(change > 0.0, -most, -np.inf)
        for side in (slice(None, -1), slice(1, None)):
            part = (side, slice(None)) if axis == 0 else (slice(None), side)
            np.minimum(high[part], upward, out=high[part])
            np.maximum(low[part], downward, out=low[part])
    return np.clip(heights, low, high)


def _smaller(first: Floats, second: Floats) -> Floats:
    return np.where(np.abs(first) <= np.abs(second), first, second)


def _between(before: Floats, after: Floats, out: Floats, steps: tuple[Mask, Mask]) -> float:
    """Return the volume that triangles (R, C, 3) enclose more after they have moved ``out``."""
    cells = np.outer(*steps)
    middle = before.reshape(-1, 3).mean(axis=0)
    found = []
    for points in (before, after):
        corner, beside = points[:-1, :-1] - middle, points[:-1, 1:] - middle
        above, across = points[1:, :-1] - middle, points[1:, 1:] - middle
        normal = np.cross(beside, across) + np.cross(across, above)
        found.append(float(np.einsum("rcx,rcx->rc", corner, normal)[cells].sum() / 6.0))
        if points is before:
            area = np.cross(across - corner, above - beside)
            side = float(np.einsum("rcx,rcx->rc", area, out[:-1, :-1])[cells].sum())
    return (found[1] - found[0]) * (1.0 if side >= 0.0 else -1.0)


def _leaning(
    heights: Floats, points: Floats, normals: Floats, steps: tuple[Mask, Mask], whole: bool
) -> Floats:
    """Return the normals of a surface moved by heights: N − ∇d, (R, C, 3)."""
    d_along, p_along = _differences(heights, points, steps[0], 0, False)
    d_around, p_around = _differences(heights, points, steps[1], 1, whole)
    e = np.einsum("rcx,rcx->rc", p_along, p_along)
    f = np.einsum("rcx,rcx->rc", p_along, p_around)
    g = np.einsum("rcx,rcx->rc", p_around, p_around)
    det = e * g - f * f
    usable = det > 1e-12 * e * g
    det = np.where(usable, det, 1.0)
    first = np.where(usable, (g * d_along - f * d_around) / det, 0.0)
    second = np.where(usable, (e * d_around - f * d_along) / det, 0.0)
    leaning = normals - first[..., None] * p_along - second[..., None] * p_around
    length = np.linalg.norm(leaning, axis=-1, keepdims=True)
    return np.asarray(leaning / np.where(length > 0.0, length, 1.0))


def _differences(
    heights: Floats, points: Floats, linked: Mask, axis: int, whole: bool
) -> tuple[Floats, Floats]:
    """Return differences of heights and points from neighbour to neighbour along an axis.

    One-sided where a neighbour is missing; on a ``whole`` turn the last column is the first.
    """
    count = heights.shape[axis]
    before = np.arange(count)
    after = before.copy()
    before[1:][linked] -= 1
    after[:-1][linked] += 1
    found = []
    for values in (heights, points):
        step = values.take(after, axis) - values.take(before, axis)
        if whole and count > 3:
            around = values[:, 1] - values[:, 0] + values[:, -1] - values[:, -2]
            step[:, 0] = step[:, -1] = around
        found.append(step)
    return found[0], found[1]
