"""The fairest curves of other kinds: against independent searches, with joints and locks kept."""

from __future__ import annotations

from itertools import pairwise
from math import comb

import numpy as np
import pytest
from scipy.optimize import minimize

import sgb_core as sgb
from sgb_core.curves.profile import Profile
from sgb_core.design.best_curves import best_curves
from sgb_core.design.comparison import Compared, Kind
from sgb_core.document import best_curves as of_documents
from sgb_core.findings.fairing import JointInTheWay
from tests.sgb_core.design.fairing import chains
from tests.sgb_core.design.locks.samples import locked, pot
from tests.sgb_core.surfaces.chains import TOWER, chain

FIGURE_2 = [[[0.2, 0.2], [0.9, 0.0], [0.9, 1.0], [0.2, 0.8]]]
S = np.linspace(0.0, 1.0, 201)


def by_kind(profile: Profile) -> dict[Kind, Compared]:
    return {each.kind: each for each in best_curves(profile)}


def bezier(points: np.ndarray) -> np.ndarray:
    degree = len(points) - 1
    rows = [comb(degree, k) * S**k * (1 - S) ** (degree - k) for k in range(degree + 1)]
    return np.stack(rows, axis=1) @ points


def least(points: np.ndarray, quartic: bool) -> float:
    """Return the least ∫ κ² dl with the ends and their tangents kept, from several starts."""
    first, last = points[1] - points[0], points[2] - points[3]
    rng = np.random.default_rng(1)

    def energy(x: np.ndarray) -> float:
        q1, q3 = points[0] + x[0] * first, points[3] + x[1] * last
        if not quartic:
            # A cubic raised to the fourth degree.
            q1, q3 = points[0] + 0.75 * x[0] * first, points[3] + 0.75 * x[1] * last
            q2 = (points[0] + points[3] + x[0] * first + x[1] * last) / 2
        else:
            q2 = x[2:]
        path = np.stack([points[0], q1, q2, q3, points[3]])
        (r1, h1), (r2, h2) = ((rows @ path).T for rows in chains.ROWS[1:3])
        bend = (r1 * h2 - h1 * r2) ** 2 / np.hypot(r1, h1) ** 5
        value = float(chains.WEIGHTS @ bend)
        return value if np.isfinite(value) else 1e30

    middle = (points[1] + points[2]) / 2
    # Points slide outwards by the size at most.
    size = np.hypot(*np.ptp(points, axis=0))
    farthest = [1 + size / np.hypot(*leg) for leg in (first, last)]
    found = []
    for _ in range(6):
        start = np.concatenate([rng.uniform(0.4, 1.2, 2), middle + 0.1 * rng.normal(size=2)])
        bounds = [*((0.02, most) for most in farthest), (None, None), (None, None)]
        many = 4 if quartic else 2
        found.append(minimize(energy, start[:many], bounds=bounds[:many], method="L-BFGS-B").fun)
    return float(min(found))


@pytest.mark.parametrize("points", [TOWER, [[[1, 0], [2, 1], [2, 2], [1, 3]]]])
def test_they_are_as_fair_as_an_independent_search_finds(points) -> None:
    profile = Profile.of(chain(points, (4, 3, 4, 2 / 3)).segments, ["G1"] * (len(points) - 1))
    found = by_kind(profile)
    for kind, quartic in ((Kind.BEST_CUBIC, False), (Kind.BEST_QUARTIC, True)):
        other = sum(least(np.array(each, float), quartic) for each in points)
        assert found[kind].energy <= other * (1 + 1e-4)
    energies = [found[kind].energy for kind in (Kind.BEST_QUARTIC, Kind.FREED, Kind.FAIREST)]
    # Each may do what the one after it may: alike, they differ by rounding.
    assert all(less <= more * (1 + 1e-12) for less, more in pairwise(energies))
    assert found[Kind.FREED].energy <= found[Kind.BEST_CUBIC].energy * (1 + 1e-6)


