"""Edits of the document as a whole: its size, place, turn, unit, name and meaning."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace
from typing import TypeVar

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.bodies.solid import BodyKind, Rim, Solid, WallSide
from sgb_core.design.locks.dimension import DimensionKind
from sgb_core.document.edits.checks import (
    as_edit_error,
    changed,
    checked,
    member,
    positive,
    with_profile,
)
from sgb_core.document.edits.cut_outs import enlarged_cut_outs
from sgb_core.document.edits.relief import enlarged_relief
from sgb_core.document.errors import EditError
from sgb_core.document.model import Document, Unit
from sgb_core.fields.kinds import MAX_COORDINATE
from sgb_core.fields.record import table_of
from sgb_core.findings.edits import NoEdit
from sgb_core.surfaces.laws.law import Law
from sgb_core.surfaces.revolution import Axis
from sgb_core.surfaces.twist import Ease

T = TypeVar("T")


def scale(document: Document, factor: float) -> Document:
    """Scale the profile and its fill line about the origin; walls, placement and the rest stay.

    >>> cylinder = sgb.Document(sgb.Profile.of([sgb.line((10, 0), (10, 60))]))
    >>> round(sgb.edits.scale(cylinder, 2).volume / cylinder.volume, 6)
    8.0
    """
    ratio = positive(factor, "the factor")
    scaled = _map_points(document, lambda points: points * ratio)
    return _with_fill_line(scaled, lambda height: height * ratio)


def set_height(document: Document, height: float) -> Document:
    """Scale the profile along the axis, and only so, until the curve is ``height`` high.

    Its lowest point stays where it is and no radius changes. Raises EditError where the curve
    has no height.
    """
    wanted = positive(height, "the height")
    low, high = document.profile.bounds()
    present = float(high[1] - low[1])
    if present == 0.0:
        raise EditError(NoEdit.FLAT)
    if present == wanted:
        return document
    foot, ratio = float(low[1]), wanted / present

    def stretch(points: Floats) -> Floats:
        points[:, 1] = foot + (points[:, 1] - foot) * ratio
        return points

    stretched = _map_points(document, stretch)
    return _with_fill_line(stretched, lambda height: foot + (height - foot) * ratio)


def set_largest_diameter(document: Document, diameter: float) -> Document:
    """Scale the profile across the axis, and only so, until the curve is so wide.

    The distance of the curve's farthest point from the axis becomes half the diameter; no
    height changes. Raises EditError where the curve lies on the axis.
    """
    wanted = positive(diameter, "the diameter")
    low, high = document.profile.bounds()
    present = 2.0 * max(abs(float(low[0])), abs(float(high[0])))
    if present == 0.0:
        raise EditError(NoEdit.ON_AXIS)
    if present == wanted:
        return document

    def widen(points: Floats) -> Floats:
        points[:, 0] *= wanted / present
        return points

    return _map_points(document, widen)


def mirror_height(document: Document) -> Document:
    """Turn the profile upside down, between the same lowest and highest point."""
    low, high = document.profile.bounds()
    total = float(low[1] + high[1])

    def turn(points: Floats) -> Floats:
        points[:, 1] = total - points[:, 1]
        return points

    # What fades towards the foot then fades towards the rim.
    laws = tuple(
        replace(law, along=tuple((1.0 - u, k) for u, k in reversed(law.along)))
        for law in document.variation
    )
    return replace(_map_points(document, turn), variation=laws)


def set_unit(document: Document, unit: Unit | str, convert: bool) -> Document:
    """Set the length unit.

    With ``convert`` the object keeps its true size and all lengths are rewritten: points, wall,
    base, drain hole, foot ring, translation. Without, the numbers stay and now mean the new unit.

    >>> cylinder = sgb.Document(sgb.Profile.of([sgb.line((10, 0), (10, 60))]))
    >>> sgb.edits.set_unit(cylinder, "cm", convert=True).height
    6.0
    """
    wanted = member(unit, Unit, "unit")
    if wanted is document.unit:
        return document
    renamed = replace(document, unit=wanted)
    if not convert:
        return renamed
    factor = document.unit.factor_to(wanted)
    known = document.reference
    source = None if known is None else checked(lambda: known.enlarged(factor))
    sized = enlarged(replace(renamed, reference=source), factor)
    # The object is the same, and so is its mass.
    told = tuple(
        old if old.kind is DimensionKind.MASS else new
        for old, new in zip(document.dimensions, sized.dimensions, strict=True)
    )
    return replace(sized, dimensions=told)


def enlarged(document: Document, factor: float) -> Document:
    """Return the same object ``factor`` times as large: profile, walls and placement alike."""
    ratio = positive(factor, "the factor")
    if ratio == 1.0:
        return document
    scaled = _enlarged_fill(scale(document, ratio), ratio)
    solid, placement = document.solid, document.placement
    if solid != Solid():
        lengths = [row.name for row in table_of(Solid).lengths]
        sizes = {name: getattr(solid, name) * ratio for name in lengths}
        scaled = set_solid(scaled, **sizes)
    scaled = enlarged_relief(enlarged_cut_outs(scaled, ratio), ratio)
    told = checked(lambda: tuple(each.enlarged(ratio) for each in document.dimensions))
    lines = checked(lambda: tuple(each.enlarged(ratio) for each in document.guides))
    scaled = checked(lambda: replace(scaled, dimensions=told, guides=lines))
    x, y, z = (ratio * part for part in placement.translation)
    return set_placement(scaled, translation=(x, y, z))


def rename(document: Document, name: str) -> Document:
    """Set the document's name. Raises EditError on what no file can hold."""
    if name == document.name:
        return document
    return checked(lambda: replace(document, name=name))


