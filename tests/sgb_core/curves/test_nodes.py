from __future__ import annotations

from math import pi

import numpy as np
import pytest

from sgb_core.curves.nodes import derivative_rows, gauss, on_nodes, panels
from tests.sgb_core.surfaces.chains import TOWER, chain


def test_six_points_are_exact_for_degree_eleven_and_five_are_not() -> None:
    for count, exact in ((6, True), (5, False)):
        nodes, weights = gauss(count)
        assert bool(abs(weights @ nodes**11 - 1 / 12) < 1e-15) == exact


def test_panels_cover_their_edges() -> None:
    nodes, weights = panels(np.array([0.0, 1.0, pi]), 10)
    assert weights @ np.sin(nodes) == pytest.approx(2.0, rel=1e-12)


def test_derivative_rows_agree_with_differences() -> None:
    s = np.linspace(0, 1, 7)
    quartics = chain(TOWER, (2, 5, 1, 0.8)).quartics
    for order in range(4):
        rows = derivative_rows(order, s.tobytes()) @ quartics
        np.testing.assert_allclose(rows, on_nodes(quartics, s, order), atol=1e-11)
