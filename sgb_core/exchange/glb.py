"""GLB: binary glTF 2.0, in metres and with +Y up by the transform of its one node."""

from __future__ import annotations

import json
import struct
from math import sqrt
from typing import BinaryIO

import numpy as np
from numpy.typing import NDArray

from sgb_core.document.model import Unit
from sgb_core.surfaces.mesh import Mesh

_FLOAT, _UNSIGNED = 5126, 5125
_VERTICES, _INDICES = 34962, 34963
_JSON, _BINARY = 0x4E4F534A, 0x004E4942
# A quarter turn about x takes +Z, up here, to +Y, up there.
_UPRIGHT = [-sqrt(0.5), 0.0, 0.0, sqrt(0.5)]
# The light green of the window's surface, in linear light.
_GREEN = [0.45, 0.75, 0.42, 1.0]


def write_glb(mesh: Mesh, stream: BinaryIO, *, unit: Unit, name: str) -> None:
    """Write a mesh with exact normals and texture coordinates.

    Positions stay in the document's unit, single precision; the node scales them to metres.
    """
    positions = mesh.positions[mesh.corner_positions].astype("<f4")
    normals = mesh.normals.astype("<f4")
    uv = mesh.uv.astype("<f4")
    # glTF counts v from the picture's top.
    uv[:, 1] = 1.0 - uv[:, 1]
    indices = mesh.triangles.astype("<u4")
    blocks = [positions, normals, uv, indices]
    scene = _scene(blocks, unit.millimetres / 1000.0, name, not mesh.is_watertight)
    # Chunks start and end at multiples of four; JSON is filled up with spaces.
    text = json.dumps(scene, separators=(",", ":"), allow_nan=False).encode()
    text += b" " * (-len(text) % 4)
    size = sum(block.nbytes for block in blocks)
    stream.write(struct.pack("<4sII", b"glTF", 2, 12 + 8 + len(text) + 8 + size))
    stream.write(struct.pack("<II", len(text), _JSON) + text)
    stream.write(struct.pack("<II", size, _BINARY))
    for block in blocks:
        stream.write(np.ascontiguousarray(block).data)


def _scene(
    blocks: list[NDArray[np.generic]], scale: float, name: str, open_ended: bool
) -> dict[str, object]:
    positions, normals, uv, indices = blocks
    views: list[dict[str, int]] = []
    offset = 0
    for block in blocks:
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
    material = {
        "pbrMetallicRoughness": {
            "baseColorFactor": _GREEN,
            "metallicFactor": 0.0,
            "roughnessFactor": 0.45,
        },
        "doubleSided": open_ended,
    }
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
        "materials": [material],
        "accessors": accessors,
        "bufferViews": views,
        "buffers": [{"byteLength": offset}],
    }
