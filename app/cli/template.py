"""The ``template`` command: what can be typed, and what is drawn of it."""

from __future__ import annotations

import argparse
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from sgb_core.drawings.page import Drawing

PAPERS = ("A4", "A3", "Letter")


def add_template(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of ``template``, the input file excepted."""
    parser.add_argument("out", metavar="OUT.pdf")
    parser.add_argument("--paper", choices=PAPERS, default="A4", help="default: A4")
    parser.add_argument(
        "--as",
        dest="stage",
        choices=("wet", "fired"),
        default="wet",
        help="the size where the project has a shrinkage (default: wet)",
    )
    parser.add_argument(
        "--wall",
        choices=("outside", "inside"),
        default="outside",
        help="the side of the wall that the board lies against (default: outside)",
    )


def made(options: argparse.Namespace) -> Drawing:
    """Return the template that was asked for; raises ValueError for what cannot be drawn."""
    from pathlib import PurePath

    from sgb_core.bodies.solid import WallSide
    from sgb_core.document.file import project_file
    from sgb_core.document.manufacture import Stage
    from sgb_core.drawings.scales import Paper
    from sgb_core.drawings.template import TemplateWanted, template
    from sgb_core.findings.errors import FindingError
    from sgb_core.findings.exports import NoFormat

    suffix = PurePath(options.out).suffix.lower()
    if suffix != ".pdf":
        raise FindingError(NoFormat(options.out, suffix, (".pdf",)))
    wanted = TemplateWanted(Paper(options.paper), Stage(options.stage), WallSide(options.wall))
    return template(project_file.load(options.file), wanted)


def report(drawing: Drawing) -> str:
    """Return what was drawn, in a line."""
    count = len(drawing.pages)
    return f"{drawing.subject}, {count} page{'s' if count > 1 else ''}"
