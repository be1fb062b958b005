from __future__ import annotations

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from sgb_core.curves.continuity import measure_joints
from sgb_core.document import edits
from sgb_core.document.edits import EditError
from tests.sgb_core.document import samples

calm = settings(deadline=None, suppress_health_check=list(HealthCheck))
places = st.tuples(st.floats(-9.0, 20.0), st.floats(-9.0, 20.0))


def points(document) -> np.ndarray:
    return document.profile.control_points


def test_a_free_end_moves_alone() -> None:
    start = samples.document()
    moved = points(edits.move_point(start, 0, 0, (1.0, -1.0))).copy()
    np.testing.assert_array_equal(moved[0, 0], [1.0, -1.0])
    moved[0, 0] = points(start)[0, 0]
    np.testing.assert_array_equal(moved, points(start))


@pytest.mark.parametrize("key", [(0, 3), (1, 0)])
def test_a_joint_stays_joined_and_carries_its_legs(key: tuple[int, int]) -> None:
    start = samples.document(rules=("G0", "G1"))
    moved = points(edits.move_point(start, *key, (7.0, 5.0)))
    shift = np.zeros((3, 4, 2))
    shift[0, 2:] = shift[1, :2] = [1.0, 1.0]
    np.testing.assert_array_equal(moved, points(start) + shift)


def test_a_free_joint_comes_apart() -> None:
    start = samples.document(rules=("free", "G0"))
    moved = points(edits.move_point(start, 0, 3, (7.0, 5.0)))
    np.testing.assert_array_equal(moved[1], points(start)[1])


def test_the_leg_beyond_a_smooth_joint_turns_and_keeps_its_length() -> None:
    start = samples.document(rules=("G1", "G0"))
    moved = points(edits.move_point(start, 0, 2, (9.0, 4.0)))
    # The leg before the joint now points to +r, so the one after it points to −r, 2 long.
    np.testing.assert_allclose(moved[1, 1], [4.0, 4.0], atol=1e-15)
    np.testing.assert_array_equal(moved[1, [0, 2, 3]], points(start)[1, [0, 2, 3]])


def test_breaking_a_rule_on_purpose_lowers_it() -> None:
    start = samples.document(rules=("G1", "G1"))
    moved = edits.move_point(start, 0, 2, (9.0, 4.0), keep_rules=False)
    assert moved.profile.rules == ("G0", "G1")
    np.testing.assert_array_equal(points(moved)[1], points(start)[1])
    apart = edits.move_point(start, 0, 3, (7.0, 5.0), keep_rules=False)
    np.testing.assert_array_equal(points(apart)[1, 0], [7.0, 5.0])
    np.testing.assert_array_equal(points(apart)[1, 1], points(start)[1, 1])


def test_a_group_moves_as_one() -> None:
    start = samples.document(rules=("G1", "G1"))
    every = [(k, i) for k in range(3) for i in range(4)]
    moved = edits.move_points(start, every, (1.0, 2.0))
    np.testing.assert_array_equal(points(moved) - points(start), np.full((3, 4, 2), (1.0, 2.0)))
    assert edits.move_points(start, [], (1.0, 2.0)) is start
    assert edits.move_points(start, every, (0.0, 0.0)) is start


def test_a_ring_whose_last_joint_is_free_stays_closed() -> None:
    points_ = [samples.HALVES[0], samples.HALVES[1][::-1]]
    ring = samples.document(points_, ("G0", "free"), closed=True)
    moved = edits.move_point(ring, 1, 3, (4.0, -1.0))
    np.testing.assert_array_equal(points(moved)[0, 0], [4.0, -1.0])
    assert moved.profile.rules == ("G0", "free")


@pytest.mark.parametrize(
    ("segment", "index", "place", "text"),
    [
        (5, 0, (0, 0), "no segment 5; allowed is 0 to 2"),
        (0, 4, (0, 0), "points 0 to 3, not 4"),
        (0, 0, (2e9, 0), "farther than 1e9"),
        (0, 0, (float("inf"), 0), "finite number"),
        (0, 0, (1, 2, 3), "allowed is a pair"),
        (0, 0, ("1", 2), "allowed is a number"),
    ],
)
def test_what_cannot_be_moved_is_said(segment, index, place, text: str) -> None:
    with pytest.raises(EditError, match=text):
        edits.move_point(samples.document(), segment, index, place)


def test_a_group_cannot_leave_the_allowed_range() -> None:
    with pytest.raises(EditError, match="farther than 1e9"):
        edits.move_points(samples.document(), [(0, 1)], (1e10, 0.0))


@calm
@given(st.lists(st.tuples(st.integers(0, 2), st.integers(0, 3), places), max_size=6))
def test_rules_hold_after_any_drags(steps) -> None:
    document = samples.document(rules=("G1", "C1"))
    for segment, index, place in steps:
        moved = edits.move_point(document, segment, index, place)
        for joint in measure_joints(moved.profile):
            legs = moved.profile.control_points[[joint.joint, joint.joint + 1]]
            lengths = np.hypot(*(legs[0, 3] - legs[0, 2])), np.hypot(*(legs[1, 1] - legs[1, 0]))
            assert joint.gap == 0.0
            if min(lengths) > 1e-6 and joint.rule == "G1":
                assert joint.holds
        document = moved
