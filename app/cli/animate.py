"""The command ``animate``: its arguments and what it does."""

from __future__ import annotations

import argparse
from collections.abc import Callable
from math import isfinite
from pathlib import Path

from app.scene.standard_views import STANDARD_VIEWS
from app.state.overlays import Overlay


class _Vary(argparse.Action):
    """Takes SEGMENT PARAMETER FROM TO apart; SEGMENT "all" means every one."""

    def __call__(
        self,
        parser: argparse.ArgumentParser,
        namespace: argparse.Namespace,
        values: object,
        option_string: str | None = None,
    ) -> None:
        # Imported late: help and other usage errors answer at once.
        from app.film.film import Variation
        from sgb_core.curves.segment import PARAMETER_RANGES

        assert isinstance(values, list)
        segment, name, *ends = values
        parameter = next((each for each in PARAMETER_RANGES if each == name), None)
        if parameter is None:
            parser.error(f"{name!r} is not allowed; allowed are {', '.join(PARAMETER_RANGES)}")
        if segment != "all" and not segment.isdecimal():
            parser.error(f"{segment!r} is not allowed; allowed is a segment's number, or all")
        try:
            start, end = (float(text) for text in ends)
        except ValueError:
            parser.error(f"{' '.join(ends)!r} is not allowed; allowed are two numbers")
        if not (isfinite(start) and isfinite(end)):
            parser.error("the values are not finite")
        number = None if segment == "all" else int(segment)
        setattr(namespace, self.dest, Variation(number, parameter, start, end))


def add_animate(
    parser: argparse.ArgumentParser,
    size: Callable[[str], tuple[int, int]],
    overlays: Callable[[str], frozenset[Overlay]],
) -> None:
    """Add the arguments of the command."""
    parser.add_argument("file", metavar="FILE", help="a project file (.sgb)")
    parser.add_argument("out", metavar="OUT", help=".gif .mp4, or .png for a picture of each frame")
    what = parser.add_mutually_exclusive_group()
    what.add_argument("--turntable", action="store_true", help="once around (the default)")
    what.add_argument(
        "--vary",
        metavar=("SEGMENT", "PARAMETER", "FROM", "TO"),
        nargs=4,
        action=_Vary,
        help="a shape parameter there and back; SEGMENT may be all",
    )
    what.add_argument("--to", metavar="STATE", help="to a saved state and back")
    parser.add_argument(
        "--from", dest="start", metavar="STATE", help="of --to: (the file as it is)"
    )
    parser.add_argument("--frames", metavar="N", type=int, default=60, help="(60)")
    parser.add_argument("--fps", metavar="N", type=float, default=20.0, help="a second (20)")
    parser.add_argument("--size", metavar="WxH", type=size, default=(480, 480), help="(480x480)")
    parser.add_argument("--view", metavar="NAME", choices=STANDARD_VIEWS, default="iso")
    parser.add_argument(
        "--show", metavar="LIST", type=overlays, default=frozenset({Overlay.SURFACE})
    )
    parser.add_argument("--progress", action="store_true", help="print the percentage done")


def write_animation(options: argparse.Namespace) -> None:
    """Draw and write the film; raises ValueError for what is at fault."""
    from app.film.film import Film, Passage, check_target, write_film
    from sgb_core.document.file import project_file
    from sgb_core.findings.errors import FindingError
    from sgb_core.findings.plates import NoFilm

    if options.start is not None and options.to is None:
        raise FindingError(NoFilm.NO_GOAL)
    moved = options.vary if options.to is None else Passage(options.start, options.to)
    film = Film(options.frames, options.fps, moved)
    path = Path(options.out)
    check_target(path)
    document = project_file.load(options.file)
    # What the first and the farthest frame refuse is said before anything is drawn.
    steps = list(film.steps(document))
    assert steps
    from app.film.frames import film_images
    from app.state.view_state import ViewState

    view = ViewState(segment=-1, show=options.show)
    images = film_images(document, film, options.size, view, direction=options.view)

    def report(part: float) -> None:
        if options.progress:
            print(round(100 * part), flush=True)

    write_film(path, images, film, report)
