"""The live path of a surface with laws: a section for each column, written in single precision."""

from __future__ import annotations

from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from sgb_core.arrays import Floats
from sgb_core.curves import basis
from sgb_core.curves.nodes import derivative_rows
from sgb_core.surfaces.normals import radius_signs, surface_normals, unit_tangents
from sgb_core.surfaces.revolution import RevolutionSurface
from sgb_core.surfaces.turn import grid_columns
from sgb_core.surfaces.variation import varying_quartics

SingleFloats: TypeAlias = NDArray[np.float32]

# Multiplications of a matrix product below which the linear algebra library starts no threads.
_ONE_THREAD = 250_000
# Numbers of one of the eight arrays that all fit into the cache beside each other.
_IN_CACHE = 8_192
# Below these parts of the size a radius or a derivative may vanish but for rounding.
_NEAR_AXIS, _NEARLY_STILL = 1e-5, 1e-5


def multiply(left: SingleFloats, right: SingleFloats, out: SingleFloats) -> None:
    """Write ``left`` @ ``right`` into ``out``, in pieces that one thread multiplies.

    A product this thin is as fast as memory is; more threads only wait for each other, up to a
    hundred times as long where the processors are busy.
    """
    rows = max(1, _ONE_THREAD // right.size)
    for start in range(0, len(left), rows):
        piece = slice(start, start + rows)
        np.matmul(left[piece], right, out=out[piece])


class VaryingWriter:
    """Writes points and normals of surfaces with laws into arrays that keep their memory.

    A few rows at a time, so that all that is computed of them stays in the processor's cache.
    Where a derivative vanishes or the axis is met, as at a pole, a row is written anew with the
    limits that hold there.
    """

    def __init__(self, segment_count: int, per_segment: int, columns: int) -> None:
        self._shape = (segment_count, per_segment + 1, columns)
        self._s = np.linspace(0.0, 1.0, per_segment + 1)
        self._values = basis.bernstein(4, self._s).astype(np.float32)
        self._slopes = basis.bernstein(3, self._s).astype(np.float32)
        self._block = max(1, min(per_segment + 1, _IN_CACHE // columns))
        self._made = np.empty((8, self._block, columns), np.float32)

    def write(
        self,
        surface: RevolutionSurface,
        points: SingleFloats,
        normals: SingleFloats,
        *,
        flipped: bool,
    ) -> None:
        """Fill ``points`` and ``normals``, each shape (rows, columns, 3), float32."""
        turned, sides = grid_columns(surface, self._shape[2] - 1)
        sections = varying_quartics(surface.profile, surface.laws, turned, sides)
        directions = surface.directions(surface.start + turned)
        axes = np.ascontiguousarray(directions.transpose(1, 2, 0), np.float32)
        quartics, rates = sections
        # Differences are taken first: far from the origin they lose no digits to the position.
        slopes = 4.0 * (quartics[..., 1:, :] - quartics[..., :-1, :])
        # One product per segment: its points as rows, the columns of the grid as columns.
        control = [
            np.ascontiguousarray(part.transpose(1, 3, 2, 0), np.float32)
            for part in (quartics, slopes, rates)
        ]
        size, moved = surface.profile.size, surface.placement.translation
        points, normals = points.reshape(*self._shape, 3), normals.reshape(*self._shape, 3)
        for segment in range(self._shape[0]):
            parts = [part[segment] for part in control]
            for start in range(0, self._shape[1], self._block):
                rows = slice(start, start + self._block)
                made = self._evaluate(parts, rows)
                _place(made, axes, moved, points[segment, rows])
                doubtful = _turn_normals(made, axes, size, flipped, normals[segment, rows])
                for row in (start + doubtful).tolist():
                    found = self._limit(sections, segment, row, size)
                    placed = np.einsum("ci,cij->cj", found, directions)
                    normals[segment, row] = -placed if flipped else placed

    def _evaluate(self, parts: list[SingleFloats], rows: slice) -> SingleFloats:
        """Return r, h, their derivatives by s, and by θ, and room for two more, on some rows."""
        values, slopes = self._values[rows], self._slopes[rows]
        made = self._made[:, : len(values)]
        for k, (matrix, part) in enumerate(zip((values, slopes, values), parts, strict=True)):
            for axis in range(2):
                multiply(matrix, part[axis], made[2 * k + axis])
        return made

    def _limit(
        self, sections: tuple[Floats, Floats], segment: int, row: int, size: float
    ) -> Floats:
        """Return the components of one row's normals, shape (columns, 3), in double precision."""
        # With the next row, whose side of the axis counts there; the last one with that before.
        first = min(row, len(self._s) - 2)
        s = self._s[first : first + 2]
        matrices = tuple(derivative_rows(order, s.tobytes()) for order in range(3))
        quartics, rates = (part[:, segment] for part in sections)
        return varying_normals(quartics, rates, s, matrices, size)[:, row - first]


def _place(
    made: SingleFloats,
    axes: SingleFloats,
    moved: tuple[float, float, float],
    out: SingleFloats,
) -> None:
    """Write the points r e_ρ + h e_h, moved."""
    r, h, one, two = made[0], made[1], made[6], made[7]
    for c in range(3):
        np.multiply(r, axes[0, c], out=one)
        np.multiply(h, axes[2, c], out=two)
        if moved[c]:
            np.add(two, np.float32(moved[c]), out=two)
        np.add(one, two, out=out[..., c])


def _turn_normals(
    made: SingleFloats, axes: SingleFloats, size: float, flipped: bool, out: SingleFloats
) -> NDArray[np.intp]:
    """Write ±(h_s e_ρ − w e_θ − r_s e_h)/|…| with w = (r_θ h_s − h_θ r_s)/r.

    The sign is that of r, reversed where flipped. Returns the rows on which a radius or a
    derivative nearly vanishes, so that this tells nothing.
    """
    r, _, dr, dh, lean, rise, one, two = made
    np.multiply(lean, dh, out=lean)
    np.multiply(rise, dr, out=rise)
    np.subtract(lean, rise, out=lean)
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        np.divide(lean, r, out=lean)
        np.multiply(dh, dh, out=one)
        np.multiply(dr, dr, out=two)
        np.add(one, two, out=one)
        np.abs(r, out=two)
        still = one.min(axis=1) <= (_NEARLY_STILL * size) ** 2
        doubtful = still | (two.min(axis=1) <= _NEAR_AXIS * size)
        np.multiply(lean, lean, out=two)
        np.add(one, two, out=one)
        np.sqrt(one, out=one)
        np.copysign(one, r, out=one)
        np.divide(-1.0 if flipped else 1.0, one, out=one)
        for part in (dh, lean, dr):
            np.multiply(part, one, out=part)
        for c in range(3):
            np.multiply(dh, axes[0, c], out=one)
            np.multiply(lean, axes[1, c], out=two)
            np.subtract(one, two, out=one)
            np.multiply(dr, axes[2, c], out=two)
            np.subtract(one, two, out=out[..., c])
    return np.flatnonzero(doubtful)


def varying_normals(
    quartics: Floats, rates: Floats, s: Floats, matrices: tuple[Floats, ...], size: float
) -> Floats:
    """Return unit normals along ∂S/∂θ × ∂S/∂s as components on e_ρ, e_θ, e_h.

    ``quartics`` and ``rates`` are sections and their ∂/∂θ, shape (..., 5, 2); ``matrices`` take
    them to L, L', L'' at ``s``. The result has shape (..., len(s), 3).
    """
    points, first, second = (matrix @ quartics for matrix in matrices)
    change = matrices[0] @ rates
    tangents = unit_tangents(quartics, s, first, second, size)
    r = points[..., 0]
    signs = radius_signs(r, size)
    slip = change[..., 0] * tangents[..., 1] - change[..., 1] * tangents[..., 0]
    return surface_normals(tangents, slip, r, signs, size)
