"""What is asked of a path, and what comes of it for a document and a printer."""

from __future__ import annotations

from dataclasses import field
from math import ceil

from sgb_core.bodies.solid import BodyKind, WallSide
from sgb_core.document.manufacture import Stage
from sgb_core.document.model import Document
from sgb_core.fields.kinds import Choice, Flag, Range
from sgb_core.fields.lists import OrNone
from sgb_core.fields.record import Record, check, says
from sgb_core.findings.toolpaths import BeyondPrinter
from sgb_core.toolpaths.errors import ToolpathError
from sgb_core.toolpaths.printer import Limits, Printer
from sgb_core.values import dataclass

MOST_WALLS = 20
MOST_FLOORS = 1_000


@dataclass(frozen=True, slots=True)
class Wanted:
    """What is asked; None leaves the choice to document and printer. Lengths in mm.

    ``chord`` is how far the path may cut a corner. ``adaptive`` lets a turn climb less where the
    wall leans, so that turns stay equally apart along the surface. ``anyway`` prints what leans
    too far. A ``bead`` of 0 is a path on the drawn surface itself that pushes nothing out.
    """

    RECORD = Record("path")

    layer: float | None = field(
        default=None, metadata=says(OrNone(Range(above=0.0, high=200.0)), label="Layer")
    )
    bead: float | None = field(default=None, metadata=says(OrNone(Range(0.0, 200.0)), label="Bead"))
    walls: int = field(
        default=1, metadata=says(Range(1, MOST_WALLS, whole=True), label="Beads in the wall")
    )
    floor_layers: int | None = field(
        default=None,
        metadata=says(OrNone(Range(0, MOST_FLOORS, whole=True)), label="Floor layers"),
    )
    chord: float = field(default=0.02, metadata=says(Range(1e-4, 5.0), label="Chord"))
    adaptive: bool = field(default=False, metadata=says(Flag(), label="Follow the lean"))
    arcs: bool = field(default=False, metadata=says(Flag(), label="Arcs"))
    stage: Stage = field(default=Stage.WET, metadata=says(Choice(Stage), label="Size"))
    skirt: int | None = field(
        default=None, metadata=says(OrNone(Range(0, 50, whole=True)), label="Skirt")
    )
    clockwise: bool = field(default=False, metadata=says(Flag(), label="Clockwise"))
    anyway: bool = field(default=False, metadata=says(Flag(), label="Print what leans too far"))

    def __post_init__(self) -> None:
        check(self)


@dataclass(frozen=True, slots=True)
class Plan:
    """What is printed, lengths in mm.

    ``offsets`` are how far inside the drawn surface each bead of the wall runs, from the outermost
    to the innermost.
    """

    printer: Printer
    wanted: Wanted
    layer: float
    bead: float
    floor_layers: int
    skirt: int
    offsets: tuple[float, ...]

    @property
    def walls(self) -> int:
        """How many beads the wall has."""
        return len(self.offsets)


def fewest_beads(document: Document, printer: Printer, stage: Stage = Stage.WET) -> int:
    """Return into how many beads a printer has to divide a vessel's wall; 1 without one."""
    if document.solid.kind is not BodyKind.VESSEL:
        return 1
    scale = document.unit.millimetres * document.manufacture.shrinkage.factor(stage)
    beads = ceil(document.solid.wall * scale / printer.bead.most - 1e-9)
    return min(max(1, beads), MOST_WALLS)


def plan_of(document: Document, printer: Printer, wanted: Wanted) -> Plan:
    """Return what is printed; raises ToolpathError for a layer or bead beyond the printer."""
    solid = document.solid
    scale = document.unit.millimetres * document.manufacture.shrinkage.factor(wanted.stage)
    layer = printer.layer.usual if wanted.layer is None else wanted.layer
    _refuse(printer, "layer", layer, printer.layer, None)
    vessel = solid.kind is BodyKind.VESSEL
    bead = wanted.bead
    if bead is None:
        bead = solid.wall * scale / wanted.walls if vessel else printer.bead.usual
    if bead:
        best = ceil(solid.wall * scale / printer.bead.most) if vessel else None
        _refuse(printer, "bead", bead, printer.bead, best)
    floors = wanted.floor_layers
    if floors is None:
        bare = solid.kind is BodyKind.SURFACE
        floors = 0 if bare else min(round(solid.base * scale / layer), MOST_FLOORS)
    if solid.side is WallSide.INSIDE:
        offsets = [(k + 0.5) * bead for k in range(wanted.walls)]
    else:
        offsets = [-(wanted.walls - k - 0.5) * bead for k in range(wanted.walls)]
    skirt = printer.skirt if wanted.skirt is None else wanted.skirt
    return Plan(printer, wanted, layer, bead, floors, skirt if bead else 0, tuple(offsets))


def _refuse(printer: Printer, what: str, value: float, limits: Limits, walls: int | None) -> None:
    slack = 1e-9 * limits.most
    if limits.least - slack <= value <= limits.most + slack:
        return
    better = walls if walls is not None and 1 < walls <= MOST_WALLS else None
    raise ToolpathError(
        BeyondPrinter(what, value, limits.least, limits.most, printer.title, better)
    )
