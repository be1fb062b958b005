"""A plate of curves on one polygon, the SG-Bézier, cubic, quartic and rational, and the fairest."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.design.comparison import Compared, Kind, compared
from sgb_core.document.best_curves import best_curves
from sgb_core.document.model import Document
from sgb_core.drawings import fonts
from sgb_core.drawings.errors import DrawingError
from sgb_core.drawings.page import (
    CENTRE_DASHES,
    Anchor,
    Drawing,
    Layer,
    Mark,
    Page,
    Path,
    Pen,
    Stroke,
    Words,
)
from sgb_core.findings.drawings import NoDrawing
from sgb_core.findings.fairing import named
from sgb_core.findings.words import say

WIDTH, _TALLEST = 175.0, 105.0
_MARGIN, _BETWEEN, _TEXT, _LINE = 3.0, 7.0, 2.2, 4.0
_COLUMNS = 4
# Room for the lines under a panel.
_BELOW = 4.0 * _LINE + 2.0
_GREY = "#8a8f94"
_CURVE, _OTHER, _POLYGON = Pen(0.4), Pen(0.2, (1.2, 0.8)), Pen(0.18, colour=_GREY)
_NAMES = {
    Kind.SG: "SG-Bézier",
    Kind.CUBIC: "plain cubic",
    Kind.QUARTIC: "quartic, ω = 1",
    Kind.RATIONAL: "rational cubic",
    Kind.FAIREST: "SG-Bézier, fairest",
    Kind.FREED: "SG-Bézier, slid",
    Kind.BEST_CUBIC: "best plain cubic",
    Kind.BEST_QUARTIC: "best quartic",
}


def comparison_plate(document: Document, found: Sequence[Compared] | None = None) -> Drawing:
    """Return the plate, each panel with its energy and how far it is from the SG-Bézier.

    Above are the curves on the same points, below the fairest of four kinds: by the shape alone,
    and with points slid along the tangents. ``found`` is what :func:`all_curves` gives, where it
    has been made already. Raises DrawingError for a profile that is a point.
    """
    profile = document.surface.shape_at(document.surface.start)
    if profile.size == 0.0:
        raise DrawingError(NoDrawing.POINT)
    curves = all_curves(document) if found is None else found
    places = np.concatenate(
        [part.reshape(-1, 2) for each in curves for part in (each.points, each.polygons)]
    )
    low, high = places.min(axis=0), places.max(axis=0)
    low[0], high[0] = min(0.0, float(low[0])), max(0.0, float(high[0]))
    room = (WIDTH - 2.0 * _MARGIN - (_COLUMNS - 1) * _BETWEEN) / _COLUMNS
    size = np.maximum(high - low, 1e-12 * profile.size)
    scale = float(min(room / size[0], _TALLEST / size[1]))
    tall = scale * float(size[1])
    rows = -(-len(curves) // _COLUMNS)
    height = 2.0 * _MARGIN + rows * (_BELOW + tall) + (rows - 1) * _BETWEEN
    made: list[Mark] = []
    for number, each in enumerate(curves):
        row, column = divmod(number, _COLUMNS)
        left = _MARGIN + column * (room + _BETWEEN)
        base = _MARGIN + (rows - 1 - row) * (_BELOW + tall + _BETWEEN) + _BELOW
        shift = np.array([left + 0.5 * (room - scale * float(size[0])), base]) - scale * low

        def path(points: Floats, shift: Floats = shift) -> Path:
            return Path.through([(x, y) for x, y in (points * scale + shift).tolist()])

        axis = Path.through(((float(shift[0]), base), (float(shift[0]), base + tall)))
        made.append(Stroke.of(Layer.AXIS, axis, pen=Pen(0.18, CENTRE_DASHES)))
        made.append(Stroke.of(Layer.EDGES, *map(path, each.polygons), pen=_POLYGON))
        if each.kind is not Kind.SG:
            made.append(Stroke.of(Layer.EDGES, *map(path, curves[0].points), pen=_OTHER))
        made.append(Stroke.of(Layer.OUTLINE, *map(path, each.points), pen=_CURVE))
        level = base - 2.0 - _TEXT
        for line in _lines("abcdefgh"[number], each, str(document.unit)):
            words = fonts.fitted(line, _TEXT, room + _BETWEEN - 2.0)
            made.append(Words(words, (left + 0.5 * room, level), _TEXT, Anchor.MIDDLE))
            level -= _LINE
    page = Page(WIDTH, height, (0.5,) * 4, tuple(made))
    return Drawing(
        (page,),
        document.name,
        _subject(curves, str(document.unit)),
        0.01,
        "",
        ("comparison", "SGB Studio"),
    )


def all_curves(document: Document) -> tuple[Compared, ...]:
    """Return the curves on the document's points, then the fairest between its joints."""
    on_points = compared(document.surface.shape_at(document.surface.start))
    return (*on_points, *best_curves(document))


def _subject(curves: Sequence[Compared], unit: str) -> str:
    """Return all energies and deviations in one line."""
    parts = []
    for each in curves:
        if each.missed is not None:
            parts.append(f"{_NAMES[each.kind]}: {say(each.missed)}")
            continue
        energy = "unbounded" if each.energy is None else f"{each.energy:.4g}/{unit}"
        away = "" if each.kind is Kind.SG else f", up to {each.deviation:.3g} {unit} off"
        parts.append(f"{_NAMES[each.kind]} {energy}{away}")
    first, then = "; ".join(parts[:_COLUMNS]), "; ".join(parts[_COLUMNS:])
    fairest = f". The fairest, and with points slid along the tangents: {then}" if then else ""
    return f"Curves on one control polygon, their ∫κ² dl and deviations: {first}{fairest}"


def _lines(label: str, each: Compared, unit: str) -> list[str]:
    if each.missed is not None:
        return [f"{label}  {_NAMES[each.kind]}", "cannot keep", named(each.missed)]
    energy = " unbounded" if each.energy is None else f" = {each.energy:.4g}/{unit}"
    lines = [f"{label}  {_NAMES[each.kind]}", f"∫κ² dl{energy}"]
    if each.kind is not Kind.SG:
        lines.append(f"up to {each.deviation:.3g} {unit} off")
    if len(each.weights) == 1:
        first, last = each.weights[0]
        lines.append(f"weights 1, {first:.3f}, {last:.3f}, 1")
    return lines
