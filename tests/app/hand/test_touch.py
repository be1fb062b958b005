"""Two fingers as a pan and a pinch."""

import math

from hypothesis import assume, given
from hypothesis import strategies as st

from app.hand.coordinates import DesignPoint, ScreenPoint, Transform
from app.hand.touch import LEAST_SPREAD, Pinch

place = st.builds(ScreenPoint, st.floats(0.0, 800.0), st.floats(0.0, 800.0))


@given(place, place, place, place)
def test_paper_follows_both_fingers_but_for_their_turning(a, b, c, d):
    before, after = Pinch.of(a, b), Pinch.of(c, d)
    assume(min(before.spread, after.spread) > 2.0 * LEAST_SPREAD)
    step = before.step(after)
    paper = Transform(2.0, 100.0, 300.0)
    moved = paper.panned(step.dx, step.dy).zoomed(step.factor, step.at)
    # What was between the fingers still is, and their distance on the paper is what it was.
    middle = moved.to_design(after.centre)
    assert math.dist(middle.pair, paper.to_design(before.centre).pair) < 1e-6
    wide = paper.to_design(a), paper.to_design(b)
    apart = math.dist(wide[0].pair, wide[1].pair) * moved.scale
    assert math.isclose(apart, after.spread, rel_tol=1e-9)
    assert isinstance(middle, DesignPoint)


@given(place, place, st.floats(0.0, LEAST_SPREAD * 0.99))
def test_fingers_that_touch_do_not_zoom(a, b, spread):
    together = Pinch(a, spread)
    assert Pinch.of(a, b).step(together).factor == 1.0
    assert together.step(Pinch.of(a, b)).factor == 1.0
