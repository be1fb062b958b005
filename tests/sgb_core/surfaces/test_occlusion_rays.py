"""How much sky is seen, against formulas of radiation exchange."""

from dataclasses import replace
from math import pi

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from sgb_core.surfaces.occlusion_rays import Edges, Floor, ambient_occlusion

RAYS = (12, 24)


def chain(points, sweep=2.0 * pi):
    points = np.asarray(points, dtype=float)
    return Edges(points[:-1], points[1:], sweep)


def arc(low, high, count=48, radius=3.0, lift=0.0):
    """A meridian of a sphere between two latitudes, its outer side to the right."""
    angle = np.linspace(low, high, count + 1)
    return np.stack([radius * np.cos(angle), lift + radius * np.sin(angle)], axis=-1)


def test_from_a_convex_form_all_of_the_sky_is_seen():
    ball = chain(arc(-pi / 2, pi / 2))
    assert ambient_occlusion(ball, ball.middles, ball.normals, RAYS).min() == 1.0


def test_inside_a_closed_form_there_is_none():
    ball = chain(arc(-pi / 2, pi / 2))
    assert ambient_occlusion(ball, ball.middles, -ball.normals, RAYS).max() < 0.01


@given(st.floats(-1.2, 1.2))
@settings(max_examples=20, deadline=None)
def test_inside_a_sphere_each_point_sees_the_same_share_of_what_is_cut_off(latitude):
    # From any point of a sphere a part of it is seen with its share of the whole area.
    bowl = chain(arc(-pi / 2, latitude))
    found = ambient_occlusion(bowl, bowl.middles, -bowl.normals, RAYS)
    assert found == pytest.approx((1.0 - np.sin(latitude)) / 2.0, abs=0.035)
    assert found.mean() == pytest.approx((1.0 - np.sin(latitude)) / 2.0, abs=0.02)


@given(st.floats(0.3, 4.0), st.floats(0.3, 4.0))
@settings(max_examples=20, deadline=None)
def test_from_the_bottom_of_a_well_its_mouth_is_a_disc(radius, depth):
    well = chain([(0, 0), (radius, 0), (radius, depth)])
    found = ambient_occlusion(well, np.zeros((1, 2)), np.array([[0.0, 1.0]]), (8, 96))
    assert found[0, 0] == pytest.approx(radius**2 / (radius**2 + depth**2), abs=0.012)


def test_a_ball_on_the_ground_shades_it_by_the_cube_of_its_distance():
    ball = chain(arc(-pi / 2, pi / 2, radius=3.0, lift=3.0))
    distance = np.array([0.5, 2.0, 4.0, 9.0])
    places = np.stack([distance, np.zeros(4)], axis=-1)
    found = ambient_occlusion(ball, places, np.tile([0.0, 1.0], (4, 1)), (16, 32))[:, 0]
    assert 1.0 - found == pytest.approx((3.0 / np.hypot(distance, 3.0)) ** 3, abs=0.01)


def test_half_a_bowl_lets_in_what_its_other_half_kept_out():
    # A quarter of the sphere is there, so three quarters of it are sky.
    bowl = chain(arc(-pi / 2, 0.0), sweep=pi)
    found = ambient_occlusion(bowl, bowl.middles, -bowl.normals, RAYS, np.linspace(0.0, pi, 5))
    assert found == pytest.approx(0.75, abs=0.03)
    whole = replace(bowl, sweep=2.0 * pi)
    assert ambient_occlusion(whole, bowl.middles, -bowl.normals, RAYS) == pytest.approx(
        0.5, abs=0.03
    )


def test_an_almost_full_turn_is_seen_as_a_full_one():
    bowl = chain(arc(-pi / 2, 0.4))
    nearly = replace(bowl, sweep=2.0 * pi - 1e-6)
    one = ambient_occlusion(bowl, bowl.middles, -bowl.normals, RAYS)
    other = ambient_occlusion(nearly, bowl.middles, -bowl.normals, RAYS, np.array([1.0]))
    # Each ray stands for its mirror image where all sides are alike.
    assert np.abs(one - other).max() < 0.002


def test_a_profile_on_the_other_side_of_the_axis_stops_as_much():
    bowl = chain(arc(-pi / 2, 0.4))
    mirrored = Edges(bowl.starts * (-1.0, 1.0), bowl.ends * (-1.0, 1.0), pi)
    there = Edges(bowl.starts, bowl.ends, pi)
    one = ambient_occlusion(there, bowl.middles, -bowl.normals, RAYS, np.array([0.7]))
    # What is turned by θ on the other side stands at θ + π.
    other = ambient_occlusion(mirrored, bowl.middles, -bowl.normals, RAYS, np.array([0.7 + pi]))
    assert np.abs(one - other).max() < 1e-12


def test_dark_ground_takes_the_light_from_below():
    wall = chain([(2, 0), (2, 6)])
    upright = wall.normals
    bright = ambient_occlusion(wall, wall.middles, upright, RAYS)
    black = Floor(0.0, np.array([0.0, 1e9]), np.zeros(2))
    dark = ambient_occlusion(wall, wall.middles, upright, RAYS, None, black)
    assert bright[0, 0] == 1.0
    assert dark[0, 0] == pytest.approx(0.5, abs=0.03)
    white = replace(black, brightness=np.ones(2))
    assert ambient_occlusion(wall, wall.middles, upright, RAYS, None, white)[0, 0] == 1.0
