from __future__ import annotations

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from sgb_core.arrays import box, distinct

NUMBERS = st.lists(st.sampled_from([-0.0, 0.0, 1.0, 2.5]) | st.floats(-1e9, 1e9), max_size=8)


@given(st.lists(NUMBERS, min_size=1, max_size=3))
def test_distinct_numbers_are_numpys(values):
    expected = np.unique(np.concatenate([np.asarray(each, float) for each in values]))
    np.testing.assert_array_equal(distinct(*values), expected)


@given(
    st.integers(1, 5), st.integers(1, 4), st.sampled_from([np.float32, np.float64]), st.randoms()
)
def test_a_box_has_the_least_and_the_largest_of_each_column(rows, columns, kind, random):
    numbers = [[random.uniform(-9.0, 9.0) for _ in range(columns)] for _ in range(rows)]
    points = np.array(numbers, kind)
    low, high = box(points)
    np.testing.assert_array_equal(low, points.min(axis=0))
    np.testing.assert_array_equal(high, points.max(axis=0))
    assert low.dtype == high.dtype == kind
