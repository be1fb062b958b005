"""Fairing with inner control points: what stays in its place, which way legs point."""

from __future__ import annotations

import numpy as np
import pytest

import sgb_core as sgb
from sgb_core.curves.continuity import measure_joints
from sgb_core.curves.profile import JointRule, Profile
from sgb_core.design.fairing.fair import fair
from sgb_core.design.fairing.findings import Freedom, Keep, KeptRule
from sgb_core.document.dimensions import missed_locks
from sgb_core.document.edits.fair import fair_profile
from sgb_core.surfaces.revolution import RevolutionSurface
from tests.sgb_core.design.fairing import chains
from tests.sgb_core.design.locks.samples import locked, pot


def directions(profile: Profile) -> np.ndarray:
    legs = np.diff(profile.control_points, axis=1)[:, [0, 2]]
    return legs / np.hypot(legs[..., 0], legs[..., 1])[..., None]


@pytest.mark.parametrize("rule", ["G1", "C1", "G2"])
def test_points_buy_fairness_and_ends_and_rules_stay(rule) -> None:
    profile = chains.rounded_chain(1, 3, rule)
    by_shape = fair(RevolutionSurface(profile))
    slid = fair(RevolutionSurface(profile), free=Freedom.POINTS, keep=[Keep.TANGENTS])
    freed = fair(RevolutionSurface(profile), free=Freedom.POINTS)
    assert freed.after < slid.after < by_shape.after
    for each in (slid, freed):
        assert all(report.holds for report in measure_joints(each.profile))
        ends = each.profile.control_points[:, [0, 3]]
        assert np.array_equal(ends, profile.control_points[:, [0, 3]])
    assert directions(slid.profile) == pytest.approx(directions(profile), abs=1e-12)


def test_locked_points_stay_where_they_are() -> None:
    document = locked(pot(4), "rim_diameter")
    for point in ((1, 1), (2, 2)):
        document = sgb.edits.add_dimension(document, sgb.Dimension("point", points=(point,)))
        document = sgb.edits.set_lock(document, len(document.dimensions) - 1, True)
    faired, found = fair_profile(document, free=Freedom.POINTS)
    assert found.after < found.before
    for point in ((1, 1), (2, 2)):
        before, after = (each.profile.control_points[point] for each in (document, faired))
        assert np.array_equal(before, after)
    assert not np.array_equal(
        document.profile.control_points[1, 2], faired.profile.control_points[1, 2]
    )
    assert missed_locks(faired) == ()


def test_a_kink_that_kept_tangents_cannot_mend_is_said_and_in_nobodys_way() -> None:
    bent = [
        sgb.Segment([(1, 0), (2, 0), (3, 1), (3, 2)]),
        sgb.Segment([(3, 2), (4, 2), (4, 4), (3, 5)]),
    ]
    surface = RevolutionSurface(Profile.of(bent, ["G1"]))
    slid = fair(surface, free=Freedom.POINTS, keep=[Keep.TANGENTS])
    assert slid.unmet == (KeptRule(0, JointRule.G1),)
    assert slid.after < slid.before
    # Free points turn their legs, and mend it.
    assert measure_joints(fair(surface, free=Freedom.POINTS).profile)[0].holds


@pytest.mark.parametrize("free", Freedom)
def test_locks_of_bodies_hold_under_a_law_of_the_radius_along_the_height(free) -> None:
    law = sgb.Law("radius", "lobes", 1.0, 1.15, count=5, along=((0.0, 0.0), (0.5, 1.0), (1.0, 0.3)))
    document = sgb.edits.set_shape_parameter(pot(2), 0, "omega", 1.0)
    document = sgb.edits.set_shape_parameter(document, 0, "lambda2", 5.0)
    document = locked(sgb.edits.add_law(document, law), "volume", "rim_diameter")
    faired, found = fair_profile(document, free=free)
    assert found.after < found.before
    assert missed_locks(faired) == ()
    assert faired.volume == pytest.approx(document.volume, rel=1e-8)
    assert faired.variation == document.variation
