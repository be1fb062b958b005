from dataclasses import replace

import numpy as np
import pytest

from sgb_core.bodies.solid import BodyKind, Solid, WallSide
from sgb_core.bodies.wall_depth import wall_depths
from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import Segment, ShapeParameters
from sgb_core.document.appearance.colour_maps import limits_of, map_values
from sgb_core.document.appearance.model import ColourMap, MapKind
from sgb_core.surfaces.revolution import RevolutionSurface
from sgb_core.surfaces.variation import Law

PLAIN = ShapeParameters(1, 3, 1, 0)
S = np.linspace(0.0, 1.0, 33)
VASE = RevolutionSurface.of_degrees(
    Profile.of(
        [
            Segment([(22, 0), (46, 8), (52, 40), (40, 62)]),
            Segment([(40, 62), (28, 84), (14, 88), (16, 108)]),
        ]
    )
)


def tube(radius=20.0):
    points = [(radius, 0), (radius, 20), (radius, 40), (radius, 60)]
    return RevolutionSurface.of_degrees(Profile.of([Segment(points, PLAIN)]))


@pytest.mark.parametrize("side", list(WallSide))
@pytest.mark.parametrize("radius", [20.0, -20.0])
def test_a_straight_wall_is_as_thick_as_asked_for_above_its_floor(side, radius):
    vessel = Solid(BodyKind.VESSEL, wall=2.5, side=side, base=4.0)
    depths = wall_depths(tube(radius), vessel, S, 8)[:, 0]
    above = S * 60.0 > 4.1
    np.testing.assert_allclose(depths[above], 2.5, atol=1e-6)


def test_through_the_floor_and_through_a_filled_body_it_is_the_whole_way():
    vessel = Solid(BodyKind.VESSEL, wall=2.5, base=4.0)
    assert wall_depths(tube(), vessel, S, 8)[1, 0] == pytest.approx(40.0)
    filled = wall_depths(tube(), Solid(BodyKind.FILLED), S, 8)
    np.testing.assert_allclose(filled, 40.0, atol=1e-6)


def test_a_bare_surface_has_no_wall():
    assert np.isnan(wall_depths(VASE, Solid(), S, 8)).all()
    shown = ColourMap(MapKind.THICKNESS)
    assert limits_of(shown, map_values(VASE, shown, 12, 8)) == (0.0, 1.0)


def test_a_curved_wall_keeps_its_thickness_between_floor_and_rim():
    vessel = Solid(BodyKind.VESSEL, wall=3.0, base=3.0)
    depths = wall_depths(VASE, vessel, S, 8).reshape(2, -1)
    np.testing.assert_allclose(depths[0, 8:], 3.0)
    np.testing.assert_allclose(depths[1, :-6], 3.0)
    shown = ColourMap(MapKind.THICKNESS)
    values = map_values(VASE, shown, 32, 8, vessel)
    assert values.shape == (66, 1)
    assert limits_of(shown, values)[0] == 0.0


def test_where_laws_hold_each_angle_has_its_own():
    law = Law("omega", "raised-cosine", 0.2, 0.9)
    varying = replace(VASE, laws=(law,))
    vessel = Solid(BodyKind.VESSEL, wall=3.0, base=3.0)
    depths = wall_depths(varying, vessel, S, 12)
    assert depths.shape == (66, 13)
    for column, angle in ((0, 0.0), (6, np.pi)):
        held = RevolutionSurface(varying.profile_at(varying.start + angle))
        np.testing.assert_allclose(
            depths[:, column], wall_depths(held, vessel, S, 12)[:, 0], atol=1e-6, equal_nan=True
        )


def test_a_wall_that_does_not_fit_has_no_map():
    vessel = Solid(BodyKind.VESSEL, wall=500.0, base=3.0)
    shown = ColourMap(MapKind.THICKNESS)
    assert np.isnan(map_values(VASE, shown, 12, 8, vessel)).all()
