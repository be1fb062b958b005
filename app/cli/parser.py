"""The command line: what can be typed, and how a command ends.

Nothing heavy is imported here: help and usage errors answer at once, and only the window and
``render`` reach Qt or VTK.
"""

from __future__ import annotations

import argparse
import os
import sys
from collections.abc import Callable, Sequence
from contextlib import suppress
from math import isfinite
from pathlib import Path
from typing import TYPE_CHECKING, NoReturn

from app.cli import animate, edit_verbs, figure_options, trace_options
from app.cli import compare as cli_compare
from app.cli import drawing as cli_drawing
from app.cli import fair as cli_fair
from app.cli import solve as cli_solve
from app.cli import template as cli_template
from app.cli import toolpath as cli_toolpath
from app.cli import variants as cli_variants
from app.cli.command_table import COMMANDS
from app.cli.version import version
from app.scene.standard_views import LARGEST_PICTURE, STANDARD_VIEWS
from app.state.overlays import Overlay

if TYPE_CHECKING:
    from sgb_core.findings.words import Reader

PROGRAM = "sgb-studio"
DONE, FAULT, USAGE = 0, 1, 2

# Those that do not begin with a project file, or say so themselves.
_NO_FILE = {"presets", "new", "animate", "figures", "trace", "printers", "drawing"}


class Parser(argparse.ArgumentParser):
    """A parser whose errors are one line; words that take a while are made for its help alone."""

    _last_words: Callable[[], str] | None = None
    _late_help: tuple[argparse.Action, Callable[[], str]] | None = None

    def end_help_with(self, words: Callable[[], str]) -> None:
        """Let the help end with words that are made when it is asked for."""
        self._last_words = words

    def explain_late(self, argument: argparse.Action, words: Callable[[], str]) -> None:
        """Give one argument its help when help is asked for."""
        self._late_help = argument, words

    def format_help(self) -> str:
        """Return the help."""
        if self._last_words is not None:
            self.epilog = self._last_words()
        if self._late_help is not None:
            action, words = self._late_help
            action.help = words()
        return super().format_help()

    def error(self, message: str) -> NoReturn:
        """Say what is wrong and where help is, then end with the status of wrong usage."""
        _complain(f"{message} (see {self.prog} --help)", self.prog)
        raise SystemExit(USAGE)


def main(argv: Sequence[str]) -> int:
    """Run one command, or the window for a bare file name, and return the exit status."""
    for stream in (sys.stdout, sys.stderr):
        # A terminal that cannot show λ shows something else; it is no reason to fail.
        if hasattr(stream, "reconfigure"):
            stream.reconfigure(errors="replace")
    try:
        status = run(list(argv))
        sys.stdout.flush()
    except BrokenPipeError:
        # The reader, such as `head`, has seen enough.
        _silence_output()
        return FAULT
    except OSError as error:
        _silence_output()
        return _complain(fault_words(error))
    except SystemExit as end:
        return end.code if isinstance(end.code, int) else FAULT
    except (MemoryError, ValueError) as error:
        return _complain(fault_words(error))
    return status


def fault_words(error: OSError | MemoryError | ValueError, reader: Reader | None = None) -> str:
    """Return in a line why a command cannot be done, for a reader other than a file's if given."""
    if isinstance(error, OSError):
        place = f"{error.filename}: " if error.filename else ""
        return f"{place}{error.strerror or error}"
    if isinstance(error, MemoryError):
        return "there is not enough memory for this"
    # Wrong usage, which never comes here, is told without loading the core.
    from sgb_core.findings.errors import FindingError

    if reader is not None and isinstance(error, FindingError):
        return error.words(reader)
    return str(error)


