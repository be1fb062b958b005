"""Edits of the patterns of holes that are cut through a vessel's wall."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace

from sgb_core.bodies.cut_outs import CutOut, HoleShape
from sgb_core.document.edits.checks import changed, checked, member
from sgb_core.document.edits.pictures import with_picture, without_unused_pictures
from sgb_core.document.errors import EditError
from sgb_core.document.model import Document
from sgb_core.fields.record import table_of
from sgb_core.findings.edits import NoSuch
from sgb_core.lettering.fonts import FontName

# Of the object's size: the holes, margins and bridge of a pattern that nothing is said of.
_HOLE, _MARGIN, _BRIDGE, _PICTURE = 0.06, 0.08, 0.015, 0.3
# Rows, and how many in each, of what is drawn.
_NUMBERS = {HoleShape.TEXT: (1, 2), HoleShape.PICTURE: (1, 3)}


def set_cut_outs(document: Document, cut_outs: Iterable[CutOut]) -> Document:
    """Set all patterns of holes. Raises EditError for more than a project keeps.

    >>> tube = sgb.Document(sgb.Profile.of([sgb.line((20, 0), (20, 60))]))
    >>> cup = sgb.edits.set_solid(tube, kind="vessel", wall=3, base=4)
    >>> lantern = sgb.edits.set_cut_outs(cup, [sgb.CutOut(rows=2, around=9, width=8)])
    >>> lantern.body().pierced[0]
    18
    """
    wanted = tuple(cut_outs)
    if wanted == document.cut_outs:
        return document
    return without_unused_pictures(checked(lambda: replace(document, cut_outs=wanted)))


def set_cut_out(
    document: Document,
    number: int = 0,
    *,
    shape: HoleShape | str | None = None,
    width: float | None = None,
    height: float | None = None,
    rows: int | None = None,
    around: int | None = None,
    stagger: bool | None = None,
    foot_margin: float | None = None,
    rim_margin: float | None = None,
    bridge: float | None = None,
    text: str | None = None,
    font: FontName | str | None = None,
    picture: str | None = None,
    threshold: float | None = None,
) -> Document:
    """Change a pattern; the number after the last adds one as large as suits the object.

    What is None stays as it is; lengths are in the unit. A shape that is drawn in place of one
    that is drilled, or the other way round, comes in the number and size that suit it. Raises
    EditError for a value that is not allowed, and for a pattern there is not.

    >>> tube = sgb.Document(sgb.Profile.of([sgb.line((20, 0), (20, 60))]))
    >>> [round(each.width, 2) for each in sgb.edits.set_cut_out(tube, shape="hexagon").cut_outs]
    [3.6]
    """
    if not 0 <= number <= len(document.cut_outs):
        raise EditError(NoSuch("pattern", number, len(document.cut_outs)))
    patterns = list(document.cut_outs)
    wanted = None if shape is None else member(shape, HoleShape, "shape")
    if number == len(patterns):
        patterns.append(usual_cut_out(document, wanted or HoleShape.CIRCLE))
    old = patterns[number]
    if wanted is not None and wanted.is_drawn is not old.shape.is_drawn:
        usual = usual_cut_out(document, wanted)
        old = replace(
            old, width=usual.width, height=usual.height, rows=usual.rows, around=usual.around
        )
    patterns[number] = changed(
        old,
        shape=wanted,
        width=width,
        height=height,
        rows=rows,
        around=around,
        stagger=stagger,
        foot_margin=foot_margin,
        rim_margin=rim_margin,
        bridge=bridge,
        text=text,
        font=font,
        picture=picture,
        threshold=threshold,
    )
    return set_cut_outs(document, patterns)


def remove_cut_out(document: Document, number: int) -> Document:
    """Remove a pattern of holes. Raises EditError for one there is not."""
    if not 0 <= number < len(document.cut_outs):
        raise EditError(NoSuch("pattern", number, len(document.cut_outs)))
    patterns = list(document.cut_outs)
    del patterns[number]
    return set_cut_outs(document, patterns)


def cut_out_picture(document: Document, data: bytes, number: int = 0) -> Document:
    """Cut the dark parts of a picture of the user's, a PNG or JPEG file's bytes, by a pattern.

    It is kept inside the project. Raises EditError for bytes that are no picture, for more
    pictures than a project keeps, and for a pattern there is not.
    """
    kept, name = with_picture(document, data)
    return set_cut_out(kept, number, shape=HoleShape.PICTURE, picture=name)


def usual_cut_out(document: Document, shape: HoleShape = HoleShape.CIRCLE) -> CutOut:
    """Return a pattern whose lengths and numbers suit its shape and the size of the object."""
    size = document.profile.size or 1.0
    hole, margin = _rounded(_HOLE * size), _rounded(_MARGIN * size)
    rows, around = _NUMBERS.get(shape, (CutOut().rows, CutOut().around))
    return CutOut(
        shape=shape,
        width=_rounded(_PICTURE * size) if shape.is_drawn else hole,
        height=_rounded(2.0 * _HOLE * size),
        rows=rows,
        around=around,
        foot_margin=margin,
        rim_margin=margin,
        bridge=_rounded(_BRIDGE * size),
    )


def enlarged_cut_outs(document: Document, factor: float) -> Document:
    """Return the document with its holes ``factor`` times as large."""
    names = [row.name for row in table_of(CutOut).lengths]
    sized = [
        replace(each, **{name: getattr(each, name) * factor for name in names})
        for each in document.cut_outs
    ]
    return set_cut_outs(document, sized)


def _rounded(length: float) -> float:
    """Return a length to two digits, as one would choose it."""
    return float(f"{length:.2g}")
