"""The segment of a slider shown large: its polygon, the fan of all its curves, and where Q slides.

Drawn over the editor while a slider is pointed at from elsewhere, for a fan of a few pixels
explains nothing. Where the segment is large in the picture already, Q gets its name there.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from itertools import pairwise
from types import MappingProxyType

import numpy as np
from PySide6.QtCore import QPointF, QRectF, QSize, Qt
from PySide6.QtGui import QPainterPath

from app.hand.canvas import Canvas
from app.hand.coordinates import Area, Transform
from app.profile_editor.cached_layer import CachedLayer
from app.profile_editor.points import draw_mark
from app.state.view_state import Hover
from app.state.window_reader import segment_title
from app.theme.fonts import small_font
from app.widgets.quantity import format_number
from sgb_core.arrays import Floats
from sgb_core.curves.parameter_fan import SLID, parameter_fan
from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import PARAMETER_RANGES, SYMBOLS, ParameterName, Segment
from sgb_core.curves.segment_names import segment_names

# The inset is these parts of the picture's width and height, no larger nor smaller in pixels.
SHARE, LEAST, MOST = (0.84, 0.86), 150.0, 440.0
# A segment that fills as much of the picture by itself needs no inset.
LARGE = 0.55
_EDGE, _PAD, _HEAD = 8.0, 30.0, 34.0
# An inset that shows it less than so many times as large is none.
_WORTH = 1.25
# What each parameter does as it grows.
_WAYS: Mapping[ParameterName, str] = MappingProxyType(
    {
        "lambda1": "More: Q1 slides from P1 to P0",
        "lambda2": "More: Q2 slides from P2 to P1",
        "lambda3": "More: Q3 slides from P2 to P3",
        "omega": "More: the λ show; 0 is the plain cubic",
    }
)
# What the editor's tools take of the left edge.
_TOOLS = 44.0


def inset_area(area: Area, places: Floats) -> Area | None:
    """Return where the inset lies: in the corner farthest from the segment; None for none.

    ``places`` are the segment's points on the screen, shape (m, 2).
    """
    extent = np.ptp(places, axis=0)
    room = min(area.width, area.height)
    if (
        room < LEAST + _TOOLS + _EDGE
        or (extent >= LARGE * np.array((area.width, area.height))).any()
    ):
        return None
    width = min(max(SHARE[0] * area.width, LEAST), MOST, area.width - _TOOLS - _EDGE)
    height = min(max(SHARE[1] * area.height, LEAST), MOST, area.height - 2.0 * _EDGE)
    middle = places.mean(axis=0)
    left = middle[0] > (area.left + area.right) / 2.0
    above = middle[1] > (area.top + area.bottom) / 2.0
    x = area.left + _TOOLS if left else area.right - _EDGE - width
    y = area.top + _EDGE if above else area.bottom - _EDGE - height
    return Area(x, y, x + width, y + height)


def draw_inset(
    canvas: Canvas, profile: Profile, hover: Hover, layer: CachedLayer, size: QSize
) -> None:
    """Draw the segment of a slider large where it is small in the picture, and name what slides.

    A slider of all segments together has neither. What stays as it is while the slider moves,
    polygon and fan, is kept in ``layer``; ``size`` is the widget's.
    """
    if hover.segment is None:
        return
    segment = profile.segments[hover.segment]
    (fan,) = parameter_fan([segment], hover.parameter)
    places = canvas.transform.map(segment.points)
    area = inset_area(canvas.area, places)
    transform = None if area is None else _transform(area, segment, fan)
    if area is None or transform is None or transform.scale <= _WORTH * canvas.transform.scale:
        _draw_slides(canvas, segment, hover.parameter, fan)
        return
    large = Canvas(canvas.painter, transform, canvas.palette, area, small_font(canvas.font, 1.12))

    def paint(sheet: Canvas) -> None:
        _draw_card(sheet, area, places)
        sheet.painter.setClipRect(_box(area))
        _draw_range(replace(large, painter=sheet.painter), segment, fan)

    layer.draw(canvas, size, (hover, segment.points.tobytes(), fan.tobytes()), paint)
    canvas.painter.save()
    canvas.painter.setClipRect(_box(area))
    _draw_segment(large, segment, hover.parameter, fan)
    y = area.top + 6.0
    for line, color in zip(_words(profile, hover), ("text", "text_muted"), strict=True):
        width, height = large.size_of(line)
        large.text(QRectF(area.left + 10.0, y, width, height), line, large.color(color), False)
        y += height
    canvas.painter.restore()


def _words(profile: Profile, hover: Hover) -> tuple[str, str]:
    """Say whose slider it is, and what slides from where to where as it grows."""
    assert hover.segment is not None
    title = segment_title(hover.segment, segment_names(profile)[hover.segment])
    return f"{title} · {SYMBOLS[hover.parameter]}", _WAYS[hover.parameter]


def _transform(area: Area, segment: Segment, fan: Floats) -> Transform:
    """Return how the segment and its fan fill the inset."""
    shown = np.concatenate([segment.points, fan.reshape(-1, 2)])
    inner = Area(area.left + _PAD, area.top + _PAD + _HEAD, area.right - _PAD, area.bottom - _PAD)
    return Transform.fitting(shown.min(axis=0), shown.max(axis=0), inner)


def _draw_card(canvas: Canvas, area: Area, places: Floats) -> None:
    """Draw the card, and a frame around what it shows with lines between them."""
    painter = canvas.painter
    low, high = places.min(axis=0) - 6.0, places.max(axis=0) + 6.0
    painter.setBrush(Qt.BrushStyle.NoBrush)
    painter.setPen(canvas.pen("accent", 1.2, 190))
    painter.drawRoundedRect(QRectF(*low, *(high - low)), 4.0, 4.0)
    path = QPainterPath()
    path.addRoundedRect(_box(area), 7.0, 7.0)
    painter.fillPath(path, canvas.color("canvas", 246))
    painter.drawPath(path)


def _draw_range(large: Canvas, segment: Segment, fan: Floats) -> None:
    """Draw the control polygon and the fan of all curves."""
    for a, b in pairwise(large.transform.map(segment.points)):
        large.line(a, b, large.pen("polygon", 1.6))
    for quartic in fan[1:-1]:
        large.quartic(quartic, large.pen("quartic", 1.4, 120))
    for quartic in (fan[0], fan[-1]):
        large.quartic(quartic, large.pen("quartic", 2.0, 220))


def _draw_segment(large: Canvas, segment: Segment, parameter: ParameterName, fan: Floats) -> None:
    """Draw the curve as it is now, its points, and what slides."""
    places = large.transform.map(segment.points)
    large.keep_labels_off(segment.point(np.linspace(0.0, 1.0, 65)))
    large.quartic(segment.quartic, large.pen("generatrix", 3.2))
    for index, at in enumerate(places):
        draw_mark(large, at, index, 6.0)
        large.occupy(QRectF(at[0] - 6.0, at[1] - 6.0, 12.0, 12.0))
    large.painter.setBrush(Qt.BrushStyle.NoBrush)
    _draw_slides(large, segment, parameter, fan)
    for index, name in ((1, "circle_p1"), (2, "circle_p2"), (0, "polygon"), (3, "polygon")):
        large.label(places[index], f"P{index}", large.color(name), 10.0)


def _draw_slides(canvas: Canvas, segment: Segment, parameter: ParameterName, fan: Floats) -> None:
    for leg in SLID[parameter]:
        _draw_slide(canvas, segment, parameter, fan, leg)


def _draw_slide(
    large: Canvas, segment: Segment, parameter: ParameterName, fan: Floats, leg: int
) -> None:
    """Draw a quartic point on its leg, with its name and what lies at both ends of its way."""
    ends = large.transform.map(fan[[0, -1], leg + 1])
    large.line(ends[0], ends[1], large.pen("quartic", 6.0, 90))
    color = large.color("quartic")
    for place, value in zip(ends, PARAMETER_RANGES[parameter], strict=True):
        _dot(large, place, "quartic", 3.0)
        if len(SLID[parameter]) == 1:
            large.label(place, f"{SYMBOLS[parameter]} = {format_number(value)}", color, 9.0)
    at = large.transform.map(segment.quartic[leg + 1])
    _dot(large, at, "quartic", 6.5)
    large.label(at, f"Q{leg + 1}", color, 12.0)


def _dot(canvas: Canvas, at: Floats, name: str, radius: float) -> None:
    canvas.painter.setPen(canvas.pen("canvas", 1.4))
    canvas.painter.setBrush(canvas.color(name))
    canvas.painter.drawEllipse(QPointF(*at.tolist()), radius, radius)
    canvas.painter.setBrush(Qt.BrushStyle.NoBrush)
    x, y = at.tolist()
    canvas.occupy(QRectF(x - radius, y - radius, 2.0 * radius, 2.0 * radius))


def _box(area: Area) -> QRectF:
    return QRectF(area.left, area.top, area.width, area.height)
