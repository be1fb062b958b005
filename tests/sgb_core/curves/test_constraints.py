"""Rules of joints hold after edits: random chains, sliders, drags, and what cannot be kept."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from sgb_core.curves.constraints import Enforced, enforce, move_control_points, set_shapes
from sgb_core.curves.continuity import JointClass, measure_joint, measure_joints
from sgb_core.curves.profile import JointRule, Profile
from sgb_core.curves.segment import NEUTRAL, Segment, ShapeParameters
from sgb_core.findings.words import say
from tests.sgb_core.curves.strategies import chains, points, shapes

SIDES = st.sampled_from(["earlier", "later"])


def enforced(profile: Profile) -> Profile:
    for joint in profile.joints:
        profile = enforce(profile, joint).profile
    return profile


def all_hold(profile: Profile) -> bool:
    return all(report.holds for report in measure_joints(profile))


def set_shape(profile: Profile, segment: int, shape: ShapeParameters, side="later") -> Enforced:
    return set_shapes(profile, {segment: shape}, side)


def move(profile: Profile, segment: int, index: int, target, keep_rules: bool = True) -> Enforced:
    return move_control_points(profile, {(segment, index): target}, keep_rules)


def two(rule: str, first: ShapeParameters = NEUTRAL, second: ShapeParameters = NEUTRAL) -> Profile:
    """A joint at (3, 0) that runs in +r, both sides bending towards +h."""
    return Profile(
        (
            Segment([[0, 3], [0, 1], [1, 0], [3, 0]], first),
            Segment([[3, 0], [5, 0], [7, 1], [7, 3]], second),
        ),
        (rule,),
    )


@given(chains(JointRule.G1), st.data())
def test_sliders_never_break_a_g1_joint_nor_move_a_point(profile, data) -> None:
    profile = enforced(profile)
    assume(all_hold(profile))
    segment = data.draw(st.integers(0, len(profile) - 1))
    result = set_shape(profile, segment, data.draw(shapes(0.0, 0.99)), data.draw(SIDES))
    assert all_hold(result.profile)
    assert result.unmet == ()
    np.testing.assert_array_equal(result.profile.control_points, profile.control_points)


@given(st.sampled_from(["G1", "C1", "G2"]).flatmap(lambda r: chains(JointRule(r))), st.data())
def test_rules_hold_after_any_sequence_of_edits_or_are_reported(profile, data) -> None:
    profile = enforced(profile)
    for _ in range(3):
        before = {r.joint for r in measure_joints(profile) if not r.holds}
        segment = data.draw(st.integers(0, len(profile) - 1))
        if data.draw(st.booleans()):
            result = set_shape(profile, segment, data.draw(shapes(0.05, 0.95)), data.draw(SIDES))
        else:
            index = data.draw(st.integers(0, 3))
            result = move(profile, segment, index, data.draw(points))
        profile = result.profile
        broken = {r.joint for r in measure_joints(profile) if not r.holds}
        noted = {unmet.joint for unmet in result.unmet}
        assert broken - before <= noted <= broken
        assert all(r.measured != JointClass.GAP for r in measure_joints(profile))


@given(chains(JointRule.C1), st.data())
def test_no_point_moves_farther_than_ten_times_its_leg(profile, data) -> None:
    profile = enforced(profile)
    segment = data.draw(st.integers(0, len(profile) - 1))
    result = set_shape(profile, segment, data.draw(shapes()), data.draw(SIDES))
    old, new = profile.control_points, result.profile.control_points
    moved = np.hypot(*np.moveaxis(new - old, -1, 0))
    legs = np.hypot(*np.moveaxis(old[:, [0, 0, 3, 3]] - old[:, [1, 1, 2, 2]], -1, 0))
    assert (moved <= 10.0 * legs * (1 + 1e-9)).all()


def test_theorem_1_with_alpha_one() -> None:
    shape = ShapeParameters(1, 3, 3, 0.5)
    result = set_shape(two("C1"), 0, shape)
    # c1 = (3 − 1)/4 = ½, a2 = ¾: P1,2 = J + (c1/a2)(J − P2,1).
    np.testing.assert_allclose(result.profile.segments[1].points[1], [3 + 2 * 0.5 / 0.75, 0])
    assert measure_joint(result.profile, 0).speed_ratio == pytest.approx(1.0, abs=1e-14)
    locked = set_shape(two("C1"), 0, shape, "earlier")
    np.testing.assert_allclose(locked.profile.segments[0].points[2], [3 - 2 * 0.75 / 0.5, 0])
    assert locked.profile.segments[1] == two("C1").segments[1]


def test_c1_is_suspended_where_an_end_derivative_vanishes() -> None:
    result = set_shape(two("C1"), 0, ShapeParameters(1, 3, 4, 1))
    np.testing.assert_array_equal(result.profile.control_points, two("C1").control_points)
    assert "suspended" in say(result.unmet[0])
    near = set_shape(two("C1"), 1, ShapeParameters(3.9999999, 3, 1, 1))
    assert "ten times" in say(near.unmet[0])
    assert near.profile.segments[1].points[1] == pytest.approx([3 + 22, 0])


def test_g1_at_a_degenerate_end_says_what_it_became() -> None:
    result = set_shape(two("G1"), 0, ShapeParameters(1, 3, 4, 1))
    assert "kink" in say(result.unmet[0])
    np.testing.assert_array_equal(result.profile.control_points, two("G1").control_points)


def test_g2_goes_through_lambda1_of_the_neighbour_first() -> None:
    profile = two("G2", ShapeParameters(1, 3, 1, 1), ShapeParameters(1, 3, 1, 1))
    result = set_shape(profile, 0, ShapeParameters(1, 3, 1.5, 1))
    old, new = profile.segments[1].shape, result.profile.segments[1].shape
    assert measure_joint(result.profile, 0).measured == JointClass.G2
    assert new.lambda1 != old.lambda1
    assert replace(new, lambda1=old.lambda1) == old
    assert result.unmet == ()


def test_g2_uses_lambda2_where_lambda1_is_not_enough_and_passes_on() -> None:
    bent = ShapeParameters(0.1, 3, 1, 1)
    third = Segment([[7, 3], [7, 5], [6, 6], [5, 6]], ShapeParameters(1, 3, 1, 1))
    start = Profile((*two("G2", NEUTRAL, bent).segments, third), ("G2", "G2"))
    start = enforced(start)
    assert all_hold(start)
    # A flatter end of the first segment asks for more than λ1 = 0 can give.
    result = set_shape(start, 0, ShapeParameters(1, 0.9, 0, 1))
    shape = result.profile.segments[1].shape
    assert shape.lambda1 == 0.0
    assert shape.lambda2 != start.segments[1].shape.lambda2
    assert result.profile.segments[2].shape != start.segments[2].shape
    assert all_hold(result.profile)


def test_g2_out_of_range_is_reported_and_stays_continuous() -> None:
    start = enforced(two("G2", ShapeParameters(1, 3, 1, 1), ShapeParameters(1, 3, 1, 1)))
    # What the yielding side misses the other one may not add.
    start = start.with_segments((replace(start.segments[0], holds_end=True), start.segments[1]))
    result = None
    previous = start.segments[1].shape
    for height in np.linspace(1.0, -1.0, 201):
        result = move(start, 0, 1, (0.0, height))
        shape = result.profile.segments[1].shape
        assert abs(shape.lambda1 - previous.lambda1) < 0.5
        assert abs(shape.lambda2 - previous.lambda2) < 0.5
        previous = shape
    assert "the nearest is kept" in say(result.unmet[0])


@pytest.mark.parametrize(
    ("second", "reason"),
    [
        (Segment([[3, 0], [5, 0], [7, 1], [7, 3]]), "ω"),
        (Segment([[3, 0], [5, 0], [7, 0], [7, 3]], ShapeParameters(omega=1)), "straight"),
        (Segment([[3, 0], [3, 0], [7, 1], [7, 3]], ShapeParameters(omega=1)), "no length"),
    ],
)
def test_g2_that_cannot_be_is_reported_in_words(second, reason) -> None:
    profile = Profile((two("G2").segments[0], second), ("G2",))
    result = set_shape(profile, 0, ShapeParameters(1, 3, 2, 1))
    assert reason in say(result.unmet[0])


@pytest.mark.parametrize("omega", [0.3, 0.7, 0.9, 1.0])
def test_g2_that_stops_at_the_end_of_a_range_stops_there_exactly(omega) -> None:
    straight = Segment([[0, 0], [1, 0], [2, 0], [3, 0]])
    bent = two("G2").segments[1].with_shape(ShapeParameters(1.5, 3.0, 1.0, omega))
    shape = enforce(Profile((straight, bent), ("G2",)), 0).profile.segments[1].shape
    assert (shape.lambda1, shape.lambda2) == (0.0, 6.0)


def test_dragging_a_leg_turns_the_other_side_and_keeps_its_length() -> None:
    for index, other in (((0, 2), (1, 1)), ((1, 1), (0, 2))):
        profile = two("G1")
        result = move(profile, *index, (2.0, -1.5) if index[0] == 0 else (4, 2))
        joint = np.array([3.0, 0.0])
        new = result.profile.segments[other[0]].points[other[1]]
        assert np.hypot(*(new - joint)) == pytest.approx(2.0, abs=1e-14)
        assert measure_joint(result.profile, 0).kink_deg < 1e-10


def test_moving_a_joint_carries_its_legs_and_alt_does_not() -> None:
    shift = np.array([0.5, -0.25])
    for key in ((0, 3), (1, 0)):
        carried = move(two("C1"), *key, np.array([3.0, 0.0]) + shift).profile
        old = two("C1").control_points
        expected = old.copy()
        expected[0, 2:] += shift
        expected[1, :2] += shift
        np.testing.assert_allclose(carried.control_points, expected, atol=1e-15)
        alone = move(two("C1"), *key, [3.5, -0.25], keep_rules=False)
        np.testing.assert_array_equal(alone.profile.control_points[:, 1:3], old[:, 1:3])
        assert measure_joint(alone.profile, 0).gap == 0.0
        assert alone.unmet == ()


def test_free_joints_come_apart_and_free_ends_move_alone() -> None:
    apart = move(two("free"), 0, 3, (2.5, 0.5)).profile
    np.testing.assert_array_equal(apart.segments[1].points, two("free").segments[1].points)
    assert measure_joint(apart, 0).measured == JointClass.GAP
    end = move(two("G1"), 0, 0, (9, 9)).profile
    np.testing.assert_array_equal(end.segments[0].points[1:], two("G1").segments[0].points[1:])


def test_several_points_move_as_one_edit() -> None:
    shift = np.array([1.0, 2.0])
    old = two("G1").control_points
    keys = [(s, i) for s in (0, 1) for i in range(4)]
    result = move_control_points(two("G1"), {key: old[key] + shift for key in keys})
    np.testing.assert_allclose(result.profile.control_points, old + shift, atol=1e-15)
    assert result.unmet == ()


def test_closing_a_gap_moves_the_yielding_end_with_its_leg() -> None:
    profile = two("free")
    moved = profile.segments[1].with_points(profile.segments[1].points + np.ones(2))
    apart = Profile((profile.segments[0], moved), ("G1",))
    later = enforce(apart, 0).profile
    np.testing.assert_allclose(later.segments[1].points[:2], [[3, 0], [5, 0]])
    np.testing.assert_array_equal(later.segments[1].points[2:], moved.points[2:])
    earlier = enforce(apart, 0, "earlier").profile
    np.testing.assert_allclose(earlier.segments[0].points[2:], [[2, 1], [4, 1]])


def test_enforcing_a_satisfied_or_free_rule_changes_nothing() -> None:
    for rule in ("free", "G0", "G1", "C1"):
        profile = two(rule)
        result = enforce(profile, 0)
        assert result.profile.segments == profile.segments
        assert result.unmet == ()
    with pytest.raises(IndexError, match="no joint"):
        enforce(two("G1"), 1)


def test_rules_with_segments_that_are_points_are_reported() -> None:
    point = Segment(np.full((4, 2), [3.0, 0.0]))
    for order in ((two("G1").segments[0], point), (point, two("G1").segments[1])):
        for rule in ("G1", "C1", "G2"):
            result = enforce(Profile(order, (rule,)), 0)
            assert len(result.unmet) == 1
            np.testing.assert_array_equal(
                result.profile.control_points, Profile(order).control_points
            )


def test_a_ring_of_one_segment_keeps_its_own_joint() -> None:
    drop = Segment([[2, 0], [4, -1], [4, 3], [2, 0]], ShapeParameters(1, 3, 1, 1))
    ring = enforced(Profile((drop,), ("C1",), closed=True))
    assert all_hold(ring)
    dragged = move(ring, 0, 1, (3.0, -2.0))
    assert all_hold(dragged.profile)
    np.testing.assert_array_equal(dragged.profile.segments[0].points[1], [3.0, -2.0])
