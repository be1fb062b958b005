from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from sgb_core.drawings.outermost import outermost
from sgb_core.drawings.page import Path

places = st.floats(-100.0, 100.0)


@given(arrays(np.float64, (4, 2), elements=places))
def test_a_cubic_reaches_as_far_as_its_farthest_point(piece) -> None:
    """Against many points of it, by Bernstein's sum written out."""
    t = np.linspace(0.0, 1.0, 4001)[:, None]
    s = 1.0 - t
    line = s**3 * piece[0] + 3 * s**2 * t * piece[1] + 3 * s * t**2 * piece[2] + t**3 * piece[3]
    found = outermost([Path((piece,))], -1e3, 1e3)
    assert found is not None
    farthest = np.abs(line[:, 0]).max()
    assert farthest - 1e-9 <= found[0] <= farthest + 1e-4
    away = np.hypot(np.abs(line[:, 0]) - found[0], line[:, 1] - found[1])
    assert away.min() < 0.2


def test_bounds_leave_out_what_is_beyond_them() -> None:
    slope = Path.through([(0.0, 0.0), (32.0, 32.0)])
    assert outermost([slope], 0.0, 16.0) == pytest.approx((16.0, 16.0))
    assert outermost([slope], 40.0, 50.0) is None
    assert outermost([], 0.0, 1.0) is None
