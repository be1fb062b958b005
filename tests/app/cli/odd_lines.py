"""Command lines made from the command line's own parser: each command, verb and option of it."""

from __future__ import annotations

import argparse
import random
from pathlib import Path

from app.cli.command_table import COMMANDS
from app.cli.parser import build_parser

# What draws with VTK needs more than the limit of memory allows, or takes minutes.
DRAWN = {"render", "animate", "figures", "plate"}
NUMBERS = ("1", "2", "3", "0.5", "7", "0", "-1", "1e9", "1000000", "1e-9", "nan", "1e999", "10mm")
ODD = ("", "-", "..", "é", "x" * 3000, "1,2", "/", "\n", "2.lambda2", "0", "all", "height=3cm")
KINDS = ("sgb", "stl", "obj", "ply", "3mf", "glb", "csv", "pdf", "svg", "dxf", "gcode")
SUFFIXES = tuple(f".{kind}" for kind in KINDS)


def odd_line(drawn: random.Random, good: Path, out: Path) -> list[str]:
    """Return the words of a line about the project file ``good``, written below ``out``."""
    command = drawn.choice(sorted(COMMANDS.keys() - DRAWN))
    below = _choices(build_parser())[command]
    line = [command, *_words(below, drawn, good, out)]
    while drawn.random() < 0.3:
        at = drawn.randrange(1, len(line) + 1)
        if drawn.random() < 0.5:
            del line[at : at + 1]
        else:
            line.insert(at, drawn.choice(ODD + NUMBERS))
    return line


def _choices(parser: argparse.ArgumentParser) -> dict[str, argparse.ArgumentParser]:
    for action in parser._actions:
        if isinstance(action, argparse._SubParsersAction):
            return dict(action.choices)
    return {}


def _words(
    parser: argparse.ArgumentParser, drawn: random.Random, good: Path, out: Path
) -> list[str]:
    words: list[str] = []
    for action in parser._actions:
        if isinstance(action, argparse._SubParsersAction):
            verb = drawn.choice(sorted(action.choices))
            words += [verb, *_words(action.choices[verb], drawn, good, out)]
        elif not action.option_strings:
            words += _values(action, drawn, good, out)
        elif drawn.random() < 0.2 and not isinstance(action, argparse._HelpAction):
            words += [drawn.choice(action.option_strings), *_values(action, drawn, good, out)]
    return words


def _values(action: argparse.Action, drawn: random.Random, good: Path, out: Path) -> list[str]:
    many = {None: 1, "?": drawn.choice((0, 1)), "*": drawn.choice((0, 2)), "+": 2}
    count = action.nargs if isinstance(action.nargs, int) else many.get(action.nargs, 1)
    return [_value(action, drawn, good, out) for _ in range(count)]


def _value(action: argparse.Action, drawn: random.Random, good: Path, out: Path) -> str:
    told = str(action.metavar or action.dest).upper()
    if drawn.random() < 0.12:
        return drawn.choice(ODD)
    if action.choices is not None:
        return str(drawn.choice(sorted(map(str, action.choices))))
    if "FILE" in told:
        return str(good)
    if "OUT" in told:
        suffix = next((s for s in SUFFIXES if told.lower().endswith(s)), drawn.choice(SUFFIXES))
        return f"{out}{suffix}"
    return drawn.choice((*NUMBERS, "vase", "segments", "circle", "height", "rim_diameter"))
