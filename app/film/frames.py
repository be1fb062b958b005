"""The frames of a film, drawn off screen by one scene that is kept from frame to frame."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from app.film.film import Film, Image
from app.scene.camera import Pose
from app.scene.offscreen import Sheet, is_transparent, pose_from
from app.state.view_state import ViewState
from app.theme.palette import LIGHT, Palette
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
    wanted = pose_from(direction, document.surface, view)
    sheet = Sheet(size, palette)
    try:
        pose = _fitted(sheet, document, film, view, wanted)
        evaluation: Evaluation | None = None
        for shaped, turned in film.steps(document):
            evaluation = evaluate(shaped, evaluation)
            body = body_state(shaped, evaluation.surface, fine=True, measured=False)
            sheet.scene.update(evaluation, view, fine=True, body=body)
            if is_transparent(evaluation):
                sheet.clear_ground()
            sheet.scene.see_from(pose.turned_to(pose.azimuth + turned, pose.elevation))
            yield sheet.picture()
    finally:
        sheet.close()


def _fitted(sheet: Sheet, document: Document, film: Film, view: ViewState, wanted: Pose) -> Pose:
    """Return the nearest pose from which every frame's object is seen whole."""
    scene, aspect = sheet.scene, sheet.aspect
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
