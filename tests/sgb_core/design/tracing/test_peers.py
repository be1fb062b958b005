"""What shape parameters buy: how many segments others need for the same outlines."""

from __future__ import annotations

from functools import cache
from pathlib import Path

import numpy as np
import pytest

from sgb_core.arrays import Floats
from sgb_core.design.tracing import trace
from sgb_core.sources import Options, Side, take
from tests.sgb_core.design.tracing.paths import farthest, wavy
from tests.sgb_core.design.tracing.peers import kurbo_joints, plain_cubics, potrace_joints
from tests.sgb_core.design.tracing.test_vessels import FILES as VESSELS
from tests.sgb_core.design.tracing.test_vessels import TOLERANCE, vessel_points

OUTLINES = Path(__file__).parents[5] / "shared" / "data" / "outlines"
FILES = sorted(OUTLINES.glob("*.jpg"))
PIXEL = 1.0
# On average at most: of a chain of cubics with the same search, and of other programs.
OF_CUBICS, OF_CUBICS_IN_PIXELS, OF_OTHERS = 0.85, 0.9, 0.7

real = pytest.mark.skipif(not FILES, reason="the data are not here")


@cache
def _outlines() -> tuple[tuple[Floats, int], ...]:
    """Return the left sides, and how many segments we need."""
    taken = [take(path, Options(scale=1.0, side=Side.LEFT)) for path in FILES]
    return tuple((found.points, len(found.trace.profile)) for found in taken)


def test_a_chain_of_plain_cubics_is_one() -> None:
    points = wavy(400)
    with plain_cubics():
        found = trace(points, 0.5)
    assert found.largest_deviation <= 0.5
    assert farthest(found.profile, points) == pytest.approx(found.largest_deviation, rel=0.01)
    fourth = np.diff(found.profile.quartics, n=4, axis=1)
    np.testing.assert_allclose(fourth, 0.0, atol=1e-9 * found.profile.size)


@real
def test_cubics_need_more_segments() -> None:
    ratios = []
    for points, ours in _outlines():
        with plain_cubics():
            cubics = trace(points, PIXEL)
        assert cubics.largest_deviation <= PIXEL
        ratios.append(ours / len(cubics.profile))
    # Round a pixel's steps more bends are followed than a vessel has: there less is gained.
    assert np.mean(ratios) <= OF_CUBICS_IN_PIXELS
    for points in map(vessel_points, VESSELS):
        ours = len(trace(points, TOLERANCE).profile)
        with plain_cubics():
            ratios.append(ours / len(trace(points, TOLERANCE).profile))
    assert np.mean(ratios) <= OF_CUBICS


@real
def test_kurbo_needs_more_segments() -> None:
    pytest.importorskip("kurbopy")
    ratios = [ours / (len(kurbo_joints(points, PIXEL)) - 1) for points, ours in _outlines()]
    assert np.mean(ratios) <= OF_OTHERS


@real
def test_potrace_needs_more_segments() -> None:
    pytest.importorskip("potrace")
    ratios = [ours / len(potrace_joints(points, PIXEL)) for points, ours in _outlines()]
    assert np.mean(ratios) <= OF_OTHERS
