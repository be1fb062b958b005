"""What a drawing holds once it is read: paths in its own coordinates, the likely one first."""

from __future__ import annotations

from sgb_core.fields.kinds import Range
from sgb_core.findings.finding import Finding
from sgb_core.findings.refusal import Argument
from sgb_core.findings.sources import NoUnit, SeveralPaths
from sgb_core.sources.errors import SourceError
from sgb_core.sources.halves import read_path
from sgb_core.sources.options import Options
from sgb_core.sources.pieces import Path
from sgb_core.sources.reading import Reading
from sgb_core.values import dataclass


@dataclass(frozen=True, slots=True, eq=False)
class Drawing:
    """The paths of a drawing, heights upwards, and the abscissa of its axis where it draws one.

    ``millimetres`` is how many its unit is, None where it names none. Where ``named`` the first
    path is called the generatrix: nothing is to be chosen.
    """

    paths: tuple[Path, ...]
    axis: float | None
    millimetres: float | None
    named: bool


def read_drawing(drawing: Drawing, options: Options) -> Reading:
    """Return the sides of the path that is chosen; SourceError where there is no such path."""
    last = len(drawing.paths) - 1
    if not 0 <= options.path <= last:
        raise SourceError(Argument("path", options.path, Range(0, last, whole=True)))
    notes: list[Finding] = []
    scale = 1.0
    if drawing.millimetres is None:
        notes.append(NoUnit(options.unit.value))
    else:
        scale = drawing.millimetres / options.unit.millimetres
    if last > 0 and not drawing.named and options.path == 0:
        notes.append(SeveralPaths(last + 1))
    return read_path(drawing.paths[options.path], options, drawing.axis, scale, notes)
