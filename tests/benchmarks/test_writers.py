"""How long making a mesh and writing it take beside other programs and beside the bare bytes.

``pytest tests/benchmarks/test_writers.py -s`` prints medians of interleaved
runs; only their ratios mean anything, since a machine's speed wanders.
"""

from __future__ import annotations

import zipfile
from collections.abc import Callable
from functools import partial
from pathlib import Path
from statistics import median
from time import perf_counter

import numpy as np
import pytest

from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import Segment, ShapeParameters
from sgb_core.document.model import Unit
from sgb_core.exchange.glb import write_glb
from sgb_core.exchange.obj import write_obj
from sgb_core.exchange.ply import write_ply
from sgb_core.exchange.stl import write_stl
from sgb_core.exchange.threemf import write_threemf
from sgb_core.surfaces.mesh import Mesh
from sgb_core.surfaces.revolution import RevolutionSurface
from sgb_core.surfaces.tessellation import tessellate

ROUNDS = 5
NAMED = {"unit": Unit.MM, "name": "ring"}
WRITERS = {
    ".stl": write_stl,
    ".obj": write_obj,
    ".ply": write_ply,
    ".glb": partial(write_glb, **NAMED),
    ".3mf": partial(write_threemf, **NAMED),
}


def ring() -> RevolutionSurface:
    upper = Segment([(40, 0), (60, 0), (60, 30), (40, 30)], ShapeParameters(0.5, 3.0, 0.5, 1.0))
    lower = Segment([(40, 30), (20, 30), (20, 0), (40, 0)])
    return RevolutionSurface(Profile((upper, lower), closed=True))


def made() -> Mesh:
    """Return a ring of a million triangles."""
    return tessellate(ring(), samples=(250, 1000))


@pytest.fixture(scope="module")
def million() -> Mesh:
    return made()


def medians(rounds: int, **ways: Callable[[], object]) -> dict[str, float]:
    """Return the median time of each way in seconds, run in turns after one warm-up each."""
    times: dict[str, list[float]] = {name: [] for name in ways}
    for number in range(rounds + 1):
        for name, way in ways.items():
            start = perf_counter()
            way()
            if number:
                times[name].append(perf_counter() - start)
    return {name: median(values) for name, values in times.items()}


def ours(mesh: Mesh, path: Path) -> Callable[[], None]:
    def write() -> None:
        with path.open("wb") as stream:
            WRITERS[path.suffix](mesh, stream)

    return write


def bare(path: Path) -> Callable[[], None]:
    """Return what writes the bytes that are now at ``path`` elsewhere, with nothing to compute."""
    data = np.fromfile(path, np.uint8)
    return lambda: data.tofile(path.with_name("bare"))


def poly_data(mesh: Mesh, precision: type):
    """Return the same mesh for VTK, arrays prepared so that only writing is timed."""
    from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
    from vtkmodules.vtkCommonCore import vtkPoints
    from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

    positions = mesh.positions[mesh.corner_positions]
    data, points, cells = vtkPolyData(), vtkPoints(), vtkCellArray()
    points.SetData(numpy_to_vtk(positions.astype(precision), deep=True))
    cells.SetData(3, numpy_to_vtkIdTypeArray(mesh.triangles.ravel(), deep=True))
    data.SetPoints(points)
    data.SetPolys(cells)
    data.GetPointData().SetNormals(numpy_to_vtk(mesh.normals.astype(precision), deep=True))
    data.GetPointData().SetTCoords(numpy_to_vtk(mesh.uv.astype(precision), deep=True))
    return data


def by_vtk(writer, mesh: Mesh, path: Path, precision: type = float) -> Callable[[], object]:
    writer.SetInputData(poly_data(mesh, precision))
    writer.SetFileName(str(path))
    return writer.Write


def report(benchmark, title: str, times: dict[str, float]) -> None:
    """Print the medians and keep them with the benchmark's own record."""
    benchmark.extra_info.update(times)
    own = times["ours"]
    print(f"\n{title}: ours {1e3 * own:.0f} ms")
    for name, time in times.items():
        if name != "ours":
            print(f"  {name:<10} {1e3 * time:6.0f} ms   ours takes {own / time:.2f} of it")


def by_numpy_stl(mesh: Mesh, path: Path) -> Callable[[], object]:
    from stl.mesh import Mesh as Facets

    data = np.zeros(len(mesh.triangles), dtype=Facets.dtype)
    data["vectors"] = mesh.positions[mesh.faces]
    # It finds the normals when it writes, as ours does.
    return lambda: Facets(data, calculate_normals=False).save(str(path))


