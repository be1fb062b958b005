"""The least of a quadratic in a box: by its own conditions, and against another search."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.optimize import minimize

from sgb_core.design.demands.sqp import box_minimum


@pytest.mark.parametrize("seed", range(12))
def test_a_convex_quadratic_in_a_box_is_the_least_there(seed: int) -> None:
    random = np.random.default_rng(seed)
    count = int(random.integers(2, 25))
    root = random.normal(size=(count, count))
    matrix = root @ root.T + 0.05 * np.eye(count)
    pull = 4.0 * random.normal(size=count)
    low, high = -random.random(count), random.random(count)
    found = box_minimum(matrix, pull, low, high, random.normal(size=count))
    assert ((found >= low) & (found <= high)).all()
    slope = matrix @ found + pull
    inside = (found > low) & (found < high)
    # The conditions of Karush, Kuhn and Tucker: no slope inside, outwards at the bounds.
    size = np.abs(matrix).max() + np.abs(pull).max()
    assert np.abs(slope[inside]).max(initial=0.0) <= 1e-9 * size
    assert (slope[found <= low] >= -1e-9 * size).all()
    assert (slope[found >= high] <= 1e-9 * size).all()


@pytest.mark.parametrize("seed", range(6))
def test_where_it_is_not_convex_it_goes_down(seed: int) -> None:
    random = np.random.default_rng(seed)
    root = random.normal(size=(9, 9))
    matrix, pull = root + root.T, random.normal(size=9)
    low, high = -np.ones(9), np.ones(9)
    found = box_minimum(matrix, pull, low, high, np.zeros(9))
    values, vectors = np.linalg.eigh(matrix)
    convex = (vectors * np.abs(values)) @ vectors.T
    best = minimize(
        lambda p: 0.5 * p @ convex @ p + pull @ p, np.zeros(9), bounds=[(-1.0, 1.0)] * 9
    )
    reached = 0.5 * found @ convex @ found + pull @ found
    assert reached <= best.fun + 1e-6 or 0.5 * found @ matrix @ found + pull @ found <= best.fun
