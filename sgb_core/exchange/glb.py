"""GLB: binary glTF 2.0, in metres and with +Y up by the transform of its one node."""

from __future__ import annotations

import json
import struct
from collections.abc import Callable
from functools import partial
from math import sqrt
from typing import Any, BinaryIO

import numpy as np
from numpy.typing import NDArray

from sgb_core.arrays import Floats, box
from sgb_core.document.model import Unit
from sgb_core.exchange.format import Format, Request
from sgb_core.exchange.glb_material import material_parts
from sgb_core.exchange.skin import Skin, look_words, skin_of
from sgb_core.surfaces.mesh import Mesh
from sgb_core.values import dataclass

# Rows converted at a time: the processor's cache holds them until they are written.
_CHUNK = 65_536
_FLOAT, _UNSIGNED = 5126, 5125
_VERTICES, _INDICES = 34962, 34963
_JSON, _BINARY = 0x4E4F534A, 0x004E4942
# Farther from the origin than so many extents an object's shift goes to its node.
_FAR = 16.0
# A quarter turn about x takes +Z, up here, to +Y, up there.
_UPRIGHT = [-sqrt(0.5), 0.0, 0.0, sqrt(0.5)]
# The light green of the window's surface, in linear light.
_GREEN = [0.45, 0.75, 0.42, 1.0]
_PLAIN = {
    "pbrMetallicRoughness": {
        "baseColorFactor": _GREEN,
        "metallicFactor": 0.0,
        "roughnessFactor": 0.45,
    }
}


def write_glb(
    mesh: Mesh, stream: BinaryIO, *, unit: Unit, name: str, skin: Skin | None = None
) -> None:
    """Write a mesh with exact normals and texture coordinates.

    Positions stay in the document's unit, single precision; the node scales them to metres, and
    moves what lies far from the origin, where single precision would spoil it.
    ``skin`` is its look, None the light green of the window.
    """
    used = _used(mesh)
    shift = _shift(used)
    # Rounding keeps the order of numbers, so that these are the bounds of what is written.
    low, high = (np.asarray(corner - shift, np.float32) for corner in box(used))
    count, corners = len(mesh.normals), mesh.corner_positions
    uv = mesh.uv if skin is None else skin.coordinates(mesh)
    blocks = [
        _Block(12 * count, partial(_positions, mesh.positions, shift), corners),
        _Block(12 * count, _singles, mesh.normals),
        _Block(8 * count, _from_the_top, uv),
        _Block(4 * mesh.triangles.size, _indices, mesh.triangles),
    ]
    png = b"" if skin is None else skin.png
    # Filled up, so that what follows it starts at a multiple of four.
    png += bytes(-len(png) % 4)
    scale = unit.millimetres / 1000.0
    bounds = (low.tolist(), high.tolist())
    scene = _scene(blocks, bounds, scale, name, not mesh.is_watertight, skin)
    if shift.any():
        x, y, z = (scale * shift).tolist()
        scene["nodes"][0]["translation"] = [x, z, -y]
    # Chunks start and end at multiples of four; JSON is filled up with spaces.
    text = json.dumps(scene, separators=(",", ":"), allow_nan=False).encode()
    text += b" " * (-len(text) % 4)
    size = sum(block.size for block in blocks) + len(png)
    stream.write(struct.pack("<4sII", b"glTF", 2, 12 + 8 + len(text) + 8 + size))
    stream.write(struct.pack("<II", len(text), _JSON) + text)
    stream.write(struct.pack("<II", size, _BINARY))
    for block in blocks:
        for start in range(0, len(block.rows), _CHUNK):
            stream.write(block.convert(block.rows[start : start + _CHUNK]).data)
    stream.write(png)


@dataclass(frozen=True, slots=True, eq=False)
class _Block:
    """So many bytes of the file: rows of an array, converted a part at a time."""

    size: int
    convert: Callable[[NDArray[Any]], NDArray[Any]]
    rows: NDArray[Any]


