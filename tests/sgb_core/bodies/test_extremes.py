"""Bodies at the edge of what can be made: one body, or one line, and never a negative number."""

from __future__ import annotations

from math import pi

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sgb_core.bodies.body import SolidError, body_mesh
from sgb_core.bodies.cross_section import cross_section
from sgb_core.bodies.solid import BodyKind, Solid, WallSide
from sgb_core.bodies.vessel import vessel_measures
from sgb_core.curves.primitives import cubic, line
from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import Segment, ShapeParameters
from sgb_core.findings.bodies import Crumb, LoosePart, NoBodyFor, WallOutOfReach
from sgb_core.findings.words import say
from sgb_core.surfaces.revolution import RevolutionSurface
from sgb_core.surfaces.variation import Law

TUBE = RevolutionSurface(Profile.of([line((20.0, 0.0), (20.0, 60.0))]))
PLATE = RevolutionSurface(Profile.of([line((40.0, 0.0), (10.0, 0.0))]))
# A bottle whose bottom rises to a point on the axis, 12 above where it stands.
PUNT = RevolutionSurface(
    Profile.of(
        [
            cubic([(0.0, 12.0), (10.0, 12.0), (25.0, 8.0), (30.0, 0.0)]),
            line((30.0, 0.0), (30.0, 80.0)),
        ]
    )
)


@pytest.mark.parametrize("wall", [1e-9, 1e-4, 1e3, 1e9])
@pytest.mark.parametrize("side", WallSide)
def test_walls_beyond_any_reason_are_refused_with_what_is_allowed(wall, side) -> None:
    with pytest.raises(SolidError) as refused:
        vessel_measures(TUBE, Solid(BodyKind.VESSEL, wall, side, 0.0))
    assert isinstance(refused.value.finding, WallOutOfReach)
    assert refused.value.finding.wall == wall
    low, high = refused.value.finding.low, refused.value.finding.high
    assert vessel_measures(TUBE, Solid(BodyKind.VESSEL, 1.01 * low, side, 0.0)).capacity > 0.0
    assert low < 1.0 < high


def test_a_flat_plate_is_a_dish_or_nothing() -> None:
    dish = Solid(BodyKind.VESSEL, 3.0, WallSide.OUTSIDE, 3.0)
    measured = vessel_measures(PLATE, dish)
    # A ring below the plate, and the floor under the hole in it.
    assert measured.material_volume >= pi * (40.0**2 - 10.0**2) * 3.0 * (1 - 1e-9)
    assert body_mesh(PLATE, dish, tolerance=0.1).is_watertight
    with pytest.raises(SolidError, match="nothing is left"):
        vessel_measures(PLATE, Solid(BodyKind.VESSEL, 3.0, WallSide.INSIDE, 0.0))


def test_a_turn_of_almost_nothing_under_a_law_has_a_body() -> None:
    sliver = RevolutionSurface.of_degrees(
        TUBE.profile, sweep_deg=1e-12, laws=(Law("lambda2", "cosine", 1.0, 4.0),)
    )
    measured = vessel_measures(sliver, Solid(BodyKind.VESSEL, 3.0, WallSide.INSIDE, 3.0))
    whole = pi * 17.0**2 * 57.0
    assert measured.capacity == pytest.approx(whole * 1e-12 / 360.0, rel=1e-9)


def test_the_floor_of_a_punt_counts_from_its_lowest_point() -> None:
    wall, base = 2.0, 8.0
    without = vessel_measures(PUNT, Solid(BodyKind.VESSEL, wall, WallSide.INSIDE, 0.0))
    filled = vessel_measures(PUNT, Solid(BodyKind.VESSEL, wall, WallSide.INSIDE, base))
    # The channel around the punt is filled up to 8, of which the wall has some already.
    lost = without.capacity - filled.capacity
    assert 0.0 < lost < pi * 30.0**2 * base
    heights = body_mesh(
        PUNT, Solid(BodyKind.VESSEL, wall, WallSide.INSIDE, base), tolerance=0.05
    ).positions[:, 2]
    assert heights.min() == pytest.approx(0.0, abs=1e-6)


def test_nothing_spans_the_recess_of_a_punt_with_its_wall_outside() -> None:
    thin = vessel_measures(PUNT, Solid(BodyKind.VESSEL, 2.0, WallSide.OUTSIDE, 0.0))
    thick = vessel_measures(PUNT, Solid(BodyKind.VESSEL, 2.0, WallSide.OUTSIDE, 5.0))
    assert thick.capacity == pytest.approx(thin.capacity, rel=1e-12)
    assert thick.material_volume == pytest.approx(thin.material_volume, rel=1e-12)


