"""What a source gives: one or two sides of a profile, as pieces or as points."""

from __future__ import annotations

from math import cos, sin

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.findings.finding import Finding
from sgb_core.sources.pieces import Path
from sgb_core.values import dataclass


@dataclass(frozen=True, slots=True, eq=False)
class Half:
    """One side of a profile from foot to rim, in the unit asked for.

    ``points`` (N, 2) are (r, h), samples of ``path`` where the source is a drawing; ``corners``
    number those that are known to be sharp.
    """

    points: Floats
    path: Path | None = None
    closed: bool = False
    corners: tuple[int, ...] = ()


@dataclass(frozen=True, slots=True)
class Frame:
    """How a profile lies in its source, in whose coordinates y runs upwards.

    (r, h) = (0, 0) is at ``origin``; the axis leans by ``turn`` radians against the clock, and
    one of the source's own lengths is ``scale`` of the unit.
    """

    origin: tuple[float, float]
    scale: float = 1.0
    turn: float = 0.0

    def placed(self, points: Floats) -> Floats:
        """Return where (r, h) pairs of shape (..., 2) lie in the source."""
        return np.asarray(points @ self._turn.T / self.scale + np.array(self.origin))

    def taken(self, places: Floats) -> Floats:
        """Return the (r, h) of places in the source, both of shape (..., 2)."""
        return np.asarray((places - np.array(self.origin)) @ self._turn * self.scale)

    @property
    def _turn(self) -> Floats:
        c, s = cos(self.turn), sin(self.turn)
        return np.array([[c, -s], [s, c]])


@dataclass(frozen=True, slots=True)
class Reading:
    """What a source holds: the sides seen, the axis used, and what is to be said.

    ``axis`` is the abscissa of an upright axis, or a point and a direction (6 numbers).
    ``tolerance`` is the source's own default, None for 1e-3 of the size. ``frame`` says how the
    sides lie in the source, None where that is no plane; a left side is mirrored.
    """

    right: Half | None
    left: Half | None = None
    axis: tuple[float, ...] = (0.0,)
    tolerance: float | None = None
    notes: tuple[Finding, ...] = ()
    frame: Frame | None = None
