"""What a pen draws: properties of anchors and of the segments between them."""

from __future__ import annotations

import math

import numpy as np
from hypothesis import assume, given
from hypothesis import strategies as st

from sgb_core.curves.basis import bernstein
from sgb_core.curves.profile import JointRule, Profile
from sgb_core.curves.segment import ShapeParameters
from sgb_core.design.pen import Anchor, PenPath, between, closing_handle
from sgb_core.document import edits
from sgb_core.document.model import Document

coordinate = st.floats(-100.0, 100.0).map(lambda value: round(value, 3))
pair = st.tuples(coordinate, coordinate)


@st.composite
def anchors(draw, away=0.1):
    anchor = Anchor(draw(pair))
    if draw(st.booleans()):
        handle = draw(pair)
        assume(math.dist(handle, anchor.place) > away)
        anchor = anchor.pulled(handle, alone=draw(st.booleans()))
    return anchor


@given(anchors(), anchors())
def test_a_segment_is_the_cubic_through_its_anchors_and_every_leg_can_move_it(start, end):
    assume(math.dist(start.place, end.place) > 1.0)
    segment = between(start, end)
    assert segment.shape == ShapeParameters(1.0, 3.0, 1.0, 1.0)
    assert tuple(segment.points[0]) == start.place
    assert tuple(segment.points[3]) == end.place
    s = np.linspace(0.0, 1.0, 9)
    assert np.allclose(segment.point(s), bernstein(3, s) @ segment.points, atol=1e-9)
    first, last = np.diff(segment.points, axis=0)[[0, 2]]
    if start.outgoing is None and end.incoming is not None:
        assume(math.dist(end.incoming, start.place) > 1e-6)
    if end.incoming is None and start.outgoing is not None:
        assume(math.dist(start.outgoing, end.place) > 1e-6)
    assert np.hypot(*first) > 0.0
    assert np.hypot(*last) > 0.0


@given(anchors(), anchors())
def test_drawn_backwards_it_is_the_same_curve(start, end):
    back = [Anchor(a.place, a.outgoing, a.incoming, a.sharp) for a in (end, start)]
    assert np.allclose(between(*back).points[::-1], between(start, end).points, atol=1e-12)


@given(pair, pair)
def test_a_pulled_anchor_off_the_axis_is_smooth(place, handle):
    assume(place[0] != 0.0)
    assume(math.dist(place, handle) > 1e-3)
    anchor = Anchor(place).pulled(handle)
    assert anchor.smooth
    assert anchor.outgoing == handle
    assert np.allclose(np.add(anchor.incoming, handle) / 2.0, place)
    assert not anchor.broken().smooth


def test_a_round_pole_makes_a_quarter_of_a_circle():
    path = PenPath().placed((0.0, -50.0)).placed((50.0, 0.0))
    segment = path.pulled((50.0, 50.0 * 4.0 / 3.0 * (math.sqrt(2.0) - 1.0))).segment
    radii = np.hypot(*segment.point(np.linspace(0.0, 1.0, 101)).T)
    assert np.abs(radii - 50.0).max() < 50.0 * 2.8e-4


def test_a_pole_stands_on_the_side_of_the_profile():
    pole = Anchor((0.0, 10.0)).pulled((8.0, 3.0))
    assert between(pole, Anchor((-30.0, 0.0))).points[1].tolist() == [-8.0, 10.0]
    assert between(Anchor((30.0, 0.0)), pole).points[2].tolist() == [8.0, 10.0]


@given(pair, pair, pair)
def test_a_closing_handle_goes_on_into_the_curve_that_leaves(place, leg, hand):
    assume(math.dist(place, leg) > 1e-3)
    assume(math.dist(place, hand) > 1e-3)
    start = Anchor(place, None, leg)
    incoming = closing_handle(start, hand)
    assert Anchor(place, incoming, leg).smooth
    assert math.isclose(math.dist(place, incoming), math.dist(place, hand), rel_tol=1e-6)


@st.composite
def drawn(draw):
    places = draw(st.lists(pair, min_size=2, max_size=5, unique=True))
    path, document = PenPath(), None
    for place in places:
        path = path.placed(place)
        if draw(st.booleans()):
            handle = draw(pair)
            assume(math.dist(handle, place) > 0.1)
            path = path.pulled(handle)
        if len(path.anchors) == 2:
            document = Document(Profile((path.segment,)))
        elif document is not None:
            document = edits.draw_on(document, path.segment, path.rule)
    return path, document


@given(drawn())
def test_a_run_becomes_a_chain_whose_joints_are_as_they_were_drawn(run):
    path, document = run
    profile = document.profile
    assert len(profile) == len(path.anchors) - 1
    assert list(profile.gaps) == [0.0] * len(profile.joints)
    for anchor, report in zip(path.anchors[1:-1], document.joints, strict=True):
        assert report.holds
        if anchor.smooth:
            assert report.rule is JointRule.G1


@given(drawn(), anchors())
def test_drawing_on_from_the_start_is_drawing_on_from_the_end_of_the_chain_turned_round(run, end):
    _, document = run
    first = document.profile.segments[0]
    start = Anchor.going_on(first, from_start=True)
    assume(end.place != start.place)
    segment = between(start, end)
    ahead = edits.draw_on(document, segment, JointRule.G1, at_start=True)
    turned = edits.draw_on(edits.reverse_profile(document), segment, JointRule.G1)
    back = edits.reverse_profile(turned).profile
    assert np.array_equal(ahead.profile.control_points, back.control_points)
    assert ahead.profile.rules == back.rules
