"""Random documents through all measures and meshes.

A few in the test command; SGB_RANDOM=20000 in the environment names how many, and
SGB_RANDOM_FIRST from which number on.
"""

from __future__ import annotations

import json
import os
from math import pi
from typing import Any

import numpy as np
import pytest

from sgb_core.bodies.body import body_mesh
from sgb_core.bodies.cross_section import cross_section
from sgb_core.bodies.solid import BodyKind
from sgb_core.bodies.traces import ends_of
from sgb_core.document.evaluation import evaluate
from sgb_core.document.file import project_file
from sgb_core.document.measures import measures
from sgb_core.document.model import Document
from sgb_core.findings.bodies import TouchingCircle
from sgb_core.findings.errors import FindingError
from sgb_core.surfaces.laws.law import RADIUS
from sgb_core.surfaces.mesh import Mesh
from tests.sgb_core.document.random_documents import random_project

COUNT = int(os.environ.get("SGB_RANDOM", "20"))
FIRST = int(os.environ.get("SGB_RANDOM_FIRST", "0"))
# Documents of one test; each is named where it fails.
EACH = 10
SAMPLES = (4, 9)


def document_of(number: int) -> Document:
    """Return a random document, read as a file is."""
    return project_file.loads(json.dumps(random_project(number)).encode())


def check_measures(document: Document) -> None:
    """Check that what is printed of a document is finite and no absurd number."""
    measured = measures(evaluate(document))
    json.dumps(measured, allow_nan=False)
    points, size = document.profile.control_points, document.profile.size
    share = document.revolution.sweep_deg / 360.0
    # A law of the radius makes it at most so much wider.
    wider = 1.4 ** sum(law.parameter == RADIUS for law in document.variation)
    points = points * (wider, 1.0)
    reach, tall = float(np.abs(points[..., 0]).max()), float(np.ptp(points[..., 1]))
    low, high = np.array(measured["bounds"], dtype=float)
    assert (low <= high).all()
    # The box of a turned cylinder, in any direction, and rounding where it is placed.
    slack = 1e-9 * size + 1e-14 * float(np.abs([low, high]).max())
    assert float(np.linalg.norm(high - low)) <= 3.0**0.5 * np.hypot(2.0 * reach, tall) + slack
    legs = np.diff(points, axis=1)
    length = measured["generatrix_length"]
    assert 0.0 <= length <= float(np.hypot(legs[..., 0], legs[..., 1]).sum()) * (1.0 + 1e-12)
    assert measured["volume"] >= 0.0
    assert measured["area"] >= 0.0
    if not document.variation:
        assert measured["area"] <= 2.0 * pi * share * reach * length * (1.0 + 1e-9)
    for key in ("bending_energy", "surface_bending_energy"):
        assert measured[key] is None or measured[key] >= 0.0
    _check_body(document, measured, share, reach, tall)


def _check_body(
    document: Document, measured: dict[str, Any], share: float, reach: float, tall: float
) -> None:
    """Check that a body lies within a cylinder round its walls, and its wall within its own."""
    solid = document.solid
    more = 0.0 if solid.kind is BodyKind.FILLED else solid.wall + solid.base + solid.foot_ring
    # A wall goes on along its end's tangent to the plane of the floor.
    more *= 10.0
    most = share * pi * (reach + more) ** 2 * (tall + 2.0 * more) * (1.0 + 1e-9)
    for key in ("capacity", "material_volume"):
        assert measured.get(key) is None or 0.0 < measured[key] <= most, key
    wall = measured.get("wall_min")
    assert wall is None or 0.0 <= wall <= solid.wall * (1.0 + 1e-9)


def check_mesh(document: Document) -> None:
    """Check that a body's mesh is closed, that of a surface where its profile is."""
    surface, solid = document.surface, document.solid
    try:
        mesh = body_mesh(surface, solid, samples=SAMPLES)
    except FindingError:
        return
    assert np.isfinite(mesh.positions).all()
    assert np.isfinite(mesh.normals).all()
    assert np.isfinite(mesh.uv).all()
    if solid.kind is BodyKind.SURFACE:
        return
    assert mesh.is_watertight, "open"
    assert mesh.volume > 0.0, "inverted"
    ends, counts = welded(mesh)
    assert (counts % 2 == 0).all(), "an odd number of faces at an edge"
    many = ends[counts > 2]
    if not len(many):
        return
    local = (many - np.asarray(surface.placement.translation)) @ surface.directions(np.array(0.0)).T
    r, h = np.hypot(local[..., 0], local[..., 1]), local[..., 2]
    size = surface.profile.size
    circles = [
        f.where for f in cross_section(surface, solid).findings if isinstance(f, TouchingCircle)
    ]
    said = r < 1e-5 * size
    for radius, height in circles:
        said |= np.hypot(r - abs(radius), h - height) < 1e-4 * size
    assert surface.laws or said.all(), "more than two faces at an edge"


def welded(mesh: Mesh) -> tuple[np.ndarray, np.ndarray]:
    """Return the ends of each edge (E, 2, 3), and how many faces it has, welded in single."""
    middle = (mesh.positions.min(axis=0) + mesh.positions.max(axis=0)) / 2.0
    places, number = np.unique(
        (mesh.positions - middle).astype(np.float32) + np.float32(0.0), axis=0, return_inverse=True
    )
    faces = number.reshape(-1)[mesh.faces]
    kept = faces[(faces != np.roll(faces, 1, axis=1)).all(axis=1)]
    pairs = np.sort(np.stack([kept, np.roll(kept, 1, axis=1)], axis=-1).reshape(-1, 2), axis=1)
    edges, counts = np.unique(pairs, axis=0, return_counts=True)
    return places[edges].astype(float) + middle, counts


@pytest.mark.parametrize("first", range(FIRST, FIRST + COUNT, EACH))
def test_random_documents_are_measured_and_meshed(first: int) -> None:
    for number in range(first, min(first + EACH, FIRST + COUNT)):
        document = document_of(number)
        check_measures(document)
        check_mesh(document)


@pytest.mark.parametrize("number", [61407, 61869])
def test_what_ended_in_an_error_of_the_overlay_is_measured_or_said(number: int) -> None:
    document = document_of(number)
    check_measures(document)
    check_mesh(document)


@pytest.mark.parametrize(
    "number",
    [
        pytest.param(60424, id="which of two parts is larger changes over the turn"),
        pytest.param(61894, id="what leads to the axis is shorter than samples are apart"),
        pytest.param(61027, id="a vessel flatter than rounding"),
        pytest.param(64467, id="a filled body flatter than rounding"),
        pytest.param(66936, id="a flat profile that lies on itself, under laws of the radius"),
        pytest.param(67337, id="a flat profile that lies on itself"),
    ],
)
def test_what_was_open_inverted_or_absurd_is_right_or_said(number: int) -> None:
    document = document_of(number)
    check_measures(document)
    check_mesh(document)


@pytest.mark.parametrize("number", [70019, 70033, 70132])
def test_a_round_rim_runs_into_its_wall_where_the_two_touch(number: int) -> None:
    document = document_of(number)
    section = cross_section(document.surface, document.solid)
    for outline in (*section.outlines, *section.hollow):
        for ring in outline.rings:
            ends = ends_of(ring)
            gaps = ends[:, 0] - np.roll(ends[:, 1], 1, axis=0)
            assert np.hypot(*gaps.T).max() <= 1e-5 * document.profile.size
