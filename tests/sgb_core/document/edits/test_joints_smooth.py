"""All joints made smooth at once: each as its rule says, or left as it was and named."""

from __future__ import annotations

from itertools import pairwise

import pytest
from hypothesis import given
from hypothesis import strategies as st

from sgb_core.curves.primitives import line
from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import READY, Segment
from sgb_core.document import edits
from sgb_core.document.model import Document

radius = st.floats(20.0, 60.0)


@pytest.mark.parametrize("rule", ["G1", "G2"])
@given(st.lists(radius, min_size=5, max_size=5))
def test_joints_are_as_smooth_as_is_said(rule, radii) -> None:
    ends = [(r, 40.0 * k) for k, r in enumerate(radii[:4])]
    segments = [
        Segment([a, (a[0] + 8.0, a[1] + 12.0), (radii[4], b[1] - 9.0), b], READY)
        for a, b in pairwise(ends)
    ]
    document = Document(Profile.of(segments))
    smoothed, left = edits.smooth_joints(document, rule)
    order = ("gap", "G0", "G1", "C1", "G2")
    for report in smoothed.joints:
        smooth = order.index(report.measured.value) >= order.index(rule)
        assert smooth is (report.joint not in left)
        assert report.holds
    if rule == "G1":
        assert left == ()


def test_what_is_smoother_already_stays() -> None:
    straight = [line((20, 0), (20, 30)), line((20, 30), (20, 60))]
    document = Document(Profile.of(straight, ["C1"]))
    assert edits.smooth_joints(document, "G1") == (document, ())
