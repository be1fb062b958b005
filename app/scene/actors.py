"""The drawn parts: each keeps its VTK objects and only rewrites the arrays behind them."""

from __future__ import annotations

from math import tan
from typing import Any

import numpy as np
from numpy.typing import NDArray
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkRenderingCore import vtkActor, vtkMapper, vtkPolyDataMapper

from app.hand.density import presence
from app.scene.camera import VIEW_ANGLE, Pose
from sgb_core.surfaces.grid import SweepGrid
from sgb_core.values import dataclass

Array = NDArray[Any]
Numbers = NDArray[np.int64]
# The point data that tell the shaders how open the outer and the inner side lie to the light.
OPENNESS = "openness"
Colour = tuple[float, float, float]


def rgb(colour: str) -> Colour:
    """Return #rrggbb as three numbers from 0 to 1."""
    red, green, blue = (int(colour[k : k + 2], 16) / 255.0 for k in (1, 3, 5))
    return red, green, blue


# Lines that lie in the surface are brought forward. The surface itself is not pushed back: writing
# the depth of each of its pixels would cost a sixth of the picture.
vtkMapper.SetResolveCoincidentTopologyToPolygonOffset()
vtkMapper.SetResolveCoincidentTopologyPolygonOffsetParameters(0.0, 0.0)
vtkMapper.SetResolveCoincidentTopologyLineOffsetParameters(-1.0, -12.0)


def _actor(data: vtkPolyData) -> vtkActor:
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(data)
    mapper.ScalarVisibilityOff()
    # Both would ask for the bounds of all cells at each tick.
    mapper.SetVBOShiftScaleMethod(0)
    mapper.StaticOn()
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.UseBoundsOff()
    return actor


def _share(points: Array) -> vtkPoints:
    shared = vtkPoints()
    shared.SetData(numpy_to_vtk(points, deep=False))
    return shared


def give_openness(data: vtkPolyData, values: Array) -> None:
    """Give points their openness, shape (points, 2)."""
    array = numpy_to_vtk(np.ascontiguousarray(values, np.float32), deep=True)
    array.SetName(OPENNESS)
    data.GetPointData().AddArray(array)
    data.Modified()


