"""Points that are dragged stop at the axis; legs that follow their chord."""

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import Segment
from sgb_core.document import edits
from sgb_core.document.model import Document

inside = st.tuples(st.floats(0.5, 60.0), st.floats(-60.0, 60.0))
anywhere = st.tuples(st.floats(-80.0, 80.0), st.floats(-80.0, 80.0))


@st.composite
def chains(draw, side=1.0):
    """A smooth chain of one to three segments on one side of the axis."""
    count = draw(st.integers(1, 3))
    places = [draw(inside) for _ in range(3 * count + 1)]
    points = np.array(places) * (side, 1.0)
    segments = [Segment(points[3 * k : 3 * k + 4]) for k in range(count)]
    document = Document(Profile.of(segments))
    for joint in document.profile.joints:
        document = edits.set_rule(document, joint, draw(st.sampled_from(["G0", "G1"])))
    assume((document.profile.control_points[..., 0] * side >= 0.0).all())
    return document


@given(chains(), st.data())
def test_no_point_goes_through_the_axis(document, data):
    segment = data.draw(st.integers(0, len(document.profile) - 1))
    index = data.draw(st.integers(0, 3))
    scales = data.draw(st.booleans())
    to = data.draw(anywhere)
    moved = edits.move_point(document, segment, index, to, scale_legs=scales, stop_at_axis=True)
    assert moved.profile.control_points[..., 0].min() >= -1e-9
    held = moved.profile.control_points[segment, index]
    assert np.allclose(held, (max(to[0], 0.0), to[1]), atol=1e-9) or index in (1, 2)
    for report in moved.joints:
        if document.joints[report.joint].holds and held[0] > 0.0:
            # A segment that has shrunk to a point has no direction left.
            free = report.degenerate or not np.all(moved.profile.control_points[..., 0] > 0.0)
            assert report.holds or free


@given(chains(side=-1.0), anywhere)
def test_on_the_other_side_it_is_the_same(document, to):
    moved = edits.move_point(document, 0, 0, to, stop_at_axis=True)
    assert moved.profile.control_points[..., 0].max() <= 1e-9


def test_a_profile_that_crosses_already_is_free():
    document = Document(Profile.of([Segment([(-20, 0), (-10, 30), (10, 60), (20, 90)])]))
    moved = edits.move_point(document, 0, 3, (-30, 90), stop_at_axis=True)
    assert moved.profile.control_points[0, 3].tolist() == [-30.0, 90.0]


def test_a_handle_that_is_carried_keeps_its_direction():
    wall = Segment([(30, 0), (10, 10), (40, 60), (30, 90)])
    document = Document(Profile.of([Segment([(60, -9), (50, -9), (50, -10), (30, 0)]), wall]))
    document = edits.set_rule(document, 0, "G1")
    leg = document.profile.control_points[1, 1] - document.profile.control_points[1, 0]
    moved = edits.move_point(document, 1, 0, (8, 0), stop_at_axis=True).profile.control_points
    short = moved[1, 1] - moved[1, 0]
    assert moved[1, 1, 0] == pytest.approx(0.0, abs=1e-12)
    assert leg[0] * short[1] - leg[1] * short[0] == pytest.approx(0.0, abs=1e-9)


@pytest.mark.parametrize("away", [0.0, 5e-324, 1e-9])
def test_ends_nearer_than_rounding_carry_their_handles(away):
    """A chord of no length has no proportion to keep."""
    wall = Segment([(30.0, 0.0), (40.0, 1.0), (40.0, 2.0), (30.0, away)])
    moved = edits.move_point(Document(Profile.of([wall])), 0, 0, (10.0, 5.0), scale_legs=True)
    points = moved.profile.control_points[0]
    assert points.tolist()[1] == pytest.approx([20.0, 6.0])
    assert points.tolist()[2] == pytest.approx([40.0, 2.0], abs=1e-6)


@given(chains(), inside)
def test_scaled_legs_keep_their_part_of_the_chord(document, to):
    before = document.profile.segments[-1].points
    chord = np.hypot(*(before[3] - before[0]))
    assume(chord > 1.0)
    joined = len(document.profile) > 1
    assume(not joined or str(document.profile.rules[-1]) == "G0")
    last = len(document.profile) - 1
    after = edits.move_point(document, last, 3, to, scale_legs=True).profile.segments[-1].points
    factor = np.hypot(*(after[3] - after[0])) / chord
    for near, far in ((1, 0), (2, 3)):
        wanted = factor * (before[near] - before[far])
        assert np.allclose(after[near] - after[far], wanted, atol=1e-7)