def test_stl_beside_the_bare_bytes_vtk_trimesh_and_numpy_stl(benchmark, million, tmp_path):
    import trimesh
    from vtkmodules.vtkIOGeometry import vtkSTLWriter

    path = tmp_path / "a.stl"
    ours(million, path)()
    vtk_writer = vtkSTLWriter()
    vtk_writer.SetFileTypeToBinary()
    other = trimesh.Trimesh(million.positions, million.faces, process=False)
    times = medians(
        ROUNDS,
        ours=ours(million, path),
        bare=bare(path),
        vtk=by_vtk(vtk_writer, million, tmp_path / "vtk.stl"),
        trimesh=lambda: other.export(tmp_path / "trimesh.stl"),
        numpy_stl=by_numpy_stl(million, tmp_path / "numpy-stl.stl"),
    )
    report(benchmark, f"STL, {len(million.triangles):,} triangles", times)
    benchmark.pedantic(ours(million, path), rounds=1)
    print(f"  above the bare bytes: {1e3 * (times['ours'] - times['bare']):.0f} ms")


def test_obj_beside_the_bare_bytes_and_vtk(benchmark, million, tmp_path):
    from vtkmodules.vtkIOGeometry import vtkOBJWriter

    path = tmp_path / "a.obj"
    ours(million, path)()
    times = medians(
        ROUNDS,
        ours=ours(million, path),
        bare=bare(path),
        vtk=by_vtk(vtkOBJWriter(), million, tmp_path / "vtk.obj"),
        vtk_single=by_vtk(vtkOBJWriter(), million, tmp_path / "vtk1.obj", np.float32),
    )
    report(benchmark, f"OBJ, {len(million.triangles):,} triangles", times)
    benchmark.pedantic(ours(million, path), rounds=1)


def test_ply_beside_the_bare_bytes_and_vtk(benchmark, million, tmp_path):
    from vtkmodules.vtkIOPLY import vtkPLYWriter

    path = tmp_path / "a.ply"
    ours(million, path)()
    times = medians(
        ROUNDS,
        ours=ours(million, path),
        bare=bare(path),
        vtk=by_vtk(vtkPLYWriter(), million, tmp_path / "vtk.ply", np.float32),
    )
    report(benchmark, f"PLY, {len(million.triangles):,} triangles", times)
    benchmark.pedantic(ours(million, path), rounds=1)


def test_glb_beside_the_bare_bytes_and_trimesh(benchmark, million, tmp_path):
    import trimesh

    path = tmp_path / "a.glb"
    ours(million, path)()
    places = million.positions[million.corner_positions]
    other = trimesh.Trimesh(
        places, million.triangles, vertex_normals=million.normals, process=False
    )
    times = medians(
        ROUNDS,
        ours=ours(million, path),
        bare=bare(path),
        trimesh=lambda: other.export(tmp_path / "trimesh.glb"),
    )
    report(benchmark, f"GLB, {len(million.triangles):,} triangles", times)
    benchmark.pedantic(ours(million, path), rounds=1)


def test_3mf_beside_the_bare_bytes_and_one_thread_on_the_same_text(benchmark, million, tmp_path):
    path = tmp_path / "a.3mf"
    ours(million, path)()
    with zipfile.ZipFile(path) as package:
        text = package.read("3D/3dmodel.model")

    def deflate() -> None:
        with zipfile.ZipFile(tmp_path / "zip.3mf", "w", zipfile.ZIP_DEFLATED) as package:
            package.writestr("3D/3dmodel.model", text, compresslevel=2)

    times = medians(ROUNDS, ours=ours(million, path), bare=bare(path), zipfile=deflate)
    report(benchmark, f"3MF, {len(million.triangles):,} triangles", times)
    benchmark.pedantic(ours(million, path), rounds=1)


def test_making_beside_a_copy_of_the_arrays_and_vtk(benchmark, million):
    import pyvista

    arrays = (
        million.positions,
        million.corner_positions,
        million.normals,
        million.uv,
        million.triangles,
    )
    section = ring().section.on(np.linspace(0.0, 1.0, 251)).reshape(-1, 2)
    line = pyvista.MultipleLines(np.stack([section[:, 0], 0.0 * section[:, 0], section[:, 1]], -1))
    times = medians(
        ROUNDS,
        ours=made,
        copy=lambda: [each.copy() for each in arrays],
        vtk=lambda: line.extrude_rotate(resolution=1000, capping=False).triangulate(),
    )
    report(benchmark, f"Making {len(million.triangles):,} triangles", times)
    benchmark.pedantic(made, rounds=1)
