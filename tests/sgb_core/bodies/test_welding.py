"""Bodies welded by place, as a reader of STL does: every edge has an even number of faces."""

from __future__ import annotations

from math import pi

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from sgb_core.arrays import Floats, Ints
from sgb_core.bodies.body import SolidError, body_mesh
from sgb_core.bodies.cross_section import cross_section
from sgb_core.bodies.solid import BodyKind, Rim, Solid, WallSide
from sgb_core.curves.primitives import cubic, line
from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import Segment, ShapeParameters
from sgb_core.findings.bodies import NoBodyFor, TouchingCircle
from sgb_core.surfaces.mesh import Mesh
from sgb_core.surfaces.revolution import RevolutionSurface
from sgb_core.surfaces.variation import Law
from tests.sgb_core.bodies.vessels import bodies, pots

FILLED = Solid(BodyKind.FILLED)
SWELLING = Law("omega", "raised-cosine", 1.0, 0.67)


def vessel(wall: float, base: float, side: WallSide = WallSide.INSIDE) -> Solid:
    return Solid(BodyKind.VESSEL, wall, side, base)


def welded_edges(mesh: Mesh) -> tuple[Floats, Ints]:
    """Return the ends of each edge (E, 2, 3) and how many faces it has, welded in single."""
    places, number = np.unique(
        mesh.positions.astype(np.float32) + np.float32(0.0), axis=0, return_inverse=True
    )
    faces = number.reshape(-1)[mesh.faces]
    kept = faces[(faces != np.roll(faces, 1, axis=1)).all(axis=1)]
    pairs = np.sort(np.stack([kept, np.roll(kept, 1, axis=1)], axis=-1).reshape(-1, 2), axis=1)
    edges, counts = np.unique(pairs, axis=0, return_counts=True)
    return places[edges].astype(float), counts


def turned(
    profile: Profile, sweep: float = 2.0 * pi, laws: tuple[Law, ...] = ()
) -> RevolutionSurface:
    return RevolutionSurface(profile, start=0.5, sweep=sweep, laws=laws)


# From pole to pole, so that under a law the inner wall meets the axis elsewhere at each angle.
TIP = Profile(
    (
        Segment(
            [(0.0, 0.0), (17.0, 0.6), (6.6, 20.6), (0.0, 36.0)], ShapeParameters(4.0, 3.0, 4.0, 0.5)
        ),
    )
)
# Two pots on each other that meet in a point of the axis.
WAIST = Profile.of(
    [
        cubic([(0.0, 0.0), (49.0, 15.0), (24.0, 30.0), (57.0, 30.0)]),
        cubic([(57.0, 30.0), (3.0, 35.0), (1.0, 45.0), (0.0, 45.0)]),
        cubic([(0.0, 45.0), (44.0, 62.0), (51.0, 77.0), (43.0, 84.0)]),
    ]
)
# A ring whose wall outside reaches the axis.
BEAN = Profile.of(
    [
        cubic([(8.0, 12.0), (46.0, 28.0), (38.0, 33.0), (12.0, 52.0)]),
        cubic([(12.0, 52.0), (30.0, 7.0), (10.0, 47.0), (8.0, 12.0)]),
    ],
    closed=True,
)


@pytest.mark.parametrize("sweep", [2.0 * pi, 1.5 * pi, 1.0])
@pytest.mark.parametrize(
    ("profile", "solid"),
    [
        (TIP, vessel(1.2, 18.0)),
        (TIP, vessel(1.2, 2.0, WallSide.OUTSIDE)),
        (TIP, FILLED),
        (WAIST, vessel(6.0, 6.0)),
        (WAIST, FILLED),
        (BEAN, vessel(9.6, 6.0, WallSide.OUTSIDE)),
        (BEAN, FILLED),
    ],
)
@pytest.mark.parametrize("law", [None, SWELLING, Law("lambda1", "paper", 1.7, 0.0)])
def test_bodies_that_touch_the_axis_are_closed(profile, solid, sweep, law) -> None:
    surface = turned(profile, sweep, () if law is None else (law,))
    mesh = body_mesh(surface, solid, samples=(8, 24))
    assert mesh.is_watertight
    assert mesh.volume > 0.0
    ends, counts = welded_edges(mesh)
    assert (counts % 2 == 0).all()
    # Only points on the axis may pinch.
    assert np.hypot(*ends[counts > 2][..., :2].T).max(initial=0.0) < 1e-6


