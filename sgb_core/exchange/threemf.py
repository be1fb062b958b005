"""3MF: the model of 3D printing, with its unit stated (core specification 1.3)."""

from __future__ import annotations

from html import escape
from itertools import chain
from typing import BinaryIO

from sgb_core.document.model import Unit
from sgb_core.exchange.digits import integer_lines, number_lines
from sgb_core.exchange.format import Format, Request
from sgb_core.exchange.package import write_package
from sgb_core.surfaces.mesh import Mesh

_UNITS = {Unit.MM: "millimeter", Unit.CM: "centimeter", Unit.IN: "inch"}
_DECLARATION = '<?xml version="1.0" encoding="UTF-8"?>\n'
_PACKAGE = "http://schemas.openxmlformats.org/package/2006"
_MODEL = "3D/3dmodel.model"
_CONTENT_TYPES = (
    f'{_DECLARATION}<Types xmlns="{_PACKAGE}/content-types">'
    '<Default Extension="rels" '
    'ContentType="application/vnd.openxmlformats-package.relationships+xml"/>'
    '<Default Extension="model" '
    'ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/></Types>'
)
_RELATIONSHIPS = (
    f'{_DECLARATION}<Relationships xmlns="{_PACKAGE}/relationships">'
    f'<Relationship Id="model" Target="/{_MODEL}" '
    'Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/></Relationships>'
)


def write_threemf(mesh: Mesh, stream: BinaryIO, *, unit: Unit, name: str) -> None:
    """Write a mesh as one object with its name and unit.

    A mesh that is not watertight is stated as a surface: as a model it would break the format's
    rules and slicers would refuse or repair it.
    """
    kind = "model" if mesh.is_watertight else "surface"
    # XML 1.0 has no way to write control characters.
    title = escape("".join(character if character.isprintable() else " " for character in name))
    head = (
        f'{_DECLARATION}<model unit="{_UNITS[unit]}" xml:lang="en-US" '
        'xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02">\n'
        '<metadata name="Application">SGB Studio</metadata>\n'
        f'<resources><object id="1" type="{kind}" name="{title}"><mesh><vertices>\n'
    )
    # `"/>` ends the last value; the others end in front of the next name.
    vertices = number_lines(mesh.positions, (b'<vertex x="', b'" y="', b'" z="'), b'"/>\n')
    triangles = integer_lines(
        mesh.triangles,
        (b'<triangle v1="', b'" v2="', b'" v3="'),
        b'"/>\n',
        mesh.corner_positions,
    )
    tail = (
        b'</triangles></mesh></object></resources>\n<build><item objectid="1"/></build></model>\n'
    )
    between = (b"</vertices><triangles>\n",)
    parts = (
        ("[Content_Types].xml", (_CONTENT_TYPES.encode(),)),
        ("_rels/.rels", (_RELATIONSHIPS.encode(),)),
        (_MODEL, chain((head.encode(),), vertices, between, triangles, (tail,))),
    )
    write_package(stream, parts)


def _write(request: Request, stream: BinaryIO) -> None:
    document = request.document
    write_threemf(request.mesh, stream, unit=document.unit, name=document.name)


def _contents(request: Request) -> str:
    return f"Name and unit ({request.document.unit})"


FORMAT = Format(".3mf", "3D Manufacturing Format", _write, _contents, bytes_per_triangle=19.0)
