"""Crossings of the axis and of the profile with itself, and certificates."""

from __future__ import annotations

import numpy as np
import pytest
import shapely
from hypothesis import given, settings
from hypothesis import strategies as st

from sgb_core.curves.crossings import axis_crossings, certificates, self_intersections
from sgb_core.curves.primitives import line
from sgb_core.curves.profile import JointRule, Profile
from sgb_core.curves.segment import Segment, ShapeParameters
from tests.sgb_core.curves.strategies import chains, segments, shapes

LOOP = Segment([[1, 0], [5, 4], [0, 4], [4, 0]])


def polyline_crossings(profile: Profile, per_segment: int) -> int:
    runs = profile.sample(per_segment)
    path = np.concatenate([runs[0], *(run[1:] for run in runs[1:])])
    edges = shapely.linestrings(np.stack([path[:-1], path[1:]], axis=1))
    i, j = shapely.STRtree(edges).query(edges, predicate="crosses")
    return int((i < j).sum())


def test_the_loop_of_a_single_segment() -> None:
    (crossing,) = self_intersections(Profile((LOOP,)))
    assert crossing.s_a == pytest.approx(1.0 - crossing.s_b)
    assert crossing.point[0] == pytest.approx(2.5)
    np.testing.assert_allclose(LOOP.point([crossing.s_a, crossing.s_b])[0], crossing.point)


def test_random_chains_against_a_fine_polyline() -> None:
    rng = np.random.default_rng(8)
    for count in (1, 2, 3, 4) * 5:
        ends = rng.normal(size=(count + 1, 2))
        made = [
            Segment(
                np.array([ends[k], *rng.normal(size=(2, 2)), ends[k + 1]]),
                ShapeParameters(*(rng.uniform(size=4) * [4, 6, 4, 1])),
            )
            for k in range(count)
        ]
        profile = Profile(tuple(made))
        found = self_intersections(profile)
        assert len(found) == polyline_crossings(profile, 1200)
        for c in found:
            gap = profile.point(c.segment_a, c.s_a) - profile.point(c.segment_b, c.s_b)
            assert np.hypot(*gap) < 1e-9 * profile.size
            assert (c.segment_a, c.s_a) < (c.segment_b, c.s_b)


@pytest.mark.parametrize(
    "profile",
    [
        Profile((LOOP, LOOP), ("free",)),
        Profile((LOOP, LOOP.reversed())),
        Profile((LOOP, LOOP.with_points(LOOP.points + 1e-11)), ("free",)),
        Profile((line((0, 0), (3, 0)), line((3, 0), (0, 0)))),
        Profile((Segment([[0, 0], [3, 0], [-2, 0], [1, 0]]),)),
    ],
)
def test_coincident_stretches_are_found_and_bounded(profile) -> None:
    assert 1 <= len(self_intersections(profile)) <= 64


def test_joints_and_shared_ends_are_no_crossings() -> None:
    square = [line(p, q) for p, q in (((1, 0), (2, 0)), ((2, 0), (2, 1)), ((2, 1), (1, 0)))]
    assert self_intersections(Profile(tuple(square), closed=True)) == ()
    assert self_intersections(Profile((Segment(np.ones((4, 2))),) * 3)) == ()
    hairpin = Profile((line((0, 0), (3, 0)), line((3, 0), (0, 0.01))))
    assert self_intersections(hairpin) == ()


def test_axis_crossings_are_exact_roots() -> None:
    # r(s) of this line is 3 − 4 s.
    (stretch,) = axis_crossings(Profile((line((3, 0), (-1, 5)),)))
    assert (stretch.segment, stretch.s1) == (0, 1.0)
    assert stretch.s0 == pytest.approx(0.75, abs=1e-15)
    mirrored = Profile((line((-3, 0), (1, 5)),))
    assert axis_crossings(mirrored)[0].s0 == pytest.approx(0.75, abs=1e-15)


def test_touching_the_axis_is_not_crossing_it() -> None:
    assert axis_crossings(Profile((Segment([[0, 0], [1.2, 0], [1.2, 2], [0, 2]]),))) == ()
    assert axis_crossings(Profile((Segment([[-1e-16, 0], [1.2, 0], [1.2, 2], [0, 2]]),))) == ()
    assert axis_crossings(Profile((line((0, 0), (0, 3)),))) == ()


@given(segments())
def test_axis_crossings_against_dense_samples(segment) -> None:
    profile = Profile((segment,))
    s = np.linspace(0.0, 1.0, 501)
    radii = segment.point(s)[:, 0] * (1.0 if segment.quartic[:, 0].sum() >= 0 else -1.0)
    inside = np.zeros(501, dtype=bool)
    for stretch in axis_crossings(profile):
        inside |= (s >= stretch.s0) & (s <= stretch.s1)
    assert not (radii[~inside] < -1e-9).any()
    assert not (radii[inside] > 1e-9).any()


@settings(max_examples=60)
@given(chains(JointRule.G0, closed=False, most=3), shapes(), st.booleans())
def test_certificates_hold_at_every_setting(profile, shape, lifted) -> None:
    if lifted:
        # Sorted heights and positive radii, so that the certificates are given.
        control = np.abs(profile.control_points)
        order = np.sort(control[..., 1].ravel()).reshape(-1, 4)
        order[1:, 0] = order[:-1, 3]
        control[..., 1] = order
        profile = profile.with_segments(
            s.with_points(p) for s, p in zip(profile.segments, control, strict=True)
        )
    given_ = certificates(profile)
    reshaped = profile.with_segments(s.with_shape(shape) for s in profile.segments)
    assert certificates(reshaped) == given_
    if lifted:
        assert given_.never_crosses_axis
        assert given_.height_monotone
    if given_.never_crosses_axis:
        assert axis_crossings(reshaped) == ()
    if given_.height_monotone:
        rises = np.diff(reshaped.sample(60)[..., 1], axis=1)
        assert (rises >= -1e-12).all() or (rises <= 1e-12).all()


@pytest.mark.parametrize(
    ("polygon", "convex"),
    [
        ([[0, 0], [1.2, 0], [1.2, 2], [0, 2]], True),
        ([[0, 0], [1, 1], [2, 2], [3, 3]], True),
        ([[0, 0], [0, 0], [1, 0], [1, 1]], True),
        ([[0, 0], [1, 0], [1, 1], [2, 1]], False),
        ([[0, 0], [3, 0], [-2, 0], [1, 0]], False),
        ([[1, 0], [5, 4], [0, 4], [4, 0]], False),
    ],
)
def test_convexity_of_the_control_polygon(polygon, convex) -> None:
    assert certificates(Profile((Segment(np.array(polygon, dtype=float)),))).convex is convex


def test_a_heap_of_equal_segments_is_examined_in_bounded_work():
    heap = Profile((Segment([(0, 0), (9, 3), (-4, 6), (5, 9)]),) * 300, (JointRule.FREE,) * 299)
    found = self_intersections(heap)
    assert 0 < len(found) <= 256


def test_one_crossing_in_a_long_chain_is_found():
    steps = [Segment([(5, k), (5, k + 0.3), (5, k + 0.6), (5, k + 1)]) for k in range(400)]
    across = Segment([(5, 400), (20, 400), (20, 200.5), (2, 200.5)])
    found = self_intersections(Profile((*steps, across)))
    (crossing,) = found
    assert crossing.segment_b == 400
    r, h = crossing.point
    assert r == pytest.approx(5.0)
    assert crossing.segment_a == int(h)
