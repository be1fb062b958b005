"""From a document and a printer to a path."""

from __future__ import annotations

from dataclasses import replace
from math import acos, ceil, pi

import numpy as np

from sgb_core.bodies.solid import BodyKind
from sgb_core.document.model import Document
from sgb_core.findings.toolpaths import TooManyPoints
from sgb_core.interruption import checkpoint
from sgb_core.toolpaths import speeds
from sgb_core.toolpaths.checks import leans, notes, refuse_beyond_bed
from sgb_core.toolpaths.drawn import LOOKS, Drawn, drawn, refuse_falling, refuse_open, scale_of
from sgb_core.toolpaths.errors import ToolpathError
from sgb_core.toolpaths.floor import floor
from sgb_core.toolpaths.helix import TURN, Angles, Climb, WallPath, climb, wall_path
from sgb_core.toolpaths.moved_wall import MovedWall
from sgb_core.toolpaths.printer import Printer
from sgb_core.toolpaths.raised import Raised, raised_of
from sgb_core.toolpaths.settings import Plan, Wanted, plan_of
from sgb_core.toolpaths.strand import Part, Strand, strand
from sgb_core.toolpaths.toolpath import Toolpath, joined
from sgb_core.toolpaths.volumes import printed_volume

MOST_POINTS = 5_000_000
# Points in a turn at least and at most.
_LEAST, _MOST = 64, 8_192
# Places of a segment at which the widest one is looked for.
_PLACES = np.linspace(0.0, 1.0, 65)
# How far outside the body's foot a skirt runs, in mm.
_SKIRT = 5.0
AS_USUAL = Wanted()


def toolpath(document: Document, printer: Printer, wanted: Wanted = AS_USUAL) -> Toolpath:
    """Return the path of a document's wall and floor for a printer.

    Raises ToolpathError, a ValueError, with what cannot be printed and what is allowed.
    """
    plan = plan_of(document, printer, wanted)
    start = plan.layer * plan.floor_layers if plan.bead else 0.0
    angles = _angles(document, plan, start)
    way_up, walls = _climb(document, plan, start, angles)
    if plan.wanted.adaptive or angles.varying:
        angles = _with_end(angles, way_up)
        way_up, walls = _climb(document, plan, start, angles)
    else:
        angles = _with_end(angles, way_up)
    turns = way_up.end / TURN + plan.walls
    points = int(turns * len(angles.of_turn))
    if points > MOST_POINTS:
        raise ToolpathError(TooManyPoints(points, MOST_POINTS))
    hole = 0.0
    if document.solid.kind is BodyKind.VESSEL:
        hole = document.solid.drain_hole * walls[0].wall.scale
    ground = floor(walls[0], plan, angles, hole)
    wall = wall_path(walls, plan, way_up, angles, checkpoint)
    pieces = [*_skirt(plan, [*ground, wall.strand]), *ground]
    # Holes are left out, and a relief shows on both sides.
    plain = not (document.cut_outs or walls[0].wall.raised)
    vessel = document.solid.kind is BodyKind.VESSEL
    volume = (
        document.body().material_volume * walls[0].wall.scale ** 3
        if vessel and plain
        else printed_volume(walls, plan, way_up, angles, ground)
    )
    path = _assembled(plan, pieces, wall, walls[0].wall, volume)
    refuse_beyond_bed(path)
    risks = leans(path)
    stops = [risk for risk in risks if risk.stops]
    if stops and not plan.wanted.anyway:
        raise ToolpathError(max(stops, key=lambda risk: risk.beads))
    closed = way_up.top < walls[0].wall.rim
    return replace(path, findings=(*risks, *notes(document, path, closed, bool(ground))))


def _climb(
    document: Document, plan: Plan, start: float, angles: Angles
) -> tuple[Climb, tuple[MovedWall, ...]]:
    theta = angles.way * angles.of_turn if angles.varying else np.zeros(1)
    surface = drawn(document, theta, plan.wanted.stage, _raised(document, plan))
    refuse_falling(surface, start)
    reach = 2.0 * max(abs(offset) for offset in plan.offsets) + surface.size
    walls = tuple(MovedWall.of(surface, offset, reach) for offset in plan.offsets)
    return climb(walls, plan, start, angles.way), walls


def _raised(document: Document, plan: Plan) -> Raised | None:
    refuse_open(document)
    return raised_of(document, plan.wanted.chord, scale_of(document, plan.wanted.stage))


