"""SVG drawings of any program: the path that is likely meant, in true units."""

from __future__ import annotations

import io
import re
from collections.abc import Iterator
from typing import Any
from xml.etree import ElementTree

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.curves.profile import Profile
from sgb_core.design.tracing.result import distances
from sgb_core.findings.sources import NoSource, TooMuch, Unreadable
from sgb_core.sources.drawing import Drawing
from sgb_core.sources.errors import SourceError
from sgb_core.sources.pieces import Arc, Bezier, Path, Piece, are_places, chained, upright_line
from sgb_core.sources.svg_tree import svg_tree

_MOST_PIECES = 50_000
# Millimetres of the units of length that a file may name; px and none name none.
_MILLIMETRES = {"mm": 1.0, "cm": 10.0, "in": 25.4, "pt": 25.4 / 72, "pc": 25.4 / 6, "q": 0.25}
# No piece has more numbers: those of an arc.
_NUMBER, _MOST_NUMBERS = re.compile(r"\d*\.?\d+"), 7
_LENGTH = re.compile(r"^\s*([-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)\s*([a-zA-Z%]*)\s*$")
# Of a path's size: ends this near are one.
_JOINED = 1e-6
# Quartics and the cubics that this program draws them with are this near at so many places each.
_ALIKE, _LOOKS = 1e-5, 5
_MOST_OWN = 5000
_GENERATRIX, _AXIS, _QUARTICS = "generatrix", "axis", "data-sgb-quartics"


def parse_svg(data: bytes) -> Drawing:
    """Return the paths that an SVG file draws.

    Places are x and −y in the coordinates of the root's viewBox. A path called "generatrix" is
    taken before the longest. Nothing but the file itself is read. Raises SourceError for what is
    no SVG, too large, or has no path.
    """
    root = svg_tree(data)
    millimetres = _millimetres(root)
    own = _own_path(root)
    paths, axis = _paths(root)
    if own is not None and paths[0].name == _GENERATRIX and _agree(own, paths[0]):
        paths = [own, *paths[1:]]
    turn = np.diag([1.0, -1.0])
    upwards = tuple(path.mapped(turn, np.zeros(2)) for path in paths)
    return Drawing(upwards, axis, millimetres, paths[0].name == _GENERATRIX)


def _millimetres(root: ElementTree.Element) -> float | None:
    """Return how many millimetres one of the root's own unit is, None where it does not say."""
    box = [float(word) for word in re.findall(r"[-+.\deE]+", root.get("viewBox", ""))]
    found = []
    for name, place in (("width", 2), ("height", 3)):
        match = _LENGTH.match(root.get(name, ""))
        if match is None or match[2].lower() not in _MILLIMETRES:
            continue
        length = float(match[1]) * _MILLIMETRES[match[2].lower()]
        extent = box[place] if len(box) == 4 else 96.0 * length / 25.4
        if length > 0.0 and extent > 0.0:
            found.append(length / extent)
    # preserveAspectRatio: the drawing fits into both sides.
    return min(found) if found else None


def _paths(root: ElementTree.Element) -> tuple[list[Path], float | None]:
    """Return the paths in the root's coordinates, the likely one first, and the axis if drawn."""
    # Imported late: only this reader needs it.
    from svgelements import SVG, Shape

    for name in ("width", "height", "viewBox", "preserveAspectRatio"):
        # What the root's own box does to coordinates is computed here, exactly.
        root.attrib.pop(name, None)
    _check_numbers(root)
    text = io.StringIO(ElementTree.tostring(root, encoding="unicode"))
    try:
        drawing = SVG.parse(text, reify=True, ppi=96.0)
        shapes = [shape for shape in drawing.elements() if isinstance(shape, Shape)]
    except RecursionError:
        raise SourceError(NoSource.USES_ITSELF) from None
    except (ValueError, TypeError, AttributeError, KeyError, ZeroDivisionError) as error:
        raise SourceError(Unreadable("SVG", str(error))) from None
    named: dict[str, list[Piece]] = {}
    total = 0
    for shape in shapes:
        if shape.values.get("visibility") in ("hidden", "collapse"):
            continue
        name = str(shape.id or "")
        for run in _runs(shape):
            total += len(run)
            if total > _MOST_PIECES:
                raise SourceError(TooMuch("lines and curves", _MOST_PIECES))
            key = name if name in (_GENERATRIX, _AXIS) else ""
            named.setdefault(key, []).extend(run)
    axis = upright_line(named.pop(_AXIS, []))
    if _GENERATRIX in named:
        return _joined(named[_GENERATRIX], _GENERATRIX), axis
    if "" not in named:
        raise SourceError(NoSource.NO_PATH)
    return _joined(named[""], ""), axis


