"""Edits of the fill line, the material and the shrinkage, and the object at another size."""

from __future__ import annotations

from dataclasses import replace

from sgb_core.document.edits.whole import changed, checked, enlarged, set_revolution
from sgb_core.document.errors import EditError
from sgb_core.document.file import making as making_file
from sgb_core.document.file.fields import Node
from sgb_core.document.making import DENSITIES, Making, Stage
from sgb_core.document.model import Document, Unit
from sgb_core.surfaces.revolution import Axis


def set_fill(document: Document, height: float | None) -> Document:
    """Set the fill line to a height of the profile, or take it away with None."""
    wanted = replace(document.making.fill, height=height)
    node = Node(making_file.fill_tree(wanted), "fill")
    read = checked(lambda: making_file.read_fill(node.object()))
    return _with(document, replace(document.making, fill=read))


def set_material(
    document: Document, *, name: str | None = None, density: float | None = None
) -> Document:
    """Set name or density (g/cm³), None stays; a known name alone brings its own density.

    >>> cylinder = sgb.Document(sgb.Profile.of([sgb.line((10, 0), (10, 60))]))
    >>> sgb.edits.set_material(cylinder, name="porcelain").making.material.density
    2.4
    """
    if name is not None and density is None:
        density = DENSITIES.get(name)
    try:
        (name or "").encode()
    except UnicodeEncodeError:
        raise EditError("the name of the material holds half a character") from None
    wanted = changed(document.making.material, name=name, density=density)
    node = Node(making_file.material_tree(wanted), "material")
    read = checked(lambda: making_file.read_material(node.object()))
    return _with(document, replace(document.making, material=read))


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
    >>> round(fired.making.shrinkage.wet_over_fired, 4)
    1.1364
    """
    wanted = changed(document.making.shrinkage, percent=percent, of=of, drawn=drawn)
    node = Node(making_file.shrinkage_tree(wanted), "shrinkage")
    read = checked(lambda: making_file.read_shrinkage(node.object()))
    return _with(document, replace(document.making, shrinkage=read))


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
    return sized if axis is None else set_revolution(sized, axis=axis)


def _with(document: Document, making: Making) -> Document:
    return document if making == document.making else replace(document, making=making)
