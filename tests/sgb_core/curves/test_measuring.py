"""Distances, angles, curvature and lengths read off a profile."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.integrate import quad

import resources
import sgb_core as sgb
from sgb_core.curves.measuring import along, between, on_curve, opening
from sgb_core.document.file import project_file
from tests.sgb_core.design.locks.samples import wavy

NUMBERS = st.floats(-100.0, 100.0)
PLACES = st.tuples(NUMBERS, NUMBERS)


@given(PLACES, PLACES)
def test_between_two_places(start, end):
    found = between(start, end)
    assert found.length == pytest.approx(np.hypot(found.dr, found.dh))
    turned = np.radians(found.angle_deg)
    back = np.add(start, found.length * np.array((np.cos(turned), np.sin(turned))))
    np.testing.assert_allclose(back, end, atol=1e-10)


@given(st.floats(1.0, 179.0), st.floats(0.0, 360.0), PLACES)
def test_an_opening_is_what_it_was_made_of(angle, turned, vertex):
    ways = np.radians((turned, turned + angle))
    one, other = (
        (vertex[0] + 5.0 * np.cos(way), vertex[1] + 3.0 * np.sin(way) * 5.0 / 3.0) for way in ways
    )
    assert opening(one, vertex, other) == pytest.approx(angle, abs=1e-9)
    assert opening(other, vertex, one) == pytest.approx(angle, abs=1e-9)
    assert opening(vertex, vertex, one) is None


def test_a_circle_has_its_own_radius_and_centre():
    # A quarter of a circle by the cubic with the usual legs: within 3e-4 of the radius's size.
    c = 10.0 * 0.5522847498
    quarter = sgb.Profile.of([sgb.Segment([(10, 0), (10, c), (c, 10), (0, 10)])])
    read = on_curve(quarter, 0, 0.5)
    assert read.radius == pytest.approx(10.0, rel=1e-2)
    np.testing.assert_allclose(read.centre, (0.0, 0.0), atol=0.1)
    assert read.angle_deg == pytest.approx(135.0)


@pytest.mark.parametrize("s", [0.0, 0.3, 0.77, 1.0])
def test_the_circle_of_curvature_follows_three_near_points(s):
    profile = wavy(3)
    read = on_curve(profile, 1, s)
    near = profile[1].point(np.clip(s, 2e-4, 1.0 - 2e-4) + np.array((-1e-4, 0.0, 1e-4)))
    a, b, c = (np.linalg.norm(near[i] - near[j]) for i, j in ((0, 1), (1, 2), (0, 2)))
    ab, ac = near[1] - near[0], near[2] - near[0]
    area = abs(ab[0] * ac[1] - ab[1] * ac[0]) / 2.0
    assert read.radius == pytest.approx(a * b * c / (4.0 * area), rel=1e-2)
    assert np.linalg.norm(np.subtract(read.centre, read.place)) == pytest.approx(read.radius)


def test_a_line_has_no_radius_and_a_still_end_no_tangent():
    line = sgb.Profile.of([sgb.line((10, 0), (10, 60))])
    assert on_curve(line, 0, 0.5).radius is None
    still = sgb.Profile.of(
        [sgb.Segment([(0, 0), (5, 0), (9, 5), (9, 9)], sgb.ShapeParameters(4, 3, 1, 1))]
    )
    read = on_curve(still, 0, 0.0)
    assert (read.angle_deg, read.radius, read.centre) == (None, None, None)


def test_the_way_along_the_profile_is_the_integral_of_speed():
    profile = wavy(4)

    def speed(segment):
        return lambda s: float(np.hypot(*profile[segment].derivative(np.array(s))))

    whole = quad(speed(1), 0.3, 1.0)[0] + quad(speed(2), 0.0, 1.0)[0] + quad(speed(3), 0.0, 0.6)[0]
    assert along(profile, (1, 0.3), (3, 0.6)) == pytest.approx(whole, rel=1e-10)
    assert along(profile, (3, 0.6), (1, 0.3)) == pytest.approx(whole, rel=1e-10)
    assert along(profile, (2, 0.5), (2, 0.5)) == pytest.approx(0.0, abs=1e-12)


def test_a_ring_is_gone_round_the_shorter_way_and_a_gap_is_not_crossed():
    ring = project_file.loads(resources.load_preset("ring")).profile
    last = len(ring) - 1
    there = along(ring, (0, 0.1), (last, 0.9))
    whole = sum(sgb.arc_length(each) for each in ring)
    assert there < whole / 2.0
    apart = sgb.Profile.of([sgb.line((10, 0), (10, 5)), sgb.line((12, 5), (12, 9))], ["free"])
    assert along(apart, (0, 0.5), (1, 0.5)) is None
    assert along(apart, (1, 0.0), (1, 0.5)) == pytest.approx(2.0)
