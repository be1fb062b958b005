"""The ``variants`` command: what can be typed, what is written and what is said."""

from __future__ import annotations

import argparse
import json
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, cast

if TYPE_CHECKING:
    from sgb_core.curves.segment import ParameterName
    from sgb_core.document.model import Document
    from sgb_core.document.variants import Variant

FREEDOMS = ("shape", "points")
MOST, USUAL = 48, 12


def add_variants(
    parser: argparse.ArgumentParser, at_least: Callable[[int], Callable[[str], int]]
) -> None:
    """Add the arguments of ``variants``, the input file excepted."""
    parser.add_argument(
        "--out", metavar="DIR", required=True, help="the folder for variant-01.sgb and so on"
    )
    what = parser.add_mutually_exclusive_group()
    what.add_argument(
        "--over",
        metavar="SEGMENT.PARAMETER",
        nargs="+",
        type=_parameter,
        help="go through one or two parameters, such as 2.lambda2 3.omega",
    )
    what.add_argument(
        "--free",
        choices=FREEDOMS,
        default="shape",
        help="go where all locks and rules hold, by shape parameters alone or by points too",
    )
    parser.add_argument(
        "--count", metavar="N", type=at_least(2), default=USUAL, help=f"how many (at most {MOST})"
    )
    parser.add_argument("--json", action="store_true", help="one object, full precision")


def written(document: Document, options: argparse.Namespace) -> str:
    """Write all variants and return the lines to print, the fairest first.

    Raises EditError where nothing is free, or where there is no such segment.
    """
    from sgb_core.document.file import project_file
    from sgb_core.document.variants import Free, Swept, free_variants, parameter_variants

    count = min(options.count, MOST)
    if options.over:
        swept = [Swept(k, cast("ParameterName", name)) for k, name in options.over[:2]]
        found = parameter_variants(document, swept, count)
    else:
        found = free_variants(document, Free(options.free), count)
    folder = Path(options.out)
    folder.mkdir(parents=True, exist_ok=True)
    names = [f"variant-{number:02d}.sgb" for number in range(1, len(found) + 1)]
    for name, variant in zip(names, found, strict=True):
        project_file.save(variant.document, folder / name)
    return (_tree if options.json else _lines)(document, list(zip(names, found, strict=True)))


def _tree(document: Document, found: list[tuple[str, Variant]]) -> str:
    from sgb_core.document.variants import shared
    from sgb_core.findings.words import say

    variants = [
        {"file": name, "energy": each.energy, "values": list(each.values)} for name, each in found
    ]
    kept = [say(lock) for lock in shared(document).locks]
    tree = {"unit": str(document.unit), "locks": kept, "variants": variants}
    return json.dumps(tree, ensure_ascii=False, allow_nan=False, indent=2)


def _lines(document: Document, found: list[tuple[str, Variant]]) -> str:
    from sgb_core.document.variants import shared
    from sgb_core.findings.words import say

    lines = [say(shared(document))]
    for name, each in found:
        values = "".join(f", {value:.4g}" for value in each.values)
        lines.append(f"{name}  energy {each.energy:.6g} 1/{document.unit}{values}")
    return "\n".join(lines)


def _parameter(text: str) -> tuple[int, str]:
    from sgb_core.curves.segment import PARAMETERS

    segment, _, parameter = text.partition(".")
    if segment.isdecimal() and parameter in PARAMETERS:
        return int(segment), parameter
    raise argparse.ArgumentTypeError(
        f"{text!r} is not allowed; allowed is SEGMENT.PARAMETER, such as 2.lambda2"
    )
