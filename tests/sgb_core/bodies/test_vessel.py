from __future__ import annotations

from math import pi

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from sgb_core.bodies.body import cross_section
from sgb_core.bodies.solid import BodyKind, Rim, Solid, WallSide
from sgb_core.bodies.vessel import capacity_to, vessel_measures
from sgb_core.curves.profile import Profile
from sgb_core.findings.bodies import TightCurve
from sgb_core.surfaces.measures import area, generatrix_length, volume
from sgb_core.surfaces.revolution import RevolutionSurface
from sgb_core.surfaces.variation import Law
from tests.sgb_core.bodies.vessels import CONE, TUBE, vessel
from tests.sgb_core.surfaces.chains import BALL, RING, chain

FLARED = chain([[(15, 0), (45, 10), (10, 50), (30, 70)]])


def frustum(low: float, high: float, height: float) -> float:
    return pi * height * (low * low + low * high + high * high) / 3.0


def test_the_worked_example() -> None:
    measured = vessel_measures(RevolutionSurface(TUBE), vessel())
    assert measured.capacity == pytest.approx(pi * 17**2 * 56, rel=1e-13)
    assert measured.material_volume == pytest.approx(pi * (20**2 * 60 - 17**2 * 56), rel=1e-13)
    assert measured.wall_min == 3.0
    assert measured.inner_area == pytest.approx(2 * pi * 17 * 56 + pi * 17**2, rel=1e-12)
    assert measured.outer_area == pytest.approx(2 * pi * 20 * 60 + pi * (20**2 - 17**2), rel=1e-12)
    assert (measured.brim, measured.floor) == pytest.approx((60.0, 4.0), abs=1e-12)
    assert measured.findings == ()


@pytest.mark.parametrize("profile", [TUBE, TUBE.reversed()])
def test_the_same_outside(profile: object) -> None:
    measured = vessel_measures(RevolutionSurface(profile), vessel(side=WallSide.OUTSIDE))
    assert measured.capacity == pytest.approx(pi * 20**2 * 60, rel=1e-13)
    assert measured.material_volume == pytest.approx(pi * (23**2 * 64 - 20**2 * 60), rel=1e-13)
    assert measured.inner_area == pytest.approx(2 * pi * 20 * 60 + pi * 20**2, rel=1e-12)
    assert measured.outer_area == pytest.approx(2 * pi * 23 * 64 + pi * (23**2 - 20**2), rel=1e-12)


def test_a_cone_has_its_wall_along_the_normal() -> None:
    """The wall measured level is wall/cos of the slope; planes cut it at floor and rim."""
    level = 3.0 * np.hypot(1.0, 1.0 / 3.0)
    measured = vessel_measures(RevolutionSurface(CONE), vessel())
    inner = frustum(20 + 4 / 3 - level, 40 - level, 56)
    assert measured.capacity == pytest.approx(inner, rel=1e-12)
    assert measured.material_volume == pytest.approx(frustum(20, 40, 60) - inner, rel=1e-12)
    measured = vessel_measures(RevolutionSurface(CONE), vessel(side=WallSide.OUTSIDE))
    outer = frustum(20 - 4 / 3 + level, 40 + level, 64)
    assert measured.capacity == pytest.approx(frustum(20, 40, 60), rel=1e-12)
    assert measured.material_volume == pytest.approx(outer - frustum(20, 40, 60), rel=1e-12)


@pytest.mark.parametrize("hole", [0.0, 6.0])
@pytest.mark.parametrize("spread", [0.2, 1.0, 4.0])
def test_a_foot_that_widens_downwards_carries_its_wall_on_past_the_floor(
    hole: float, spread: float
) -> None:
    """Outside, the wall's end lies above the foot; it goes on to the floor's underside."""
    wide = 20.0 + 60.0 * spread
    bell = chain([[(wide - 20.0 * spread * k, 20.0 * k) for k in range(4)]])
    body = vessel(side=WallSide.OUTSIDE, drain_hole=hole)
    measured = vessel_measures(RevolutionSurface(bell), body)
    level = 3.0 * np.hypot(1.0, spread)
    outer = frustum(wide + 4.0 * spread + level, 20.0 + level, 64)
    inner = frustum(wide, 20, 60)
    assert measured.capacity == pytest.approx(inner, rel=1e-12)
    drilled = pi * (hole / 2.0) ** 2 * 4.0
    assert measured.material_volume == pytest.approx(outer - inner - drilled, rel=1e-12)


def test_a_level_rim_is_glazed_with_the_outside() -> None:
    """At a lip that leans out its height may round to just below the body's crest."""
    for top in np.linspace(57.0, 63.0, 25):
        points = [(40, 0), (40, 20), (15, 35), (35, float(top))]
        measured = vessel_measures(RevolutionSurface(chain([points])), vessel())
        drawn = area(RevolutionSurface(chain([points])))
        assert measured.outer_area > drawn + 2 * pi * 30 * 2.9


