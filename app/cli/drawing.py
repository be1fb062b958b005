"""The ``drawing`` command: what can be typed, and what is drawn of it."""

from __future__ import annotations

import argparse
import re
from collections.abc import Callable
from typing import TYPE_CHECKING

from app.cli.figure_options import add_dpi

if TYPE_CHECKING:
    from sgb_core.drawings.page import Drawing
    from sgb_core.drawings.scales import Scale

STYLES = ("section", "vessel")
PAPERS = ("A4", "A3", "A2", "A1", "Letter")


def add_drawing(
    parser: argparse.ArgumentParser, at_least: Callable[[int], Callable[[str], int]]
) -> None:
    """Add the arguments of ``drawing``."""
    parser.add_argument("files", metavar="FILE", nargs="+", help="project files (.sgb)")
    parser.add_argument("out", metavar="OUT", help="ending in .svg, .pdf, .dxf or .png")
    parser.add_argument(
        "--style",
        choices=STYLES,
        default="section",
        help="section: dimensioned, for the workshop (default); vessel: a plate of vessels as "
        "archaeologists publish them",
    )
    parser.add_argument(
        "--paper", metavar="NAME", choices=PAPERS, help=f"of {', '.join(PAPERS)}; default: fitting"
    )
    parser.add_argument("--scale", metavar="N:M", type=scale_of, help="default: the largest to fit")
    parser.add_argument(
        "--section", choices=("left", "right"), help="on which side it stands (default: right)"
    )
    parser.add_argument(
        "--fill",
        choices=("hatched", "filled"),
        help="how the wall is shown (default: hatched, in a plate filled)",
    )
    parser.add_argument(
        "--first", metavar="N", type=at_least(0), help="number of a plate's first vessel (1)"
    )
    parser.add_argument("--date", metavar="DAY", help="as 2026-03-31, for the title block (today)")
    add_dpi(parser)


def scale_of(text: str) -> tuple[int, int]:
    """Return the two numbers of a scale."""
    found = re.fullmatch(r"([1-9]\d{0,8}):([1-9]\d{0,8})", text)
    if found is None:
        raise argparse.ArgumentTypeError(
            f"{text!r} is not allowed; allowed are scales such as 1:2 and 2:1"
        )
    return int(found[1]), int(found[2])


def made(options: argparse.Namespace) -> Drawing:
    """Return the drawing that was asked for; raises ValueError for what cannot be drawn."""
    from datetime import date

    from sgb_core.document.file import project_file
    from sgb_core.drawings.drawing import draw
    from sgb_core.drawings.scales import Paper
    from sgb_core.drawings.wanted import Fill, Side, Style, Wanted

    wanted = Wanted(
        style=Style(options.style),
        paper=None if options.paper is None else Paper(options.paper),
        scale=_scale(options.scale),
        side=Side(options.section or "right"),
        fill=None if options.fill is None else Fill(options.fill),
        first=1 if options.first is None else options.first,
        day=date.today().isoformat() if options.date is None else options.date,
    )
    return draw([project_file.load(file) for file in options.files], wanted)


def _scale(numbers: tuple[int, int] | None) -> Scale | None:
    from sgb_core.drawings.scales import Scale

    return None if numbers is None else Scale(*numbers)


def report(drawing: Drawing) -> str:
    """Return what was drawn, in a line."""
    return f"{drawing.subject}; curves within {drawing.tolerance:g} mm on paper"
