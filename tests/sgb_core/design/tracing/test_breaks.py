"""Where a path is cut, and the quartics near its stretches."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from sgb_core.curves.basis import bernstein
from sgb_core.design.tracing import solver
from sgb_core.design.tracing.breaks import Cuts, near_quartics
from sgb_core.design.tracing.conditions import KeepsVolume
from sgb_core.design.tracing.guide import Guide, guide_of
from sgb_core.design.tracing.search import settled, within
from sgb_core.design.tracing.solver import Cloud, least_squares
from sgb_core.design.tracing.start import hermite_start, quartic_start
from tests.sgb_core.design.tracing.paths import polyline

QUARTIC = np.array([(0.2, 0.0), (0.5, 0.1), (0.6, 0.5), (0.3, 0.8), (0.4, 1.0)])


def _guide(count: int = 2000) -> Guide:
    return guide_of(bernstein(4, np.linspace(0.0, 1.0, count)) @ QUARTIC, 0.0)


def test_any_stretch_of_a_quartic_has_one_near_it() -> None:
    guide = _guide()
    start = np.array([0.0, 0.2, 0.7]) * guide.length
    end = np.array([1.0, 0.9, 0.8]) * guide.length
    found, distances = near_quartics(guide, start, end)
    # The parameter is another one, and only what is across the path counts much.
    assert np.abs(distances).max() < 2e-3
    dense = guide.at(np.linspace(0.0, guide.length, 4001))
    inside = (bernstein(4, np.linspace(0.1, 0.9, 9)) @ found).reshape(-1, 1, 2)
    assert np.hypot(*(inside - dense).transpose(2, 0, 1)).min(axis=1).max() < 2e-3


def test_a_straight_stretch_is_met_exactly() -> None:
    guide = guide_of(np.linspace((0.1, 0.0), (0.4, 0.9), 50), 0.0)
    found, distances = near_quartics(guide, np.zeros(1), np.array([guide.length]))
    assert np.abs(distances).max() < 1e-12
    np.testing.assert_allclose(found[0], np.linspace((0.1, 0.0), (0.4, 0.9), 5), atol=1e-9)


@pytest.mark.parametrize("crowding", [0.5, 0.8])
def test_a_zigzag_is_cut_at_its_corners(crowding: float) -> None:
    corners = [(0.1, 0.0), (0.5, 0.2), (0.1, 0.5), (0.5, 0.9)]
    guide = guide_of(polyline(corners, 900), 0.0)
    cuts = Cuts(guide, 1e-3, crowding)
    lengths = np.append(0.0, np.cumsum(np.hypot(*np.diff(np.array(corners), axis=0).T)))
    # To the nearest place where a cut may be.
    np.testing.assert_allclose(cuts.places(3), lengths, atol=0.04 * guide.length)
    assert 3 <= cuts.enough(1e-3) <= 6


@pytest.mark.parametrize("start", [hermite_start, quartic_start])
@pytest.mark.parametrize("count", [1, 2, 5])
def test_a_first_chain_is_joined_smoothly_between_the_ends(start: object, count: int) -> None:
    guide = _guide()
    assert callable(start)
    chain, feet = start(guide, np.linspace(0.0, guide.length, count + 1), guide.along)
    quartics = chain.quartics
    np.testing.assert_allclose(quartics[0, 0], QUARTIC[0], atol=1e-12)
    np.testing.assert_allclose(quartics[-1, 4], QUARTIC[4], atol=1e-12)
    np.testing.assert_allclose(quartics[1:, 0], quartics[:-1, 4], atol=1e-12)
    before, after = quartics[:-1, 4] - quartics[:-1, 3], quartics[1:, 1] - quartics[1:, 0]
    cross = before[:, 0] * after[:, 1] - before[:, 1] * after[:, 0]
    np.testing.assert_allclose(cross, 0.0, atol=1e-9)
    assert ((before * after).sum(axis=1) > 0.0).all()
    assert feet.segment.max() == count - 1


def test_more_unknowns_than_can_be_sought_together_stay(monkeypatch) -> None:
    level = np.linspace(0.0, 1.0, 101)
    points = np.stack([0.3 + 0.02 * np.sin(9.0 * level), level], axis=1)
    guide = guide_of(points, 0.0)
    chain, feet = hermite_start(guide, np.linspace(0.0, guide.length, 4), guide.along)
    cloud = Cloud(
        points, np.ones(101), guide.along, np.full(101, 1.0 / 101), np.zeros(101), tolerance=0.001
    )
    state = settled(chain, cloud, feet)
    assert least_squares(state, cloud, 5).largest < state.largest
    monkeypatch.setattr(solver, "MOST", 5)
    assert least_squares(state, cloud, 5) is state


def test_the_largest_distance_is_pressed_down_to_the_tolerance() -> None:
    # A bump that one segment cannot follow.
    level = np.linspace(0.0, 1.0, 301)
    points = np.stack([0.3 + 0.02 * np.exp(-(((level - 0.5) / 0.12) ** 2)), level], axis=1)
    guide = guide_of(points, 0.0)
    chain, feet = hermite_start(guide, np.array([0.0, guide.length]), guide.along)
    cloud = Cloud(
        points, np.ones(301), guide.along, np.full(301, 1.0 / 301), np.zeros(301), tolerance=0.01
    )
    keeps = [KeepsVolume(cloud.shares)]
    plain = least_squares(settled(chain, cloud, feet), cloud, 40, keeps)
    # Where least squares leave a quarter more than the tolerance:
    cloud = replace(cloud, tolerance=0.01 * plain.largest / 1.25)
    plain = settled(plain.chain, cloud, plain.feet)
    assert plain.largest == pytest.approx(1.25, rel=1e-3)
    pressed = within(plain, cloud, keeps)
    assert pressed.largest <= 1.0
    assert abs(float(cloud.shares @ pressed.distances)) < 1e-2
