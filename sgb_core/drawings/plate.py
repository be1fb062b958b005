"""The vessel plate: sections and outsides of vessels on one page, all at one scale.

As archaeologists publish them: the section on one side of a thin axis, the outside with its edges
and painted bands on the other, the rim line over both, number and measures below, a scale bar.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import floor, log10

from sgb_core.bodies.solid import BodyKind
from sgb_core.design.locks.dimension import Dimension, DimensionKind
from sgb_core.document.appearance.relief import relief_of
from sgb_core.document.dimensions import dimension_value
from sgb_core.document.model import Document
from sgb_core.drawings import fonts, marks
from sgb_core.drawings.dimensioning import as_at_start
from sgb_core.drawings.errors import DrawingError
from sgb_core.drawings.half_view import HalfView, half_view
from sgb_core.drawings.page import Anchor, Layer, Mark, Page, Pen, Words
from sgb_core.drawings.paint import Painted, paint_of
from sgb_core.drawings.paint_marks import paint_marks
from sgb_core.drawings.scales import PLATES, Paper, Scale, Sheet, scales_to_try, sheets_of
from sgb_core.drawings.uncertainty import volume_uncertainty
from sgb_core.drawings.view_marks import ViewLook, view_marks
from sgb_core.drawings.wanted import Fill, Wanted
from sgb_core.findings.drawings import DoesNotFit
from sgb_core.surfaces.measures import largest_diameter
from sgb_core.values import dataclass

TOLERANCE = 0.001
MARGINS = (15.0, 15.0, 15.0, 15.0)
# In mm: between vessels, from a vessel to its number, the number's height, that of the measures
# and from line to line, the room of the scale bar, and its greatest length.
_BETWEEN, _BELOW, _NUMBER, _MEASURE, _LINE = 10.0, 4.0, 3.5, 2.2, 4.0
_BAR_ROOM, _BAR = 12.0, 60.0
_OUTLINE, _AXIS = Pen(0.4), Pen(0.18)


@dataclass(frozen=True, slots=True, eq=False)
class _Vessel:
    """A vessel to be placed: its halves, its paint, and the lines below it."""

    view: HalfView
    paint: tuple[Painted, ...]
    lines: tuple[str, ...]

    def width(self, factor: float) -> float:
        words = max(fonts.width(line, _MEASURE) for line in self.lines)
        return max(2.0 * self.view.reach * factor, words)

    def height(self, factor: float) -> float:
        below = _BELOW + _NUMBER + _LINE * (len(self.lines) - 1) + 0.5 * _MEASURE
        return self.view.height * factor + below


def plate_page(documents: Sequence[Document], wanted: Wanted) -> tuple[Page, str]:
    """Return the page of vessels, and the scale and the sheet in words.

    Raises DrawingError where the chosen scale does not fit the chosen paper, SolidError where
    there is no body.
    """
    coarse = [_vessel(document, wanted, number) for number, document in enumerate(documents)]
    sheet, scale, rows = _fitting(coarse, wanted)
    factor = scale.factor
    within = TOLERANCE / factor
    fine = [_vessel(each, wanted, number, within) for number, each in enumerate(documents)]
    drawn: list[Mark] = []
    origins: list[tuple[float, float]] = []
    width, height = sheet.size
    room = height - MARGINS[2] - MARGINS[3] - _BAR_ROOM
    tall = [max(fine[k].height(factor) for k in row) for row in rows]
    gap = (room - sum(tall)) / (len(rows) + 1)
    top = height - MARGINS[3]
    for row, high in zip(rows, tall, strict=True):
        top -= gap
        wide = [fine[k].width(factor) for k in row]
        free = (width - MARGINS[0] - MARGINS[1] - sum(wide)) / (len(row) + 1)
        left = MARGINS[0] + free
        for number, across in zip(row, wide, strict=True):
            vessel = fine[number]
            base = top - high + vessel.height(factor) - vessel.view.height * factor
            origin = (left + 0.5 * across, base - vessel.view.low * factor)
            origins.append(origin)
            drawn += _drawn(vessel, origin, factor, wanted)
            left += across + free
        top -= high
    drawn += _bar(sheet, scale)
    page = Page(width, height, MARGINS, tuple(drawn), factor, origins[0])
    return page, f"{scale} on {sheet}"


def _vessel(
    document: Document, wanted: Wanted, number: int, tolerance: float | None = None
) -> _Vessel:
    size = document.profile.size * document.unit.millimetres
    view = half_view(document, 1e-4 * size if tolerance is None else tolerance, wanted.mirror)
    lines = (str(wanted.first + number), *measure_lines(document, view))
    return _Vessel(view, paint_of(document), lines)


def measure_lines(document: Document, view: HalfView) -> tuple[str, ...]:
    """Return the measures that stand under a vessel: rim and height in cm, what it holds."""
    unit = document.unit.millimetres
    rim = dimension_value(as_at_start(document), Dimension(DimensionKind.RIM_DIAMETER))
    sizes = [f"H {_centimetres(view.height)} cm"]
    if document.variation:
        sizes.insert(0, f"greatest ⌀ {_centimetres(largest_diameter(document) * unit)} cm")
    if rim is not None and rim > 1e-9 * document.profile.size:
        sizes.insert(0, f"rim ⌀ {_centimetres(rim * unit)} cm")
    if relief_of(document.appearance) is not None:
        sizes.append("without its relief")
    holds = capacity_words(document)
    return (", ".join(sizes), *((holds,) if holds else ()))


def _centimetres(millimetres: float) -> str:
    digits = 2 if millimetres >= 1.0 else 4
    return f"{millimetres / 10.0:.{digits}f}".rstrip("0").rstrip(".")


def capacity_words(document: Document) -> str:
    """Return what a vessel holds, with the uncertainty where it was traced; empty for none."""
    if document.solid.kind is BodyKind.VESSEL:
        value = dimension_value(document, Dimension(DimensionKind.CAPACITY))
    elif document.profile.closed:
        value = None
    else:
        value = document.volume
    if value is None:
        return ""
    unit = document.unit.millilitres
    litres = value * unit >= 1000.0
    part, name = (unit / 1000.0, "l") if litres else (unit, "ml")
    known = volume_uncertainty(document, value)
    if known is None or known <= 0.0:
        return f"{value * part:.{2 if litres else 0}f} {name}"
    # The uncertainty has two digits, the volume as many places as it.
    places = min(max(0, 1 - floor(log10(known * part))), 6)
    return f"{value * part:.{places}f} ± {known * part:.{places}f} {name}"


def _fitting(vessels: Sequence[_Vessel], wanted: Wanted) -> tuple[Sheet, Scale, list[list[int]]]:
    """Return the sheet, the largest scale and the rows that fit; raises DrawingError for none."""
    paper = wanted.paper or Paper.A4
    largest = max(max(each.view.height, 2.0 * each.view.reach) for each in vessels)
    scales = (wanted.scale,) if wanted.scale else scales_to_try(PLATES, largest)
    upright, lying = sorted(sheets_of(paper), key=lambda sheet: sheet.lying)
    for scale in scales:
        for sheet in (upright, lying):
            rows = _rows(vessels, scale.factor, sheet)
            if rows is not None:
                return sheet, scale, rows
    factor = scales[-1].factor
    needed = (
        max(each.width(factor) for each in vessels),
        max(each.height(factor) for each in vessels),
    )
    room = (
        upright.size[0] - MARGINS[0] - MARGINS[1],
        upright.size[1] - MARGINS[2] - MARGINS[3] - _BAR_ROOM,
    )
    raise DrawingError(DoesNotFit(str(scales[-1]), str(upright), needed, room))


def _rows(vessels: Sequence[_Vessel], factor: float, sheet: Sheet) -> list[list[int]] | None:
    """Return the vessels row by row in their order; None where they do not fit."""
    width = sheet.size[0] - MARGINS[0] - MARGINS[1]
    height = sheet.size[1] - MARGINS[2] - MARGINS[3] - _BAR_ROOM
    rows: list[list[int]] = []
    used = 0.0
    for number, vessel in enumerate(vessels):
        wide = vessel.width(factor)
        if wide > width:
            return None
        if rows and used + _BETWEEN + wide <= width:
            rows[-1].append(number)
            used += _BETWEEN + wide
        else:
            rows.append([number])
            used = wide
    tall = sum(max(vessels[k].height(factor) for k in row) for row in rows)
    return rows if tall + _BETWEEN * (len(rows) - 1) <= height else None


def _drawn(
    vessel: _Vessel, origin: tuple[float, float], factor: float, wanted: Wanted
) -> list[Mark]:
    view, (x, y) = vessel.view, origin
    fill = wanted.fill or Fill.FILLED
    made: list[Mark] = []
    for painted in vessel.paint:
        made += paint_marks(painted, view, origin, factor, wanted.mirror)
    look = ViewLook(_OUTLINE, _AXIS, fill, spacing=1.0)
    made += view_marks(view, origin, factor, wanted.mirror, look)
    level = y + view.low * factor - _BELOW - _NUMBER
    made.append(Words(vessel.lines[0], (x, level), _NUMBER, Anchor.MIDDLE))
    for line in vessel.lines[1:]:
        level -= _LINE
        made.append(Words(line, (x, level), _MEASURE, Anchor.MIDDLE))
    return made


def _bar(sheet: Sheet, scale: Scale) -> list[Mark]:
    """Return the scale bar in the middle below: a round length of at most 60 mm of paper."""
    most = _BAR / scale.factor
    power = 10.0 ** floor(log10(most))
    length = next(digit * power for digit in (5.0, 2.0, 1.0) if digit * power <= most)
    words = f"{length / 10.0:g} cm" if length >= 10.0 else f"{length:g} mm"
    left = 0.5 * (sheet.size[0] - length * scale.factor)
    bar = marks.scale_bar((left, MARGINS[2] + 0.5), length, 5, scale.factor, words)
    clear = 0.5 * fonts.width(words, marks.BAR_WORDS) + 2.0
    beside = (left + length * scale.factor + clear, MARGINS[2] + 1.0)
    return [*bar, Words(str(scale), beside, _MEASURE, layer=Layer.SCALE)]
