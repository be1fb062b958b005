"""What the options copy, so that help answers at once, is what the core allows."""

from __future__ import annotations

import argparse

from app.cli.figure_options import FREEDOMS, add_fit
from sgb_core.design.fitting import Freedom
from sgb_core.design.target_curves import SuperellipseArc
from sgb_core.document.edits.fit import SUPERELLIPSE
from sgb_core.fields.record import table_of


def test_the_freedoms_are_the_cores() -> None:
    assert tuple(Freedom) == FREEDOMS


def test_the_help_names_the_exponents_that_are_allowed() -> None:
    parser = argparse.ArgumentParser()
    add_fit(parser)
    allowed = table_of(SuperellipseArc).row("exponent").kind.brief
    said = " ".join(parser.format_help().split())
    assert f"of a superellipse, {allowed} (default: {SUPERELLIPSE:g})" in said
