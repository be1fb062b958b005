"""OBJ: positions indexed apart from texture coordinates and normals.

A seam or a pole splits texture coordinates and normals, never positions: by its position
indices the mesh stays as watertight as it is.
"""

from __future__ import annotations

from typing import BinaryIO

import numpy as np
from numpy.typing import NDArray

from sgb_core.arrays import Floats
from sgb_core.exchange.digits import CHUNK, COARSE, Bytes, number_lines, packed, write_integers
from sgb_core.exchange.format import Companions, Format, Request
from sgb_core.exchange.mtl import NAME as MATERIAL
from sgb_core.exchange.mtl import mtl_text
from sgb_core.exchange.skin import has_picture, look_words, skin_of
from sgb_core.surfaces.mesh import Mesh


def write_obj(
    mesh: Mesh, stream: BinaryIO, *, uv: Floats | None = None, library: str | None = None
) -> None:
    """Write a mesh with texture coordinates and normals, in the unit of its positions.

    ``uv`` (V, 2) takes the place of the mesh's own; ``library`` is the name of the MTL file with
    its material.
    """
    stream.write(b"# SGB Studio\n")
    if library is not None:
        stream.write(f"mtllib {library}\n".encode())
    stream.write(b"o surface\n")
    if library is not None:
        stream.write(f"usemtl {MATERIAL}\n".encode())
    coordinates = mesh.uv if uv is None else uv
    stream.writelines(number_lines(mesh.positions, (b"v ", b" ", b" "), b"\n"))
    stream.writelines(number_lines(coordinates, (b"vt ", b" "), b"\n", COARSE))
    stream.writelines(number_lines(mesh.normals, (b"vn ", b" ", b" "), b"\n", COARSE))
    corners = _corner_names(mesh.corner_positions)
    width = corners.shape[1]
    names = corners.view(f"V{width}")[:, 0]
    table = np.empty((min(CHUNK, len(mesh.triangles)), 1 + 3 * width + 1), dtype=np.uint8)
    table[:, 0] = ord("f")
    table[:, -1] = ord("\n")
    for start in range(0, len(mesh.triangles), CHUNK):
        chunk = mesh.triangles[start : start + CHUNK]
        used = table[: len(chunk)]
        used[:, 1:-1] = names[chunk].view(np.uint8).reshape(len(chunk), 3 * width)
        stream.write(packed(used))


def _corner_names(corner_positions: NDArray[np.int64]) -> Bytes:
    """Return `` p/c/c`` for each corner, counted from 1, shape (V, width)."""
    count = len(corner_positions)
    width = len(str(count))
    names = np.empty((count, 3 * (1 + width)), dtype=np.uint8)
    names[:, 0] = ord(" ")
    names[:, 1 + width] = names[:, 2 + 2 * width] = ord("/")
    for start in range(0, count, CHUNK):
        part = names[start : start + CHUNK]
        write_integers(corner_positions[start : start + CHUNK] + 1, part[:, 1 : 1 + width])
        own = part[:, 2 + width : 2 + 2 * width]
        write_integers(np.arange(start + 1, start + len(part) + 1), own)
        part[:, 3 + 2 * width :] = own
    return names


def _write(request: Request, stream: BinaryIO) -> Companions:
    """Write the mesh, and return the material's file and its picture where there is a look."""
    mesh, skin = request.mesh, skin_of(request.document)
    if skin is None:
        write_obj(mesh, stream)
        return None
    library, picture = f"{request.stem}.mtl", f"{request.stem}.png"
    write_obj(mesh, stream, uv=skin.coordinates(mesh), library=library)
    beside = {picture: skin.png} if skin.png else {}
    return {**beside, library: mtl_text(skin, picture).encode()}


def _contents(request: Request) -> str:
    document = request.document
    look = look_words(document.appearance)
    if not look:
        return "Exact normals, texture coordinates"
    pictured = has_picture(document.appearance)
    beside = "in .mtl and .png files beside it" if pictured else "in an .mtl file beside it"
    return f"Exact normals, texture coordinates; {look}, {beside}"


FORMAT = Format(".obj", "Wavefront OBJ", _write, _contents, looks=True, bytes_per_triangle=105.0)
