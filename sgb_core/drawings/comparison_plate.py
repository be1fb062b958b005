"""A plate of curves on one polygon: the SG-Bézier, cubic, quartic and rational cubic."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.design.comparison import Compared, Kind, compared
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

WIDTH, _TALLEST = 175.0, 200.0
_MARGIN, _BETWEEN, _TEXT, _LINE = 3.0, 7.0, 2.2, 4.0
_GREY = "#8a8f94"
_CURVE, _OTHER, _POLYGON = Pen(0.4), Pen(0.2, (1.2, 0.8)), Pen(0.18, colour=_GREY)
_NAMES = {
    Kind.SG: "SG-Bézier",
    Kind.CUBIC: "plain cubic",
    Kind.QUARTIC: "quartic, ω = 1",
    Kind.RATIONAL: "rational cubic",
}


def comparison_plate(document: Document, found: Sequence[Compared] | None = None) -> Drawing:
    """Return the plate, each panel with its energy and how far it is from the SG-Bézier.

    ``found`` is what :func:`compared` gives for the profile, where it has been made already.
    Raises DrawingError for a profile that is a point.
    """
    profile = document.surface.shape_at(document.surface.start)
    if profile.size == 0.0:
        raise DrawingError(NoDrawing.POINT)
    curves = compared(profile) if found is None else found
    polygons = profile.control_points
    places = np.concatenate([polygons.reshape(-1, 2), curves[0].points.reshape(-1, 2)])
    low, high = places.min(axis=0), places.max(axis=0)
    low[0], high[0] = min(0.0, float(low[0])), max(0.0, float(high[0]))
    room = (WIDTH - 2.0 * _MARGIN - 3.0 * _BETWEEN) / len(curves)
    size = np.maximum(high - low, 1e-12 * profile.size)
    scale = float(min(room / size[0], _TALLEST / size[1]))
    below = 4.0 * _LINE + 2.0
    height = 2.0 * _MARGIN + below + scale * float(size[1])
    made: list[Mark] = []
    for number, each in enumerate(curves):
        left = _MARGIN + number * (room + _BETWEEN) + 0.5 * (room - scale * float(size[0]))
        origin = np.array([left, _MARGIN + below]) - scale * low

        def path(points: Floats, origin: Floats = origin) -> Path:
            return Path.through([(x, y) for x, y in (points * scale + origin).tolist()])

        top, foot = float(origin[1] + scale * high[1]), float(origin[1] + scale * low[1])
        axis = Path.through(((float(origin[0]), foot), (float(origin[0]), top)))
        made.append(Stroke.of(Layer.AXIS, axis, pen=Pen(0.18, CENTRE_DASHES)))
        made.append(Stroke.of(Layer.EDGES, *map(path, polygons), pen=_POLYGON))
        if each.kind is not Kind.SG:
            made.append(Stroke.of(Layer.EDGES, *map(path, curves[0].points), pen=_OTHER))
        made.append(Stroke.of(Layer.OUTLINE, *map(path, each.points), pen=_CURVE))
        middle = _MARGIN + number * (room + _BETWEEN) + 0.5 * room
        level = _MARGIN + below - 2.0 - _TEXT
        for line in _lines("abcd"[number], each, str(document.unit)):
            words = fonts.fitted(line, _TEXT, room + _BETWEEN - 2.0)
            made.append(Words(words, (middle, level), _TEXT, Anchor.MIDDLE))
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


def _subject(curves: Sequence[Compared], unit: str) -> str:
    """Return all energies and deviations in one line."""
    parts = []
    for each in curves:
        energy = "unbounded" if each.energy is None else f"{each.energy:.4g}/{unit}"
        away = "" if each.kind is Kind.SG else f", up to {each.deviation:.3g} {unit} off"
        parts.append(f"{_NAMES[each.kind]} {energy}{away}")
    return f"Curves on one control polygon, their ∫κ² dl and deviations: {'; '.join(parts)}"


def _lines(label: str, each: Compared, unit: str) -> list[str]:
    energy = " unbounded" if each.energy is None else f" = {each.energy:.4g}/{unit}"
    lines = [f"{label}  {_NAMES[each.kind]}", f"∫κ² dl{energy}"]
    if each.kind is not Kind.SG:
        lines.append(f"up to {each.deviation:.3g} {unit} off")
    if len(each.weights) == 1:
        first, last = each.weights[0]
        lines.append(f"weights 1, {first:.3f}, {last:.3f}, 1")
    return lines
