"""The window tells findings without a path, by the names that its controls show."""

from __future__ import annotations

import re
from dataclasses import fields

import pytest

from app.panels.solid.panel import LENGTHS
from app.state.window_reader import WINDOW, reason, segment_titles, sentence, told, why
from sgb_core.curves.primitives import line
from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import Segment
from sgb_core.document import edits
from sgb_core.document.edits.fit import arc_for
from sgb_core.document.errors import EditError
from sgb_core.document.model import Document
from sgb_core.fields.record import Row
from sgb_core.findings.edits import LastSegment, NoEdit
from sgb_core.findings.finding import Finding
from tests.sgb_core.findings.examples import COUNTING, EXAMPLES, SEGMENT

SECTIONS = "|".join(field.name for field in fields(Document))
PATH = re.compile(rf"\b(?:{SECTIONS})(?:\.\w|\[|: )")


@pytest.mark.parametrize("finding", EXAMPLES, ids=repr)
def test_no_finding_names_a_path(finding: Finding) -> None:
    assert not PATH.search(told(finding))


@pytest.mark.parametrize("finding", COUNTING, ids=repr)
def test_segments_count_from_1(finding: Finding) -> None:
    assert re.search(rf"\b{SEGMENT + 1}\b", told(finding))
    assert not re.search(rf"\b{SEGMENT}\b", told(finding))


def test_paths_of_files_are_seen_by_the_test_of_them() -> None:
    for path in ("profile.segments[3]: beyond", "solid.wall: 3 is", "variation: segment 2 goes"):
        assert PATH.search(path)


@pytest.mark.parametrize("row", LENGTHS, ids=lambda row: row.key)
def test_controls_are_called_as_the_panel_shows_them(row: Row) -> None:
    assert row.label.removesuffix(" ⌀") == WINDOW.place(("solid", row.key))


def cylinder() -> Document:
    return Document(Profile.of([line((10, 0), (10, 60))]))


def test_errors_are_told_in_the_windows_words() -> None:
    assert why(EditError(LastSegment(2))).startswith("segment 3 is the last")
    with pytest.raises(EditError) as refused:
        edits.set_shape_parameter(cylinder(), 0, "omega", 1.2)
    assert why(refused.value) == "ω is 1.2; allowed is 0 to 1"
    assert str(refused.value) == "omega is 1.2; allowed is 0 to 1"
    with pytest.raises(EditError) as refused:
        arc_for(cylinder(), a=-2.0)
    assert why(refused.value) == "Half height a is -2.0; allowed is a positive number, at most 1e9"
    assert why(OSError("no space left")) == "no space left"
    assert reason(OSError("no space left")) == "No space left."
    assert sentence(NoEdit.OPEN_ALREADY) == "The profile is open already."


def test_a_segment_has_one_title_wherever_one_is_chosen():
    line_up = [[20, 0], [30, 20], [30, 40], [20, 60]]
    flared = [[20, 60], [18, 70], [18, 80], [26, 90]]
    pot = Profile.of([Segment(line_up), Segment(flared)], ["G0"])
    assert segment_titles(pot) == ["1 · foot", "2 · lip"]
    assert segment_titles(Profile.of([Segment(line_up)])) == ["Segment 1"]
