"""Pictures without a window: PNG files of a scene at any size, with or without an X server."""

from __future__ import annotations

import os
import sys
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkLogger
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import vtkRenderer, vtkRenderWindow, vtkWindowToImageFilter

import resources
from app.scene.camera import Pose, standard_pose
from app.scene.scene import Scene
from app.scene.standard_views import LARGEST_PICTURE, STANDARD_VIEWS
from app.state.overlays import Overlay
from app.state.printed import Printed, planned
from app.state.view_state import ViewState
from app.theme.palette import LIGHT, Palette
from sgb_core.document.appearance.model import Background
from sgb_core.document.body_state import BodyState, body_state
from sgb_core.document.evaluation import Evaluation, evaluate
from sgb_core.document.model import Document
from sgb_core.fields.kinds import Choice, Range
from sgb_core.findings.errors import FindingError
from sgb_core.findings.refusal import Argument, Unknown
from sgb_core.surfaces.revolution import RevolutionSurface

if TYPE_CHECKING:
    from app.state.presenter import Frame

# Each pixel is the mean of so many squared; lines and edges are smooth on every driver.
SUPERSAMPLING = 2
# The picture's height at which a line is as wide as on the screen.
REFERENCE_HEIGHT = 800.0


class Sheet:
    """A scene in a window that is never shown, from which pictures are taken.

    ``factor`` is how many samples a side each pixel has. Raises ValueError for a size out of
    range. :meth:`close` lets go of the graphics.
    """

    def __init__(
        self,
        size: tuple[int, int],
        palette: Palette,
        line_scale: float | None = None,
        *,
        smooth: bool = True,
    ) -> None:
        for name, pixels in zip(("width", "height"), size, strict=True):
            if not 1 <= pixels <= LARGEST_PICTURE:
                raise FindingError(Argument(name, pixels, Range(1, LARGEST_PICTURE, whole=True)))
        self.size = size
        self.factor = (
            SUPERSAMPLING if smooth and max(size) * SUPERSAMPLING <= LARGEST_PICTURE else 1
        )
        self.window = offscreen_window()
        self.window.SetSize(*(pixels * self.factor for pixels in size))
        self.renderer = vtkRenderer()
        self.window.AddRenderer(self.renderer)
        scale = max(0.6, min(size) / REFERENCE_HEIGHT) if line_scale is None else line_scale
        self.scene = Scene(self.renderer, palette, pixel_ratio=scale * self.factor)

    @property
    def aspect(self) -> float:
        """Width over height."""
        return self.size[0] / self.size[1]

    def clear_ground(self) -> None:
        """Draw on nothing; to be called after what gives the scene a ground of its own."""
        self.renderer.GradientBackgroundOff()
        self.renderer.SetBackgroundAlpha(0.0)
        self.renderer.SetBackground(0.0, 0.0, 0.0)

    def picture(self) -> NDArray[np.uint8]:
        """Draw, and return the rows from the top, shape (h, w, 4), RGBA."""
        self.window.Render()
        return grabbed(self.window, self.factor)

    def close(self) -> None:
        """Let go of the graphics."""
        self.window.Finalize()


def pose_from(direction: str, surface: RevolutionSurface, view: ViewState) -> Pose:
    """Return a pose that is to be fitted; raises ValueError for an unknown direction."""
    if direction not in STANDARD_VIEWS:
        raise FindingError(Unknown("view", direction, Choice(STANDARD_VIEWS)))
    return standard_pose(surface.axis, direction, view.projection == "parallel")


def is_transparent(evaluation: Evaluation) -> bool:
    """Whether a document's pictures have no ground."""
    return evaluation.document.appearance.background is Background.TRANSPARENT


def render_image(
    evaluation: Evaluation,
    view: ViewState,
    size: tuple[int, int],
    *,
    pose: Pose | None = None,
    direction: str = "iso",
    palette: Palette = LIGHT,
    transparent: bool = False,
    line_scale: float | None = None,
    body: BodyState | None = None,
    printed: Printed | None = None,
) -> NDArray[np.uint8]:
    """Draw off screen and return the picture's rows from the top, shape (h, w, 4), RGBA.

    ``pose`` keeps a camera as it is; without one the object is fitted, seen from
    ``direction``. ``body`` is drawn in the surface's place, ``printed`` in that of both. Raises
    ValueError for a size out of range or an unknown direction.
    """
    wanted = pose_from(direction, evaluation.surface, view)
    sheet = Sheet(size, palette, line_scale)
    scene = sheet.scene
    scene.update(evaluation, view, fine=True, body=body, printed=printed)
    if transparent or is_transparent(evaluation):
        sheet.clear_ground()
    if pose is None:
        scene.fit(sheet.aspect, wanted)
    else:
        scene.see_from(pose)
    image = sheet.picture()
    sheet.close()
    return image


