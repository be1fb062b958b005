"""How far places are from the outline of a line of text: what soft edges are made of."""

from __future__ import annotations

from functools import lru_cache

import numpy as np
import shapely

from sgb_core.arrays import Floats, between, frozen
from sgb_core.lettering.fonts import FontName
from sgb_core.lettering.outlines import text_letters
from sgb_core.values import dataclass

# Samples in the height of a capital; how far beyond its letters distances are known, in heights.
_PER_CAPITAL = 48
REACH = 0.5


@dataclass(frozen=True, slots=True, eq=False)
class TextDistances:
    """Signed distances in heights of capitals, positive inside, sampled at even steps.

    ``values`` (rows, columns); the first lies at ``corner`` (x, y), the next a ``step`` on.
    ``middle`` is the x of the middle of the letters, ``half`` how far they reach to both sides.
    """

    values: Floats
    corner: tuple[float, float]
    step: float
    middle: float
    half: float

    def at(self, x: Floats, y: Floats) -> Floats:
        """Return the distances at broadcast places; beyond what is known they are −REACH."""
        x, y = np.broadcast_arrays(x, y)
        columns, rows = (x - self.corner[0]) / self.step, (y - self.corner[1]) / self.step
        count = self.values.shape
        inside = (rows >= 0.0) & (rows <= count[0] - 1) & (columns >= 0.0)
        inside &= columns <= count[1] - 1
        found = np.full(x.shape, -REACH)
        low, up = between(rows[inside], count[0])
        left, right = between(columns[inside], count[1])
        lower = self.values[low, left] * (1.0 - right) + self.values[low, left + 1] * right
        upper = self.values[low + 1, left] * (1.0 - right) + self.values[low + 1, left + 1] * right
        found[inside] = lower * (1.0 - up) + upper * up
        return found


@lru_cache(maxsize=16)
def text_distances(text: str, font: FontName) -> TextDistances | None:
    """Return the distances of a line of text; None for one of blanks."""
    letters = text_letters(text, font)
    if not letters:
        return None
    bounds = np.array([letter.bounds for letter in letters])
    low, high = bounds[:, :2].min(axis=0), bounds[:, 2:].max(axis=0)
    step = 1.0 / _PER_CAPITAL
    corner = low - REACH
    columns, rows = np.ceil((high - low + 2.0 * REACH) / step).astype(int) + 1
    values = np.full((rows, columns), -REACH)
    for letter, (left, below, right, above) in zip(letters, bounds.tolist(), strict=True):
        window = [
            slice(max(int((a - REACH - at) / step), 0), int((b + REACH - at) / step) + 2)
            for a, b, at in ((below, above, corner[1]), (left, right, corner[0]))
        ]
        part = values[window[0], window[1]]
        y, x = (corner[axis] + step * np.arange(count)[at] for axis, count, at in zip(
            (1, 0), (rows, columns), window, strict=True
        ))  # fmt: skip
        xs, ys = (each.ravel() for each in np.meshgrid(x, y))
        away = shapely.distance(letter.boundary, shapely.points(xs, ys))
        shapely.prepare(letter)
        signed = np.where(shapely.contains_xy(letter, xs, ys), away, -away)
        np.maximum(part, signed.reshape(part.shape), out=part)
    middle = float(low[0] + high[0]) / 2.0
    half = float(high[0] - low[0]) / 2.0
    return TextDistances(frozen(values), (float(corner[0]), float(corner[1])), step, middle, half)
