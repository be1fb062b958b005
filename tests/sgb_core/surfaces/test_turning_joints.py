"""Joints under laws: the worst over the turn, against a fine walk round it."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise
from math import log, radians

import numpy as np
import pytest

from sgb_core.curves.continuity import JointClass, measure_joint, measure_joints
from sgb_core.curves.many_joints import measure_many
from sgb_core.curves.profile import JointRule, Profile
from sgb_core.curves.segment import Segment, ShapeParameters
from sgb_core.surfaces import turning_joints
from sgb_core.surfaces.revolution import RevolutionSurface
from sgb_core.surfaces.turning_joints import measure_turning_joints
from sgb_core.surfaces.variation import Law
from tests.sgb_core.surfaces.chains import TOWER, chain

SYMMETRIC = Profile.of(
    [
        Segment([(5, 13), (6, 12), (3, 10), (2, 8)], ShapeParameters(4, 3, 4, 1)),
        Segment([(2, 8), (1, 6), (2, 3), (5, -1)], ShapeParameters(4, 3, 4, 1)),
    ],
    ["G1"],
)
HALF = Law("omega", "raised-cosine", 0.0, 0.5)


def test_stored_parameters_that_a_law_overrides_say_nothing() -> None:
    assert measure_joint(SYMMETRIC, 0).measured is JointClass.G0
    (found,) = measure_turning_joints(RevolutionSurface(SYMMETRIC, laws=(HALF,)))
    assert (found.measured, found.at_deg) == (JointClass.C1, 0.0)
    assert found.kink_deg == pytest.approx(0.0, abs=1e-6)
    assert found.speed_ratio == pytest.approx(1.0)


def test_a_class_that_drops_at_one_angle_alone_is_found_there() -> None:
    # Only at θ = 180° both are at their ends: the derivative vanishes and the kink shows.
    laws = (
        Law("omega", "paper", 0.0, 1.0),
        Law("lambda3", "raised-cosine", 1.0, 4.0, (0,)),
        Law("lambda1", "raised-cosine", 1.0, 2.0, (1,)),
    )
    (found,) = measure_turning_joints(RevolutionSurface(SYMMETRIC, laws=laws))
    assert found.measured is JointClass.G0
    assert found.at_deg == pytest.approx(180.0)
    still = RevolutionSurface(SYMMETRIC, laws=laws).profile_at(np.pi)
    assert found.kink_deg == pytest.approx(measure_joint(still, 0).kink_deg)
    assert (found.speed_ratio, found.curvature_jump) == (None, None)


def test_without_laws_they_are_the_joints_of_the_profile() -> None:
    profile = chain(TOWER, (2, 4, 1, 0.7))
    assert measure_turning_joints(RevolutionSurface(profile)) == measure_joints(profile)


def test_a_joint_that_no_law_reaches_is_the_same_all_round() -> None:
    profile = chain(TOWER, (2, 4, 1, 0.7))
    last = Law("omega", "cosine", 0.1, 0.9, (len(profile) - 1,), count=3)
    found = measure_turning_joints(RevolutionSurface(profile, laws=(last,)))
    for report, plain in zip(found[:-1], measure_joints(profile)[:-1], strict=True):
        assert report.at_deg == 0.0
        assert (report.measured, report.kink_deg) == (plain.measured, plain.kink_deg)


def random_surface(seed: int) -> RevolutionSurface:
    rng = np.random.default_rng(seed)
    tops = {"lambda1": 4.0, "lambda2": 6.0, "lambda3": 4.0, "omega": 1.0}
    points = np.cumsum(rng.uniform(-1, 2, (7, 2)), axis=0) + 5
    points[4] = 2 * points[3] - points[2] if seed % 2 else points[4]
    both = [
        Segment(part, ShapeParameters(*(rng.uniform(0, top) for top in tops.values())))
        for part in (points[:4], points[3:])
    ]
    laws = []
    for name in rng.choice(list(tops), 2, replace=False):
        keys = np.stack([rng.uniform(0, 360, 4), rng.random(4)], axis=1)
        laws.append(
            Law(
                str(name),
                ["paper", "raised-cosine", "cosine", "keyframes"][rng.integers(4)],
                *rng.uniform(0.05 * tops[name], 0.95 * tops[name], 2).tolist(),
                count=int(rng.integers(1, 5)),
                keyframes=tuple(map(tuple, keys.tolist())),
            )
        )
    sweep = (360.0, 100.0)[seed % 3 == 0]
    return RevolutionSurface.of_degrees(
        Profile.of(both, [JointRule.G0]), laws=tuple(laws), sweep_deg=sweep
    )


@pytest.mark.parametrize("seed", range(10))
def test_a_fine_walk_finds_nothing_worse(seed: int) -> None:
    surface = random_surface(seed)
    (found,) = measure_turning_joints(surface)
    walk = [
        measure_joint(surface.profile_at(surface.start + theta), 0)
        for theta in np.linspace(0.0, surface.sweep, 1441)
    ]
    order = list(JointClass)
    assert order.index(found.measured) <= min(order.index(r.measured) for r in walk)
    kinks, jumps = [r.kink_deg for r in walk], [abs(r.curvature_jump) for r in walk]
    assert found.kink_deg == pytest.approx(max(kinks), abs=1e-6)
    assert abs(found.curvature_jump) == pytest.approx(max(jumps), rel=1e-4)
    assert abs(found.curvature_jump) >= max(jumps) * (1 - 1e-9)
    offs = [abs(log(r.speed_ratio)) for r in walk]
    assert abs(log(found.speed_ratio)) == pytest.approx(max(offs), rel=1e-4)
    there = measure_joint(surface.profile_at(surface.start + radians(found.at_deg)), 0)
    assert there.measured is found.measured


def long_surface(count: int) -> RevolutionSurface:
    """Return a tower under a law, its last joint out of the law's reach."""
    ends = [(5.0 + (k % 3), 2.0 * k) for k in range(count + 1)]
    segments = []
    for (r, h), (far, top) in pairwise(ends):
        points = [(r, h), (r + 1.0, h + 0.5), (far - 0.5, top - 0.5), (far, top)]
        segments.append(Segment(points, ShapeParameters(1.5, 4.0, 0.5, 0.6)))
    governed = tuple(range(count - 2))
    laws = (Law("omega", "cosine", 0.2, 0.9, governed, count=3),)
    return RevolutionSurface(Profile.of(segments), laws=laws)