def frame_png(
    frame: Frame,
    size: tuple[int, int],
    pose: Pose | None,
    palette: Palette,
    line_scale: float,
    transparent: bool,
) -> bytes:
    """Return a PNG of what a window shows, seen from ``pose``; lines are so much wider."""
    image = render_image(
        frame.evaluation,
        frame.view,
        size,
        pose=pose,
        palette=palette,
        transparent=transparent,
        line_scale=line_scale,
        body=frame.body,
        printed=frame.printed,
    )
    return png_bytes(image)


def pixels_of(window: vtkRenderWindow, *, depth: bool = False) -> NDArray[Any]:
    """Return what a window has just rendered, rows from the top: RGBA, or the raw depths."""
    grabber = vtkWindowToImageFilter()
    grabber.SetInput(window)
    if depth:
        grabber.SetInputBufferTypeToZBuffer()
    else:
        grabber.SetInputBufferTypeToRGBA()
    grabber.ReadFrontBufferOff()
    grabber.ShouldRerenderOff()
    grabber.Update()
    width, height = window.GetSize()
    flat: NDArray[Any] = vtk_to_numpy(grabber.GetOutput().GetPointData().GetScalars())
    return flat.reshape((height, width) if depth else (height, width, 4))[::-1]


def grabbed(window: vtkRenderWindow, factor: int) -> NDArray[np.uint8]:
    """Return what a window has just rendered, ``factor`` times smaller, rows from the top.

    Shape (h, w, 4), RGBA.
    """
    return reduced(pixels_of(window), factor)


def offscreen_window() -> vtkRenderWindow:
    """Return a window that is never shown; on Linux without an X server it asks for none."""
    window = _window()
    window.OffScreenRenderingOn()
    window.SetMultiSamples(0)
    window.SetAlphaBitPlanes(1)
    return window


def _window() -> vtkRenderWindow:
    # VTK warns on standard error of X libraries that it misses and no picture needs.
    vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_ERROR)
    if sys.platform == "linux" and not os.environ.get("DISPLAY"):
        # The class exists on Linux only.
        from vtkmodules.vtkRenderingOpenGL2 import vtkEGLRenderWindow

        return vtkEGLRenderWindow()
    return vtkRenderWindow()


def reduced(pixels: NDArray[np.uint8], factor: int) -> NDArray[np.uint8]:
    """Return the mean over squares of pixels, colours weighted by their opacity."""
    height, width = pixels.shape[0] // factor, pixels.shape[1] // factor
    # One picture for each place in the square: added to each other they need no walk over axes of
    # a few numbers, which takes numpy ten times as long.
    parts = [pixels[row::factor, column::factor] for row, column in np.ndindex(factor, factor)]
    count = factor * factor
    image = np.empty((height, width, 4), dtype=np.uint8)
    total, colour = np.zeros((2, height, width, 4), np.uint32)
    if pixels[..., 3].min() == 255:
        for part in parts:
            colour += part
        image[...] = (colour + count // 2) // count
        return image
    for part in parts:
        alpha = part[..., 3:].astype(np.uint32)
        total += alpha
        colour += part * alpha
    image[..., :3] = ((colour + total // 2) // np.maximum(total, 1))[..., :3]
    image[..., 3] = ((total + count // 2) // count)[..., 3]
    return image


def png_bytes(image: NDArray[np.uint8]) -> bytes:
    """Return an image of shape (h, w, 3 or 4), rows from the top, as a PNG file."""
    height, width, channels = image.shape
    data = vtkImageData()
    data.SetDimensions(width, height, 1)
    flat = np.ascontiguousarray(image[::-1]).reshape(-1, channels)
    data.GetPointData().SetScalars(numpy_to_vtk(flat, deep=True))
    writer = vtkPNGWriter()
    writer.WriteToMemoryOn()
    writer.SetInputData(data)
    writer.Write()
    return bytes(vtk_to_numpy(writer.GetResult()))


def render_png(
    document: Document,
    size: tuple[int, int] = (1200, 800),
    view: str = "iso",
    show: frozenset[Overlay] | None = None,
    transparent: bool = False,
) -> bytes:
    """Return a PNG picture of a document as the ``render`` command writes it.

    ``show`` names the overlays, by default those that a new window shows.
    """
    state = ViewState(segment=-1)
    if show is not None:
        state = ViewState(segment=-1, show=show)
    evaluation = evaluate(document)
    body = body_state(document, evaluation.surface, fine=True, measured=False)
    image = render_image(
        evaluation,
        state,
        size,
        direction=view,
        transparent=transparent,
        body=body,
        printed=_printed(document) if state.shows(Overlay.PRINT) else None,
    )
    return png_bytes(image)


def _printed(document: Document) -> Printed:
    """Return the path of a document on the first printer that the program knows."""
    from sgb_core.toolpaths.printer import read_printer

    printer = read_printer(resources.printers()[0])
    return planned(document, printer, printer.layer.usual)
