"""Which side of a joint yields, kept with the document, and why a rule does not hold."""

import numpy as np
import pytest

from sgb_core.curves.continuity import measure_joint
from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import Segment, ShapeParameters
from sgb_core.curves.unmet import hindrance_at
from sgb_core.document import edits
from sgb_core.document.errors import EditError, FileError
from sgb_core.document.file.project_file import dumps, loads
from sgb_core.document.model import Document
from sgb_core.findings.words import say

SHAPE = ShapeParameters(1.5, 2.5, 1.5, 0.8)


def pair(rule):
    document = Document(
        Profile.of(
            [
                Segment([(2, 0), (5, 1), (5, 4), (3, 6)], SHAPE),
                Segment([(3, 6), (1, 8), (2, 9), (4, 11)], SHAPE),
            ],
            ["G0"],
        )
    )
    return edits.set_rule(document, 0, rule)


def moved(before, after):
    return [
        not np.array_equal(a.points, b.points)
        for a, b in zip(before.profile.segments, after.profile.segments, strict=True)
    ]


@pytest.mark.parametrize(
    ("yielding", "wanted"), [("later", [False, True]), ("earlier", [True, False])]
)
@pytest.mark.parametrize("segment", [0, 1])
def test_the_chosen_side_moves_for_a_c1_joint(yielding, wanted, segment):
    document = edits.set_yielding(pair("C1"), 0, yielding)
    parameter = "lambda3" if segment == 0 else "lambda1"
    changed = edits.set_shape_parameter(document, segment, parameter, 2.5)
    assert moved(document, changed) == wanted
    assert measure_joint(changed.profile, 0).holds


def test_the_chosen_side_turns_when_a_rule_is_chosen():
    kinked = edits.move_point(pair("G0"), 1, 1, (3.5, 7.0))
    kinked = edits.set_yielding(kinked, 0, "earlier")
    assert moved(kinked, edits.set_rule(kinked, 0, "G1")) == [True, False]


def test_it_is_saved_and_follows_the_chain():
    document = edits.set_yielding(pair("C1"), 0, "earlier")
    assert b'"holds"' in dumps(document)
    assert b'"holds"' not in dumps(pair("C1"))
    assert loads(dumps(document)) == document
    assert document != pair("C1")
    split, _ = edits.split_segment(document, 1, 0.5)
    assert [s.holds_start for s in split.profile.segments] == [False, True, False]
    merged, _ = edits.merge_segments(split, 1)
    assert merged.profile.segments[1].holds_start
    turned = edits.reverse_profile(document)
    assert turned.profile.segments[0].holds_end
    assert edits.reverse_profile(turned) == document
    assert edits.set_yielding(document, 0, "later") == pair("C1")


def test_a_side_that_is_none():
    with pytest.raises(EditError, match="no side 'both'"):
        edits.set_yielding(pair("C1"), 0, "both")
    with pytest.raises(EditError, match="no joint 1"):
        edits.set_yielding(pair("C1"), 1, "later")
    text = dumps(edits.set_yielding(pair("C1"), 0, "earlier"))
    with pytest.raises(FileError, match=r"segments\[1\]\.holds\[0\]"):
        loads(text.replace(b'"holds": ["start"]', b'"holds": ["middle"]'))


def test_why_a_rule_does_not_hold():
    document = pair("C1")
    assert hindrance_at(document.profile, 0) is None
    flat = edits.set_shape_parameter(document, 0, "omega", 1.0)
    flat = edits.set_shape_parameter(flat, 0, "lambda3", 4.0)
    assert "end derivative vanishes" in say(hindrance_at(flat.profile, 0))
    plain = edits.set_shape_parameter(pair("G1"), 1, "omega", 0.0)
    wanted = edits.set_rule(plain, 0, "G2")
    assert "ω" in say(hindrance_at(wanted.profile, 0))
    bent = edits.move_point(pair("G1"), 1, 1, (1.0, 6.5), keep_rules=False)
    profile = Profile(bent.profile.segments, ("G1",))
    assert "choose the rule again" in say(hindrance_at(profile, 0))
