from __future__ import annotations

from dataclasses import replace
from math import pi

import numpy as np
import pytest

from sgb_core.bodies.body import SolidError, body_mesh
from sgb_core.bodies.solid import WallSide
from sgb_core.bodies.vessel import vessel_measures
from sgb_core.curves.segment import ShapeParameters
from sgb_core.findings.words import say
from sgb_core.surfaces.revolution import RevolutionSurface
from sgb_core.surfaces.variation import Law
from tests.sgb_core.bodies.vessels import CONE, TUBE, vessel
from tests.sgb_core.surfaces.chains import chain

K = 4.0 * (2.0**0.5 - 1.0) / 3.0
BOWL = chain([[(0, 0), (50 * K, 0), (50, 50 - 50 * K), (50, 50)]])
PLATE = chain([[(0, 0), (30, 0), (60, 8), (90, 20)]])


def gained(surface: RevolutionSurface, body) -> tuple[float, float]:
    """Return what a foot ring adds to the capacity and to the material."""
    ring, none = (vessel_measures(surface, b) for b in (body, replace(body, foot_ring=0.0)))
    return ring.capacity - none.capacity, ring.material_volume - none.material_volume


@pytest.mark.parametrize("profile", [TUBE, CONE, TUBE.reversed()])
@pytest.mark.parametrize("hole", [0.0, 6.0])
def test_a_level_foot_stands_on_a_ring_below_its_edge(profile, hole) -> None:
    body = vessel(foot_ring=5.0, drain_hole=hole)
    held, more = gained(RevolutionSurface(profile), body)
    assert held == 0.0
    assert more == pytest.approx(pi * (20**2 - 17**2) * 5, rel=1e-12)
    mesh = body_mesh(RevolutionSurface(profile), body)
    assert mesh.is_watertight
    assert mesh.bounds[0][2] == -5.0


def test_outside_it_stands_below_the_wall() -> None:
    body = vessel(side=WallSide.OUTSIDE, foot_ring=5.0)
    held, more = gained(RevolutionSurface(TUBE), body)
    assert held == 0.0
    assert more == pytest.approx(pi * (23**2 - 20**2) * 5, rel=1e-12)
    assert body_mesh(RevolutionSurface(TUBE), body).bounds[0][2] == -9.0


@pytest.mark.parametrize(("side", "radius"), [(WallSide.INSIDE, 25.0), (WallSide.OUTSIDE, 26.5)])
def test_a_round_bowl_stands_on_a_ring_of_half_its_width(side, radius) -> None:
    body = vessel(side=side, base=0.0, foot_ring=5.0)
    mesh = body_mesh(RevolutionSurface(BOWL), body, tolerance=0.01)
    low = mesh.bounds[0][2]
    assert low == pytest.approx(-5.0 if side is WallSide.INSIDE else -8.0, abs=1e-12)
    sole = mesh.positions[mesh.positions[:, 2] <= low + 1e-9]
    across = np.hypot(sole[:, 0], sole[:, 1])
    assert across.max() == pytest.approx(radius, abs=0.01)
    assert across.min() == pytest.approx(radius - 3.0, abs=0.01)
    held, more = gained(RevolutionSurface(BOWL), body)
    assert held == 0.0
    # Between the ring as high as its inside and as high as its outside.
    outer = radius * 2.0
    heights = [outer - (outer**2 - r**2) ** 0.5 + 5.0 for r in (radius - 3.0, radius)]
    shell = pi * (radius**2 - (radius - 3.0) ** 2)
    assert shell * heights[0] < more < shell * heights[1]


def test_a_steep_bottom_has_its_ring_where_it_rises_more_steeply_than_45_degrees() -> None:
    pear = chain([[(0, 0), (20, 0), (20, 20), (40, 60)]])
    mesh = body_mesh(RevolutionSurface(pear), vessel(base=0.0, foot_ring=4.0), tolerance=0.01)
    sole = mesh.positions[mesh.positions[:, 2] <= -4.0 + 1e-9]
    s = np.linspace(0.0, 1.0, 100_001)
    r, h = 60 * s * (1 - s) ** 2 + 60 * s**2 * (1 - s) + 40 * s**3, 60 * s**2 * (1 - s) + 60 * s**3
    steep = np.gradient(h) > np.gradient(r)
    assert np.hypot(sole[:, 0], sole[:, 1]).max() == pytest.approx(r[np.argmax(steep)], abs=0.01)


@pytest.mark.parametrize("profile", [TUBE, BOWL, PLATE])
@pytest.mark.parametrize("side", WallSide)
@pytest.mark.parametrize("sweep", [2.0 * pi, 4.0])
def test_it_is_closed_in_part_turns_and_with_laws(profile, side, sweep) -> None:
    bent = profile.with_segments(
        segment.with_shape(ShapeParameters(1.0, 3.0, 1.0, 0.5)) for segment in profile.segments
    )
    for laws in ((), (Law("lambda2", "cosine", 2.0, 4.0, count=3),)):
        surface = RevolutionSurface(bent, sweep=sweep, laws=laws)
        body = vessel(side=side, foot_ring=2.0)
        mesh = body_mesh(surface, body, samples=(8, 24))
        assert mesh.is_watertight
        assert mesh.volume == pytest.approx(
            vessel_measures(surface, body).material_volume, rel=0.06
        )


@pytest.mark.parametrize(("wall", "hole"), [(21.0, 0.0), (3.0, 36.0)])
def test_a_foot_without_room_for_it_is_refused_in_words(wall, hole) -> None:
    wide = chain([[(20, 0), (60, 10), (60, 30), (60, 60)]])
    body = vessel(wall=wall, drain_hole=hole, foot_ring=3.0)
    with pytest.raises(SolidError, match=r"solid\.foot_ring: a ring as wide as the wall"):
        body_mesh(RevolutionSurface(wide), body)


def test_a_floor_outside_is_flat_where_the_wall_would_reach_the_axis_above_its_underside() -> None:
    plate = RevolutionSurface(chain([[(20, 0), (45, 1.8), (65, 3.3), (95, 5.7)]]))
    body = vessel(wall=1.5, side=WallSide.OUTSIDE, base=7.0)
    mesh = body_mesh(plate, body)
    assert mesh.bounds[0][2] == -7.0
    under = mesh.positions[mesh.positions[:, 2] <= -7.0 + 1e-9]
    assert np.hypot(under[:, 0], under[:, 1]).max() == pytest.approx(20.1, abs=0.2)
    assert any("cut square" in say(each) for each in vessel_measures(plate, body).findings)
