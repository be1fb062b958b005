"""The body in the profile editor: its wall hatched, its liquid, the fill line, doubtful places."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QBrush, QColor, QPainterPath, QPen

from app.hand.canvas import Canvas, polygon
from app.hand.coordinates import Paper, ScreenPoint
from app.hand.features import (
    Feature,
    Kind,
    bands,
    edge_places,
    fill_height,
    pick_band,
    pick_body,
    pick_texture,
    textures,
)
from app.hand.hit_test import Handle, Target
from app.state.overlays import Overlay
from app.state.presenter import Frame
from sgb_core.arrays import Floats
from sgb_core.curves.segment import Segment
from sgb_core.findings.bodies import TightCurve

if TYPE_CHECKING:
    from sgb_core.document.body_state import BodyState

LEVEL_REACH = 5.0
_HANDLE = 7.0
_SPOT = 8.0
_CHEQUER = 4.5


def pick_level(frame: Frame, paper: Paper, at: ScreenPoint) -> Handle | None:
    """Return the fill line's handle where a press at ``at`` would grab it."""
    height = fill_height(frame)
    if height is None:
        return None
    y = float(paper.map(np.array((0.0, height)))[1])
    return Handle(Target.LEVEL, 0) if abs(at.y - y) <= LEVEL_REACH else None


def pick_feature(frame: Frame, paper: Paper, at: ScreenPoint) -> Handle | None:
    """Return what a press would grab of the body or its look: texture, band, wall or floor."""
    document = frame.document
    look = pick_texture(document, paper, at) or pick_band(document, paper, at)
    feature = look or pick_body(frame, paper, at)
    return None if feature is None else Handle(Target.FEATURE, 0, feature=feature)


def draw_bands(canvas: Canvas, frame: Frame, active: Handle | None) -> None:
    """Draw the edges of painted layers as ticks across the curve, in their paint."""
    profile = frame.document.profile
    for number, layer in bands(frame.document):
        for upper in (False, True):
            feature = Feature(Kind.BAND, (0.0, 0.0), layer=number, upper=upper)
            lit = active is not None and feature.same(active.feature)
            for x, y in canvas.transform.map(edge_places(profile, layer, upper=upper)).tolist():
                half = np.array((12.0 if lit else 8.0, 0.0))
                centre = np.array((x, y))
                canvas.line(centre - half, centre + half, canvas.pen("canvas", 6.0))
                canvas.line(centre - half, centre + half, canvas.pen("text", 4.0))
                canvas.painter.setPen(QPen(QColor(layer.color), 2.4))
                canvas.painter.drawLine(QPointF(*(centre - half)), QPointF(*(centre + half)))


def draw_textures(canvas: Canvas, frame: Frame, active: Handle | None) -> None:
    """Mark where each texture is grabbed by a small piece of a chequer on the curve."""
    for feature in textures(frame.document):
        lit = active is not None and feature.same(active.feature)
        x, y = canvas.transform.map(feature.at).tolist()
        half = _CHEQUER + (1.0 if lit else 0.0)
        canvas.painter.setPen(canvas.pen("accent" if lit else "text", 1.4))
        canvas.painter.setBrush(canvas.color("canvas"))
        canvas.painter.drawRect(QRectF(x - half, y - half, 2.0 * half, 2.0 * half))
        for left, top in ((x - half, y - half), (x, y)):
            canvas.painter.fillRect(
                QRectF(left, top, half, half), canvas.color("accent" if lit else "text")
            )
        canvas.painter.setBrush(Qt.BrushStyle.NoBrush)
        canvas.occupy(QRectF(x - half, y - half, 2.0 * half, 2.0 * half))


