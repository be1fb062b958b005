"""From the suffix of a file to the reader of its kind."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping
from functools import partial
from pathlib import Path, PurePath
from types import MappingProxyType
from typing import Any, TypeAlias

from sgb_core.fields.kinds import Said
from sgb_core.findings.refusal import Argument
from sgb_core.findings.sources import NoSource, TooLarge
from sgb_core.sources.drawing import read_drawing
from sgb_core.sources.dxf import parse_dxf
from sgb_core.sources.errors import SourceError
from sgb_core.sources.mesh import parse_mesh, read_mesh
from sgb_core.sources.options import Options
from sgb_core.sources.picture import parse_picture, read_picture
from sgb_core.sources.points import parse_points, read_points
from sgb_core.sources.reading import Reading
from sgb_core.sources.svg import parse_svg
from sgb_core.values import dataclass

_MEGABYTE = 1 << 20
Parser: TypeAlias = Callable[[bytes], Any]
Reader: TypeAlias = Callable[[Any, Options], Reading]


@dataclass(frozen=True, slots=True)
class Source:
    """A kind of source: its words, how it is read, and how many bytes a file may have.

    ``parse`` makes of a file's bytes what ``read`` takes each time that an option changes.
    ``closes`` says that points whose ends meet are an outline that goes round.
    """

    kind: str
    title: str
    parse: Parser
    read: Reader
    most_bytes: int
    closes: bool = False

    def data(self, path: str | os.PathLike[str]) -> bytes:
        """Return the bytes of a file; SourceError where they are none or too many."""
        size = Path(path).stat().st_size
        if size > self.most_bytes:
            raise SourceError(TooLarge(size / _MEGABYTE, self.most_bytes / _MEGABYTE))
        if size == 0:
            raise SourceError(NoSource.EMPTY)
        return Path(path).read_bytes()


_MESH_BYTES = 1024 * _MEGABYTE
_PICTURE = Source("picture", "Picture", parse_picture, read_picture, 128 * _MEGABYTE)
_POINTS = Source(
    "points", "Table of points", parse_points, read_points, 64 * _MEGABYTE, closes=True
)

SOURCES: Mapping[str, Source] = MappingProxyType(
    {
        ".svg": Source("svg", "SVG drawing", parse_svg, read_drawing, 32 * _MEGABYTE),
        ".dxf": Source("dxf", "DXF drawing", parse_dxf, read_drawing, 64 * _MEGABYTE),
        ".csv": _POINTS,
        ".txt": _POINTS,
        **{
            f".{kind}": Source(
                kind, f"{kind.upper()} mesh", partial(parse_mesh, kind), read_mesh, _MESH_BYTES
            )
            for kind in ("stl", "obj", "ply", "glb", "3mf")
        },
        ".png": _PICTURE,
        ".jpg": _PICTURE,
        ".jpeg": _PICTURE,
    }
)


def source_for(path: str | os.PathLike[str]) -> Source:
    """Return the source that the suffix of a path names, in any case of its letters.

    Raises SourceError that names the suffixes there are.
    """
    suffix = PurePath(path).suffix
    found = SOURCES.get(suffix.lower())
    if found is None:
        allowed = Said(" ".join(SOURCES))
        raise SourceError(Argument("suffix", suffix, allowed))
    return found
