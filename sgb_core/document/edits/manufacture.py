"""Edits of the fill line, the material and the shrinkage, and the object at another size."""

from __future__ import annotations

from dataclasses import replace

from sgb_core.document.edits.whole import changed, enlarged, set_revolution
from sgb_core.document.manufacture import DENSITIES, Manufacture
from sgb_core.document.model import Document, Unit
from sgb_core.surfaces.revolution import Axis


def set_fill(document: Document, height: float | None) -> Document:
    """Set the fill line to a height of the profile, or take it away with None."""
    wanted = changed(document.manufacture.fill, {"height": height}, "fill")
    return _with(document, replace(document.manufacture, fill=wanted))


def set_material(document: Document, **changes: object) -> Document:
    """Set ``name`` or ``density`` (g/cm³); a known name alone brings its own density."""
    if "name" in changes and "density" not in changes and changes["name"] in DENSITIES:
        changes["density"] = DENSITIES[str(changes["name"])]
    wanted = changed(document.manufacture.material, changes, "material")
    return _with(document, replace(document.manufacture, material=wanted))


def set_shrinkage(document: Document, **changes: object) -> Document:
    """Set ``percent``, ``of`` or ``drawn`` of the shrinkage."""
    wanted = changed(document.manufacture.shrinkage, changes, "shrinkage")
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
    ratio = document.unit.millimetres / wanted.millimetres
    sized = enlarged(replace(document, unit=wanted), factor * ratio)
    return sized if axis is None else set_revolution(sized, axis=str(axis))


def _with(document: Document, manufacture: Manufacture) -> Document:
    return document if manufacture == document.manufacture else replace(document, manufacture=manufacture)