@pytest.mark.parametrize("sweep", [2.0 * pi, pi])
def test_a_lens_that_ends_where_it_starts_touches_itself_there_and_says_so(sweep) -> None:
    lens = Segment([(10.0, 0.0), (20.0, 20.0), (0.0, 20.0), (10.0, 0.0)], ShapeParameters(0.0))
    surface, hollow = turned(Profile((lens,)), sweep), vessel(6.0, 0.0, WallSide.OUTSIDE)
    assert (welded_edges(body_mesh(surface, FILLED, samples=(8, 24)))[1] == 2).all()
    mesh = body_mesh(surface, hollow, samples=(8, 24))
    assert mesh.is_watertight
    ends, counts = welded_edges(mesh)
    assert (counts % 2 == 0).all()
    found = [f for f in cross_section(surface, hollow).findings if isinstance(f, TouchingCircle)]
    assert [f.where for f in found] == [pytest.approx((10.0, 0.0))]
    many = ends[counts > 2]
    assert len(many) > 0
    assert np.allclose(np.hypot(many[..., 0], many[..., 1]), 10.0, atol=1e-5)
    assert np.allclose(many[..., 2], 0.0, atol=1e-5)


def test_what_does_not_touch_itself_says_nothing_of_it() -> None:
    for surface in map(turned, (TIP, WAIST, Profile.of([line((20.0, 0.0), (20.0, 60.0))]))):
        for solid in (vessel(1.2, 2.0), FILLED):
            findings = cross_section(surface, solid).findings
            assert not any(isinstance(finding, TouchingCircle) for finding in findings)


@pytest.mark.parametrize("sweep", [1e-14, 1e-8])
def test_a_turn_narrower_than_rounding_is_refused_for_a_mesh(sweep) -> None:
    with pytest.raises(SolidError) as refused:
        body_mesh(turned(TIP, sweep), FILLED)
    assert refused.value.finding is NoBodyFor.TOO_NARROW
    assert body_mesh(turned(TIP, 1e-4), FILLED, samples=(8, 3)).is_watertight


@pytest.mark.parametrize("solid", [FILLED, vessel(1.2, 2.0)])
def test_a_gap_narrower_than_rounding_closes(solid) -> None:
    almost = turned(TIP, 2.0 * pi - 1e-8)
    mesh = body_mesh(almost, solid, samples=(8, 24))
    assert len(mesh.triangles) == len(body_mesh(turned(TIP), solid, samples=(8, 24)).triangles)
    assert (welded_edges(mesh)[1] == 2).all()
    open_ = body_mesh(turned(TIP, 2.0 * pi - 1e-4), solid, samples=(8, 24))
    assert len(open_.triangles) > len(mesh.triangles)
    assert (welded_edges(open_)[1] == 2).all()


def test_a_line_of_which_a_law_leaves_nothing_is_no_division_by_zero() -> None:
    low = Segment(
        [(0.0850823817, 0.4062501464), (0.2, 0.36), (0.5, 0.177), (0.0, 0.0)],
        ShapeParameters(0.0, 6.0, 0.9329467067, 0.5),
    )
    solid = Solid(BodyKind.VESSEL, 0.03, WallSide.INSIDE, 0.03, Rim.ROUND)
    surface = turned(Profile((low,)), laws=(Law("lambda1", "paper", 0.0, 0.0),))
    assert body_mesh(surface, solid, samples=(8, 24)).is_watertight


@settings(max_examples=12)
@given(st.data(), pots())
def test_random_bodies_have_two_faces_at_every_edge(data, surface) -> None:
    try:
        mesh = body_mesh(surface, data.draw(bodies(surface.profile.size)), samples=(4, 9))
    except SolidError:
        return
    assert (welded_edges(mesh)[1] == 2).all()
