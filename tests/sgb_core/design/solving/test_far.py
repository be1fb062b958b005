"""Targets far away, at odds or beside walls: reached, or the nearest is there and truly so."""

from __future__ import annotations

import os

import numpy as np
import pytest

import sgb_core as sgb
from sgb_core.bodies.solid import BodyKind, Solid
from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import Segment
from sgb_core.design.solving.along import least_along
from sgb_core.design.solving.goals import Goal
from sgb_core.design.solving.ways import Way
from sgb_core.document import edits
from sgb_core.document.edits.reach import goal_value
from sgb_core.document.edits.solve import OutOfReachError, solve_targets
from sgb_core.document.model import Document
from tests.sgb_core.design.locks.samples import pot
from tests.sgb_core.design.solving.test_solve import VESSEL, vessel

# Two hundred by hand: SOLVE_VESSELS=200.
VESSELS = int(os.environ.get("SOLVE_VESSELS", "1"))


def nearest(document: Document, targets, way=Way.BOTH) -> OutOfReachError:
    with pytest.raises(OutOfReachError) as caught:
        solve_targets(document, targets, way)
    return caught.value


@pytest.mark.parametrize("seed", range(VESSELS))
@pytest.mark.parametrize("factor", [0.2, 0.5, 3.0])
def test_points_reach_whatever_a_change_of_size_reaches(seed, factor) -> None:
    document = Document(vessel(seed).profile, solid=VESSEL)
    for goal in (Goal.CAPACITY, Goal.MATERIAL):
        wanted = factor * goal_value(document, goal)
        for way in (Way.ALL, Way.POINTS, Way.BOTH):
            result = solve_targets(document, {goal: wanted}, way)[0]
            assert goal_value(result, goal) == pytest.approx(wanted, rel=1e-9)
            assert [each.holds for each in result.joints] == [
                each.holds for each in document.joints
            ]


@pytest.mark.parametrize("way", [Way.ALL, Way.WIDTH, Way.HEIGHT])
def test_a_stretch_is_refused_only_beyond_what_every_stretch_has(way) -> None:
    document = pot(2)
    for goal, factor in ((Goal.CAPACITY, 1e-3), (Goal.MATERIAL, 0.3)):
        wanted = factor * goal_value(document, goal)
        try:
            result = solve_targets(document, {goal: wanted}, way)[0]
        except OutOfReachError as error:
            # By brute force: every stretch that leaves a body has more, or all have less.
            found = []
            for part in np.geomspace(1e-3, 1e3, 80).tolist():
                wide = part if way is not Way.HEIGHT else 1.0
                high = part if way is not Way.WIDTH else 1.0
                points = document.profile.control_points * (wide, high)
                profile = document.profile.with_segments(
                    each.with_points(own)
                    for each, own in zip(document.profile, points, strict=True)
                )
                value = goal_value(Document(profile, solid=document.solid), goal)
                if value is not None:
                    found.append(value / wanted - 1.0)
            assert min(found) > 0.0 or max(found) < 0.0
            least = abs(goal_value(error.nearest, goal) / wanted - 1.0)
            assert least <= 1.1 * min(map(abs, found))
        else:
            assert goal_value(result, goal) == pytest.approx(wanted, rel=1e-9)


@pytest.mark.parametrize("apart", [1e-8, 1e-6, 1e-4, 1e-2, -1e-6])
def test_wishes_nearly_alike_that_exclude_each_other_are_met_half_way(apart) -> None:
    cone = Profile.of([Segment([(30, 0), (35, 20), (45, 40), (55, 80)])])
    document = Document(cone, solid=Solid(BodyKind.VESSEL, wall=3.0, base=4.0))
    wanted = {Goal.RIM_DIAMETER: 120.0, Goal.MAX_DIAMETER: 120.0 * (1.0 + apart)}
    error = nearest(document, wanted)
    for goal, value in wanted.items():
        part = goal_value(error.nearest, goal) / value - 1.0
        assert abs(part) == pytest.approx(abs(apart) / 2.0, rel=2.0 * abs(apart) + 1e-5)
    # As many digits as tell what is wanted from what there is.
    for words in sgb.say(error.finding).split(";")[:2]:
        asked, near = words.split(" is out of reach, the nearest is ")
        assert asked.split()[-2:] != near.split()
    met = solve_targets(document, dict.fromkeys(wanted, 120.0))[0]
    assert goal_value(met, Goal.RIM_DIAMETER) == pytest.approx(120.0, rel=1e-9)


def test_many_wishes_at_odds_end_with_the_nearest_and_a_body() -> None:
    document = edits.set_fill(pot(2), below_rim=10.0)
    goals = [Goal.VOLUME, Goal.HEIGHT, Goal.MAX_DIAMETER, Goal.CAPACITY, Goal.MATERIAL]
    factors = (1.05, 1.0, 1.0, 1.05, 0.2)
    wanted = {g: f * goal_value(document, g) for g, f in zip(goals, factors, strict=True)}
    error = nearest(document, wanted)
    before, after = (
        np.hypot.reduce([goal_value(each, g) / value - 1.0 for g, value in wanted.items()])
        for each in (document, error.nearest)
    )
    assert after < before
    assert error.nearest.body().capacity > 0.0


def test_along_a_range_the_zero_nearest_to_the_present_is_found() -> None:
    places = np.linspace(-3.0, 3.0, 13)
    assert least_along(places, lambda x: (x - 0.7) * (x + 2.2)) == pytest.approx(0.7, abs=1e-14)
    assert least_along(places, lambda x: x * x + 1.0) == 0.0
    # Only just where it begins to be measured.
    edge = least_along(places, lambda x: x - 1.01 if x >= 1.0 else float("nan"))
    assert edge == pytest.approx(1.01, abs=1e-14)
    beyond = least_along(places, lambda x: x if x > 1.1 else float("nan"))
    assert beyond == pytest.approx(1.1, abs=1e-12)


def test_a_search_that_was_ended_says_so_and_keeps_the_nearest() -> None:
    document, asked = pot(2), iter([False, False])
    wanted = {Goal.CAPACITY: 0.05 * goal_value(document, Goal.CAPACITY)}
    with pytest.raises(OutOfReachError) as caught:
        solve_targets(document, wanted, enough=lambda: next(asked, True))
    assert not caught.value.is_final
    words = sgb.say(caught.value.finding)
    assert "is not reached so far" in words
    assert "free to move" not in words
    found = goal_value(caught.value.nearest, Goal.CAPACITY)
    assert abs(found / wanted[Goal.CAPACITY] - 1.0) < 0.5


@pytest.mark.parametrize("way", [Way.POINTS, Way.BOTH])
def test_a_vessel_wider_than_its_profile_is_large_shrinks_as_far_as_a_change_of_size(way) -> None:
    # Its radius is nearly twice the diagonal of its profile's box.
    document = Document(vessel(28).profile, solid=VESSEL)
    wanted = 0.2 * goal_value(document, Goal.MATERIAL)
    result = solve_targets(document, {Goal.MATERIAL: wanted}, way)[0]
    assert goal_value(result, Goal.MATERIAL) == pytest.approx(wanted, rel=1e-9)
