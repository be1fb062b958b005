"""Guides of the profile editor, drawn."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from app.hand.canvas import Canvas
from sgb_core.document.guides import Guide, GuideAt

_ALPHA = 170


def draw_guides(canvas: Canvas, guides: Sequence[Guide]) -> None:
    """Draw each guide through the whole picture."""
    area, pen = canvas.area, canvas.pen("accent", 1.0, _ALPHA)
    for guide in guides:
        if guide.at is GuideAt.RADIUS:
            x = float(canvas.transform.map((guide.value, 0.0))[0])
            canvas.line(np.array((x, area.top)), np.array((x, area.bottom)), pen)
        else:
            y = float(canvas.transform.map((0.0, guide.value))[1])
            canvas.line(np.array((area.left, y)), np.array((area.right, y)), pen)
