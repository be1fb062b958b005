"""Targets on random vessels: reached by independent integration, refused only out of reach."""

from __future__ import annotations

import os
from dataclasses import replace
from itertools import pairwise, product

import numpy as np
import pytest
from scipy.optimize import brentq

from sgb_core.bodies.cut_outs import CutOut, HoleShape
from sgb_core.bodies.solid import BodyKind, Solid
from sgb_core.curves.continuity import measure_joints
from sgb_core.curves.primitives import line
from sgb_core.curves.profile import Profile
from sgb_core.design.demands.chain import Chain
from sgb_core.design.demands.directions import KeptDirections
from sgb_core.design.fairing.findings import Keep
from sgb_core.design.locks.dimension import Dimension, DimensionKind
from sgb_core.design.solving.goals import Goal, target
from sgb_core.design.solving.solve import Solved
from sgb_core.design.solving.ways import Slider, Way, unknowns_by
from sgb_core.document import edits
from sgb_core.document.appearance.model import Layer
from sgb_core.document.dimensions import missed_locks, setting_of
from sgb_core.document.edits.reach import goal_value
from sgb_core.document.edits.solve import solve_targets
from sgb_core.document.errors import EditError
from sgb_core.document.model import Document
from sgb_core.findings.solving import Unreachable
from sgb_core.surfaces.laws.law import Law
from sgb_core.surfaces.measures import volume
from sgb_core.surfaces.revolution import RevolutionSurface
from tests.sgb_core.design.fairing.chains import smooth_chain

# Two hundred by hand: SOLVE_VESSELS=200.
VESSELS = int(os.environ.get("SOLVE_VESSELS", "3"))
VESSEL = Solid(BodyKind.VESSEL, wall=0.1, base=0.15)


def vessel(seed: int, rule: str = "G1") -> RevolutionSurface:
    """Return a smooth wall of two segments that rises all the way."""
    return RevolutionSurface(smooth_chain(seed, 2, rule, bend=0.12))


def solve(surface, solid, targets, way=Way.BOTH, keep=()) -> Solved:
    """Return what is found for a body over a surface."""
    return solve_targets(Document(surface.profile, solid=solid), targets, way, keep)[1]


def unreachable(document, targets, way=Way.BOTH, keep=()) -> Unreachable:
    """Return what is said of targets that cannot be reached."""
    with pytest.raises(EditError) as caught:
        solve_targets(document, targets, way, keep)
    assert isinstance(caught.value.finding, Unreachable)
    return caught.value.finding


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
    # Fine panels: a wall beside a tight bend turns fast.
    marks = (k / 16.0 for k in range(16 * count + 1))
    edges = sorted({first, last, *(mark for mark in marks if first < mark < last)})
    nodes, weights = np.polynomial.legendre.leggauss(30)
    total = 0.0
    for a, b in pairwise(edges):
        low, high = moved(a)[1], moved(b)[1]
        heights = low + (nodes + 1) / 2 * (high - low)
        squares = [moved(place_of(height, a, b))[0] ** 2 for height in heights.tolist()]
        total += float((high - low) / 2 * weights @ squares)
    return np.pi * total


def folds(profile: Profile, solid: Solid) -> bool:
    """Whether the profile bends tighter to the inside than the wall is thick."""
    s = np.linspace(0.0, 1.0, 2001)
    return any(float(each.curvature(s).max()) * solid.wall >= 1.0 for each in profile.segments)


@pytest.mark.parametrize("seed", range(VESSELS))
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
    capacity = held(result.profile, VESSEL)
    if folds(result.profile, VESSEL):
        # Trimmed there, as the integral along the wall's curve is not.
        capacity = Document(result.profile, solid=VESSEL).body().capacity
    assert capacity == pytest.approx(wanted[Goal.CAPACITY], rel=1e-9)
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
        found = unreachable(Document(surface.profile), {Goal.VOLUME: beyond}, slider)
        assert found.targets[0].nearest == pytest.approx(nearest, rel=1e-6)
        assert found.limits == ((1, "lambda2"),)


def test_the_shape_alone_reaches_no_more_than_its_corners() -> None:
    # The volume of straight-walled segments grows with every fraction of a bulge: the largest
    # is at a corner of the box of fractions.
    surface = vessel(2)
    start = Chain.of(surface.profile)
    unknowns = unknowns_by(Way.SHAPE, surface.profile, start)
    setting = setting_of(Document(surface.profile, solid=VESSEL))
    measure = target(Goal.VOLUME, setting, 1.0, start)
    rng = np.random.default_rng(0)
    tried = 1.0 + max(
        measure.missed(unknowns.chain(np.where(rng.random(6) < 0.5, unknowns.low, unknowns.high)))
        for _ in range(300)
    )
    found = unreachable(Document(surface.profile), {Goal.VOLUME: 2.0 * tried}, Way.SHAPE)
    assert found.targets[0].nearest >= tried * (1 - 1e-9)
    assert found.targets[0].nearest < 1.05 * tried
    assert len(found.limits) == 6


