from __future__ import annotations

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from sgb_core.curves.continuity import measure_joints
from sgb_core.curves.segment import ShapeParameters
from sgb_core.document import edits
from sgb_core.document.edits import EditError
from sgb_core.surfaces import measures
from sgb_core.surfaces.variation import Law
from tests.sgb_core.document import samples
from tests.sgb_core.document.strategies import profiles, shapes

calm = settings(deadline=None, suppress_health_check=list(HealthCheck))
SMOOTH = samples.document(rules=("G1", "G1"))
RING = samples.document([samples.HALVES[0], samples.HALVES[1][::-1]], ("G0", "G0"), closed=True)
BEND = ShapeParameters(0.5, 4.0, 2.0, 0.7)


def points(document) -> np.ndarray:
    return document.profile.control_points


def law(parameter: str, segments: tuple[int, ...] | None = None) -> Law:
    return Law(parameter, "raised-cosine", 0.5, 1.0, segments)  # type: ignore[arg-type]


def test_an_appended_segment_continues_smoothly() -> None:
    longer = edits.append_segment(SMOOTH)
    assert longer.profile.rules == ("G1", "G1", "G1")
    assert measure_joints(longer.profile)[2].holds
    np.testing.assert_array_equal(points(longer)[:3], points(SMOOTH))
    chord = np.hypot(*(points(longer)[3, 3] - points(longer)[3, 0]))
    assert 2.0 < chord < 6.0
    first = edits.prepend_segment(SMOOTH)
    assert measure_joints(first.profile)[0].holds
    np.testing.assert_array_equal(points(first)[1:], points(SMOOTH))


@calm
@given(profiles(), shapes)
def test_any_open_profile_can_be_continued_on_its_side_of_the_axis(profile, shape) -> None:
    document = samples.document(points_of(profile), shape=shape)
    longer = edits.append_segment(document)
    new = points(longer)[-1]
    if (points(document)[..., 0] >= 0.0).all():
        assert (new[:, 0] >= -1e-9 * profile.size).all()
    assert np.ptp(new, axis=0).any()


def points_of(profile) -> list:
    """Return the profile's points moved up to the axis and joined, as an open chain."""
    found = profile.control_points.copy()
    found[1:, 0] = found[:-1, 3]
    found[..., 0] -= min(found[..., 0].min(), 0.0)
    return list(np.clip(found, -1e8, 1e8))


def test_an_end_that_runs_into_the_axis_turns_back_with_a_kink() -> None:
    cone = samples.document([[[3, 0], [2, 1], [1, 2], [0, 3]]])
    longer = edits.append_segment(cone)
    assert longer.profile.rules == ("G0",)
    assert (points(longer)[..., 0] >= 0.0).all()


def test_a_single_point_can_be_continued() -> None:
    longer = edits.append_segment(samples.document([[[2, 1]] * 4]))
    np.testing.assert_array_equal(points(longer)[1, 3], [2.0, 2.0])


def test_an_inserted_segment_makes_room_along_the_axis_only() -> None:
    longer = edits.insert_segment(SMOOTH, 1)
    assert longer.profile.rules == ("G1", "G1", "G1")
    assert all(joint.holds for joint in measure_joints(longer.profile))
    np.testing.assert_array_equal(points(longer)[0], points(SMOOTH)[0])
    shift = points(longer)[2:] - points(SMOOTH)[1:]
    assert (shift[..., 0] == 0.0).all()
    assert np.ptp(shift[..., 1]) < 1e-12
    assert shift[0, 0, 1] > 0.0


def test_inserting_at_the_ends_continues_the_chain() -> None:
    assert edits.insert_segment(SMOOTH, 3) == edits.append_segment(SMOOTH)
    assert edits.insert_segment(SMOOTH, 0) == edits.prepend_segment(SMOOTH)
    with pytest.raises(EditError, match="at 4; allowed is 0 to 3"):
        edits.insert_segment(SMOOTH, 4)


