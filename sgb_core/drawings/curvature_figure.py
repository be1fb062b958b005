"""Curvature and the distance from the plain cubic along a profile, as a figure for a paper."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.curves.along import Along
from sgb_core.document.model import Document
from sgb_core.drawings import fonts
from sgb_core.drawings.errors import DrawingError
from sgb_core.drawings.graph import TEXT, Graph, spread
from sgb_core.drawings.page import Anchor, Drawing, Mark, Page, Pen, Words
from sgb_core.findings.drawings import NoDrawing
from sgb_core.surfaces.section_along import along_section

WIDTH, HEIGHT = 175.0, 120.0
_MARGIN, _LEFT, _RIGHT = 3.0, 24.0, 7.0
_PER_SEGMENT = 401
# Near an end whose derivative vanishes curvature grows beyond all bounds: so much of it is shown.
_SHOWN, _EVEN = 0.98, 2001
_BETWEEN, _BELOW, _ABOVE = 5.0, 11.0, 5.0
_CURVE = Pen(0.35)


def _evenly(parts: Sequence[Along], whole: float) -> Floats:
    """Return the curvature at equal steps of arc length: a tight bend counts by its length."""
    lengths = np.concatenate([part.length for part in parts])
    values = np.concatenate([part.curvature for part in parts])
    known = np.isfinite(values)
    if not known.any():
        return np.zeros(1)
    even = np.linspace(0.0, whole, _EVEN)
    return np.asarray(np.interp(even, lengths[known], values[known]))


def curvature_figure(document: Document) -> Drawing:
    """Return κ and the deviation over the arc length, joints marked; at θ = 0 where laws hold.

    Raises DrawingError for a profile of no length.
    """
    surface = document.surface
    parts = along_section(surface, _PER_SEGMENT)
    whole = float(parts[-1].length[-1])
    if whole <= 0.0:
        raise DrawingError(NoDrawing.POINT)
    unit = str(document.unit)
    high = 0.5 * (HEIGHT - 2.0 * _MARGIN - _BETWEEN - _BELOW - _ABOVE)
    wide = WIDTH - _MARGIN - _LEFT - _RIGHT
    low = _MARGIN + _BELOW
    below = Graph(_LEFT, low, wide, high, (0.0, whole), spread([p.deviation for p in parts]))
    above = Graph(
        _LEFT,
        low + high + _BETWEEN,
        wide,
        high,
        (0.0, whole),
        spread([_evenly(parts, whole)], _SHOWN),
    )
    made: list[Mark] = above.frame("", f"κ (1/{unit})")
    made += below.frame(f"arc length ({unit})", f"distance from the cubic ({unit})")
    zero = np.array([(0.0, 0.0), (whole, 0.0)])
    made += above.curve(zero, Pen(0.18))
    clear = -1.0
    for number, part in enumerate(parts):
        for graph, values in ((above, part.curvature), (below, part.deviation)):
            made += graph.curve(np.stack([part.length, values], axis=1), _CURVE)
            if number:
                made.append(graph.upright(float(part.length[0])))
        middle = 0.5 * float(part.length[0] + part.length[-1])
        x = float(above.placed(np.array([(middle, 0.0)]))[0, 0])
        # Counted from 1, as the window and papers count.
        label = str(number + 1)
        half = 0.5 * fonts.width(label, TEXT)
        if x - half > clear:
            at = (x, above.low + high + 1.0)
            made.append(Words(label, at, TEXT, Anchor.MIDDLE))
            clear = x + half + 1.0
    page = Page(WIDTH, HEIGHT, (_MARGIN,) * 4, tuple(made))
    subject = "Curvature and distance from the plain cubic along the profile, by segment"
    return Drawing((page,), document.name, subject, 0.01, "", ("curvature", "SGB Studio"))