@pytest.mark.parametrize("seed", range(VESSELS))
def test_what_is_refused_is_out_of_reach_of_every_corner_and_what_is_not_is_reached(seed) -> None:
    """By brute force: all 64 corners of the leg fractions' box, and places inside it."""
    surface = vessel(seed)
    document = Document(surface.profile)
    start = Chain.of(surface.profile)
    unknowns = unknowns_by(Way.SHAPE, surface.profile, start)
    rng = np.random.default_rng(seed)
    shares = [*product((0.0, 1.0), repeat=6), *rng.random((100, 6)).tolist()]
    tried = [
        volume(replace(surface, profile=chain.profile(surface.profile, start)))
        for share in shares
        for chain in [
            unknowns.chain(unknowns.low + np.array(share) * (unknowns.high - unknowns.low))
        ]
    ]
    for factor, extreme, sign in ((3.0, max(tried), 1.0), (0.3, min(tried), -1.0)):
        found = unreachable(document, {Goal.VOLUME: factor * extreme}, Way.SHAPE)
        nearest = found.targets[0].nearest
        assert sign * nearest >= sign * extreme - 1e-9 * extreme
        inside = nearest + 0.03 * (volume(surface) - nearest)
        result = solve(surface, VESSEL, {Goal.VOLUME: inside}, Way.SHAPE)
        assert volume(replace(surface, profile=result.profile)) == pytest.approx(inside, rel=1e-9)
        assert result.profile.control_points.tobytes() == surface.profile.control_points.tobytes()


@pytest.mark.parametrize("goal", [Goal.CAPACITY, Goal.FILLED, Goal.MATERIAL, Goal.VOLUME])
@pytest.mark.parametrize("reverse", [False, True])
def test_slopes_are_those_of_differences_of_the_body(goal, reverse) -> None:
    surface = vessel(3)
    if reverse:
        surface = replace(surface, profile=surface.profile.reversed())
    document = edits.set_fill(Document(surface.profile, solid=VESSEL), below_rim=0.3)
    start, present = Chain.of(surface.profile), goal_value(document, goal)
    model = target(goal, setting_of(document), present, start)
    unknowns = unknowns_by(Way.BOTH, surface.profile, start)
    slope = model.equations(start).slope[0] @ unknowns.matrix
    rng, step = np.random.default_rng(5), 1e-6
    for _ in range(4):
        way = rng.normal(size=len(unknowns))
        values = []
        for sign in (1, -1):
            profile = unknowns.chain(sign * step * way).profile(surface.profile, start)
            values.append(goal_value(replace(document, profile=profile), goal) / present)
        numeric = (values[0] - values[1]) / (2 * step)
        # A model: at the ends of the wall it is a little off.
        assert numeric == pytest.approx(slope @ way, abs=2e-3 * float(np.abs(slope).sum()))


def test_what_has_no_such_measure_is_told() -> None:
    surface = vessel(0)
    for goal, solid, words in (
        (Goal.CAPACITY, Solid(), "no capacity"),
        (Goal.CAPACITY, Solid(BodyKind.FILLED), "only a vessel"),
        (Goal.FILLED, VESSEL, "without a fill line"),
    ):
        with pytest.raises(EditError, match=words):
            solve(surface, solid, {goal: 1.0})


@pytest.mark.parametrize("below_rim", [None, 0.4])
def test_to_the_fill_line_which_goes_with_a_stretch(below_rim) -> None:
    document = Document(vessel(1).profile, solid=VESSEL)
    low, high = (float(corner[1]) for corner in document.profile.bounds())
    line = 0.7 * high + 0.3 * low
    document = edits.set_fill(document, None if below_rim else line, below_rim=below_rim)
    wanted = 1.2 * goal_value(document, Goal.FILLED)
    for way in (Way.BOTH, Way.ALL, Way.HEIGHT):
        result, found = solve_targets(document, {Goal.FILLED: wanted}, way)
        assert goal_value(result, Goal.FILLED) == pytest.approx(wanted, rel=1e-9)
        if below_rim is None and way is not Way.BOTH:
            from_low = low if way is Way.HEIGHT else 0.0
            assert result.fill_height == pytest.approx(from_low + found.factor * (line - from_low))
        elif below_rim is None:
            assert result.fill_height == line