def test_the_round_rim_is_a_half_circle_of_the_walls_width() -> None:
    flat = vessel_measures(RevolutionSurface(TUBE), vessel())
    measured = vessel_measures(RevolutionSurface(TUBE), vessel(rim=Rim.ROUND))
    # What the half circle leaves of its square is turned about the axis at its centroid.
    half = 1.5
    corner = half * half * (1 - pi / 4)
    away = (half**3 / 2 - half**3 / 3) / corner
    lost = 2 * pi * corner * ((18.5 + away) + (18.5 - away))
    assert measured.material_volume == pytest.approx(flat.material_volume - lost, rel=1e-12)
    assert measured.brim == pytest.approx(60.0, abs=1e-12)
    gained = 2 * pi * corner * (18.5 - away)
    assert measured.capacity == pytest.approx(flat.capacity + gained, rel=1e-12)


def test_capacity_follows_the_fill_height() -> None:
    surface = RevolutionSurface(TUBE)
    for height, expected in ((0, 0), (4, 0), (14, 10), (59.5, 55.5), (60, 56), (99, 56)):
        found = capacity_to(surface, vessel(), height)
        assert found == pytest.approx(pi * 17**2 * expected, rel=1e-12, abs=1e-9)


@settings(max_examples=20, deadline=None)
@given(st.floats(5.0, 69.0), st.sampled_from(WallSide))
def test_capacity_against_brute_quadrature(height: float, side: WallSide) -> None:
    """∫ π r² dh over a million samples of the wall's curve, moved by hand."""
    body = vessel(side=side, wall=2.0)
    s = np.linspace(0.0, 1.0, 1_000_001)
    segment = FLARED.segments[0]
    point, rate = segment.point(s), segment.derivative(s)
    if side is WallSide.INSIDE:
        normal = np.stack([-rate[:, 1], rate[:, 0]], axis=1)
        point = point + 2.0 * normal / np.hypot(rate[:, 0], rate[:, 1])[:, None]
    r, h = point[:, 0], np.clip(point[:, 1], 4.0 if side is WallSide.INSIDE else 0.0, height)
    expected = pi * float((((r[1:] + r[:-1]) / 2) ** 2 * np.diff(h)).sum())
    found = capacity_to(RevolutionSurface(FLARED), body, height)
    assert found == pytest.approx(expected, rel=1e-6)


def test_a_sphere_is_a_hollow_body_without_a_brim() -> None:
    ball = RevolutionSurface(chain(BALL, (1, 3, 1, 0)))
    measured = vessel_measures(ball, vessel(wall=0.05, base=0.0))
    assert measured.capacity is None
    assert measured.brim is None
    assert capacity_to(ball, vessel(wall=0.05, base=0.0), 1.0) is None
    # Steiner: a parallel surface at distance w encloses V − A w + M w² − 4/3 π w³.
    filled = vessel_measures(ball, Solid(BodyKind.FILLED))
    assert filled.material_volume == pytest.approx(volume(ball), rel=1e-12)
    assert filled.wall_min is None
    hollow = vessel_measures(ball, vessel(wall=0.05, base=0.0, side=WallSide.OUTSIDE))
    thin = vessel_measures(ball, vessel(wall=1e-4, base=0.0, side=WallSide.OUTSIDE))
    assert thin.material_volume == pytest.approx(1e-4 * filled.outer_area, rel=1e-3)
    assert hollow.material_volume > measured.material_volume


def test_a_rings_wall_by_pappus() -> None:
    """Between parallel curves of a convex ring lie w·length ± π w² of area."""
    ring = RevolutionSurface(chain(RING, (1, 3, 1, 0), closed=True))
    measured = {
        side: vessel_measures(ring, vessel(side=side, wall=0.05)).material_volume
        for side in WallSide
    }
    length = generatrix_length(ring.profile)
    # The section is symmetric about r = 2, so its centroid is there.
    for side, sign in ((WallSide.INSIDE, -1), (WallSide.OUTSIDE, 1)):
        area = 0.05 * length + sign * pi * 0.05**2
        assert measured[side] == pytest.approx(2 * pi * 2.0 * area, rel=1e-9)
    assert vessel_measures(ring, vessel(wall=0.05)).capacity is None


@pytest.mark.parametrize("sweep", [0.5, 3.0])
def test_part_of_a_turn_is_its_share(sweep: float) -> None:
    whole = vessel_measures(RevolutionSurface(FLARED), vessel())
    part = vessel_measures(RevolutionSurface(FLARED, sweep=sweep), vessel())
    share = sweep / (2 * pi)
    assert part.capacity == pytest.approx(share * whole.capacity, rel=1e-12)
    assert part.material_volume == pytest.approx(share * whole.material_volume, rel=1e-12)


