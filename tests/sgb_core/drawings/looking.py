"""Looks at pages as a reader would: what lies over what, and what lies outside."""

from __future__ import annotations

from math import cos, radians, sin

import numpy as np
import shapely

from sgb_core.drawings import fonts
from sgb_core.drawings.page import Anchor, Layer, Page, Stroke, Words


def box_of(words: Words) -> shapely.Polygon:
    """Return the rectangle of a line of words, from below its baseline to its capitals."""
    length = fonts.width(words.text, words.height)
    back = {Anchor.START: 0.0, Anchor.MIDDLE: 0.5, Anchor.END: 1.0}[words.anchor] * length
    low, high = -0.2 * words.height, words.height
    corners = np.array([(-back, low), (length - back, low), (length - back, high), (-back, high)])
    c, s = cos(radians(words.turn_deg)), sin(radians(words.turn_deg))
    return shapely.Polygon(corners @ np.array([[c, s], [-s, c]]) + words.at)


def boxes(page: Page) -> list[tuple[str, shapely.Polygon]]:
    """Return all words with their rectangles."""
    return [(mark.text, box_of(mark)) for mark in page.marks if isinstance(mark, Words)]


def overlaps(page: Page) -> list[tuple[str, str]]:
    """Return words that lie over other words, over lines or over filled areas."""
    found = []
    known = boxes(page)
    for number, (text, box) in enumerate(known):
        found += [(text, other) for other, place in known[:number] if place.intersects(box)]
    for mark in page.marks:
        if isinstance(mark, Words) or mark.layer is Layer.PAINT:
            continue
        for path in mark.paths:
            points = path.flat()
            if isinstance(mark, Stroke):
                shape = shapely.buffer(shapely.LineString(points), 0.5 * mark.pen.width)
            else:
                shape = shapely.Polygon(points)
            found += [(text, mark.layer.value) for text, box in known if shape.intersects(box)]
    return found


def outside(page: Page) -> list[str]:
    """Return what reaches beyond the margins."""
    left, right, bottom, top = page.margins
    room = shapely.box(left, bottom, page.width - right, page.height - top).buffer(0.001)
    found = [text for text, box in boxes(page) if not room.contains(box)]
    for mark in page.marks:
        if isinstance(mark, Words):
            continue
        # The frame is the margin itself; of all else the width of the line counts too.
        half = 0.5 * mark.pen.width if isinstance(mark, Stroke) and mark.layer != "frame" else 0.0
        for path in mark.paths:
            line = shapely.LineString(path.flat())
            # Where a tile cuts a line its end is level with the border.
            shape = line.buffer(half, cap_style="flat") if half and line.length else line
            if not room.buffer(0.01).contains(shape):
                found.append(mark.layer.value)
    return found
