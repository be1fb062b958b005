"""One picture of the profile editor, painted from a frame and what the hand is doing."""

from __future__ import annotations

import numpy as np
from PySide6.QtCore import QPoint, QRect, QRectF, QSize, Qt
from PySide6.QtGui import QFont, QPainter

from app.hand.canvas import Canvas
from app.hand.coordinates import Area, ScreenPoint, Transform
from app.hand.dimension_picture import draw_dimensions
from app.hand.drag import Gesture, State
from app.hand.hit_test import Handle, Target
from app.hand.readout import draw_hud, told_lines
from app.hand.reference import draw_reference
from app.hand.scale_frame import PointFrame, draw_frame
from app.hand.snapping import Landing
from app.profile_editor.body import (
    draw_bands,
    draw_body,
    draw_findings,
    draw_grabbed,
    draw_level,
    draw_textures,
)
from app.profile_editor.cached_layer import CachedLayers
from app.profile_editor.comb import draw_comb
from app.profile_editor.curve import (
    draw_faults,
    draw_generatrix,
    draw_polygon,
    draw_silhouette,
)
from app.profile_editor.grid import draw_axis, draw_grid, draw_ruler_marks, draw_rulers, name_axis
from app.profile_editor.guides import draw_guides
from app.profile_editor.inset import draw_inset
from app.profile_editor.overlays import (
    draw_compared,
    draw_mark,
    draw_preview,
    draw_section,
)
from app.profile_editor.parameter_fan import draw_hover
from app.profile_editor.points import draw_labels, draw_points, draw_quartic_points
from app.profile_editor.tools.tool import Tool
from app.state.overlays import Overlay
from app.state.presenter import Frame
from app.state.view_state import Hover
from app.theme import theme
from sgb_core.curves.segment import LAMBDAS
from sgb_core.values import dataclass

# How much is left of a profile that a tool is about to replace.
FADED = 0.25


@dataclass(frozen=True, slots=True)
class Picture:
    """Everything that one picture shows.

    ``active`` is the handle under the pointer or in the hand; ``pointer`` is None while the
    pointer is elsewhere; ``told`` is where the heads-up label stands, None for none.
    """

    frame: Frame
    transform: Transform
    area: Area
    size: QSize
    font: QFont
    active: Handle | None
    gesture: Gesture
    landing: Landing | None
    pointer: ScreenPoint | None
    told: ScreenPoint | None
    focused: bool
    layers: CachedLayers
    tool: Tool | None = None
    # What lies over the picture: labels keep clear of it.
    over: tuple[QRectF, ...] = ()

    @property
    def selected_segments(self) -> range:
        """The segments that the panel's sliders act on."""
        view, count = self.frame.view, len(self.frame.document.profile)
        if view.all_segments:
            return range(count)
        return range(view.segment, min(view.segment + 1, count))

    @property
    def lit(self) -> frozenset[int]:
        """The segments whose marks are shown in full, however crowded: selected, pointed at."""
        view, active = self.frame.view, self.active
        pointed = () if active is None or not active.on_profile else (active.segment,)
        return frozenset((view.segment, *pointed, *(segment for segment, _ in view.points)))

    @property
    def hover(self) -> Hover | None:
        """The parameter whose range is shown: a slider's, or that of a quartic point."""
        if self.frame.view.hover is not None:
            return self.frame.view.hover
        if self.active is not None and self.active.target is Target.QUARTIC:
            return Hover(LAMBDAS[self.active.index], self.active.segment)
        return None


def paint(painter: QPainter, picture: Picture) -> None:
    """Paint the picture over its background, back to front."""
    canvas = Canvas(painter, picture.transform, theme.current(), picture.area, picture.font)
    area = picture.area
    painter.setClipRect(QRectF(area.left, area.top, area.width, area.height))
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    for box in picture.over:
        canvas.hide_under(box)
    tool = picture.tool
    if tool is not None and tool.fades:
        painter.setOpacity(FADED)
    _paint_profile(canvas, picture)
    painter.setOpacity(1.0)
    if tool is not None:
        tool.draw(canvas)
    elif picture.frame.view.hover is not None and picture.pointer is None:
        # Pointed at from a slider; over the editor itself it would cover what is in the hand.
        profile, hover = picture.frame.document.profile, picture.frame.view.hover
        draw_inset(canvas, profile, hover, picture.layers.inset, picture.size)
    painter.setClipping(False)
    if picture.pointer is not None:
        draw_ruler_marks(canvas, picture.pointer)
    if picture.told is not None and picture.active is not None:
        lines = told_lines(
            picture.frame, picture.gesture, picture.landing, picture.active, picture.transform.scale
        )
        if lines:
            draw_hud(canvas, picture.told, lines)
    said = None if tool is None else tool.told()
    if said is not None:
        draw_hud(canvas, *said)
    if picture.focused:
        painter.setRenderHint(QPainter.RenderHint.Antialiasing, False)
        painter.setPen(canvas.pen("accent", 1.0))
        painter.drawRect(QRectF(0, 0, picture.size.width() - 1, picture.size.height() - 1))


