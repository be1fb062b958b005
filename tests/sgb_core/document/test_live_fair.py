"""Live fair: segments beside a moving point keep themselves fair, locks and rules hold."""

import numpy as np
import pytest
from scipy.optimize import minimize

import resources
import sgb_core as sgb
from sgb_core.curves.continuity import measure_joints
from sgb_core.curves.segment import ShapeParameters
from sgb_core.design.fairing.energy import Energy
from sgb_core.design.fairing.measure import profile_energy
from sgb_core.document.dimensions import missed_locks
from sgb_core.document.file import project_file
from sgb_core.document.live_fair import LiveFair, beside
from sgb_core.document.session import Session
from tests.sgb_core.design.locks.samples import locked, pot, wavy


def preset(name):
    """Return a preset as a document."""
    return project_file.loads(resources.load_preset(name))


NAMES = [p.name for p in resources.presets() if len(preset(p.name).profile) > 1]
TICKS = 8


def dragged(document, point, step, *, live, energy=Energy.BENDING):
    """Drag a point by a step, in parts of the size, in some ticks; return all that was seen."""
    session, profile = Session(document), document.profile
    start, way = profile[point[0]].points[point[1]], np.array(step) * profile.size
    refining = LiveFair(beside(profile, [point]), energy) if live else None
    session.begin("drag")
    seen = []
    for part in np.linspace(0.0, 1.0, TICKS + 1)[1:]:
        to = tuple((start + part * way).tolist())
        session.apply(
            lambda d, to=to: sgb.edits.move_point(d, *point, to, keep_rules=True),
            refining=refining,
        )
        seen.append(session.document)
    session.commit()
    seen.append(session.document)
    return session, seen


def fractions(document):
    return np.array([segment.shape.leg_fractions for segment in document.profile.segments])


@pytest.mark.parametrize("name", NAMES)
def test_presets_are_fairer_at_every_place_and_no_other_point_moves(name):
    document = preset(name)
    point = (len(document.profile) // 2, 0)
    session, live = dragged(document, point, (0.02, 0.015), live=True)
    _, plain = dragged(document, point, (0.02, 0.015), live=False)
    chosen = beside(document.profile, [point])
    for fair, bare in zip(live, plain, strict=True):
        assert fair.profile.control_points.tobytes() == bare.profile.control_points.tobytes()
        after, before = (profile_energy(each.profile, Energy.BENDING) for each in (fair, bare))
        assert before is None or after <= before * (1.0 + 1e-9)
        for k in set(range(len(document.profile))) - chosen:
            assert fair.profile[k].shape == bare.profile[k].shape
        kept = [report.holds for report in measure_joints(bare.profile)]
        holds = [report.holds for report in measure_joints(fair.profile)]
        assert all(now for was, now in zip(kept, holds, strict=True) if was)
    assert len(session.history) == 2
    session.undo()
    assert session.document is document


def least_energy(profile, segment, starts=24):
    """The least bending energy of one segment by an optimiser that knows no derivatives."""
    rng = np.random.default_rng(3)
    own = profile[segment]
    unit = profile.size

    def energy(at):
        shape = ShapeParameters.from_leg_fractions(*np.clip(at, 1e-4, 1.0).tolist())
        s, w = np.polynomial.legendre.leggauss(60)
        s, w = 0.5 * (s + 1.0), 0.5 * w
        bent = own.with_shape(shape)
        speed = np.hypot(*bent.derivative(s).T)
        return float(np.sum(w * bent.curvature(s) ** 2 * speed) * unit)

    bounds = [(1e-4, 1.0)] * 3
    return min(
        minimize(energy, rng.uniform(0.1, 0.95, 3), bounds=bounds, method="Nelder-Mead").fun
        for _ in range(starts)
    )


def test_where_the_hand_lets_go_no_independent_search_finds_fairer():
    document = sgb.Document(wavy(4))
    _, seen = dragged(document, (2, 0), (0.06, 0.03), live=True)
    for k in (1, 2):
        alone = sgb.Profile.of([seen[-1].profile[k]])
        found = profile_energy(alone, Energy.BENDING) * seen[-1].profile.size
        assert found <= least_energy(seen[-1].profile, k) * (1.0 + 1e-4)


def test_the_sliders_follow_the_hand_without_a_jump():
    document = sgb.Document(wavy(4))
    _, seen = dragged(document, (2, 0), (0.02, 0.01), live=True)
    steps = np.abs(np.diff([fractions(each) for each in seen], axis=0)).max(axis=(1, 2))
    assert (steps[:-1] > 1e-4).all()
    assert steps.max() < 0.15


@pytest.mark.parametrize(
    "kinds",
    [
        ("volume",),
        ("capacity",),
        ("height", "rim_diameter"),
        ("capacity", "height", "max_diameter"),
    ],
)
def test_locks_hold_and_the_shape_is_fairer_than_by_the_locks_alone(kinds):
    document = locked(pot(6), *kinds)
    point = (3, 0)
    _, live = dragged(document, point, (0.03, 0.02), live=True)
    _, plain = dragged(document, point, (0.03, 0.02), live=False)
    assert missed_locks(live[-1]) == ()
    energies = [profile_energy(each[-1].profile, Energy.BENDING) for each in (live, plain)]
    assert energies[0] < energies[1]
    assert all(report.holds for report in measure_joints(live[-1].profile))


@pytest.mark.parametrize("energy", list(Energy))
def test_a_curvature_rule_goes_on_holding(energy):
    # The halves of one segment meet with one curvature.
    document = sgb.edits.split_segment(sgb.Document(wavy(2)), 0, 0.5)[0]
    document = sgb.edits.set_rule(document, 0, "G2")
    assert measure_joints(document.profile)[0].holds
    _, seen = dragged(document, (1, 2), (0.02, 0.02), live=True, energy=energy)
    assert all(measure_joints(each.profile)[0].holds for each in seen)
    assert not np.array_equal(fractions(seen[-1]), fractions(document))


def test_nothing_moved_is_nothing_changed():
    document = sgb.Document(wavy(3))
    session = Session(document)
    session.begin("drag")
    place = tuple(document.profile[1].points[0].tolist())
    session.apply(lambda d: sgb.edits.move_point(d, 1, 0, place), refining=LiveFair([0, 1]))
    session.commit()
    assert session.document is document


def test_beside_are_both_sides_of_the_end_a_point_belongs_to():
    profile = wavy(4)
    assert beside(profile, [(1, 0)]) == beside(profile, [(1, 1)]) == {0, 1}
    assert beside(profile, [(1, 2)]) == beside(profile, [(1, 3)]) == {1, 2}
    assert beside(profile, [(0, 0)]) == {0}
    assert beside(profile, [(0, 3), (3, 3)]) == {0, 1, 3}
    ring = preset("ring").profile
    assert ring.closed
    assert beside(ring, [(0, 0)]) == {0, len(ring) - 1}