def run(argv: list[str]) -> int:
    """Run one command, or the window, and return the exit status; what is at fault is raised."""
    parser = build_parser()
    if not argv or not (argv[0].startswith("-") or argv[0] in COMMANDS):
        return _open_window(parser, argv)
    options = parser.parse_args(argv)
    if options.version:
        print(f"{PROGRAM} {version()}")
        return DONE
    if options.diagnose:
        from app.cli import diagnose

        for line in diagnose.lines():
            print(line)
        return DONE
    if options.command is None:
        parser.error("a command is missing")
    from app.cli import commands

    command: Callable[[argparse.Namespace], int] = getattr(commands, options.command)
    return command(options)


def _open_window(parser: Parser, argv: list[str]) -> int:
    path = None
    if argv:
        path = Path(argv[0])
        # lexists: a dangling link or an unreadable folder is for the window's own message.
        if not os.path.lexists(path):
            if path.suffix or path.name != argv[0]:
                return _complain(f"cannot read {argv[0]}: there is no such file")
            # Imported late: it takes as long to load as all the rest of the parser.
            from difflib import get_close_matches

            near = get_close_matches(argv[0], COMMANDS, 1)
            hint = f"did you mean '{near[0]}'?" if near else f"commands: {', '.join(COMMANDS)}"
            parser.error(f"'{argv[0]}' is neither a command nor a file; {hint}")
        if len(argv) > 1:
            parser.error(f"one file at a time: '{argv[1]}' is one too many")
    from app.cli import preflight

    finding = preflight.window_finding()
    if finding is not None:
        from sgb_core.findings.errors import FindingError

        raise FindingError(finding)
    from app.window.qt_imports import load_qt

    load_qt()
    from app.window import program

    return program.run(path)


def build_parser() -> Parser:
    """Return the parser of the whole command line."""
    parser = Parser(
        prog=PROGRAM,
        description="Sculpt rotation surfaces from shape-adjustable Bézier profiles. "
        "With a project file, or nothing, the window opens.",
        usage=f"{PROGRAM} [FILE]\n       {PROGRAM} COMMAND ...",
        epilog=f"{PROGRAM} COMMAND --help tells more. "
        "Exit status: 0 done, 1 the input or a file is at fault, 2 wrong usage.",
        allow_abbrev=False,
    )
    parser.add_argument("--version", action="store_true", help="print the version and stop")
    parser.add_argument(
        "--diagnose",
        action="store_true",
        help="print versions, OpenGL, screens and folders, and stop",
    )
    commands = parser.add_subparsers(metavar="COMMAND", dest="command", prog=PROGRAM)

    below = {
        name: commands.add_parser(name, help=text, description=text, allow_abbrev=False)
        for name, text in COMMANDS.items()
    }
    below["new"].add_argument("preset", metavar="PRESET", help="a name that 'presets' lists")
    below["new"].add_argument("out", metavar="OUT.sgb")
    for name in COMMANDS.keys() - _NO_FILE:
        below[name].add_argument("file", metavar="FILE", help="a project file (.sgb)")
    below["measure"].add_argument("--json", action="store_true", help="one object, full precision")
    below["check"].end_help_with(_laws)
    _add_sample(below["sample"])
    _add_export(below["export"])
    _add_render(below["render"])
    animate.add_animate(below["animate"], _size, _overlays)
    figure_options.add_figures(below["figures"])
    figure_options.add_plate(below["plate"])
    figure_options.add_fit(below["fit"])
    trace_options.add_trace(below["trace"], _positive)
    cli_fair.add_fair(below["fair"])
    cli_solve.add_solve(below["solve"])
    cli_variants.add_variants(below["variants"], _at_least)
    cli_toolpath.add_toolpath(below["toolpath"], _positive, _at_least)
    cli_toolpath.add_printers(below["printers"])
    cli_drawing.add_drawing(below["drawing"], _at_least)
    cli_template.add_template(below["template"])
    cli_compare.add_compare(below["compare"])
    below["edit"].add_argument("out", metavar="OUT.sgb")
    edit_verbs.add_verbs(below["edit"], f"{PROGRAM} edit FILE OUT.sgb")
    return parser


