"""The path under twisted laws against the exact surface, found by a search from outside."""

from __future__ import annotations

from dataclasses import replace
from math import pi

import numpy as np
import pytest
from scipy.optimize import minimize
from scipy.spatial import cKDTree

from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import Segment, ShapeParameters
from sgb_core.document.model import Document
from sgb_core.surfaces.laws.law import Law
from sgb_core.surfaces.twist import Ease, Twist
from sgb_core.toolpaths.errors import ToolpathError
from sgb_core.toolpaths.plan_path import toolpath
from sgb_core.toolpaths.settings import Wanted
from tests.sgb_core.toolpaths.printing import BIG, CYLINDER, wall_of


def fluted(turns: float, ease: Ease = Ease.LINEAR) -> Document:
    """Return a bellied vase with eight lobes, twisted."""
    segment = Segment([(30, 0), (50, 20), (50, 40), (32, 60)], ShapeParameters(1, 3, 1, 1))
    return replace(
        Document(Profile.of([segment])),
        variation=(Law("radius", "lobes", start=0.85, end=1.1, count=8),),
        twist=Twist(turns, ease),
    )


@pytest.mark.parametrize(
    ("turns", "ease", "clockwise"),
    [(0.3, Ease.LINEAR, False), (-0.3, Ease.SMOOTH, False), (0.3, Ease.SMOOTH, True)],
)
def test_with_a_twist_each_point_lies_half_a_bead_inside_the_exact_surface(
    turns, ease, clockwise
) -> None:
    document = fluted(turns, ease)
    surface = document.surface

    def away(at: np.ndarray, place: np.ndarray) -> float:
        return float(((surface.point(0, min(max(at[0], 0.0), 1.0), at[1]) - place) ** 2).sum())

    wanted = Wanted(layer=1.5, bead=2.0, chord=0.1, anyway=True, clockwise=clockwise)
    points = wall_of(toolpath(document, BIG, wanted))
    inside = points[(points[:, 2] > 3.0) & (points[:, 2] < 57.0)]
    grid = [(s, theta) for s in np.linspace(0, 1, 30) for theta in np.linspace(0, 2 * pi, 90)]
    near = cKDTree([surface.point(0, s, theta) for s, theta in grid])
    for place in inside[:: len(inside) // 12]:
        start = grid[near.query(place)[1]]
        found = minimize(away, start, (place,), "Nelder-Mead", tol=1e-12)
        assert abs(found.fun**0.5 - 1.0) < 1e-3


@pytest.mark.parametrize("clockwise", [False, True])
def test_a_twisted_wall_climbs_a_layer_a_turn_about_the_axis(clockwise) -> None:
    for ease in Ease:
        wanted = Wanted(layer=2.0, bead=0.0, anyway=True, clockwise=clockwise)
        points = wall_of(toolpath(fluted(1.0, ease), BIG, wanted))
        turned = np.abs(np.unwrap(np.arctan2(points[:, 1], points[:, 0]))) / (2.0 * pi)
        climbing = points[:, 2] < 59.99
        turned -= turned[0] - points[0, 2] / 2.0
        assert points[climbing, 2] == pytest.approx(2.0 * turned[climbing], abs=1e-4)


def test_with_a_twist_the_flow_is_the_wall() -> None:
    for bead in (0.6, 3.0):
        path = toolpath(fluted(0.7), BIG, Wanted(layer=1.5, bead=bead, chord=0.1, anyway=True))
        assert path.extruded_volume == pytest.approx(path.material_volume, rel=5e-3)


def test_a_straight_fluted_prism_leans_nowhere_and_a_twisted_one_as_its_flanks_do() -> None:
    prism = replace(fluted(0.0), profile=CYLINDER.profile)
    wanted = Wanted(layer=0.2, bead=0.5, anyway=True)
    assert toolpath(prism, BIG, wanted).largest_step < 1e-3
    turned = toolpath(replace(prism, twist=Twist(0.25)), BIG, wanted)
    # How far a place of a section moves square to the outline while it turns by a layer's part.
    theta = np.linspace(0.0, 2.0 * pi, 4001)
    sides = np.array([prism.surface.point(0, 0.5, at)[:2] for at in theta])
    along = np.diff(sides, axis=0)
    normal = np.column_stack([along[:, 1], -along[:, 0]]) / np.hypot(*along.T)[:, None]
    middle = (sides[1:] + sides[:-1]) / 2.0
    swept = np.abs((np.column_stack([-middle[:, 1], middle[:, 0]]) * normal).sum(axis=1))
    expected = swept.max() * 2.0 * pi * 0.25 * 0.2 / 21.3
    assert turned.largest_step == pytest.approx(expected, rel=2e-2)


def test_a_twist_of_many_turns_is_refused() -> None:
    with pytest.raises(ToolpathError, match="more than 30 degrees in a layer"):
        toolpath(fluted(20.0), BIG, Wanted(layer=1.0, anyway=True))
