import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra import numpy as arrays

from sgb_core.exchange.digits import (
    COARSE,
    FINE,
    Decimal,
    number_lines,
    packed,
    write_integers,
)

FINITE = st.floats(-1e9, 1e9)


def text_of(values: np.ndarray, significant: int = FINE) -> str:
    before = (b"",) + (b" ",) * (values.shape[1] - 1)
    return b"".join(number_lines(values, before, b"\n", significant)).decode()


@given(
    arrays.arrays(np.float64, st.tuples(st.integers(1, 9), st.just(3)), elements=FINITE),
    st.sampled_from([COARSE, FINE]),
    st.sampled_from([1e-250, 1e-9, 1e-3, 1.0, 1e3, 1e200]),
)
def test_numbers_read_back_to_the_digits_promised(values, significant, scale):
    values = values * scale
    lines = text_of(values, significant).splitlines()
    read = np.array([[float(word) for word in line.split(" ")] for line in lines])
    largest = np.abs(values).max()
    assert np.abs(read - values).max() <= 1.001 * 0.5 * 10.0 ** (1 - significant) * largest


@pytest.mark.parametrize(
    ("value", "expected"),
    [
        (0.0, "0.0000000000"),
        (-0.0, "0.0000000000"),
        (70.0, "70.000000000"),
        (-0.5, "-0.50000000000"),
        (9.99999999999, "10.0000000000"),
        (99.9999999999999, "100.000000000"),
        (3e-7, "3.0000000000e-7"),
        (-1e9, "-1000000000.0"),
        (2.5e14, "2.5000000000e14"),
        (2.5e-310, "2.5000000000e-310"),
    ],
)
def test_one_number_looks_as_a_person_would_write_it(value, expected):
    assert text_of(np.array([[value]])) == expected + "\n"


def test_small_numbers_beside_large_ones_keep_one_zero_before_the_point():
    assert text_of(np.array([[1234.5, -0.25]])) == "1234.5000000 -0.2500000\n"


def test_more_rows_than_one_table_holds():
    values = np.arange(200_000.0).reshape(-1, 2)
    read = np.array(text_of(values).split(), dtype=float).reshape(-1, 2)
    assert np.array_equal(read, values)


@given(st.lists(st.integers(0, 10**12 - 1), min_size=1))
def test_integers(values):
    width = len(str(max(values)))
    table = np.full((len(values), width + 1), ord("\n"), dtype=np.uint8)
    write_integers(np.array(values), table[:, :width])
    assert packed(table).decode().split() == [str(value) for value in values]


def test_the_notation_of_an_empty_array():
    assert Decimal.for_values(np.empty((0, 3))).exponent == 0
