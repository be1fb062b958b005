"""Grid, rulers and rotation axis of the profile editor."""

from __future__ import annotations

from PySide6.QtCore import QLineF, QPointF, QRectF, Qt
from PySide6.QtGui import QFont, QFontMetricsF, QPen, QPolygonF

from app.hand.canvas import Canvas
from app.hand.coordinates import (
    Area,
    GridSteps,
    ScreenPoint,
    Transform,
    decimals_for,
    number,
    ticks,
)


def ruler_sizes(font: QFont, transform: Transform, height: float) -> tuple[float, float]:
    """Return the width of the height ruler and the height of the radius ruler, in pixels."""
    metrics = QFontMetricsF(font)
    steps = GridSteps.at(transform.scale)
    decimals = decimals_for(steps.major)
    ends = [(transform.y0 - y) / transform.scale for y in (0.0, height)]
    widest = max(metrics.horizontalAdvance(number(end, decimals)) for end in ends)
    return max(30.0, widest + 13.0), metrics.height() + 7.0


def draw_grid(canvas: Canvas) -> None:
    """Draw fine and numbered grid lines."""
    area, transform = canvas.area, canvas.transform
    steps = GridSteps.at(transform.scale)
    for step, name in ((steps.minor, "grid_minor"), (steps.major, "grid_major")):
        lines = [
            QLineF(x, area.top, x, area.bottom) for _, x in _verticals(transform, area, step)
        ] + [QLineF(area.left, y, area.right, y) for _, y in _horizontals(transform, area, step)]
        canvas.painter.setPen(canvas.pen(name))
        canvas.painter.drawLines(lines)


def draw_axis(canvas: Canvas, name: str) -> None:
    """Draw the rotation axis r = 0 as a centre line, or say on which side it lies."""
    area, x = canvas.area, canvas.transform.x0
    if area.left <= x <= area.right:
        pen = QPen(canvas.pen("axis", 1.4))
        pen.setCapStyle(Qt.PenCapStyle.FlatCap)
        pen.setDashPattern([12.0, 3.0, 2.0, 3.0])
        canvas.painter.setPen(pen)
        canvas.painter.drawLine(QPointF(x, area.top), QPointF(x, area.bottom))
    else:
        text = f"◂ {name}" if x < area.left else f"{name} ▸"
        width, height = canvas.size_of(text)
        left = area.left + 6.0 if x < area.left else area.right - 6.0 - width
        box = QRectF(left, area.top + 4.0, width, height)
        canvas.text(box, text, canvas.color("text_muted"))
        canvas.occupy(box)


def name_axis(canvas: Canvas, name: str) -> None:
    """Write the axis' name beside it, above or below, where nothing else is written or drawn."""
    area, x = canvas.area, canvas.transform.x0
    if not area.left <= x <= area.right:
        return
    width, height = canvas.size_of(name)
    for top in (area.top + 4.0, area.bottom - 4.0 - height):
        for left in (x + 7.0, x - 7.0 - width):
            box = QRectF(left, top, width, height)
            if area.left < left and left + width < area.right and canvas.covered(box) == 0:
                canvas.text(box, name, canvas.color("text_muted"))
                canvas.occupy(box)
                return


def draw_rulers(canvas: Canvas, size: tuple[float, float], unit: str) -> None:
    """Draw the numbered strips at the left and at the bottom, and the unit in their corner."""
    area, transform, painter = canvas.area, canvas.transform, canvas.painter
    width, height = size
    painter.setPen(Qt.PenStyle.NoPen)
    painter.setBrush(canvas.color("panel"))
    painter.drawRect(QRectF(0, 0, area.left, height))
    painter.drawRect(QRectF(0, area.bottom, width, height - area.bottom))
    painter.setBrush(Qt.BrushStyle.NoBrush)
    painter.setPen(canvas.pen("border"))
    painter.drawLine(QPointF(area.left, 0), QPointF(area.left, area.bottom))
    painter.drawLine(QPointF(area.left, area.bottom), QPointF(width, area.bottom))

    steps = GridSteps.at(transform.scale)
    painter.drawLines(
        [
            QLineF(x, area.bottom, x, area.bottom + (4.0 if k % 5 else 5.0))
            for k, x in _verticals(transform, area, steps.minor)
        ]
        + [
            QLineF(area.left - 4.0, y, area.left, y)
            for _, y in _horizontals(transform, area, steps.minor)
        ]
    )
    decimals = decimals_for(steps.major)
    painter.setFont(canvas.font)
    painter.setPen(canvas.color("text_muted"))
    _, text_height = canvas.size_of("0")
    for k, x in _verticals(transform, area, steps.major):
        text = number(k * steps.major, decimals)
        half = canvas.size_of(text)[0] / 2.0 + 1.0
        if area.left + half <= x <= width - half:
            box = QRectF(x - half, area.bottom + 5.0, 2.0 * half, text_height)
            painter.drawText(box, Qt.AlignmentFlag.AlignCenter, text)
    for k, y in _horizontals(transform, area, steps.major):
        if text_height / 2.0 <= y <= area.bottom - text_height / 2.0:
            box = QRectF(0.0, y - text_height / 2.0, area.left - 7.0, text_height)
            right = Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter
            painter.drawText(box, right, number(k * steps.major, decimals))
    corner = QRectF(0.0, area.bottom, area.left, height - area.bottom)
    painter.setPen(canvas.color("text"))
    painter.drawText(corner, Qt.AlignmentFlag.AlignCenter, unit)


def draw_ruler_marks(canvas: Canvas, at: ScreenPoint) -> None:
    """Mark on both rulers where the pointer is."""
    area, painter = canvas.area, canvas.painter
    if not area.contains(at):
        return
    painter.setPen(Qt.PenStyle.NoPen)
    painter.setBrush(canvas.color("accent"))
    below, left = area.bottom, area.left
    painter.drawPolygon(
        QPolygonF([QPointF(at.x + dx, below + dy) for dx, dy in ((0, 0), (3.5, 5.5), (-3.5, 5.5))])
    )
    painter.drawPolygon(
        QPolygonF([QPointF(left - dx, at.y + dy) for dx, dy in ((0, 0), (5.5, 3.5), (5.5, -3.5))])
    )
    painter.setBrush(Qt.BrushStyle.NoBrush)


def _verticals(transform: Transform, area: Area, step: float) -> list[tuple[int, float]]:
    low = (area.left - transform.x0) / transform.scale
    high = (area.right - transform.x0) / transform.scale
    # Half a pixel in: lines one pixel wide fall on whole pixels.
    return [
        (k, round(transform.x0 + transform.scale * k * step) + 0.5) for k in ticks(low, high, step)
    ]


def _horizontals(transform: Transform, area: Area, step: float) -> list[tuple[int, float]]:
    low = (transform.y0 - area.bottom) / transform.scale
    high = (transform.y0 - area.top) / transform.scale
    return [
        (k, round(transform.y0 - transform.scale * k * step) + 0.5) for k in ticks(low, high, step)
    ]
