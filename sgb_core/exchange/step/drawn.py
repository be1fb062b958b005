"""The parts of a STEP file that the drawn profile gives: a surface or filled, all of it exact."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.bodies.cross_section import cross_section
from sgb_core.bodies.meridian import SolidError
from sgb_core.bodies.solid import BodyKind
from sgb_core.curves.crossings import axis_crossings, self_intersections
from sgb_core.curves.profile import GAP, JointRule, Profile
from sgb_core.curves.roots import evaluate, real_roots
from sgb_core.curves.subdivision import de_casteljau
from sgb_core.document.model import Document
from sgb_core.exchange.errors import ExportError
from sgb_core.exchange.step.curves import bezier
from sgb_core.exchange.step.parts import StepPart
from sgb_core.findings.exports import NoExport, NoStep

# A quartic whose points lie within this part of the size of each other is a point; radii below
# it lie on the axis.
_POINT = 1e-9


def drawn_parts(document: Document) -> tuple[StepPart, ...]:
    """Return the parts of a document's surface; several only where the profile touches the axis.

    A curve is cut where it touches the axis. Kind "filled" is closed to the axis by level lines.
    Raises ExportError for a profile that crosses the axis or itself or has gaps, and for one that
    is a point or lies on the axis.
    """
    profile = _without_points(document.profile)
    _check(profile)
    filled = document.solid.kind is BodyKind.FILLED
    if filled:
        try:
            cross_section(document.surface, document.solid)
        except SolidError as error:
            raise ExportError(error.finding) from error
    near = _POINT * profile.size
    curves = [part for quartic in profile.quartics for part in _cut_on_axis(quartic, near)]
    runs = _runs(curves, profile.closed)
    if not runs:
        raise ExportError(NoExport.NO_AREA)
    if filled and not profile.closed:
        runs[0] = [*_level(runs[0][0][0], to_axis=False), *runs[0]]
        runs[-1] = [*runs[-1], *_level(runs[-1][-1][-1], to_axis=True)]
    whole = filled or document.surface.is_full_turn
    return tuple(
        StepPart((tuple(map(bezier, run)),), whole and _is_closed(run, profile.closed))
        for run in runs
    )


def _without_points(profile: Profile) -> Profile:
    size = profile.size
    kept = [
        segment
        for segment, quartic in zip(profile.segments, profile.quartics, strict=True)
        if np.ptp(quartic, axis=0).max() > _POINT * size
    ]
    if not kept:
        raise ExportError(NoExport.POINT)
    count = len(kept) - (0 if profile.closed else 1)
    return Profile(tuple(kept), (JointRule.FREE,) * count, profile.closed)


def _check(profile: Profile) -> None:
    if axis_crossings(profile):
        raise ExportError(NoStep.CROSSES_AXIS)
    if not all(crossing.touches for crossing in self_intersections(profile)):
        raise ExportError(NoStep.CROSSES_ITSELF)
    if max(profile.gaps, default=0.0) > GAP * profile.size:
        raise ExportError(NoStep.GAPS)


def _cut_on_axis(quartic: Floats, near: float) -> list[Floats]:
    """Return a curve on one side of the axis as those between the places where it touches it."""
    left = quartic.copy()
    left[np.abs(left[:, 0]) <= near, 0] = 0.0
    radii, pieces, from_s = left[:, 0].tolist(), [], 0.0
    for s in real_roots(np.diff(left[:, 0]).tolist()):
        if _POINT < s < 1.0 - _POINT and abs(evaluate(radii, s)) <= near and any(radii):
            first, left = de_casteljau(left, (s - from_s) / (1.0 - from_s))
            first[-1, 0] = left[0, 0] = 0.0
            pieces.append(first)
            from_s = s
    return [*pieces, left]


def _runs(curves: Sequence[Floats], closed: bool) -> list[list[Floats]]:
    """Return the curves between places on the axis; what lies on it sweeps nothing."""
    runs: list[list[Floats]] = [[]]
    for curve in curves:
        if runs[-1] and curve[0, 0] == 0.0:
            runs.append([])
        if curve[:, 0].any():
            runs[-1].append(curve)
        elif runs[-1]:
            runs.append([])
    if closed and len(runs) > 1 and runs[0] and runs[0][0][0, 0] != 0.0:
        # A ring that reaches the axis is cut there, not where it happens to begin.
        runs[0] = [*runs.pop(), *runs[0]]
    return [run for run in runs if run]


def _is_closed(run: Sequence[Floats], ring: bool) -> bool:
    first, last = run[0][0], run[-1][-1]
    return bool(first[0] == 0.0 == last[0]) or (ring and bool(first[0] != 0.0))


def _level(end: Floats, to_axis: bool) -> list[Floats]:
    """Return the level line between an end off the axis and the axis."""
    if end[0] == 0.0:
        return []
    line = np.array([end, (0.0, end[1])])
    return [line if to_axis else line[::-1]]
