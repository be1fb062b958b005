"""A graph on a page: an area with two scales, curves clipped to it, and names at its axes."""

from __future__ import annotations

from collections.abc import Sequence
from math import ceil, floor, log10

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.drawings import fonts
from sgb_core.drawings.marks import line, rectangle
from sgb_core.drawings.page import FINE, Anchor, Layer, Mark, Path, Pen, Stroke, Words
from sgb_core.values import dataclass

TEXT = 2.0
_TICK, _GAP = 1.2, 1.0
# About so far apart are the numbers at an axis, in mm.
_APART = 16.0


@dataclass(frozen=True, slots=True)
class Graph:
    """Where a graph stands on the page (mm) and which values its sides stand for."""

    left: float
    low: float
    width: float
    height: float
    x: tuple[float, float]
    y: tuple[float, float]

    def placed(self, points: Floats) -> Floats:
        """Return where values (k, 2) lie on the page."""
        (x0, x1), (y0, y1) = self.x, self.y
        part = (points - (x0, y0)) / (x1 - x0, y1 - y0)
        return np.asarray(part * (self.width, self.height) + (self.left, self.low))

    def frame(self, x_name: str, y_name: str) -> list[Mark]:
        """Return the frame, ticks with numbers, and the names of the axes; "" for no numbers."""
        right, high = self.left + self.width, self.low + self.height
        made: list[Mark] = [rectangle(Layer.FRAME, self.left, self.low, right, high)]
        for value, words in ticks(*self.x, self.width):
            x = float(self.placed(np.array([(value, self.y[0])]))[0, 0])
            made.append(line(Layer.FRAME, (x, self.low), (x, self.low + _TICK)))
            if x_name:
                at = (x, self.low - TEXT - _GAP)
                made.append(Words(words, at, TEXT, Anchor.MIDDLE))
        widest = 0.0
        for value, words in ticks(*self.y, self.height, 0.7):
            y = float(self.placed(np.array([(self.x[0], value)]))[0, 1])
            made.append(line(Layer.FRAME, (self.left, y), (self.left + _TICK, y)))
            at = (self.left - _GAP, min(max(y - 0.5 * TEXT, self.low), high - TEXT))
            made.append(Words(words, at, TEXT, Anchor.END))
            widest = max(widest, fonts.width(words, TEXT))
        if x_name:
            at = (self.left + 0.5 * self.width, self.low - 2.4 * TEXT - 2.0 * _GAP)
            made.append(Words(x_name, at, TEXT, Anchor.MIDDLE))
        at = (self.left - widest - 2.0 * _GAP - 0.5, self.low + 0.5 * self.height)
        made.append(Words(y_name, at, TEXT, Anchor.MIDDLE, 90.0))
        return made

    def curve(self, points: Floats, pen: Pen, layer: Layer = Layer.OUTLINE) -> list[Mark]:
        """Return a polyline of values (k, 2), broken where it leaves the graph or is not finite."""
        low, high = self.y
        inside = np.isfinite(points).all(axis=1) & (points[:, 1] >= low) & (points[:, 1] <= high)
        paths = []
        for run in np.split(np.arange(len(points)), np.flatnonzero(np.diff(inside)) + 1):
            if inside[run[0]] and len(run) > 1:
                places = self.placed(points[run]).tolist()
                paths.append(Path.through([(x, y) for x, y in places]))
        return [Stroke.of(layer, *paths, pen=pen)] if paths else []

    def upright(self, x: float) -> Mark:
        """Return a fine dashed line across the graph at a value."""
        at = float(self.placed(np.array([(x, self.y[0])]))[0, 0])
        path = Path.through(((at, self.low), (at, self.low + self.height)))
        return Stroke.of(Layer.EDGES, path, pen=Pen(FINE, (1.5, 1.0)))


def ticks(low: float, high: float, length: float, apart: float = 1.0) -> list[tuple[float, str]]:
    """Return round values between two, and their words, some 16 mm apart."""
    span = high - low
    rough = span / max(2.0, length / (_APART * apart))
    power = 10.0 ** floor(log10(rough))
    step = next(digit * power for digit in (1.0, 2.0, 5.0, 10.0) if digit * power >= rough)
    places = max(0, -floor(log10(step) + 1e-9))
    first, last = ceil(low / step - 1e-9), floor(high / step + 1e-9)
    found = []
    for number in range(first, last + 1):
        value = number * step
        plain = f"{value:.{places}f}" if step >= 1e-4 and abs(value) < 1e6 else f"{value:.3g}"
        found.append((value, plain.replace("-", "−")))
    return found


def spread(values: Sequence[Floats], share: float = 1.0) -> tuple[float, float]:
    """Return a range that holds a share of all finite values, 0 among them, with room around."""
    finite = np.concatenate([each[np.isfinite(each)] for each in values])
    if len(finite) == 0:
        return -1.0, 1.0
    beyond = 0.5 * (1.0 - share)
    low, high = np.quantile(finite, [beyond, 1.0 - beyond]).tolist()
    low, high = min(0.0, low), max(0.0, high)
    room = 0.08 * (high - low) or 1.0
    return (low - room if low < 0.0 else 0.0), high + room
