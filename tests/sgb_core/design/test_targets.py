"""Solving for a measure: exact, bounded, and in words where it cannot be."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from sgb_core.design.targets import TargetError, solve_factor


@given(st.floats(1e-3, 1e3), st.sampled_from([1.0, 2.0, 3.0]), st.floats(0.1, 10.0))
def test_powers_are_inverted(wanted: float, power: float, scale: float) -> None:
    found = solve_factor(lambda x: scale * x**power, wanted)
    assert scale * found**power == pytest.approx(wanted, rel=1e-9)


def test_a_wall_that_takes_its_share_is_met_exactly() -> None:
    def capacity(x: float) -> float:
        if x <= 0.2:
            raise ValueError("the wall fills the pot")
        return (x - 0.2) ** 3

    for wanted in (1e-6, 0.1, 0.512, 100.0):
        assert capacity(solve_factor(capacity, wanted)) == pytest.approx(wanted, rel=1e-9)


def test_what_is_met_already_stays() -> None:
    assert solve_factor(lambda x: 5.0 * x, 5.0) == 1.0


@pytest.mark.parametrize("wanted", [0.0, -1.0, float("nan")])
def test_nothing_holds_nothing(wanted: float) -> None:
    with pytest.raises(TargetError):
        solve_factor(lambda x: x, wanted)


def test_out_of_reach_is_said() -> None:
    with pytest.raises(TargetError, match="it cannot be made so large"):
        solve_factor(lambda x: min(x, 2.0), 3.0)
    with pytest.raises(TargetError, match="jumps"):
        solve_factor(lambda x: 1.0 if x < 1.5 else 4.0, 2.0)
