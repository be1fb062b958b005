"""Frames of segments, their slopes, and what keeps a chain smooth."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest

from sgb_core.design.tracing.chain import Chain, Layout, frames_of, slopes
from sgb_core.design.tracing.conditions import (
    WATCHED,
    KeepsBend,
    KeepsCurvature,
    KeepsVolume,
    KeepsWithin,
    Rows,
)
from sgb_core.design.tracing.guide import guide_of
from sgb_core.design.tracing.prepare import prepare
from sgb_core.design.tracing.profile import profile_of
from sgb_core.design.tracing.start import hermite_start
from sgb_core.design.tracing.symmetry import mirrored
from tests.sgb_core.design.tracing.paths import wavy

READY = prepare(wavy(60), 1.0, None, (), None)
CHAIN, FEET = hermite_start(guide_of(READY.points, 0.0), np.array([0.0, 0.6, 1.1, 1.9]), np.ones(1))


def _unknowns(chain: Chain) -> np.ndarray:
    numbering = chain.layout.numbering()
    return (numbering[:, :, None] == np.arange(int(numbering.max()) + 1)).astype(float)


def test_the_slopes_of_quartic_points_are_those_of_differences() -> None:
    numbering = CHAIN.layout.numbering()
    local = slopes(CHAIN.frames) @ _unknowns(CHAIN)
    for unknown in range(local.shape[2]):
        step = np.zeros(local.shape[2])
        step[unknown] = 1e-6
        ahead = CHAIN.moved(step, numbering).quartics
        behind = CHAIN.moved(-step, numbering).quartics
        difference = (ahead - behind).reshape(len(local), 10) / 2e-6
        np.testing.assert_allclose(local[:, :, unknown], difference, atol=1e-7)


@pytest.mark.parametrize(
    "layout", [Layout(3), Layout(3, closed=True), Layout(3, level=(True, True))]
)
def test_smooth_joints_share_place_and_direction(layout: Layout) -> None:
    numbering = layout.numbering()
    for first, second in pairwise(numbering):
        assert first[8:11].tolist() == second[[2, 0, 1]].tolist()
    used = numbering[numbering >= 0]
    assert set(used.tolist()) == set(range(int(used.max()) + 1))


def test_every_frame_is_an_ordinary_segment() -> None:
    rng = np.random.default_rng(0)
    frames = CHAIN.frames.copy()
    for _ in range(50):
        frames[:, 3:8] = rng.uniform(
            [0.05, 0.05, 0.0, 0.0, 0.05], [0.5, 0.95, 0.4, 0.4, 0.5], (3, 5)
        )
        chain = Chain(CHAIN.layout, frames)
        profile = profile_of(chain, READY)
        np.testing.assert_allclose(
            profile.quartics, READY.restored(chain.quartics), atol=1e-9 * READY.size
        )


def test_a_frame_gives_its_quartic_back() -> None:
    np.testing.assert_allclose(
        Chain(CHAIN.layout, frames_of(CHAIN.quartics)).quartics, CHAIN.quartics, atol=1e-12
    )


def test_a_mirrored_chain_is_the_mirror_image() -> None:
    expected = CHAIN.quartics[::-1, ::-1] * [1.0, -1.0]
    np.testing.assert_allclose(mirrored(CHAIN).quartics, expected, atol=1e-12)


@pytest.mark.parametrize(
    "condition",
    [
        KeepsVolume(np.full(5, 0.2)),
        KeepsBend(-np.ones((3, len(WATCHED))), CHAIN.reach, 0.01, 30.0),
        KeepsCurvature([(0, 1), (1, 2)], 1.0),
        KeepsWithin(0.1, 2.0),
    ],
)
def test_the_slopes_of_conditions_are_those_of_differences(condition: KeepsBend) -> None:
    numbering, choose = CHAIN.layout.numbering(), _unknowns(CHAIN)
    segment = np.array([0, 0, 1, 2, 2])
    by_points = np.random.default_rng(1).normal(size=(5, 10))

    def distances(chain: Chain) -> np.ndarray:
        flat = chain.quartics.reshape(3, 10)
        return np.einsum("ij,ij->i", by_points, flat[segment])

    runs = [np.flatnonzero(segment == k) for k in range(3)]
    rows = Rows(by_points, runs, slopes(CHAIN.frames), numbering)
    values, by_unknowns = condition(CHAIN, distances(CHAIN), rows)
    assert len(values)
    scale = float(np.abs(by_unknowns).max())
    for unknown in range(choose.shape[2]):
        step = np.zeros(choose.shape[2])
        step[unknown] = 1e-6
        ahead, behind = CHAIN.moved(step, numbering), CHAIN.moved(-step, numbering)
        difference = (
            condition(ahead, distances(ahead), None)[0]
            - condition(behind, distances(behind), None)[0]
        ) / 2e-6
        np.testing.assert_allclose(by_unknowns[:, unknown], difference, atol=1e-6 * scale)