def set_revolution(
    document: Document,
    *,
    axis: Axis | str | None = None,
    start_deg: float | None = None,
    sweep_deg: float | None = None,
) -> Document:
    """Set about which axis, from where and how far the profile turns; None stays as it is.

    >>> cylinder = sgb.Document(sgb.Profile.of([sgb.line((10, 0), (10, 60))]))
    >>> round(sgb.edits.set_revolution(cylinder, sweep_deg=90).volume / cylinder.volume, 6)
    0.25
    """
    wanted = changed(document.revolution, axis=axis, start_deg=start_deg, sweep_deg=sweep_deg)
    return document if wanted == document.revolution else replace(document, revolution=wanted)


def set_solid(
    document: Document,
    *,
    kind: BodyKind | str | None = None,
    wall: float | None = None,
    side: WallSide | str | None = None,
    base: float | None = None,
    rim: Rim | str | None = None,
    drain_hole: float | None = None,
    foot_ring: float | None = None,
) -> Document:
    """Set what the surface means as an object, lengths in the unit; None stays as it is.

    >>> tube = sgb.Document(sgb.Profile.of([sgb.line((20, 0), (20, 60))]))
    >>> cup = sgb.edits.set_solid(tube, kind="vessel", wall=3, base=4)
    >>> str(cup.solid.kind), cup.solid.wall
    ('vessel', 3.0)
    """
    wanted = changed(
        document.solid,
        kind=kind,
        wall=wall,
        side=side,
        base=base,
        rim=rim,
        drain_hole=drain_hole,
        foot_ring=foot_ring,
    )
    return document if wanted == document.solid else replace(document, solid=wanted)


def set_placement(
    document: Document,
    *,
    rotation_deg: Sequence[float] | None = None,
    translation: Sequence[float] | None = None,
) -> Document:
    """Set how the result is turned and moved, three numbers each; None stays as it is.

    >>> cylinder = sgb.Document(sgb.Profile.of([sgb.line((10, 0), (10, 60))]))
    >>> sgb.edits.set_placement(cylinder, translation=(0, 0, 5)).centroid.round(6).tolist()
    [0.0, 0.0, 35.0]
    """
    wanted = changed(document.placement, rotation_deg=rotation_deg, translation=translation)
    return document if wanted == document.placement else replace(document, placement=wanted)


def set_variation(document: Document, laws: Iterable[Law]) -> Document:
    """Set the laws over the angle; raises EditError where one is out of its range."""
    wanted = tuple(laws)
    if wanted == document.variation:
        return document
    return checked(lambda: replace(document, variation=wanted))


def set_twist(
    document: Document, *, turns: float | None = None, ease: Ease | str | None = None
) -> Document:
    """Set by how many turns the top is turned against the foot, and how that sets in.

    None stays as it is. Volume, capacity, material and horizontal sections keep their size.
    Raises EditError out of range.

    >>> tube = sgb.Document(sgb.Profile.of([sgb.line((20, 0), (20, 60))]))
    >>> sgb.edits.set_twist(tube, turns=0.25, ease="smooth").twist
    Twist(turns=0.25, ease=<Ease.SMOOTH: 'smooth'>)
    """
    wanted = changed(document.twist, turns=turns, ease=ease)
    return document if wanted == document.twist else replace(document, twist=wanted)


def _with_fill_line(document: Document, change: Callable[[float], float]) -> Document:
    """Let the fill line follow the profile, within what a file may hold."""
    fill = document.manufacture.fill
    if fill.height is None:
        return document
    height = min(MAX_COORDINATE, max(-MAX_COORDINATE, change(fill.height)))
    moved = replace(fill, height=height)
    return replace(document, manufacture=replace(document.manufacture, fill=moved))


def _enlarged_fill(document: Document, ratio: float) -> Document:
    """Enlarge how far the fill line lies below the rim, as of the same object at another size."""
    fill = document.manufacture.fill
    if fill.below_rim is None:
        return document
    wider = replace(fill, below_rim=min(MAX_COORDINATE, fill.below_rim * ratio))
    return replace(document, manufacture=replace(document.manufacture, fill=wider))


def _map_points(document: Document, change: Callable[[Floats], Floats]) -> Document:
    with as_edit_error():
        segments = [
            segment.with_points(change(np.array(segment.points)))
            for segment in document.profile.segments
        ]
    return with_profile(document, document.profile.with_segments(segments))