def test_a_ring_grows_by_splitting() -> None:
    longer = edits.insert_segment(RING, 1)
    assert len(longer.profile) == 3
    assert measures.volume(longer.surface) == pytest.approx(measures.volume(RING.surface), 1e-12)
    with pytest.raises(EditError, match="a ring has no end"):
        edits.append_segment(RING)


def test_removing_an_end_moves_nothing() -> None:
    np.testing.assert_array_equal(points(edits.remove_segment(SMOOTH, 0)), points(SMOOTH)[1:])
    np.testing.assert_array_equal(points(edits.remove_segment(SMOOTH, 2)), points(SMOOTH)[:2])


def test_removing_inside_joins_the_neighbours_halfway() -> None:
    shorter = edits.remove_segment(SMOOTH, 1)
    assert shorter.profile.rules == ("G1",)
    assert measure_joints(shorter.profile)[0].holds
    np.testing.assert_allclose(points(shorter)[0, 3], [4.5, 6.0])
    np.testing.assert_array_equal(points(shorter)[0, :2], points(SMOOTH)[0, :2])


def test_the_weaker_rule_wins_and_free_ends_stay_apart() -> None:
    mixed = samples.document(rules=("C1", "G2"))
    assert edits.remove_segment(mixed, 1).profile.rules == ("G1",)
    loose = samples.document(rules=("free", "G1"))
    shorter = edits.remove_segment(loose, 1)
    assert shorter.profile.rules == ("free",)
    np.testing.assert_array_equal(points(shorter), points(SMOOTH)[[0, 2]])


def test_a_ring_of_two_is_opened_and_the_last_segment_stays() -> None:
    half = edits.remove_segment(RING, 1)
    assert not half.profile.closed
    np.testing.assert_array_equal(points(half)[0], points(RING)[0])
    with pytest.raises(EditError, match="only segment"):
        edits.remove_segment(half, 0)


@pytest.mark.parametrize("index", [0, 1, 2])
def test_a_ring_of_three_stays_a_ring(index: int) -> None:
    ring = edits.insert_segment(RING, 1)
    shorter = edits.remove_segment(ring, index)
    assert shorter.profile.closed
    assert all(joint.gap == 0.0 for joint in measure_joints(shorter.profile))


def test_reversing_the_profile_twice_is_the_identity() -> None:
    laws = (law("lambda1", (0,)), law("lambda2"), law("omega", (1, 2)))
    start = samples.document(rules=("G1", "C1"), shape=BEND, laws=laws)
    once = edits.reverse_profile(start)
    assert once.profile.rules == ("C1", "G1")
    assert [(each.parameter, each.segments) for each in once.variation] == [
        ("lambda3", (2,)),
        ("lambda2", None),
        ("omega", (0, 1)),
    ]
    assert (once.variation[1].start, once.variation[1].end) == (5.5, 5.0)
    assert measures.volume(once.surface) == pytest.approx(measures.volume(start.surface), 1e-12)
    assert edits.reverse_profile(once) == start


def test_reversing_one_segment_leaves_its_points_and_frees_its_joints() -> None:
    start = samples.document(shape=BEND)
    once = edits.reverse_segment(start, 1)
    assert once.profile.rules == ("free", "free")
    np.testing.assert_array_equal(points(once)[1], points(start)[1, ::-1])
    s = np.linspace(0.0, 1.0, 9)
    np.testing.assert_allclose(
        once.profile.point(1, s), start.profile.point(1, 1.0 - s), atol=1e-14
    )
    assert edits.reverse_segment(once, 1) == start


def test_reversing_the_only_segment_is_reversing_the_profile() -> None:
    start = samples.document(samples.VASE[:1], shape=BEND, laws=(law("lambda3"),))
    assert edits.reverse_segment(start, 0) == edits.reverse_profile(start)


def test_a_ring_that_comes_apart_at_its_last_joint_opens() -> None:
    ring = samples.document(
        [samples.VASE[0], samples.VASE[1], [[3, 8], [1, 8], [1, 0], [4, 0]]], ["G0"] * 3, True
    )
    once = edits.reverse_segment(ring, 0)
    assert not once.profile.closed
    assert once.profile.rules == ("free", "G0")
    inner = edits.reverse_segment(ring, 1)
    assert inner.profile.closed
    assert inner.profile.rules == ("free", "free", "G0")


