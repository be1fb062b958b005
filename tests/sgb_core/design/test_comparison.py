"""Other curves on one polygon: against closed forms, and the nearest weights against a search."""

from __future__ import annotations

from math import pi, sqrt

import numpy as np
import pytest

from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import Segment, ShapeParameters
from sgb_core.design.comparison import Kind, compared, nearest_weights, rational_cubic
from sgb_core.surfaces.energy import bending_energy

POLYGON = [(20, 0), (45, 5), (50, 30), (35, 50)]
BENT = Segment(POLYGON, ShapeParameters(2.0, 4.0, 0.5, 0.9))
T = np.linspace(0.0, 1.0, 201)


def test_weights_of_one_are_the_plain_cubic() -> None:
    plain = Segment(POLYGON)
    assert rational_cubic(plain.points, (1.0, 1.0), T) == pytest.approx(plain.point(T))
    assert nearest_weights(plain) == (1.0, 1.0)


def test_a_half_circle_is_rational_and_has_its_energy() -> None:
    # Farin's half circle: the polygon of a square of twice the radius, inner weights 1/3.
    points = np.array([(0.0, -1.0), (2.0, -1.0), (2.0, 1.0), (0.0, 1.0)])
    curve = rational_cubic(points, (1.0 / 3.0, 1.0 / 3.0), T)
    assert np.hypot(*curve.T) == pytest.approx(np.ones(201))
    from sgb_core.design.comparison import _rational_energy

    assert _rational_energy(points, (1.0 / 3.0, 1.0 / 3.0)) == pytest.approx(pi, rel=1e-9)


def test_the_energy_of_a_rational_with_weights_of_one_is_that_of_the_cubic() -> None:
    from sgb_core.design.comparison import _rational_energy

    plain = Profile.of([Segment(POLYGON)])
    found = _rational_energy(plain[0].points, (1.0, 1.0))
    assert found == pytest.approx(bending_energy(plain), rel=1e-9)


def root_mean_square(first: float, last: float) -> float:
    off = rational_cubic(BENT.points, (first, last), np.linspace(0.0, 1.0, 49))
    fine = BENT.point(np.linspace(0.0, 1.0, 4001))
    gaps = np.sqrt(((off[:, None] - fine[None]) ** 2).sum(axis=2)).min(axis=1)
    return sqrt(float((gaps**2).mean()))


def test_no_neighbouring_weights_are_nearer() -> None:
    first, last = nearest_weights(BENT)
    best = root_mean_square(first, last)
    assert best < root_mean_square(1.0, 1.0) / 3.0
    for a in (0.97, 1.03):
        for b in (0.97, 1.0, 1.03):
            assert root_mean_square(a * first, b * last) > best


def test_all_kinds_are_compared_on_the_same_ends() -> None:
    profile = Profile.of([BENT, Segment([(35, 50), (30, 60), (10, 62), (12, 80)])])
    found = compared(profile)
    assert [each.kind for each in found] == [Kind.SG, Kind.CUBIC, Kind.QUARTIC, Kind.RATIONAL]
    for each in found:
        assert each.points.shape == (2, 201, 2)
        assert each.points[0, 0] == pytest.approx(np.array((20.0, 0.0)))
        assert each.points[1, -1] == pytest.approx(np.array((12.0, 80.0)))
    curve, cubic, quartic, rational = found
    assert curve.deviation == 0.0
    assert curve.energy == pytest.approx(bending_energy(profile))
    assert 0.0 < rational.deviation < cubic.deviation
    assert quartic.deviation > 0.0
    assert len(rational.weights) == 2
    assert rational.weights[1] == (1.0, 1.0)


def test_a_quartic_that_stands_still_at_an_end_has_no_bounded_energy() -> None:
    still = Profile.of([Segment(POLYGON, ShapeParameters(4.0, 3.0, 4.0, 0.7))])
    quartic = compared(still)[2]
    assert quartic.energy is None
