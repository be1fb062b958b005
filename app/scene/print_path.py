"""The path of a printer in the 3-D picture: its beads up to a moment, the nozzle and the bed."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkRenderer

from app.scene.actors import Array, LinePart, rgb
from app.state.overlays import Overlay
from app.state.path_colours import shade_numbers, shades
from app.state.view_state import ViewState
from app.theme.palette import LIGHT, Palette
from sgb_core.document.appearance.pictures import Pixels
from sgb_core.document.model import Document
from sgb_core.surfaces.revolution import RevolutionSurface
from sgb_core.toolpaths.beads import Beads, bed_lines
from sgb_core.toolpaths.toolpath import Toolpath

if TYPE_CHECKING:
    from app.state.printed import Printed

# The nozzle: how high and how wide it is beside the size of what is printed, and its sides.
_HIGH, _WIDE, _SIDES = 0.16, 0.05, 24


class BeadPart:
    """The beads of one fineness; their arrays are kept, and as many are drawn as are printed."""

    def __init__(self, renderer: vtkRenderer) -> None:
        self._beads: Beads | None = None
        self._data, self.actor = _part(renderer)
        mapper = self.actor.GetMapper()
        mapper.ScalarVisibilityOn()
        mapper.SetColorModeToDirectScalars()

    def write(self, surface: RevolutionSurface, path: Toolpath, found: Beads) -> None:
        """Lay the beads where they are printed."""
        self._beads = found
        corners = on_bed(surface, path, found.corners.reshape(-1, 3))
        _set(self._data, corners, _turned(surface, found.normals.reshape(-1, 3)))

    def paint(self, colours: Pixels) -> None:
        """Give the moves their colours, shape (k, 3) for the points of the path."""
        assert self._beads is not None
        painted = np.repeat(colours[self._beads.kept], 4, axis=0)
        self._data.GetPointData().SetScalars(numpy_to_vtk(painted, deep=True))
        self._data.Modified()

    def show_until(self, times: Array, now: float) -> None:
        """Draw what is printed ``now``; ``times`` are when the path is at its points."""
        found = self._beads
        assert found is not None
        count = int(np.searchsorted(times[found.kept[found.moves]], now + 1e-9, side="right"))
        cells = vtkCellArray()
        flat = found.quads[:count].reshape(-1).astype(np.int32)
        cells.SetData(4, numpy_to_vtk(flat, deep=True))
        self._data.SetPolys(cells)
        self._data.Modified()


class PathPart:
    """Shown in the surface's place; written only where path, colours or moment are others."""

    def __init__(self, renderer: vtkRenderer) -> None:
        self.shown = False
        self._path: Toolpath | None = None
        self._surface: RevolutionSurface | None = None
        self._clock: Array = np.zeros(1)
        self._measure: tuple[str, Palette] | None = None
        self._moment: float | None = None
        self._palette = LIGHT
        # Those of the resting picture, and those of one that moves.
        self.fine, self.rough = BeadPart(renderer), BeadPart(renderer)
        self._tip, self.nozzle = _part(renderer)
        for actor in (self.fine.actor, self.rough.actor, self.nozzle):
            actor.GetProperty().SetAmbient(0.45)
            actor.GetProperty().SetDiffuse(0.6)
        self.bed, self.outline = LinePart(), LinePart()
        for lines in (self.bed, self.outline):
            renderer.AddActor(lines.actor)
        self.farthest: Array = np.zeros((0, 3))

    def update(
        self,
        printed: Printed | None,
        document: Document,
        view: ViewState,
        surface: RevolutionSurface,
        *,
        fine: bool,
    ) -> None:
        """Show the path where it is this document's and asked for."""
        here = printed if printed is not None and printed.document is document else None
        path = None if here is None or not view.shows(Overlay.PRINT) else here.path
        self.shown = path is not None
        if here is not None and path is not None:
            self._write(path, here, surface)
            self._paint(path, view.path_measure)
            self._show_until(path, surface, view.path_moment)
        self.fine.actor.SetVisibility(self.shown and fine)
        self.rough.actor.SetVisibility(self.shown and not fine)
        self.nozzle.SetVisibility(self.shown)
        for lines in (self.bed, self.outline):
            lines.show(self.shown)

    def style(self, palette: Palette) -> None:
        """Take all colours from a theme."""
        self._palette = palette
        self.nozzle.GetProperty().SetColor(rgb(palette.accent))
        self.bed.style(rgb(palette.grid_major), opacity=0.6)
        self.outline.style(rgb(palette.text))
        if self.shown and self._path is not None and self._measure is not None:
            self._paint(self._path, self._measure[0])

    def set_pixel_ratio(self, ratio: float) -> None:
        """Set how many pixels of the picture one pixel of line width is."""
        self.bed.set_width(1.0 * ratio)
        self.outline.set_width(2.0 * ratio)

    def reach(self, centre: Array) -> float:
        """Return how far from a point anything shown lies."""
        if not self.shown or not len(self.farthest):
            return 0.0
        return float(np.sqrt(((self.farthest - centre) ** 2).sum(axis=1).max()))

    def _write(self, path: Toolpath, printed: Printed, surface: RevolutionSurface) -> None:
        if path is self._path and surface is self._surface:
            return
        self._path, self._surface = path, surface
        self._measure = self._moment = None
        self._clock = np.cumsum(path.times)
        for part, found in ((self.fine, printed.beads), (self.rough, printed.rough)):
            assert found is not None
            part.write(surface, path, found)
        lines = [on_bed(surface, path, line) for line in bed_lines(path.plan.printer.bed)]
        self.outline.write(lines[:1])
        self.bed.write(lines[1:])
        box = np.stack(np.meshgrid(*zip(*path.bounds, strict=True)), axis=-1).reshape(-1, 3)
        self.farthest = np.concatenate([lines[0], on_bed(surface, path, box)])

    def _paint(self, path: Toolpath, measure: str) -> None:
        key = (measure, self._palette)
        if key == self._measure:
            return
        self._measure = key
        colours = shades(self._palette)[shade_numbers(path, measure)]
        for part in (self.fine, self.rough):
            part.paint(colours)

    def _show_until(self, path: Toolpath, surface: RevolutionSurface, moment: float) -> None:
        if moment == self._moment:
            return
        self._moment = moment
        times = self._clock
        now = moment * float(times[-1])
        for part in (self.fine, self.rough):
            part.show_until(times, now)
        tip = np.array([np.interp(now, times, row) for row in path.points.T])
        size = float(np.linalg.norm(path.bounds[1] - path.bounds[0]))
        points, normals, sides = _cone(tip, _HIGH * size, _WIDE * size)
        _set(self._tip, on_bed(surface, path, points), _turned(surface, normals))
        cone = vtkCellArray()
        cone.SetData(3, numpy_to_vtk(sides.reshape(-1).astype(np.int32), deep=True))
        self._tip.SetPolys(cone)
        self._tip.Modified()


