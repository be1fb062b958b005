"""Strokes of a pencil: whole profiles, on from an end, over a part; joints, rules, laws, rings."""

from __future__ import annotations

import numpy as np
import pytest

import sgb_core as sgb
from sgb_core.arrays import Floats
from sgb_core.curves.profile import JointRule, Profile
from sgb_core.curves.segment import Segment
from sgb_core.design.tracing.result import distances
from sgb_core.document.edits.stroke import StrokeKind, draw_stroke, seen
from sgb_core.surfaces.laws.law import Law

REACH, TOLERANCE = 3.0, 0.5
WALL = [
    [[30, 0], [30, 25], [60, 40], [40, 60]],
    [[40, 60], [30, 70], [30, 80], [35, 100]],
]


def jar(rule: str = "G1") -> sgb.Document:
    return sgb.Document(Profile.of([Segment(points) for points in WALL], [rule]))


def shaky(points: Floats, size: float = 0.15, seed: int = 1) -> Floats:
    noise = np.random.default_rng(seed).normal(0.0, size, points.shape)
    noise[[0, -1]] = 0.0
    return points + noise


def along(profile: Profile, low: float, high: float, count: int = 60) -> Floats:
    places = np.linspace(low, high, count)
    numbers = np.minimum(places.astype(int), len(profile) - 1)
    return np.array([profile.point(k, p - k) for k, p in zip(numbers, places, strict=True)])


def drawn(document: sgb.Document, points: Floats) -> tuple[sgb.Document, StrokeKind]:
    stroke = seen(document.profile, points, REACH)
    return draw_stroke(document, stroke, TOLERANCE, REACH), stroke.kind


def test_a_stroke_elsewhere_is_a_whole_profile_from_foot_to_rim_with_poles() -> None:
    angle = np.linspace(np.pi / 2, -np.pi / 2, 90)
    circle = np.stack([70 * np.cos(angle), 150 + 70 * np.sin(angle)], axis=1)
    for side in (1.0, -1.0):
        found, kind = drawn(jar(), shaky(circle) * (side, 1.0) + (0.8, 0.0))
        assert kind is StrokeKind.WHOLE
        profile = found.profile
        assert len(profile) <= 3
        assert profile.segments[0].points[0].tolist() == pytest.approx([0.0, 80.0], abs=0.5)
        assert profile.segments[-1].points[3, 0] == 0.0
        assert float(distances(profile, circle + np.array([side * 0.8, 0.0])).max()) < 1.0 + 0.8


@pytest.mark.parametrize("backwards", [False, True])
@pytest.mark.parametrize("at_start", [False, True])
def test_a_stroke_from_an_end_goes_on_smoothly(backwards: bool, at_start: bool) -> None:
    before = jar()
    segment = before.profile.segments[0 if at_start else -1]
    end = segment.points[0] if at_start else segment.points[3]
    way = -segment.start_tangent() if at_start else segment.end_tangent()
    side = np.array([way[1], -way[0]])
    t = np.linspace(0.0, 1.0, 40)[:, None]
    stroke = shaky(end + 60 * t * way + 25 * t**2 * side)
    found, kind = drawn(before, stroke[::-1] if backwards else stroke)
    assert kind is StrokeKind.ON
    profile, count = found.profile, len(found.profile) - 2
    assert count >= 1
    kept = profile.segments[count:] if at_start else profile.segments[:2]
    assert kept == before.profile.segments
    joint = found.joints[count - 1 if at_start else 1]
    assert joint.rule is JointRule.G1
    assert joint.holds
    assert float(distances(profile, stroke).max()) < 3.0 * TOLERANCE


def test_a_stroke_that_leaves_at_an_angle_leaves_a_corner() -> None:
    before = jar()
    stroke = np.linspace([35, 100], [80, 100], 30)
    found, kind = drawn(before, shaky(stroke))
    assert kind is StrokeKind.ON
    assert found.profile.rules[1] is JointRule.G0


def test_a_part_is_redrawn_and_the_rest_stays() -> None:
    before = jar()
    old = before.profile
    path = along(old, 0.3, 0.8)
    bulge = np.sin(np.linspace(0.0, np.pi, len(path)))[:, None] * (8.0, 0.0)
    found, kind = drawn(before, shaky(path + bulge))
    assert kind is StrokeKind.PART
    profile = found.profile
    assert profile.segments[-1] == old.segments[1]
    outside = np.concatenate([along(old, 0.0, 0.28), along(old, 0.82, 2.0)])
    assert float(distances(profile, outside).max()) < 1e-6
    assert float(distances(profile, path + bulge).max()) < 3.0 * TOLERANCE
    assert profile.rules[-1] is JointRule.G1
    assert all(joint.holds for joint in found.joints)
    backwards, _ = drawn(before, shaky(path + bulge)[::-1])
    assert float(distances(backwards.profile, path + bulge).max()) < 3.0 * TOLERANCE


def test_a_part_between_joints_keeps_them_and_laws_of_others_follow() -> None:
    law = Law("omega", "raised-cosine", 0.5, 1.0, (1,))
    before = sgb.edits.set_variation(jar(), [law])
    old = before.profile
    path = along(old, 0.0, 1.0)
    dent = np.sin(np.linspace(0.0, np.pi, len(path)))[:, None] * (-10.0, 0.0)
    found, kind = drawn(before, shaky(path + dent))
    assert kind is StrokeKind.PART
    profile = found.profile
    assert profile.segments[-1] == old.segments[1]
    assert profile.segments[0].points[0].tolist() == [30.0, 0.0]
    assert found.variation[0].segments == (len(profile) - 1,)


def test_a_part_of_a_ring_is_redrawn() -> None:
    parts = [
        [[60, 0], [60, 20], [20, 20], [20, 0]],
        [[20, 0], [20, -20], [60, -20], [60, 0]],
    ]
    ring = Profile.of([Segment(part) for part in parts], ["G1", "G1"], closed=True)
    before = sgb.Document(ring)
    path = along(ring, 0.25, 0.75)
    bulge = np.sin(np.linspace(0.0, np.pi, len(path)))[:, None] * (0.0, 9.0)
    found, kind = drawn(before, shaky(path + bulge, 0.05))
    assert kind is StrokeKind.PART
    assert found.profile.closed
    assert float(distances(found.profile, path + bulge).max()) < 3.0 * TOLERANCE
    half = draw_stroke(before, seen(ring, along(ring, 1.0, 2.0), REACH), TOLERANCE, REACH)
    assert half.profile.closed
    assert float(distances(half.profile, along(ring, 0.0, 2.0)).max()) < 3.0 * TOLERANCE


def test_what_is_no_line_is_refused() -> None:
    stroke = seen(None, [(0.0, 0.0), (0.0, 50.0)], REACH)
    with pytest.raises(sgb.edits.EditError, match="axis"):
        draw_stroke(jar(), stroke, TOLERANCE, REACH)