def test_laws_of_one_reversed_segment_are_taken_apart() -> None:
    start = samples.document(laws=(law("lambda1"), law("omega"), law("lambda2", (1,))))
    once = edits.reverse_segment(start, 1)
    assert [(each.parameter, each.segments) for each in once.variation] == [
        ("lambda1", (0, 2)),
        ("lambda3", (1,)),
        ("omega", None),
        ("lambda2", (1,)),
    ]
    s = np.linspace(0.0, 1.0, 5)
    for theta in (0.0, 1.0, 2.5):
        turned, straight = once.surface.profile_at(theta), start.surface.profile_at(theta)
        np.testing.assert_allclose(turned.point(1, s), straight.point(1, 1.0 - s), atol=1e-14)


def test_laws_follow_their_segments() -> None:
    start = samples.document(laws=(law("omega", (0, 2)), law("lambda1", (1,)), law("lambda2")))
    shorter = edits.remove_segment(start, 1)
    assert [each.segments for each in shorter.variation] == [(0, 1), None]
    longer = edits.insert_segment(start, 1)
    assert [each.segments for each in longer.variation] == [(0, 3), (2,), None]
    assert [each.segments for each in edits.append_segment(start).variation] == [
        (0, 2),
        (1,),
        None,
    ]


def test_halves_given_in_the_same_direction_become_a_ring() -> None:
    halves = samples.document(samples.HALVES, ("free",), laws=(law("lambda1", (1,)),))
    ring = edits.head_to_tail(halves)
    assert ring.profile.closed
    assert ring.profile.rules == ("G0", "G0")
    assert ring.variation[0].parameter == "lambda3"
    np.testing.assert_array_equal(points(ring)[1], points(halves)[1, ::-1])
    assert edits.close_profile(halves) == ring
    assert measures.volume(ring.surface) == pytest.approx(measures.volume(RING.surface), 1e-12)


def test_runs_of_several_segments_are_put_head_to_tail() -> None:
    ring = edits.split_segment(edits.insert_segment(RING, 0), 2, 0.4)[0]
    opened = edits.open_profile(ring)
    flipped = samples.document(
        [*points(opened)[:2], *points(opened)[:1:-1, ::-1]], ("G0", "free", "G0")
    )
    again = edits.head_to_tail(flipped)
    assert again.profile.closed
    np.testing.assert_array_equal(points(again), points(ring))


def test_two_runs_that_leave_one_point_are_joined_there() -> None:
    apart = samples.document([samples.VASE[1], samples.VASE[0][::-1]], ("free",))
    joined = edits.head_to_tail(apart)
    assert not joined.profile.closed
    np.testing.assert_array_equal(points(joined)[0, 3], points(joined)[1, 0])


@pytest.mark.parametrize("document", [SMOOTH, RING])
def test_nothing_apart_cannot_be_put_head_to_tail(document) -> None:
    with pytest.raises(EditError, match="ends of this profile"):
        edits.head_to_tail(document)


def test_runs_that_meet_nowhere_cannot_be_put_head_to_tail() -> None:
    far = samples.document([samples.VASE[0], samples.VASE[2]], ("free",))
    with pytest.raises(EditError, match="ends of this profile"):
        edits.head_to_tail(far)


@calm
@given(st.integers(0, 2))
def test_there_is_no_segment_beyond_the_last(extra: int) -> None:
    for edit in (edits.remove_segment, edits.reverse_segment, edits.merge_segments):
        with pytest.raises(EditError, match="no segment"):
            edit(SMOOTH, 3 + extra)


def test_what_is_appended_to_a_single_segment_does_not_double_the_profile():
    single = samples.document([((30, 0), (46, 25), (46, 75), (34, 100))])
    assert 120.0 < edits.append_segment(single).height < 150.0
