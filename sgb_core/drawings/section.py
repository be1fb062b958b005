"""The dimensioned section: half section with hatching, half view, centre line, title block."""

from __future__ import annotations

from dataclasses import replace

from sgb_core.bodies.solid import BodyKind, Rim
from sgb_core.document.model import Document
from sgb_core.drawings import fonts, marks
from sgb_core.drawings.dimensioning import (
    Across,
    Dimensions,
    Note,
    Upright,
    drawn_dimensions,
    held,
    number_words,
)
from sgb_core.drawings.errors import DrawingError
from sgb_core.drawings.half_view import HalfView, half_view
from sgb_core.drawings.notes import column_places, note_marks
from sgb_core.drawings.outermost import outermost
from sgb_core.drawings.page import PENS, Anchor, Layer, Mark, Page, Words
from sgb_core.drawings.relief_words import relief_words
from sgb_core.drawings.scales import (
    TRUE_SIZE,
    WORKSHOP,
    Paper,
    Scale,
    Sheet,
    scales_to_try,
    sheets_of,
)
from sgb_core.drawings.title_block import MARGINS, Cell, block_height, frame, title_block
from sgb_core.drawings.view_marks import ViewLook, view_marks
from sgb_core.drawings.wanted import Fill, Wanted
from sgb_core.findings.drawings import DoesNotFit
from sgb_core.surfaces.measures import largest_diameter
from sgb_core.values import dataclass

# On paper, in mm: how near curves are, how far the first dimension line is from the shape and
# the next from it, and what is left free around all.
TOLERANCE = 0.001
_FIRST, _NEXT, _FREE = 10.0, 7.5, 4.0
_COLUMN, _AXIS_BEYOND = 10.0, 4.0
# Of the size: a body that reaches beyond the drawn profile does so by more than curves are off.
_BEYOND = 1e-4
# In units of the document: a difference that numbers show.
_SHOWN = 0.005
# Papers in the order in which they are tried, and the smallest scale with which one is content.
_PAPERS = (Paper.A4, Paper.A3, Paper.A2, Paper.A1)
_CONTENT = 0.5


@dataclass(frozen=True, slots=True)
class _Plan:
    """What stands around the view at a scale: how far each side reaches from (axis, h = 0)."""

    scale: Scale
    text: float
    left: float
    right: float
    low: float
    high: float
    column: float

    @property
    def size(self) -> tuple[float, float]:
        """Width and height of all of it."""
        return self.left + self.right, self.high - self.low


def section_page(document: Document, wanted: Wanted) -> tuple[Page, str]:
    """Return the page of a document, and the scale and the sheet in words.

    Raises DrawingError where the chosen scale does not fit the chosen paper, SolidError where
    there is no body.
    """
    size = document.profile.size * document.unit.millimetres
    # As fine as numbers are shown, whatever the scale will be.
    sized = half_view(document, min(TOLERANCE, _BEYOND * size), wanted.mirror)
    found = _with_overall(document, sized, drawn_dimensions(document))
    rows = _rows(document, found, None, "", wanted)
    remarks = _remarks(document)
    taken = block_height(rows) + 5.0 * len(remarks) + _FREE
    sheet, plan = _fitting(sized, found, wanted, taken)
    factor = plan.scale.factor
    view = half_view(document, TOLERANCE / factor, wanted.mirror)
    width, height = sheet.size
    room_x, room_y = _room(sheet, taken)
    origin = (
        MARGINS[0] + 0.5 * (room_x - plan.size[0]) + plan.left,
        MARGINS[2] + taken + 0.5 * (room_y - plan.size[1]) - plan.low,
    )
    drawn: list[Mark] = [frame(sheet.size)]
    look = ViewLook(
        PENS[Layer.OUTLINE], PENS[Layer.AXIS], wanted.fill or Fill.HATCHED, _AXIS_BEYOND
    )
    drawn += view_marks(view, origin, factor, wanted.mirror, look)
    drawn += _dimension_marks(view, found, plan, origin, wanted.mirror)
    drawn += title_block(sheet.size, _rows(document, found, plan, str(sheet.paper), wanted))
    for number, remark in enumerate(remarks):
        at = (MARGINS[0] + 2.0, MARGINS[2] + block_height(rows) + 2.0 + 5.0 * number)
        room = width - MARGINS[0] - MARGINS[1] - 4.0
        drawn.append(Words(fonts.fitted(remark, 2.5, room), at, 2.5))
    page = Page(width, height, MARGINS, tuple(drawn), factor, origin)
    return page, f"{plan.scale} on {sheet}"


