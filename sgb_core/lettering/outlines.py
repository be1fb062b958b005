"""The outlines of a line of text: the font's own curves, in heights of its capitals.

The baseline is y = 0, capitals reach to y = 1, and the line begins at x = 0. The curves are the
quadratic splines of a TrueType font, taken apart into chords.
"""

from __future__ import annotations

from functools import lru_cache
from math import ceil, sqrt
from typing import Any

import numpy as np
import shapely
from shapely.geometry.base import BaseGeometry

from sgb_core.arrays import Floats
from sgb_core.lettering.fonts import FontName, font_of

# How far a chord may lie off its curve, in heights of capitals, and the most chords of a piece.
CHORD = 1e-3
_MOST = 64


@lru_cache(maxsize=64)
def text_letters(text: str, font: FontName) -> tuple[BaseGeometry, ...]:
    """Return the outline of each letter of a line where it stands, those of blanks left out."""
    read = font_of(font)
    names, advances = read.getBestCmap(), read["hmtx"]
    scale = 1.0 / _capitals(font)
    found: list[BaseGeometry] = []
    x = 0.0
    for letter in text:
        name = names.get(ord(letter), ".notdef")
        shape = glyph(name, font)
        if not shape.is_empty:
            found.append(shapely.transform(shape, lambda points, x=x: points + np.array([x, 0.0])))
        x += advances[name][0] * scale
    return tuple(found)


@lru_cache(maxsize=256)
def glyph(name: str, font: FontName) -> BaseGeometry:
    """Return the outline of one glyph of a font, as polygons with what they enclose left out."""
    scale = 1.0 / _capitals(font)
    rings = [scale * ring for ring in _contours(name, font)]
    polygons = [shapely.Polygon(ring) for ring in rings if len(ring) > 2]
    # Contours that run clockwise are ink; a smaller one lies on what a larger one made.
    order = sorted(range(len(polygons)), key=lambda k: -polygons[k].area)
    result: BaseGeometry = shapely.Polygon()
    for k in order:
        part = shapely.make_valid(polygons[k])
        ink = not shapely.is_ccw(polygons[k].exterior)
        result = result.union(part) if ink else result.difference(part)
    return result


@lru_cache(maxsize=len(FontName))
def _capitals(font: FontName) -> float:
    """Return how high capitals are, in the font's own units."""
    return float(font_of(font)["glyf"]["H"].yMax)


def _contours(name: str, font: FontName) -> list[Floats]:
    """Return the closed contours of a glyph as chords, (k, 2) each, in the font's units."""
    from fontTools.pens.recordingPen import DecomposingRecordingPen

    glyphs = font_of(font).getGlyphSet()
    pen = DecomposingRecordingPen(glyphs)
    glyphs[name].draw(pen)
    tolerance = CHORD * _capitals(font)
    found: list[list[Floats]] = []
    for step, points in pen.value:
        if step == "moveTo":
            found.append([np.array(points)])
        elif step == "lineTo":
            found[-1].append(np.array(points))
        elif step == "qCurveTo":
            if points[-1] is None:
                found.append([])
            found[-1] += _quadratics(found[-1][-1][-1] if found[-1] else None, points, tolerance)
    return [np.concatenate(each).astype(np.float64) for each in found if each]


def _quadratics(start: Floats | None, points: Any, tolerance: float) -> list[Floats]:
    """Return the chords of a spline of quadratics whose inner ends are implied, (k, 2) each.

    Where ``start`` is None it is closed and has no end of its own, as TrueType allows.
    """
    controls = [np.array(point, float) for point in points if point is not None]
    if start is None:
        start = (controls[-1] + controls[0]) / 2.0
        controls.append(start)
    found = []
    for k, control in enumerate(controls[:-1]):
        last = k == len(controls) - 2
        end = controls[-1] if last else (control + controls[k + 1]) / 2.0
        # A quadratic is farthest from its chord halfway: by |P0 − 2 P1 + P2|/4.
        bend = float(np.hypot(*(start - 2.0 * control + end))) / 4.0
        count = min(max(1, ceil(sqrt(bend / tolerance))), _MOST)
        t = np.arange(1, count + 1)[:, None] / count
        found.append((1.0 - t) ** 2 * start + 2.0 * t * (1.0 - t) * control + t * t * end)
        start = end
    return found
