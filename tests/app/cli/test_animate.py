"""What the arguments of ``animate`` copy, so that help answers at once."""

from __future__ import annotations

import argparse

from app.cli.animate import add_animate
from app.film.film import FORMATS


def test_the_help_names_the_films_that_can_be_made() -> None:
    parser = argparse.ArgumentParser()
    add_animate(parser, lambda _: (1, 1), lambda _: frozenset())
    assert all(suffix in parser.format_help() for suffix in FORMATS)
