"""What can be typed for ``trace``; nothing heavy is imported here."""

from __future__ import annotations

import argparse
from collections.abc import Callable
from math import isfinite

UNITS = ("mm", "cm", "in")
SIDES = ("left", "right", "both")


def add_trace(parser: argparse.ArgumentParser, positive: Callable[[str], float]) -> None:
    """Add what ``trace`` takes; ``positive`` reads a number above 0."""
    parser.add_argument(
        "sources", metavar="SOURCE", nargs="+", help="a drawing, table, mesh or picture"
    )
    parser.add_argument("out", metavar="OUT.sgb", help="or a folder, for several sources")
    parser.add_argument(
        "--tolerance",
        metavar="T",
        type=positive,
        help="largest distance of a point, in OUT's unit (default: 1e-3 of the size, or a pixel)",
    )
    parser.add_argument(
        "--unit",
        metavar="U",
        choices=UNITS,
        default="mm",
        help="unit of OUT, and of a source that names none: mm (default), cm, in",
    )
    size = parser.add_mutually_exclusive_group()
    size.add_argument(
        "--height", metavar="H", type=positive, help="true height of what a picture shows"
    )
    size.add_argument("--scale", metavar="S", type=positive, help="length of a pixel")
    size.add_argument(
        "--scale-bar",
        metavar="x1,y1,x2,y2,LENGTH",
        type=_scale_bar,
        help="two pixels and their true distance",
    )
    parser.add_argument(
        "--axis",
        metavar="A",
        type=_axis,
        help="auto, the abscissa of the upright axis, or for meshes x, y, z or px,py,pz,dx,dy,dz",
    )
    parser.add_argument(
        "--side",
        choices=SIDES,
        default="both",
        help="which side of the axis; both: their mean",
    )
    parser.add_argument(
        "--clicks",
        metavar='"x,y x,y ..."',
        type=_clicks,
        default=(),
        help="pixels near the line wanted, in order",
    )
    parser.add_argument(
        "--merge", action="store_true", help="trace exact pieces too, into fewer segments"
    )
    parser.add_argument("--json", action="store_true", help="one object, full precision")


def _numbers(text: str, count: int) -> list[float]:
    try:
        values = [float(word) for word in text.split(",")]
    except ValueError:
        values = []
    if len(values) != count or not all(map(isfinite, values)):
        raise argparse.ArgumentTypeError(
            f"{text!r} is not allowed; allowed are {count} finite numbers with commas"
        )
    return values


def _scale_bar(text: str) -> tuple[float, ...]:
    return tuple(_numbers(text, 5))


def _axis(text: str) -> float | str | tuple[float, ...] | None:
    word = text.strip().lower()
    if word == "auto":
        return None
    if word in ("x", "y", "z"):
        return word
    return tuple(_numbers(text, 6)) if "," in text else _numbers(text, 1)[0]


def _clicks(text: str) -> tuple[tuple[float, float], ...]:
    pairs = [_numbers(word, 2) for word in text.split()]
    if len(pairs) < 2:
        raise argparse.ArgumentTypeError(
            f"{text!r} is not allowed; allowed are two pairs x,y or more, with blanks between"
        )
    return tuple((x, y) for x, y in pairs)
