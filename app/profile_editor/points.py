"""Marks of the profile editor: control points, joints with their class, quartic points."""

from __future__ import annotations

from collections.abc import Collection, Sequence

import numpy as np
from PySide6.QtCore import QLineF, QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QPolygonF

from app.hand.canvas import Canvas
from app.hand.coordinates import ScreenPoint
from app.hand.density import CLEAR, end_presence, leg_lengths, segment_presence
from app.hand.hit_test import (
    Handle,
    PointId,
    Target,
    distinct_points,
    graspable,
    twin_among,
)
from app.hand.readout import class_text
from sgb_core.arrays import Floats
from sgb_core.curves.continuity import JointReport
from sgb_core.curves.profile import Profile

# Joints within so many pixels of the pointer say what they are.
LABELLED = 40.0
_ASTERISK = [(np.cos(a), np.sin(a)) for a in np.radians((90.0, 30.0, -30.0))]


def draw_quartic_points(
    canvas: Canvas, profile: Profile, lit: Collection[int], active: Handle | None
) -> None:
    """Draw Q1, Q2, Q3 as small dots on their legs, plain or not at all in segments not ``lit``."""
    control = canvas.transform.map(profile.control_points)
    places = canvas.transform.map(profile.quartics)
    grasps = graspable(control, places[:, 1:4])
    shown = segment_presence(control, ())
    for index, points in enumerate(places):
        chosen = index in lit
        if not chosen and shown[index] < 0.5:
            continue
        radius, alpha = (3.4, 255) if chosen else (2.0, 130)
        for which in range(3):
            at = QPointF(*points[which + 1].tolist())
            held = active is not None and active.same(Handle(Target.QUARTIC, index, which))
            size = 5.5 if held else radius
            if chosen and not held and np.any(grasps[index, which] != points[which + 1]):
                # The dot itself is under an end: a hollow one shows where it can be grabbed.
                canvas.painter.setPen(canvas.pen("quartic", 1.4))
                canvas.painter.setBrush(canvas.color("canvas"))
                x, y = grasps[index, which].tolist()
                canvas.painter.drawEllipse(QPointF(x, y), 3.0, 3.0)
                canvas.occupy(QRectF(x - 4.0, y - 4.0, 8.0, 8.0))
            canvas.painter.setPen(canvas.pen("canvas", 1.2))
            canvas.painter.setBrush(canvas.color("quartic", 255 if held else alpha))
            canvas.painter.drawEllipse(at, size, size)
    canvas.painter.setBrush(Qt.BrushStyle.NoBrush)


def draw_points(
    canvas: Canvas,
    profile: Profile,
    joints: Sequence[JointReport],
    lit: Collection[int],
    selected_points: Collection[PointId],
    active: Handle | None,
) -> None:
    """Draw control points: P1 '*', P2 'o', ends square, joints diamonds by their class.

    Those of segments that are not ``lit`` are fainter and smaller as they crowd, and then gone.
    """
    places = canvas.transform.map(profile.control_points)
    reports = {report.joint: report for report in joints}
    joined = profile.joined
    inner, outer = segment_presence(places, lit), end_presence(places, lit)
    chosen_points = set(selected_points)
    visible, whole = canvas.area.grown(30.0), canvas.painter.opacity()
    for report in joints:
        if report.measured == "gap":
            before, after = profile.neighbours(report.joint)
            dashes = canvas.pen("warning", 1.2, 255, Qt.PenStyle.DotLine)
            canvas.line(places[before, 3], places[after, 0], dashes)
    for point in distinct_points(profile):
        segment, index = point
        other = twin_among(joined, len(profile), point)
        at = places[segment, index]
        if not visible.contains(_screen(at)):
            continue
        names = {point, other} if other else {point}
        chosen = any(name[0] in lit for name in names)
        shown = max(float((outer if index in (0, 3) else inner)[name[0]]) for name in names)
        broken = index == 3 and other is not None and _is_broken(reports.get(segment))
        if shown == 0.0 and not names & chosen_points and not broken:
            continue
        size = 6.0 if chosen else 2.8 + 1.8 * shown
        canvas.painter.setOpacity(whole * (1.0 if chosen or broken else 0.35 + 0.45 * shown))
        held = active is not None and any(
            active.same(Handle(Target.POINT, *name)) for name in names
        )
        if names & chosen_points:
            _ring(canvas, at, "selection", 10.5, 110 if held else 62)
        elif held:
            _ring(canvas, at, "accent", 10.5, 45)
        if index in (1, 2) or other is None:
            draw_mark(canvas, at, index, size)
        else:
            joint = segment if index == 3 else other[0]
            _diamond(canvas, at, size + 0.5, reports.get(joint))
        canvas.painter.setOpacity(whole)
        canvas.occupy(QRectF(at[0] - 8.0, at[1] - 8.0, 16.0, 16.0))
    canvas.painter.setBrush(Qt.BrushStyle.NoBrush)


