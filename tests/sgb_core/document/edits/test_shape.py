from __future__ import annotations

import numpy as np
import pytest
from hypothesis import HealthCheck, assume, given, settings
from hypothesis import strategies as st

from sgb_core.curves.continuity import measure_joint, measure_joints
from sgb_core.curves.segment import NEUTRAL, ShapeParameters
from sgb_core.document import edits
from sgb_core.document.edits import EditError
from tests.sgb_core.document import samples
from tests.sgb_core.document.strategies import RANGES, parts_of, shapes

calm = settings(deadline=None, suppress_health_check=list(HealthCheck))
ROUND = ShapeParameters(1.0, 3.0, 1.0, 0.5)


def test_one_parameter_of_one_segment_or_of_all() -> None:
    start = samples.document()
    one = edits.set_shape_parameter(start, 1, "lambda2", 4.5)
    assert [s.shape.lambda2 for s in one.profile.segments] == [3.0, 4.5, 3.0]
    assert one.profile.segments[0] is start.profile.segments[0]
    every = edits.set_shape_parameter(start, None, "omega", 0.25)
    assert [s.shape.omega for s in every.profile.segments] == [0.25] * 3
    assert edits.set_shape_parameter(start, 1, "lambda2", 3.0) is start


@pytest.mark.parametrize(
    ("segment", "name", "value", "text"),
    [
        (0, "omega", 2.0, "omega is 2; allowed is 0 to 1"),
        (0, "lambda2", -0.5, "lambda2 is -0.5; allowed is 0 to 6"),
        (0, "lambda1", float("nan"), "lambda1 is nan; allowed is a finite number"),
        (0, "lambda1", True, "lambda1 is True; allowed is a number"),
        (0, "size", 1.0, "no shape parameter 'size'"),
        (3, "omega", 0.5, "no segment 3; allowed is 0 to 2"),
        (-1, "omega", 0.5, "no segment -1"),
    ],
)
def test_what_is_out_of_range_is_refused(segment, name, value, text: str) -> None:
    with pytest.raises(EditError, match=text):
        edits.set_shape_parameter(samples.document(), segment, name, value)


def test_reset_is_the_plain_cubic() -> None:
    start = samples.document(shape=ShapeParameters(4.0, 0.0, 2.0, 1.0))
    assert edits.reset_shape(start, 1, None).profile.segments[1].shape == NEUTRAL
    cubic = edits.reset_shape(start, None, None)
    assert all(s.shape == NEUTRAL for s in cubic.profile.segments)
    some = edits.reset_shape(start, 0, "lambda1").profile.segments[0].shape
    assert some == ShapeParameters(1.0, 0.0, 2.0, 1.0)
    with pytest.raises(EditError):
        edits.reset_shape(start, 0, "size")  # type: ignore[arg-type]


def test_a_c1_joint_stays_c1_and_the_later_leg_yields() -> None:
    start = samples.document(rules=("C1", "C1"), shape=ROUND)
    moved = edits.set_shape_parameter(start, 0, "lambda3", 2.0)
    assert measure_joint(moved.profile, 0).holds
    before, after = start.profile.segments[1].points, moved.profile.segments[1].points
    # c1/a2 = (3 + ω(1 − 2))/(3 + ω(1 − 1)) = 2.5/3 of the master's leg of 2.
    np.testing.assert_allclose(after[1], [6.0, 4.0 + 2.0 * 2.5 / 3.0], rtol=1e-15)
    np.testing.assert_array_equal(after[[0, 2, 3]], before[[0, 2, 3]])


@calm
@given(st.integers(0, 2), st.sampled_from(list(RANGES)), st.data())
def test_sliders_never_break_a_smooth_joint_that_is_not_degenerate(segment, name, data) -> None:
    document = samples.document()
    value = data.draw(parts_of(RANGES[name]))
    smooth = edits.set_rule(edits.set_rule(document, 0, "G1"), 1, "C1")
    moved = edits.set_shape_parameter(smooth, segment, name, value)
    for before, after in zip(
        measure_joints(smooth.profile), measure_joints(moved.profile), strict=True
    ):
        if before.holds and not after.degenerate:
            assert after.holds


@calm
@given(shapes, st.integers(0, 2), st.floats(0.0, 1.0))
def test_dragging_q_moves_that_q_alone(shape: ShapeParameters, which: int, target: float) -> None:
    start = samples.document(samples.VASE[:1], shape=shape)
    moved = edits.set_leg_fraction(start, 0, which, target).profile.segments[0]
    expected = list(shape.leg_fractions)
    expected[which] = target
    np.testing.assert_allclose(moved.shape.leg_fractions, expected, rtol=0, atol=1e-14)
    np.testing.assert_array_equal(moved.points, start.profile.segments[0].points)


def test_dragging_q_changes_only_its_own_parameter_where_that_suffices() -> None:
    start = samples.document(samples.VASE[:1], shape=ROUND)
    near = edits.set_leg_fraction(start, 0, 0, 0.7).profile.segments[0].shape
    assert (near.lambda2, near.lambda3, near.omega) == (3.0, 1.0, 0.5)
    assert near.lambda1 == pytest.approx(1.4)
    far = edits.set_leg_fraction(start, 0, 0, 0.1).profile.segments[0].shape
    assert far.omega == 1.0
    cubic = samples.document(samples.VASE[:1])
    assert edits.set_leg_fraction(cubic, 0, 1, 0.5) is cubic
    assert edits.set_leg_fraction(cubic, 0, 1, 0.6).profile.segments[0].shape.omega == 1.0


def test_legs_and_fractions_that_do_not_exist_are_refused() -> None:
    start = samples.document()
    with pytest.raises(EditError, match="0 to 1"):
        edits.set_leg_fraction(start, 0, 0, 1.1)
    with pytest.raises(EditError, match="legs 0, 1 and 2"):
        edits.set_leg_fraction(start, 0, 3, 0.5)
    with pytest.raises(EditError, match="no segment"):
        edits.set_leg_fraction(start, 9, 0, 0.5)


@calm
@given(shapes, st.floats(0.0, 1.0))
def test_dragging_back_gives_the_same_curve(shape: ShapeParameters, target: float) -> None:
    start = samples.document(samples.VASE[:1], shape=shape)
    assume(0.0 <= shape.leg_fractions[1] <= 1.0)
    away = edits.set_leg_fraction(start, 0, 1, target)
    back = edits.set_leg_fraction(away, 0, 1, shape.leg_fractions[1])
    np.testing.assert_allclose(back.profile.quartics, start.profile.quartics, atol=1e-13)
