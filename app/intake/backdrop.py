"""What a source itself looks like, in its own coordinates with y upwards, ready to be painted."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from PySide6.QtCore import QRectF
from PySide6.QtGui import QImage

from app.hand.canvas import Canvas
from app.hand.reference import picture_of
from sgb_core.arrays import Floats
from sgb_core.sources import Opened
from sgb_core.sources.drawing import Drawing
from sgb_core.values import dataclass

# Points along each piece of a path that is shown, and dots of a table at most.
_SAMPLES, _DOTS = 17, 4000
# A click this near to a path means it, in pixels.
_NEAR = 8.0


@dataclass(frozen=True, slots=True, eq=False)
class Backdrop:
    """A picture, or paths and points, of a source.

    ``low`` and ``high`` are the corners of the box around all of it.
    """

    low: Floats
    high: Floats
    picture: QImage | None = None
    paths: tuple[Floats, ...] = ()
    points: Floats | None = None

    def draw(self, canvas: Canvas, chosen: int, opacity: float) -> None:
        """Draw it faintly, the chosen path more strongly."""
        if self.picture is not None:
            left, top = canvas.transform.map((self.low[0], self.high[1])).tolist()
            right, bottom = canvas.transform.map((self.high[0], self.low[1])).tolist()
            canvas.painter.setOpacity(opacity)
            canvas.painter.setRenderHint(canvas.painter.RenderHint.SmoothPixmapTransform)
            canvas.painter.drawImage(QRectF(left, top, right - left, bottom - top), self.picture)
            canvas.painter.setOpacity(1.0)
        for number, path in enumerate(self.paths):
            pen = (
                canvas.pen("text", 1.4) if number == chosen else canvas.pen("text_muted", 1.0, 150)
            )
            canvas.polyline(canvas.transform.map(path), pen)
        if self.points is not None:
            draw_dots(canvas, self.points)

    def path_at(self, canvas_place: Floats, placed: Sequence[Floats]) -> int | None:
        """Return the number of the path whose screen places run nearest by, None for none."""
        best, least = None, _NEAR
        for number, places in enumerate(placed):
            away = float(np.hypot(*(places - canvas_place).T).min())
            if away < least:
                best, least = number, away
        return best


def draw_dots(canvas: Canvas, points: Floats) -> None:
    """Draw points, shape (N, 2), as dots."""
    canvas.painter.setPen(canvas.pen("text_muted", 2.4, 200))
    step = max(1, len(points) // _DOTS)
    for x, y in canvas.transform.map(points[::step]).tolist():
        canvas.painter.drawPoint(int(x), int(y))


def backdrop_of(source: Opened) -> Backdrop | None:
    """Return what a source looks like, None where it lies in no plane, as a mesh does."""
    content: Any = source.content
    if source.data is not None:
        picture = picture_of(source.data)
        # A pixel's middle is a whole number.
        low = np.array([-0.5, 0.5 - picture.height()])
        high = np.array([picture.width() - 0.5, 0.5])
        return Backdrop(low, high, picture=picture)
    if isinstance(content, Drawing):
        paths = tuple(path.sampled(_SAMPLES) for path in content.paths)
        every = np.concatenate(paths)
        return Backdrop(every.min(axis=0), every.max(axis=0), paths=paths)
    if isinstance(content, np.ndarray):
        return Backdrop(content.min(axis=0), content.max(axis=0), points=content)
    return None
