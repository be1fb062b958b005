from __future__ import annotations

from math import pi

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import Segment
from sgb_core.surfaces.placement import Placement
from sgb_core.surfaces.revolution import Axis, RevolutionSurface
from tests.sgb_core.surfaces.chains import BALL, CROSSING, PAPER, TOWER, WAVE, chain, surfaces

BOTH = surfaces() | surfaces(laws=True)
INNER = st.floats(0.05, 0.95)


@pytest.mark.parametrize(("axis", "order"), [(Axis.X, "hcs"), (Axis.Y, "shc"), (Axis.Z, "csh")])
def test_the_axes_are_those_of_the_paper(axis: Axis, order: str) -> None:
    profile = chain(TOWER, (2, 1, 3, 0.4))
    s, theta = np.linspace(0, 1, 9)[:, None], np.linspace(-4, 4, 11)
    r, h = np.moveaxis(profile.point(1, s), -1, 0)
    parts = {"h": h + 0 * theta, "c": r * np.cos(theta), "s": r * np.sin(theta)}
    expected = np.stack([parts[letter] for letter in order], axis=-1)
    points = RevolutionSurface(profile, axis).point(1, s, theta)
    np.testing.assert_allclose(points, expected, rtol=1e-14, atol=1e-14)


@settings(max_examples=60)
@given(BOTH, INNER, INNER)
def test_partials_are_the_slopes_of_the_point(
    surface: RevolutionSurface, s: float, share: float
) -> None:
    theta = surface.start + share * surface.sweep
    step = 1e-6
    if any(abs(theta - surface.start - b) < 1e-3 for law in surface.laws for b in law.breaks):
        return
    along, around = surface.partials(0, s, theta)
    for partial, ds, dt in ((along, step, 0.0), (around, 0.0, step)):
        ahead, behind = surface.point(0, s + ds, theta + dt), surface.point(0, s - ds, theta - dt)
        np.testing.assert_allclose(partial, (ahead - behind) / (2 * step), atol=1e-6)


@settings(max_examples=60)
@given(BOTH, INNER, INNER)
def test_the_normal_is_square_to_both_partials(
    surface: RevolutionSurface, s: float, share: float
) -> None:
    theta = surface.start + share * surface.sweep
    normal = surface.normal(0, s, theta)
    assert np.linalg.norm(normal) == pytest.approx(1.0, abs=1e-12)
    along, around = surface.partials(0, s, theta)
    cross = np.cross(around, along)
    length = np.linalg.norm(cross)
    if length > 1e-3:
        sense = -1.0 if surface.flips else 1.0
        np.testing.assert_allclose(normal, sense * cross / length, atol=1e-9)


@settings(max_examples=40)
@given(BOTH)
def test_normals_at_the_ends_are_limits(surface: RevolutionSurface) -> None:
    theta = surface.start + 0.3 * surface.sweep
    normals = surface.normal(0, [0.0, 1.0], theta)
    assert np.isfinite(normals).all()
    np.testing.assert_allclose(np.linalg.norm(normals, axis=-1), 1.0, atol=1e-12)


def test_the_limit_at_a_degenerate_end_is_approached() -> None:
    surface = RevolutionSurface(chain(TOWER, (4, 3, 4, 1)), placement=Placement((20, 0, 5)))
    for end, near in ((0.0, 1e-7), (1.0, 1.0 - 1e-7)):
        exact, close = surface.normal(1, end, 0.7), surface.normal(1, near, 0.7)
        np.testing.assert_allclose(exact, close, atol=1e-5)


@pytest.mark.parametrize("profile", [chain(BALL), chain(BALL).reversed()])
def test_curvatures_of_a_nearly_round_ball(profile: object) -> None:
    surface = RevolutionSurface(profile)
    meridian, parallel = surface.curvatures(0, np.linspace(0, 1, 21), 0.3)
    assert (meridian > 0.3).all()
    assert (parallel > 0.3).all()
    # On the axis the two agree: all directions are alike.
    np.testing.assert_allclose(meridian[[0, -1]], parallel[[0, -1]], rtol=1e-12)
    near = surface.curvatures(0, 1e-6, 0.3)
    np.testing.assert_allclose(near, [meridian[0], parallel[0]], rtol=1e-4)