def draw_labels(
    canvas: Canvas,
    profile: Profile,
    joints: Sequence[JointReport],
    selected: int,
    pointer: ScreenPoint | None,
) -> None:
    """Name the selected segment's points; joints say what they are near the pointer, or broken."""
    places = canvas.transform.map(profile.control_points)
    for report in sorted(joints, key=lambda r: r.holds):
        at = places[profile.neighbours(report.joint)[0], 3]
        near = pointer is not None and pointer.distance(_screen(at)) <= LABELLED
        if near or not report.holds:
            canvas.label(at, class_text(report), _class_color(canvas, report), 10.0)
    if selected < len(places) and leg_lengths(places)[selected] >= 2.0 * CLEAR:
        for index, name in ((1, "circle_p1"), (2, "circle_p2"), (0, "polygon"), (3, "polygon")):
            canvas.label(places[selected, index], f"P{index}", canvas.color(name), 9.0)


def _is_broken(report: JointReport | None) -> bool:
    return report is not None and not report.holds


def _class_color(canvas: Canvas, report: JointReport) -> QColor:
    if report.measured == "gap" and report.rule != "free":
        return canvas.color("error")
    if not report.holds:
        return canvas.color("warning")
    return canvas.color("text_muted")


def _screen(at: Floats) -> ScreenPoint:
    return ScreenPoint(float(at[0]), float(at[1]))


def _ring(canvas: Canvas, at: Floats, name: str, radius: float, alpha: int) -> None:
    canvas.painter.setPen(canvas.pen(name, 1.6))
    canvas.painter.setBrush(canvas.color(name, alpha))
    canvas.painter.drawEllipse(QPointF(*at.tolist()), radius, radius)
    canvas.painter.setBrush(Qt.BrushStyle.NoBrush)


def draw_mark(canvas: Canvas, at: Floats, index: int, size: float) -> None:
    """Draw the mark of a control point: of P1 '*', of P2 'o', of an end a square."""
    if index == 1:
        _asterisk(canvas, at, size)
    elif index == 2:
        _circle(canvas, at, size - 0.7)
    else:
        _square(canvas, at, max(size - 1.0, 2.6))


def _asterisk(canvas: Canvas, at: Floats, size: float) -> None:
    lines = [
        QLineF(at[0] - size * x, at[1] - size * y, at[0] + size * x, at[1] + size * y)
        for x, y in _ASTERISK
    ]
    # A rim in the ground's colour keeps the arms apart from lines below them.
    for pen in (canvas.pen("canvas", 4.6), canvas.pen("circle_p1", 2.0)):
        canvas.painter.setPen(pen)
        canvas.painter.drawLines(lines)


def _circle(canvas: Canvas, at: Floats, size: float) -> None:
    canvas.painter.setBrush(canvas.color("canvas"))
    for pen in (canvas.pen("canvas", 4.6), canvas.pen("circle_p2", 2.0)):
        canvas.painter.setPen(pen)
        canvas.painter.drawEllipse(QPointF(*at.tolist()), size, size)


def _square(canvas: Canvas, at: Floats, size: float) -> None:
    canvas.painter.setBrush(canvas.color("polygon"))
    canvas.painter.setPen(canvas.pen("canvas", 1.4))
    canvas.painter.drawRect(QRectF(at[0] - size, at[1] - size, 2.0 * size, 2.0 * size))


def _diamond(canvas: Canvas, at: Floats, size: float, report: JointReport | None) -> None:
    """Draw a joint: hollow for G0, half full for G1, full for C1 and G2; red rim where broken."""
    corners = [(0.0, -size), (size, 0.0), (0.0, size), (-size, 0.0)]
    outline = QPolygonF([QPointF(at[0] + x, at[1] + y) for x, y in corners])
    half = QPolygonF([QPointF(at[0] + x, at[1] + y) for x, y in corners[1:]])
    measured = "G0" if report is None else str(report.measured)
    name = "warning" if _is_broken(report) else "polygon"
    painter = canvas.painter
    painter.setPen(canvas.pen("canvas", 4.2))
    painter.setBrush(canvas.color("canvas"))
    painter.drawPolygon(outline)
    painter.setPen(canvas.pen(name, 1.8))
    full = measured in ("C1", "G2")
    painter.setBrush(canvas.color(name) if full else Qt.BrushStyle.NoBrush)
    painter.drawPolygon(outline)
    if measured == "G1":
        painter.setBrush(canvas.color(name))
        painter.drawPolygon(half)
    painter.setBrush(Qt.BrushStyle.NoBrush)
