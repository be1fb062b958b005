"""Sequential quadratic programming where equations exclude each other."""

from __future__ import annotations

import numpy as np
import pytest

from sgb_core.arrays import Floats
from sgb_core.design.demands.chain import BLOCK, Chain
from sgb_core.design.demands.sqp import Model, minimise
from sgb_core.design.demands.unknowns import Unknowns


class _Apart:
    """y is to be 0 and 1 at once, under a function that is least at 3; counts its expansions."""

    def __init__(self, second: float) -> None:
        start = Chain(np.zeros((1, BLOCK)), 1.0, 0.0)
        self.unknowns = Unknowns(start, np.eye(BLOCK)[:, :1], np.array([-9.0]), np.array([9.0]))
        self.second = second
        self.expanded = 0

    def values(self, y: Floats) -> tuple[float, Floats]:
        return float((y[0] - 3.0) ** 2), np.array([y[0], y[0] - self.second])

    def expand(self, y: Floats, _multipliers: Floats) -> Model:
        self.expanded += 1
        value, residual = self.values(y)
        slope = np.ones((2, 1))
        return Model(value, 2.0 * (y - 3.0), np.array([[2.0]]), residual, slope)


def test_equations_that_exclude_each_other_end_the_search_soon_and_half_way() -> None:
    apart, alike = _Apart(1.0), _Apart(0.0)
    found = minimise(apart, np.array([5.0]), rounds=1000)
    assert not found.met
    assert found.y[0] == pytest.approx(0.5, abs=1e-3)
    assert apart.expanded < 40
    met = minimise(alike, np.array([5.0]), rounds=1000)
    assert met.met
    assert met.y[0] == pytest.approx(0.0, abs=1e-12)
