"""The ``solve`` command: targets with their units, what may change, and what is said."""

from __future__ import annotations

import argparse
import json
import re
from typing import TYPE_CHECKING

from app.cli.fair import KEEPS, keeps

if TYPE_CHECKING:
    from sgb_core.design.solving.goals import Goal
    from sgb_core.design.solving.ways import Slider, Way
    from sgb_core.document.model import Document

TARGETS = (
    "capacity",
    "filled",
    "volume",
    "material",
    "mass",
    "height",
    "max_diameter",
    "rim_diameter",
    "foot_diameter",
)
WAYS = ("all", "height", "width", "shape", "points")
LENGTHS = {"mm": 1.0, "cm": 10.0, "m": 1000.0, "in": 25.4}
# In cubic millimetres.
VOLUMES = {"ml": 1e3, "cl": 1e4, "dl": 1e5, "l": 1e6, "mm3": 1.0, "cm3": 1e3, "in3": 25.4**3}
MASSES = {"g": 1.0, "kg": 1e3}
_UNITS = {
    **dict.fromkeys(("capacity", "filled", "volume", "material"), VOLUMES),
    "mass": MASSES,
}
NUMBER = re.compile(r"([0-9.]+(?:[eE][+-]?[0-9]+)?)\s*([a-zA-Z]*3?)$")


def add_solve(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of ``solve``, the input file excepted."""
    parser.add_argument("out", metavar="OUT.sgb")
    parser.add_argument(
        "targets",
        metavar="TARGET=VALUE",
        nargs="+",
        type=_target,
        help=f"of {', '.join(TARGETS)}; the value with its unit (350ml, 95mm, 3in)",
    )
    parser.add_argument(
        "--by",
        metavar="WAY",
        type=_way,
        help=f"what may change: {', '.join(WAYS)} or SEGMENT.PARAMETER, such as 2.lambda2 "
        "(default: points and shape parameters by the least change)",
    )
    parser.add_argument(
        "--keep",
        metavar="LIST",
        type=keeps,
        default=(),
        help=f"what stays, locks aside: of {', '.join(KEEPS)}",
    )
    parser.add_argument("--json", action="store_true", help="one object, full precision")


def solved(document: Document, options: argparse.Namespace) -> tuple[Document, str]:
    """Return the document that reaches its targets, and the lines to print.

    Raises EditError with what is out of reach.
    """
    from sgb_core.design.fairing.findings import Keep
    from sgb_core.design.solving.ways import Way
    from sgb_core.document.edits.solve import solve_targets

    wanted = {}
    for name, value, unit in options.targets:
        goal, amount = _in_document(document, name, value, unit)
        wanted[goal] = amount
    keep = [Keep(name) for name in options.keep]
    result, found = solve_targets(document, wanted, options.by or Way.BOTH, keep)
    reached = {goal.value: value for goal, value in found.reached.items()}
    moved = [[m.segment, m.parameter, m.before, m.after] for m in found.moved]
    if options.json:
        tree = {"reached": reached, "factor": found.factor, "moved": moved}
        return result, json.dumps(tree, ensure_ascii=False, allow_nan=False, indent=2)
    lines = [f"{name.replace('_', ' ')}: {value:.10g}" for name, value in reached.items()]
    if found.factor is not None:
        return result, "\n".join([*lines, f"factor: {found.factor:.10g}"])
    lines += [f"segment {k}: {what} {old:.6g} -> {new:.6g}" for k, what, old, new in moved]
    return result, "\n".join(lines)


def _in_document(document: Document, name: str, value: float, unit: str) -> tuple[Goal, float]:
    """Return the goal and its value in the document's unit; a bare number is in that unit."""
    from sgb_core.design.solving.goals import Goal
    from sgb_core.document.body_measures import mass_in_grams

    if name == "mass":
        grams = value * MASSES[unit or "g"]
        return Goal.MATERIAL, grams / mass_in_grams(document, 1.0)
    units = _UNITS.get(name, LENGTHS)
    if not unit:
        return Goal(name), value
    power = 3 if units is VOLUMES else 1
    return Goal(name), value * units[unit] / LENGTHS[document.unit.value] ** power


def _target(text: str) -> tuple[str, float, str]:
    name, _, amount = text.partition("=")
    if name not in TARGETS:
        raise argparse.ArgumentTypeError(
            f"{name!r} is no target; allowed are {', '.join(TARGETS)}, each with =VALUE"
        )
    found = NUMBER.match(amount.strip())
    units = _UNITS.get(name, LENGTHS)
    try:
        value = float(found[1]) if found else 0.0
    except ValueError:
        value = 0.0
    if found is None or not 0.0 < value < float("inf") or (found[2] and found[2] not in units):
        raise argparse.ArgumentTypeError(
            f"{name} is {amount!r}; allowed is a number above 0 with {', '.join(units)}"
        )
    return name, value, found[2]


def _way(text: str) -> Way | Slider:
    from sgb_core.curves.segment import PARAMETERS
    from sgb_core.design.solving.ways import Slider, Way

    if text in WAYS:
        return Way(text)
    segment, _, parameter = text.partition(".")
    for name in PARAMETERS:
        if name == parameter and segment.isdecimal():
            return Slider(int(segment), name)
    raise argparse.ArgumentTypeError(
        f"{text!r} is not allowed; allowed are {', '.join(WAYS)} and SEGMENT.PARAMETER"
    )