def _positions(positions: Floats, shift: Floats, corners: NDArray[Any]) -> NDArray[Any]:
    taken = positions.take(corners, axis=0, mode="clip")
    taken -= shift
    return _singles(taken)


def _singles(values: NDArray[Any]) -> NDArray[Any]:
    return values.astype("<f4", order="C")


def _from_the_top(uv: NDArray[Any]) -> NDArray[Any]:
    """Return texture coordinates as glTF has them: it counts v from the picture's top."""
    turned = _singles(uv)
    np.subtract(1.0, turned[:, 1], out=turned[:, 1])
    return turned


def _indices(triangles: NDArray[Any]) -> NDArray[Any]:
    return triangles.astype("<u4")


def _used(mesh: Mesh) -> Floats:
    """Return the positions that corners have."""
    used = np.zeros(len(mesh.positions), dtype=np.bool_)
    used[mesh.corner_positions] = True
    return mesh.positions if used.all() else mesh.positions[used]


def _shift(positions: Floats) -> Floats:
    """Return what to take off the positions, where far from the origin single precision fails."""
    low, high = box(positions)
    extent = float((high - low).max())
    near = max(float(np.abs(low).max()), float(np.abs(high).max())) <= _FAR * extent
    return np.zeros(3) if near else np.asarray((low + high) / 2.0)


def _scene(
    blocks: list[_Block],
    bounds: tuple[list[float], list[float]],
    scale: float,
    name: str,
    open_ended: bool,
    skin: Skin | None,
) -> dict[str, Any]:
    positions, normals, uv, indices = blocks
    views: list[dict[str, int]] = []
    offset = 0
    for block in blocks:
        target = _INDICES if block is indices else _VERTICES
        views.append(
            {"buffer": 0, "byteOffset": offset, "byteLength": block.size, "target": target}
        )
        offset += block.size
    accessors: list[dict[str, object]] = [
        {
            "bufferView": 0,
            "componentType": _FLOAT,
            "count": len(positions.rows),
            "type": "VEC3",
            "min": bounds[0],
            "max": bounds[1],
        },
        {"bufferView": 1, "componentType": _FLOAT, "count": len(normals.rows), "type": "VEC3"},
        {"bufferView": 2, "componentType": _FLOAT, "count": len(uv.rows), "type": "VEC2"},
        {"bufferView": 3, "componentType": _UNSIGNED, "count": indices.rows.size, "type": "SCALAR"},
    ]
    looks: dict[str, Any] = {"materials": [_PLAIN]}
    if skin is not None:
        looks = material_parts(skin, len(views))
        if skin.png:
            views.append({"buffer": 0, "byteOffset": offset, "byteLength": len(skin.png)})
            offset += len(skin.png) + -len(skin.png) % 4
    materials = [{**each, "doubleSided": open_ended} for each in looks.pop("materials")]
    primitive = {
        "attributes": {"POSITION": 0, "NORMAL": 1, "TEXCOORD_0": 2},
        "indices": 3,
        "material": 0,
    }
    return {
        "asset": {"version": "2.0", "generator": "SGB Studio"},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"name": name, "mesh": 0, "rotation": _UPRIGHT, "scale": [scale] * 3}],
        "meshes": [{"name": name, "primitives": [primitive]}],
        "materials": materials,
        **looks,
        "accessors": accessors,
        "bufferViews": views,
        "buffers": [{"byteLength": offset}],
    }


def _write(request: Request, stream: BinaryIO) -> None:
    document = request.document
    skin = skin_of(document)
    write_glb(request.mesh, stream, unit=document.unit, name=document.name, skin=skin)


def _contents(request: Request) -> str:
    document = request.document
    look = look_words(document.appearance)
    return (
        f"Exact normals, texture coordinates{look and f'; {look}'}"
        "; in metres, as it stands in the viewport"
    )


FORMAT = Format(
    ".glb",
    "glTF, binary",
    _write,
    _contents,
    looks=True,
    # A GLB file is in metres and upright whatever is asked for.
    any_unit=False,
    any_axis=False,
    bytes_per_triangle=29.0,
)
