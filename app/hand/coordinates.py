"""Screen and design coordinates of the profile editor, and the way between them."""

from __future__ import annotations

import math
from typing import Protocol

import numpy as np
from numpy.typing import ArrayLike

from sgb_core.arrays import Floats
from sgb_core.values import dataclass


@dataclass(frozen=True, slots=True)
class DesignPoint:
    """A place in the profile half-plane, in the document's unit: r to the right, h up."""

    r: float
    h: float

    @classmethod
    def of(cls, pair: ArrayLike) -> DesignPoint:
        """Return the point of an (r, h) pair."""
        r, h = np.asarray(pair, dtype=np.float64).tolist()
        return cls(r, h)

    @property
    def pair(self) -> tuple[float, float]:
        """(r, h)."""
        return self.r, self.h


@dataclass(frozen=True, slots=True)
class ScreenPoint:
    """A place in the widget, in logical pixels: x to the right, y down."""

    x: float
    y: float

    def distance(self, other: ScreenPoint) -> float:
        """Return the distance in logical pixels."""
        return math.hypot(self.x - other.x, self.y - other.y)


@dataclass(frozen=True, slots=True)
class Area:
    """A rectangle of the screen."""

    left: float
    top: float
    right: float
    bottom: float

    @property
    def width(self) -> float:
        """Its width in logical pixels."""
        return self.right - self.left

    @property
    def height(self) -> float:
        """Its height in logical pixels."""
        return self.bottom - self.top

    def contains(self, point: ScreenPoint) -> bool:
        """Whether a point lies inside or on the edge."""
        return self.left <= point.x <= self.right and self.top <= point.y <= self.bottom

    def grown(self, margin: float) -> Area:
        """Return the rectangle with every side moved out by ``margin``."""
        return Area(
            self.left - margin, self.top - margin, self.right + margin, self.bottom + margin
        )


class Paper(Protocol):
    """What carries the profile to the screen: flat in the editor, a plane in space in 3-D."""

    @property
    def scale(self) -> float:
        """Pixels per unit where the hand is."""

    def map(self, points: ArrayLike) -> Floats:
        """Return screen places of (r, h) pairs, both of shape (..., 2)."""

    def to_design(self, point: ScreenPoint) -> DesignPoint:
        """Return which design point lies under a place on the screen."""


# No drawing is smaller than this, in whatever unit.
_POINT = 1e-9


@dataclass(frozen=True, slots=True)
class Transform:
    """Where design coordinates lie on the screen.

    ``scale`` is pixels per unit; (``x0``, ``y0``) is the screen place of r = h = 0.
    """

    scale: float
    x0: float
    y0: float

    @classmethod
    def fitting(cls, lower: ArrayLike, upper: ArrayLike, area: Area) -> Transform:
        """Return the transform that centres the box (``lower``, ``upper``) in ``area``."""
        (r0, h0), (r1, h1) = np.asarray(lower, dtype=float), np.asarray(upper, dtype=float)
        width, height = r1 - r0, h1 - h0
        # A profile that is one point, or next to one, still gets a usable scale.
        reach = max(width, height, abs(r1), abs(h1))
        smallest = reach * 1e-6 if reach > _POINT else 1.0
        scale = min(
            max(area.width, 1.0) / max(width, smallest),
            max(area.height, 1.0) / max(height, smallest),
        )
        centre_x = (area.left + area.right) / 2.0
        centre_y = (area.top + area.bottom) / 2.0
        return cls(scale, centre_x - scale * (r0 + r1) / 2.0, centre_y + scale * (h0 + h1) / 2.0)

    def to_screen(self, point: DesignPoint) -> ScreenPoint:
        """Return where a design point lies on the screen."""
        return ScreenPoint(self.x0 + self.scale * point.r, self.y0 - self.scale * point.h)

    def to_design(self, point: ScreenPoint) -> DesignPoint:
        """Return which design point lies under a place on the screen."""
        return DesignPoint((point.x - self.x0) / self.scale, (self.y0 - point.y) / self.scale)

    def map(self, points: ArrayLike) -> Floats:
        """Return screen places of (r, h) pairs, both of shape (..., 2)."""
        return np.asarray(points) * (self.scale, -self.scale) + (self.x0, self.y0)

    def panned(self, dx: float, dy: float) -> Transform:
        """Return the transform after the paper moved by (dx, dy) pixels."""
        return Transform(self.scale, self.x0 + dx, self.y0 + dy)

    def told_in(self, factor: float) -> Transform:
        """Return the transform by which what was multiplied by ``factor`` lies where it lay."""
        return self if factor == 1.0 else Transform(self.scale / factor, self.x0, self.y0)

    def zoomed(self, factor: float, at: ScreenPoint) -> Transform:
        """Return the transform scaled by ``factor``; what lies under ``at`` stays there."""
        return Transform(
            self.scale * factor,
            at.x + (self.x0 - at.x) * factor,
            at.y + (self.y0 - at.y) * factor,
        )


def nice_step(least: float) -> float:
    """Return the smallest of 1, 2, 5 times a power of ten that is at least ``least``."""
    power = 10.0 ** math.floor(math.log10(least))
    for factor in (1.0, 2.0, 5.0):
        # The tolerance keeps 0.1 + rounding from jumping to 0.2.
        if factor * power >= least * (1.0 - 1e-9):
            return factor * power
    return 10.0 * power


@dataclass(frozen=True, slots=True)
class GridSteps:
    """Spacings of the numbered lines and of the fine lines between them, in design units."""

    major: float
    minor: float

    @classmethod
    def at(cls, scale: float, spacing: float = 62.0) -> GridSteps:
        """Return steps of at least ``spacing`` pixels between numbers at a scale."""
        major = nice_step(spacing / scale)
        leading = round(major / 10.0 ** math.floor(math.log10(major) + 1e-9))
        return cls(major, major / (4 if leading == 2 else 5))

    def snapped(self, value: float) -> float:
        """Return the nearest multiple of the fine step."""
        # Dividing by a whole number of steps per unit gives 0.3, not 0.30000000000000004.
        count = round(value / self.minor)
        return count / (1.0 / self.minor) if self.minor < 1.0 else count * self.minor


def ticks(low: float, high: float, step: float) -> list[int]:
    """Return the whole numbers k with low ≤ k·step ≤ high."""
    return list(range(math.ceil(low / step), math.floor(high / step) + 1))


def decimals_for(resolution: float) -> int:
    """Return how many decimals tell two values ``resolution`` apart, at most 12."""
    return min(12, max(0, math.ceil(-math.log10(resolution) - 1e-9)))


def number(value: float, decimals: int) -> str:
    """Return a value with so many decimals, a true minus sign and never a negative zero."""
    text = f"{value:.{decimals}f}"
    if float(text) == 0.0:
        text = text.lstrip("-")
    return text.replace("-", "−")
