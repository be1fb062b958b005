"""The shaded surface alone as pixels and depths, for pictures whose lines are drawn elsewhere."""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from app.scene.actors import FINE, Array
from app.scene.camera import Pose
from app.scene.offscreen import Sheet, pixels_of
from app.state.overlays import Overlay
from app.state.view_state import ViewState
from app.theme.palette import Palette
from sgb_core.document.body_state import BodyState
from sgb_core.document.evaluation import Evaluation
from sgb_core.values import dataclass

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
    body: BodyState | None = None,
    fine: bool = True,
) -> Raster:
    """Draw the surface of a document, or its ``body``, on nothing, seen from ``pose``.

    ``paint`` takes points of the profile, shape (n, K, 2), and gives the colours of the parallels
    through them, shape (n, K, 3), from 0 to 1. ``fine`` smooths edges. Raises ValueError for a
    size out of range.
    """
    sheet = Sheet(size, palette, 1.0, smooth=fine)
    scene = sheet.scene
    view = ViewState(segment=-1, show=frozenset({Overlay.SURFACE}))
    scene.update(evaluation, view, fine=True, body=body)
    if paint is not None:
        surface = evaluation.surface
        per_segment, _ = FINE.intervals(len(surface.profile), surface.sweep)
        scene.paint_rows(paint(surface.profile.sample(per_segment + 1)).reshape(-1, 3))
    scene.see_from(pose)
    sheet.clear_ground()
    for layer in sheet.window.GetRenderers():
        # The empty layer of the lines would wipe out the depths.
        layer.SetPreserveDepthBuffer(layer is not sheet.renderer)
    image = sheet.picture()
    raw = pixels_of(sheet.window, depth=True).astype(np.float64)
    near, far = sheet.renderer.GetActiveCamera().GetClippingRange()
    sheet.close()
    with np.errstate(divide="ignore"):
        if pose.parallel:
            depth = near + raw * (far - near)
        else:
            depth = near * far / (far - raw * (far - near))
    depth[raw >= 1.0] = np.inf
    return Raster(image, depth)
