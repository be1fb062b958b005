"""The heads-up label beside the pointer: coordinates, length and angle of the leg."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence

import numpy as np
from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QFont, QFontMetricsF

from app.hand.canvas import Canvas
from app.hand.coordinates import Area, DesignPoint, ScreenPoint, decimals_for, number
from app.hand.drag import Gesture, State
from app.hand.hit_test import Handle, PointId, Target, twin
from app.hand.scale_frame import PointFrame
from app.hand.snapping import Landing
from app.state.presenter import Frame
from app.state.window_reader import WINDOW
from sgb_core.curves.continuity import JointReport
from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import LAMBDAS, SYMBOLS
from sgb_core.values import dataclass

_PAD = 7.0
_AWAY = 18.0


def point_name(profile: Profile, point: PointId) -> str:
    """Return what a person calls a control point: "P1 of segment 2", "the joint 1–2"."""
    segment, index = point
    other = twin(profile, point)
    if other is not None and index in (0, 3):
        before, after = (segment, other[0]) if index == 3 else (other[0], segment)
        return WINDOW.joint(before, after)
    return f"P{index} of {WINDOW.segment(segment)}"


def lines_for(
    profile: Profile,
    joints: Sequence[JointReport],
    handle: Handle,
    scale: float,
    unit: str,
) -> list[str]:
    """Return a title and what there is to know about a handle.

    Numbers have as many decimals as a pixel resolves at ``scale`` pixels per unit.
    """
    decimals = decimals_for(1.0 / scale)
    segment = profile.segments[handle.segment]
    if handle.target is Target.QUARTIC:
        name = LAMBDAS[handle.index]
        value = getattr(segment.shape, name)
        fraction = segment.shape.leg_fractions[handle.index]
        return [
            f"Q{handle.index + 1} of {WINDOW.segment(handle.segment)}",
            f"{SYMBOLS[name]} = {value:.3f}   ω = {segment.shape.omega:.3f}",
            f"{100.0 * fraction:.1f} % of the leg",
        ]
    if handle.target is Target.CURVE:
        r, h = segment.point(handle.s).tolist()
        return [
            f"{WINDOW.segment(handle.segment)}   s = {handle.s:.3f}",
            f"r {number(r, decimals)}   h {number(h, decimals)} {unit}",
        ]
    r, h = segment.points[handle.index].tolist()
    lines = [
        point_name(profile, (handle.segment, handle.index)),
        f"r {number(r, decimals)}   h {number(h, decimals)} {unit}",
    ]
    for near, far, mark in _legs(profile, (handle.segment, handle.index)):
        dr, dh = (far - near).tolist()
        length = number(math.hypot(dr, dh), decimals)
        lines.append(f"{mark} {length} {unit}   ∠ {number(math.degrees(math.atan2(dh, dr)), 1)}°")
    lines += [
        f"measured {class_text(report)}, rule {report.rule}"
        for report in joints
        if (handle.segment, handle.index) in joint_ends(profile, report.joint)
    ]
    return lines


def lines_for_step(
    count: int, start: DesignPoint, end: DesignPoint, scale: float, unit: str
) -> list[str]:
    """Return what there is to know about several points that are moved together."""
    decimals = decimals_for(1.0 / scale)
    dr, dh = end.r - start.r, end.h - start.h
    return [
        f"{count} points",
        f"Δr {number(dr, decimals)}   Δh {number(dh, decimals)} {unit}",
        f"{number(math.hypot(dr, dh), decimals)} {unit}   "
        f"∠ {number(math.degrees(math.atan2(dh, dr)), 1)}°",
    ]


def joint_ends(profile: Profile, joint: int) -> tuple[PointId, PointId]:
    """Return the two ends that meet, or should meet, at a joint."""
    before, after = profile.neighbours(joint)
    return (before, 3), (after, 0)


def class_text(report: JointReport) -> str:
    """Return what a joint truly is, in a few signs: "G1", "G0 ∠12°", "gap"."""
    if report.measured == "G0" and report.kink_deg is not None:
        decimals = 0 if report.kink_deg >= 9.5 else 1
        shown = f"{report.kink_deg:.{decimals}f}"
        return f"G0 ∠{shown}°" if float(shown) else "G0 ∠<0.1°"
    return str(report.measured)


def _legs(profile: Profile, point: PointId) -> list[tuple[np.ndarray, np.ndarray, str]]:
    """Return the legs from the curve's end to the handle that belongs to it."""
    names = [point, twin(profile, point)]
    legs = []
    for name in names:
        if name is None:
            continue
        points = profile.segments[name[0]].points
        near, far = {0: (0, 1), 1: (0, 1), 2: (3, 2), 3: (3, 2)}[name[1]]
        mark = "leg" if names[1] is None else f"leg {name[0] + 1}"
        legs.append((points[near], points[far], mark))
    return legs


