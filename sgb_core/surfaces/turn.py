"""The columns of a mesh: at which angles the section is placed, and which of them coincide."""

from __future__ import annotations

from dataclasses import dataclass, replace
from math import pi
from typing import Literal

import numpy as np

from sgb_core.arrays import Floats, Ints
from sgb_core.findings.errors import FindingError
from sgb_core.findings.surfaces import TooFewAround
from sgb_core.surfaces.revolution import RevolutionSurface
from sgb_core.surfaces.transfinite import turn_angle, turn_parameter

Spacing = Literal["angle", "rational"]


@dataclass(frozen=True, slots=True, eq=False)
class Turn:
    """Render columns: C angles from the start angle, in radians.

    ``ids`` (C,) number the welded columns: the seam of a full turn has two render columns on one,
    and so has a meridian on which a law leaves a crease. ``sides`` (C,) say from which
    side (+1 after, −1 before) one-sided derivatives are taken; ``linked`` (C − 1,) where a step
    leads from a column to the next. ``fraction`` (C,) is the share of the sweep, 0 to 1.
    """

    angles: Floats
    ids: Ints
    sides: Floats
    linked: np.ndarray[tuple[int], np.dtype[np.bool_]]
    fraction: Floats

    @property
    def welded_count(self) -> int:
        """The number of different columns."""
        return int(self.ids.max()) + 1

    @property
    def first_of_each(self) -> Ints:
        """The first render column of each welded one."""
        return np.unique(self.ids, return_index=True)[1].astype(np.int64)


def closed_up(surface: RevolutionSurface, widest: float, merge: float) -> RevolutionSurface:
    """Return the surface, turned all round where the gap that it leaves is narrower than ``merge``.

    ``widest`` is its largest distance from the axis. The two sides of such a gap are one to a
    reader that welds by place.
    """
    gap = (2.0 * pi - surface.sweep) * widest
    return replace(surface, sweep=2.0 * pi) if 0.0 < gap < merge else surface


def turn_of(surface: RevolutionSurface, count: int, spacing: Spacing = "angle") -> Turn:
    """Return ``count`` intervals over the sweep, at equal angles.

    With spacing "rational" they are equal steps of the paper's parameter t, (24), over one half
    turn and back over the other: other points of the same surface. Raises FindingError where a
    step would reach half a turn (a full turn needs 3), which would leave flat triangles.
    """
    if count * pi <= surface.sweep * (1.0 + 1e-12):
        needed = int(surface.sweep / pi + 1e-9) + 1
        raise FindingError(TooFewAround(count, needed))
    shares = np.linspace(0.0, 1.0, count + 1)
    if spacing == "rational":
        angles = turn_angle(turn_parameter(surface.sweep) * shares)
        angles[-1] = surface.sweep
    else:
        angles = surface.sweep * shares
    doubled = np.zeros(count + 1, dtype=bool)
    for crease in {angle for law in surface.laws for angle in law.creases}:
        doubled[1:-1] |= np.abs(angles[1:-1] - crease) < 1e-9
    repeats = np.where(doubled, 2, 1)
    ids = np.repeat(np.arange(count + 1), repeats)
    angles = np.repeat(angles, repeats)
    linked = np.diff(ids) > 0
    sides = np.ones(len(angles))
    sides[:-1][~linked] = -1.0
    sides[-1] = -1.0
    if surface.is_full_turn:
        ids[-1] = 0
    return Turn(angles, ids, sides, linked, angles / surface.sweep)
