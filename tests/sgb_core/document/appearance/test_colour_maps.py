from dataclasses import replace

import numpy as np
import pytest

from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import Segment, ShapeParameters
from sgb_core.document.appearance.colour_maps import (
    is_diverging,
    limits_of,
    map_values,
    shares_of,
    title_of,
)
from sgb_core.document.appearance.model import ColourMap, MapKind, Scale
from sgb_core.surfaces.revolution import RevolutionSurface
from sgb_core.surfaces.variation import Law

SHAPE = ShapeParameters(2, 4, 1, 0.7)
POINTS = [[(22, 0), (46, 8), (52, 40), (40, 62)], [(40, 62), (28, 84), (14, 88), (16, 108)]]
SURFACE = RevolutionSurface.of_degrees(Profile.of([Segment(each, SHAPE) for each in POINTS]))
LAW = Law("omega", "raised-cosine", 0.2, 0.9)


def values(kind, surface=SURFACE, columns=8, **options):
    return map_values(surface, ColourMap(kind, **options), 12, columns)


def by_fundamental_forms(surface, segment, s, theta):
    """Gaussian and mean curvature from points alone, by fourth-order differences."""
    h = 2e-3
    offsets, first = np.array([-2, -1, 0, 1, 2]), np.array([1, -8, 0, 8, -1]) / 12
    second = np.array([-1, 16, -30, 16, -1]) / 12
    block = np.array(
        [[surface.point(segment, s + a * h, theta + b * h) for b in offsets] for a in offsets]
    )
    xs = np.einsum("a,ax->x", first, block[:, 2]) / h
    xt = np.einsum("b,bx->x", first, block[2]) / h
    xss = np.einsum("a,ax->x", second, block[:, 2]) / h**2
    xtt = np.einsum("b,bx->x", second, block[2]) / h**2
    xst = np.einsum("a,b,abx->x", first, first, block) / h**2
    normal = surface.normal(segment, s, theta)
    e, f, g = xs @ xs, xs @ xt, xt @ xt
    # Positive where the surface bends away from the normal.
    ll, m, n = -(xss @ normal), -(xst @ normal), -(xtt @ normal)
    area = e * g - f * f
    return (ll * n - m * m) / area, (e * n - 2 * f * m + g * ll) / (2 * area)


@pytest.mark.parametrize("surface", [SURFACE, replace(SURFACE, laws=(LAW,))])
def test_curvatures_are_those_of_the_fundamental_forms(surface):
    gaussian, mean = values(MapKind.GAUSSIAN, surface), values(MapKind.MEAN, surface)
    angles = surface.angles(8)
    for segment in (0, 1):
        for row in (3, 6, 9):
            for column in (1, 3) if surface.laws else (0,):
                wanted = by_fundamental_forms(surface, segment, row / 12, angles[column])
                found = [each[13 * segment + row, column] for each in (gaussian, mean)]
                assert found == pytest.approx(wanted, rel=2e-4, abs=1e-7)


def test_a_sphere_is_evenly_curved():
    k = 4 / 3 * (2**0.5 - 1)
    quarter = Segment([(0, 0), (5 * k, 0), (5, 5 - 5 * k), (5, 5)])
    sphere = RevolutionSurface.of_degrees(Profile.of([quarter]))
    for kind, wanted in (
        (MapKind.MERIDIAN, 0.2),
        (MapKind.PARALLEL, 0.2),
        (MapKind.MEAN, 0.2),
        (MapKind.GAUSSIAN, 0.04),
    ):
        assert values(kind, sphere) == pytest.approx(np.full((13, 1), wanted), rel=0.06)


def test_radius_height_and_overhang():
    points = np.array([SURFACE.point(k, np.linspace(0, 1, 13), 0.0) for k in (0, 1)]).reshape(-1, 3)
    assert values(MapKind.RADIUS)[:, 0] == pytest.approx(points[:, 0])
    assert values(MapKind.HEIGHT)[:, 0] == pytest.approx(points[:, 2])
    overhang = values(MapKind.OVERHANG)[:, 0]
    # The belly's foot leans outward, its shoulder faces the sky.
    assert overhang[0] == pytest.approx(90.0 - np.degrees(np.arctan2(8, 24)), abs=1e-6)
    assert overhang[16] < 0.0


def test_influence_is_that_of_its_parameter():
    s, step = 0.5, 1e-6
    segment = SURFACE.profile.segments[1]
    more = segment.with_shape(replace(SHAPE, omega=SHAPE.omega + step))
    wanted = np.hypot(*(more.point(s) - segment.point(s))) / step
    found = values(MapKind.INFLUENCE, segment=1)
    assert found[13 + 6, 0] == pytest.approx(wanted, rel=1e-5)
    assert (found[:13] == 0.0).all()
    assert title_of(ColourMap(MapKind.INFLUENCE), "mm") == "Influence of ω (mm per unit)"


def test_limits_are_the_values_or_what_is_set():
    signed = np.array([-1.0, 0.5, 4.0, np.inf])
    assert limits_of(ColourMap(MapKind.RADIUS), np.array([1.0, 3.0])) == (1.0, 3.0)
    low, high = limits_of(ColourMap(MapKind.MEAN), signed)
    assert low == -high
    assert limits_of(ColourMap(MapKind.MEAN, -2.0, 3.0), signed) == (-2.0, 3.0)
    flat = limits_of(ColourMap(MapKind.RADIUS), np.full(4, 2.0))
    assert flat[0] < 2.0 < flat[1]
    assert is_diverging(ColourMap(MapKind.MEAN), -1.0, 1.0)
    assert not is_diverging(ColourMap(MapKind.MEAN), -0.01, 1.0)
    assert not is_diverging(ColourMap(MapKind.MEAN, scale=Scale.VIRIDIS), -1.0, 1.0)
    assert shares_of(signed, 0.0, 1.0).tolist() == [0.0, 0.5, 1.0, 1.0]
