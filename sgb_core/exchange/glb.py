"""GLB: binary glTF 2.0, in metres and with +Y up by the transform of its one node."""

from __future__ import annotations

import json
import struct
from math import sqrt
from typing import Any, BinaryIO

import numpy as np
from numpy.typing import NDArray

from sgb_core.arrays import Floats
from sgb_core.document.model import Unit
from sgb_core.exchange.format import Format, Request
from sgb_core.exchange.glb_material import material_parts
from sgb_core.exchange.skin import Skin, look_words, skin_of
from sgb_core.surfaces.mesh import Mesh

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
    shift = _shift(mesh.positions)
    positions = (mesh.positions - shift)[mesh.corner_positions].astype("<f4")
    normals = mesh.normals.astype("<f4")
    uv = (mesh.uv if skin is None else skin.coordinates(mesh)).astype("<f4")
    # glTF counts v from the picture's top.
    uv[:, 1] = 1.0 - uv[:, 1]
    indices = mesh.triangles.astype("<u4")
    blocks: list[NDArray[np.generic]] = [positions, normals, uv, indices]
    if skin is not None and skin.png:
        # Filled up, so that what follows it starts at a multiple of four.
        png = skin.png
        blocks.append(np.frombuffer(png + bytes(-len(png) % 4), np.uint8))
    scale = unit.millimetres / 1000.0
    scene = _scene(blocks, scale, name, not mesh.is_watertight, skin)
    if shift.any():
        x, y, z = (scale * shift).tolist()
        scene["nodes"][0]["translation"] = [x, z, -y]
    # Chunks start and end at multiples of four; JSON is filled up with spaces.
    text = json.dumps(scene, separators=(",", ":"), allow_nan=False).encode()
    text += b" " * (-len(text) % 4)
    size = sum(block.nbytes for block in blocks)
    stream.write(struct.pack("<4sII", b"glTF", 2, 12 + 8 + len(text) + 8 + size))
    stream.write(struct.pack("<II", len(text), _JSON) + text)
    stream.write(struct.pack("<II", size, _BINARY))
    for block in blocks:
        stream.write(np.ascontiguousarray(block).data)


def _shift(positions: Floats) -> Floats:
    """Return what to take off the positions, where far from the origin single precision fails."""
    low, high = positions.min(axis=0), positions.max(axis=0)
    extent = float((high - low).max())
    near = float(np.abs(positions).max()) <= _FAR * extent
    return np.zeros(3) if near else np.asarray((low + high) / 2.0)


def _scene(
    blocks: list[NDArray[np.generic]],
    scale: float,
    name: str,
    open_ended: bool,
    skin: Skin | None,
) -> dict[str, Any]:
    positions, normals, uv, indices = blocks[:4]
    views: list[dict[str, int]] = []
    offset = 0
    for block in blocks[:4]:
        target = _INDICES if block is indices else _VERTICES
        views.append(
            {"buffer": 0, "byteOffset": offset, "byteLength": block.nbytes, "target": target}
        )
        offset += block.nbytes
    accessors: list[dict[str, object]] = [
        {
            "bufferView": 0,
            "componentType": _FLOAT,
            "count": len(positions),
            "type": "VEC3",
            "min": positions.min(axis=0).tolist(),
            "max": positions.max(axis=0).tolist(),
        },
        {"bufferView": 1, "componentType": _FLOAT, "count": len(normals), "type": "VEC3"},
        {"bufferView": 2, "componentType": _FLOAT, "count": len(uv), "type": "VEC2"},
        {"bufferView": 3, "componentType": _UNSIGNED, "count": indices.size, "type": "SCALAR"},
    ]
    looks: dict[str, Any] = {"materials": [_PLAIN]}
    if skin is not None:
        looks = material_parts(skin, len(views))
        for block in blocks[4:]:
            views.append({"buffer": 0, "byteOffset": offset, "byteLength": len(skin.png)})
            offset += block.nbytes
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
