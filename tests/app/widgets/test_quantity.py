"""Numbers as people type them."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.widgets.quantity import QuantityError, format_number, parse_number, signed_percent


@pytest.mark.parametrize(
    ("text", "unit", "value"),
    [
        ("12.5/2", "mm", 6.25),
        ("(3+4)*2", "mm", 14.0),
        ("3cm", "mm", 30.0),
        ("1/2 in", "mm", 12.7),
        ("1/2 in", "in", 0.5),
        ("1 1/2 in", "in", 1.5),
        ("1 1/2", "cm", 1.5),
        ("12,5", "mm", 12.5),
        (",5", "", 0.5),
        ("3cm+2", "mm", 32.0),
        ("2+3cm", "cm", 5.0),
        ("2*3cm", "mm", 60.0),
        ("(1+2)cm", "mm", 30.0),
        ("10cm/2", "mm", 50.0),
        ("10cm/2cm", "mm", 5.0),
        ("2in", "cm", 5.08),
        ('1"', "mm", 25.4),
        ("1'", "in", 12.0),
        ("-3", "mm", -3.0),
        ("2--3", "mm", 5.0),
        ("−3 × 2", "mm", -6.0),
        ("6 ÷ 4", "", 1.5),
        ("1e-3 m", "mm", 1.0),
        ("1.e2", "mm", 100.0),
        ("50%", "", 0.5),
        ("90°", "deg", 90.0),
        ("1/4 turn", "deg", 90.0),
        ("2-3-4", "mm", -5.0),
        ("8/4/2", "mm", 1.0),
        ("2+3*4", "mm", 14.0),
        ("  7 MM ", "mm", 7.0),
    ],
)
def test_reads(text, unit, value):
    assert parse_number(text, unit) == pytest.approx(value, rel=1e-15)


def test_a_half_turn_in_radians():
    assert parse_number(f"{math.pi!r} rad", "deg") == pytest.approx(180.0, rel=1e-15)


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("", "type a number"),
        ("   ", "type a number"),
        ("abc", "“abc” is not a number"),
        ("1/0", "division by zero"),
        ("1/(2-2)", "division by zero"),
        ("(1+2", "closing bracket"),
        ("1+2)", "“)” is not expected"),
        ("12+", "missing at the end"),
        ("3 4", "“4” is not expected"),
        ("1,234.5", "not expected"),
        ("3 kg", "“kg” is not a unit here"),
        ("3cm*2cm", "plain number"),
        ("1/3cm + 1/(3cm)", "plain numbers"),
        ("1e400", "too large"),
        ("1e300*1e300", "too large"),
        ("(" * 41 + "1" + ")" * 41, "too many brackets"),
        ("1" * 201, "too long"),
        ("__import__('os')", "not a number"),
        ("2**3", "“*” is not a number"),
        ("nan", "not a number"),
        ("inf", "not a number"),
    ],
)
def test_refuses_in_one_clear_line(text, words):
    with pytest.raises(QuantityError) as caught:
        parse_number(text)
    assert words in str(caught.value)
    assert "\n" not in str(caught.value)


def test_a_length_is_no_angle():
    with pytest.raises(QuantityError, match="°"):
        parse_number("3 cm", "deg")


@given(st.text(max_size=60))
def test_any_text_is_a_finite_number_or_an_error(text):
    try:
        value = parse_number(text)
    except QuantityError:
        return
    assert math.isfinite(value)


@given(st.floats(-1e12, 1e12))
def test_a_number_written_in_full_comes_back_unchanged(value):
    assert parse_number(repr(value)) == value


@given(st.floats(-1e6, 1e6), st.floats(-1e6, 1e6), st.floats(0.5, 1e6))
def test_sums_agree_with_arithmetic(a, b, c):
    assert parse_number(f"({a!r} + {b!r}) * 2 / {c!r}") == (a + b) * 2 / c


@given(st.floats(-1e6, 1e6, allow_subnormal=False))
def test_units_there_and_back(value):
    in_mm = parse_number(f"({value!r}) in", "mm")
    assert parse_number(f"({in_mm!r}) mm", "in") == pytest.approx(value, rel=1e-14, abs=1e-300)


@pytest.mark.parametrize(
    ("value", "text"),
    [
        (1.0, "1"),
        (2.5, "2.5"),
        (0.1 + 0.2, "0.3"),
        (-0.0, "0"),
        (1e-5, "1e-05"),
        (120.0, "120"),
        (61.5333333, "61.533"),
        (2e9, "2e+09"),
        (math.inf, "–"),
    ],
)
def test_shows_sensible_digits(value, text):
    assert format_number(value) == text


@pytest.mark.parametrize(
    ("part", "words"),
    [
        (0.0, "+0 %"),
        (-0.00223, "−0.22 %"),
        (0.5, "+50 %"),
        (12.34, "+1234 %"),
        (-1e-7, "−1e-05 %"),
    ],
)
def test_a_signed_percentage_has_a_true_minus(part, words):
    assert signed_percent(part) == words
