import numpy as np
import pytest
from scipy.integrate import quad

from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import Segment, ShapeParameters
from sgb_core.surfaces.revolution import RevolutionSurface
from sgb_core.surfaces.uv import uv_map_of


def vase_surface():
    shape = ShapeParameters(2, 3, 1, 0.5)
    points = [[(22, 0), (46, 8), (52, 40), (40, 62)], [(40, 62), (28, 84), (14, 88), (16, 108)]]
    return RevolutionSurface.of_degrees(Profile.of([Segment(each, shape) for each in points]))


def cylinder(radius, height):
    points = [(radius, height * k / 3) for k in range(4)]
    return RevolutionSurface.of_degrees(Profile.of([Segment(points)]))


def test_v_is_the_arc_length():
    surface = vase_surface()
    uv_map = uv_map_of(surface, 24)
    length = 0.0
    for k, segment in enumerate(surface.profile.segments):
        rows = slice(25 * k, 25 * (k + 1))
        for j in (6, 13, 24):

            def speed(s, segment=segment):
                return float(np.hypot(*segment.derivative(s)))

            until, _ = quad(speed, 0.0, j / 24, epsabs=1e-12)
            assert uv_map.lengths[rows][j] == pytest.approx(length + until, rel=1e-9)
        length = uv_map.lengths[rows][-1]
    assert uv_map.shares[0] == 0.0
    assert uv_map.shares[-1] == 1.0
    assert len(uv_map.borders) == len(surface.profile) + 1


def test_a_cylinder_unrolls_to_its_rectangle():
    uv_map = uv_map_of(cylinder(radius=2.0, height=5.0), 8)
    assert uv_map.length == pytest.approx(5.0)
    assert uv_map.width == pytest.approx(4.0 * np.pi)
    assert np.allclose(uv_map.shares, uv_map.heights)
