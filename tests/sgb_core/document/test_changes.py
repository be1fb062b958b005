"""What differs between two documents, where that is one value."""

from __future__ import annotations

from dataclasses import replace

import pytest

from sgb_core.curves.primitives import line
from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import Segment
from sgb_core.document import edits
from sgb_core.document.changes import only_change
from sgb_core.document.model import Document
from sgb_core.surfaces.laws.law import Law

CHAIN = Document(
    Profile.of(
        [Segment([(10, 0), (20, 5), (20, 15), (12, 20)]), line((12, 20), (10, 40))], ["G0"], False
    ),
    variation=(Law("omega", "cosine", 0.0, 1.0, count=3), Law("lambda2", "cosine", 3.0, 4.0)),
)


def moved(document: Document, *places: tuple[int, int]) -> Document:
    segments = list(document.profile.segments)
    for segment, index in places:
        points = segments[segment].points.copy()
        points[index] += (1.0, 0.5)
        segments[segment] = replace(segments[segment], points=points)
    return replace(document, profile=replace(document.profile, segments=tuple(segments)))


@pytest.mark.parametrize(
    ("after", "path", "old", "new"),
    [
        (edits.set_solid(CHAIN, base=5.5), ("solid", "base"), 3.0, 5.5),
        (
            edits.set_shape_parameter(CHAIN, 1, "omega", 0.25),
            ("profile", "segments", 1, "omega"),
            1.0,
            0.25,
        ),
        (edits.set_revolution(CHAIN, sweep_deg=90.0), ("revolution", "sweep_deg"), 360.0, 90.0),
        (
            replace(CHAIN, variation=(replace(CHAIN.variation[0], count=5), CHAIN.variation[1])),
            ("variation", 0, "n"),
            3,
            5,
        ),
        (
            edits.set_shrinkage(CHAIN, percent=11.0),
            ("shrinkage", "percent"),
            0.0,
            11.0,
        ),
        (moved(CHAIN, (0, 1)), ("profile", "segments", 0, "points", 1), (20, 5), (21, 5.5)),
        # A joint, with and without its handles.
        (
            moved(CHAIN, (0, 3), (1, 0)),
            ("profile", "segments", 0, "points", 3),
            (12, 20),
            (13, 20.5),
        ),
        (
            moved(CHAIN, (0, 2), (0, 3), (1, 0), (1, 1)),
            ("profile", "segments", 0, "points", 3),
            (12, 20),
            (13, 20.5),
        ),
    ],
)
def test_one_value(after, path, old, new):
    change = only_change(CHAIN, after)
    assert change is not None
    assert (change.path, change.before, change.after) == (path, old, new)


@pytest.mark.parametrize(
    "after",
    [
        CHAIN,
        replace(CHAIN),
        edits.set_solid(CHAIN, base=5.5, wall=2.0),
        moved(CHAIN, (0, 1), (0, 2)),
        moved(edits.set_solid(CHAIN, base=5.5), (0, 1)),
        edits.split_segment(replace(CHAIN, variation=()), 1, 0.5)[0],
        edits.set_rule(CHAIN, 0, "free"),
    ],
)
def test_none_or_several(after):
    assert only_change(CHAIN, after) is None
