"""Triangles of a 3MF file: a zip archive with XML in it."""

from __future__ import annotations

import io
import zipfile
from array import array
from typing import IO
from xml.parsers.expat import ExpatError, ParserCreate

import numpy as np

from sgb_core.arrays import Floats, Ints
from sgb_core.findings.sources import NoSource, TooLarge, Unreadable
from sgb_core.sources.errors import SourceError

_MOST_BYTES, _CHUNK = 1 << 30, 1 << 20
_MILLIMETRES = {
    "micron": 1e-3,
    "millimeter": 1.0,
    "centimeter": 10.0,
    "inch": 25.4,
    "foot": 304.8,
    "meter": 1000.0,
}


def read_threemf(data: bytes) -> tuple[Floats, Ints, float]:
    """Return vertices, triangles and the millimetres of the unit of all meshes in a 3MF file.

    Components and transforms are not followed: each mesh stands as it is written. The archive is
    read as it unpacks, so that only the numbers of the meshes are kept. Raises SourceError for
    what is no 3MF or unpacks to more than a gigabyte.
    """
    found = _Meshes()
    try:
        with zipfile.ZipFile(io.BytesIO(data)) as archive:
            models = [name for name in archive.namelist() if name.lower().endswith(".model")]
            if not models:
                raise SourceError(Unreadable("3MF", "it holds no model"))
            for name in models:
                with archive.open(name) as stream:
                    found.read(stream)
    except (
        zipfile.BadZipFile,
        NotImplementedError,
        RuntimeError,
        OSError,
        ExpatError,
        ValueError,
        OverflowError,
    ) as error:
        if isinstance(error, SourceError):
            raise
        raise SourceError(Unreadable("3MF", str(error))) from None
    vertices = np.array(found.vertices, dtype=np.float64).reshape(-1, 3)
    triangles = np.array(found.triangles, dtype=np.int64).reshape(-1, 3)
    if not len(vertices):
        raise SourceError(NoSource.NO_TRIANGLES)
    if len(triangles) and (triangles.min() < 0 or triangles.max() >= len(vertices)):
        raise SourceError(NoSource.NO_CORNER)
    return vertices, triangles, found.millimetres


class _Meshes:
    """The numbers of all meshes read so far, three to a vertex and three to a triangle."""

    def __init__(self) -> None:
        self.vertices, self.triangles = array("d"), array("q")
        self.millimetres = 1.0
        self._first = 0
        self._bytes = 0

    def read(self, stream: IO[bytes]) -> None:
        """Add the meshes of a model."""
        parser = ParserCreate(namespace_separator="}")
        parser.StartElementHandler = self._element
        parser.EntityDeclHandler = self._entity
        while chunk := stream.read(_CHUNK):
            self._bytes += len(chunk)
            if self._bytes > _MOST_BYTES:
                raise SourceError(TooLarge(_MOST_BYTES / 2**20, _MOST_BYTES / 2**20))
            parser.Parse(chunk)
        parser.Parse(b"", True)

    def _element(self, name: str, values: dict[str, str]) -> None:
        tag = name.rpartition("}")[2]
        if tag == "vertex":
            self.vertices.extend(float(values.get(key, "nan")) for key in "xyz")
        elif tag == "triangle":
            corners = (int(float(values.get(key, "nan"))) for key in ("v1", "v2", "v3"))
            self.triangles.extend(self._first + corner for corner in corners)
        elif tag == "mesh":
            self._first = len(self.vertices) // 3
        elif tag == "model":
            self.millimetres = _MILLIMETRES.get(values.get("unit", "millimeter"), 1.0)

    def _entity(self, *_declared: object) -> None:
        raise SourceError(NoSource.ENTITIES)
