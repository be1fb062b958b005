"""The soft light on surfaces and bodies, on their grids and meshes."""

from dataclasses import replace
from math import pi

import numpy as np
import pytest

from sgb_core.bodies.body import body_mesh, section_polygons
from sgb_core.bodies.solid import BodyKind, Solid
from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import Segment
from sgb_core.curves.subdivision import split
from sgb_core.surfaces.ambient_occlusion import FULL, QUICK, body_light, ground_under, surface_light
from sgb_core.surfaces.ambient_occlusion import surface_edges as edges_of
from sgb_core.surfaces.revolution import RevolutionSurface


def bowl(**changes):
    """A bowl with a foot: up its outside to the rim."""
    segments = [
        Segment([(20, 0), (20, 3), (20, 6), (20, 10)]),
        Segment([(20, 10), (45, 12), (60, 30), (62, 50)]),
    ]
    return RevolutionSurface(Profile.of(segments, ["G0"]), **changes)


def light(surface, fineness=FULL, **changes):
    return surface_light(surface, fineness, **{"grounded": False, **changes})


def test_the_inside_is_darker_than_the_outside():
    rows = light(bowl()).on_rows(24, 8)
    assert rows.shape == (50, 9, 2)
    assert 0.0 <= rows.min() <= rows.max() <= 1.0
    outer, inner = rows[25:, 0].T
    assert (inner[2:] < outer[2:]).all()
    assert inner.max() < 0.75
    assert np.ptp(rows, axis=1).max() == 0.0


def test_sides_are_outer_and_inner_however_the_profile_is_drawn():
    surface = bowl()
    turned = replace(surface, profile=surface.profile.reversed())
    assert turned.flips != surface.flips
    one, other = light(surface).on_rows(16, 1), light(turned).on_rows(16, 1)
    assert one == pytest.approx(other[::-1], abs=0.03)
    mirrored = replace(surface, profile=mirror(surface.profile))
    assert light(mirrored).on_rows(16, 1) == pytest.approx(one, abs=1e-9)


def mirror(profile):
    return profile.with_segments(
        Segment(segment.points * (-1.0, 1.0), segment.shape) for segment in profile.segments
    )


def test_what_is_quick_is_nearly_what_is_fine():
    quick, fine = (light(bowl(), each).on_rows(24, 1)[:, 0] for each in (QUICK, FULL))
    assert np.abs(quick - fine).mean() < 0.03


def test_light_is_even_over_a_smooth_joint_and_breaks_at_a_kink():
    # One smooth curve, cut in two.
    whole = Segment([(10, 0), (60, 10), (60, 60), (12, 80)])
    halves = split(whole, 0.5)
    smooth = RevolutionSurface(Profile.of([halves.first, halves.second], ["G1"]))
    rows = light(smooth).on_rows(24, 1)[:, 0]
    assert rows[24] == pytest.approx(rows[25])
    kinked = light(bowl()).on_rows(24, 1)[:, 0]
    assert abs(kinked[24, 0] - kinked[25, 0]) > 0.05


def test_a_wedge_left_away_lets_light_in_where_it_is():
    shut, opened = light(bowl()), light(bowl(), wedge=(-pi / 2.0, 0.0))
    columns = 32
    inner = opened.on_rows(8, columns)[9:, :, 1]
    assert np.all(inner.mean(axis=1) > shut.on_rows(8, columns)[9:, :, 1].mean(axis=1))
    # The same on both sides of the wedge's middle, at -45 degrees, and closed all around.
    assert inner[:, 0] == pytest.approx(inner[:, -1])
    assert inner[:, 12 - 4] == pytest.approx(inner[:, 12 + 4], abs=0.02)


def test_on_the_ground_the_foot_is_dark_and_the_ground_about_it():
    hovering, standing = (light(bowl(), grounded=each) for each in (False, True))
    foot = [each.on_rows(24, 1)[1, 0, 0] for each in (hovering, standing)]
    assert foot[1] < foot[0] - 0.15
    assert hovering.ground is None
    ground = standing.ground
    assert ground.height == 0.0
    outside = ground.distances > 21.0
    shade = ground.brightness[outside, 0]
    assert shade[0] < 0.3
    assert shade[-1] > 0.8
    moved = ground.moved_under(edges_of(bowl(), QUICK))
    assert moved.distances == pytest.approx(ground.distances)


def test_the_ground_of_a_part_turn_is_dark_where_it_stands():
    ground = ground_under(edges_of(bowl(sweep=pi), QUICK), QUICK)
    near = np.abs(ground.distances - 40.0).argmin()
    ways = ground.brightness.shape[1]
    assert ground.brightness[near, ways // 4] < ground.brightness[near, 3 * ways // 4] - 0.3


def test_a_vessel_is_lit_as_the_bowl_that_it_is():
    surface, solid = bowl(), Solid(BodyKind.VESSEL, wall=2.0)
    loops = [
        loop
        for polygon in section_polygons(surface, solid)
        for loop in (polygon.exterior, *polygon.holes)
    ]
    mesh = body_mesh(surface, solid, samples=(24, 24))
    found = body_light(loops, surface, FULL, grounded=False).on_corners(mesh, surface)
    assert found.shape == (len(mesh.normals),)
    assert 0.0 <= found.min() <= found.max() <= 1.0
    places = mesh.positions[mesh.corner_positions]
    radius = np.hypot(places[:, 0], places[:, 1])
    facing = (mesh.normals[:, :2] * places[:, :2]).sum(axis=1) / np.maximum(radius, 1e-9)
    high = (places[:, 2] > 20.0) & (places[:, 2] < 45.0)
    outer, inner = found[high & (facing > 0.3)], found[high & (facing < -0.3)]
    assert outer.min() > inner.max()
    # All around alike, as the form is.
    level = np.round(places[:, 2], 6) == np.round(places[high][0, 2], 6)
    same = level & (np.abs(facing - facing[high][0]) < 1e-6)
    assert np.ptp(found[same]) < 1e-6
