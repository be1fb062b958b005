"""What is laid over the profile on demand: another state, a section, a preview."""

from __future__ import annotations

import numpy as np
from PySide6.QtCore import QPointF, QSize, Qt

from app.hand.canvas import Canvas
from app.profile_editor.cached_layer import CachedLayer
from app.state.presenter import Frame
from sgb_core.curves.profile import Profile
from sgb_core.document.model import Document


def draw_compared(canvas: Canvas, other: Document, layer: CachedLayer, size: QSize) -> None:
    """Draw the state that the document is compared with, dashed."""
    quartics = other.profile.quartics

    def paint(sheet: Canvas) -> None:
        for quartic in quartics:
            sheet.quartic(quartic, sheet.pen("compare", 1.6, 235, Qt.PenStyle.DashLine))

    layer.draw(canvas, size, quartics.tobytes(), paint)


def draw_preview(canvas: Canvas, profile: Profile, present: Profile) -> None:
    """Draw what a profile that is offered would change in the present one."""
    for segment in set(profile.segments) - set(present.segments):
        canvas.quartic(segment.quartic, canvas.pen("accent", 2.0, 255, Qt.PenStyle.DashLine))


def draw_section(canvas: Canvas, frame: Frame) -> None:
    """Draw the section at the angle that is pointed at, where laws make it another one."""
    surface, degrees = frame.evaluation.surface, frame.view.angle
    if degrees is None or not surface.laws:
        return
    section = surface.profile_at(surface.start + float(np.deg2rad(degrees)))
    for segment in section.segments:
        canvas.quartic(segment.quartic, canvas.pen("accent", 1.8, 220))


def draw_mark(canvas: Canvas, profile: Profile, mark: tuple[int, float]) -> None:
    """Draw the place that is pointed at elsewhere."""
    segment, s = mark
    if segment < len(profile):
        x, y = canvas.transform.map(profile.point(segment, s)).tolist()
        canvas.painter.setPen(canvas.pen("canvas", 2.0))
        canvas.painter.setBrush(canvas.color("accent"))
        canvas.painter.drawEllipse(QPointF(x, y), 5.0, 5.0)
        canvas.painter.setBrush(Qt.BrushStyle.NoBrush)
