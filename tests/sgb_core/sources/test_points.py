"""Tables of points, as programs and people write them."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from sgb_core.findings.finding import Finding
from sgb_core.findings.refusal import Argument
from sgb_core.findings.sources import NoNumbers, NoSource, TooMuch
from sgb_core.sources import Options, Side, SourceError
from sgb_core.sources.points import parse_points
from tests.sgb_core.sources.files import apart, taken

POINTS = [[0.5, -1.0], [1.25, 0.0], [2.0, 1000.0]]


@pytest.mark.parametrize(
    "text",
    [
        "0.5,-1\n1.25,0\n2,1000\n",
        "r,h\n0.5,-1.0\n1.25,0\n2,1e3\n",
        "# a comment\n\n0,5;-1\n1,25;0\n2;1000",
        "Radius\tHeight\r\n0,5\t-1\r\n1,25\t0\r\n2\t1,0E3\r\n",
        "0,5 -1\n1,25 0\n2 1000\n",
        '"0.5","\u22121"\n"1.25","0"\n"2","1000"\n',
        "segment,s,r,h\n0,0,0.5,-1\n0,0.5,1.25,0\n0,1,2,1000\n",
        "0.5,-1\n0.5,-1\n1.25,0\n2,1000\n2,1000\n",
    ],
    ids=["plain", "header", "semicolons", "tabs", "blanks", "quoted", "columns", "doubled"],
)
@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig", "utf-16"])
def test_a_table_is_read_however_it_is_written(text: str, encoding: str) -> None:
    np.testing.assert_array_equal(parse_points(text.encode(encoding)), POINTS)


@pytest.mark.parametrize(
    ("text", "finding"),
    [
        ("It was the best of times,\nit was the worst of times.\n" * 30, NoSource.NO_COLUMNS),
        ("1,2\n3,4\nfive,six\n", NoNumbers(3, "five,six")),
        ("1,1e400\n2,3\n", NoSource.NOT_FINITE),
        ("1e308,1\n-1e308,2\n1e308,5\n", NoSource.NOT_FINITE),
        ("1,2\n3,4\n" * 50_001, TooMuch("points", 100_000)),
        ("1,2\n1,2\n", NoSource.ONE_PLACE),
        ("", NoSource.EMPTY),
    ],
)
def test_what_is_no_table_is_refused_with_the_line_at_fault(
    tmp_path: Path, text: str, finding: Finding
) -> None:
    with pytest.raises(SourceError) as error:
        taken(tmp_path, "points.csv", text)
    assert error.value.finding == finding


def test_points_without_an_order_are_ordered_by_height(tmp_path: Path) -> None:
    h = np.linspace(0.0, 100.0, 60)
    points = np.stack([30.0 + 10.0 * np.sin(h / 20.0), h], axis=1)
    shuffled = np.random.default_rng(4).permutation(points)
    text = "\n".join(f"{r:.17g};{z:.17g}".replace(".", ",") for r, z in shuffled)
    found = taken(tmp_path, "points.txt", text, Options(tolerance=0.5))
    assert apart(found.trace.profile, points) * found.trace.profile.size <= 0.5
    np.testing.assert_allclose(found.trace.profile.segments[0].points[0], points[0])
    assert len(found.trace.profile) <= 3


def test_the_sides_of_an_axis_are_told_apart_and_their_difference_is_said(tmp_path: Path) -> None:
    h = np.linspace(0.0, 50.0, 40)
    right = np.stack([100.0 + 20.0 + h / 5.0, h], axis=1)
    left = np.stack([100.0 - 22.0 - h / 5.0, h], axis=1)
    text = "\n".join(f"{x!r},{y!r}" for x, y in np.concatenate([right, left]).tolist())
    both = taken(tmp_path, "points.csv", text, Options(axis=100.0))
    assert both.left_right == pytest.approx(2.0)
    assert both.axis == (100.0,)
    np.testing.assert_allclose(both.trace.profile.segments[0].points[[0, 3]], [[21, 0], [31, 50]])
    one = taken(tmp_path, "points.csv", text, Options(axis=100.0, side=Side.LEFT))
    assert one.left_right is None
    np.testing.assert_allclose(one.trace.profile.segments[0].points[[0, 3]], [[22, 0], [32, 50]])


def test_a_letter_is_no_axis_of_points(tmp_path: Path) -> None:
    with pytest.raises(SourceError, match="axis is 'z'; allowed is auto") as error:
        taken(tmp_path, "points.csv", "1,2\n3,4\n", Options(axis="z"))
    assert isinstance(error.value.finding, Argument)
