"""The figure of curvature: on its page, nothing over words, curves where their values are."""

from __future__ import annotations

import numpy as np
import pytest

import resources
from sgb_core.drawings.curvature_figure import curvature_figure
from sgb_core.drawings.errors import DrawingError
from sgb_core.drawings.graph import Graph, spread, ticks
from sgb_core.drawings.page import Layer, Pen, Stroke, Words
from tests.sgb_core.drawings.looking import outside, overlaps
from tests.sgb_core.drawings.shapes import BENT, OTHERS, chain, preset

NAMES = [found.name for found in resources.presets()]


@pytest.mark.parametrize("name", NAMES)
def test_presets_fit(name: str) -> None:
    (page,) = curvature_figure(preset(name)).pages
    assert (overlaps(page), outside(page)) == ([], [])


@pytest.mark.parametrize("name", OTHERS)
def test_odd_shapes_fit(name: str) -> None:
    (page,) = curvature_figure(OTHERS[name]).pages
    assert (overlaps(page), outside(page)) == ([], [])


def test_a_point_has_no_graph() -> None:
    with pytest.raises(DrawingError, match="single point"):
        curvature_figure(chain((5, 5), (5, 5)))


def test_curves_run_through_their_values() -> None:
    graph = Graph(10.0, 20.0, 100.0, 50.0, (0.0, 4.0), (-1.0, 1.0))
    x = np.linspace(0.0, 4.0, 41)
    (stroke,) = graph.curve(np.stack([x, np.sin(x)], axis=1), Pen())
    assert isinstance(stroke, Stroke)
    (path,) = stroke.paths
    places = path.flat()
    assert places[:, 0] == pytest.approx(10.0 + 25.0 * x)
    assert places[:, 1] == pytest.approx(45.0 + 25.0 * np.sin(x))


def test_what_leaves_the_graph_is_cut() -> None:
    graph = Graph(0.0, 0.0, 10.0, 10.0, (0.0, 10.0), (0.0, 1.0))
    values = np.array([0.5, 0.6, np.nan, 0.5, 0.5, 7.0, 0.1, 0.2])
    (stroke,) = graph.curve(np.stack([np.arange(8.0), values], axis=1), Pen())
    assert [len(path.pieces) for path in stroke.paths] == [1, 1, 1]


@pytest.mark.parametrize(("low", "high"), [(0.0, 365.2), (-0.095, 0.04), (1e-9, 3e-9), (0, 9e8)])
def test_ticks_are_round_and_inside(low: float, high: float) -> None:
    found = ticks(low, high, 100.0)
    values = [value for value, _ in found]
    assert 2 <= len(values) <= 12
    assert all(low - 1e-9 * high <= value <= high * (1 + 1e-9) for value in values)
    assert len({words for _, words in found}) == len(found)


def test_a_range_holds_its_values() -> None:
    low, high = spread([np.array([1.0, 2.0, np.nan]), np.array([-1.0])])
    assert low < -1.0 < 2.0 < high
    assert spread([np.array([np.nan])]) == (-1.0, 1.0)


def test_each_segment_has_a_curve_in_both_graphs() -> None:
    (page,) = curvature_figure(BENT).pages
    assert len(page.of_layer(Layer.OUTLINE)) >= 4


def test_segments_are_counted_from_one_above_the_upper_graph() -> None:
    (page,) = curvature_figure(preset("vase")).pages
    words = [mark for mark in page.marks if isinstance(mark, Words)]
    top = max(mark.at[1] for mark in words)
    numbers = [mark.text for mark in sorted(words, key=lambda each: each.at) if mark.at[1] == top]
    assert numbers == [str(k + 1) for k in range(len(preset("vase").profile))]
