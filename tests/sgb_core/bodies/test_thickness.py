"""The least thickness of walls that vary with the angle: exact, and each search made once."""

from __future__ import annotations

from dataclasses import replace
from math import pi

import numpy as np
import pytest
from scipy.optimize import minimize

from sgb_core.arrays import Floats
from sgb_core.bodies import thickness, vessel
from sgb_core.bodies.solid import BodyKind, Solid, WallSide
from sgb_core.bodies.thickness import least_distance
from sgb_core.bodies.vessel import vessel_measures
from sgb_core.surfaces.angular import different_angles
from sgb_core.surfaces.placement import Placement
from sgb_core.surfaces.revolution import Axis, RevolutionSurface
from sgb_core.surfaces.variation import Law
from tests.sgb_core.surfaces.chains import chain

POT = chain(
    [[(12, 0), (60, 15), (5, 40), (30, 60)], [(30, 60), (34, 64), (30, 80), (40, 90)]], (1, 3, 1, 1)
)
WALL = Solid(BodyKind.VESSEL, 2.0, WallSide.INSIDE, 2.0)
KEYS = ((0.0, 0.0), (90.0, 1.0), (200.0, 0.3))
WAVES = Law("lambda2", "cosine", 1.0, 5.0, count=8)
LAWS = [
    WAVES,
    Law("lambda2", "paper", 0.0, 6.0),
    Law("lambda1", "keyframes", 0.0, 4.0, segments=(0,), keyframes=KEYS),
]


def turned(*laws: Law) -> RevolutionSurface:
    return RevolutionSurface(POT, laws=laws)


@pytest.mark.parametrize("law", [replace(WAVES, count=3), *LAWS[1:]])
def test_against_a_search_by_other_means(law: Law, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(thickness, "AROUND", 6)
    monkeypatch.setattr(thickness, "ALONG", 5)
    surface = turned(law)
    places = np.linspace(0.02, 0.98, 5)
    least = WALL.wall
    for angle in 2.0 * pi * (np.arange(6) + 0.5) / 6.0:
        held = RevolutionSurface(surface.profile_at(angle))
        # The walls are too thin for what is nearest to lie beyond the paper's creases.
        half = (0.0, pi) if angle < pi else (pi, 2.0 * pi)
        for segment in range(2):
            inward = -WALL.wall * held.normal(segment, places, angle)
            moved = held.point(segment, places, angle) + inward
            for s, point in zip(places, moved, strict=True):

                def square(x: Floats, segment: int = segment, point: Floats = point) -> float:
                    return float(((surface.point(segment, *x) - point) ** 2).sum())

                nearest = minimize(square, (s, angle), bounds=((0.0, 1.0), half))
                least = min(least, float(nearest.fun) ** 0.5)
    assert least < 0.98 * WALL.wall
    assert least_distance(surface, WALL) == pytest.approx(least, rel=1e-5)


@pytest.mark.parametrize("laws", [(WAVES,), (LAWS[1],), (WAVES, replace(WAVES, count=12))])
def test_what_repeats_round_the_turn_is_sought_once(laws: tuple[Law, ...]) -> None:
    surface = turned(*laws)
    # A turn that is not quite full is taken to repeat nothing.
    whole = least_distance(replace(surface, sweep=2.0 * pi * (1.0 - 1e-13)), WALL)
    assert least_distance(surface, WALL) == pytest.approx(whole, rel=1e-9)


@pytest.mark.parametrize("law", LAWS)
def test_turning_and_placing_changes_no_thickness(law: Law) -> None:
    moved = RevolutionSurface(POT, Axis.X, 1.0, laws=(law,))
    moved = replace(moved, placement=Placement((5.0, -3.0, 100.0), (30.0, 40.0, 50.0)))
    assert least_distance(moved, WALL) == pytest.approx(
        least_distance(turned(law), WALL), rel=1e-12
    )


def test_different_angles_stand_for_all() -> None:
    theta = 2.0 * pi * (np.arange(96) + 0.5) / 96
    assert len(different_angles(turned(WAVES), theta)[0]) == 6
    assert len(different_angles(turned(WAVES, replace(WAVES, count=12)), theta)[0]) == 12
    assert len(different_angles(turned(WAVES, LAWS[1]), theta)[0]) == 48
    assert len(different_angles(turned(WAVES, LAWS[2]), theta)[0]) == 96
    assert len(different_angles(replace(turned(WAVES), sweep=3.0), theta)[0]) == 96


def test_equal_sections_are_measured_once(monkeypatch: pytest.MonkeyPatch) -> None:
    measured = []
    swept_area = vessel.swept_area
    monkeypatch.setattr(
        vessel, "swept_area", lambda pieces: measured.append(1) or swept_area(pieces)
    )
    vessel_measures(turned(replace(WAVES, start=2.5, end=3.0)), WALL)
    # The twelve angles of half a wave, all of the body and its cavity.
    assert len(measured) == 2 * 12
