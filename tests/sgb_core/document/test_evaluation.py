from __future__ import annotations

import numpy as np
import pytest

from sgb_core.curves.continuity import measure_joints
from sgb_core.document import edits
from sgb_core.document.evaluation import SAMPLES, evaluate, prepared
from sgb_core.document.file import project_file
from sgb_core.document.file.project_file import warnings
from sgb_core.findings.words import say
from tests.sgb_core.document import samples

VASE = samples.document(rules=("G1", "G1"))


def test_what_follows_from_a_document() -> None:
    found = evaluate(VASE)
    assert found.document is VASE
    assert found.surface == VASE.surface
    assert found.joints == measure_joints(VASE.profile)
    np.testing.assert_array_equal(found.quartics, VASE.profile.quartics)
    np.testing.assert_array_equal(found.sample, VASE.profile.sample(SAMPLES))
    np.testing.assert_array_equal(found.bounds, VASE.profile.bounds())
    assert found.certificates.never_crosses_axis
    assert found.axis_crossings == found.self_intersections == found.findings == ()
    assert not found.sample.flags.writeable


def test_the_volume_is_that_of_a_cylinder() -> None:
    tube = samples.document([[[2, 0], [2, 1], [2, 2], [2, 3]]])
    assert evaluate(tube).volume == pytest.approx(np.pi * 4 * 3, rel=1e-14)


def test_nothing_is_computed_before_it_is_asked_for() -> None:
    found = evaluate(VASE)
    assert set(vars(found.facts)) == {"profile", "known"}
    assert found.joints is found.joints
    assert set(vars(found.facts)) == {"profile", "known", "joints"}


def test_what_is_unchanged_is_taken_over() -> None:
    first = evaluate(VASE)
    assert evaluate(VASE, first) is first
    joints, sample = first.joints, first.sample
    renamed = evaluate(edits.rename(VASE, "Krug"), first)
    assert renamed.surface is first.surface
    assert renamed.joints is joints
    turned = evaluate(edits.set_revolution(VASE, sweep_deg=90.0), first)
    assert turned.surface is not first.surface
    assert turned.sample is sample
    assert turned.volume == pytest.approx(first.volume / 4.0, rel=1e-14)
    reshaped = evaluate(edits.set_shape_parameter(VASE, 0, "omega", 0.5), first)
    assert reshaped.sample is not sample
    again = project_file.loads(project_file.dumps(VASE))
    assert evaluate(again, first).sample is not sample


def test_warnings_say_what_and_where() -> None:
    kinked = samples.document(
        [[[4, 0], [5, 1], [6, 2], [6, 4]], [[6, 4], [4, 5], [3, 6], [3, 8]]], ("G2",)
    )
    (line,) = warnings(kinked)
    assert line.startswith("profile.joints[0]: the rule is G2, but the curve is only G0")
    assert "kink 63.43°" in line
    crossing = samples.document([[[3, 0], [1, 1], [-3, 2], [-1, 3]]])
    (line,) = warnings(crossing)
    assert line.startswith("profile.segments[0]: beyond the axis from s = 0.")
    loop = samples.document([[[4, 0], [12, 4], [0, 4], [8, 0]]])
    (line,) = warnings(loop)
    assert line.startswith("profile.segments[0]: crosses segment 0 at r = 6, h = ")
    assert [say(each) for each in evaluate(loop).findings] == warnings(loop)


def test_halves_in_the_same_direction_are_noticed() -> None:
    lines = warnings(samples.document(samples.HALVES, ("free",)))
    assert lines[0] == "profile.joints[0]: the ends are 4 apart"
    assert "head to tail" in lines[1]
    assert warnings(edits.head_to_tail(samples.document(samples.HALVES, ("free",)))) == []
    apart = samples.document([samples.VASE[0], samples.VASE[2]], ("free",))
    assert len(warnings(apart)) == 1


def test_long_chains_are_examined_too_and_not_every_place_is_named() -> None:
    line = [np.array([[1, k], [1, k + 0.3], [1, k + 0.6], [1, k + 1]]) for k in range(300)]
    assert warnings(samples.document(line)) == []
    across = [np.array([[k, 0], [k, 30], [k, 60], [k, 90]]) for k in range(1, 8)]
    along = [np.array([[0, k], [3, k], [6, k], [9, k]]) for k in range(1, 8)]
    lines = warnings(samples.document(across + along, ("free",) * 13))
    named = [text for text in lines if "crosses segment" in text]
    assert len(named) == 16
    assert lines[-1] == "profile: crosses itself in 33 more places"


def test_what_is_prepared_is_what_would_be_asked_for() -> None:
    parts: list[float] = []
    found, other = prepared(VASE, parts.append), evaluate(VASE)
    assert parts == sorted(parts)
    assert parts[-1] == 1.0
    assert {"joints", "findings"} <= found.__dict__.keys()
    made = {"quartics", "sample", "bounds", "axis_crossings", "self_intersections", "certificates"}
    assert made <= found.facts.__dict__.keys()
    assert (found.joints, found.findings) == (other.joints, other.findings)
