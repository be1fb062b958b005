"""The picture that a profile came from, upright in the profile's plane."""

from __future__ import annotations

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkImageData, vtkPolyData
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkRenderer, vtkTexture

from app.scene import shapes
from sgb_core.document.appearance.pictures import decode
from sgb_core.document.reference import Reference
from sgb_core.surfaces.revolution import RevolutionSurface

# The larger side of the texture at most, in pixels.
_LARGEST = 2048


class ReferencePart:
    """A textured rectangle in the half-plane where the turn starts, and beyond the axis."""

    def __init__(self, renderer: vtkRenderer) -> None:
        self._points = np.zeros((4, 3))
        points, quad, data = vtkPoints(), vtkCellArray(), vtkPolyData()
        points.SetData(numpy_to_vtk(self._points, deep=False))
        quad.InsertNextCell(4, [0, 1, 2, 3])
        data.SetPoints(points)
        data.SetPolys(quad)
        corners = np.array([(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)], np.float32)
        data.GetPointData().SetTCoords(numpy_to_vtk(corners, deep=True))
        self._data, self._texture = data, vtkTexture()
        self._texture.InterpolateOn()
        mapper = vtkPolyDataMapper()
        mapper.SetInputData(data)
        self.actor = vtkActor()
        self.actor.SetMapper(mapper)
        self.actor.SetTexture(self._texture)
        self.actor.GetProperty().LightingOff()
        self.actor.UseBoundsOff()
        self.actor.VisibilityOff()
        renderer.AddActor(self.actor)
        self._shown: tuple[Reference | None, RevolutionSurface | None] = (None, None)
        self._size = (1, 1)

    def update(self, source: Reference | None, surface: RevolutionSurface) -> None:
        """Show the picture of a reference, where it has one that is shown."""
        before = self._shown
        if before[0] is source and before[1] is surface:
            return
        self._shown = (source, surface)
        seen = source is not None and source.shown and source.picture is not None
        self.actor.SetVisibility(seen)
        if source is None or source.picture is None or not seen:
            return
        if before[0] is None or before[0].picture is not source.picture:
            self._write_texture(source.picture.data)
        self.actor.GetProperty().SetOpacity(source.opacity)
        width, height = self._size
        left, top, right, bottom = -0.5, -0.5, width - 0.5, height - 0.5
        places = source.placed([(left, bottom), (right, bottom), (right, top), (left, top)])
        self._points[:] = shapes.in_profile_plane(surface, places)
        self._data.GetPoints().GetData().Modified()
        self._data.GetPoints().Modified()

    def _write_texture(self, data: bytes) -> None:
        pixels = decode(data)
        height, width = pixels.shape[:2]
        self._size = (width, height)
        step = -(-max(width, height) // _LARGEST)
        pixels = np.ascontiguousarray(pixels[::step, ::step, :3])
        image = vtkImageData()
        image.SetDimensions(pixels.shape[1], pixels.shape[0], 1)
        image.GetPointData().SetScalars(numpy_to_vtk(pixels.reshape(-1, 3), deep=True))
        self._texture.SetInputData(image)