def _laws() -> str:
    # Imported late: no other help needs it.
    from sgb_core.surfaces.laws.shapes import SHAPES

    return f"Laws over the angle that a file may hold: {', '.join(SHAPES)}."


def _add_sample(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "--per-segment", metavar="N", type=_at_least(2), help="points per segment (default: 65)"
    )
    parser.add_argument(
        "--curvature",
        action="store_true",
        help="also arc length, curvature and distance from the plain cubic; "
        "OUT.svg, .pdf, .dxf or .png: a figure of them, made again from OUT.json beside it",
    )
    figure_options.add_dpi(parser)
    parser.add_argument("--out", metavar="OUT.csv", help="default: standard output")


def _add_export(parser: Parser) -> None:
    parser.explain_late(parser.add_argument("out", metavar="OUT"), _suffixes)
    fineness = parser.add_mutually_exclusive_group()
    fineness.add_argument(
        "--tolerance",
        metavar="T",
        type=_positive,
        help="largest distance from the true surface (default: 1e-3 of the size)",
    )
    fineness.add_argument(
        "--samples",
        metavar=("NS", "NT"),
        nargs=2,
        type=_at_least(1),
        help="intervals per segment and around",
    )
    figure_options.add_progress(parser)


def _suffixes() -> str:
    from sgb_core import exchange

    return " ".join(exchange.suffixes())


def _add_render(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("out", metavar="OUT.png")
    parser.add_argument(
        "--size", metavar="WxH", type=_size, default=(1200, 800), help="in pixels (1200x800)"
    )
    parser.add_argument(
        "--view",
        metavar="NAME",
        choices=STANDARD_VIEWS,
        default="iso",
        help=", ".join(STANDARD_VIEWS),
    )
    parser.add_argument(
        "--show", metavar="LIST", type=_overlays, help=f"of {', '.join(Overlay)}; with commas"
    )
    parser.add_argument("--transparent", action="store_true", help="no background")
    parser.add_argument("--look", metavar="NAME", help="a ready-made look, such as blue-white")


def _at_least(lowest: int) -> Callable[[str], int]:
    def parse(text: str) -> int:
        try:
            value = int(text)
        except ValueError:
            value = lowest - 1
        if value < lowest:
            raise argparse.ArgumentTypeError(
                f"{text!r} is not allowed; allowed is a whole number of at least {lowest}"
            )
        return value

    return parse


def _positive(text: str) -> float:
    try:
        value = float(text)
    except ValueError:
        value = 0.0
    if not (isfinite(value) and value > 0.0):
        raise argparse.ArgumentTypeError(
            f"{text!r} is not allowed; allowed is a finite number above 0"
        )
    return value


def _size(text: str) -> tuple[int, int]:
    width, cross, height = text.partition("x")
    if cross and width.isdecimal() and height.isdecimal():
        size = int(width), int(height)
        if min(size) >= 1 and max(size) <= LARGEST_PICTURE:
            return size
    raise argparse.ArgumentTypeError(
        f"{text!r} is not allowed; allowed is WxH, each from 1 to {LARGEST_PICTURE}"
    )


def _overlays(text: str) -> frozenset[Overlay]:
    names = frozenset(name.strip() for name in text.split(",")) - {""}
    unknown = sorted(names - set(Overlay))
    if unknown:
        raise argparse.ArgumentTypeError(
            f"{unknown[0]!r} is not allowed; allowed are {', '.join(Overlay)}"
        )
    return frozenset(overlay for overlay in Overlay if overlay in names)


def _complain(message: str, name: str = PROGRAM) -> int:
    """Print one line on standard error and return the status of a fault."""
    with suppress(OSError):
        print(f"{name}: {' '.join(message.splitlines())}", file=sys.stderr)
    return FAULT


def _silence_output() -> None:
    """Send what is still buffered nowhere, or the interpreter complains while it ends."""
    with suppress(OSError, ValueError):
        nowhere = os.open(os.devnull, os.O_WRONLY)
        os.dup2(nowhere, sys.stdout.fileno())
        os.close(nowhere)
