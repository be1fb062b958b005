import io

import numpy as np
import pytest

from sgb_core.curves import basis
from sgb_core.exchange.csv_profile import HEADER, csv_lines, write_csv
from tests.sgb_core.exchange.shapes import spindle


def test_header_order_and_ends():
    lines = csv_lines(spindle().profile, 3)
    assert lines[0] == HEADER == "segment,s,r,h"
    assert lines[1] == "0,0.0,0.0,0.0"
    assert [line.split(",")[:2] for line in lines[1:]] == [
        [segment, s] for segment in "01" for s in ("0.0", "0.5", "1.0")
    ]
    assert lines[-1] == "1,1.0,0.0,60.0"


def test_points_are_those_of_the_basis_in_full_precision():
    profile = spindle().profile
    rows = np.array([line.split(",") for line in csv_lines(profile, 33)[1:]], dtype=float)
    assert len(rows) == 2 * 33
    for index, segment in enumerate(profile.segments):
        own = rows[rows[:, 0] == index]
        shape = segment.shape
        a, b, c = shape.leg_fractions
        q = basis.quartic_points(segment.points, (a, b, c))
        s = own[:, 1:2]
        weights = [1, 4, 6, 4, 1]
        expected = sum(w * s**k * (1 - s) ** (4 - k) * q[k] for k, w in enumerate(weights))
        assert np.abs(own[:, 2:] - expected).max() < 1e-12 * 60


def test_a_number_for_each_segment():
    lines = csv_lines(spindle().profile, [2, 5])
    assert [line[0] for line in lines[1:]] == ["0"] * 2 + ["1"] * 5


@pytest.mark.parametrize("points", [0, 1, -3, 10**9])
def test_numbers_that_are_refused(points):
    with pytest.raises(ValueError, match="allowed"):
        csv_lines(spindle().profile, points)


def test_the_file_ends_with_a_line_break():
    stream = io.BytesIO()
    write_csv(spindle().profile, stream, 2)
    assert stream.getvalue().count(b"\n") == 5
    assert stream.getvalue().endswith(b"60.0\n")
