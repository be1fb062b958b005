"""The parts of a STEP file that a vessel's section gives: drawn curves exact, the others fitted."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
import shapely

from sgb_core.arrays import Floats
from sgb_core.bodies.cross_section import CrossSection
from sgb_core.bodies.outline import Piece, Ring, Role, Trace, line
from sgb_core.bodies.region import Outline, parameters
from sgb_core.exchange.errors import ExportError
from sgb_core.exchange.step.curves import Curve, curve_of
from sgb_core.exchange.step.parts import Run, StepPart
from sgb_core.findings.bodies import TouchingCircle
from sgb_core.findings.exports import NoStep
from sgb_core.surfaces.section import AXIS

# Pieces that reach no farther than this part of the size are corners.
_POINT = 1e-9
# So far around its end, in its own parameter, a curve is followed to close a gap.
_REACH = 0.1


def section_parts(section: CrossSection, tolerance: float) -> tuple[StepPart, ...]:
    """Return the solids of a section, offset curves within ``tolerance``.

    A part is one connected solid: its outer run and the runs about its voids. Parts that touch
    only on the axis are several. Raises ExportError where the section touches itself along a
    circle, for a curve that no fit follows, and where nothing is left.
    """
    if any(isinstance(finding, TouchingCircle) for finding in section.findings):
        raise ExportError(NoStep.TOUCHES)
    parts = [part for outline in section.outlines for part in _outline(section, outline, tolerance)]
    if not section.meridian.mirrored:
        return tuple(parts)
    return tuple(
        StepPart(tuple(tuple(c.mirrored() for c in run) for run in part.runs), True)
        for part in parts
    )


def _outline(section: CrossSection, outline: Outline, tolerance: float) -> list[StepPart]:
    size = section.meridian.size
    found = [run for ring in outline.rings for run in _runs(ring, size)]
    regions = [shapely.Polygon(_samples(section, run)) for run in found]
    ways = [_area(_samples(section, run)) for run in found]
    curves = [_curves(run, size, tolerance) for run in found]
    outer = [k for k, way in enumerate(ways) if way > 0.0]
    inner: dict[int, list[Run]] = {k: [] for k in outer}
    for k, way in enumerate(ways):
        if way > 0.0:
            continue
        # Runs of one outline that touch on the axis bound solids apart; each void lies in one.
        middle = regions[k].representative_point()
        around = min(outer, key=lambda m: (not regions[m].contains(middle), regions[m].area))
        inner[around].append(curves[k])
    return [StepPart((curves[k], *inner[k]), True) for k in outer]


def _runs(ring: Ring, size: float) -> list[list[Piece]]:
    """Return a ring as the runs of its pieces between places on the axis."""
    near = AXIS * size
    kept = [piece for piece in ring if _extent(piece) > _POINT * size]
    flat = [bool((np.abs(piece.ends[:, 0]) <= near).all()) and _straight(piece) for piece in kept]
    start = next((k for k, piece in enumerate(kept) if abs(piece.ends[0, 0]) <= near), None)
    if start is None:
        return [kept] if kept else []
    order = [*range(start, len(kept)), *range(start)]
    runs: list[list[Piece]] = [[]]
    for k in order:
        if flat[k]:
            continue
        if abs(kept[k].ends[0, 0]) <= near and runs[-1]:
            runs.append([])
        runs[-1].append(kept[k])
    return [run for run in runs if run]


def _straight(piece: Piece) -> bool:
    """Whether a piece between places on the axis lies on it all along."""
    u = np.linspace(piece.start, piece.end, 9)
    points = piece.points(u)
    return bool(np.abs(points[:, 0]).max() <= 1e-6 * float(np.ptp(points[:, 1])))


def _extent(piece: Piece) -> float:
    return float(np.ptp(piece.points(np.linspace(piece.start, piece.end, 5)), axis=0).max())


def _samples(section: CrossSection, run: Sequence[Piece]) -> Floats:
    return np.concatenate([piece.points(parameters(piece, section.grids)) for piece in run])


def _area(points: Floats) -> float:
    """Return twice the signed area of a closed polyline."""
    r, h = points.T
    return float(r @ np.roll(h, -1) - h @ np.roll(r, -1))


def _closed_up(run: list[Piece], size: float) -> list[Piece]:
    """Return a run whose pieces meet: where corners are lost in a fold, by short lines.

    A moved curve first begins where it comes nearest to what lies before it.
    """
    on_axis = abs(run[0].ends[0, 0]) <= AXIS * size
    result: list[Piece] = [run[0]]
    for piece in [*run[1:], *([] if on_axis else run[:1])]:
        end = result[-1].ends[1]
        if piece is run[0]:
            begin = result[0].ends[0]
        else:
            if np.hypot(*(piece.ends[0] - end)) > _POINT * size and isinstance(piece, Trace):
                piece = _begun_near(piece, end)
            begin = piece.ends[0]
        if np.hypot(*(begin - end)) > _POINT * size:
            result.append(line(Role.WALL, end, begin))
        if piece is not run[0]:
            result.append(piece)
    return result


def _begun_near(piece: Trace, end: Floats) -> Trace:
    way = 1.0 if piece.end >= piece.start else -1.0
    u = np.clip(piece.start + way * np.linspace(-_REACH, _REACH, 513), 0.0, 1.0)
    u = u[(piece.end - u) * way > 0.0]
    points = piece.points(u)
    away = np.hypot(*(points - end).T)
    return replace(piece, start=float(u[np.argmin(np.where(points[:, 0] >= 0.0, away, np.inf))]))


def _curves(run: list[Piece], size: float, tolerance: float) -> Run:
    """Return a run's curves with ends that meet to the last bit, those on the axis on it."""
    curves = [curve_of(piece, tolerance) for piece in _closed_up(run, size)]
    if len(curves) == 1 and abs(curves[0].ends[0, 0]) > AXIS * size:
        return (curves[0].between(curves[0].ends[0], curves[0].ends[0]),)
    firsts = [curve.ends[0] for curve in curves]
    on_axis = abs(firsts[0][0]) <= AXIS * size
    lasts = [*firsts[1:], curves[-1].ends[1] if on_axis else firsts[0]]
    if on_axis:
        firsts[0], lasts[-1] = np.array([0.0, firsts[0][1]]), np.array([0.0, lasts[-1][1]])
    met: list[Curve] = []
    for curve, first, last in zip(curves, firsts, lasts, strict=True):
        met.append(curve.between(first, last))
    return tuple(met)