def told_lines(
    frame: Frame, gesture: Gesture, landing: Landing | None, handle: Handle, scale: float
) -> list[str]:
    """Return what the heads-up label says about a handle, under the pointer or in the hand.

    While a number is typed that is what it says.
    """
    lines = _lines_of(frame, gesture, landing, handle, scale)
    lines[:1] = [f"{line[:1].upper()}{line[1:]}" for line in lines[:1]]
    return lines if gesture.typed is None else [*lines[:1], *gesture.typed.lines()]


def _lines_of(
    frame: Frame, gesture: Gesture, landing: Landing | None, handle: Handle, scale: float
) -> list[str]:
    profile, unit = frame.document.profile, str(frame.document.unit)
    if handle.target is Target.DIMENSION:
        return [dimension.label for dimension in frame.document.dimensions[handle.index :][:1]]
    if handle.feature is not None:
        gone = handle.feature.is_gone(frame.document)
        return [] if gone else handle.feature.lines(frame.document, scale)
    if handle.target is Target.LEVEL:
        document, decimals = frame.document, decimals_for(1.0 / scale)
        height = document.fill_height or 0.0
        below = number(document.rim_height - height, decimals)
        return [
            "fill line",
            f"h {number(height, decimals)} {unit}",
            f"{below} {unit} below the rim",
        ]
    if len(gesture.points) > 1 and gesture.start is not None and gesture.handle is not None:
        held = gesture.handle
        now = DesignPoint.of(profile.segments[held.segment].points[held.index])
        lines = lines_for_step(len(gesture.points), gesture.start, now, scale, unit)
    elif handle.target in (Target.GRIP, Target.BODY):
        box = PointFrame.of(profile, frame.view.points)
        lines = box.lines(landing.factors if landing else None, scale, unit) if box else []
    else:
        lines = lines_for(profile, frame.evaluation.joints, handle, scale, unit)
    if gesture.state is State.MOVING and len(gesture.points) == 1 and handle.index in (0, 3):
        lines.append("Handles in proportion (H)" if gesture.scales else "Handles carried (H)")
    if landing is not None and landing.on_axis:
        lines.append("On the axis")
    return lines


@dataclass(frozen=True, slots=True)
class Label:
    """The lines of a heads-up label, the first one bold, and the room that they take."""

    lines: list[str]
    fonts: list[QFont]
    width: float
    height: float

    @classmethod
    def of(cls, lines: list[str], font: QFont) -> Label:
        """Measure a label."""
        bold = QFont(font)
        bold.setBold(True)
        fonts = [bold] + [font] * (len(lines) - 1)
        widths = [
            QFontMetricsF(f).horizontalAdvance(line) for f, line in zip(fonts, lines, strict=True)
        ]
        height = 2.0 * _PAD - 4.0 + _row(bold) * len(lines)
        return cls(lines, fonts, 2.0 * _PAD + max(widths), height)

    def beside(
        self, at: ScreenPoint, area: Area, covered: Callable[[QRectF], int] | None = None
    ) -> QRectF:
        """Return where the label stands near a place: where there is room and it covers least."""
        lefts = (at.x + _AWAY, at.x - _AWAY - self.width, at.x - 0.5 * self.width)
        tops = (at.y + _AWAY, at.y - _AWAY - self.height)
        boxes = [self._within(left, top, area) for top in tops for left in lefts]
        # One that had to be moved into the area may lie on the place itself.
        here = QRectF(at.x - 4.0, at.y - 4.0, 8.0, 8.0)
        return min(
            boxes,
            key=lambda box: (box.intersects(here), 0 if covered is None else covered(box)),
        )

    def _within(self, left: float, top: float, area: Area) -> QRectF:
        left = min(max(left, area.left + 2.0), area.right - self.width - 2.0)
        # The hand of a drag may have left the area altogether.
        top = min(max(top, area.top + 2.0), area.bottom - self.height - 2.0)
        return QRectF(left, top, self.width, self.height)

    def paint(self, canvas: Canvas, box: QRectF) -> None:
        """Paint the label in its box."""
        painter = canvas.painter
        painter.setPen(canvas.pen("border"))
        painter.setBrush(canvas.color("panel", 240))
        painter.drawRoundedRect(box, 5.0, 5.0)
        painter.setBrush(Qt.BrushStyle.NoBrush)
        painter.setPen(canvas.color("text"))
        row = _row(self.fonts[0])
        for k, (font, line) in enumerate(zip(self.fonts, self.lines, strict=True)):
            painter.setFont(font)
            baseline = box.top() + _PAD - 2.0 + row * k + QFontMetricsF(font).ascent()
            painter.drawText(QPointF(box.left() + _PAD, baseline), line)


def _row(font: QFont) -> float:
    return QFontMetricsF(font).height() + 1.0


def draw_hud(canvas: Canvas, at: ScreenPoint, lines: list[str]) -> None:
    """Draw the label near ``at``, on the side where there is room."""
    label = Label.of(lines, canvas.font)
    label.paint(canvas, label.beside(at, canvas.area, canvas.covered))
