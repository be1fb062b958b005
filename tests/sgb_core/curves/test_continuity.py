"""What a joint truly is, in the ordinary and in every degenerate case."""

from __future__ import annotations

from math import degrees

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from sgb_core.curves.continuity import (
    JointClass,
    end_view,
    measure_joint,
    measure_joints,
    start_view,
)
from sgb_core.curves.profile import JointRule, Profile
from sgb_core.curves.segment import Segment, ShapeParameters
from tests.sgb_core.curves.strategies import chains, segments, shapes

TOWER = (
    [[5, 13], [6, 12], [3, 10], [2, 8]],
    [[2, 8], [1, 6], [2, 3], [5, -1]],
    [[5, -1], [8, -5], [5, -9], [8, -10]],
)
FLAT = ShapeParameters(4, 3, 4, 1)


def tower(*shapes_: ShapeParameters) -> Profile:
    return Profile(tuple(Segment(np.array(p), s) for p, s in zip(TOWER, shapes_, strict=True)))


def angle_between(u: np.ndarray, v: np.ndarray) -> float:
    u, v = u / np.linalg.norm(u), v / np.linalg.norm(v)
    return degrees(2.0 * np.arctan2(np.linalg.norm(u - v), np.linalg.norm(u + v)))


@given(segments(shapes(0.05, 0.95)))
def test_curvature_at_an_end_in_closed_form_is_that_of_the_curve(segment) -> None:
    legs = np.hypot(*np.diff(segment.points, axis=0).T)
    assume(min(legs[0], legs[2]) > 0.01)
    at_start, at_end = segment.curvature([0.0, 1.0])
    assert start_view(segment).curvature() == pytest.approx(at_start, rel=1e-8, abs=1e-10)
    assert -end_view(segment).curvature() == pytest.approx(at_end, rel=1e-8, abs=1e-10)


@given(chains(JointRule.G0))
def test_ordinary_joints_against_the_curve_itself(profile) -> None:
    for report in measure_joints(profile):
        first, second = (profile.segments[k] for k in profile.neighbours(report.joint))
        v1, v2 = first.derivative(1.0), second.derivative(0.0)
        assert report.kink_deg == pytest.approx(angle_between(v1, v2), abs=1e-9)
        assert report.speed_ratio == pytest.approx(
            np.linalg.norm(v2) / np.linalg.norm(v1), rel=1e-9
        )
        jump = second.curvature(0.0) - first.curvature(1.0)
        assert report.curvature_jump == pytest.approx(jump, rel=1e-6, abs=1e-6)
        assert not report.degenerate
        assert report == measure_joint(profile, report.joint)


@pytest.mark.parametrize("omega", [0.0, 1 / 3, 2 / 3])
def test_figure_7_is_smooth_while_no_end_is_degenerate(omega) -> None:
    shape = ShapeParameters(4, 3, 4, omega)
    for report in measure_joints(tower(shape, shape, shape)):
        assert report.kink_deg < 1e-6
        assert report.measured == JointClass.C1


def test_figure_7d_has_real_kinks() -> None:
    reports = measure_joints(tower(FLAT, FLAT, FLAT))
    # Q2 is the middle of P1P2 and the first quartic point that differs from the joint.
    expected = (
        angle_between(np.array([2, 8]) - [4.5, 11], np.array([1.5, 4.5]) - [2, 8]),
        angle_between(np.array([5, -1]) - [1.5, 4.5], np.array([6.5, -7]) - [5, -1]),
    )
    for report, kink in zip(reports, expected, strict=True):
        assert report.measured == JointClass.G0
        assert report.degenerate
        assert report.kink_deg == pytest.approx(kink, abs=1e-10)
        assert kink > 10.0
        assert report.speed_ratio is None
        assert report.curvature_jump is None


def test_a_degenerate_later_end_has_speed_ratio_zero() -> None:
    report = measure_joint(tower(ShapeParameters(), FLAT, FLAT), 0)
    assert report.speed_ratio == 0.0
    assert report.curvature_jump is None


def test_gap_is_seen_and_has_no_kink() -> None:
    first = Segment([[1, 0], [1, 1], [1, 2], [1, 3]])
    apart = Profile((first, Segment([[1, 3.5], [1, 4], [1, 5], [1, 6]])), ("free",))
    report = measure_joint(apart, 0)
    assert report.measured == JointClass.GAP
    assert report.kink_deg is None
    assert report.gap == 0.5
    assert report.holds
    rounding = Profile((first, Segment([[1, 3 + 1e-10], [1, 4], [1, 5], [1, 6]])))
    assert measure_joint(rounding, 0).measured == JointClass.G2


