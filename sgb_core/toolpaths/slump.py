"""Which parts of a profile a printer can build: what a path would meet, seen while sculpting.

Only the surface is asked, no path is made: from turn to turn a wall moves sideways by the layer
times |n_h| / √(1 − n_h²), n_h the upward part of the unit normal; without laws that is |dr/dh|.
"""

from __future__ import annotations

from enum import IntEnum

import numpy as np

from sgb_core.arrays import Floats, Ints
from sgb_core.bodies.solid import BodyKind
from sgb_core.curves.nodes import on_nodes
from sgb_core.document.manufacture import Stage
from sgb_core.document.model import Document
from sgb_core.surfaces.normals import radius_signs, surface_normals, tangents_at
from sgb_core.toolpaths.checks import NOTHING_BELOW
from sgb_core.toolpaths.drawn import refuse_open
from sgb_core.toolpaths.printer import BedShape, Printer
from sgb_core.values import dataclass

# Places of a segment, and angles of a turn where laws make the sections differ.
NODES = np.linspace(0.0, 1.0, 33)
_ANGLES = 48
# A place that rises less than this part of its way is level; what is level carries no bead.
_LEVEL = 1e-9


class Build(IntEnum):
    """What a printer makes of a place of the wall."""

    FLOOR = 0
    HOLDS = 1
    LEANS = 2
    FAILS = 3


@dataclass(frozen=True, slots=True, eq=False)
class Slump:
    """The profile as a printer meets it, at :data:`NODES` of each of its n segments.

    ``places`` (n, k, 2) are (r, h) in the document's unit. ``lean`` (n, k) is how many beads a
    turn lies sideways of the one below, infinite where there is none below or the printer does
    not reach. ``build`` (n, k) are numbers of :class:`Build`. ``layer`` and ``bead`` are in mm.
    """

    printer: Printer
    layer: float
    bead: float
    places: Floats
    lean: Floats
    build: Ints

    @property
    def worst(self) -> tuple[int, int] | None:
        """The place (segment, node) that leans most; None where all holds."""
        if (self.build < Build.LEANS).all():
            return None
        wall = np.where(self.build == Build.FLOOR, 0.0, self.lean)
        segment, node = np.unravel_index(int(wall.argmax()), wall.shape)
        return int(segment), int(node)


def slump(document: Document, printer: Printer, layer: float | None = None) -> Slump:
    """Return which parts of a document's wall a printer can build, printed wet, a bead wide.

    ``layer`` is in mm, by default the printer's usual one; a vessel's wall is divided into as few
    beads as the printer allows. Raises ToolpathError for a part turn, a ring, or a gap.
    """
    profile = document.profile
    refuse_open(document)
    layer = printer.layer.usual if layer is None else layer
    scale = document.unit.millimetres * document.manufacture.shrinkage.factor(Stage.WET)
    bead = _bead(document, printer, scale)
    places = on_nodes(profile.quartics, NODES)
    up = -1.0 if places[-1, -1, 1] < places[0, 0, 1] else 1.0
    slope, rises = _slopes(document, up)
    with np.errstate(divide="ignore"):
        lean = np.where(rises > _LEVEL, layer * slope / np.maximum(rises, _LEVEL) / bead, np.inf)
    heights = scale * (places[..., 1] - float(places[..., 1].min()))
    build = np.full(lean.shape, int(Build.HOLDS))
    build[lean > printer.largest_lean] = Build.LEANS
    build[lean >= NOTHING_BELOW] = Build.FAILS
    base = 0.0 if document.solid.kind is BodyKind.SURFACE else scale * document.solid.base
    # What lies on the bed, or is the floor that spirals fill, is no wall.
    build[(heights <= max(layer, base)) & (lean >= NOTHING_BELOW)] = Build.FLOOR
    beyond = _beyond(printer, scale * np.abs(places[..., 0]) + bead / 2.0, heights)
    lean[beyond], build[beyond] = np.inf, Build.FAILS
    return Slump(printer, layer, bead, places, lean, build)


def _bead(document: Document, printer: Printer, scale: float) -> float:
    if document.solid.kind is not BodyKind.VESSEL:
        return printer.bead.usual
    wall = scale * document.solid.wall
    return float(wall / np.ceil(wall / printer.bead.most))


def _slopes(document: Document, up: float) -> tuple[Floats, Floats]:
    """Return how far sideways and how far upwards the wall goes on its way, (n, k) each.

    Under laws those at the angle at which it leans most.
    """
    profile, surface = document.profile, document.surface
    tangents = up * tangents_at(profile.quartics, NODES, profile.size)
    rises = tangents[..., 1]
    if not document.variation:
        return np.abs(tangents[..., 0]), rises
    # Of a whole turn of sections at once: while a slider moves this is done for every picture.
    sections = surface.sections(surface.sweep * np.arange(_ANGLES) / _ANGLES)
    points, tangent = sections.on(NODES), sections.tangents_on(NODES, profile.size)
    change = sections.changes_on(NODES)
    slip = change[..., 0] * tangent[..., 1] - change[..., 1] * tangent[..., 0]
    signs = radius_signs(points[..., 0], profile.size)
    normals = surface_normals(tangent, slip, points[..., 0], signs, profile.size)
    if surface.twisting is not None:
        normals = surface.twisting.normals(normals, points)
    level = np.abs(normals[..., 2]).max(axis=0)
    return level, np.where(rises > _LEVEL, np.sqrt(np.clip(1.0 - level**2, 0.0, None)), rises)


def _beyond(printer: Printer, reach: Floats, heights: Floats) -> np.ndarray:
    """Return where a wall reaching so far (mm) from the middle of the bed is out of reach."""
    bed = printer.bed
    across = bed.width if bed.shape is BedShape.CIRCLE else min(bed.width, bed.depth)
    return np.asarray((2.0 * reach > across) | (heights > bed.height))
