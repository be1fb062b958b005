"""The columns of a mesh: at which angles the section is placed, and which of them coincide."""

from __future__ import annotations

from dataclasses import replace
from math import pi
from typing import Literal

import numpy as np

from sgb_core.arrays import Floats, Ints, distinct
from sgb_core.findings.errors import FindingError
from sgb_core.findings.surfaces import TooFewAround
from sgb_core.surfaces.relief import NEAR, refined
from sgb_core.surfaces.revolution import RevolutionSurface
from sgb_core.surfaces.transfinite import turn_angle, turn_parameter
from sgb_core.values import dataclass

Spacing = Literal["angle", "rational"]
# Angles nearer to each other than this are one.
_SAME = 1e-9


@dataclass(frozen=True, slots=True, eq=False)
class Turn:
    """Render columns: C angles from the start angle, in radians.

    ``ids`` (C,) number the welded columns: the seam of a full turn has two render columns on one,
    and so has a meridian on which a law leaves a crease. ``sides`` (C,) say from which
    side (+1 after, −1 before) one-sided derivatives are taken; ``linked`` (C − 1,) where a step
    leads from a column to the next. ``fraction`` (C,) is the share of the sweep, 0 to 1; ``step``
    is the usual angle between columns, others between them left out.
    """

    angles: Floats
    ids: Ints
    sides: Floats
    linked: np.ndarray[tuple[int], np.dtype[np.bool_]]
    fraction: Floats
    step: float

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


def creases(surface: RevolutionSurface) -> Floats:
    """Return the angles inside the sweep at which laws leave creases, increasing."""
    found = distinct([angle for law in surface.laws for angle in law.creases])
    found = found[(found > _SAME) & (found < surface.sweep - _SAME)]
    return found[np.append(True, np.diff(found) > _SAME)] if len(found) else found


def column_angles(surface: RevolutionSurface, count: int, spacing: Spacing = "angle") -> Floats:
    """Return the angles of ``count`` intervals, (count + 1,): equal ones, creases among them.

    The nearest column to a crease is moved onto it, as long as one is free: corners stay sharp.
    """
    shares = np.linspace(0.0, 1.0, count + 1)
    if spacing == "rational":
        angles = turn_angle(turn_parameter(surface.sweep) * shares)
        angles[-1] = surface.sweep
    else:
        angles = surface.sweep * shares
    return _onto(angles, creases(surface), 1)


def grid_columns(surface: RevolutionSurface, count: int) -> tuple[Floats, Floats]:
    """Return angles from the start and sides of a grid of ``count`` intervals, each (count + 1,).

    For what keeps its topology whatever the laws: two columns stand on every crease, one for
    each side of it, as far as there are enough.
    """
    angles = _onto(surface.sweep * np.linspace(0.0, 1.0, count + 1), creases(surface), 2)
    sides = np.ones(count + 1)
    sides[:-1][np.diff(angles) == 0.0] = -1.0
    sides[-1] = -1.0
    return angles, sides


def _onto(angles: Floats, sharp: Floats, each: int) -> Floats:
    """Return increasing angles with the ``each`` nearest ones of every crease moved onto it."""
    last = len(angles) - 1
    if not len(sharp) or last - 1 < each * len(sharp):
        return angles
    after = np.searchsorted(angles, sharp)
    nearest = np.where(sharp - angles[after - 1] < angles[after] - sharp, after - 1, after)
    first = nearest if each == 1 else after - 1
    taken = 0
    # Of creases beside one column the first has it, the others those after it.
    for k, place in enumerate(first.tolist()):
        left = each * (len(sharp) - k)
        place = min(max(place, taken + 1), last - left)
        angles[place : place + each] = sharp[k]
        taken = place + each - 1
    return np.sort(angles)


def turn_of(
    surface: RevolutionSurface,
    count: int,
    spacing: Spacing = "angle",
    more: Floats | None = None,
) -> Turn:
    """Return ``count`` intervals over the sweep, at equal angles but for creases.

    ``more`` are shares of the sweep at which further columns stand.

    With spacing "rational" they are equal steps of the paper's parameter t, (24), over one half
    turn and back over the other: other points of the same surface. Raises FindingError where a
    step would reach half a turn (a full turn needs 3), which would leave flat triangles.
    """
    if count * pi <= surface.sweep * (1.0 + 1e-12):
        needed = int(surface.sweep / pi + 1e-9) + 1
        raise FindingError(TooFewAround(count, needed))
    angles = column_angles(surface, count, spacing)
    if more is not None:
        angles = refined(angles, surface.sweep * more, NEAR * surface.sweep)
    doubled = np.zeros(len(angles), dtype=bool)
    doubled[1:-1] = np.isin(angles[1:-1], creases(surface))
    repeats = np.where(doubled, 2, 1)
    ids = np.repeat(np.arange(len(angles)), repeats)
    angles = np.repeat(angles, repeats)
    linked = np.diff(ids) > 0
    sides = np.ones(len(angles))
    sides[:-1][~linked] = -1.0
    sides[-1] = -1.0
    if surface.is_full_turn:
        ids[-1] = 0
    return Turn(angles, ids, sides, linked, angles / surface.sweep, surface.sweep / count)
