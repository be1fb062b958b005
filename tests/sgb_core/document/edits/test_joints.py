from __future__ import annotations

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from sgb_core.curves.continuity import measure_joints
from sgb_core.curves.segment import ShapeParameters
from sgb_core.document import edits
from sgb_core.document.edits import EditError
from sgb_core.surfaces.variation import Law
from tests.sgb_core.document import samples
from tests.sgb_core.document.strategies import shapes

calm = settings(deadline=None, suppress_health_check=list(HealthCheck))
BEND = ShapeParameters(0.5, 4.0, 2.0, 0.7)
KINKED = samples.document(
    [[[4, 0], [5, 1], [6, 2], [6, 4]], [[6, 4], [4, 5], [3, 6], [3, 8]]], shape=BEND
)
OMEGA = Law("omega", "raised-cosine", 0.0, 1.0)


def points(document) -> np.ndarray:
    return document.profile.control_points


@pytest.mark.parametrize("rule", ["G1", "C1", "G2"])
def test_a_rule_is_satisfied_when_it_is_set(rule: str) -> None:
    ruled = edits.set_rule(KINKED, 0, rule)
    assert ruled.profile.rules == (rule,)
    assert measure_joints(ruled.profile)[0].holds
    np.testing.assert_array_equal(points(ruled)[0], points(KINKED)[0])


def test_a_gap_is_closed_by_a_rule_and_free_moves_nothing() -> None:
    apart = samples.document([samples.VASE[0], samples.VASE[2]], ("free",))
    joined = edits.set_rule(apart, 0, "G0")
    np.testing.assert_array_equal(points(joined)[1, 0], points(joined)[0, 3])
    free = edits.set_rule(KINKED, 0, "free")
    np.testing.assert_array_equal(points(free), points(KINKED))


def test_rules_and_joints_that_do_not_exist_are_refused() -> None:
    with pytest.raises(EditError, match="no joint rule 'G3'; allowed is free, G0, G1, C1, G2"):
        edits.set_rule(KINKED, 0, "G3")
    with pytest.raises(EditError, match="no joint 1; allowed is 0 to 0"):
        edits.set_rule(KINKED, 1, "G1")
    with pytest.raises(EditError, match="the profile has no joints"):
        edits.set_rule(samples.document(samples.VASE[:1]), 0, "G1")


def test_closing_with_a_line_and_opening_again() -> None:
    ring = edits.close_profile(KINKED)
    assert (ring.profile.closed, ring.profile.rules) == (True, ("G0", "G0", "G0"))
    np.testing.assert_allclose(points(ring)[2], np.linspace([3, 8], [4, 0], 4), atol=1e-15)
    with pytest.raises(EditError, match="closed already"):
        edits.close_profile(ring)
    with pytest.raises(EditError, match="cannot be free"):
        edits.set_rule(ring, 2, "free")
    opened = edits.open_profile(ring)
    np.testing.assert_array_equal(points(opened), points(ring))
    assert opened.profile.rules == ("G0", "G0")
    with pytest.raises(EditError, match="open already"):
        edits.open_profile(opened)
    assert edits.close_profile(opened) == ring


@calm
@given(shapes, st.floats(0.01, 0.99))
def test_splitting_keeps_the_curve(shape: ShapeParameters, s: float) -> None:
    start = samples.document(rules=("G1", "G1"), shape=shape)
    halves, deviation = edits.split_segment(start, 1, s)
    u = np.linspace(0.0, 1.0, 17)
    error = 1e-12 * start.profile.size + deviation
    np.testing.assert_allclose(
        halves.profile.point(1, u), start.profile.point(1, s * u), rtol=0, atol=error
    )
    np.testing.assert_allclose(
        halves.profile.point(2, u), start.profile.point(1, s + (1 - s) * u), rtol=0, atol=error
    )
    assert len(halves.profile.rules) == 3


def test_a_split_lowers_only_what_it_cannot_keep() -> None:
    start = edits.set_rule(edits.set_rule(samples.document(shape=BEND), 0, "C1"), 1, "G1")
    halves, _ = edits.split_segment(start, 1, 0.5)
    assert halves.profile.rules == ("G1", "G1", "G1")
    assert all(joint.holds for joint in measure_joints(halves.profile))
    other, _ = edits.split_segment(start, 2, 0.5)
    assert other.profile.rules == ("C1", "G1", "G1")


@pytest.mark.parametrize("s", [0.0, 1.0, -1.0, float("nan")])
def test_a_split_is_inside(s: float) -> None:
    with pytest.raises(EditError, match="s is"):
        edits.split_segment(KINKED, 0, s)


def test_merging_undoes_a_split() -> None:
    halves, _ = edits.split_segment(KINKED, 0, 0.3)
    merged, deviation = edits.merge_segments(halves, 0)
    assert deviation < 1e-9
    np.testing.assert_allclose(merged.profile.bounds(), KINKED.profile.bounds(), atol=1e-8)
    assert merged.profile.rules == ("G0",)


def test_merging_reports_how_far_the_curve_moved() -> None:
    merged, deviation = edits.merge_segments(KINKED, 0)
    assert len(merged.profile) == 1
    assert deviation > 0.01
    np.testing.assert_array_equal(points(merged)[0, [0, 3]], [[4, 0], [3, 8]])


def test_merging_across_the_end_of_a_ring() -> None:
    ring = edits.close_profile(KINKED)
    merged, _ = edits.merge_segments(ring, 2)
    assert merged.profile.closed
    assert len(merged.profile) == 2
    np.testing.assert_array_equal(points(merged)[0], points(ring)[1])
    np.testing.assert_allclose(points(merged)[1, [0, 3]], points(ring)[[2, 0], [0, 3]])


def test_what_cannot_be_merged_is_said() -> None:
    with pytest.raises(EditError, match="is the last"):
        edits.merge_segments(KINKED, 1)
    with pytest.raises(EditError, match="only one segment"):
        edits.merge_segments(samples.document(samples.VASE[:1]), 0)
    with pytest.raises(EditError, match="do not meet"):
        edits.merge_segments(samples.document([samples.VASE[0], samples.VASE[2]], ("free",)), 0)


def test_a_split_under_a_law_says_how_far_the_surface_moves() -> None:
    start = samples.document(
        samples.VASE[:2], shape=ShapeParameters(0.0, 6.0, 0.0, 0.5), laws=(OMEGA,)
    )
    halves, deviation = edits.split_segment(start, 0, 0.5)
    assert deviation > 1e-3
    u = np.linspace(0.0, 1.0, 33)
    worst = 0.0
    for theta in np.linspace(0.0, 2.0 * np.pi, 48, endpoint=False):
        old, new = start.surface.profile_at(theta), halves.surface.profile_at(theta)
        worst = max(worst, np.abs(old.point(0, 0.5 * u) - new.point(0, u)).max())
        np.testing.assert_allclose(new.point(2, u), old.point(1, u), atol=1e-14)
    assert worst <= deviation * (1 + 1e-9)


def test_laws_of_both_survive_a_merge_and_laws_of_one_do_not() -> None:
    laws = (
        OMEGA,
        Law("lambda1", "paper", 0, 1, (1,)),
        Law("lambda2", "paper", 0, 1, (0, 1)),
    )
    start = samples.document(shape=BEND, laws=laws)
    merged, deviation = edits.merge_segments(start, 0)
    assert [(law.parameter, law.segments) for law in merged.variation] == [
        ("omega", None),
        ("lambda2", (0,)),
    ]
    assert deviation > 0.0
