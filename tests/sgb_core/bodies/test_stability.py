"""Centre of mass, standing and overhang against bodies known in closed form."""

from __future__ import annotations

import itertools
from math import atan2, degrees, pi, sqrt

import numpy as np
import pytest

from sgb_core.bodies.stability import centre_of_mass, overhang, stand
from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import Segment
from sgb_core.surfaces.mesh import Mesh
from sgb_core.surfaces.revolution import RevolutionSurface
from sgb_core.surfaces.tessellation import tessellate

UP = np.eye(3)


def turned(*corners: tuple[float, float], sweep: float = 2.0 * pi) -> Mesh:
    """Return the mesh of straight lines turned about z."""
    steps = itertools.pairwise(corners)
    segments = [Segment(np.linspace(first, last, 4).astype(float)) for first, last in steps]
    surface = RevolutionSurface(Profile.of(segments), sweep=sweep)
    return tessellate(surface, samples=(2, 256))


def test_a_cone_has_its_centre_a_quarter_up_and_stands() -> None:
    cone = turned((0.0, 0.0), (10.0, 0.0), (0.0, 40.0))
    np.testing.assert_allclose(centre_of_mass(cone), (0.0, 0.0, 10.0), atol=1e-9)
    found = stand(cone, UP)
    assert found.stands
    assert found.margin == pytest.approx(10.0, rel=1e-3)
    assert found.tip_deg == pytest.approx(45.0, abs=0.05)
    assert found.tip_deg == pytest.approx(degrees(atan2(found.margin, 10.0)))


def test_a_cone_on_its_tip_falls() -> None:
    cone = turned((0.0, 0.0), (10.0, 40.0), (0.0, 40.0))
    found = stand(cone, UP)
    assert not found.stands
    assert found.tip_deg == 0.0


def test_overhang_counts_what_leans_beyond_the_angle() -> None:
    cone = turned((0.0, 0.0), (10.0, 10.0), (0.0, 10.0))
    lateral, lid = pi * 10.0 * sqrt(200.0), pi * 100.0
    share = lateral / (lateral + lid)
    assert overhang(cone, UP[2], 44.0) == pytest.approx(share, rel=1e-3)
    assert overhang(cone, UP[2], 46.0) == 0.0


def test_the_bed_is_no_overhang() -> None:
    cylinder = turned((0.0, 0.0), (10.0, 0.0), (10.0, 30.0), (0.0, 30.0))
    assert overhang(cylinder, UP[2], 45.0) == 0.0
    assert overhang(cylinder, -UP[2], 45.0) == 0.0


def test_nothing_has_no_centre() -> None:
    flat = Mesh(np.zeros((3, 3)), np.arange(3), UP, np.zeros((3, 2)), np.arange(3)[None])
    with pytest.raises(ValueError, match="no centre of mass"):
        centre_of_mass(flat)