def test_a_longer_chain_is_searched_in_the_same_steps(monkeypatch) -> None:
    calls = []

    def counted(*args):
        calls.append(None)
        return measure_many(*args)

    monkeypatch.setattr(turning_joints, "measure_many", counted)
    taken = []
    for count in (4, 40):
        calls.clear()
        measure_turning_joints(long_surface(count))
        taken.append(len(calls))
    assert taken[0] == taken[1] <= 6


def test_what_an_edit_leaves_alone_is_taken_over(monkeypatch) -> None:
    surface = long_surface(10)
    before = measure_turning_joints(surface)
    profile = surface.profile
    shape = replace(profile[4].shape, lambda2=2.0)
    edited = replace(surface, profile=profile.with_segment(4, profile[4].with_shape(shape)))
    anew = measure_turning_joints(edited)
    measured = []

    def counted(before, after, size):
        measured.append(np.broadcast_shapes(before.fraction.shape, after.fraction.shape))
        return measure_many(before, after, size)

    monkeypatch.setattr(turning_joints, "measure_many", counted)
    found = measure_turning_joints(edited, (surface, before))
    assert found == anew
    assert [a is b for a, b in zip(found, before, strict=True)] == [
        joint not in (3, 4) for joint in profile.joints
    ]
    assert measured[0][0] == 2


def test_nothing_is_taken_over_where_laws_turn_or_size_are_others() -> None:
    surface = long_surface(6)
    before = measure_turning_joints(surface)
    wider = surface.profile[5].with_points([*surface.profile[5].points[:3], (5.0, 30.0)])
    others = (
        replace(surface, laws=(Law("omega", "cosine", 0.2, 0.8, (0, 1, 2), count=2),)),
        replace(surface, sweep=1.0),
        replace(surface, profile=surface.profile.with_segment(5, wider)),
    )
    for other in others:
        found = measure_turning_joints(other, (surface, before))
        assert found == measure_turning_joints(other)
        assert all(a is not b for a, b in zip(found, before, strict=True))
