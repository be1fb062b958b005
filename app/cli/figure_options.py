"""What can be typed for ``figures``, ``plate`` and ``fit``; nothing heavy is imported here."""

from __future__ import annotations

import argparse
from collections.abc import Callable
from math import isfinite

TARGETS = ("circle", "ellipse", "superellipse")
FREEDOMS = ("omega", "shape", "polygon")
LAST_FIGURE = 14
DPI = (50, 1200)


def add_figures(parser: argparse.ArgumentParser) -> None:
    """Add the options of ``figures``."""
    numbers = range(1, LAST_FIGURE + 1)
    parser.add_argument(
        "--only", metavar="N", type=int, choices=numbers, help=f"one figure, 1 to {LAST_FIGURE}"
    )
    parser.add_argument(
        "--out", metavar="DIR", required=True, help="folder for figure_NN.png, .pdf, .svg, .json"
    )
    parser.add_argument(
        "--again", metavar="FILE.json", help="make the figure of such a file again, to the last bit"
    )
    add_dpi(parser, "what is shaded", "the figure's own")


def add_plate(parser: argparse.ArgumentParser) -> None:
    """Add the options of ``plate``, after FILE."""
    parser.add_argument(
        "out",
        metavar="OUT",
        help=".png, .pdf or .svg; OUT.json beside it makes it again, in place of FILE",
    )
    add_dpi(parser, "what is shaded", "the figure's own")
    add_progress(parser)


def add_progress(parser: argparse.ArgumentParser) -> None:
    """Add whether progress is printed."""
    parser.add_argument("--progress", action="store_true", help="print the percentage done")


def add_dpi(parser: argparse.ArgumentParser, of: str = "a .png", default: str = "300") -> None:
    """Add how fine a picture is."""
    low, high = DPI
    parser.add_argument(
        "--dpi",
        metavar="N",
        type=resolution,
        help=f"pixels to the inch of {of}, {low} to {high} (default: {default})",
    )


def resolution(text: str) -> int:
    """Return a number of pixels to the inch; raises ArgumentTypeError."""
    low, high = DPI
    if not (text.isdecimal() and low <= int(text) <= high):
        raise argparse.ArgumentTypeError(
            f"{text!r} is not allowed; allowed is a whole number from {low} to {high}"
        )
    return int(text)


def add_fit(parser: argparse.ArgumentParser) -> None:
    """Add the options of ``fit``, after FILE."""
    parser.add_argument("out", metavar="OUT.sgb")
    parser.add_argument("--target", choices=TARGETS, required=True, help=", ".join(TARGETS))
    sizes = (
        ("--a", "half height of the target (default: from the profile's ends)", _positive),
        (
            "--b",
            "half width (default: a for a circle, else the profile's largest radius)",
            _positive,
        ),
        ("--centre", "height of the target's centre (default: midway between the ends)", _finite),
        ("--exponent", "of a superellipse, 1 to 20 (default: 2.5)", _positive),
    )
    for name, text, read in sizes:
        parser.add_argument(name, metavar="X", type=read, help=text)
    parser.add_argument(
        "--freedom",
        choices=FREEDOMS,
        default="polygon",
        help="what may change: ω alone, all shape parameters, or control points too (polygon)",
    )
    parser.add_argument(
        "--keep-ends",
        action="store_true",
        help="with polygon: keep the directions of the end legs, so poles stay smooth",
    )
    parser.add_argument(
        "--slide-poles",
        action="store_true",
        help="with polygon: let the ends move along the axis",
    )
    parser.add_argument(
        "--least-squares",
        action="store_true",
        help="the least sum of squares instead of the least largest deviation",
    )


def _finite(text: str) -> float:
    return _number(text, "a finite number", lambda value: True)


def _positive(text: str) -> float:
    return _number(text, "a finite number above 0", lambda value: value > 0.0)


def _number(text: str, allowed: str, accepts: Callable[[float], bool]) -> float:
    try:
        value = float(text)
    except ValueError:
        value = float("nan")
    if not (isfinite(value) and accepts(value)):
        raise argparse.ArgumentTypeError(f"{text!r} is not allowed; allowed is {allowed}")
    return value