def _angles(document: Document, plan: Plan, start: float) -> Angles:
    """Return the angles of a turn at which the path has points, for its chord."""
    way = -1.0 if plan.wanted.clockwise else 1.0
    varying = bool(document.variation)
    looks = np.arange(LOOKS) * TURN / LOOKS if varying else np.zeros(1)
    surface = drawn(document, looks, plan.wanted.stage)
    chord = plan.wanted.chord
    widest = float(np.abs(surface.sections.on(_PLACES)[..., 0]).max()) + max(
        -min(plan.offsets), 0.0
    )
    count = pi / acos(max(1.0 - chord / widest, 0.0)) if widest > 0.0 else _LEAST
    if varying:
        count = max(count, _turning(surface, plan, start) / np.sqrt(8.0 * chord))
    number = ceil(min(max(count, _LEAST), _MOST))
    of_turn = np.arange(number) * TURN / number
    raised = _raised(document, plan)
    if varying or raised is not None:
        more = np.array([b for law in document.variation for b in law.breaks])
        if raised is not None:
            more = np.concatenate([more, TURN * raised.columns])
        of_turn = np.unique(np.concatenate([of_turn, np.mod(way * more, TURN)]))
        of_turn = of_turn[np.concatenate([[True], np.diff(of_turn) > 1e-9])]
    return Angles(of_turn, way, varying or raised is not None)


def _turning(surface: Drawn, plan: Plan, start: float) -> float:
    """Return 2π times the root of the largest second derivative of the path by the angle."""
    wall = MovedWall.of(surface, plan.offsets[0], surface.size)
    angles = Angles(np.arange(LOOKS) * TURN / LOOKS, 1.0, True)
    rows, largest = np.arange(LOOKS), 0.0
    for z in np.linspace(start, surface.rim, 17):
        ring = angles.place(angles.of_turn, wall.at(np.full(LOOKS, z), rows))
        second = np.roll(ring, 1, axis=0) - 2.0 * ring + np.roll(ring, -1, axis=0)
        largest = max(largest, float(np.hypot(*second.T).max()) * (LOOKS / TURN) ** 2)
    return float(TURN * np.sqrt(largest))


def _with_end(angles: Angles, way_up: Climb) -> Angles:
    """Return the angles with the one at which the helix reaches the rim."""
    last = way_up.end % TURN
    near = np.abs(angles.of_turn - last)
    if min(near.min(), TURN - last) < 1e-9:
        return angles
    return Angles(np.sort(np.append(angles.of_turn, last)), angles.way, angles.varying)


def _assembled(
    plan: Plan, pieces: list[Strand], wall: WallPath, surface: Drawn, volume: float
) -> Toolpath:
    """Return the pieces and then the wall as one path."""
    floors = max((int(piece.layers.max()) + 1 for piece in pieces), default=0)
    if all(piece.part is Part.SKIRT for piece in pieces):
        floors = 0
    moves = joined([*pieces, replace(wall.strand, layers=wall.strand.layers + floors)])
    count, own = len(moves.points), len(wall.strand.volumes)
    steps, turns = np.zeros(count), np.full(count, -1)
    steps[count - own :], turns[count - own :] = wall.steps[1:], wall.turns[1:]
    return Toolpath(
        plan=plan,
        points=moves.points,
        parts=moves.parts,
        layers=moves.layers,
        volumes=moves.volumes,
        speeds=speeds.speeds(plan.printer, moves),
        steps=steps,
        turns=turns,
        material_volume=volume,
        scale=surface.scale,
        ground=surface.ground,
    )


def _skirt(plan: Plan, body: list[Strand]) -> list[Strand]:
    """Return circles on the bed around the foot, from the outside inwards."""
    if not plan.skirt:
        return []
    points = np.concatenate([piece.points for piece in body])
    low = points[points[:, 2] <= 2.0 * plan.layer + 1e-9]
    radius = float(np.hypot(low[:, 0], low[:, 1]).max()) + _SKIRT + plan.bead
    count = plan.skirt * max(_LEAST, ceil(TURN * radius / 2.0))
    angle = np.linspace(0.0, TURN * plan.skirt, count + 1)
    r = radius + plan.bead * (plan.skirt - angle / TURN)
    ring = np.column_stack([r * np.cos(angle), r * np.sin(angle), np.full(count + 1, plan.layer)])
    area = np.full(count + 1, plan.bead * plan.layer)
    return [strand(Part.SKIRT, ring, area, np.zeros(count + 1, dtype=np.intp))]
