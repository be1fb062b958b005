"""What a source gives: one or two sides of a profile, as pieces or as points."""

from __future__ import annotations

from dataclasses import dataclass

from sgb_core.arrays import Floats
from sgb_core.findings.finding import Finding
from sgb_core.sources.pieces import Path


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
class Reading:
    """What a source holds: the sides seen, the axis used, and what is to be said.

    ``axis`` is the abscissa of an upright axis, or a point and a direction (6 numbers).
    ``tolerance`` is the source's own default, None for 1e-3 of the size.
    """

    right: Half | None
    left: Half | None = None
    axis: tuple[float, ...] = (0.0,)
    tolerance: float | None = None
    notes: tuple[Finding, ...] = ()