def test_classes_of_two_straight_lines() -> None:
    def joint(second: list[list[float]], shape: ShapeParameters | None = None) -> JointClass:
        first = Segment([[0, 0], [1, 0], [2, 0], [3, 0]], shape or ShapeParameters())
        later = Segment(np.array(second, dtype=float), shape or ShapeParameters())
        return measure_joint(Profile((first, later)), 0).measured

    assert joint([[3, 0], [4, 0], [5, 0], [6, 0]]) == JointClass.G2
    assert joint([[3, 0], [3, 1], [3, 2], [3, 3]]) == JointClass.G0
    assert joint([[3, 0], [2, 0], [1, 0], [0, 0]]) == JointClass.G0
    # Vanishing derivatives in one line: equal, and without a kink.
    assert joint([[3, 0], [4, 0], [5, 0], [6, 0]], FLAT) == JointClass.C1
    assert joint([[3, 0], [3, 1], [3, 2], [3, 3]], FLAT) == JointClass.G0
    # Equal derivatives and different curvatures.
    assert joint([[3, 0], [4, 0], [4, 1], [6, 3]]) == JointClass.C1
    assert joint([[3, 0], [4.5, 0], [4, 1], [6, 3]]) == JointClass.G1


def test_coincident_control_points_are_classed_by_the_true_tangent() -> None:
    smooth = Profile(
        (Segment([[0, 0], [1, 0], [3, 0], [3, 0]]), Segment([[3, 0], [3, 0], [5, 0], [6, 1]]))
    )
    report = measure_joint(smooth, 0)
    assert report.degenerate
    assert report.measured == JointClass.C1
    kinked = smooth.with_segment(1, Segment([[3, 0], [3, 0], [4, 1], [6, 1]]))
    assert measure_joint(kinked, 0).kink_deg == pytest.approx(45.0)


def test_profiles_without_extent_are_measured_without_failing() -> None:
    point = Segment(np.ones((4, 2)))
    for report in measure_joints(Profile((point, point), closed=True)):
        assert report.measured == JointClass.G0
        assert report.kink_deg is None
        assert report.speed_ratio is None
        assert report.curvature_jump is None
        assert report.degenerate
    mixed = Profile((point, Segment([[1, 1], [2, 1], [3, 1], [4, 2]])))
    assert measure_joint(mixed, 0).kink_deg is None


def test_closed_profiles_measure_the_closing_joint() -> None:
    lens = Segment([[0, 0], [1, -1], [1, 1], [0, 0]])
    report = measure_joint(Profile((lens,), closed=True), 0)
    assert report.kink_deg == pytest.approx(90.0)
    with pytest.raises(IndexError, match="no joint 1"):
        measure_joint(Profile((lens,), closed=True), 1)


@given(shapes(), shapes(), st.floats(-9e5, 9e5), st.sampled_from([1e-3, 1.0, 1e3]))
def test_the_class_does_not_depend_on_scale(one, two, shift, scale) -> None:
    profile = tower(one, two, FLAT)
    moved = profile.with_segments(
        s.with_points(scale * (s.points + np.round(shift))) for s in profile.segments
    )
    for before, after in zip(measure_joints(profile), measure_joints(moved), strict=True):
        assert (before.kink_deg is None) == (after.kink_deg is None)
        assert before.degenerate == after.degenerate
        assert after.kink_deg == pytest.approx(before.kink_deg, abs=1e-5)


def test_a_rule_holds_when_the_joint_is_at_least_that() -> None:
    straight = tower(ShapeParameters(), ShapeParameters(), ShapeParameters())
    for rule, holds in {"G0": True, "G1": True, "C1": True, "G2": False, "free": True}.items():
        profile = Profile(straight.segments, (rule, "G0"))
        assert measure_joint(profile, 0).holds is holds
    fast = Profile(
        (
            Segment([[0, 0], [1, 0], [2, 0], [3, 0]]),
            Segment([[3, 0], [5, 0], [7, 0], [9, 0]]),
        ),
        ("C1",),
    )
    assert measure_joint(fast, 0).measured == JointClass.G2
    assert not measure_joint(fast, 0).holds
