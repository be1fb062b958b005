"""A long mesh is in memory once: making and writing it take little beside it."""

from __future__ import annotations

import tracemalloc
from collections.abc import Callable
from typing import BinaryIO, TypeVar, cast

import pytest

from sgb_core.bodies.solid import BodyKind, Solid
from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import Segment
from sgb_core.document.model import Document
from sgb_core.exchange import glb, obj, ply, stl, threemf
from sgb_core.exchange.format import Format, Request
from sgb_core.exchange.progress import CountingStream
from sgb_core.surfaces.fineness import Fineness
from sgb_core.surfaces.mesh import Mesh

Made = TypeVar("Made")
FORMATS = [module.FORMAT for module in (stl, obj, ply, glb, threemf)]
BELLY = Profile((Segment([(20, 0), (30, 20), (25, 40), (20, 60)]),))
BARE, FILLED, VESSEL = (Solid(kind, base=4.0) for kind in BodyKind)


def size(mesh: Mesh) -> int:
    arrays = (mesh.positions, mesh.corner_positions, mesh.normals, mesh.uv, mesh.triangles)
    return sum(each.nbytes for each in arrays)


def peak(action: Callable[[], Made]) -> tuple[Made, int]:
    """Return what an action gives, and the most memory that it held at once, in bytes."""
    tracemalloc.start()
    try:
        return action(), tracemalloc.get_traced_memory()[1]
    finally:
        tracemalloc.stop()


def made(solid: Solid, triangles: int) -> Mesh:
    return Request(Document(BELLY, solid=solid), Fineness(None, (triangles // 2000, 1000))).mesh


def growth(action: Callable[[Mesh], object], meshes: tuple[Mesh, Mesh]) -> float:
    """Return by how much more is held for a longer mesh, as a part of how much longer it is.

    What is held whatever the mesh, such as the tables of a chunk, does not count.
    """
    short, long = (peak(lambda mesh=mesh: action(mesh))[1] for mesh in meshes)
    return (long - short) / (size(meshes[1]) - size(meshes[0]))


@pytest.fixture(scope="module")
def meshes() -> tuple[Mesh, Mesh]:
    return made(FILLED, 200_000), made(FILLED, 800_000)


@pytest.mark.parametrize("solid", [BARE, FILLED, VESSEL], ids=["bare", "filled", "vessel"])
def test_making_holds_little_more_than_the_mesh(solid):
    both = made(solid, 400_000), made(solid, 800_000)
    assert growth(lambda mesh: made(solid, 400_000 * (1 + (mesh is both[1]))), both) < 1.25


@pytest.mark.parametrize("written", FORMATS, ids=[each.suffix for each in FORMATS])
def test_writing_holds_less_than_a_third_of_the_mesh_again(written: Format, meshes, monkeypatch):
    monkeypatch.setattr(ply, "_BLOCK", 1 << 16)
    document = Document(BELLY, solid=FILLED)

    def write(mesh: Mesh) -> None:
        counter = CountingStream()
        written.write(Request(document, made=mesh), cast(BinaryIO, counter))
        assert counter.size > 10 * len(mesh.triangles)

    assert growth(write, meshes) < 1 / 3
