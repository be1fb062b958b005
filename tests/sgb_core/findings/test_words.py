"""Every finding has words, in which segments and joints count as their reader counts."""

from __future__ import annotations

import re

import pytest

from sgb_core.findings.errors import FindingError
from sgb_core.findings.finding import Finding
from sgb_core.findings.line import Line
from sgb_core.findings.profile import BeyondAxis
from sgb_core.findings.words import FILE, Reader, path_text, say
from tests.sgb_core.findings.examples import COUNTING, EXAMPLES, SEGMENT, kinds

# Who knows controls instead of paths, counting from 0 and from 1.
NAMES = {"profile": "Profile", "profile.segments[]": "Segment {}", "solid.wall": "Wall"}
ZERO, ONE = Reader(0, NAMES), Reader(1, NAMES)


def numbers(finding: Finding, reader: Reader) -> list[float]:
    """Return the numbers in the words of a finding, in order."""
    return [float(text) for text in re.findall(r"\d+(?:\.\d+)?", say(finding, reader))]


def test_every_finding_has_an_example() -> None:
    assert set(kinds()) == {type(example) for example in EXAMPLES}


@pytest.mark.parametrize("finding", EXAMPLES, ids=repr)
def test_a_finding_is_one_line_and_never_changes(finding: Finding) -> None:
    for reader in (FILE, ONE):
        words = say(finding, reader)
        assert words
        assert words == words.strip()
        assert "\n" not in words
    assert str(FindingError(finding)) == say(finding)
    assert hash(finding) == hash(finding)


@pytest.mark.parametrize("finding", EXAMPLES, ids=repr)
def test_readers_differ_by_one_in_what_they_count_and_in_nothing_else(finding: Finding) -> None:
    from_zero, from_one = numbers(finding, ZERO), numbers(finding, ONE)
    assert len(from_zero) == len(from_one)
    differences = [b - a for a, b in zip(from_zero, from_one, strict=True)]
    assert set(differences) <= {0.0, 1.0}
    assert (1.0 in differences) == (finding in COUNTING)


@pytest.mark.parametrize("finding", COUNTING, ids=repr)
def test_files_count_from_0_and_others_from_their_first_number(finding: Finding) -> None:
    assert SEGMENT in numbers(finding, FILE)
    assert SEGMENT + 1 not in numbers(finding, FILE)
    assert SEGMENT + 1 in numbers(finding, ONE)
    assert SEGMENT not in numbers(finding, ONE)


def test_a_finding_that_nobody_put_into_words_is_a_fault_of_ours() -> None:
    class Unworded(Finding):
        pass

    with pytest.raises(TypeError, match="Unworded has no words"):
        say(Unworded())


def test_fields_are_called_by_path_or_by_control() -> None:
    path = ("profile", "segments", 2, "omega")
    assert path_text(path) == FILE.place(path) == "profile.segments[2].omega"
    named = Reader(1, {"profile.segments[].omega": "ω of segment {}"})
    assert named.place(path) == "ω of segment 3"
    assert named.place(("solid", "wall")) == "solid.wall"
    assert ONE.place(("solid", "wall")) == "Wall"


def test_an_error_keeps_what_it_found() -> None:
    found = BeyondAxis(2, 0.25, 0.75)
    error = FindingError(found)
    assert error.finding is found
    assert error.words(ONE) == say(found, ONE)
    assert FindingError("no such file").finding == Line("no such file")
