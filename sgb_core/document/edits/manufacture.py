"""Edits of the fill line, the material and the shrinkage, and the object at another size."""

from __future__ import annotations

from dataclasses import replace

from sgb_core.document.edits.checks import changed, checked
from sgb_core.document.edits.whole import enlarged, set_revolution
from sgb_core.document.manufacture import DENSITIES, Manufacture, Stage
from sgb_core.document.model import Document, Unit
from sgb_core.surfaces.revolution import Axis


def set_fill(
    document: Document, height: float | None = None, *, below_rim: float | None = None
) -> Document:
    """Set the fill line, to a height of the profile or so far below the rim; neither is none.

    A line below the rim stays so when the shape changes. Raises EditError.

    >>> cylinder = sgb.Document(sgb.Profile.of([sgb.line((10, 0), (10, 60))]))
    >>> filled = sgb.edits.set_fill(cylinder, below_rim=10.0)
    >>> filled.fill_height, sgb.edits.set_height(filled, 90.0).fill_height
    (50.0, 80.0)
    """
    fill = document.manufacture.fill
    wanted = checked(lambda: replace(fill, height=height, below_rim=below_rim))
    return _with(document, replace(document.manufacture, fill=wanted))


def move_fill(document: Document, height: float) -> Document:
    """Move the fill line to a height; one that is given below the rim stays so given."""
    if document.manufacture.fill.below_rim is None:
        return set_fill(document, height)
    return set_fill(document, below_rim=max(0.0, document.rim_height - height))


def set_material(
    document: Document, *, name: str | None = None, density: float | None = None
) -> Document:
    """Set name or density (g/cm³), None stays; a known name alone brings its own density.

    >>> cylinder = sgb.Document(sgb.Profile.of([sgb.line((10, 0), (10, 60))]))
    >>> sgb.edits.set_material(cylinder, name="porcelain").manufacture.material.density
    2.4
    """
    if name is not None and density is None:
        density = DENSITIES.get(name)
    wanted = changed(document.manufacture.material, name=name, density=density)
    return _with(document, replace(document.manufacture, material=wanted))


def set_shrinkage(
    document: Document,
    *,
    percent: float | None = None,
    of: Stage | str | None = None,
    drawn: Stage | str | None = None,
) -> Document:
    """Set by how much it shrinks, of which size, and which one is drawn; None stays as it is.

    >>> cylinder = sgb.Document(sgb.Profile.of([sgb.line((10, 0), (10, 60))]))
    >>> fired = sgb.edits.set_shrinkage(cylinder, percent=12.0, drawn="fired")
    >>> round(fired.manufacture.shrinkage.wet_over_fired, 4)
    1.1364
    """
    wanted = changed(document.manufacture.shrinkage, percent=percent, of=of, drawn=drawn)
    return _with(document, replace(document.manufacture, shrinkage=wanted))


def for_export(
    document: Document,
    *,
    unit: Unit | None = None,
    factor: float = 1.0,
    axis: Axis | None = None,
) -> Document:
    """Return the object as another program wants it, true to size but for ``factor``.

    Lengths are in ``unit``; the axis of rotation lies along ``axis`` (the coordinates change
    places in a ring, so nothing is mirrored). None keeps what the document has.
    """
    wanted = document.unit if unit is None else unit
    sized = enlarged(replace(document, unit=wanted), factor * document.unit.factor_to(wanted))
    return sized if axis is None else set_revolution(sized, axis=axis)


def _with(document: Document, manufacture: Manufacture) -> Document:
    return (
        document
        if manufacture == document.manufacture
        else replace(document, manufacture=manufacture)
    )
