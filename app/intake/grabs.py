"""What can be grabbed over a source, how it is drawn, and where a held axis goes."""

from __future__ import annotations

from collections.abc import Iterable
from enum import Enum
from math import atan2, tan

import numpy as np
from PySide6.QtCore import QPointF, QRectF, Qt

from app.hand.canvas import Canvas
from sgb_core.arrays import Floats
from sgb_core.sources.options import MOST_LEAN
from sgb_core.values import dataclass

_DASHES = Qt.PenStyle.DashDotLine


class Part(Enum):
    """What of the sheet can be held."""

    AXIS = "axis"
    TOP = "top"
    BOTTOM = "bottom"
    FIRST = "first"
    SECOND = "second"
    CLICK = "click"
    PAPER = "paper"


@dataclass(frozen=True, slots=True)
class Grabs:
    """What can be grabbed: the axis, its lean, the ends of a scale, clicks (None: no clicks)."""

    axis: bool = False
    lean: bool = False
    scale: tuple[tuple[float, float], tuple[float, float]] | None = None
    clicks: tuple[tuple[float, float], ...] | None = None


def draw_axis(canvas: Canvas, ends: tuple[Floats, Floats], *, held: bool, leans: bool) -> None:
    """Draw the axis between screen places, with handles at its ends where it can lean."""
    pen = canvas.pen("accent" if held else "axis", 2.0 if held else 1.4, 255, _DASHES)
    canvas.line(*ends, pen)
    if not leans:
        return
    canvas.painter.setPen(canvas.pen("accent", 1.6))
    canvas.painter.setBrush(canvas.color("canvas"))
    for x, y in np.array(ends).tolist():
        canvas.painter.drawRect(QRectF(x - 4.5, y - 4.5, 9.0, 9.0))
    canvas.painter.setBrush(Qt.BrushStyle.NoBrush)


def draw_clicks(canvas: Canvas, places: Iterable[Floats]) -> None:
    """Draw the clicks along a line, at screen places."""
    canvas.painter.setPen(canvas.pen("accent", 2.0))
    canvas.painter.setBrush(canvas.color("canvas", 160))
    for place in places:
        canvas.painter.drawEllipse(QPointF(*place.tolist()), 5.0, 5.0)
    canvas.painter.setBrush(Qt.BrushStyle.NoBrush)


def axis_through(
    low: tuple[float, float], high: tuple[float, float], fixed: tuple[float, float], middle: float
) -> tuple[float, float]:
    """Return the abscissa at the ordinate ``middle`` and the lean of an axis from low to high.

    Leaning too far it is turned back about ``fixed``.
    """
    lean = atan2(low[0] - high[0], max(high[1] - low[1], 1e-9))
    lean = min(max(lean, -MOST_LEAN), MOST_LEAN)
    return fixed[0] - (middle - fixed[1]) * tan(lean), lean
