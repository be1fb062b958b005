"""What is around the object: a soft shadow on the ground, and lines at its edges and kinks."""

from __future__ import annotations

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkRenderer

from app.scene import shapes
from app.scene.actors import Array
from sgb_core.document.evaluation import Evaluation
from sgb_core.surfaces.ambient_occlusion import Ground as Shaded
from sgb_core.surfaces.revolution import RevolutionSurface

_SIDES = 72
# How much of the light of the ground a shadow can take.
_DARKEST = 0.52
# A joint bent by more degrees than this is an edge.
_KINK = 5.0


def upward(surface: RevolutionSurface) -> tuple[float, float, float]:
    """Return the direction of growing heights, a unit vector."""
    x, y, z = surface.directions(np.zeros(1))[0, 2]
    return float(x), float(y), float(z)


class Ground:
    """The shadow that a soft sky casts under a turned object: darkest where it stands."""

    def __init__(self, renderer: vtkRenderer) -> None:
        self._points = vtkPoints()
        self._data = vtkPolyData()
        self._data.SetPoints(self._points)
        mapper = vtkPolyDataMapper()
        mapper.SetInputData(self._data)
        mapper.SetColorModeToDirectScalars()
        self.actor = vtkActor()
        self.actor.SetMapper(mapper)
        self.actor.UseBoundsOff()
        prop = self.actor.GetProperty()
        prop.LightingOff()
        # From below the ground is not in the way.
        prop.BackfaceCullingOn()
        self.actor.ForceTranslucentOn()
        self.actor.SetVisibility(False)
        renderer.AddActor(self.actor)

    def show(self, visible: bool) -> None:
        """Show or hide the shadow."""
        self.actor.SetVisibility(visible and self._points.GetNumberOfPoints() > 0)

    def write(self, surface: RevolutionSurface, ground: Shaded) -> None:
        """Lay the shadow under a surface."""
        out, reach = ground.distances, ground.distances[-1]
        angles = np.linspace(0.0, 2.0 * np.pi, _SIDES, endpoint=False)
        ways = ground.brightness.shape[1]
        around = angles / (2.0 * np.pi) * ways
        first = around.astype(np.intp)
        part = around - first
        light = ground.brightness[:, first] * (1.0 - part)
        light += ground.brightness[:, (first + 1) % ways] * part
        # It runs out before the edge of most pictures.
        dark = _DARKEST * (1.0 - light) * ((1.0 - (out / reach) ** 2) ** 2)[:, None]
        below = ground.height - 0.002 * reach
        grid = np.broadcast_arrays(out[:, None], below, ground.start + angles)
        places = shapes.place(surface, *(part.ravel() for part in grid))
        self._points.SetData(numpy_to_vtk(np.ascontiguousarray(places, np.float32), deep=True))
        colours = np.zeros((len(out), _SIDES, 4), np.uint8)
        colours[..., :3] = (20, 22, 26)
        colours[..., 3] = np.rint(255.0 * dark)
        self._data.GetPointData().SetScalars(numpy_to_vtk(colours.reshape(-1, 4), deep=True))
        if self._data.GetNumberOfCells() == 0:
            self._data.SetPolys(_disc_quads(len(out)))
        self._points.Modified()
        self._data.Modified()


def _disc_quads(rings: int) -> vtkCellArray:
    ring = np.arange(rings - 1)[:, None] * _SIDES
    side = np.arange(_SIDES)
    after = (side + 1) % _SIDES
    quads = np.stack([ring + side, ring + _SIDES + side, ring + _SIDES + after, ring + after], -1)
    cells = vtkCellArray()
    cells.SetData(4, numpy_to_vtk(quads.reshape(-1).astype(np.int32), deep=True))
    return cells


def feature_lines(evaluation: Evaluation) -> list[Array]:
    """Return the circles at rims, gaps and kinks, and the ends of a part turn."""
    surface = evaluation.surface
    profile = surface.profile
    points = profile.control_points
    edges = [] if profile.closed else [points[0, 0], points[-1, 3]]
    for report in evaluation.joints:
        before, after = profile.neighbours(report.joint)
        if report.kink_deg is None:
            edges += [points[before, 3], points[after, 0]]
        elif report.kink_deg > _KINK:
            edges.append(points[before, 3])
    angles = surface.angles(128)
    lines = [
        np.asarray(
            shapes.place(surface, np.full(129, r), np.full(129, h), angles), dtype=np.float32
        )
        for r, h in edges
        if abs(r) > 1e-9 * profile.size
    ]
    if not surface.is_full_turn:
        for angle in (angles[0], angles[-1]):
            for run in profile.sample(33):
                lines.append(
                    np.asarray(
                        shapes.place(surface, run[:, 0], run[:, 1], np.full(33, angle)), np.float32
                    )
                )
    return lines