def test_the_papers_figure_by_its_shape_alone_and_the_best_cubic() -> None:
    profile = Profile.of(chain(FIGURE_2, (4, 3, 4, 0.6)).segments)
    found = by_kind(profile)
    assert found[Kind.FAIREST].energy == pytest.approx(9.74, rel=5e-4)
    assert np.array_equal(found[Kind.FAIREST].polygons, profile.control_points)
    assert found[Kind.BEST_CUBIC].energy == pytest.approx(least(np.array(FIGURE_2[0]), False))


def test_curves_are_those_of_their_polygons_between_the_same_ends_and_tangents() -> None:
    profile = Profile.of(chain(TOWER, (4, 3, 4, 2 / 3)).segments, ["G1", "G1"])
    found = by_kind(profile)
    for kind, many in ((Kind.BEST_CUBIC, 4), (Kind.BEST_QUARTIC, 5)):
        each = found[kind]
        assert each.polygons.shape == (3, many, 2)
        for own, curve, before in zip(
            each.polygons, each.points, profile.control_points, strict=True
        ):
            assert curve == pytest.approx(bezier(own), abs=1e-12)
            assert np.array_equal(own[[0, -1]], before[[0, 3]])
            for leg, old in (
                (own[1] - own[0], before[1] - before[0]),
                (own[-2] - own[-1], before[2] - before[3]),
            ):
                cross = leg[0] * old[1] - leg[1] * old[0]
                assert abs(cross) < 1e-12
                assert leg @ old > 0.0


def test_rules_hold_or_the_joint_in_the_way_is_named() -> None:
    c1 = by_kind(chains.rounded_chain(0, 3, "C1"))
    for kind, degree in ((Kind.BEST_CUBIC, 3), (Kind.BEST_QUARTIC, 4)):
        for before, after in zip(c1[kind].polygons[:-1], c1[kind].polygons[1:], strict=True):
            speeds = degree * (before[-1] - before[-2]), degree * (after[1] - after[0])
            assert speeds[0] == pytest.approx(speeds[1], rel=1e-8, abs=1e-9)
    # From a line straight on, and back beside it: a cubic between such legs bends at its end.
    points = [[[1, -3], [1, -2], [1, -1], [1, 0]], [[1, 0], [1, 1], [2, 2], [2, 3]]]
    found = by_kind(Profile.of(chain(points, (1, 6, 1, 1)).segments, ["G2"]))
    assert found[Kind.FAIREST].missed is None
    cubic = found[Kind.BEST_CUBIC]
    assert isinstance(cubic.missed, JointInTheWay)
    assert cubic.missed.rule == "G2"
    assert cubic.energy is None


def test_locks_are_kept_and_locked_points_stay() -> None:
    document = locked(pot(3), "volume", "max_diameter")
    document = sgb.edits.add_dimension(document, sgb.Dimension("point", points=((1, 1),)))
    document = sgb.edits.set_lock(document, 2, True)
    free = {each.kind: each for each in of_documents.best_curves(pot(3))}
    found = {each.kind: each for each in of_documents.best_curves(document)}
    for kind, each in found.items():
        assert each.missed is None
        if kind is not Kind.BEST_QUARTIC:
            assert np.array_equal(each.polygons[1, 1], document.profile[1].points[1])
        assert each.energy >= free[kind].energy * (1.0 - 1e-9)
    # The cubic is a profile of its own, and measured as one.
    cubic = found[Kind.BEST_CUBIC]
    profile = document.profile.with_segments(sgb.Segment(points) for points in cubic.polygons)
    own = sgb.Document(profile)
    assert own.volume == pytest.approx(document.volume, rel=1e-9)
    assert 2.0 * own.profile.bounds()[1][0] == pytest.approx(
        2.0 * document.profile.bounds()[1][0], rel=1e-9
    )


def test_under_laws_the_section_at_the_start_is_compared() -> None:
    law = sgb.Law("omega", "cosine", 0.0, 0.8, count=3)
    document = sgb.edits.add_law(locked(pot(3), "volume"), law)
    section = document.surface.shape_at(document.surface.start)
    own = sgb.Document(section)
    for each in of_documents.best_curves(document):
        if each.kind is Kind.BEST_CUBIC:
            made = section.with_segments(sgb.Segment(points) for points in each.polygons)
            assert sgb.Document(made).volume == pytest.approx(own.volume, rel=1e-9)
