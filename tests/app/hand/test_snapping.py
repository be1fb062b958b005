import math

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from app.hand.coordinates import DesignPoint, GridSteps
from app.hand.snapping import DragKeys, Snapping, land, leg_directions
from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import Segment

coordinates = st.floats(-100.0, 100.0)
points = st.builds(DesignPoint, coordinates, coordinates)
GRID = GridSteps(10.0, 2.0)


@given(points, points)
def test_without_grid_a_point_lands_under_the_cursor_or_on_the_axis(start, cursor):
    landing = land(start, cursor, DragKeys(), Snapping(None, 0.5))
    assert landing.point.h == cursor.h
    assert landing.point.r == (0.0 if landing.on_axis else cursor.r)
    assert landing.on_axis == (abs(cursor.r) <= 0.5)


@given(points, points)
def test_ctrl_lands_exactly_under_the_cursor(start, cursor):
    assert land(start, cursor, DragKeys(free=True), Snapping(GRID, 0.5)).point == cursor


@given(points, points)
def test_on_the_grid_both_coordinates_are_whole_steps_and_near(start, cursor):
    landing = land(start, cursor, DragKeys(), Snapping(GRID, 0.5))
    assert landing.point.r % 2.0 == landing.point.h % 2.0 == 0.0
    assert abs(landing.point.r - cursor.r) <= 1.0 + 1e-9
    assert abs(landing.point.h - cursor.h) <= 1.0 + 1e-9


@given(points, points, st.floats(0.0, 2.0 * math.pi))
def test_shift_stays_on_a_line_through_the_start_and_gets_no_farther_than_the_hand(
    start, cursor, angle
):
    leg = (math.cos(angle), math.sin(angle))
    landing = land(start, cursor, DragKeys(free=True, constrain=True), Snapping(None, 0.5), [leg])
    assert landing.guide in ((1.0, 0.0), (0.0, 1.0), leg)
    dr, dh = landing.point.r - start.r, landing.point.h - start.h
    assert abs(dr * landing.guide[1] - dh * landing.guide[0]) < 1e-9
    assert math.hypot(dr, dh) <= math.hypot(cursor.r - start.r, cursor.h - start.h) + 1e-9


def test_shift_along_a_leg_meets_the_axis_on_the_leg():
    leg = (math.sqrt(0.5), math.sqrt(0.5))
    landing = land(
        DesignPoint(10.0, 10.0),
        DesignPoint(0.3, 0.1),
        DragKeys(constrain=True),
        Snapping(GRID, 1),
        [leg],
    )
    assert landing.on_axis
    assert abs(landing.point.r) == 0.0
    assert math.isclose(landing.point.h, 0.0, abs_tol=1e-12)


def test_a_leg_of_no_length_has_no_direction():
    segment = Segment(np.array([(0.0, 0), (0, 0), (2, 1), (3, 0)]))
    assert leg_directions(Profile.of([segment]), (0, 0)) == []