@dataclass(frozen=True, slots=True)
class Detail:
    """How many intervals a segment and a full turn are drawn with.

    ``rows`` are shared out among the segments; each has ``least_per_segment`` as long as all
    together have no more than ``most_rows``, and never less than two. Where these are more than
    ``most_rows`` all the same there are fewer columns, but never less than ``least_columns``.
    """

    rows: int
    least_per_segment: int
    columns: int
    most_rows: int
    least_columns: int

    def intervals(self, segments: int, sweep: float) -> tuple[int, int]:
        """Return (per segment, around) for so many segments and a sweep in radians."""
        least = max(2, min(self.least_per_segment, self.most_rows // segments))
        per_segment = max(least, min(self.rows // segments, self.rows // 2))
        # In steps, so that a sweep being dragged seldom needs another topology.
        most = self.columns * self.most_rows // (segments * per_segment)
        step = max(self.least_columns, min(self.columns, most)) // 8
        around = step * max(1, int(np.ceil(8 * sweep / (2 * np.pi))))
        return per_segment, around


# A circle of 96 steps that fills a picture of 800 pixels is off by a fifth of a pixel, one of 72 in
# half the resolution by as much of its pixels; the shading does not depend on the steps, its
# normals are exact. Smaller quads than needed cost dearly where no graphics card draws: each is
# shaded in whole blocks of pixels. The finer levels are for the resting picture: that of a file,
# and that of a window, magnified and as it is. In a window that of a long chain, whose rows lie
# closer than its pixels, is held down: drawing it would hold up the hand.
HALVED = Detail(rows=72, least_per_segment=9, columns=72, most_rows=360, least_columns=72)
COARSE = Detail(rows=96, least_per_segment=12, columns=96, most_rows=360, least_columns=96)
FINE = Detail(rows=240, least_per_segment=24, columns=256, most_rows=1200, least_columns=256)
MAGNIFIED = Detail(rows=240, least_per_segment=24, columns=256, most_rows=600, least_columns=96)
LIVE = Detail(rows=144, least_per_segment=16, columns=144, most_rows=600, least_columns=96)
# What is drawn with a larger radius, in pixels, is magnified: a circle of 144 steps would be off by
# a sixth of a pixel there.
MAGNIFIED_FROM = 700.0


class SurfacePart:
    """The surface over one sweep grid, and the net of lines on it: same points, no copies."""

    def __init__(self, shape: tuple[int, int, int], net: tuple[Numbers, Numbers]) -> None:
        grid = SweepGrid(*shape)
        self.grid = grid
        self.shape = shape
        points = _share(grid.points)
        self._points = points
        self._normals = numpy_to_vtk(grid.normals, deep=False)
        self._data = vtkPolyData()
        self._data.SetPoints(points)
        self._data.GetPointData().SetNormals(self._normals)
        give_openness(self._data, np.ones((len(grid.points), 2)))
        self._uv: Array | None = None
        self._flipped: bool | None = None
        self.actor = _actor(self._data)
        self._net = vtkPolyData()
        self._net.SetPoints(points)
        self._net.SetLines(_polylines(*net))
        self.net_actor = _actor(self._net)

    def paint_rows(self, colours: Array) -> None:
        """Give each row of the grid a colour of its own, (rows, 3) from 0 to 1, unshaded."""
        self.take_openness(np.ones((len(self.grid.points), 2)))
        painted = np.repeat(np.rint(255.0 * colours).astype(np.uint8), self.grid.columns, axis=0)
        self._data.GetPointData().SetScalars(numpy_to_vtk(painted, deep=True))
        mapper = self.actor.GetMapper()
        mapper.ScalarVisibilityOn()
        mapper.SetColorModeToDirectScalars()

    def take_openness(self, values: Array) -> None:
        """Set how open the points lie to the light, outside and inside, shape (points, 2)."""
        give_openness(self._data, values)

    def coordinates(self) -> Array:
        """Return the texture coordinates (u, v) to write in place, shape (points, 2), float32."""
        if self._uv is None:
            self._uv = np.zeros((len(self.grid.points), 2), np.float32)
            self._shared_uv = numpy_to_vtk(self._uv, deep=False)
            self._data.GetPointData().SetTCoords(self._shared_uv)
        return self._uv

    def coordinates_written(self) -> None:
        """Tell VTK that the texture coordinates are new."""
        self._shared_uv.Modified()
        self._data.Modified()

    def written(self) -> None:
        """Tell VTK that the grid's arrays hold new numbers."""
        if self.grid.flipped != self._flipped:
            self._flipped = self.grid.flipped
            self._connectivity = numpy_to_vtk(self.grid.outward_quads.reshape(-1), deep=False)
            quads = vtkCellArray()
            quads.SetData(4, self._connectivity)
            self._data.SetPolys(quads)
        for changed in (self._points.GetData(), self._points, self._normals):
            changed.Modified()


class LinePart:
    """Polylines of one colour, drawn where they are seen and faintly where they are hidden."""

    def __init__(self, *, lift: float = 0.0) -> None:
        self._array: Array = np.zeros((0, 3), dtype=np.float32)
        self._counts: tuple[int, ...] | None = None
        self._opacities = (1.0, 0.0)
        self._thinness = 1.0
        self._points = vtkPoints()
        self._data = vtkPolyData()
        self.actor = _actor(self._data)
        self.hidden_actor = _actor(self._data)
        for actor in (self.actor, self.hidden_actor):
            actor.GetProperty().LightingOff()
        mapper = self.actor.GetMapper()
        # Nearer than the surface they lie in, by ``lift`` units of the depth buffer.
        mapper.SetRelativeCoincidentTopologyLineOffsetParameters(0.0, -lift)

    def write(self, runs: list[Array]) -> None:
        """Show these polylines, each of shape (count, 3)."""
        counts = tuple(len(run) for run in runs)
        if counts != self._counts:
            self._counts = counts
            self._array = np.empty((sum(counts), 3), dtype=np.float32)
            self._points = _share(self._array)
            self._data.SetPoints(self._points)
            self._data.SetLines(_polylines(np.array(counts), np.arange(len(self._array))))
        if runs:
            np.concatenate(runs, out=self._array, casting="same_kind")
        self._points.GetData().Modified()
        self._points.Modified()

    def set_width(self, pixels: float) -> None:
        """Set the width of the lines in pixels of the picture.

        What is thinner than one is drawn as one, so much fainter.
        """
        self._thinness = min(1.0, pixels)
        for actor in (self.actor, self.hidden_actor):
            actor.GetProperty().SetLineWidth(max(1.0, pixels))
        self._set_opacities()

    def style(self, colour: Colour, hidden_opacity: float = 0.0, opacity: float = 1.0) -> None:
        """Set the colour, and how much of the line shows through the surface."""
        self._opacities = (opacity, hidden_opacity)
        for actor in (self.actor, self.hidden_actor):
            actor.GetProperty().SetColor(colour)
        self._set_opacities()

    def _set_opacities(self) -> None:
        for actor, opacity in zip((self.actor, self.hidden_actor), self._opacities, strict=True):
            actor.GetProperty().SetOpacity(opacity * self._thinness)

    def show(self, visible: bool) -> None:
        """Show or hide; an empty part is never drawn."""
        seen = visible and bool(self._counts)
        self.actor.SetVisibility(seen)
        self.hidden_actor.SetVisibility(seen and self._opacities[1] > 0.0)

    @property
    def positions(self) -> Array:
        """All points of the lines, shape (P, 3), float32."""
        return self._array


class MarkPart:
    """Flat glyphs that face the viewer, all in one actor, of one size in the picture."""

    def __init__(self, glyph: tuple[Array, Array]) -> None:
        self._outline, self._triangles = glyph
        self._size = 10.0
        self._centres: Array = np.zeros((0, 3))
        self._limits: Array = np.zeros(0)
        self._spacing: Array | None = None
        self._array: Array = np.zeros((0, 3), dtype=np.float32)
        self._points = vtkPoints()
        self._data = vtkPolyData()
        self._seen_from: tuple[Any, ...] | None = None
        self.actor = _actor(self._data)
        self.hidden_actor = _actor(self._data)
        for actor in (self.actor, self.hidden_actor):
            actor.GetProperty().LightingOff()

    def write(self, centres: Array, limits: Array | None = None) -> None:
        """Place the glyphs, shape (count, 3); they turn to the viewer in :meth:`face`.

        ``limits``, shape (count,), are the largest radii, so that crowded ones do not touch.
        """
        if len(centres) != len(self._centres):
            corners = len(self._outline)
            self._array = np.zeros((len(centres) * corners, 3), dtype=np.float32)
            self._points = _share(self._array)
            starts = np.arange(len(centres))[:, None, None] * corners
            triangles = (starts + self._triangles).reshape(-1).astype(np.int32)
            self._connectivity = numpy_to_vtk(triangles, deep=True)
            cells = vtkCellArray()
            cells.SetData(3, self._connectivity)
            self._data.SetPoints(self._points)
            self._data.SetPolys(cells)
        self._centres = np.asarray(centres, dtype=np.float64)
        self._spacing = None
        self._limits = np.full(len(centres), np.inf) if limits is None else limits
        self._seen_from = None

    @property
    def count(self) -> int:
        """How many glyphs there are."""
        return len(self._centres)

    def crowd(self, spacing: Array | None) -> None:
        """Let glyphs give way where they crowd; ``spacing``, shape (count,), is the room of each.

        It is in units of space, infinite for those that are drawn in full; None draws all so.
        """
        self._spacing = spacing
        self._seen_from = None

    def set_size(self, size: float) -> None:
        """Set how large a glyph is in the picture, in pixels; it is drawn in :meth:`face`."""
        self._size = size

    def face(self, pose: Pose, height_px: float) -> None:
        """Turn the glyphs to the viewer; ``height_px`` is the height of the whole picture."""
        seen_from = (pose, height_px, self._size)
        if seen_from == self._seen_from or len(self._centres) == 0:
            return
        self._seen_from = seen_from
        right, up, back = pose.basis
        pixel = 2.0 * pose.distance * tan(VIEW_ANGLE / 2.0) / height_px
        half = np.minimum(self._size / 2.0 * pixel, self._limits)
        if self._spacing is not None:
            shown = presence(self._spacing / pixel)
            small = np.where(shown > 0.0, 0.4 + 0.3 * shown, 0.0)
            half = half * np.where(np.isinf(self._spacing), 1.0, small)
        flat = self._outline[:, :1] * right + self._outline[:, 1:] * up + 0.6 * back
        corners = self._centres[:, None] + half[:, None, None] * flat
        self._array.reshape(corners.shape)[:] = corners
        self._points.GetData().Modified()
        self._points.Modified()

    def style(self, colour: Colour, hidden_opacity: float = 0.0) -> None:
        """Set the colour, and how much of a glyph shows through the surface."""
        self.actor.GetProperty().SetColor(colour)
        self.hidden_actor.GetProperty().SetColor(colour)
        self.hidden_actor.GetProperty().SetOpacity(hidden_opacity)

    def show(self, visible: bool) -> None:
        """Show or hide; an empty part is never drawn."""
        seen = visible and len(self._centres) > 0
        self.actor.SetVisibility(seen)
        self.hidden_actor.SetVisibility(seen and self.hidden_actor.GetProperty().GetOpacity() > 0.0)


def _polylines(lengths: Numbers, vertices: Numbers) -> vtkCellArray:
    """Return lines of so many vertices each, all of which follow one another."""
    offsets = np.cumsum(np.concatenate([[0], lengths]), dtype=np.int64)
    cells = vtkCellArray()
    cells.SetData(
        numpy_to_vtkIdTypeArray(offsets, deep=True),
        numpy_to_vtkIdTypeArray(vertices.astype(np.int64, copy=False), deep=True),
    )
    return cells
