"""What a traced vessel holds, and how far scale, curve and sides leave it open."""

from __future__ import annotations

from math import pi, sqrt

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.sources.intake import Taken
from sgb_core.sources.options import Options
from sgb_core.sources.reading import Reading
from sgb_core.surfaces.measures import area, volume
from sgb_core.surfaces.revolution import RevolutionSurface
from sgb_core.values import dataclass

# How truly a place of a picture is set, in pixels.
_SET = 0.5


@dataclass(frozen=True, slots=True)
class Holding:
    """The volume inside a traced profile, in unit³, and three reasons why it may be another.

    ``scale``: both ends of the length that gives a picture's scale are set to half a pixel,
    which changes the volume by three times their part of it. ``curve``: the area times the root
    mean square deviation. ``sides``: half the difference of what the left and the right side
    would hold. ``total`` is the root of the sum of their squares.
    """

    volume: float
    scale: float
    curve: float
    sides: float

    @property
    def total(self) -> float:
        """All three together, in unit³."""
        return sqrt(self.scale**2 + self.curve**2 + self.sides**2)


def holding(taken: Taken, reading: Reading, options: Options) -> Holding | None:
    """Return what a traced vessel holds; None for a ring, which holds nothing."""
    if taken.trace.profile.closed:
        return None
    surface = RevolutionSurface(taken.trace.profile)
    whole = abs(volume(surface))
    scale = 0.0
    if taken.data is not None and taken.frame is not None:
        length = _measured(options)
        if length > 0.0:
            scale = 3.0 * sqrt(2.0) * _SET * taken.frame.scale / length * whole
    sides = 0.0
    if taken.left_right is not None and reading.right is not None and reading.left is not None:
        right, left = _frusta(reading.right.points), _frusta(reading.left.points)
        sides = abs(right - left) / 2.0
    return Holding(whole, scale, area(surface) * taken.trace.rms_deviation, sides)


def _measured(options: Options) -> float:
    """Return the length, in the unit, by which a picture's scale was given; 0 where it was not."""
    if options.scale_bar is not None:
        return options.scale_bar.length
    return 0.0 if options.height is None else options.height


def _frusta(points: Floats) -> float:
    """Return the volume of the cone frusta that a line through (r, h) points sweeps."""
    (r0, r1), rise = (points[:-1, 0], points[1:, 0]), np.diff(points[:, 1])
    return abs(float((pi / 3.0 * rise * (r0 * r0 + r0 * r1 + r1 * r1)).sum()))
