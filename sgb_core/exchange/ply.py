"""PLY: binary little-endian, welded vertices with normals."""

from __future__ import annotations

from typing import BinaryIO

import numpy as np
from numpy.typing import NDArray

from sgb_core.arrays import Floats
from sgb_core.exchange.format import Format, Request
from sgb_core.exchange.skin import has_skin, skin_of
from sgb_core.surfaces.mesh import Mesh, faces_of

_VERTEX = np.dtype([("position", "<f8", 3), ("normal", "<f4", 3)])
_COLOURED = np.dtype([*_VERTEX.descr, ("colour", "u1", 3)])
_FACE = np.dtype([("count", "u1"), ("corners", "<i4", 3)])
_CHUNK = 65_536
# Positions whose normals are held at a time.
_BLOCK = 1 << 19


def write_ply(mesh: Mesh, stream: BinaryIO, colours: NDArray[np.uint8] | None = None) -> None:
    """Write a mesh in the unit of its positions, in double precision.

    A position has one normal: where several faces meet at a crease, their mean. ``colours``
    (P, 3) are written where they are given.
    """
    coloured = (
        ""
        if colours is None
        else "".join(f"property uchar {name}\n" for name in ("red", "green", "blue"))
    )
    header = (
        "ply\nformat binary_little_endian 1.0\ncomment SGB Studio\n"
        f"element vertex {len(mesh.positions)}\n"
        + "".join(f"property double {name}\n" for name in ("x", "y", "z"))
        + "".join(f"property float {name}\n" for name in ("nx", "ny", "nz"))
        + coloured
        + f"element face {len(mesh.triangles)}\n"
        + "property list uchar int vertex_indices\nend_header\n"
    )
    stream.write(header.encode("ascii"))
    kind = _VERTEX if colours is None else _COLOURED
    vertices = np.empty(min(_CHUNK, len(mesh.positions)), dtype=kind)
    for first in range(0, len(mesh.positions), _BLOCK):
        normals = position_normals(mesh, first, min(first + _BLOCK, len(mesh.positions)))
        for start in range(0, len(normals), _CHUNK):
            near = normals[start : start + _CHUNK]
            part = slice(first + start, first + start + len(near))
            used = vertices[: len(near)]
            used["position"] = mesh.positions[part]
            used["normal"] = near
            if colours is not None:
                used["colour"] = colours[part]
            stream.write(used.data)
    faces = np.empty(min(_CHUNK, len(mesh.triangles)), dtype=_FACE)
    faces["count"] = 3
    for start in range(0, len(mesh.triangles), _CHUNK):
        chunk = faces_of(mesh.triangles[start : start + _CHUNK], mesh.corner_positions)
        faces["corners"][: len(chunk)] = chunk
        stream.write(faces[: len(chunk)].data)


def position_normals(mesh: Mesh, first: int, stop: int) -> Floats:
    """Return one unit normal for each of some positions, shape (stop − first, 3).

    It is the mean over the position's corners; opposite normals that cancel give (0, 0, 0).
    """
    corners, normals, count = mesh.corner_positions, mesh.normals, stop - first
    if count < len(mesh.positions):
        here = (corners >= first) & (corners < stop)
        corners, normals = corners[here] - first, normals[here]
    sums = np.empty((count, 3))
    for k in range(3):
        sums[:, k] = np.bincount(corners, normals[:, k], count)
    lengths = np.linalg.norm(sums, axis=1, keepdims=True)
    means: Floats = np.divide(sums, lengths, out=np.zeros_like(sums), where=lengths > 1e-9)
    return means


def _write(request: Request, stream: BinaryIO) -> None:
    mesh, skin = request.mesh, skin_of(request.document)
    write_ply(mesh, stream, None if skin is None else skin.position_colors(mesh))


def _contents(request: Request) -> str:
    document = request.document
    colours = ", and colours" if has_skin(document.appearance) else ""
    return f"Normals, in double precision{colours}"


FORMAT = Format(".ply", "PLY, binary", _write, _contents, looks=True, bytes_per_triangle=31.0)
