"""The traced chain over its source, coloured by how far the source's points are from it."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from PySide6.QtCore import QPointF, Qt
from PySide6.QtGui import QColor, QPen

from app.hand.canvas import Canvas, polygon
from app.intake.work import PLACES, Traced
from sgb_core.arrays import Floats
from sgb_core.curves import basis
from sgb_core.sources.reading import Frame

# Deviations of so many parts of the tolerance get a colour of their own.
_SHADES = 12
_ROUND, _WIDTH = Qt.PenCapStyle.RoundCap, 3.0


def draw_chain(canvas: Canvas, traced: Traced) -> None:
    """Draw the chain with its mirror image, coloured by deviation, with its joints."""
    profile, frame = traced.taken.trace.profile, traced.reading.frame or Frame((0.0, 0.0))
    # A left side alone is drawn where it was seen.
    sign = -1.0 if traced.reading.right is None else 1.0
    s = np.linspace(0.0, 1.0, PLACES)
    places = basis.bernstein(4, s) @ profile.quartics
    mirrored = canvas.transform.map(frame.placed(places * (-sign, 1.0)))
    for part in mirrored:
        canvas.polyline(part, canvas.pen("generatrix", 1.4, 150))
    own = canvas.transform.map(frame.placed(places * (sign, 1.0)))
    for part in own:
        canvas.polyline(part, canvas.pen("canvas", _WIDTH + 2.5, 170))
    shares = traced.deviations / traced.taken.trace.tolerance
    for part, share in zip(own, shares, strict=True):
        _draw_shaded(canvas, part, share)
    ends = np.concatenate([own[:, 0], own[-1:, -1]])
    canvas.painter.setPen(canvas.pen("canvas", 1.0))
    canvas.painter.setBrush(canvas.color("text"))
    for x, y in ends.tolist():
        canvas.painter.drawEllipse(QPointF(x, y), 4.0, 4.0)
    canvas.painter.setBrush(Qt.BrushStyle.NoBrush)


def _draw_shaded(canvas: Canvas, places: Floats, share: Floats) -> None:
    between = (share[:-1] + share[1:]) / 2.0
    shades = np.minimum((between * _SHADES).astype(int), _SHADES)
    borders = np.flatnonzero(np.diff(shades)) + 1
    for run in np.split(np.arange(len(shades)), borders):
        pen = QPen(shade(canvas, float(shades[run[0]]) / _SHADES), _WIDTH)
        pen.setCapStyle(_ROUND)
        canvas.painter.setPen(pen)
        canvas.painter.drawPolyline(polygon(places[run[0] : run[-1] + 2]))


def shade(canvas: Canvas, share: float) -> QColor:
    """Return the colour of a deviation as a part of the tolerance: good, middling, beyond."""
    good, middle, bad = (canvas.color(name) for name in ("good", "warning", "error"))
    if share >= 1.0:
        return bad
    first, second, part = (
        (good, middle, 2.0 * share) if share < 0.5 else (middle, bad, 2.0 * share - 1.0)
    )
    mixed = [
        round(a + part * (b - a))
        for a, b in zip(first.getRgb()[:3], second.getRgb()[:3], strict=True)  # type: ignore[index]
    ]
    return QColor(*mixed)


def draw_scale(canvas: Canvas, ends: Sequence[Floats]) -> None:
    """Draw the two points whose true distance is given, with the line between them."""
    canvas.line(ends[0], ends[1], canvas.pen("canvas", 5.0, 170))
    canvas.line(ends[0], ends[1], canvas.pen("selection", 2.0))
    canvas.painter.setPen(canvas.pen("selection", 2.0))
    for x, y in np.array(ends).tolist():
        canvas.painter.drawLine(QPointF(x - 7.0, y), QPointF(x + 7.0, y))
        canvas.painter.drawLine(QPointF(x, y - 7.0), QPointF(x, y + 7.0))
        canvas.painter.drawEllipse(QPointF(x, y), 5.0, 5.0)
