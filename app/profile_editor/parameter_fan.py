"""The picture that explains the method: a leg lit up, an arrow on it, a fan of curves."""

from __future__ import annotations

import numpy as np
from PySide6.QtCore import QPointF, QSize, Qt

from app.hand.canvas import Canvas
from app.profile_editor.cached_layer import CachedLayer
from app.state.view_state import Hover
from sgb_core.arrays import Floats
from sgb_core.curves.parameter_fan import SLID, TOWARDS, parameter_fan
from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import SYMBOLS, ParameterName, Segment

# How flat the circles of P1 and P2 are drawn, which the editor truly sees from the side.
_FLAT = 0.09
_CLEAR = 10.0


def draw_hover(
    canvas: Canvas, profile: Profile, hover: Hover, layer: CachedLayer, size: QSize
) -> None:
    """Draw the range of one parameter, for one segment or for all."""
    segments = [profile.segments[index] for index in hover.segments(len(profile))]
    ranges = parameter_fan(segments, hover.parameter)

    def paint(sheet: Canvas) -> None:
        for segment in segments:
            for which in TOWARDS[hover.parameter]:
                _draw_circle(sheet, segment.points[which], which)
        for segment, quartics in zip(segments, ranges, strict=True):
            _draw_range(sheet, segment, hover.parameter, quartics)

    points = np.array([segment.points for segment in segments])
    layer.draw(canvas, size, (hover, points.tobytes(), ranges.tobytes()), paint)
    for segment in segments:
        if hover.parameter != "omega" and segment.shape.omega == 0.0:
            _tell_idle(canvas, segment, hover.parameter)


def _draw_circle(canvas: Canvas, point: Floats, which: int) -> None:
    """Draw the circle that P1 or P2 runs through, nearly from the side, in that point's colour."""
    x, y = canvas.transform.map(point).tolist()
    middle = canvas.transform.x0
    reach = abs(x - middle)
    name = "circle_p1" if which == 1 else "circle_p2"
    painter = canvas.painter
    painter.setBrush(Qt.BrushStyle.NoBrush)
    if reach > 2.0:
        for pen in (
            canvas.pen(name, 5.0, 40),
            canvas.pen(name, 1.6, 200, Qt.PenStyle.DashLine),
        ):
            painter.setPen(pen)
            painter.drawEllipse(QPointF(middle, y), reach, max(3.0, _FLAT * reach))
    painter.setPen(canvas.pen(name, 2.4, 230))
    painter.drawEllipse(QPointF(x, y), 11.0, 11.0)


def _draw_range(
    canvas: Canvas, segment: Segment, parameter: ParameterName, quartics: Floats
) -> None:
    fine = canvas.pen("quartic", 1.2, 105)
    for quartic in quartics[1:-1]:
        canvas.quartic(quartic, fine)
    for quartic in (quartics[0], quartics[-1]):
        canvas.quartic(quartic, canvas.pen("quartic", 1.5, 190))
    places = canvas.transform.map(segment.points)
    for which in SLID[parameter]:
        near, far = places[which], places[which + 1]
        canvas.line(near, far, canvas.pen("quartic", 5.0, 85))
        # The arrow runs as the parameter grows, over all that the quartic point can reach.
        start, end = canvas.transform.map(quartics[[0, -1], which + 1])
        length = float(np.hypot(*(end - start)))
        if length > 3.0 * _CLEAR:
            # The mark of a control point must not hide the arrow's head.
            end = end + (start - end) * (_CLEAR / length)
        canvas.arrow(start, end, canvas.pen("quartic", 2.2), 9.0)


def _tell_idle(canvas: Canvas, segment: Segment, parameter: ParameterName) -> None:
    """Write beside the leg that the parameter does nothing yet."""
    (which,) = SLID[parameter]
    middle = canvas.transform.map(segment.points[which : which + 2]).mean(axis=0)
    text = f"{SYMBOLS[parameter]} acts when ω > 0"
    canvas.label(middle, text, canvas.color("quartic"), 12.0)
