"""One end of a chain moved across: what goes along, what stays, what goes on as it was."""

import numpy as np
import pytest

from sgb_core.curves.continuity import JointClass, measure_joints
from sgb_core.curves.flare import REACH, flared
from sgb_core.curves.primitives import line
from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import Segment
from sgb_core.document import edits
from sgb_core.document.model import Document


def vase():
    belly = Segment(np.array([(20.0, 0), (45, 10), (52, 40), (38, 60)]))
    neck = Segment(np.array([(38.0, 60), (24, 80), (14, 95), (15, 112)]))
    return Document(Profile.of([belly, neck], ["G1"]))


def split(document, rounds):
    for _ in range(rounds):
        for k in reversed(range(len(document.profile))):
            document = edits.split_segment(document, k, 0.5)[0]
    return document


def with_points(profile, points):
    return profile.with_segments(
        each.with_points(p) for each, p in zip(profile.segments, points, strict=True)
    )


@pytest.mark.parametrize("last", [True, False])
@pytest.mark.parametrize("step", [3.0, -4.0])
def test_the_end_goes_all_the_way_and_beyond_the_reach_nothing_moves(last, step):
    profile = split(vase(), 4).profile
    moved = with_points(profile, flared(profile, last=last, step=step))
    before, after = profile.sample(9).reshape(-1, 2), moved.sample(9).reshape(-1, 2)
    if last:
        before, after = before[::-1], after[::-1]
    along = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(before, axis=0).T))])
    away = after - before
    assert away[0] == pytest.approx((step, 0.0))
    assert np.abs(away[:, 1]).max() == pytest.approx(0.0, abs=1e-12)
    reach = REACH * abs(step)
    assert np.abs(away[along > 1.05 * reach]).max() < 0.02 * abs(step)
    # w(1/2) = 1/2, and the weight falls all the way.
    assert np.interp(reach / 2.0, along, away[:, 0]) == pytest.approx(step / 2.0, rel=0.02)
    assert (np.diff(away[:, 0]) * np.sign(step) < 0.002 * abs(step)).all()


@pytest.mark.parametrize("rounds", [0, 3])
def test_tangents_go_on_as_they_were(rounds):
    profile = split(vase(), rounds).profile
    moved = with_points(profile, flared(profile, last=True, step=6.0))
    for report in measure_joints(moved):
        assert report.measured not in (JointClass.GAP, JointClass.G0)


def test_what_is_straight_between_kinks_stays_straight():
    cup = Profile.of([line((10.0, 0.0), (20.0, 0.0)), line((20.0, 0.0), (20.0, 60.0))])
    points = flared(cup, last=True, step=15.0)
    assert np.allclose(points[1, :, 0], [20.0, 25.0, 30.0, 35.0])
    assert np.array_equal(points[0], cup.control_points[0])


def test_what_lies_on_the_axis_stays_there():
    points = np.array(vase().profile.control_points)
    points[0, 0] = (0.0, 0.0)
    profile = split(Document(with_points(vase().profile, points)), 2).profile
    moved = flared(profile, last=True, step=400.0)
    assert np.array_equal(moved[0], profile.control_points[0])
    assert moved[-1, 3, 0] == 415.0
