"""The chain: counting, bounds, reversal, sampling."""

from __future__ import annotations

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
