"""Profiles of real vessels, digitised by hand, with noise below the tolerance."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from sgb_core.arrays import Floats
from sgb_core.curves.continuity import JointClass
from sgb_core.design.tracing import trace
from sgb_core.design.tracing.ordering import ordered
from tests.sgb_core.design.tracing.paths import farthest, frusta, sign_changes, volume

VESSELS = Path(__file__).parents[5] / "shared" / "data" / "vessels"
FILES = sorted(VESSELS.glob("*-points.csv"))
TOLERANCE = 0.2

pytestmark = pytest.mark.skipif(not FILES, reason="the data are not here")


def vessel_points(path: Path) -> Floats:
    lines = path.read_text(encoding="utf-8").replace(",", ".").split()
    points = np.array([[float(word) for word in line.split(";")] for line in _pairs(lines)])
    return points[ordered(points)]


def _pairs(words: list[str]) -> list[str]:
    # "r; h": the separator ends the first word of each pair.
    return [first + second for first, second in zip(words[::2], words[1::2], strict=True)]


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem[:3])
def test_a_vessel_is_a_few_smooth_segments(path: Path) -> None:
    points = vessel_points(path)
    found = trace(points, TOLERANCE)
    kept = np.delete(points, found.outliers, axis=0)
    assert len(found.profile) <= 4
    assert found.largest_deviation <= TOLERANCE
    assert farthest(found.profile, kept) == pytest.approx(found.largest_deviation, rel=0.02)
    assert {joint.measured for joint in found.joints} <= {
        JointClass.G1,
        JointClass.C1,
        JointClass.G2,
    }
    assert sign_changes(found.profile) <= 1
    assert volume(found.profile) == pytest.approx(frusta(kept), rel=3e-3)