def draw_grabbed(canvas: Canvas, active: Handle | None) -> None:
    """Light up the place at which the wall or the floor would be grabbed."""
    if active is None or active.feature is None or active.feature.kind in (Kind.BAND, Kind.TEXTURE):
        return
    x, y = canvas.transform.map(active.feature.at).tolist()
    way = np.radians(active.feature.angle)
    arm = 11.0 * np.array((np.cos(way), -np.sin(way)))
    centre = np.array((x, y))
    for tip in (centre + arm, centre - arm):
        canvas.arrow(centre, tip, canvas.pen("accent", 2.0), 7.0)


def draw_body(canvas: Canvas, frame: Frame) -> None:
    """Draw the newest body's section: hatched material, and liquid up to the fill line."""
    state = frame.body
    if state is None or state.mesh is None:
        return
    painter = canvas.painter
    if frame.view.shows(Overlay.LIQUID):
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(canvas.color("liquid", 80))
        for loop in state.liquid_section:
            painter.drawPolygon(polygon(canvas.transform.map(loop)))
    path = _section_path(canvas, state)
    painter.setPen(canvas.pen("cut", 1.0, 170))
    painter.setBrush(canvas.color("cut", 60))
    painter.drawPath(path)
    painter.setPen(Qt.PenStyle.NoPen)
    painter.setBrush(QBrush(canvas.color("cut", 120), Qt.BrushStyle.BDiagPattern))
    painter.drawPath(path)
    painter.setBrush(Qt.BrushStyle.NoBrush)


def _section_path(canvas: Canvas, state: BodyState) -> QPainterPath:
    path = QPainterPath()
    path.setFillRule(Qt.FillRule.OddEvenFill)
    for part in state.section(state.surface.start):
        for loop in (part.exterior, *part.holes):
            path.addPolygon(polygon(canvas.transform.map(loop)))
            path.closeSubpath()
    return path


def draw_level(canvas: Canvas, frame: Frame, active: Handle | None) -> None:
    """Draw the fill line with a handle at the picture's edge."""
    height = fill_height(frame)
    if height is None:
        return
    y = float(canvas.transform.map(np.array((0.0, height)))[1])
    area = canvas.area
    lit = active is not None and active.target is Target.LEVEL
    pen = canvas.pen("liquid", 2.4 if lit else 1.4, 255, Qt.PenStyle.DashLine)
    canvas.line(np.array((area.left, y)), np.array((area.right, y)), pen)
    tip = area.right - 3.0
    corners = np.array([(tip - 1.6 * _HANDLE, y), (tip, y - _HANDLE), (tip, y + _HANDLE)])
    canvas.shape(corners, canvas.pen("liquid"), canvas.color("liquid"))


def draw_findings(canvas: Canvas, frame: Frame) -> None:
    """Mark where the newest body is doubtful: a stretch of the curve, or a place."""
    state = frame.body
    if state is None:
        return
    profile = frame.document.profile
    for doubt in state.doubts:
        if not isinstance(doubt, TightCurve):
            _draw_spot(canvas, canvas.transform.map(np.array(doubt.where)))
        elif doubt.segment < len(profile):
            _draw_stretch(canvas, profile.segments[doubt.segment], doubt.span)


def _draw_stretch(canvas: Canvas, segment: Segment, span: tuple[float, float]) -> None:
    places = canvas.transform.map(segment.point(np.linspace(*span, 33)))
    canvas.polyline(places, canvas.pen("error", 6.0, 90))
    _draw_spot(canvas, places[len(places) // 2])


def _draw_spot(canvas: Canvas, at: Floats) -> None:
    painter = canvas.painter
    painter.setPen(canvas.pen("error", 1.6))
    painter.setBrush(canvas.color("canvas", 210))
    painter.drawEllipse(QPointF(*at), _SPOT, _SPOT)
    painter.setBrush(Qt.BrushStyle.NoBrush)
    pen = canvas.pen("error", 2.2)
    for low, high in ((-4.0, 1.0), (4.0, 4.2)):
        canvas.line(np.add(at, (0.0, low)), np.add(at, (0.0, high)), pen)
