"""One error for files, scripts and the window, told to each in his words."""

from __future__ import annotations

import numpy as np
import pytest

from sgb_core.fields.kinds import COORDINATE, FINITE, Range
from sgb_core.findings.finding import Finding
from sgb_core.findings.refusal import (
    MISSING,
    Apart,
    Argument,
    HalfCharacter,
    OpenRing,
    Refusal,
    SameAngle,
    Taken,
    moved,
    shown,
)
from sgb_core.findings.words import FILE, Reader, path_text, say

WINDOW = Reader(first=1, names={"solid.wall": "Wall", "a[].b[]": "B {} of {}", "omega": "ω"})


@pytest.mark.parametrize(
    ("finding", "file", "window"),
    [
        (
            Refusal(("solid", "wall"), -5, Range(above=0.0)),
            "solid.wall is -5; allowed is a number above 0",
            "Wall is -5; allowed is a number above 0",
        ),
        (
            Refusal(("a", 2, "b", 0), MISSING, FINITE),
            "a[2].b[0] is missing; allowed is a finite number",
            "B 3 of 1 is missing; allowed is a finite number",
        ),
        (
            Refusal((), [], COORDINATE),
            "the file is a list of 0; allowed is a number from -1e9 to 1e9",
            "the file is a list of 0; allowed is a number from -1e9 to 1e9",
        ),
        (
            Argument("omega", 2.0, Range(0.0, 1.0)),
            "omega is 2; allowed is 0 to 1",
            "ω is 2; allowed is 0 to 1",
        ),
        (
            Argument("omega", True, FINITE),
            "omega is True; allowed is a finite number",
            "ω is True; allowed is a finite number",
        ),
        (
            Apart(("profile", "joints", 0), "C1", (0, 1), 3.0),
            'profile.joints[0] is "C1", but segments 0 and 1 are 3 apart; allowed is "free", or '
            "ends that meet",
            'profile.joints[0] is "C1", but segments 1 and 2 are 3 apart; allowed is "free", or '
            "ends that meet",
        ),
        (
            OpenRing(("profile", "closed"), 0.5),
            "profile.closed is true, but the last point is 0.5 from the first; allowed is true "
            "only where they meet",
            "profile.closed is true, but the last point is 0.5 from the first; allowed is true "
            "only where they meet",
        ),
    ],
)
def test_every_reader_is_told_in_his_words(finding: Finding, file: str, window: str) -> None:
    assert say(finding) == say(finding, FILE) == file
    assert say(finding, WINDOW) == window


def test_a_finding_is_moved_to_where_its_value_stands() -> None:
    alone = Refusal(("law", "n"), 0, FINITE)
    assert moved(alone, ("variation", 2), 1).path == ("variation", 2, "n")
    for finding in (HalfCharacter(("name",)), Taken(("name",), "state"), SameAngle(("k",), 1.0)):
        assert moved(finding, ("states", 1), 0).path[:2] == ("states", 1)


def test_paths_are_written_as_json_is_addressed() -> None:
    assert path_text(("profile", "segments", 2, "omega")) == "profile.segments[2].omega"
    assert path_text(("a b", "c"), numbered=False) == '"a b".c'
    assert path_text(("a", 1, 2), numbered=False) == "a[][]"
    assert path_text(()) == ""


@pytest.mark.parametrize(
    ("value", "text"),
    [
        (2.0, "2.0"),
        (True, "true"),
        (None, "null"),
        ("x", '"x"'),
        ("x" * 99, '"' + "x" * 36 + "..."),
        ([1], "a list of 1"),
        ({}, "an object"),
        (float("nan"), "NaN"),
        (float("-inf"), "too large"),
        (np.float32(0.5), "0.5"),
        (np.zeros((3, 2)), "an array of shape (3, 2)"),
        (object, "<class 'object'>"),
    ],
)
def test_values_are_shown_in_one_short_line(value: object, text: str) -> None:
    assert shown(value) == text
