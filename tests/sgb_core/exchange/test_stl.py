import io
import re
import shutil
import subprocess

import numpy as np
import pytest
import trimesh
from hypothesis import given, settings

from sgb_core import exchange
from sgb_core.exchange.body import exported_mesh
from sgb_core.exchange.stl import FACET, write_stl
from sgb_core.surfaces.measures import volume
from sgb_core.surfaces.mesh import Mesh
from sgb_core.surfaces.placement import Placement
from tests.sgb_core.exchange.shapes import closed_documents, ring, spindle


def facets_of(mesh: Mesh) -> np.ndarray:
    stream = io.BytesIO()
    write_stl(mesh, stream)
    data = stream.getvalue()
    assert data[:5] != b"solid"
    facets = np.frombuffer(data[84:], FACET)
    assert int.from_bytes(data[80:84], "little") == len(facets)
    return facets


def edges_pair_up(corners: np.ndarray) -> bool:
    """Whether each directed edge, compared bit by bit, has exactly one partner."""
    edges = {}
    for a, b, c in corners:
        points = [p.tobytes() for p in (a, b, c)]
        for start, end in zip(points, points[1:] + points[:1], strict=True):
            edges[start, end] = edges.get((start, end), 0) + 1
    return all(edges.get((b, a), 0) == count for (a, b), count in edges.items())


@settings(max_examples=25)
@given(closed_documents())
def test_closed_bodies_are_watertight_and_outward_as_stored(document):
    mesh = exported_mesh(document, samples=(12, 24))
    facets = facets_of(mesh)
    assert edges_pair_up(facets["corners"])
    a, b, c = np.moveaxis(facets["corners"].astype(float), 1, 0)
    assert np.einsum("ij,ij->", a, np.cross(b, c)) / 6 == pytest.approx(mesh.volume, rel=1e-4)
    assert mesh.volume > 0


def test_the_volume_tends_to_the_exact_one():
    document = spindle()
    facets = facets_of(exported_mesh(document, samples=(200, 400)))
    a, b, c = np.moveaxis(facets["corners"].astype(float), 1, 0)
    read = np.einsum("ij,ij->", a, np.cross(b, c)) / 6
    assert read == pytest.approx(volume(document.surface), rel=1e-4)


def test_normals_are_unit_and_those_of_the_facets():
    facets = facets_of(exported_mesh(spindle(), samples=(20, 30)))
    a, b, c = np.moveaxis(facets["corners"].astype(float), 1, 0)
    expected = np.cross(b - a, c - a)
    expected /= np.linalg.norm(expected, axis=1, keepdims=True)
    assert np.abs(facets["normal"] - expected).max() < 1e-3


@pytest.mark.parametrize("scale", [1e-9, 1e8])
def test_normals_do_not_depend_on_the_size(scale):
    mesh = exported_mesh(spindle(), samples=(5, 8))
    scaled = Mesh(
        mesh.positions * scale, mesh.corner_positions, mesh.normals, mesh.uv, mesh.triangles
    )
    assert np.allclose(facets_of(scaled)["normal"], facets_of(mesh)["normal"], atol=1e-4)


def test_far_away_single_precision_merges_points_and_stays_watertight():
    document = spindle(placement=Placement(translation=(1e7, 1e7, 1e7)))
    mesh = exported_mesh(document, samples=(40, 60))
    facets = facets_of(mesh)
    assert 0 < len(facets) < len(mesh.triangles)
    assert edges_pair_up(facets["corners"])


def test_trimesh_reads_a_ring(tmp_path):
    path = tmp_path / "ring.STL"
    exchange.write(ring(), path, samples=(20, 40))
    read = trimesh.load_mesh(path)
    assert read.is_watertight
    assert read.is_winding_consistent
    assert read.euler_number == 0
    assert read.volume == pytest.approx(exported_mesh(ring(), samples=(20, 40)).volume, rel=1e-5)


@pytest.mark.skipif(shutil.which("admesh") is None, reason="admesh is not installed")
def test_admesh_has_nothing_to_repair(tmp_path):
    path = tmp_path / "spindle.stl"
    exchange.write(spindle(), path)
    # Some versions print bytes that are no text before their figures.
    printed = subprocess.run(["admesh", path], capture_output=True, check=True).stdout
    text = printed.decode(errors="replace")
    for what in ("disconnected facets", "Degenerate facets", "Edges fixed", "Facets reversed"):
        counts = re.search(rf"{what}\s*:\s*(\d+)", text)
        assert counts is not None, what
        assert int(counts[1]) == 0, what
