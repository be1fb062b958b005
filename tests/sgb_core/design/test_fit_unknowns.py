"""The vector of a fit: exact slopes, vectors there and back, symmetric chains."""

import numpy as np
import pytest

from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import Segment, ShapeParameters
from sgb_core.design.fit_unknowns import Unknowns
from sgb_core.design.target_curves import SuperellipseArc

SPHERE = SuperellipseArc(1.0, 1.0, 1.0)
ONION = SuperellipseArc(0.7, 1.1, 0.9, exponent=2.5)
TORUS = SuperellipseArc(1.0, 1.0, 1.0, radius=4.0)


def chain(count: int, rule: str, closed: bool = False) -> Profile:
    """Return a jagged chain from pole to pole, or around the torus's circle."""
    rng = np.random.default_rng(count)
    angle = (
        np.linspace(0.0, 2.0 * np.pi, count + 1) if closed else np.linspace(-1.57, 1.57, count + 1)
    )
    ends = np.stack([np.cos(angle) + 4.0 * closed, 1.0 + np.sin(angle)], axis=1)
    if closed:
        ends[-1] = ends[0]
    inner = rng.normal(0.0, 0.1, (count, 2, 2))
    segments = [
        Segment(
            np.array([p, p + (q - p) / 3 + i, p + 2 * (q - p) / 3 + j, q]),
            ShapeParameters(1, 3, 1, 0.5),
        )
        for p, q, (i, j) in zip(ends[:-1], ends[1:], inner, strict=True)
    ]
    return Profile(tuple(segments), (rule,) * (count if closed else count - 1), closed)


CASES = [
    (chain(1, "G1"), SPHERE),
    (chain(3, "G1"), ONION),
    (chain(4, "G0"), SPHERE),
    (chain(2, "G1", True), TORUS),
    (chain(3, "G0", True), TORUS),
]


@pytest.mark.parametrize(("profile", "target"), CASES)
@pytest.mark.parametrize(("keep", "slide"), [(False, False), (True, True)])
def test_slopes_are_those_of_differences(profile, target, keep, slide):
    unknowns = Unknowns(profile, target, True, keep, slide)
    vector = np.clip(unknowns.start + 0.01, *np.transpose(unknowns.bounds))
    step = 1e-6 * np.eye(len(vector))
    ahead = [unknowns.distances(vector + move) for move in step]
    back = [unknowns.distances(vector - move) for move in step]
    differences = (np.array(ahead) - np.array(back)).T / 2e-6
    np.testing.assert_allclose(unknowns.slopes(vector), differences, atol=2e-7)


@pytest.mark.parametrize(("profile", "target"), CASES)
def test_polygons_are_their_own_mirror_image(profile, target):
    unknowns = Unknowns(profile, target, True, False)
    vector = unknowns.scattered(np.random.default_rng(0))
    points = unknowns.profile(vector).control_points
    mirrored = points[::-1, ::-1] * (1.0, -1.0) + (0.0, 2.0 * target.centre)
    turns = [np.roll(mirrored, k, axis=0) for k in range(len(points) if profile.closed else 1)]
    assert min(np.abs(points - turned).max() for turned in turns) < 1e-12


def test_unsymmetric_rules_are_searched_without_symmetry():
    profile = Profile(chain(3, "G1").segments, ("G1", "G0"))
    free = Unknowns(profile, SPHERE, True, False)
    bound = Unknowns(chain(3, "G1"), SPHERE, True, False)
    assert len(free.start) > 1.5 * len(bound.start)
    kept = free.profile(free.start)
    inner = kept.control_points[2, 1:3]
    np.testing.assert_allclose(inner, profile.control_points[2, 1:3], atol=1e-12)
