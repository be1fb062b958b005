"""The fairest curves of other kinds between the same joints: what shape parameters buy.

A plain cubic has no freedom on its control points: to become fair it has to move its inner ones.
Here cubics and quartic Bézier curves may slide theirs along the tangents, with the ends of all
segments, the joints' rules and locks kept, beside the SG-Bézier curve by its shape alone and with
its inner points slid as well. All have the least ∫ κ² dl.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import replace

import numpy as np

from sgb_core.arrays import Floats, frozen
from sgb_core.curves import basis
from sgb_core.curves.profile import Profile
from sgb_core.design.comparison import MEASURED, Compared, Kind, farthest
from sgb_core.design.demands.chain import Chain
from sgb_core.design.demands.kept import Kept
from sgb_core.design.demands.unknowns import fraction_unknowns, with_inner_points
from sgb_core.design.fairing.coupled import solve_together
from sgb_core.design.fairing.energy import Energy
from sgb_core.design.fairing.fair import fair
from sgb_core.design.fairing.findings import Freedom, Keep, LocksExcludeError
from sgb_core.design.fairing.measure import segment_energies
from sgb_core.design.fairing.problem import FairProblem
from sgb_core.design.fairing.task import Task
from sgb_core.surfaces.revolution import RevolutionSurface

# Leg fractions of a plain cubic, and the wider ones with which two moving inner points give every
# quartic: its Q2 lies on the line through P1 and P2, and may do so beyond them.
_CUBIC = (0.75, 0.5, 0.75)
_LEAST, _MOST = (0.02, -4.0, 0.02), (2.0, 5.0, 2.0)
_KEEP = (Keep.TANGENTS,)


def best_curves(
    section: Profile, locks: Sequence[Kept] = (), fixed: Collection[tuple[int, int]] = ()
) -> tuple[Compared, ...]:
    """Return the fairest SG-Bézier, plain cubic and quartic curves between a section's joints.

    First the SG-Bézier curve by its shape parameters alone, no point moved, then with P1 and P2
    of each segment slid along their legs, as the cubics and the quartics have them. ``locks`` are
    told in the size of the section, ``fixed`` points (segment, point) stay. A kind that cannot keep
    all says what is in the way and has the curve of the section's own points.
    """
    surface, found = RevolutionSurface(section), []
    best = Chain.of(section)
    for kind, freedom in ((Kind.FAIREST, Freedom.SHAPE), (Kind.FREED, Freedom.POINTS)):
        try:
            faired = fair(surface, free=freedom, keep=_KEEP, locks=locks, fixed=fixed)
        except LocksExcludeError as error:
            found.append(replace(_compared(section, kind, best), energy=None, missed=error.finding))
            continue
        best = best.told(faired.profile)
        found.append(_compared(section, kind, best))
    task = Task.of(
        section, Energy.BENDING, Freedom.POINTS, range(len(section)), _KEEP, (), locks, fixed
    )
    others = [best]
    for kind in (Kind.BEST_CUBIC, Kind.BEST_QUARTIC):
        curve, chain = _freed(section, task, kind, others)
        found.append(curve)
        others.append(chain)
    return tuple(found)


def _freed(
    section: Profile, task: Task, kind: Kind, others: Sequence[Chain]
) -> tuple[Compared, Chain]:
    """Return the fairest curve of a kind, sought from the section's points and from others."""
    start, present = task.start, task.start.fractions
    if kind is Kind.BEST_CUBIC:
        low = high = np.tile(_CUBIC, (len(section), 1))
    else:
        low, high = np.minimum(present, _LEAST), np.maximum(present, _MOST)
    blocks = start.blocks.copy()
    blocks[:, :3] = np.clip(present, low, high)
    own = start.with_blocks(blocks)
    # Straight segments bend nowhere, and stay.
    moving = np.flatnonzero(task.limits.moving).tolist()
    if not moving:
        return _compared(section, kind, own), own
    unknowns = with_inner_points(
        fraction_unknowns(own, low, high), moving, along_tangents=True, fixed=task.fixed
    )
    problem = FairProblem(
        unknowns,
        Energy.BENDING,
        moving,
        task.equations,
        task.measures,
        points_move=True,
        exact=False,
    )
    starts = [own, *(_within(each, low, high) for each in others)]
    found = solve_together(problem, [unknowns.nearest(each) for each in starts], scatter=False)
    if not found.met:
        missed = task.obstacle(problem, found.residual)
        return replace(_compared(section, kind, own), energy=None, missed=missed), own
    chain = unknowns.chain(found.y)
    return _compared(section, kind, chain), chain


def _within(chain: Chain, low: Floats, high: Floats) -> Chain:
    """Return fractions within bounds, with P1 and P2 that leave Q1 and Q3 where they are."""
    blocks, points = chain.blocks.copy(), chain.points.copy()
    blocks[:, :3] = np.clip(chain.fractions, low, high)
    for end, leg, which in ((0, 1, 0), (3, 2, 2)):
        part = chain.fractions[:, which] / blocks[:, which]
        points[:, leg] = points[:, end] + part[:, None] * (points[:, leg] - points[:, end])
    blocks[:, 3:] = points.reshape(-1, 8)
    return chain.with_blocks(blocks)


def _compared(section: Profile, kind: Kind, chain: Chain) -> Compared:
    rows = basis.bernstein(4, np.linspace(0.0, 1.0, MEASURED))
    curves = _drawn(np.einsum("sq,nqk->nsk", rows, chain.quartics), chain)
    energy = float(segment_energies(Energy.BENDING, chain.quartics).sum()) / chain.size
    polygons = chain.quartics if kind is Kind.BEST_QUARTIC else chain.points
    return Compared(
        kind,
        frozen(curves),
        energy if np.isfinite(energy) else None,
        farthest(section, list(curves)),
        polygons=frozen(_drawn(polygons, chain)),
    )


def _drawn(points: Floats, chain: Chain) -> Floats:
    return np.asarray(points * chain.size + (0.0, chain.middle))