def paint_background(painter: QPainter, picture: Picture) -> None:
    """Paint what changes with the zoom only: the paper, its grid and its rulers."""
    canvas = Canvas(painter, picture.transform, theme.current(), picture.area, picture.font)
    area = picture.area
    painter.fillRect(QRect(QPoint(0, 0), picture.size), canvas.color("canvas"))
    painter.setClipRect(QRectF(area.left, area.top, area.width, area.height))
    draw_grid(canvas)
    draw_reference(canvas, picture.frame.document.reference)
    painter.setClipping(False)
    draw_rulers(canvas, picture.size.toTuple(), str(picture.frame.document.unit))


def _paint_profile(canvas: Canvas, picture: Picture) -> None:
    frame, active = picture.frame, picture.active
    view, evaluation = frame.view, frame.evaluation
    profile = frame.document.profile
    selected, lit = picture.selected_segments, picture.lit
    canvas.keep_labels_off(profile.sample(49).reshape(-1, 2))
    if view.shows(Overlay.GHOST):
        draw_silhouette(canvas, profile)
    draw_body(canvas, frame)
    axis = f"{frame.document.revolution.axis} axis"
    draw_axis(canvas, axis)
    draw_guides(canvas, frame.document.guides)
    if picture.landing is not None and picture.gesture.profile is not None:
        _draw_guide(canvas, picture)
    if view.shows(Overlay.POLYGON):
        draw_polygon(canvas, profile, lit)
    if picture.hover is not None:
        draw_hover(canvas, profile, picture.hover, picture.layers.range, picture.size)
    if view.shows(Overlay.COMB) or view.before is not None:
        before = None if view.before is None else view.before.profile
        draw_comb(canvas, profile, evaluation.joints, view.comb_length, before)
    if frame.compared is not None:
        draw_compared(canvas, frame.compared.document, picture.layers.compared, picture.size)
    if view.shows(Overlay.SLUMP):
        picture.layers.slump.draw(canvas, frame.document)
    if view.shows(Overlay.GENERATRIX):
        pointed = None
        if active is not None and active.target is Target.CURVE:
            pointed = active.segment
        draw_generatrix(canvas, profile, selected, pointed)
    draw_section(canvas, frame)
    if view.preview is not None:
        draw_preview(canvas, view.preview, profile)
    if view.shows(Overlay.QUARTIC):
        draw_quartic_points(canvas, profile, lit, active)
    draw_points(canvas, profile, evaluation.joints, lit, view.points, active)
    box = PointFrame.of(profile, view.points)
    if box is not None and picture.gesture.state is not State.BOXING:
        draw_frame(canvas, box, active)
    draw_textures(canvas, frame, active)
    draw_bands(canvas, frame, active)
    draw_level(canvas, frame, active)
    draw_findings(canvas, frame)
    draw_dimensions(canvas, frame, active, canvas.transform)
    name_axis(canvas, axis)
    draw_faults(canvas, profile, evaluation.axis_crossings, evaluation.self_intersections)
    if picture.tool is None:
        draw_labels(canvas, profile, evaluation.joints, view.segment, picture.pointer)
    if picture.gesture.state is State.IDLE:
        draw_grabbed(canvas, active)
    if view.mark is not None:
        draw_mark(canvas, profile, view.mark)
    if picture.gesture.state is State.BOXING and picture.pointer is not None:
        _draw_box(canvas, picture.gesture.press, picture.pointer)


def _draw_guide(canvas: Canvas, picture: Picture) -> None:
    """Draw the line on which a point moves, those on which it lines up, or the axis."""
    landing, start = picture.landing, picture.gesture.start
    if landing is None:
        return
    pen = canvas.pen("accent", 1.0, 200, Qt.PenStyle.DashLine)
    area = canvas.area
    if landing.on_axis:
        x = canvas.transform.x0
        canvas.line(np.array((x, area.top)), np.array((x, area.bottom)), canvas.pen("accent", 2.0))
    beside, level = landing.aligned
    if beside is not None:
        x = float(canvas.transform.map((beside, 0.0))[0])
        canvas.line(np.array((x, area.top)), np.array((x, area.bottom)), pen)
    if level is not None:
        y = float(canvas.transform.map((0.0, level))[1])
        canvas.line(np.array((area.left, y)), np.array((area.right, y)), pen)
    if landing.guide is not None and start is not None:
        at = canvas.transform.to_screen(start)
        far = area.width + area.height + abs(at.x) + abs(at.y)
        step = np.array((landing.guide[0], -landing.guide[1])) * far
        centre = np.array((at.x, at.y))
        canvas.line(centre - step, centre + step, pen)


def _draw_box(canvas: Canvas, a: ScreenPoint, b: ScreenPoint) -> None:
    canvas.painter.setPen(canvas.pen("accent", 1.0, 255, Qt.PenStyle.DashLine))
    canvas.painter.setBrush(canvas.color("accent", 28))
    canvas.painter.drawRect(QRectF(min(a.x, b.x), min(a.y, b.y), abs(a.x - b.x), abs(a.y - b.y)))
    canvas.painter.setBrush(Qt.BrushStyle.NoBrush)
