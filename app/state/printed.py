"""A document's path on a printer as views show it, planned as for a look at it."""

from __future__ import annotations

from typing import TYPE_CHECKING

from sgb_core.document.model import Document
from sgb_core.values import dataclass

if TYPE_CHECKING:
    from sgb_core.toolpaths.beads import Beads
    from sgb_core.toolpaths.printer import Printer
    from sgb_core.toolpaths.toolpath import Toolpath


# Of paths with more points some are not drawn: in a resting picture, and in one that moves.
MOST_POINTS, MOST_MOVING = 60_000, 9_000


@dataclass(frozen=True, slots=True, eq=False)
class Printed:
    """A document's path and its beads as they are drawn; None with why there can be none.

    ``beads`` are those of a resting picture, ``rough`` those of one that moves.
    """

    document: Document
    path: Toolpath | None
    beads: Beads | None = None
    rough: Beads | None = None
    refused: str = ""


def planned(document: Document, printer: Printer, layer: float) -> Printed:
    """Return the path of a document with as few beads in its wall as the printer can.

    What leans too far is planned all the same. Raises ToolpathError for what has no path.
    """
    # Imported when first needed, aside: the window is painted sooner.
    from sgb_core.toolpaths.beads import beads
    from sgb_core.toolpaths.plan_path import toolpath
    from sgb_core.toolpaths.settings import Wanted, fewest_beads

    walls = fewest_beads(document, printer)
    path = toolpath(document, printer, Wanted(layer=layer, walls=walls, anyway=True))
    return Printed(document, path, beads(path, MOST_POINTS), beads(path, MOST_MOVING))
