"""The sections ``fill``, ``material`` and ``shrinkage`` of a project file."""

from __future__ import annotations

from sgb_core.document.file.fields import Fields
from sgb_core.document.manufacture import (
    MAX_DENSITY,
    MAX_MATERIAL_NAME,
    MAX_SHRINKAGE,
    Fill,
    Manufacture,
    Material,
    Shrinkage,
    Stage,
)

MAX_HEIGHT = 1e9


def read_manufacture(fields: Fields) -> Manufacture:
    """Return the sections from the fields of a document."""
    return Manufacture(
        read_fill(fields["fill"].object()),
        read_material(fields["material"].object()),
        read_shrinkage(fields["shrinkage"].object()),
    )


def read_fill(fields: Fields) -> Fill:
    """Return the ``fill`` section; a height of null is none."""
    node = fields["height"]
    height = None
    if node.is_given and node.value is not None:
        height = node.number("null or a number from -1e9 to 1e9", -MAX_HEIGHT, MAX_HEIGHT)
    return Fill(height, fields.rest())


def read_material(fields: Fields) -> Material:
    """Return the ``material`` section."""
    default = Material()
    name = fields["name"].text(default.name)
    if not 1 <= len(name) <= MAX_MATERIAL_NAME:
        fields["name"].fail(f"a text of 1 to {MAX_MATERIAL_NAME} characters")
    density = default.density
    if fields["density"].is_given:
        allowed = f"a number above 0 and at most {MAX_DENSITY:g}"
        density = fields["density"].number(allowed, high=MAX_DENSITY, above=0.0)
    return Material(name, density, fields.rest())


def read_shrinkage(fields: Fields) -> Shrinkage:
    """Return the ``shrinkage`` section."""
    default = Shrinkage()
    percent = default.percent
    if fields["percent"].is_given:
        allowed = f"a number from 0 to {MAX_SHRINKAGE:g}"
        percent = fields["percent"].number(allowed, 0.0, MAX_SHRINKAGE)
    return Shrinkage(
        percent,
        fields["of"].choice(Stage, default.of),
        fields["drawn"].choice(Stage, default.drawn),
        fields.rest(),
    )


def manufacture_tree(manufacture: Manufacture) -> dict[str, object]:
    """Return those of the sections that say more than the defaults."""
    tree: dict[str, object] = {}
    if manufacture.fill != Fill():
        tree["fill"] = fill_tree(manufacture.fill)
    if manufacture.material != Material():
        tree["material"] = material_tree(manufacture.material)
    if manufacture.shrinkage != Shrinkage():
        tree["shrinkage"] = shrinkage_tree(manufacture.shrinkage)
    return tree


def fill_tree(fill: Fill) -> dict[str, object]:
    """Return the ``fill`` section."""
    return {"height": fill.height, **fill.extra}


def material_tree(material: Material) -> dict[str, object]:
    """Return the ``material`` section."""
    return {"name": material.name, "density": material.density, **material.extra}


def shrinkage_tree(shrinkage: Shrinkage) -> dict[str, object]:
    """Return the ``shrinkage`` section."""
    return {
        "percent": shrinkage.percent,
        "of": str(shrinkage.of),
        "drawn": str(shrinkage.drawn),
        **shrinkage.extra,
    }
