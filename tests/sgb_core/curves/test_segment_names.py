"""What a potter calls the segments of a profile."""

import numpy as np

from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import Segment
from sgb_core.curves.segment_names import segment_names
from tests.app.helpers import tower

BULGE = np.array([(10.0, 0.0), (30.0, 5.0), (30.0, 35.0), (10.0, 40.0)])


def _halves(points):
    middle = (points[0] + points[3]) / 2
    return np.linspace(points[0], middle, 4), np.linspace(middle, points[3], 4)


def test_segments_get_a_potters_names():
    assert segment_names(tower().profile) == ("lip", "belly", "foot")
    assert segment_names(Profile.of([Segment(BULGE)])) == ("",)
    corners = [(0, 0), (20, 0), (30, 30), (25, 50), (8, 70), (12, 100)]
    lines = [np.linspace(corners[k], corners[k + 1], 4) for k in range(5)]
    vase = Profile.of([Segment(points) for points in lines])
    assert segment_names(vase) == ("floor", "foot", "belly", "neck", "lip")
    tall = Profile.of([Segment(p) for p in (*lines[:3], *_halves(lines[3]), lines[4])])
    names = ("floor", "foot", "belly", "shoulder", "neck", "lip")
    assert segment_names(tall) == names
    closed = Profile.of([Segment(BULGE), Segment(BULGE[::-1])], closed=True)
    assert segment_names(closed) == ("", "")
