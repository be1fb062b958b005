"""The profile itself: silhouette, control polygon, generatrix and what is wrong with it."""

from __future__ import annotations

from collections.abc import Collection, Iterable
from itertools import groupby, pairwise

import numpy as np
from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QPainter

from app.hand.canvas import Canvas, joined, most_pieces, polygon
from app.hand.density import segment_presence
from sgb_core.arrays import Floats
from sgb_core.curves import basis
from sgb_core.curves.crossings import BeyondAxis, Crossing
from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import Segment

_FILL_PIECES = 600


def draw_silhouette(canvas: Canvas, profile: Profile) -> None:
    """Draw what the other half of the turn shows: the mirror image, and both halves tinted."""
    places = canvas.transform.map(profile.quartics)
    pen = canvas.pen("ghost", 1.6)
    pieces = most_pieces(places)
    if pieces > _FILL_PIECES:
        # Straight pieces would part from the curve: only what is on the screen, and no tint.
        canvas.chain(profile.quartics * (-1.0, 1.0), pen)
        return
    # Half as many pieces stray four times as far: still well below a pixel, and only a ghost.
    chain = basis.bernstein(4, np.linspace(0.0, 1.0, pieces // 2 + 2)) @ places
    mirror = chain * (-1.0, 1.0) + (2.0 * canvas.transform.x0, 0.0)
    painter = canvas.painter
    # The lines drawn over its edges hide that the tint is not antialiased, which is quicker.
    painter.setRenderHint(QPainter.RenderHint.Antialiasing, False)
    painter.setPen(Qt.PenStyle.NoPen)
    painter.setBrush(canvas.color("surface", 36))
    whole, other = chain.reshape(-1, 2), mirror.reshape(-1, 2)
    if profile.closed:
        painter.drawPolygon(polygon(whole))
        painter.drawPolygon(polygon(other))
    else:
        painter.drawPolygon(polygon(np.concatenate((whole, other[::-1]))))
    painter.setBrush(Qt.BrushStyle.NoBrush)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    for part in joined(mirror):
        canvas.polyline(part, pen)


def draw_polygon(canvas: Canvas, profile: Profile, lit: Collection[int]) -> None:
    """Draw the control polygons: those of ``lit`` segments in full, crowded ones not at all."""
    shown = segment_presence(canvas.transform.map(profile.control_points), ())
    for index, segment in enumerate(profile.segments):
        if index not in lit and shown[index] > 0.0:
            _draw_legs(canvas, segment, 1.0, round(40 + 80 * float(shown[index])))
    for index in lit:
        if index < len(profile):
            _draw_legs(canvas, profile.segments[index], 1.6, 255)


def _draw_legs(canvas: Canvas, segment: Segment, width: float, alpha: int) -> None:
    pen = canvas.pen("polygon", width, alpha)
    places = canvas.transform.map(segment.points)
    for a, b in pairwise(places):
        canvas.line(a, b, pen)


def draw_generatrix(
    canvas: Canvas, profile: Profile, selected: Iterable[int], hovered: int | None
) -> None:
    """Draw the curve, with a halo around selected segments and a fainter one where hovered."""
    chosen = set(selected)
    for index, segment in enumerate(profile.segments):
        if index in chosen:
            canvas.quartic(segment.quartic, canvas.pen("selection", 9.0, 62))
        elif index == hovered:
            canvas.quartic(segment.quartic, canvas.pen("generatrix", 8.0, 80))
    for lit, run in groupby(range(len(profile)), chosen.__contains__):
        numbers = list(run)
        pen = canvas.pen("generatrix", 3.0 if lit else 2.4)
        canvas.chain(profile.quartics[numbers[0] : numbers[-1] + 1], pen)


def draw_faults(
    canvas: Canvas, profile: Profile, stretches: Iterable[BeyondAxis], crossings: Iterable[Crossing]
) -> None:
    """Draw red what lies beyond the axis, and circle where the profile meets itself."""
    for stretch in stretches:
        part = _part(profile.segments[stretch.segment].quartic, stretch.s0, stretch.s1)
        canvas.quartic(part, canvas.pen("error", 7.0, 60))
        canvas.quartic(part, canvas.pen("error", 3.0))
        middle = canvas.transform.map(profile.point(stretch.segment, (stretch.s0 + stretch.s1) / 2))
        canvas.label(middle, "beyond the axis", canvas.color("error"), 12.0)
    for crossing in crossings:
        x, y = canvas.transform.map(np.asarray(crossing.point)).tolist()
        canvas.painter.setPen(canvas.pen("error", 2.0))
        canvas.painter.drawEllipse(QPointF(x, y), 9.0, 9.0)
        canvas.occupy(QRectF(x - 9.0, y - 9.0, 18.0, 18.0))
        canvas.label(np.array((x, y)), "crosses itself", canvas.color("error"), 14.0)


def _part(quartic: Floats, s0: float, s1: float) -> Floats:
    """Return the control points of the part of a quartic from s0 to s1, by blossoming."""
    weights = np.empty((5, 5))
    for k in range(5):
        # The blossom at s0 taken 4 − k times and s1 taken k times.
        row = np.ones(1)
        for s in (s0,) * (4 - k) + (s1,) * k:
            row = np.convolve(row, (1.0 - s, s))
        weights[k] = row
    return np.asarray(weights @ quartic)
