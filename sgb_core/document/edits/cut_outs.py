"""Edits of the patterns of holes that are cut through a vessel's wall."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace

from sgb_core.bodies.cut_outs import CutOut, HoleShape
from sgb_core.document.edits.checks import changed, checked
from sgb_core.document.model import Document
from sgb_core.fields.record import table_of

# Of the object's size: the holes, margins and bridge of a pattern that nothing is said of.
_HOLE, _MARGIN, _BRIDGE = 0.06, 0.08, 0.02


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
    return checked(lambda: replace(document, cut_outs=wanted))


def set_cut_out(
    document: Document,
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
) -> Document:
    """Change the first pattern; where there is none, one as large as suits the object is added.

    What is None stays as it is; lengths are in the unit. Raises EditError for a value that
    is not allowed.

    >>> tube = sgb.Document(sgb.Profile.of([sgb.line((20, 0), (20, 60))]))
    >>> [round(each.width, 2) for each in sgb.edits.set_cut_out(tube, shape="hexagon").cut_outs]
    [3.6]
    """
    first, *others = document.cut_outs or (usual_cut_out(document),)
    wanted = changed(
        first,
        shape=shape,
        width=width,
        height=height,
        rows=rows,
        around=around,
        stagger=stagger,
        foot_margin=foot_margin,
        rim_margin=rim_margin,
        bridge=bridge,
    )
    return set_cut_outs(document, (wanted, *others))


def usual_cut_out(document: Document) -> CutOut:
    """Return a pattern whose lengths suit the size of the object."""
    size = document.profile.size or 1.0
    hole, margin = _rounded(_HOLE * size), _rounded(_MARGIN * size)
    return CutOut(
        width=hole,
        height=_rounded(2.0 * _HOLE * size),
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