def _with_overall(document: Document, view: HalfView, found: Dimensions) -> Dimensions:
    """Add what the body measures over all where it reaches beyond the drawn profile."""
    if any(each.is_number for each in document.dimensions):
        return found
    unit = document.unit.millimetres
    low, high = (corner * unit for corner in document.profile.bounds())
    slack = _BEYOND * document.profile.size * unit
    across, upright = [_as_rounded(document, view, each) for each in found.across], [*found.upright]
    if view.height > float(high[1] - low[1]) + slack:
        words = number_words(view.height / unit, document.unit)
        upright.append(Upright(words, (0.0, view.low), (0.0, view.high)))
    if document.variation:
        return replace(found, upright=tuple(upright))
    if view.reach > max(float(high[0]), -float(low[0])) + slack:
        across.append(_diameter(document, view.reach, 0.5 * (view.low + view.high)))
    foot = view.foot
    if foot is not None and all(abs(foot - each.r) > slack for each in across):
        # A profile that is closed to the axis has no foot diameter; what it stands on has one.
        across.append(_diameter(document, foot, view.low))
    return replace(found, across=tuple(across), upright=tuple(upright))


def _as_rounded(document: Document, view: HalfView, drawn: Across) -> Across:
    """Return a diameter of the drawn profile as the body has it: a round rim takes some away."""
    solid = document.solid
    if solid.kind is not BodyKind.VESSEL or solid.rim is not Rim.ROUND or document.variation:
        return drawn
    unit = document.unit.millimetres
    wall = solid.wall * unit
    lines = [path for part in view.material for path in part]
    found = outermost(lines, drawn.h - wall, drawn.h + wall)
    if found is None or found[0] >= drawn.r - _SHOWN * unit:
        return drawn
    return _diameter(document, *found)


def _diameter(document: Document, r: float, h: float) -> Across:
    words = number_words(2.0 * r / document.unit.millimetres, document.unit)
    return Across(f"⌀{words}", r, h)


def _room(sheet: Sheet, taken: float) -> tuple[float, float]:
    left, right, bottom, top = MARGINS
    return sheet.size[0] - left - right, sheet.size[1] - bottom - top - taken


def _fitting(
    view: HalfView, found: Dimensions, wanted: Wanted, taken: float
) -> tuple[Sheet, _Plan]:
    """Return the first paper and the largest scale that fit; raises DrawingError for none."""
    papers = _PAPERS if wanted.paper is None else (wanted.paper,)
    scales = scales_to_try(WORKSHOP, max(view.height, 2.0 * view.reach))
    if wanted.scale is not None:
        scales = (wanted.scale,)
    best: tuple[Sheet, _Plan] | None = None
    for paper in papers:
        for scale in scales:
            for sheet in sheets_of(paper):
                plan = _plan(view, found, scale, sheet, wanted.mirror)
                room = _room(sheet, taken)
                if plan.size[0] > room[0] or plan.size[1] > room[1]:
                    continue
                if scale.factor >= _CONTENT or len(papers) == 1:
                    return sheet, plan
                if best is None or scale.factor > best[1].scale.factor:
                    best = sheet, plan
    if best is not None:
        return best
    sheet = sheets_of(papers[-1])[0]
    plan = _plan(view, found, scales[-1], sheet, wanted.mirror)
    raise DrawingError(DoesNotFit(str(plan.scale), str(sheet), plan.size, _room(sheet, taken)))


def _plan(view: HalfView, found: Dimensions, scale: Scale, sheet: Sheet, mirror: float) -> _Plan:
    text = 2.5 if sheet.paper in (Paper.A4, Paper.LETTER) else 3.5
    k = scale.factor
    above, below = _levels(view, found)
    beyond = 0.0
    for group in (above, below):
        for each in group:
            clear = (group[-1].r - each.r) * k
            reach = marks.reach_beyond(2.0 * each.r * k, each.words, text, clear)
            beyond = max(beyond, each.r * k + reach)
    reach = max([view.reach * k, *(abs(r) * k for note in found.notes for r in _radii(note))])
    column = max(reach + _COLUMN, beyond + _FREE if mirror > 0.0 else 0.0)
    widest = max((fonts.width(note.words, text) for note in found.notes), default=-6.0)
    noted = column + widest + _FREE
    count = len(found.upright)
    measured = reach + (_FIRST + _NEXT * (count - 1) + _FREE + text if count else _FREE)
    measured = max(measured, (beyond if mirror < 0.0 else 0.0) + _FREE)
    left, right = (measured, noted) if mirror > 0.0 else (noted, measured)
    right = max(right, beyond + _FREE)
    lengths = [
        marks.reach_beyond((each.high[1] - each.low[1]) * k, each.words, text)
        for each in found.upright
    ]
    over = max([0.0, *lengths])
    step = _NEXT * text / 2.5
    high = view.high * k + max(_FIRST + step * (len(above) - 1) + text, over) + _FREE
    low = view.low * k - (_FIRST + step * (len(below) - 1) if below else _FIRST) - _FREE
    return _Plan(scale, text, left, right, low, high, column)


