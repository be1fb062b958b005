"""Targets on random vessels: reached by independent integration, refused only out of reach."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest
from scipy.optimize import brentq

from sgb_core.bodies.solid import BodyKind, Solid
from sgb_core.curves.continuity import measure_joints
from sgb_core.curves.profile import Profile
from sgb_core.design.demands.chain import Chain
from sgb_core.design.solving.goals import Goal, goal_measure
from sgb_core.design.solving.solve import UnreachableError, solve
from sgb_core.design.solving.ways import Slider, Way, unknowns_by
from sgb_core.findings.errors import FindingError
from sgb_core.surfaces.measures import volume
from sgb_core.surfaces.revolution import RevolutionSurface
from tests.sgb_core.design.fairing.chains import smooth_chain

VESSEL = Solid(BodyKind.VESSEL, wall=0.1, base=0.15)


def vessel(seed: int, rule: str = "G1") -> RevolutionSurface:
    """Return a smooth wall of two segments that rises all the way."""
    return RevolutionSurface(smooth_chain(seed, 2, rule, bend=0.12))


def held(profile: Profile, solid: Solid) -> float:
    """Return the capacity of a rising wall, floor inside: ∫ π r² dh of the wall's curve.

    Where the wall ends below the rim it goes on straight.
    """

    def moved(t: float) -> np.ndarray:
        k = min(max(int(t), 0), len(profile) - 1)
        segment, s = profile.segments[k], min(max(t - k, 0.0), 1.0)
        a, b, c = segment.shape.leg_fractions
        p = segment.points
        inner = p[0] + a * (p[1] - p[0]), p[2] + b * (p[1] - p[2]), p[3] + c * (p[2] - p[3])
        q = [p[0], *inner, p[3]]
        while len(q) > 2:
            q = [u + s * (v - u) for u, v in pairwise(q)]
        along = (q[1] - q[0]) / np.hypot(*(q[1] - q[0]))
        place = q[0] + s * (q[1] - q[0]) + solid.wall * np.array([-along[1], along[0]])
        return place + (max(t - len(profile), 0.0) + min(t, 0.0)) * along

    def place_of(level: float, a: float, b: float) -> float:
        return float(brentq(lambda t: moved(t)[1] - level, a, b, xtol=1e-15))

    count = len(profile)
    low = float(profile.segments[0].points[0, 1]) + solid.base
    high = float(profile.segments[-1].points[3, 1])
    first, last = (place_of(level, -5.0, count + 5.0) for level in (low, high))
    edges = sorted({first, last, *(float(k) for k in range(count + 1) if first < k < last)})
    nodes, weights = np.polynomial.legendre.leggauss(30)
    total = 0.0
    for a, b in pairwise(edges):
        low, high = moved(a)[1], moved(b)[1]
        heights = low + (nodes + 1) / 2 * (high - low)
        squares = [moved(place_of(height, a, b))[0] ** 2 for height in heights.tolist()]
        total += float((high - low) / 2 * weights @ squares)
    return np.pi * total


@pytest.mark.parametrize("seed", range(3))
def test_targets_are_reached_together_and_rules_hold(seed) -> None:
    surface = vessel(seed, ("G1", "C1", "G2")[seed % 3])
    rng = np.random.default_rng(seed)
    before = held(surface.profile, VESSEL)
    low, high = surface.profile.bounds()
    wanted = {
        Goal.CAPACITY: before * rng.uniform(0.9, 1.15),
        Goal.HEIGHT: float(high[1] - low[1]) * rng.uniform(0.95, 1.1),
        Goal.RIM_DIAMETER: 2.0 * float(surface.profile.segments[-1].points[3, 0]) * 1.02,
    }
    result = solve(surface, VESSEL, wanted)
    assert held(result.profile, VESSEL) == pytest.approx(wanted[Goal.CAPACITY], rel=1e-9)
    low, high = result.profile.bounds()
    assert high[1] - low[1] == pytest.approx(wanted[Goal.HEIGHT], rel=1e-9)
    rim = 2.0 * result.profile.segments[-1].points[3, 0]
    assert rim == pytest.approx(wanted[Goal.RIM_DIAMETER], rel=1e-9)
    # A rule that did not hold asks at least that its smooth joint stays so.
    old, new = measure_joints(surface.profile)[0], measure_joints(result.profile)[0]
    assert new.holds or not old.holds
    assert new.kink_deg < 1e-6


@pytest.mark.parametrize("way", [Way.ALL, Way.HEIGHT, Way.WIDTH, Way.SHAPE, Way.POINTS])
def test_each_way_moves_what_it_may_and_nothing_else(way) -> None:
    surface = vessel(1)
    before, wanted = surface.profile, held(surface.profile, VESSEL) * 1.005
    result = solve(surface, VESSEL, {Goal.CAPACITY: wanted}, way)
    after = result.profile
    assert held(after, VESSEL) == pytest.approx(wanted, rel=1e-9)
    moved = {change.parameter.partition(".")[2] for change in result.moved}
    if way is Way.SHAPE:
        assert after.control_points.tobytes() == before.control_points.tobytes()
        return
    assert all(a.shape == b.shape for a, b in zip(before.segments, after.segments, strict=True))
    assert moved == {Way.HEIGHT: {"h"}, Way.WIDTH: {"r"}}.get(way, {"r", "h"})
    assert (result.factor is None) == (way is Way.POINTS)
    if way is Way.ALL:
        assert after.control_points == pytest.approx(before.control_points * result.factor)


@pytest.mark.parametrize("seed", range(3))
def test_one_slider_reaches_what_its_range_holds_and_no_more(seed) -> None:
    surface = vessel(seed)
    slider = Slider(1, "lambda2")

    def at(value: float) -> float:
        segment = surface.profile.segments[1]
        shape = replace(segment.shape, lambda2=value)
        profile = surface.profile.with_segment(1, segment.with_shape(shape))
        return volume(replace(surface, profile=profile))

    values = [at(value) for value in np.linspace(0.0, 6.0, 301)]
    inside = min(values) + 0.3 * (max(values) - min(values))
    result = solve(surface, VESSEL, {Goal.VOLUME: inside}, slider)
    assert volume(replace(surface, profile=result.profile)) == pytest.approx(inside, rel=1e-9)
    assert {(change.segment, change.parameter) for change in result.moved} == {(1, "lambda2")}
    for beyond, nearest in ((max(values) * 1.01, max(values)), (min(values) * 0.99, min(values))):
        with pytest.raises(UnreachableError) as caught:
            solve(surface, VESSEL, {Goal.VOLUME: beyond}, slider)
        found = caught.value.finding
        assert found.targets[0].nearest == pytest.approx(nearest, rel=1e-6)
        assert found.limits == ((1, "lambda2"),)


def test_the_shape_alone_reaches_no_more_than_its_corners() -> None:
    # The volume of straight-walled segments grows with every fraction of a bulge: the largest
    # is at a corner of the box of fractions.
    surface = vessel(2)
    start = Chain.of(surface.profile)
    unknowns = unknowns_by(Way.SHAPE, surface.profile, start)
    measure = goal_measure(Goal.VOLUME, surface, VESSEL, start)
    rng = np.random.default_rng(0)
    tried = max(
        measure(unknowns.chain(np.where(rng.random(6) < 0.5, unknowns.low, unknowns.high))).value
        for _ in range(300)
    )
    with pytest.raises(UnreachableError) as caught:
        solve(surface, VESSEL, {Goal.VOLUME: 2.0 * tried}, Way.SHAPE)
    found = caught.value.finding
    assert found.targets[0].nearest >= tried * (1 - 1e-9)
    assert found.targets[0].nearest < 1.05 * tried
    assert len(found.limits) == 6


@pytest.mark.parametrize("goal", [Goal.CAPACITY, Goal.MATERIAL, Goal.VOLUME])
@pytest.mark.parametrize("reverse", [False, True])
def test_derivatives_are_those_of_differences(goal, reverse) -> None:
    surface = vessel(3)
    if reverse:
        surface = replace(surface, profile=surface.profile.reversed())
    start = Chain.of(surface.profile)
    measure = goal_measure(goal, surface, VESSEL, start)
    unknowns = unknowns_by(Way.BOTH, surface.profile, start)
    slope = np.einsum("nq,nqj->nj", measure(start).slope, start.slopes()).ravel() @ unknowns.matrix
    rng, step = np.random.default_rng(5), 1e-6
    for _ in range(4):
        way = rng.normal(size=len(unknowns))
        values = [measure.value(unknowns.chain(sign * step * way)) for sign in (1, -1)]
        numeric = (values[0] - values[1]) / (2 * step)
        assert numeric == pytest.approx(slope @ way, abs=1e-7 * float(np.abs(slope).sum()))


def test_what_has_no_such_measure_is_told() -> None:
    surface = vessel(0)
    for goal, solid, words in (
        (Goal.CAPACITY, Solid(), "no capacity"),
        (Goal.CAPACITY, Solid(BodyKind.FILLED), "only a vessel"),
    ):
        with pytest.raises(FindingError, match=words):
            solve(surface, solid, {goal: 1.0})