@given(
    st.lists(st.tuples(st.floats(0.0, 60.0), st.floats(0.0, 90.0)), min_size=7, max_size=7),
    st.floats(0.0005, 120.0),
    st.floats(0.0, 30.0),
    st.sampled_from(WallSide),
)
def test_random_vessels_are_whole_or_refused(points, wall, base, side) -> None:
    first = cubic(points[:4])
    second = cubic(points[3:])
    solid = Solid(BodyKind.VESSEL, wall, side, base)
    surface = RevolutionSurface(Profile.of([first, second]))
    try:
        measured = vessel_measures(surface, solid)
        mesh = body_mesh(surface, solid, samples=(6, 12))
    except SolidError:
        return
    assert measured.material_volume > 0.0
    assert measured.capacity is None or measured.capacity > 0.0
    assert np.isfinite(mesh.positions).all()
    assert mesh.volume > 0.0
    section = cross_section(surface, solid)
    loose = [f for f in section.findings if isinstance(f, LoosePart)]
    assert len(section.outlines) == len(loose) + 1
    assert all(f.where[0] >= 0.0 for f in section.findings if isinstance(f, Crumb))


@pytest.mark.parametrize("kind", [BodyKind.FILLED, BodyKind.VESSEL])
def test_a_ring_that_is_a_point_has_no_body_under_a_law_either(kind) -> None:
    point = Profile.of([Segment([(16.0, 26.0)] * 4)], closed=True)
    with pytest.raises(SolidError) as refused:
        vessel_measures(
            RevolutionSurface(point, laws=(Law("omega", "cosine", 0.2, 0.3),)), Solid(kind, 1.0)
        )
    with pytest.raises(SolidError) as plain:
        vessel_measures(RevolutionSurface(point), Solid(kind, 1.0))
    assert say(plain.value.finding) in say(refused.value.finding)


def test_a_wall_that_leaves_the_axis_from_a_standstill_ends_on_it() -> None:
    # A lid that rises from a pole where its curve stands still: its wall begins beyond the axis.
    lid = Profile.of(
        [
            Segment([(0.0, 0.0), (0.0, 0.0), (23.0, 2.0), (34.0, 2.5)], ShapeParameters(omega=0.1)),
            Segment([(34.0, 2.5), (33.0, 6.0), (0.0, 14.5), (0.0, 14.5)]),
        ],
        ["G0"],
    )
    solid = Solid(BodyKind.VESSEL, 0.75, WallSide.INSIDE, 0.0)
    for sweep, laws in ((360.0, ()), (300.0, (Law("lambda3", "paper", 1.1, 3.0),))):
        surface = RevolutionSurface.of_degrees(lid, sweep_deg=sweep, laws=laws)
        mesh = body_mesh(surface, solid, samples=(4, 9))
        assert mesh.is_watertight
        # Nothing lies beyond the axis.
        for outline in cross_section(surface, solid).outlines:
            for piece in outline.exterior:
                assert piece.ends[:, 0].min() >= -1e-8


@pytest.mark.parametrize("kind", [BodyKind.FILLED, BodyKind.VESSEL])
@pytest.mark.parametrize("direction", [(1.0, 0.0), (0.0, 1.0), (0.6, 0.8)])
def test_a_profile_that_runs_back_along_itself_has_no_body(kind, direction) -> None:
    def at(along: float, aside: float) -> tuple[float, float]:
        x, y = direction
        return 50.0 + along * x - aside * y, along * y + aside * x

    folded = Profile.of([cubic([at(0, 0), at(20, 1e-9), at(20, 2e-9), at(3, 3e-9)])])
    with pytest.raises(SolidError) as refused:
        vessel_measures(RevolutionSurface(folded), Solid(kind, 1.0, WallSide.OUTSIDE, 0.0))
    assert refused.value.finding is NoBodyFor.TOO_FLAT
    apart = Profile.of([cubic([at(0, 0), at(20, 3), at(20, 6), at(3, 9)])])
    assert vessel_measures(RevolutionSurface(apart), Solid(BodyKind.FILLED)).material_volume > 1.0


def test_a_filled_body_flatter_than_samples_are_apart_has_no_mesh() -> None:
    def disc(rise: float) -> RevolutionSurface:
        points = [(0.0, 0.0), (10.0, rise), (20.0, 2.0 * rise), (30.0, 0.0)]
        return RevolutionSurface(Profile.of([cubic(points)]))

    filled = Solid(BodyKind.FILLED)
    with pytest.raises(SolidError) as refused:
        body_mesh(disc(1e-8), filled)
    assert refused.value.finding is NoBodyFor.TOO_FLAT
    mesh = body_mesh(disc(1.0), filled, tolerance=1e-3)
    assert mesh.is_watertight
    # ∫ 2πr h dr with h = rise·3 t (1 − t²) and r = 30 t.
    assert mesh.volume == pytest.approx(2.0 * pi * 900.0 * 0.4, rel=1e-2)