def _radii(note: Note) -> list[float]:
    return [note.at[0], *(point[0] for point in note.along or ())]


def _levels(view: HalfView, found: Dimensions) -> tuple[list[Across], list[Across]]:
    """Return the diameters measured above the view and those below, the smallest first."""
    middle = 0.5 * (view.low + view.high)
    ordered = sorted(found.across, key=lambda each: each.r)
    above = [each for each in ordered if each.h > middle + 0.25 * view.height]
    return above, [each for each in ordered if each not in above]


def _dimension_marks(
    view: HalfView,
    found: Dimensions,
    plan: _Plan,
    origin: tuple[float, float],
    mirror: float,
) -> list[Mark]:
    k, text = plan.scale.factor, plan.text
    x, y = origin
    step = _NEXT * text / 2.5
    made: list[Mark] = []
    above, below = _levels(view, found)
    for group, start, sign in ((above, view.high, 1.0), (below, view.low, -1.0)):
        for number, each in enumerate(group):
            level = y + start * k + sign * (_FIRST + step * number)
            ends = [(x + side * each.r * k, y + each.h * k) for side in (-1.0, 1.0)]
            clear = (group[-1].r - each.r) * k
            made += marks.level_dimension(ends[0], ends[1], level, each.words, text, clear)
    reach = view.reach * k
    ordered = sorted(found.upright, key=lambda each: each.high[1] - each.low[1])
    for number, upright in enumerate(ordered):
        place = x - mirror * (reach + _FIRST + step * number)
        low, high = ((x - mirror * abs(r) * k, y + h * k) for r, h in (upright.low, upright.high))
        made += marks.upright_dimension(low, high, place, upright.words, text)
    limits = (y + view.low * k - 0.5 * _FIRST, y + view.high * k + 0.5 * _FIRST)
    places, left_out = column_places(found.notes, y, k, text, limits)
    for note, level in places:
        made += note_marks(note, (x, y), k, mirror, plan.column, level, text)
    if left_out:
        words = f"{left_out} more not shown"
        anchor = Anchor.START if mirror > 0.0 else Anchor.END
        at = (x + mirror * plan.column, limits[0] - 2.0 * text)
        made.append(Words(words, at, text, anchor, layer=Layer.DIMENSIONS))
    return made


def _rows(
    document: Document, found: Dimensions, plan: _Plan | None, paper: str, wanted: Wanted
) -> list[list[Cell]]:
    scale = str(TRUE_SIZE if plan is None else plan.scale)
    label, holds = held(document)
    rows = [
        [Cell("Title", document.name, 100.0), Cell("Scale", scale, 30.0), Cell("Sheet", paper, 50)],
        [
            Cell("Dimensions in", str(document.unit), 30.0),
            Cell(label, holds, 45.0),
            Cell("Body", _body_words(document), 55.0),
            Cell("Date", wanted.day or "–", 50.0),
        ],
    ]
    for first in range(0, len(found.listed), 4):
        part = found.listed[first : first + 4]
        rows.append([Cell(name, value, 45.0) for name, value in part])
    return rows


def _body_words(document: Document) -> str:
    solid = document.solid
    if solid.kind is BodyKind.VESSEL:
        return f"vessel, wall {number_words(solid.wall, document.unit)} {solid.side}"
    return "bare surface" if solid.kind is BodyKind.SURFACE else str(solid.kind)


def _remarks(document: Document) -> list[str]:
    """Return what the drawing does not show."""
    found = []
    sweep = document.revolution.sweep_deg
    if sweep < 360.0:
        found.append(f"Part turn of {sweep:g}°; volumes are those of the part")
    if document.variation:
        widest = number_words(largest_diameter(document), document.unit)
        found.append(
            "The section varies around the axis: cut is that at the start angle; the greatest "
            f"diameter is {widest} {document.unit}"
        )
    relief = relief_words(document)
    return [*found, relief] if relief else found
