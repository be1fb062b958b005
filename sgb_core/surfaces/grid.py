"""The live fast path: a surface's points and normals written in place, in single precision."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from sgb_core.arrays import Floats
from sgb_core.curves.nodes import derivative_rows
from sgb_core.surfaces.normals import radius_signs, unit_tangents
from sgb_core.surfaces.revolution import RevolutionSurface
from sgb_core.surfaces.varying_grid import SingleFloats, VaryingWriter, multiply


class SweepGrid:
    """A grid of one strip per segment and ``columns`` steps around, allocated once.

    ``points`` and ``normals``, shape (rows·(columns + 1), 3), float32, C-contiguous, keep their
    memory for the life of the grid, so that a viewport can share it. A joint has two rows (one
    normal each side), a full turn two coinciding columns; vertex index =
    row·(columns + 1) + column. ``quads``, shape (Q, 4), int32, are wound along ∂S/∂θ × ∂S/∂s;
    after :meth:`write` ``flipped`` says that outward is the other side (the normals written
    always point outward), and ``outward_quads`` are wound that way.

    Raises ValueError unless there is at least one segment, step and column.
    """

    def __init__(self, segment_count: int, per_segment: int, columns: int) -> None:
        if min(segment_count, per_segment, columns) < 1:
            raise ValueError("a grid has at least one segment, one step and one column")
        self.segment_count = segment_count
        self.per_segment = per_segment
        self.rows = segment_count * (per_segment + 1)
        self.columns = columns + 1
        self.points: SingleFloats = np.zeros((self.rows * self.columns, 3), np.float32)
        self.normals: SingleFloats = np.zeros_like(self.points)
        self.quads = _quads(segment_count, per_segment, self.columns)
        self._reversed_quads: NDArray[np.int32] | None = None
        self.flipped = False
        self._s = np.linspace(0.0, 1.0, per_segment + 1)
        samples = self._s.tobytes()
        self._matrices = tuple(derivative_rows(order, samples) for order in range(3))
        self._varying: VaryingWriter | None = None
        self._around: SingleFloats | None = None
        self._around_key: object = None
        # Columns r, h, 1 of the section; the 1 carries a translation.
        self._section_points = np.ones((self.rows, 3), np.float32)
        self._section_normals = np.zeros((self.rows, 2), np.float32)

    @property
    def outward_quads(self) -> NDArray[np.int32]:
        """``quads`` wound so that their front faces outward, as of the last write."""
        if not self.flipped:
            return self.quads
        if self._reversed_quads is None:
            self._reversed_quads = np.ascontiguousarray(self.quads[:, ::-1])
        return self._reversed_quads

    def section(self, surface: RevolutionSurface) -> Floats:
        """Return the rows' (r, h) at the start angle, double precision, shape (rows, 2)."""
        return surface.section.on(self._s).reshape(self.rows, 2)

    def write(self, surface: RevolutionSurface, flip: bool | None = None) -> None:
        """Fill ``points`` and ``normals`` with a surface of ``segment_count`` segments.

        Normals are exact and point outward; ``flip`` overrides that decision (True reverses
        those along ∂S/∂θ × ∂S/∂s). Raises ValueError for another number of segments.
        """
        if len(surface.profile) != self.segment_count:
            raise ValueError(
                f"the grid has {self.segment_count} segments, the profile {len(surface.profile)}"
            )
        self.flipped = surface.flips if flip is None else flip
        if surface.laws or surface.twisting is not None:
            if self._varying is None:
                self._varying = VaryingWriter(self.segment_count, self.per_segment, self.columns)
            shape = (self.rows, self.columns, 3)
            points, normals = self.points.reshape(shape), self.normals.reshape(shape)
            self._varying.write(surface, points, normals, flipped=self.flipped)
        else:
            self._write_constant(surface)

    def _write_constant(self, surface: RevolutionSurface) -> None:
        quartics, size = surface.profile.quartics, surface.profile.size
        points, first, second = (matrix @ quartics for matrix in self._matrices)
        tangents = unit_tangents(quartics, self._s, first, second, size)
        signs = radius_signs(points[..., 0], size)
        if self.flipped:
            signs = -signs
        self._section_points[:, :2] = points.reshape(self.rows, 2)
        normals = self._section_normals.reshape(self.segment_count, -1, 2)
        np.multiply(tangents[..., 1], signs, out=normals[..., 0], casting="same_kind")
        np.multiply(tangents[..., 0], -signs, out=normals[..., 1], casting="same_kind")
        around = self._turn(surface)
        # Two terms are a third faster than three, and almost nothing is translated.
        terms = 3 if any(surface.placement.translation) else 2
        shape = (self.rows, 3 * self.columns)
        multiply(self._section_points[:, :terms], around[:terms], self.points.reshape(shape))
        multiply(self._section_normals, around[:2], self.normals.reshape(shape))

    def _turn(self, surface: RevolutionSurface) -> SingleFloats:
        """Return K, shape (3, 3·columns), with (r, h, 1) K the points of a row."""
        key = (surface.axis, surface.start, surface.sweep, surface.placement)
        if self._around is None or key != self._around_key:
            directions = surface.directions(surface.angles(self.columns - 1))
            around = np.empty((3, self.columns, 3), np.float32)
            around[0], around[1] = directions[:, 0], directions[:, 2]
            around[2] = surface.placement.translation
            self._around = around.reshape(3, 3 * self.columns)
            self._around_key = key
        return self._around


def _quads(segment_count: int, per_segment: int, columns: int) -> NDArray[np.int32]:
    rows = np.arange(segment_count * (per_segment + 1)).reshape(segment_count, -1)[:, :-1]
    corner = (rows.reshape(-1, 1) * columns + np.arange(columns - 1)).ravel()
    quads = np.stack([corner, corner + 1, corner + columns + 1, corner + columns], axis=1)
    return quads.astype(np.int32)
