"""What a path cannot be, and what is risky about it."""

from __future__ import annotations

import numpy as np

from sgb_core.bodies.solid import BodyKind, Rim
from sgb_core.document.appearance.relief import relief_of
from sgb_core.document.model import Document
from sgb_core.findings.finding import Finding
from sgb_core.findings.toolpaths import BeyondBed, Floating, HighLayer, Lean, PathNote
from sgb_core.toolpaths.errors import ToolpathError
from sgb_core.toolpaths.printer import BedShape
from sgb_core.toolpaths.strand import Part
from sgb_core.toolpaths.toolpath import Toolpath

# From this part of a bead sideways on, a turn rests on too little of the one below to be held.
NOTHING_BELOW = 1.0


def refuse_beyond_bed(path: Toolpath) -> None:
    """Raise ToolpathError where the path and half its bead reach beyond the printer's room."""
    bed = path.plan.printer.bed
    low, high = path.bounds
    half = path.plan.bead / 2.0
    # The axis stands over the middle, so the farther side counts.
    across = 2.0 * (np.maximum(-low[:2], high[:2]) + half)
    needed = (float(across[0]), float(across[1]), float(high[2]))
    beyond = needed[2] > bed.height or needed[0] > bed.width or needed[1] > bed.depth
    if bed.shape is BedShape.CIRCLE:
        widest = 2.0 * (float(np.hypot(path.points[:, 0], path.points[:, 1]).max()) + half)
        beyond = needed[2] > bed.height or widest > bed.width
    if beyond:
        room = (bed.width, bed.depth, bed.height)
        raise ToolpathError(BeyondBed(needed, room, path.plan.printer.title))


def leans(path: Toolpath) -> list[Lean]:
    """Return the stretches of turns that lean out or in more than the printer bridges."""
    plan = path.plan
    if plan.bead == 0.0:
        return []
    wall = path.parts == Part.WALL
    turns, heights = path.turns[wall] // plan.walls, path.points[wall, 2]
    most = np.zeros(int(turns.max()) + 1)
    np.maximum.at(most, turns, path.steps[wall] / plan.bead)
    found = []
    for limit, stops in ((NOTHING_BELOW, True), (plan.printer.largest_lean, False)):
        bad = most >= limit
        if not stops:
            bad &= most < NOTHING_BELOW
        edges = np.flatnonzero(np.diff(np.concatenate([[0], bad.astype(np.int8), [0]])))
        for first, after in zip(edges[::2].tolist(), edges[1::2].tolist(), strict=True):
            own = heights[(turns >= first) & (turns < after)]
            beads = float(most[first:after].max())
            found.append(Lean(first + 1, after, float(own.min()), float(own.max()), beads, stops))
    return sorted(found, key=lambda lean: lean.first)


def notes(document: Document, path: Toolpath, closed_top: bool, has_floor: bool) -> list[Finding]:
    """Return what is printed otherwise than drawn, and what is risky but for leaning walls."""
    plan, solid = path.plan, document.solid
    found: list[Finding] = []
    if 0.0 < plan.bead < plan.layer:
        found.append(HighLayer(plan.layer, plan.bead))
    if solid.kind is BodyKind.VESSEL and solid.foot_ring > 0.0:
        found.append(PathNote.FOOT_RING)
    if solid.kind is BodyKind.VESSEL and solid.rim is Rim.ROUND:
        found.append(PathNote.ROUND_RIM)
    if not has_floor and plan.bead and solid.kind is not BodyKind.SURFACE:
        found.append(PathNote.OPEN_BOTTOM)
    if closed_top:
        found.append(PathNote.CLOSED_TOP)
    relief = relief_of(document.appearance) is not None
    if relief:
        found.append(PathNote.RELIEF)
    if document.cut_outs:
        found.append(PathNote.HOLES)
    if plan.wanted.arcs and (document.variation or relief):
        found.append(PathNote.NO_ARCS)
    lowest = float(path.points[path.parts == Part.FLOOR, 2].min(initial=np.inf))
    if has_floor and lowest > 1.5 * plan.layer:
        found.append(Floating(lowest))
    return found
