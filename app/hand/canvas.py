"""Drawing aids of the profile editor: a painter that knows the transform and the colours."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import field
from functools import lru_cache
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QBrush, QColor, QFont, QFontMetricsF, QPainter, QPen, QPolygonF

from app.hand.coordinates import Area, Transform
from app.hand.label_room import LabelRoom
from app.theme.theme import Palette
from sgb_core.arrays import Floats
from sgb_core.curves import basis
from sgb_core.values import dataclass

# A chord may stray this many pixels from its curve; less is invisible with antialiasing.
FLATNESS = 0.15
_WHOLE = 200
_LEAST, _MOST = 2, 900
_COARSE = 128
# Ends so near each other, in pixels, are one place of a line.
_APART = 0.05
# Where equal steps make so many times the pieces, each curve gets its own.
_UNEVEN = 8

# Places on the curve that labels keep clear of: so far apart, so many at most, so far outside.
_NOTED = 5.0
_MOST_NOTED = 3000
_NOTED_BEYOND = 200.0
# What is taken counts as much as so many places of a curve; under what lies over the picture
# nothing could be read.
_TAKEN, _HIDDEN = 50, 10_000


@lru_cache(maxsize=256)
def _bernstein(pieces: int) -> Floats:
    return basis.bernstein(4, np.linspace(0.0, 1.0, pieces + 1))


def _pieces_for_each(quartics: Floats) -> Floats:
    """Return how many equal pieces in s keep chords within FLATNESS of quartics in pixels.

    For shape (n, 5, 2) so many numbers. A chord over a step δ strays at most δ²/8·max|L''|, and
    |L''| ≤ 12·max|Δ²Q|.
    """
    second = quartics[:, 2:] - 2.0 * quartics[:, 1:-1] + quartics[:, :-2]
    bends = np.sqrt((second**2).sum(axis=2).max(axis=1))
    found: Floats = np.maximum(_LEAST, np.ceil(np.sqrt(12.0 * bends / (8.0 * FLATNESS))))
    return found


def most_pieces(quartics: Floats) -> int:
    """Return how many equal pieces in s keep the chords of all of several quartics so near."""
    return int(_pieces_for_each(quartics).max())


def joined(parts: Floats, seen: NDArray[np.bool_] | None = None) -> Iterator[Floats]:
    """Yield the polylines, each (m, 2), that polylines in pixels (n, k, 2) make end to end.

    ``seen``, shape (n,), says which of them are drawn at all.
    """
    whole = np.ones(len(parts), dtype=np.bool_) if seen is None else seen
    apart = np.abs(parts[1:, 0] - parts[:-1, -1]).max(axis=1) > _APART
    breaks = 1 + np.flatnonzero(apart | (whole[1:] != whole[:-1]))
    for first, last in pairwise((0, *breaks.tolist(), len(parts))):
        if whole[first]:
            body = parts[first:last, :-1].reshape(-1, 2)
            yield np.concatenate([body, parts[last - 1, -1:]])


def visible_runs(quartic: Floats, area: Area) -> Iterator[Floats]:
    """Yield the polylines, shape (m, 2), of a quartic in pixels as far as it touches ``area``."""
    low, high = quartic.min(axis=0), quartic.max(axis=0)
    if low[0] > area.right or high[0] < area.left or low[1] > area.bottom or high[1] < area.top:
        return
    pieces = most_pieces(quartic[None])
    if pieces <= _WHOLE:
        yield _bernstein(pieces) @ quartic
        return
    # Zoomed far in: only what is on the screen gets the fine steps.
    coarse = _bernstein(_COARSE) @ quartic
    slack = 2.0 * FLATNESS * (pieces / _COARSE) ** 2 + 2.0
    lows = np.minimum(coarse[:-1], coarse[1:]) - slack
    highs = np.maximum(coarse[:-1], coarse[1:]) + slack
    inside = (
        (lows[:, 0] <= area.right)
        & (highs[:, 0] >= area.left)
        & (lows[:, 1] <= area.bottom)
        & (highs[:, 1] >= area.top)
    )
    edges = np.flatnonzero(np.diff(np.concatenate(([False], inside, [False]))))
    for first, last in zip(edges[::2], edges[1::2], strict=True):
        count = min(_MOST, max(8, math.ceil(pieces * (last - first) / _COARSE)))
        s = np.linspace(first / _COARSE, last / _COARSE, count + 1)
        yield basis.bernstein(4, s) @ quartic


@lru_cache(maxsize=512)
def _color(name: str, alpha: int) -> QColor:
    color = QColor(name)
    color.setAlpha(alpha)
    return color


@lru_cache(maxsize=512)
def _pen(name: str, width: float, alpha: int, style: Qt.PenStyle) -> QPen:
    pen = QPen(_color(name, alpha), width, style)
    pen.setCapStyle(Qt.PenCapStyle.RoundCap)
    pen.setJoinStyle(Qt.PenJoinStyle.RoundJoin)
    return pen


@dataclass(slots=True)
class Canvas:
    """One picture being painted; ``area`` is the part inside the rulers."""

    painter: QPainter
    transform: Transform
    palette: Palette
    area: Area
    font: QFont
    _room: LabelRoom = field(default_factory=LabelRoom)
    _over: list[QRectF] = field(default_factory=list)

    def occupy(self, box: QRectF) -> None:
        """Keep the labels that follow clear of a rectangle."""
        self._room.occupy(box)

    def hide_under(self, box: QRectF) -> None:
        """Keep all labels clear of what lies over the picture, before all else."""
        self._over.append(box)
        self._room.occupy(box)

    def keep_labels_off(self, curve: Floats) -> None:
        """Let labels cover nothing of a curve, given by places in design coordinates (m, 2)."""
        places = self.transform.map(curve)
        area = self.area.grown(_NOTED_BEYOND)
        low, high = (area.left, area.top), (area.right, area.bottom)
        places = places[((places > low) & (places < high)).all(axis=1)]
        if len(places) > 1:
            # So close together that no label fits in between.
            way = np.concatenate(([0.0], np.cumsum(np.hypot(*np.diff(places, axis=0).T))))
            steps = np.linspace(0.0, way[-1], min(_MOST_NOTED, int(way[-1] / _NOTED) + 2))
            places = np.stack([np.interp(steps, way, row) for row in places.T], axis=1)
        self._room.lay_curve(places)

    def color(self, name: str, alpha: int = 255) -> QColor:
        """Return the palette's colour for a meaning, with an opacity of 0 to 255."""
        return _color(getattr(self.palette, name), alpha)

    def pen(
        self,
        name: str,
        width: float = 1.0,
        alpha: int = 255,
        style: Qt.PenStyle = Qt.PenStyle.SolidLine,
    ) -> QPen:
        """Return a round pen in the palette's colour for a meaning; pens are shared: copy first."""
        return _pen(getattr(self.palette, name), width, alpha, style)

    def polyline(self, places: Floats, pen: QPen) -> None:
        """Draw a polyline through screen places of shape (m, 2)."""
        self.painter.setPen(pen)
        self.painter.drawPolyline(polygon(places))

    def quartic(self, quartic: Floats, pen: QPen) -> None:
        """Draw a quartic given in design coordinates, shape (5, 2)."""
        for run in visible_runs(self.transform.map(quartic), self.area.grown(pen.widthF() + 2.0)):
            self.polyline(run, pen)

    def chain(self, quartics: Floats, pen: QPen) -> None:
        """Draw quartics that follow one another, design coordinates, shape (n, 5, 2)."""
        places, area = self.transform.map(quartics), self.area.grown(pen.widthF() + 2.0)
        pieces = _pieces_for_each(places)
        most = int(pieces.max())
        if most > _WHOLE or most * len(places) > _UNEVEN * int(pieces.sum()):
            for quartic in quartics:
                self.quartic(quartic, pen)
            return
        low, high = places.min(axis=1), places.max(axis=1)
        seen = ((low <= (area.right, area.bottom)) & (high >= (area.left, area.top))).all(axis=1)
        for part in joined(_bernstein(most) @ places, seen):
            self.polyline(part, pen)

    def line(self, a: Floats, b: Floats, pen: QPen) -> None:
        """Draw a straight line between screen places, cut at the picture's edges.

        Cutting keeps dashes cheap where the ends lie far outside.
        """
        ends = clipped(a, b, self.area.grown(8.0))
        if ends is not None:
            self.painter.setPen(pen)
            self.painter.drawLine(QPointF(*ends[0]), QPointF(*ends[1]))

    def shape(self, places: Floats, pen: QPen, fill: QBrush | QColor | None = None) -> None:
        """Draw a closed polygon through screen places."""
        self.painter.setPen(pen)
        self.painter.setBrush(fill if fill is not None else Qt.BrushStyle.NoBrush)
        self.painter.drawPolygon(polygon(places))
        self.painter.setBrush(Qt.BrushStyle.NoBrush)

    def arrow(self, a: Floats, b: Floats, pen: QPen, head: float = 8.0) -> None:
        """Draw an arrow from ``a`` to ``b``; only the head where they nearly meet."""
        way = np.asarray(b) - a
        length = float(np.hypot(*way))
        if length < 1.0:
            return
        along = way / length
        across = np.array((-along[1], along[0]))
        head = min(head, length)
        neck = b - head * along
        self.line(a, neck, pen)
        tip = np.array([b, neck + 0.45 * head * across, neck - 0.45 * head * across])
        self.shape(tip, QPen(pen.color(), 1.0), pen.color())

    def size_of(self, text: str) -> tuple[float, float]:
        """Return width and height of a text in the canvas' font."""
        metrics = QFontMetricsF(self.font)
        return metrics.horizontalAdvance(text), metrics.height()

    def text(self, box: QRectF, text: str, color: QColor, halo: bool = True) -> None:
        """Draw a text centred in a box, on a soft patch of the canvas where ``halo`` says so."""
        painter = self.painter
        if halo:
            painter.setPen(Qt.PenStyle.NoPen)
            painter.setBrush(self.color("canvas", 205))
            painter.drawRoundedRect(box.adjusted(-2, 0, 2, 0), 3, 3)
            painter.setBrush(Qt.BrushStyle.NoBrush)
        painter.setFont(self.font)
        painter.setPen(color)
        painter.drawText(box, Qt.AlignmentFlag.AlignCenter, text)

    def label(self, at: Floats, text: str, color: QColor, distance: float = 9.0) -> bool:
        """Write a text beside a screen place, near it or farther; leave it out if there is no room.

        It never lies on a curve, nor on what is occupied. Returns whether there was room.
        """
        width, height = self.size_of(text)
        inner = QRectF(self.area.left, self.area.top, self.area.width, self.area.height)
        for away in (distance, distance + 9.0, distance + 18.0):
            for dx, dy in _SIDES:
                centre_x = at[0] + dx * (away + width / 2.0)
                centre_y = at[1] + dy * (away + height / 2.0)
                box = QRectF(centre_x - width / 2.0, centre_y - height / 2.0, width, height)
                if inner.contains(box) and self.covered(box) == 0:
                    self.occupy(box)
                    self.text(box, text, color)
                    return True
        return False

    def covered(self, box: QRectF) -> int:
        """Return how much a label in a box would cover of the curves, more where it is taken."""
        hidden = any(box.intersects(each) for each in self._over)
        taken = not self._room.is_free(box)
        return self._room.covered(box) + _TAKEN * taken + _HIDDEN * hidden


_SIDES = (
    (1.0, 0.0),
    (-1.0, 0.0),
    (0.8, -0.8),
    (-0.8, -0.8),
    (0.8, 0.8),
    (-0.8, 0.8),
    (0, -1),
    (0, 1),
)


def polygon(places: Floats) -> QPolygonF:
    """Return screen places of shape (m, 2) as Qt's polygon."""
    return QPolygonF([QPointF(x, y) for x, y in places.tolist()])


def clipped(a: Floats, b: Floats, area: Area) -> tuple[list[float], list[float]] | None:
    """Return the part of a straight line inside a rectangle (Liang and Barsky), or None."""
    x, y = float(a[0]), float(a[1])
    dx, dy = float(b[0]) - x, float(b[1]) - y
    enter, leave = 0.0, 1.0
    for step, room in (
        (-dx, x - area.left),
        (dx, area.right - x),
        (-dy, y - area.top),
        (dy, area.bottom - y),
    ):
        if step == 0.0:
            if room < 0.0:
                return None
        elif step < 0.0:
            enter = max(enter, room / step)
        else:
            leave = min(leave, room / step)
    if enter > leave:
        return None
    return [x + enter * dx, y + enter * dy], [x + leave * dx, y + leave * dy]
