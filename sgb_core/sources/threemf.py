"""Triangles of a 3MF file: a zip archive with XML in it."""

from __future__ import annotations

import io
import re
import zipfile
from xml.etree import ElementTree

import numpy as np

from sgb_core.arrays import Floats, Ints
from sgb_core.findings.sources import NoSource, TooLarge, Unreadable
from sgb_core.sources.errors import SourceError

_MOST_BYTES = 1 << 30
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

    Components and transforms are not followed: each mesh stands as it is written. Raises
    SourceError for what is no 3MF or unpacks to more than a gigabyte.
    """
    try:
        with zipfile.ZipFile(io.BytesIO(data)) as archive:
            models = [name for name in archive.namelist() if name.lower().endswith(".model")]
            if not models:
                raise SourceError(Unreadable("3MF", "it holds no model"))
            if sum(archive.getinfo(name).file_size for name in models) > _MOST_BYTES:
                raise SourceError(TooLarge(_MOST_BYTES / 2**20, _MOST_BYTES / 2**20))
            texts = [archive.read(name) for name in models]
    except (zipfile.BadZipFile, NotImplementedError, RuntimeError, OSError) as error:
        if isinstance(error, SourceError):
            raise
        raise SourceError(Unreadable("3MF", str(error))) from None
    vertices: list[Floats] = []
    faces: list[Ints] = []
    unit, total = 1.0, 0
    for text in texts:
        if re.search(rb"<!ENTITY", text, re.IGNORECASE):
            raise SourceError(NoSource.ENTITIES)
        try:
            root = ElementTree.fromstring(text)
            unit = _MILLIMETRES.get(root.get("unit", "millimeter"), 1.0)
            for mesh in root.iter():
                if _tag(mesh) != "mesh":
                    continue
                own = [_values(v, "xyz") for v in mesh.iter() if _tag(v) == "vertex"]
                three = [
                    _values(t, ("v1", "v2", "v3")) for t in mesh.iter() if _tag(t) == "triangle"
                ]
                vertices.append(np.array(own, dtype=np.float64).reshape(-1, 3))
                faces.append(np.array(three, dtype=np.int64).reshape(-1, 3) + total)
                total += len(own)
        except (ElementTree.ParseError, ValueError, TypeError) as error:
            raise SourceError(Unreadable("3MF", str(error))) from None
    if not vertices:
        raise SourceError(NoSource.NO_TRIANGLES)
    triangles = np.concatenate(faces)
    if len(triangles) and (triangles.min() < 0 or triangles.max() >= total):
        raise SourceError(NoSource.NO_CORNER)
    return np.concatenate(vertices), triangles, unit


def _tag(element: ElementTree.Element) -> str:
    return element.tag.rpartition("}")[2]


def _values(element: ElementTree.Element, names: tuple[str, ...] | str) -> list[float]:
    return [float(element.get(name, "nan")) for name in names]
