"""Fairing over shape parameters: known values, independent searches, rules, ends, laws."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import resources
from sgb_core.curves.continuity import JointClass, measure_joints
from sgb_core.curves.profile import JointRule, Profile
from sgb_core.curves.segment import Segment, ShapeParameters
from sgb_core.design.fairing.energy import Energy
from sgb_core.design.fairing.fair import fair
from sgb_core.design.fairing.findings import Keep, KeptRule, LocksExcludeError, Status
from sgb_core.design.fairing.measure import profile_energy
from sgb_core.document.file import project_file
from sgb_core.findings.fairing import JointInTheWay
from sgb_core.surfaces.laws.law import Law
from sgb_core.surfaces.measures import bending_energy, volume
from sgb_core.surfaces.revolution import RevolutionSurface
from tests.sgb_core.curves.strategies import segments
from tests.sgb_core.design.fairing import chains
from tests.sgb_core.surfaces.chains import TOWER, chain

FIGURE_2 = [[[0.2, 0.2], [0.9, 0.0], [0.9, 1.0], [0.2, 0.8]]]


def faired(profile: Profile, kind: Energy = Energy.BENDING, **asked: object):
    return fair(RevolutionSurface(profile), kind, **asked)


def outcome(profile: Profile):
    try:
        return faired(profile)
    except LocksExcludeError as error:
        return error.finding


def same_points(before: Profile, after: Profile) -> bool:
    return before.control_points.tobytes() == after.control_points.tobytes()


def broken(before: Profile, after: Profile) -> list[int]:
    pairs = zip(measure_joints(before), measure_joints(after), strict=True)
    return [old.joint for old, new in pairs if old.holds and not new.holds]


@pytest.mark.parametrize(
    ("points", "shape", "rules", "before", "after", "cubic"),
    [
        (TOWER, (4, 3, 4, 2 / 3), ["G1", "G1"], 7.546, 2.198, 2.50),
        (FIGURE_2, (4, 3, 4, 0.6), [], 13.85, 9.74, 10.2),
    ],
)
def test_the_papers_figures_become_as_fair_as_known(
    points, shape, rules, before, after, cubic
) -> None:
    profile = Profile.of(chain(points, shape).segments, rules)
    result = faired(profile)
    assert result.before == pytest.approx(before, rel=5e-4)
    assert result.after == pytest.approx(after, rel=5e-4)
    assert bending_energy(chain(points)) == pytest.approx(cubic, rel=5e-3)
    assert bending_energy(result.profile) == pytest.approx(result.after, rel=1e-10)
    assert same_points(profile, result.profile)
    assert result.status is Status.FAIRER
    assert [rule.rule for rule in result.kept] == rules
    for change in result.moved:
        old, new = (p.segments[change.segment].shape for p in (profile, result.profile))
        assert getattr(old, change.parameter) == change.before
        assert getattr(new, change.parameter) == change.after != change.before


@pytest.mark.parametrize(
    ("name", "kind"),
    [(preset.name, Energy.BENDING) for preset in resources.presets()]
    + [(name, kind) for name in ("goblet", "ring", "sphere") for kind in list(Energy)[1:]],
)
def test_every_preset_becomes_fairer_and_keeps_its_rules_and_points(name, kind) -> None:
    document = project_file.loads(resources.load_preset(name))
    result = fair(document.surface, kind)
    assert same_points(document.profile, result.profile)
    assert broken(document.profile, result.profile) == []
    if result.before is not None:
        assert result.after < result.before
    again = fair(replace(document, profile=result.profile).surface, kind)
    assert again.moved == ()
    assert again.profile is result.profile or again.profile == result.profile


@pytest.mark.parametrize(
    ("name", "kind"), [("tower", kind) for kind in Energy] + [("vase", Energy.BENDING)]
)
def test_presets_become_as_fair_as_an_independent_search_finds(name, kind) -> None:
    profile = project_file.loads(resources.load_preset(name)).profile
    result = faired(profile, kind)
    for before, after in zip(profile.segments, result.profile.segments, strict=True):
        own = chains.energy(kind, after.points, np.array(after.shape.leg_fractions))
        other = chains.fairest_alone(kind, before.points, starts=3)
        assert own <= other * (1 + 1e-4) + 1e-9


@pytest.mark.parametrize("kind", Energy)
@pytest.mark.parametrize("seed", range(2))
def test_random_segments_become_as_fair_as_an_independent_search_finds(seed, kind) -> None:
    rng = np.random.default_rng(seed)
    points = rng.normal(size=(4, 2)) * (1.0, 1.5)
    points[:, 0] = np.abs(points[:, 0]) + 0.2
    result = faired(Profile((Segment(points),)), kind)
    after = result.profile.segments[0]
    own = chains.energy(kind, points, np.array(after.shape.leg_fractions))
    other = chains.fairest_alone(kind, points, starts=5, seed=seed)
    assert own <= other * (1 + 1e-4)


def _g2_equations(profile: Profile):
    legs = np.diff(profile.control_points, axis=1)
    turns = legs[:, :-1, 0] * legs[:, 1:, 1] - legs[:, :-1, 1] * legs[:, 1:, 0]
    lengths = np.hypot(legs[..., 0], legs[..., 1])

    def residuals(f: np.ndarray) -> np.ndarray:
        last = f[:-1, 1] / f[:-1, 2] ** 2 * turns[:-1, 1] / lengths[:-1, 2] ** 3
        first = (1 - f[1:, 1]) / f[1:, 0] ** 2 * turns[1:, 0] / lengths[1:, 0] ** 3
        return last - first

    return residuals


def _c1_equations(profile: Profile):
    lengths = np.hypot(*np.diff(profile.control_points, axis=1).transpose(2, 0, 1))
    return lambda f: f[:-1, 2] * lengths[:-1, 2] - f[1:, 0] * lengths[1:, 0]


@pytest.mark.parametrize(
    ("rule", "equations", "kind", "seed"),
    [
        ("C1", _c1_equations, Energy.BENDING, 0),
        ("G2", _g2_equations, Energy.SURFACE, 2),
    ],
)
def test_coupled_chains_become_as_fair_as_an_independent_search_finds(
    seed, rule, equations, kind
) -> None:
    profile = chains.rounded_chain(seed, 2, rule)
    result = faired(profile, kind)
    assert all(report.holds for report in measure_joints(result.profile))
    assert same_points(profile, result.profile)
    assert result.kept == tuple(KeptRule(k, JointRule(rule)) for k in range(1))
    own = sum(
        chains.energy(kind, s.points, np.array(s.shape.leg_fractions))
        for s in result.profile.segments
    )
    other = chains.fairest_together(kind, profile, equations(profile), starts=2, seed=seed)
    assert own <= other * (1 + 1e-4)
    # A rule costs something: without it the same points become fairer.
    free = faired(Profile(profile.segments), kind)
    assert free.after <= result.after * (1 + 1e-9)


@given(segments(), st.sampled_from(Energy))
@settings(max_examples=25)
def test_nothing_becomes_less_fair_and_nothing_is_not_a_number(segment, kind) -> None:
    profile = Profile((segment,))
    result = faired(profile, kind)
    assert same_points(profile, result.profile)
    if result.before is not None:
        assert result.after is not None
        assert result.after <= result.before * (1 + 1e-12)
    if result.status is Status.ENDLESS:
        assert result.endless == (0,)
        assert result.after is None
        assert result.moved == ()
    else:
        assert result.after is not None


@pytest.mark.parametrize(
    ("rule", "count", "seed", "possible"),
    [("C1", 4, 2, True), ("G2", 2, 0, True), ("G2", 4, 0, True), ("G2", 4, 2, False)],
)
def test_rules_are_kept_or_the_joint_in_the_way_is_named(rule, count, seed, possible) -> None:
    profile = chains.smooth_chain(seed, count, rule)
    result = outcome(profile)
    if possible:
        assert all(report.holds for report in measure_joints(result.profile))
        return
    assert isinstance(result, JointInTheWay)
    assert result.rule == rule
    assert result.missed > 1e-9


def test_a_middle_segment_cannot_turn_both_ways_without_curvature() -> None:
    # At both joints the polygons turn to different sides: no curvature there, so Q2 of the
    # middle segment would have to lie on P1 and on P2.
    points = [
        [[1, 0], [2, 0], [3, 0.5], [4, 2]],
        [[4, 2], [5, 3.5], [6, 3.5], [7, 2]],
        [[7, 2], [8, 0.5], [9, 0], [10, 0]],
    ]
    profile = Profile.of(chain(points).segments, ["G2", "G2"])
    with pytest.raises(LocksExcludeError) as caught:
        faired(profile)
    assert caught.value.finding.rule == "G2"
    assert caught.value.finding.joint in (0, 1)
    one = faired(Profile.of(profile.segments, ["G2", "G1"]))
    assert measure_joints(one.profile)[0].measured is JointClass.G2
    assert one.profile.segments[0].shape.leg_fractions[1] == 0.0
    assert one.profile.segments[1].shape.leg_fractions[1] == 1.0


def test_a_rule_that_no_fraction_restores_is_said_and_stands_in_nobodys_way() -> None:
    kinked = [[[1, 0], [2, 0], [3, 1], [3, 2]], [[3, 2], [4, 2], [4, 4], [3, 5]]]
    profile = Profile.of(chain(kinked, (4, 3, 4, 0.5)).segments, ["G1"])
    result = faired(profile)
    assert result.unmet == (KeptRule(0, JointRule.G1),)
    assert result.kept == ()
    assert result.after < result.before


@pytest.mark.parametrize("kind", [Energy.BENDING, Energy.VARIATION])
def test_where_the_volume_is_kept_the_fairest_is_found_at_once(kind) -> None:
    # From the printed shape one search ends in a valley that is not the lowest.
    start = RevolutionSurface(chain(TOWER, (4, 3, 4, 2 / 3)))
    found = fair(start, kind, keep=[Keep.VOLUME])
    assert volume(replace(start, profile=found.profile)) == pytest.approx(volume(start), rel=1e-9)
    again = fair(replace(start, profile=found.profile), kind, keep=[Keep.VOLUME])
    assert again.after == pytest.approx(found.after, rel=1e-9)


def test_what_is_not_chosen_stays() -> None:
    profile = Profile.of(chain(TOWER, (4, 3, 4, 2 / 3)).segments, ["G1", "G1"])
    result = faired(profile, segments=[1])
    assert {change.segment for change in result.moved} == {1}
    assert result.profile.segments[0] is profile.segments[0]
    assert result.profile.segments[2] is profile.segments[2]
    whole = faired(profile)
    assert result.profile.segments[1] == whole.profile.segments[1]
    for wrong in (3, -1):
        with pytest.raises(IndexError, match="no segment"):
            faired(profile, segments=[wrong])


def test_omega_stays_where_the_best_is_in_its_reach() -> None:
    wide = Profile.of(chain(TOWER, (1, 3, 1, 1)).segments)
    moved = {change.parameter for change in faired(wide).moved}
    assert "omega" not in moved
    narrow = Profile.of(chain(TOWER, (1, 3, 1, 0)).segments)
    assert {change.after for change in faired(narrow).moved if change.parameter == "omega"} == {1.0}


def test_vanishing_ends_are_left_behind() -> None:
    profile = Profile.of(chain(TOWER, (4, 3, 4, 1)).segments, ["G1", "G1"])
    result = faired(profile)
    assert result.before is None
    assert result.after == pytest.approx(2.19797, rel=1e-5)
    assert all(min(s.shape.leg_fractions[::2]) > 0.0 for s in result.profile.segments)


@pytest.mark.parametrize("kind", Energy)
def test_a_leg_without_length_has_its_finite_best(kind) -> None:
    points = np.array([[2, 0], [2, 0], [3, 1], [4, 0]], float)
    profile = Profile((Segment(points),))
    assert profile_energy(profile, kind) is None
    result = faired(profile, kind)
    # Q0, Q2 and Q3 are in line only where Q3 lies on P2.
    assert result.profile.segments[0].shape.leg_fractions[2] == 1.0
    assert result.status is Status.FAIRER
    b = result.profile.segments[0].shape.leg_fractions[1]
    if kind is Energy.VARIATION:
        assert b == pytest.approx(2 / 3, abs=1e-15)
        return
    others = [
        profile_energy(
            Profile((Segment(points, ShapeParameters.from_leg_fractions(0.75, other, 1.0)),)), kind
        )
        for other in np.linspace(0.0, 0.95, 20)
    ]
    assert result.after <= min(others) * (1 + 1e-12)


def test_points_in_one_place_and_lines_stay_as_they_are() -> None:
    point = Segment(np.full((4, 2), 2.0), ShapeParameters(4, 3, 4, 1))
    line = Segment(np.linspace((2, 2), (2, 5), 4), ShapeParameters(4, 3, 4, 1))
    for profile in (Profile((point,)), Profile((line,)), Profile((point, line))):
        result = faired(profile)
        assert result.moved == ()
        assert result.profile == profile
        assert result.after == 0.0


def test_an_apex_has_no_surface_energy_but_the_rest_becomes_fair() -> None:
    points = [[[0, 0], [1, 1], [2, 1], [3, 2]], [[3, 2], [4, 3], [4, 5], [3, 6]]]
    profile = Profile.of(chain(points, (4, 3, 4, 0.5)).segments, ["G1"])
    result = faired(profile, Energy.SURFACE)
    assert result.status is Status.ENDLESS
    assert result.endless == (0,)
    assert result.before is result.after is None
    assert {change.segment for change in result.moved} == {1}


def test_size_unit_and_place_change_nothing() -> None:
    profile = Profile.of(chain(TOWER, (4, 3, 4, 2 / 3)).segments, ["G1", "G1"])
    fractions = [s.shape.leg_fractions for s in faired(profile).profile.segments]
    for factor, shift in ((1e-6, 0.0), (1e6, 0.0), (1.0, 1e6)):
        moved = profile.with_segments(
            s.with_points(s.points * factor + (0.0, shift)) for s in profile.segments
        )
        found = faired(moved)
        after = np.array([s.shape.leg_fractions for s in found.profile.segments])
        assert after == pytest.approx(np.array(fractions), abs=1e-6)
        assert found.after * factor == pytest.approx(2.19797, rel=1e-5)


def test_a_ring_is_faired_all_round() -> None:
    document = project_file.loads(resources.load_preset("ring"))
    for rule in ("G1", "C1", "G2"):
        profile = Profile.of(document.profile.segments, [rule, rule], closed=True)
        result = faired(profile)
        assert all(report.holds for report in measure_joints(result.profile))
        assert result.after < result.before


def test_laws_hold_and_the_section_at_zero_becomes_fair() -> None:
    law = Law("omega", "raised-cosine", 0.5, 1.0, (0, 1))
    profile = Profile.of(chain(TOWER, (4, 3, 4, 0)).segments, ["G1", "G1"])
    surface = RevolutionSurface(profile, laws=(law,))
    result = fair(surface)
    section = surface.profile_at(0.0)
    assert result.before == pytest.approx(bending_energy(section), rel=1e-10)
    after = replace(surface, profile=result.profile)
    assert result.after == pytest.approx(bending_energy(after.profile_at(0.0)), rel=1e-10)
    assert {c.parameter for c in result.moved if c.segment < 2} == {"lambda1", "lambda2", "lambda3"}
    free = fair(replace(surface, laws=()))
    assert free.after < result.after < result.before
    with pytest.raises(ValueError, match="laws"):
        fair(surface, Energy.SURFACE)


def test_where_the_search_runs_into_an_infinite_energy_nothing_moves() -> None:
    """A leg of no length: the fairest would be a point at which the end stands still twice."""
    shape = ShapeParameters(0.0, 0.0, 0.0, 0.0)
    profile = Profile((Segment([(1, 0), (1, 0), (4, 1), (0, 0)], shape),))
    result = faired(profile, Energy.BENDING)
    assert result.status is Status.ENDLESS
    assert (result.endless, result.moved, result.after) == ((0,), (), None)