def test_locks_and_what_is_kept_hold_and_a_locked_target_takes_its_value() -> None:
    document = Document(vessel(2).profile, solid=VESSEL)
    for kind in (DimensionKind.CAPACITY, DimensionKind.RIM_DIAMETER, DimensionKind.HEIGHT):
        document = edits.add_dimension(document, Dimension(kind))
    document = edits.add_dimension(document, Dimension(DimensionKind.POINT, points=((0, 0),)))
    for number in range(4):
        document = edits.set_lock(document, number, True)
    height = 1.04 * goal_value(document, Goal.HEIGHT)
    keep = (Keep.ENDS, Keep.TANGENTS)
    result, found = solve_targets(document, {Goal.HEIGHT: height}, keep=keep[1:])
    assert missed_locks(result) == ()
    assert result.dimensions[2].value == height
    assert set(found.reached) == {Goal.HEIGHT}
    before, after = Chain.of(document.profile), Chain.of(result.profile)
    assert (result.profile.segments[0].points[0] == document.profile.segments[0].points[0]).all()
    told = KeptDirections.of(before).equations(after)
    assert np.abs(told.residual).max() < 1e-9
    # With the ends in their places nothing reaches higher; what is in the way is named.
    refused = unreachable(document, {Goal.HEIGHT: height}, Way.ALL, keep)
    assert "capacity" in refused.held or "rim_diameter" in refused.held
    free = replace(document, dimensions=())
    wanted = 1.01 * goal_value(free, Goal.MATERIAL)
    kept = solve_targets(free, {Goal.MATERIAL: wanted}, keep=(Keep.ENDS,))[0]
    assert goal_value(kept, Goal.MATERIAL) == pytest.approx(wanted, rel=1e-9)
    for segment, point in ((0, 0), (-1, 3)):
        before, after = (each.profile.segments[segment].points[point] for each in (free, kept))
        assert (before == after).all()


def test_under_laws_the_object_itself_has_the_values() -> None:
    law = Law("lambda2", "cosine", 1.0, 5.0, segments=(0,), count=3)
    document = replace(Document(vessel(1).profile), variation=(law,))
    wanted = 1.1 * volume(document.surface)
    slid = edits.set_shape_parameter(document, 1, "lambda2", 4.5)
    for way in (Way.BOTH, Way.ALL, Slider(1, "lambda2")):
        aim = wanted if isinstance(way, Way) else volume(slid.surface)
        result, found = solve_targets(document, {Goal.VOLUME: aim}, way)
        assert volume(result.surface) == pytest.approx(aim, rel=1e-9)
        assert found.reached[Goal.VOLUME] == pytest.approx(aim, rel=1e-9)
        # The shape of what a law governs is not the search's to change.
        assert result.profile.segments[0].shape == document.profile.segments[0].shape
    with pytest.raises(EditError, match="laws"):
        solve_targets(document, {Goal.VOLUME: wanted}, Slider(0, "lambda2"))


@pytest.mark.parametrize("way", [Way.BOTH, Way.ALL])
def test_material_is_reached_with_its_relief_and_its_holes(way) -> None:
    tube = Document(Profile.of([line((40.0, 0.0), (40.0, 100.0))]))
    cup = edits.set_solid(tube, kind="vessel", wall=4.0, base=5.0)
    ringed = edits.add_layer(cup, Layer("band", start=0.4, end=0.6, relief=1.5, edge=2.0))
    pierced = edits.set_cut_outs(ringed, (CutOut(HoleShape.CIRCLE, width=8.0, rows=1, around=6),))
    for document in (ringed, pierced):
        wanted = 1.1 * document.body().material_volume
        result, found = solve_targets(document, {Goal.MATERIAL: wanted}, way)
        assert found.reached[Goal.MATERIAL] == pytest.approx(wanted, rel=2e-4)
        assert result.body().material_volume == pytest.approx(wanted, rel=2e-4)


def test_what_is_out_of_reach_is_told_as_it_is_measured() -> None:
    tube = Document(Profile.of([line((40.0, 0.0), (40.0, 100.0))]))
    cup = edits.set_solid(tube, kind="vessel", wall=4.0, base=5.0)
    ringed = edits.add_layer(cup, Layer("band", start=0.4, end=0.6, relief=1.5, edge=2.0))
    (nearest,) = unreachable(ringed, {Goal.MATERIAL: 5e6}, Way.SHAPE).targets
    assert nearest.wanted == pytest.approx(5e6)
