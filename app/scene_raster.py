"""The shaded surface alone as pixels and depths, for pictures whose lines are drawn elsewhere."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkRenderingCore import vtkRenderer, vtkWindowToImageFilter

from app.palette import Palette
from app.scene import Scene
from app.scene_camera import Pose
from app.scene_offscreen import LARGEST, SUPERSAMPLING, offscreen_window, reduced
from app.scene_parts import FINE, Array
from app.view_state import ViewState
from sgb_core.document.evaluation import Evaluation

Paint: TypeAlias = Callable[[Array], Array]


@dataclass(frozen=True, slots=True, eq=False)
class Raster:
    """``image`` (h, w, 4) RGBA, rows from the top; ``depth`` (H, W), finer by a whole factor.

    A depth is the distance from the viewer's plane in the document's unit; infinite where the
    surface is not.
    """

    image: NDArray[np.uint8]
    depth: NDArray[np.float64]


def surface_raster(
    evaluation: Evaluation,
    pose: Pose,
    size: tuple[int, int],
    palette: Palette,
    paint: Paint | None = None,
    *,
    fine: bool = True,
) -> Raster:
    """Draw the surface of a document on nothing, seen from ``pose``.

    ``paint`` takes points of the profile, shape (n, K, 2), and gives the colours of the parallels
    through them, shape (n, K, 3), from 0 to 1. ``fine`` smooths edges. Raises ValueError for a
    size out of range.
    """
    width, height = size
    if not (1 <= width <= LARGEST and 1 <= height <= LARGEST):
        raise ValueError(f"picture size is {width}x{height}; allowed is 1 to {LARGEST} a side")
    factor = SUPERSAMPLING if fine and max(size) * SUPERSAMPLING <= LARGEST else 1
    window = offscreen_window()
    window.SetSize(width * factor, height * factor)
    renderer = vtkRenderer()
    window.AddRenderer(renderer)
    scene = Scene(renderer, palette)
    scene.update(evaluation, ViewState(segment=-1, show=frozenset({"surface"})), fine=True)
    if paint is not None:
        surface = evaluation.surface
        per_segment, _ = FINE.intervals(len(surface.profile), surface.sweep)
        scene.paint_rows(paint(surface.profile.sample(per_segment + 1)).reshape(-1, 3))
    scene.pose = pose
    # After the look, which has a ground of its own.
    renderer.GradientBackgroundOff()
    renderer.SetBackgroundAlpha(0.0)
    renderer.SetBackground(0.0, 0.0, 0.0)
    for layer in window.GetRenderers():
        # The empty layer of the lines would wipe out the depths.
        layer.SetPreserveDepthBuffer(layer is not renderer)
    window.Render()
    shape = (height * factor, width * factor)
    pixels = _grabbed(window, depth=False).reshape(*shape, 4)[::-1]
    raw = _grabbed(window, depth=True).reshape(shape)[::-1].astype(np.float64)
    near, far = renderer.GetActiveCamera().GetClippingRange()
    window.Finalize()
    with np.errstate(divide="ignore"):
        if pose.parallel:
            depth = near + raw * (far - near)
        else:
            depth = near * far / (far - raw * (far - near))
    depth[raw >= 1.0] = np.inf
    return Raster(reduced(pixels, factor), depth)


def _grabbed(window: object, *, depth: bool) -> Array:
    grabber = vtkWindowToImageFilter()
    grabber.SetInput(window)
    if depth:
        grabber.SetInputBufferTypeToZBuffer()
    else:
        grabber.SetInputBufferTypeToRGBA()
    grabber.ReadFrontBufferOff()
    grabber.ShouldRerenderOff()
    grabber.Update()
    return vtk_to_numpy(grabber.GetOutput().GetPointData().GetScalars())
