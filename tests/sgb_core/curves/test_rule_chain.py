"""A G2 rule is tried on both sides of its joint before it is refused; a refused rule moves nothing.

The oracle scans each shape parameter over its range and looks for a sign change of the curvature
jump, measured from the curve.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from sgb_core.curves.constraints import enforce, keep_rule, move_control_points
from sgb_core.curves.continuity import measure_joint
from sgb_core.curves.moved import moved
from sgb_core.curves.profile import JointRule, Profile
from sgb_core.curves.rule_chain import RuleChain
from sgb_core.curves.segment import PARAMETER_RANGES, Segment, ShapeParameters
from sgb_core.curves.unmet import hindrance_at
from sgb_core.findings.joints import Hindrance
from tests.sgb_core.curves.strategies import chains

SAMPLES = 161
pairs = chains(JointRule.G2, closed=False, most=2)
# Both bend to the same side; the second's curvature at their joint reaches 0.230 to 0.291, the
# first's is 0.296, and λ3 takes it down to 0.167.
SHARP = Segment([[0, 3], [0, 1], [1.5, 0], [3, 0]], ShapeParameters(1, 3, 1, 1))
BENT = Segment([[3, 0], [5, 0], [7, 1.5], [7, 3]], ShapeParameters(1, 3, 1, 0.05))


def smooth(profile: Profile) -> Profile:
    """Return the profile with the leg of the later segment in line, its rule still G2."""
    legs = enforce(replace(profile, rules=(JointRule.G1,)), 0).profile
    return replace(legs, rules=(JointRule.G2,))


def can_be_met(profile: Profile, segment: int, name: str) -> bool:
    """Whether some value of one shape parameter alone makes a G1 joint of two segments G2."""
    jumps = []
    for value in np.linspace(*PARAMETER_RANGES[name], SAMPLES):
        part = profile.segments[segment]
        changed = part.with_shape(replace(part.shape, **{name: float(value)}))
        jump = measure_joint(profile.with_segment(segment, changed), 0).curvature_jump
        jumps.append(np.nan if jump is None else jump)
    signs = np.sign(jumps)
    return bool(np.any(signs[1:] * signs[:-1] < 0.0))


@given(pairs)
def test_a_refused_rule_moves_nothing_and_no_single_parameter_could_have_kept_it(profile) -> None:
    result = keep_rule(profile, 0)
    if measure_joint(result.profile, 0).holds:
        assert result.unmet == ()
        return
    assert moved(profile, result.profile) == ()
    assert [unmet.joint for unmet in result.unmet] == [0]
    aligned = smooth(profile)
    assume(measure_joint(aligned, 0).kink_deg < 1e-6)
    for segment, name in ((1, "lambda1"), (1, "lambda2"), (0, "lambda3"), (0, "lambda2")):
        assert not can_be_met(aligned, segment, name), (segment, name)


@given(pairs, st.booleans())
def test_the_other_side_moves_only_where_the_yielding_one_cannot_meet_it(profile, held) -> None:
    first, second = profile.segments
    profile = profile.with_segments((replace(first, holds_end=held), second))
    result = keep_rule(profile, 0)
    changes = {(each.segment, each.what) for each in moved(profile, result.profile)}
    own = {(1, "P1"), (1, "lambda1"), (1, "lambda2")}
    other = {(0, "lambda3"), (0, "lambda2")}
    assert changes <= own | other
    assert not (held and changes & other)
    if changes & other:
        assert changes <= {(1, "P1")} | other
        aligned = smooth(profile)
        assert not any(can_be_met(aligned, 1, name) for name in ("lambda1", "lambda2"))
    if (0, "lambda2") in changes:
        assert not can_be_met(smooth(profile), 0, "lambda3")
    if (1, "lambda2") in changes:
        assert not can_be_met(smooth(profile), 1, "lambda1")


def test_the_other_side_alone_meets_the_curvature_unless_it_holds() -> None:
    profile = Profile((SHARP, BENT), ("G2",))
    result = keep_rule(profile, 0).profile
    assert measure_joint(result, 0).holds
    assert [(m.segment, m.what) for m in moved(profile, result)] == [(0, "lambda3")]
    held = profile.with_segments((replace(SHARP, holds_end=True), BENT))
    assert keep_rule(held, 0).profile == held
    assert hindrance_at(held, 0) is Hindrance.NONE_IN_RANGE


def test_a_way_that_breaks_another_rule_comes_after_one_that_does_not() -> None:
    # Raising λ2 of the middle segment would do, and would break the rule at its other end.
    line = Segment([[7, 3], [7, 4], [7, 5], [7, 6]])
    flat = BENT.with_shape(ShapeParameters(0, 0, 1, 1))
    calm = SHARP.with_shape(ShapeParameters(1, 3, 0, 1))
    profile = Profile((calm, flat, line), ("G2", "G2"))
    assert [measure_joint(profile, k).holds for k in profile.joints] == [False, True]
    result = keep_rule(profile, 0)
    assert result.unmet == ()
    assert {each.segment for each in moved(profile, result.profile)} == {0}


def test_a_refused_rule_still_closes_a_gap() -> None:
    cubic = SHARP.with_shape(ShapeParameters())
    profile = Profile((cubic, Segment([[4, 1], [5, 1], [6, 2], [7, 2]])), ("G2",))
    result = keep_rule(profile, 0)
    assert [unmet.hindrance for unmet in result.unmet] == [Hindrance.PLAIN_CUBIC]
    changes = [(each.segment, each.what) for each in moved(profile, result.profile)]
    assert changes == [(1, "P0"), (1, "P1")]


def test_moved_needs_as_many_segments() -> None:
    with pytest.raises(ValueError, match="argument"):
        moved(Profile((SHARP,)), Profile((SHARP, BENT)))


def dragged(profile: Profile, share: float) -> Profile:
    """Return the profile with P2 of its first segment pulled towards the joint."""
    end, leg = profile.segments[0].points[3], profile.segments[0].points[2]
    return move_control_points(profile, {(0, 2): leg + share * 0.8 * (end - leg)}).profile


def test_while_a_leg_is_dragged_the_other_side_adds_what_the_yielding_one_misses() -> None:
    kept = keep_rule(Profile((SHARP, BENT), ("G2",)), 0).profile
    steps = [dragged(kept, share) for share in np.linspace(0.0, 1.0, 41)]
    holding = [measure_joint(profile, 0).holds for profile in steps]
    both = [{m.segment for m in moved(kept, p) if m.what.startswith("lambda")} for p in steps]
    assert {0, 1} in both
    # As far as both reach the rule holds, farther than one side alone would have kept it.
    reached = holding.index(False) if False in holding else len(holding)
    assert {0, 1} in both[:reached]
    held = kept.with_segments((replace(kept.segments[0], holds_end=True), kept.segments[1]))
    alone = [measure_joint(dragged(held, share), 0).holds for share in np.linspace(0.0, 1.0, 41)]
    assert sum(alone) < sum(holding)
    # Nothing jumps on the way.
    shapes = np.array([[p.segments[k].shape.leg_fractions for k in (0, 1)] for p in steps])
    assert np.abs(np.diff(shapes, axis=0)).max() < 0.1


@given(st.data(), chains(JointRule.G1))
def test_the_joints_of_segments_are_those_beside_them(data, profile) -> None:
    chosen = data.draw(st.sets(st.integers(0, len(profile) - 1)))
    beside = [j for j in profile.joints if chosen & set(profile.neighbours(j))]
    assert RuleChain(profile, "later").joints_of(chosen) == beside