def _check_numbers(root: ElementTree.Element) -> None:
    """Refuse more numbers than the pieces that are read can have, before all are parsed."""
    count = 0
    for element in root.iter():
        for name in ("d", "points"):
            count += len(_NUMBER.findall(element.get(name, "")))
        if count > _MOST_NUMBERS * _MOST_PIECES:
            raise SourceError(TooMuch("lines and curves", _MOST_PIECES))


def _own_path(root: ElementTree.Element) -> Path | None:
    """Return the quartics that this program writes beside its path, in the path's coordinates."""
    for element in root.iter():
        text = element.get(_QUARTICS)
        if text is not None and element.get("id") == _GENERATRIX:
            try:
                numbers = [float(word) for word in re.split(r"[\s,;]+", text.strip())]
                points = np.array(numbers).reshape(-1, 5, 2)
            except ValueError:
                return None
            if not len(points) or not np.isfinite(points).all():
                return None
            pieces = tuple(Bezier(quartic * np.array([1.0, -1.0])) for quartic in points)
            return Path(pieces, element.get("d", "").rstrip().endswith("Z"), _GENERATRIX)
    return None


def _agree(own: Path, drawn: Path) -> bool:
    """Whether quartics are still what is drawn: another program may have changed the path."""
    segments = [piece.segments() for piece in own.pieces]
    if any(found is None for found in segments):
        return False
    profile = Profile.of([segment for found in segments if found for segment in found])
    if max(map(len, (own.pieces, drawn.pieces))) > _MOST_OWN:
        return False
    return float(distances(profile, drawn.sampled(_LOOKS)).max()) <= _ALIKE * profile.size


def _joined(pieces: list[Piece], name: str) -> list[Path]:
    ends = np.concatenate([piece.ends for piece in pieces])
    size = float(np.hypot(*np.ptp(ends, axis=0)))
    return chained(pieces, _JOINED * size, name)


def _runs(shape: Any) -> Iterator[list[Piece]]:
    """Yield the subpaths of a shape as pieces."""
    # Imported late: only this reader needs it.
    from svgelements import Arc as SvgArc
    from svgelements import Close, CubicBezier, Line, Move, QuadraticBezier
    from svgelements import Path as SvgPath

    run: list[Piece] = []
    for part in SvgPath(shape).segments():
        if isinstance(part, Move):
            if run:
                yield run
            run = []
            continue
        start, end = _place(part.start), _place(part.end)
        if isinstance(part, CubicBezier):
            inner = [_place(part.control1), _place(part.control2)]
        elif isinstance(part, QuadraticBezier):
            inner = [_place(part.control)]
        elif isinstance(part, SvgArc):
            if not are_places(np.array([start, end, _place(part.center)])):
                raise SourceError(NoSource.NOT_FINITE)
            run.append(_arc(part))
            continue
        elif isinstance(part, Line | Close):
            inner = []
        else:
            continue
        points = np.array([start, *inner, end])
        if not are_places(points):
            raise SourceError(NoSource.NOT_FINITE)
        if np.ptp(points, axis=0).any():
            run.append(Bezier(points))
    if run:
        yield run


def _arc(part: Any) -> Arc:
    """Return an elliptical arc: its conjugate half diameters and the parameters of its ends."""
    center = _place(part.center)
    frame = np.column_stack([_place(part.prx) - center, _place(part.pry) - center])
    start = np.linalg.solve(frame, _place(part.start) - center)
    first = float(np.arctan2(start[1], start[0]))
    # The sweep counts from prx towards pry.
    sweep = float(part.sweep)
    if np.linalg.det(frame) < 0.0:
        sweep = -sweep
    return Arc(center, frame, first, first + sweep)


def _place(point: Any) -> Floats:
    return np.array([float(point.x), float(point.y)])
