"""Edits of the fill line, the material and the shrinkage, and the object at another size."""

from __future__ import annotations

from dataclasses import replace

from sgb_core.document.edits.checks import checked
from sgb_core.document.edits.whole import changed, enlarged, set_revolution
from sgb_core.document.manufacture import DENSITIES, Manufacture, Stage
from sgb_core.document.model import Document, Unit
from sgb_core.surfaces.revolution import Axis


def set_fill(document: Document, height: float | None) -> Document:
    """Set the fill line to a height of the profile, or take it away with None."""
    wanted = checked(lambda: replace(document.manufacture.fill, height=height))
    return _with(document, replace(document.manufacture, fill=wanted))


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