@given(surfaces(radii=st.floats(0.3, 2.0)), INNER)
def test_curvatures_are_the_second_fundamental_form(surface: RevolutionSurface, s: float) -> None:
    theta, step = surface.start + 0.1, 1e-4
    along, around = surface.partials(0, s, theta)
    if min(np.linalg.norm(along), np.linalg.norm(around)) < 0.2:
        return
    normal = surface.normal(0, s, theta)
    second = [
        (surface.point(0, s + a, theta + b) + surface.point(0, s - a, theta - b)
         - 2 * surface.point(0, s, theta)) / step**2
        for a, b in ((step, 0.0), (0.0, step))
    ]  # fmt: skip
    expected = [
        -(bend @ normal) / (tangent @ tangent)
        for bend, tangent in zip(second, (along, around), strict=True)
    ]
    np.testing.assert_allclose(surface.curvatures(0, s, theta), expected, rtol=1e-3, atol=1e-3)


def test_curvature_limits_where_there_is_no_derivative() -> None:
    degenerate = RevolutionSurface(chain(TOWER, (4, 3, 4, 1)))
    meridian, _ = degenerate.curvatures(0, [0.0, 1.0], 0.0)
    near, _ = degenerate.curvatures(0, [1e-4, 1.0 - 1e-4], 0.0)
    assert np.isinf(meridian).all()
    np.testing.assert_array_equal(np.sign(meridian), np.sign(near))
    cone = RevolutionSurface(chain([[[0, 0], [1, 1], [2, 2], [3, 3]]], (4, 3, 4, 1)))
    meridian, parallel = cone.curvatures(0, [0.0, 1.0], 0.0)
    np.testing.assert_array_equal(meridian, 0.0)
    assert np.isinf(parallel[0])
    assert parallel[1] == pytest.approx(1 / (3 * np.sqrt(2)))


def test_the_section_follows_the_laws() -> None:
    surface = RevolutionSurface(chain(TOWER), start=0.5, laws=(PAPER, WAVE))
    for angle in (0.5, 0.5 + pi, 2.0):
        section = surface.profile_at(angle)
        points = surface.point(2, np.linspace(0, 1, 5), angle)
        r = np.hypot(points[:, 0], points[:, 1])
        np.testing.assert_allclose(r, section.point(2, np.linspace(0, 1, 5))[:, 0], rtol=1e-13)
    assert surface.profile_at(0.5 + pi).segments[0].shape.omega == 1.0
    plain = RevolutionSurface(chain(TOWER))
    assert plain.profile_at(1.0) is plain.profile


def test_beyond_the_axis_the_normal_faces_away_from_it() -> None:
    surface = RevolutionSurface(chain(CROSSING))
    points, normals = (f(0, np.array([0.2, 0.9]), 0.4) for f in (surface.point, surface.normal))
    assert (np.einsum("kx,kx->k", points[:, :2], normals[:, :2]) > 0.0).all()


def test_a_sweep_outside_its_range_is_refused() -> None:
    for sweep in (0.0, -1.0, 7.0, float("nan")):
        with pytest.raises(ValueError, match="sweep"):
            RevolutionSurface(chain(BALL), sweep=sweep)
    assert RevolutionSurface.of_degrees(chain(BALL), sweep_deg=360).is_full_turn
    np.testing.assert_allclose(
        RevolutionSurface.of_degrees(chain(BALL), start_deg=90, sweep_deg=90).angles(2),
        [pi / 2, 0.75 * pi, pi],
    )


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"axis": "q"}, "'q' is not a valid Axis"),
        ({"start": float("nan")}, "start is nan rad; allowed is a finite number"),
        ({"laws": (3,)}, r"laws is \(3,\); allowed is a tuple of Law"),
        ({"profile": 3}, "profile is 3; allowed is a Profile"),
        ({"placement": None}, "placement is None; allowed is a Placement"),
        ({"sweep": 0.0}, "sweep is 0.0 rad"),
    ],
)
def test_a_surface_that_cannot_be_is_refused(change: dict, words: str) -> None:
    profile = Profile.of([Segment([(10, 0), (10, 20), (10, 40), (10, 60)])])
    with pytest.raises(ValueError, match=words):
        RevolutionSurface(**{"profile": profile, **change})


def test_an_axis_may_be_given_by_its_letter() -> None:
    profile = Profile.of([Segment([(10, 0), (10, 20), (10, 40), (10, 60)])])
    assert RevolutionSurface(profile, "x").axis is Axis.X  # type: ignore[arg-type]
