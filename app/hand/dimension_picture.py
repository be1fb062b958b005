"""Draws the dimension lines of the document: with arrows, their values, and a padlock on locks."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QPen

from app.hand.canvas import Canvas, clipped
from app.hand.coordinates import Paper
from app.hand.dimension_lines import DimensionLine, dimension_lines
from app.hand.hit_test import Handle, Target
from app.state.presenter import Frame
from sgb_core.arrays import Floats
from sgb_core.design.locks.dimension import Dimension, DimensionKind, Quantity
from sgb_core.design.locks.spans import Way
from sgb_core.document.dimensions import dimension_value

_PADLOCK = 11.0
_GAP = 5.0
_K = DimensionKind


def draw_dimensions(canvas: Canvas, frame: Frame, active: Handle | None, paper: Paper) -> None:
    """Draw the lines of all dimensions on a paper; a lock that stopped the hand lights up."""
    document = frame.document
    stopped = () if frame.in_the_way is None else frame.in_the_way.numbers
    taken: list[QRectF] = []
    for line in dimension_lines(document, paper):
        dimension = document.dimensions[line.number]
        lit = active is not None and (active.target, active.index) == (
            Target.DIMENSION,
            line.number,
        )
        name = "warning" if line.number in stopped else "accent" if lit else "text"
        _draw_line(canvas, line, name, strong=lit or line.number in stopped)
        _draw_value(canvas, line, dimension, _words(frame, dimension), name, taken)
    for number, dimension in enumerate(document.dimensions):
        if dimension.kind is _K.POINT and dimension.locked:
            segment, point = dimension.points[0]
            place = paper.map(document.profile.segments[segment].points[point])
            name = "warning" if number in stopped else "text"
            _draw_padlock(canvas, place + np.array((9.0, -9.0)), name)
        elif dimension.kind is _K.JOINT and dimension.locked and dimension.joint is not None:
            place = paper.map(document.profile.segments[dimension.joint].points[3])
            name = "warning" if number in stopped else "text"
            _draw_padlock(canvas, place + np.array((-9.0, -9.0)), name)


def _words(frame: Frame, dimension: Dimension) -> str:
    document = frame.document
    value = dimension.value
    if value is None:
        value = dimension_value(document, dimension)
    if value is None:
        return ""
    sign = "R " if dimension.kind is _K.RADIUS else "⌀ " if "diameter" in dimension.kind else ""
    degrees = dimension.facts.quantity is Quantity.ANGLE
    return f"{sign}{value:.5g}" + ("°" if degrees else f" {document.unit}")


def _draw_line(canvas: Canvas, line: DimensionLine, name: str, *, strong: bool) -> None:
    pen = canvas.pen(name, 2.0 if strong else 1.1, 235 if strong else 190)
    if line.aside != (0.0, 0.0):
        # Lines lead from what is measured to its dimension.
        thin = canvas.pen(name, 0.8, 110)
        reach = np.array(line.aside) * (1.0 + 4.0 / float(np.hypot(*line.aside)))
        for end in (line.start, line.end):
            foot = end - line.aside
            canvas.line(foot, foot + reach, thin)
    if line.place is not None:
        canvas.line(line.end, line.place, canvas.pen(name, 0.8, 110))
    middle = (line.start + line.end) / 2.0
    if line.arc is not None:
        _draw_angle(canvas, line, line.arc, pen)
        return
    if line.is_short:
        outer = line.drawn
        canvas.line(line.start, line.end, pen)
        canvas.arrow(outer[0], line.start, pen, 7.0)
        canvas.arrow(outer[1], line.end, pen, 7.0)
        return
    canvas.arrow(middle, line.end, pen, 7.0)
    if line.span.way is Way.RADIUS:
        canvas.line(middle, line.start, pen)
    else:
        canvas.arrow(middle, line.start, pen, 7.0)


def _draw_angle(canvas: Canvas, line: DimensionLine, arc: Floats, pen: QPen) -> None:
    """Draw an angle's line, the way it is measured from, and the arc between them."""
    canvas.line(line.start, line.end, pen)
    canvas.line(arc[0], arc[0] + 1.15 * (arc[1] - arc[0]), pen)
    for a, b in pairwise(arc[1:-1]):
        canvas.line(a, b, pen)
    canvas.arrow(arc[-2], arc[-1], pen, 7.0)


def _draw_value(
    canvas: Canvas,
    line: DimensionLine,
    dimension: Dimension,
    words: str,
    name: str,
    taken: list[QRectF],
) -> None:
    seen = clipped(line.start, line.end, canvas.area.grown(-4.0))
    if not words or seen is None:
        return
    x, y = (np.array(seen[0]) + np.array(seen[1])) / 2.0
    if line.arc is not None:
        # On the arc, half way.
        x, y = line.arc[len(line.arc) // 2]
    elif line.is_short:
        # Beyond the arrow at its end: between them there is no room.
        x, y = line.drawn[1] + 0.9 * (line.drawn[1] - line.end)
    if line.span.way is Way.ACROSS and abs(line.start[0] - line.end[0]) > 90.0:
        # Beside the axis, whose own line runs through the middle.
        x = 0.3 * float(line.start[0]) + 0.7 * float(line.end[0])
    width, height = canvas.size_of(words)
    mark = _PADLOCK + _GAP if dimension.locked else 0.0
    left = min(
        max(float(x) - (width + mark) / 2.0, canvas.area.left + 3.0),
        canvas.area.right - width - mark - 3.0,
    )
    y = min(max(float(y), canvas.area.top + height / 2.0 + 1.0), canvas.area.bottom - height)
    box = QRectF(left, y - height / 2.0, width + mark, height)
    # Values of lines that cross stand below each other.
    while any(box.intersects(other) for other in taken) and box.bottom() < canvas.area.bottom:
        box.translate(0.0, height)
    taken.append(box)
    y = box.center().y()
    painter = canvas.painter
    painter.setPen(Qt.PenStyle.NoPen)
    painter.setBrush(canvas.color("canvas", 230))
    painter.drawRoundedRect(box.adjusted(-3, 0, 3, 0), 3, 3)
    painter.setBrush(Qt.BrushStyle.NoBrush)
    canvas.occupy(box)
    canvas.text(box.adjusted(mark, 0, 0, 0), words, canvas.color(name), halo=False)
    if dimension.locked:
        _draw_padlock(canvas, np.array((left + _PADLOCK / 2.0, float(y))), name)


def _draw_padlock(canvas: Canvas, at: Floats, name: str) -> None:
    x, y = float(at[0]), float(at[1])
    painter = canvas.painter
    painter.setPen(canvas.pen(name, 1.3))
    painter.setBrush(canvas.color(name))
    painter.drawRect(QRectF(x - 3.6, y - 0.8, 7.2, 5.2))
    painter.setBrush(Qt.BrushStyle.NoBrush)
    painter.drawArc(QRectF(x - 2.4, y - 4.6, 4.8, 6.6), 0, 180 * 16)
    painter.drawLine(QPointF(x - 2.4, y - 1.3), QPointF(x - 2.4, y - 0.6))
