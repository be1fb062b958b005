"""The chain: counting, bounds, reversal, sampling."""

from __future__ import annotations

from math import hypot

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sgb_core.curves.profile import JointRule, Profile
from sgb_core.curves.segment import Segment
from tests.sgb_core.curves.strategies import chains, segments

rules = st.sampled_from(list(JointRule))


@given(st.lists(segments(), min_size=1, max_size=4))
def test_bounds_hold_and_are_reached(parts) -> None:
    profile = Profile(tuple(parts), (JointRule.FREE,) * (len(parts) - 1))
    low, high = profile.bounds()
    dense = profile.sample(400).reshape(-1, 2)
    assert (dense >= low - 1e-12).all()
    assert (dense <= high + 1e-12).all()
    assert (dense.min(axis=0) - low <= 2e-3 * profile.size + 1e-12).all()
    assert (high - dense.max(axis=0) <= 2e-3 * profile.size + 1e-12).all()


@given(rules.flatmap(chains))
def test_reversing_twice_is_the_identity(profile) -> None:
    back = profile.reversed()
    np.testing.assert_allclose(
        back.sample(9).reshape(-1, 2), profile.sample(9).reshape(-1, 2)[::-1], atol=1e-12
    )
    twice = back.reversed()
    assert twice.rules == profile.rules
    np.testing.assert_array_equal(twice.control_points, profile.control_points)


def test_joints_of_open_and_closed_profiles() -> None:
    one = Segment([[1, 0], [2, 0], [2, 1], [1, 0]])
    ring = Profile((one, one, one), ("G0", "G1", "C1"), closed=True)
    assert [ring.neighbours(j) for j in ring.joints] == [(0, 1), (1, 2), (2, 0)]
    assert ring.reversed().rules == ("G1", "G0", "C1")
    assert len(Profile((one,)).joints) == 0
    with pytest.raises(ValueError, match="joints"):
        Profile((one, one), ("G0", "G0"))
    with pytest.raises(ValueError, match="a list of 0; allowed is a list of 1"):
        Profile(())
    with pytest.raises(ValueError, match="2 or more"):
        ring.sample(1)


def test_size_is_the_diagonal_of_the_control_points() -> None:
    profile = Profile((Segment([[0, 0], [3, 0], [3, 4], [0, 4]]),))
    assert profile.size == 5.0


@given(st.data(), rules.flatmap(lambda rule: chains(rule, most=6)))
def test_arrays_of_an_edited_chain_are_those_of_a_new_one(data, profile) -> None:
    known = data.draw(st.sets(st.sampled_from(("control_points", "quartics", "shape_values"))))
    for name in known:
        getattr(profile, name)
    edited = profile
    for _ in range(data.draw(st.integers(1, 2))):
        number = data.draw(st.integers(0, len(profile) - 1))
        edited = edited.with_segment(number, data.draw(segments()))
    anew = Profile(edited.segments, edited.rules, edited.closed)
    for name in ("control_points", "quartics", "shape_values"):
        np.testing.assert_array_equal(getattr(edited, name), getattr(anew, name))
        assert not getattr(edited, name).flags.writeable


@given(st.lists(segments(), min_size=1, max_size=4), st.booleans())
def test_gaps_are_the_distances_of_the_ends(parts, closed) -> None:
    profile = Profile.of(parts, closed=closed)
    for joint, gap in zip(profile.joints, profile.gaps, strict=True):
        first, second = profile.neighbours(joint)
        end, start = parts[first].points[3].tolist(), parts[second].points[0].tolist()
        assert gap == hypot(end[0] - start[0], end[1] - start[1])