def test_the_drain_hole_counts_for_the_material_only() -> None:
    surface = RevolutionSurface(TUBE)
    whole = vessel_measures(surface, vessel())
    drilled = vessel_measures(surface, vessel(drain_hole=10.0))
    assert drilled.capacity == whole.capacity
    lost = whole.material_volume - drilled.material_volume
    assert lost == pytest.approx(pi * 5**2 * 4, rel=1e-10)


def test_base_0_leaves_the_bottom_open() -> None:
    measured = vessel_measures(RevolutionSurface(TUBE), vessel(base=0.0))
    assert measured.material_volume == pytest.approx(pi * (20**2 - 17**2) * 60, rel=1e-12)


def test_a_floor_on_the_axis_is_the_wall_unless_the_base_is_thicker() -> None:
    cup = RevolutionSurface(
        chain([[(0, 0), (7, 0), (14, 0), (20, 0)], [(20, 0), (20, 20), (20, 40), (20, 60)]])
    )
    for base, floor in ((0.0, 3.0), (2.0, 3.0), (5.0, 5.0)):
        measured = vessel_measures(cup, vessel(base=base))
        assert measured.capacity == pytest.approx(pi * 17**2 * (60 - floor), rel=1e-12)
        assert measured.floor == pytest.approx(floor, abs=1e-12)


def test_a_wall_is_as_thin_as_two_stretches_of_the_profile_come_near() -> None:
    """A flange of 2 between its drawn faces cannot hold a wall of 3 on each side."""
    flanged = chain(
        [
            [(20, 0), (20, 10), (20, 20), (20, 30)],
            [(20, 30), (25, 30), (30, 30), (35, 30)],
            [(35, 30), (35, 30.7), (35, 31.3), (35, 32)],
            [(35, 32), (30, 32), (25, 32), (20, 32)],
            [(20, 32), (20, 40), (20, 50), (20, 60)],
        ]
    )
    measured = vessel_measures(RevolutionSurface(flanged), vessel())
    assert measured.wall_min == pytest.approx(2.0, abs=1e-6)
    # At the flange's mouth the true offset bulges between two arcs about its corners.
    assert 1.0 < measured.capacity / (pi * 17**2 * 56) < 1.001


def test_a_bare_surface_has_no_material() -> None:
    with pytest.raises(ValueError, match="no material"):
        vessel_measures(RevolutionSurface(TUBE), Solid())


@pytest.mark.parametrize("drop", [-1e-3, 0.0, 1e-3])
def test_a_level_lip_may_hang_a_little(drop: float) -> None:
    """A plane through its end would cut all of the wall below it off."""
    lip = [(10, 60), (10, 67), (14, 70 + drop), (22, 70)]
    jar = chain([[(20, 0), (40, 20), (30, 45), (10, 60)], lip])
    for side in WallSide:
        body = vessel(wall=2.0, side=side)
        measured = vessel_measures(RevolutionSurface(jar), body)
        level = vessel_measures(RevolutionSurface(chain([jar.control_points[0], LEVEL])), body)
        assert measured.capacity == pytest.approx(level.capacity, rel=1e-3)
        assert measured.material_volume == pytest.approx(level.material_volume, rel=1e-3)


LEVEL = [(10, 60), (10, 67), (14, 70), (22, 70)]


def test_what_a_tight_hanging_lip_leaves_above_itself_is_no_wall() -> None:
    """A loop of the moved curve came out above the lip, was the crest, and let the air out."""
    lip = chain(
        [[(16.679, 76.391), (11, 76.42), (7, 74.42), (6, 71.42)]], (3.738, 2.675, 2.912, 0.913)
    )
    belly = chain([[(6, 71.42), (17, 62), (42, 33), (16.7, 0)]])
    jar = Profile((*lip.segments, *belly.segments))
    body = vessel(wall=7.5, side=WallSide.OUTSIDE, base=0.0)
    measured = vessel_measures(RevolutionSurface(jar), body)
    assert measured.brim == pytest.approx(76.391, abs=1e-4)
    drawn = volume(RevolutionSurface(jar))
    assert measured.capacity == pytest.approx(drawn, rel=1e-4)


def test_what_is_doubtful_at_many_angles_is_named_once() -> None:
    tight = chain([[(30, 0), (60, 0), (60, 2), (60, 4)], [(60, 4), (60, 20), (60, 40), (60, 60)]])
    laws = (
        Law("lambda2", "cosine", 1.0, 5.0, count=3),
        Law("omega", "cosine", 0.5, 1.0, count=3),
    )
    surface, solid = RevolutionSurface(tight, laws=laws), vessel(wall=8.0)
    places = {
        finding.where
        for theta in (0.0, 0.3, 0.6)
        for finding in cross_section(RevolutionSurface(surface.profile_at(theta)), solid).findings
    }
    assert len(places) > 1
    (found,) = vessel_measures(surface, solid).findings
    assert found.subject == (TightCurve, 0)
