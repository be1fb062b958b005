"""Filled outlines of real pots: few segments on either side, and deviations that are true."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from scipy.spatial import cKDTree

from sgb_core.arrays import Floats
from sgb_core.curves.continuity import JointClass
from sgb_core.curves.profile import Profile
from sgb_core.sources import Options, Side, take

OUTLINES = Path(__file__).parents[4] / "shared" / "data" / "outlines"
FILES = sorted(OUTLINES.glob("*.jpg"))
PIXEL = 1.0
# At one pixel, with true corners, and smooth throughout.
MOST_SHARP, MOST_SMOOTH = 8, 10

pytestmark = pytest.mark.skipif(not FILES, reason="the data are not here")


def _distances(profile: Profile, points: Floats) -> Floats:
    """Return the distances of points from a polyline of 8000 chords along each segment."""
    chain = profile.sample(8001).reshape(-1, 2)
    nearest = cKDTree(chain).query(points)[1]
    found = np.full(len(points), np.inf)
    for first in (np.maximum(nearest - 1, 0), np.minimum(nearest, len(chain) - 2)):
        chord, off = chain[first + 1] - chain[first], points - chain[first]
        square = np.maximum((chord**2).sum(axis=1), 1e-300)
        part = np.clip((off * chord).sum(axis=1) / square, 0.0, 1.0)
        found = np.minimum(found, np.hypot(*(off - part[:, None] * chord).T))
    return found


@pytest.mark.parametrize("side", [Side.LEFT, Side.RIGHT])
@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_a_side_is_few_segments_and_as_near_as_it_says(path: Path, side: Side) -> None:
    taken = take(path, Options(scale=1.0, side=side))
    found = taken.trace
    kinds = {joint.measured for joint in found.joints}
    assert JointClass.GAP not in kinds
    assert len(found.profile) <= (MOST_SHARP if JointClass.G0 in kinds else MOST_SMOOTH)
    assert found.largest_deviation <= PIXEL
    off = _distances(found.profile, np.delete(taken.points, found.outliers, axis=0))
    assert off.max() == pytest.approx(found.largest_deviation, rel=0.02)
    assert np.sqrt((off**2).mean()) == pytest.approx(found.rms_deviation, rel=0.02)
    assert len(taken.points) > 1000
    assert len(found.outliers) == 0