def on_bed(surface: RevolutionSurface, path: Toolpath, points: Array) -> Array:
    """Return where points of a path, in mm and shape (k, 3), lie in the picture of a surface."""
    flat = _upright(surface, points + np.array([0.0, 0.0, path.ground]))
    return surface.placement.apply(flat / path.scale)


def _turned(surface: RevolutionSurface, vectors: Array) -> Array:
    return surface.placement.apply_to_directions(_upright(surface, vectors))


def _upright(surface: RevolutionSurface, vectors: Array) -> Array:
    """Return vectors with their angle counted from the surface's start, along its axis."""
    h, u, v = surface.axis.frame
    cosine, sine = np.cos(surface.start), np.sin(surface.start)
    found = np.empty_like(vectors)
    found[:, u] = vectors[:, 0] * cosine - vectors[:, 1] * sine
    found[:, v] = vectors[:, 0] * sine + vectors[:, 1] * cosine
    found[:, h] = vectors[:, 2]
    return found


def _cone(tip: Array, high: float, wide: float) -> tuple[Array, Array, Array]:
    """Return a nozzle over its tip: points and normals (k, 3), triangles (m, 3)."""
    angle = np.arange(_SIDES) * (2.0 * np.pi / _SIDES)
    round_ = np.column_stack([np.cos(angle), np.sin(angle), np.zeros(_SIDES)])
    rim = tip + wide * round_ + np.array([0.0, 0.0, high])
    normals = round_ - np.array([0.0, 0.0, wide / high])
    k = np.arange(_SIDES)
    points = np.concatenate([np.repeat(tip[None], _SIDES, axis=0), rim])
    sides = np.column_stack([k, _SIDES + (k + 1) % _SIDES, _SIDES + k])
    return points, np.concatenate([normals, normals]), sides


def _part(renderer: vtkRenderer) -> tuple[vtkPolyData, vtkActor]:
    data = vtkPolyData()
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(data)
    mapper.ScalarVisibilityOff()
    mapper.SetVBOShiftScaleMethod(0)
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.UseBoundsOff()
    actor.SetVisibility(False)
    renderer.AddActor(actor)
    return data, actor


def _set(data: vtkPolyData, points: Array, normals: Array) -> None:
    shared = vtkPoints()
    shared.SetData(numpy_to_vtk(np.ascontiguousarray(points, np.float32), deep=True))
    data.SetPoints(shared)
    flat = np.ascontiguousarray(normals, np.float32)
    data.GetPointData().SetNormals(numpy_to_vtk(flat, deep=True))
