"""STL: binary, facet normals, welded positions rounded to single precision."""

from __future__ import annotations

from typing import BinaryIO

import numpy as np
from numpy.typing import NDArray

from sgb_core.arrays import Floats, box
from sgb_core.exchange.errors import ExportError
from sgb_core.exchange.format import Format, Request
from sgb_core.findings.exports import SinglePrecision
from sgb_core.surfaces.mesh import Mesh, faces_of

FACET = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])

Singles = NDArray[np.float32]

_CHUNK = 16_384
# Without a tolerance: the part of the mesh's size that rounding may take.
_SHARE = 1e-3
_FINEST = 1e-6
# No reader must take the file for the text variant, whose first word is "solid".
_HEADER = b"SGB Studio binary STL".ljust(80)


def write_stl(mesh: Mesh, stream: BinaryIO) -> None:
    """Write a mesh to a seekable stream, in the unit of its positions.

    Corners that single precision makes one leave a facet without area; it is left out, which
    keeps a watertight mesh watertight.
    """
    positions = mesh.positions.astype(np.float32)
    shape = _for_normals(mesh.positions, positions)
    count = len(mesh.triangles)
    facets = np.zeros(min(_CHUNK, count), dtype=FACET)
    gathered = np.empty((len(facets), 3, 3), dtype=np.float32)
    stream.write(_HEADER + count.to_bytes(4, "little"))
    written = 0
    for start in range(0, count, _CHUNK):
        chunk = faces_of(mesh.triangles[start : start + _CHUNK], mesh.corner_positions)
        used, corners = facets[: len(chunk)], gathered[: len(chunk)]
        rows = _gather(positions, chunk, corners)
        used["corners"] = corners
        collapsed = _collapsed(rows)
        used["normal"] = _normals(rows if shape is positions else _gather(shape, chunk, corners))
        if collapsed.any():
            used = used[~collapsed]
        stream.write(used.data)
        written += len(used)
    if written != count:
        stream.seek(len(_HEADER))
        stream.write(written.to_bytes(4, "little"))


def _for_normals(exact: Floats, rounded: Singles) -> Singles:
    """Return the positions to take normals from: those written, unless that would spoil them.

    Centred coordinates of size 1 instead where products could overflow or vanish, and where
    something small stands so far away that rounding eats its shape.
    """
    low, high = box(exact)
    extent = float(max((exact[0] - low).max(), (high - exact[0]).max()))
    farthest = float(np.abs(np.asarray((low, high), np.float32)).max())
    if 1e-3 < extent < 1e6 and farthest < 10.0 * extent:
        return rounded
    centred: Singles = ((exact - exact[0]) / (extent or 1.0)).astype(np.float32)
    return centred


def _gather(positions: Singles, faces: NDArray[np.int64], out: Singles) -> Singles:
    """Fill ``out``, shape (n, 3, 3), with the corners of faces; return it as rows, (9, n)."""
    # numpy checks indices through a copy of its own unless told how to treat bad ones.
    np.take(positions, faces, axis=0, out=out, mode="clip")
    # Whole rows at a time are three times as fast as one facet at a time.
    return np.ascontiguousarray(out.reshape(-1, 9).T)


def _normals(rows: Singles) -> Singles:
    """Return the unit normals of facets, shape (n, 3).

    Without an area it is (0, 0, 0), by which a reader is asked to find it itself.
    """
    u, v = rows[3:6] - rows[0:3], rows[6:9] - rows[0:3]
    normals = np.empty_like(u)
    np.subtract(u[1] * v[2], u[2] * v[1], out=normals[0])
    np.subtract(u[2] * v[0], u[0] * v[2], out=normals[1])
    np.subtract(u[0] * v[1], u[1] * v[0], out=normals[2])
    x, y, z = normals
    lengths = np.sqrt(x * x + y * y + z * z)
    lengths[lengths == 0.0] = np.inf
    normals /= lengths
    return normals.T


def _collapsed(rows: Singles) -> NDArray[np.bool_]:
    """Return which facets have two equal corners, shape (n,)."""
    collapsed = np.zeros(rows.shape[1], dtype=np.bool_)
    for first, second in ((0, 3), (3, 6), (6, 0)):
        same = rows[first] == rows[second]
        same &= rows[first + 1] == rows[second + 1]
        same &= rows[first + 2] == rows[second + 2]
        collapsed |= same
    return collapsed


def _write(request: Request, stream: BinaryIO) -> None:
    """Write a document's mesh; raises ExportError where single precision cannot hold it."""
    mesh = request.mesh
    low, high = mesh.bounds
    farthest = float(np.abs((low, high)).max())
    if farthest > float(np.finfo(np.float32).max):
        raise ExportError(SinglePrecision(farthest, None, None))
    size = float(np.linalg.norm(high - low))
    wanted = request.fineness.tolerance
    # Near the origin single precision is as good as the format can be.
    allowed = _SHARE * size if wanted is None else max(wanted, _FINEST * size)
    rounding = float(np.spacing(np.float32(farthest))) / 2.0
    if rounding > allowed:
        raise ExportError(SinglePrecision(farthest, rounding, allowed))
    write_stl(mesh, stream)


FORMAT = Format(
    ".stl",
    "STL, binary",
    _write,
    lambda _document: "Triangles alone: no unit, which most programs take for mm",
    bytes_per_triangle=50.0,
)
