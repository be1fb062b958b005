"""The ``compare`` command: what can be typed, and what is printed."""

from __future__ import annotations

import argparse
import json
from collections.abc import Sequence
from typing import TYPE_CHECKING

from app.cli.figure_options import add_dpi

if TYPE_CHECKING:
    from sgb_core.design.comparison import Compared


def add_compare(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of ``compare``, the input file excepted."""
    parser.add_argument(
        "out",
        metavar="OUT",
        help="a plate ending in .svg, .pdf, .dxf or .png; OUT.json beside it makes it again, in "
        "place of FILE",
    )
    parser.add_argument("--json", action="store_true", help="one object, full precision")
    add_dpi(parser)


def report(found: Sequence[Compared], unit: str, as_json: bool) -> str:
    """Return energies and deviations, a line each or as JSON."""
    from sgb_core.findings.words import say

    if as_json:
        curves = [
            {
                "kind": each.kind.value,
                "energy": each.energy,
                "largest_deviation": each.deviation,
                **(
                    {"weights": [[1.0, *pair, 1.0] for pair in each.weights]}
                    if each.weights
                    else {}
                ),
                **({} if each.missed is None else {"missed": say(each.missed)}),
            }
            for each in found
        ]
        return json.dumps({"unit": unit, "curves": curves}, allow_nan=False, indent=2)
    lines = []
    for each in found:
        if each.missed is not None:
            lines.append(f"{each.kind.value:<17}  {say(each.missed)}")
            continue
        energy = "unbounded" if each.energy is None else f"{each.energy:.6g} 1/{unit}"
        lines.append(f"{each.kind.value:<17}  energy {energy}, {each.deviation:.4g} {unit} off")
    return "\n".join(lines)
