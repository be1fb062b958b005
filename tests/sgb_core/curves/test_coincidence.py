"""Coincident control points and joints: one true word about each, and no crossing that is none."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sgb_core.curves.coincidence import coincident_points
from sgb_core.curves.crossings import self_intersections
from sgb_core.curves.primitives import line
from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import Segment
from sgb_core.document.findings import check
from sgb_core.document.model import Document
from sgb_core.findings.profile import LegsWithoutLength, SegmentIsPoint
from tests.sgb_core.curves.strategies import shapes

FOOT, WAIST, RIM = (20.0, 0.0), (30.0, 40.0), (25.0, 90.0)


def point(place) -> Segment:
    return Segment([place] * 4)


@pytest.mark.parametrize("rule", ["G0", "G1", "C1", "G2"])
@pytest.mark.parametrize("number", [0, 1, 2])
def test_a_segment_that_is_a_point_is_said_once(number, rule) -> None:
    chain = [line(FOOT, WAIST), line(WAIST, RIM)]
    place = (FOOT, WAIST, RIM)[number]
    chain.insert(number, point(place))
    profile = Profile.of(chain, [rule] * 2)
    beside = [f for f in check(Document(profile)) if not isinstance(f, SegmentIsPoint)]
    assert check(Document(profile))[-1 if beside else 0] == SegmentIsPoint(number, place)
    # A joint of the two lines is no neighbour of the point at an end, and has its own rule.
    assert len(beside) == (number != 1 and rule != "G0")


def test_points_in_a_row_and_nothing_but_points() -> None:
    row = Profile.of([line(FOOT, WAIST), point(WAIST), point(WAIST), line(WAIST, RIM)])
    assert [found.segment for found in check(Document(row))] == [1, 2]
    alone = Profile.of([point(WAIST)])
    assert check(Document(alone)) == (SegmentIsPoint(0, WAIST),)


@given(st.integers(0, 2), shapes())
def test_a_leg_without_length_is_said_once_and_crosses_nothing(leg, shape) -> None:
    polygon = np.array([(20, 0), (30, 20), (32, 45), (24, 60)], dtype=float)
    polygon[leg + 1 if leg < 2 else 2] = polygon[leg if leg < 2 else 3]
    profile = Profile.of([Segment(polygon, shape)])
    assert check(Document(profile)) == (LegsWithoutLength((0,)),)


def test_legs_of_many_segments_are_one_finding() -> None:
    corner = Segment([FOOT, FOOT, WAIST, WAIST])
    other = Segment([WAIST, WAIST, RIM, RIM])
    assert coincident_points(Profile.of([corner, other])) == (LegsWithoutLength((0, 1)),)
    assert coincident_points(Profile.of([line(FOOT, WAIST)])) == ()


def test_a_line_that_runs_back_over_itself_is_one_fault() -> None:
    there_and_back = Segment([FOOT, WAIST, WAIST, FOOT])
    assert len(self_intersections(Profile.of([there_and_back]))) == 1


def test_joints_on_one_point_touch() -> None:
    corners = [(20, 0), (40, 0), (30, 30), (50, 60), (30, 60), (30, 30), (10, 60)]
    chain = [line(p, q) for p, q in pairwise(corners)]
    (touch,) = self_intersections(Profile.of(chain))
    assert touch.touches
    assert (touch.segment_a, touch.s_a, touch.segment_b, touch.s_b) == (1, 1.0, 4, 1.0)
    assert touch.point == (30.0, 30.0)
    again = [*chain, line((10, 60), (10, 30)), line((10, 30), (30, 30)), line((30, 30), (30, 0))]
    found = [each for each in self_intersections(Profile.of(again)) if each.touches]
    assert [(each.segment_a, each.segment_b) for each in found] == [(1, 4), (4, 7)]


def test_joints_are_neighbours_through_points_and_ends_are_no_joints() -> None:
    triangle = [(20.0, 0.0), (40.0, 0.0), (30.0, 30.0)]
    sides = [line(triangle[k - 1], triangle[k]) for k in range(3)]
    assert self_intersections(Profile.of(sides, closed=True)) == ()
    assert self_intersections(Profile.of(sides)) == ()
    sides.insert(1, point(triangle[0]))
    assert self_intersections(Profile.of(sides, closed=True)) == ()
