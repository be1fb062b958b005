"""The frames of a film, drawn off screen by one scene that is kept from frame to frame."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np
from vtkmodules.vtkRenderingCore import vtkRenderer

from app.film import Film, Image
from app.palette import LIGHT, Palette
from app.scene import Scene
from app.scene_camera import VIEWS, Pose, standard_pose
from app.scene_offscreen import (
    LARGEST,
    REFERENCE_HEIGHT,
    SUPERSAMPLING,
    grabbed,
    offscreen_window,
)
from app.view_state import ViewState
from sgb_core.document.appearance import Background
from sgb_core.document.body_state import body_state
from sgb_core.document.evaluation import Evaluation, evaluate
from sgb_core.document.model import Document


def film_images(
    document: Document,
    film: Film,
    size: tuple[int, int],
    view: ViewState,
    *,
    direction: str = "iso",
    palette: Palette = LIGHT,
) -> Iterator[Image]:
    """Yield the frames, rows from the top, shape (h, w, 4); the camera keeps its distance.

    Raises ValueError for a size out of range or an unknown direction.
    """
    width, height = size
    if not (1 <= width <= LARGEST and 1 <= height <= LARGEST):
        raise ValueError(f"picture size is {width}x{height}; allowed is 1 to {LARGEST} a side")
    if direction not in VIEWS:
        raise ValueError(f"view is {direction!r}; allowed are {', '.join(VIEWS)}")
    finer = SUPERSAMPLING if max(size) * SUPERSAMPLING <= LARGEST else 1
    window = offscreen_window()
    window.SetSize(width * finer, height * finer)
    renderer = vtkRenderer()
    window.AddRenderer(renderer)
    scale = max(0.6, min(size) / REFERENCE_HEIGHT)
    scene = Scene(renderer, palette, pixel_ratio=scale * finer)
    try:
        pose = _pose(scene, document, film, view, width / height, direction)
        evaluation: Evaluation | None = None
        for shaped, turned in film.steps(document):
            evaluation = evaluate(shaped, evaluation)
            body = body_state(shaped, evaluation.surface, fine=True)
            scene.update(evaluation, view, fine=True, body=body)
            if document.appearance.background is Background.TRANSPARENT:
                renderer.GradientBackgroundOff()
                renderer.SetBackgroundAlpha(0.0)
                renderer.SetBackground(0.0, 0.0, 0.0)
            scene.pose = pose.turned_to(pose.azimuth + turned, pose.elevation)
            window.Render()
            yield grabbed(window, finer)
    finally:
        window.Finalize()


def _pose(
    scene: Scene, document: Document, film: Film, view: ViewState, aspect: float, direction: str
) -> Pose:
    """Return the nearest pose from which every frame's object is seen whole."""
    wanted = standard_pose(document.revolution.axis, direction, view.projection == "parallel")
    points = []
    steps = list(film.steps(document)) if film.variation is not None else [(document, 0.0)]
    for shaped, _ in steps[:: max(1, len(steps) // 8)]:
        scene.update(evaluate(shaped), view, fine=True)
        points.append(scene.points_to_fit())
    fitted = wanted.fitted(np.concatenate(points), aspect)
    if film.variation is not None:
        return fitted
    # A turned object is as wide from everywhere only about its axis.
    around = [fitted.turned_to(turn, fitted.elevation) for turn in np.linspace(0.0, 6.0, 5)]
    distance = max(pose.fitted(points[0], aspect).distance for pose in around)
    return replace(fitted, distance=max(fitted.distance, distance))
