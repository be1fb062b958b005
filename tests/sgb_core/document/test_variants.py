"""Variants: each keeps all locks and rules, and differs from the others."""

from dataclasses import replace
from itertools import combinations

import numpy as np
import pytest
from scipy.integrate import quad

import resources
import sgb_core as sgb
from sgb_core.curves.continuity import measure_joints
from sgb_core.curves.segment import PARAMETER_RANGES
from sgb_core.design.demands.chain import Chain
from sgb_core.design.locks.hold import Holder
from sgb_core.design.locks.null_space import displacements, free_directions
from sgb_core.document.dimensions import missed_locks
from sgb_core.document.errors import EditError
from sgb_core.document.file import project_file
from sgb_core.document.lock_plan import plan_of
from sgb_core.document.variants import Free, Swept, free_variants, parameter_variants, shared
from sgb_core.findings.words import say
from tests.sgb_core.design.locks.samples import locked, pot, wavy

KINDS = [(), ("capacity", "rim_diameter"), ("volume", "height", "max_diameter", "foot_diameter")]


def volume(document):
    """π ∫ r² dh of the drawn profile, by adaptive quadrature of its points and derivatives."""
    total = 0.0
    for segment in document.profile.segments:

        def ring(s, segment=segment):
            at = np.array(s)
            return float(segment.point(at)[0] ** 2 * segment.derivative(at)[1])

        total += quad(ring, 0.0, 1.0, epsabs=1e-12, epsrel=1e-12)[0]
    return np.pi * total


@pytest.mark.parametrize("free", list(Free))
@pytest.mark.parametrize("kinds", KINDS)
def test_all_keep_locks_and_rules_and_the_fairest_comes_first(kinds, free):
    document = locked(pot(5), *kinds)
    found = free_variants(document, free, 8)
    assert len(found) == 8
    assert [each.energy for each in found] == sorted(each.energy for each in found)
    for each in found:
        made = each.document
        assert missed_locks(made) == ()
        assert all(report.holds for report in measure_joints(made.profile))
        assert made.profile.rules == document.profile.rules
        assert made.solid == document.solid
        if "capacity" in kinds:
            assert made.body().capacity == pytest.approx(document.body().capacity, rel=1e-8)
            rims = [d.profile.control_points[-1, 3, 0] for d in (made, document)]
            assert rims[0] == pytest.approx(rims[1], abs=1e-7)
        if "volume" in kinds:
            assert volume(made) == pytest.approx(volume(document), rel=1e-8)
        if free is Free.SHAPE:
            points = document.profile.control_points
            assert made.profile.control_points.tobytes() == points.tobytes()
    curves = [each.document.profile.sample(17) for each in found] + [document.profile.sample(17)]
    for one, other in combinations(curves, 2):
        assert np.abs(one - other).max() > 1e-3 * document.profile.size


@pytest.mark.parametrize("name", ["vase", "tower", "ring", "teapot", "lantern"])
def test_presets_have_variants_that_break_no_rule(name):
    document = project_file.loads(resources.load_preset(name))
    held = [report.holds for report in measure_joints(document.profile)]
    found = free_variants(document, count=6)
    assert found
    for each in found:
        now = [report.holds for report in measure_joints(each.document.profile)]
        assert all(new for old, new in zip(held, now, strict=True) if old)
        assert (
            project_file.loads(project_file.dumps(each.document)).profile == each.document.profile
        )


def test_directions_are_seen_by_no_equation_and_come_by_how_far_they_move_the_curve():
    document = locked(pot(4), "capacity", "height", "rim_diameter")
    plan = plan_of((), document, document)
    holder = Holder(plan.columns, plan.joints, plan.locks, plan.setting)
    columns, chain = plan.columns, plan.start
    moved = displacements(chain, columns)
    directions, reach = free_directions(holder.slopes(chain), moved, columns.cost, 6)
    assert len(directions) == 6
    assert (np.diff(reach) <= 0.0).all()
    np.testing.assert_allclose(np.linalg.norm(directions * columns.cost, axis=1), 1.0, rtol=1e-9)
    step = 1e-6
    for direction, far in zip(directions, reach, strict=True):
        ends = []
        for sign in (step, -step):
            flat = chain.blocks.ravel() + columns.spread(sign * direction, chain.blocks.size)
            ends.append(chain.with_blocks(flat.reshape(chain.blocks.shape)))
        assert np.abs(holder.missed(ends[0]) - holder.missed(ends[1])).max() < 1e-4 * step
        assert far == pytest.approx(reached(chain, *ends) / (2.0 * step), rel=1e-4)


def reached(chain: Chain, one: Chain, other: Chain) -> float:
    """How far two chains lie apart along the normals of a third, at equal steps of s."""
    s = np.linspace(0.0, 1.0, 9)
    powers = np.stack([s**0 * (1 - s) ** 4, 4 * s * (1 - s) ** 3, 6 * (s * (1 - s)) ** 2])
    rows = np.stack([*powers, 4 * s**3 * (1 - s), s**4], axis=1)
    apart = np.einsum("sq,nqk->nsk", rows, one.quartics - other.quartics)
    legs = np.diff(chain.quartics, axis=1)
    cubic = np.stack([(1 - s) ** 3, 3 * s * (1 - s) ** 2, 3 * s**2 * (1 - s), s**3], axis=1)
    tangents = np.einsum("sq,nqk->nsk", cubic, legs)
    normals = np.stack([-tangents[..., 1], tangents[..., 0]], axis=-1)
    normals /= np.linalg.norm(normals, axis=-1, keepdims=True)
    return float(np.sqrt(((apart * normals).sum(axis=-1) ** 2).mean()))


def test_parameters_take_equal_steps_of_their_ranges_and_locks_hold():
    document = locked(pot(4), "capacity")
    found = parameter_variants(document, [Swept(1, "lambda2"), Swept(2, "omega")], 12)
    assert found
    steps = [
        np.linspace(*PARAMETER_RANGES["lambda2"], 4).tolist(),
        np.linspace(*PARAMETER_RANGES["omega"], 3).tolist(),
    ]
    assert len({each.values for each in found}) == len(found)
    for each in found:
        first, second = each.values
        assert first in steps[0]
        assert second in steps[1]
        assert each.document.profile[1].shape.lambda2 == first
        assert each.document.profile[2].shape.omega == second
        assert missed_locks(each.document) == ()
    one = parameter_variants(sgb.Document(wavy(3)), [Swept(0, "omega")], 5)
    assert sorted(each.values[0] for each in one) == [0.0, 0.25, 0.5, 0.75, 1.0]


def test_a_document_without_freedom_is_refused():
    document = sgb.Document(sgb.Profile.of([sgb.line((10, 0), (10, 60))]))
    with pytest.raises(EditError, match="nothing is free"):
        free_variants(document)


def test_what_all_keep_is_said_in_one_line():
    document = locked(pot(4), "rim_diameter", "capacity")
    words = say(shared(document))
    assert words.startswith("all keep Rim diameter ")
    assert " mm, Capacity " in words
    assert words.endswith(" ml, G1 at 3 joints")
    bare = replace(document, dimensions=(), profile=wavy(1))
    assert say(shared(bare)) == "no lock and no joint's rule is to be kept"
