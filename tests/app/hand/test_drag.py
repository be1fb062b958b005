import math

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from app.hand.coordinates import DesignPoint, GridSteps
from app.hand.drag import leg_ends, slide_fraction
from sgb_core.curves.segment import Segment

coordinates = st.floats(-100.0, 100.0)
points = st.builds(DesignPoint, coordinates, coordinates)
GRID = GridSteps(10.0, 2.0)


@given(st.lists(points, min_size=4, max_size=4), st.sampled_from([0, 1, 2]), points)
def test_a_quartic_point_slides_to_the_place_on_its_leg_nearest_to_the_cursor(
    places, which, cursor
):
    segment = Segment(np.array([place.pair for place in places]))
    fraction = slide_fraction(segment, which, cursor)
    near, far = leg_ends(segment, which)

    def distance(t):
        r, h = near.r + t * (far.r - near.r), near.h + t * (far.h - near.h)
        return math.hypot(r - cursor.r, h - cursor.h)

    assert 0.0 <= fraction <= 1.0
    if math.hypot(far.r - near.r, far.h - near.h) > 1e-6:
        best = min(distance(t) for t in np.linspace(0.0, 1.0, 201))
        assert distance(fraction) <= best + 1e-6


def test_leg_ends_are_where_the_fraction_is_zero_and_one():
    segment = Segment(np.array([(0.0, 0), (1, 1), (2, 1), (3, 0)]))
    for which in range(3):
        a = segment.shape.leg_fractions[which]
        near, far = leg_ends(segment, which)
        expected = np.array(near.pair) + a * (np.array(far.pair) - near.pair)
        assert np.allclose(segment.quartic[which + 1], expected)
