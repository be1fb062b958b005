"""How marks give way to the shape where segments crowd."""

from itertools import pairwise

import numpy as np
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from app.hand.coordinates import ScreenPoint, Transform
from app.hand.density import CLEAR, presence, segment_presence, shown_points
from app.hand.hit_test import Target, pick
from sgb_core.curves.primitives import line
from sgb_core.curves.profile import Profile

places = arrays(float, (5, 4, 2), elements=st.floats(0.0, 400.0))


@given(st.lists(st.floats(0.0, 500.0), min_size=2, max_size=20))
def test_more_room_never_shows_less(rooms):
    found = presence(np.sort(rooms))
    assert (np.diff(found) >= 0.0).all()
    assert ((found == 0.0) == (np.sort(rooms) < CLEAR)).all()
    assert found.max() <= 1.0


@given(places, st.sets(st.integers(0, 7)))
def test_lit_segments_are_shown_in_full_and_lighting_one_changes_no_other(points, lit):
    with_light, without = segment_presence(points, lit), segment_presence(points, ())
    for k in range(5):
        assert with_light[k] == (1.0 if k in lit else without[k])
    shown = shown_points(points, lit)
    assert shown[[k for k in lit if k < 5]].all()


def test_of_a_crowd_only_the_curve_can_be_grabbed_but_for_the_selected_segment():
    heights = np.linspace(0.0, 100.0, 41)
    rods = [line((20.0, a), (20.0, b)) for a, b in pairwise(heights)]
    profile, paper = Profile.of(rods), Transform(3.0, 100.0, 400.0)

    def grabbed(point, selected):
        at = ScreenPoint(*paper.map(point).tolist())
        return pick(profile, paper, at, selected=selected, quartics=True)

    inner = profile.segments[20].points[1]
    assert grabbed(inner, 3).target is Target.CURVE
    assert grabbed(inner, 20).target is Target.POINT
