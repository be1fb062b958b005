"""A small picture of a mesh with its triangles, for those who are about to export it."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkLight,
    vtkPolyDataMapper,
    vtkRenderer,
)

from app.scene.actors import rgb
from app.scene.body import mesh_data
from app.scene.camera import standard_pose
from app.scene.offscreen import grabbed, offscreen_window
from app.theme.palette import Palette
from sgb_core.surfaces.mesh import Mesh
from sgb_core.surfaces.revolution import Axis

# Edges of more triangles than this would cover the picture.
MOST_EDGES = 15_000
SMOOTHING = 2


def mesh_picture(
    mesh: Mesh, axis: Axis, size: tuple[int, int], palette: Palette
) -> NDArray[np.uint8]:
    """Return a picture of a mesh as rows from the top, shape (h, w, 4), seen as at first.

    Triangles are flat, and outlined while there are not too many of them.
    """
    width, height = size
    window = offscreen_window()
    window.SetSize(width * SMOOTHING, height * SMOOTHING)
    renderer = vtkRenderer()
    renderer.SetBackground(rgb(palette.viewport_bottom))
    renderer.SetBackground2(rgb(palette.viewport_top))
    renderer.GradientBackgroundOn()
    renderer.RemoveAllLights()
    light = vtkLight()
    light.SetLightTypeToHeadlight()
    renderer.AddLight(light)
    window.AddRenderer(renderer)
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(mesh_data(mesh))
    actor = vtkActor()
    actor.SetMapper(mapper)
    look = actor.GetProperty()
    look.SetInterpolationToFlat()
    look.SetColor(rgb(palette.surface))
    look.SetAmbient(0.3)
    look.SetDiffuse(0.7)
    look.SetEdgeVisibility(len(mesh.triangles) <= MOST_EDGES)
    look.SetEdgeColor(rgb(palette.text_muted))
    look.SetLineWidth(0.6 * SMOOTHING)
    renderer.AddActor(actor)
    pose = standard_pose(axis).fitted(mesh.positions, width / height)
    low, high = mesh.bounds
    radius = float(np.linalg.norm(high - low)) / 2.0
    pose.apply(renderer.GetActiveCamera(), (low + high) / 2.0, 1.05 * radius)
    window.Render()
    image = grabbed(window, SMOOTHING)
    window.Finalize()
    image[..., 3] = 255
    return image
