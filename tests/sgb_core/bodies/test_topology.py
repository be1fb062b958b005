"""What a mesh knows of itself from how it was made is what its triangles say."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from sgb_core.bodies.body_mesh import body_mesh
from sgb_core.bodies.solid import BodyKind, Solid
from sgb_core.findings.errors import FindingError
from sgb_core.surfaces.mesh import Mesh, are_closed
from sgb_core.surfaces.revolution import RevolutionSurface
from sgb_core.surfaces.tessellation import tessellate
from tests.sgb_core.bodies.vessels import TUBE, pots, vessel
from tests.sgb_core.surfaces.chains import BALL, CROSSING, PAPER, RING, TOWER, chain, surfaces


def check(mesh: Mesh) -> None:
    assert mesh.closed in (None, are_closed(mesh.faces, len(mesh.positions)))
    a, b, c = mesh.faces.T
    assert not ((a == b) | (b == c) | (c == a)).any()
    assert len(np.unique(mesh.triangles)) == len(mesh.normals)
    assert len(np.unique(mesh.corner_positions)) == len(mesh.positions)


@settings(max_examples=150)
@given(surfaces(), st.integers(1, 4), st.integers(3, 9))
def test_of_a_surface(surface, per_segment, columns):
    try:
        mesh = tessellate(surface, samples=(per_segment, columns))
    except FindingError:
        assume(False)
    check(mesh)


@settings(max_examples=25)
@given(pots(), st.sampled_from([Solid(BodyKind.FILLED), vessel(), vessel(base=0.0)]))
def test_of_a_body(surface, solid):
    try:
        mesh = body_mesh(surface, solid, samples=(3, 7))
    except FindingError:
        assume(False)
    check(mesh)


@pytest.mark.parametrize(
    ("points", "closed"), [(BALL, True), (TOWER, False), (CROSSING, False), (RING, True)]
)
@pytest.mark.parametrize("columns", [3, 4, 5, 12])
def test_a_whole_turn_knows(points, closed, columns):
    surface = RevolutionSurface(chain(points, closed=points is RING))
    mesh = tessellate(surface, samples=(6, columns))
    assert mesh.closed is closed
    check(mesh)


def test_what_differs_around_or_has_end_faces_is_looked_at():
    ball = chain(BALL)
    assert tessellate(RevolutionSurface(ball, laws=(PAPER,)), samples=(4, 9)).closed is None
    half = RevolutionSurface(chain(TUBE.control_points), sweep=np.pi)
    for surface, solid in ((half, vessel()), (half, Solid())):
        mesh = body_mesh(surface, solid, samples=(4, 9))
        assert mesh.closed is None
        assert mesh.is_watertight is (solid.kind is not BodyKind.SURFACE)
