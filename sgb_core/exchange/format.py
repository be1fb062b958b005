"""What a file format is: each module that writes one declares it as its ``FORMAT``."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import BinaryIO, TypeAlias

from sgb_core.document.model import Document
from sgb_core.exchange.body import exported_mesh
from sgb_core.exchange.progress import Report, untold
from sgb_core.surfaces.fineness import DEFAULT_TOLERANCE, Fineness
from sgb_core.surfaces.mesh import Mesh
from sgb_core.values import dataclass

_USUAL = Fineness()


@dataclass(frozen=True, slots=True)
class Request:
    """What to write: a document, how finely, and the name of its file without the suffix.

    ``made`` is the document's mesh where it has been made as finely already. A writer that works
    long before it writes tells ``report`` which part, 0 to 1, is done.
    """

    document: Document
    fineness: Fineness = _USUAL
    stem: str = "file"
    made: Mesh | None = None
    report: Report = untold

    @property
    def mesh(self) -> Mesh:
        """The mesh of the document's body; raises ExportError where there is none."""
        if self.made is not None:
            return self.made
        wanted = self.fineness
        return exported_mesh(self.document, tolerance=wanted.tolerance, samples=wanted.samples)


# By their names the bytes of the files that go beside the one written; None: it stands alone.
Companions: TypeAlias = Mapping[str, bytes] | None
Writer: TypeAlias = Callable[[Request, BinaryIO], Companions]


@dataclass(frozen=True, slots=True)
class Format:
    """A file format: its suffix, its name for people, what writes it and what it can hold.

    ``write`` writes to a stream and returns the files that go beside it. ``contents`` says in a
    line what the file holds, besides the triangles of a ``meshed`` one. ``tolerance`` is the part
    of the size to which it follows the true surface where nothing is asked for; None where it is
    exact whatever is asked.
    """

    suffix: str
    title: str
    write: Writer
    contents: Callable[[Request], str]
    # Whether it holds a mesh, whose fineness can be chosen.
    meshed: bool = True
    tolerance: float | None = DEFAULT_TOLERANCE
    # Whether it holds the look: material, paint or the colours of a map.
    looks: bool = False
    # Whether its numbers are in a unit of choice, and the object along an axis of choice.
    any_unit: bool = True
    any_axis: bool = True
    # Whether writing it holds up all threads: a window lets another process do it.
    holds_up: bool = False
    # In a long file, to tell its size without writing it.
    bytes_per_triangle: float = 50.0
