"""The ``toolpath`` and ``printers`` commands: what can be typed, and what is printed."""

from __future__ import annotations

import argparse
import json
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from sgb_core.document.model import Document
    from sgb_core.toolpaths.printer import Printer
    from sgb_core.toolpaths.settings import Wanted
    from sgb_core.toolpaths.toolpath import Toolpath

USUAL = "generic-plastic"


def add_toolpath(
    parser: argparse.ArgumentParser,
    positive: Callable[[str], float],
    at_least: Callable[[int], Callable[[str], int]],
) -> None:
    """Add the arguments of ``toolpath``, the input file excepted."""
    parser.add_argument("out", metavar="OUT.gcode")
    parser.add_argument(
        "--printer",
        metavar="NAME",
        default=USUAL,
        help=f"of 'printers', or the file of one's own (default: {USUAL})",
    )
    parser.add_argument("--layer", metavar="H", type=positive, help="climb of a turn in mm")
    parser.add_argument(
        "--bead",
        metavar="W",
        type=_at_least_nothing,
        help="width of the bead in mm (default: the printer's, or of a vessel wall / N); "
        "0 is the drawn surface itself, with nothing pushed out",
    )
    parser.add_argument(
        "--walls", metavar="N", type=at_least(1), default=1, help="beads side by side (default: 1)"
    )
    parser.add_argument(
        "--floor-layers", metavar="N", type=at_least(0), help="default: base / layer"
    )
    parser.add_argument(
        "--chord", metavar="C", type=positive, help="how far a corner may be cut in mm (0.02)"
    )
    parser.add_argument("--adaptive", action="store_true", help="climb less where the wall leans")
    parser.add_argument("--arcs", action="store_true", help="write arcs, G2 and G3, for circles")
    parser.add_argument(
        "--as", dest="stage", choices=("wet", "fired"), help="the size (default: wet)"
    )
    parser.add_argument("--skirt", metavar="N", type=at_least(0), help="circles around the foot")
    parser.add_argument("--clockwise", action="store_true", help="turn the other way round")
    parser.add_argument(
        "--anyway", action="store_true", help="print what leans too far to rest on the turn below"
    )
    parser.add_argument("--json", action="store_true", help="one object, full precision")


def add_printers(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of ``printers``."""
    parser.add_argument("name", metavar="NAME", nargs="?", help="print this one's data file")


def printer_called(name: str) -> Printer:
    """Return a known printer by its name, or that of a file.

    Raises ValueError, in one line that names the choices, where there is none.
    """
    import resources
    from sgb_core.fields.kinds import Choice
    from sgb_core.findings.errors import FindingError
    from sgb_core.findings.line import InFile
    from sgb_core.findings.refusal import Unknown
    from sgb_core.toolpaths.printer import read_printer

    known = {path.stem: path for path in resources.printers()}
    path = known.get(name)
    if path is None:
        path = Path(name)
        if path.suffix.lower() != ".json":
            raise FindingError(Unknown("printer", name, Choice(known)))
    try:
        return read_printer(path)
    except FindingError as error:
        raise FindingError(InFile(name, error.finding)) from None


def list_printers(name: str | None) -> str:
    """Return a line for each known printer, or the data file of one."""
    from sgb_core.toolpaths.printer import printer_text

    if name is not None:
        return printer_text(printer_called(name)).rstrip("\n")
    import resources

    found = [printer_called(path.stem) for path in resources.printers()]
    width = max(len(printer.name) for printer in found)
    lines = []
    for printer in found:
        bed = printer.bed
        across = f"⌀{bed.width:g}" if bed.shape == "circle" else f"{bed.width:g} × {bed.depth:g}"
        room = f"{across} × {bed.height:g} mm"
        lines.append(f"{printer.name:<{width}}  {printer.title}; {room}, nozzle {printer.nozzle:g}")
    return "\n".join(lines)


def made(document: Document, options: argparse.Namespace) -> Toolpath:
    """Return the path that was asked for; raises ValueError for what cannot be printed."""
    from sgb_core.toolpaths.plan_path import toolpath

    return toolpath(document, printer_called(options.printer), _wanted(options))


def _wanted(options: argparse.Namespace) -> Wanted:
    from sgb_core.document.manufacture import Stage
    from sgb_core.toolpaths.settings import Wanted

    return Wanted(
        layer=options.layer,
        bead=options.bead,
        walls=options.walls,
        floor_layers=options.floor_layers,
        chord=0.02 if options.chord is None else options.chord,
        adaptive=options.adaptive,
        arcs=options.arcs,
        stage=Stage(options.stage or "wet"),
        skirt=options.skirt,
        clockwise=options.clockwise,
        anyway=options.anyway,
    )


def report(path: Toolpath, as_json: bool) -> str:
    """Return what a path comes to, as lines or as JSON; lengths in mm, volumes in mm³."""
    from sgb_core.findings.words import say

    warnings = [say(finding) for finding in path.findings]
    if as_json:
        low, high = path.bounds
        tree = {
            "points": len(path.points),
            "length": path.length,
            "extruded_volume": path.extruded_volume,
            "material_volume": path.material_volume,
            "time_s": path.time,
            "layers": path.layer_count,
            "largest_sideways_step": path.largest_step,
            "e_per_mm3": path.plan.printer.feed.e_per_mm3,
            "bounds": [low.tolist(), high.tolist()],
            "warnings": warnings,
            "grams": path.grams,
            "refills": path.refills,
        }
        return json.dumps(tree, ensure_ascii=False, allow_nan=False, indent=2)
    minutes = path.time / 60.0
    lines = [
        f"layers: {path.layer_count}",
        f"points: {len(path.points)}",
        f"length: {path.length / 1000.0:.2f} m",
        f"volume: {path.extruded_volume / 1000.0:.2f} ml",
        f"time: {minutes:.0f} min without acceleration",
    ]
    if path.grams is not None:
        lines.append(f"mass: {path.grams:.0f} g")
    if path.refills:
        lines.append(f"refills: {path.refills}")
    return "\n".join([*lines, *warnings])


def _at_least_nothing(text: str) -> float:
    try:
        value = float(text)
    except ValueError:
        value = -1.0
    if not 0.0 <= value < float("inf"):
        raise argparse.ArgumentTypeError(
            f"{text!r} is not allowed; allowed is a number of at least 0"
        )
    return value
