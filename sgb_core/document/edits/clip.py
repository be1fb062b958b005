"""Runs of segments on their own: copied out of one document, pasted into another.

As text a run is JSON: ``{"format": "sgb-segments", "version": 1, "unit": "mm", "profile": {...}}``
with the profile section of a project file.
"""

from __future__ import annotations

import json
from dataclasses import replace

from sgb_core.curves.profile import GAP, JointRule, Profile
from sgb_core.document.edits.chain import remove_segment
from sgb_core.document.edits.checks import as_edit_error, lowered, segment_number, with_profile
from sgb_core.document.edits.renumber_laws import follow
from sgb_core.document.errors import EditError, FileError
from sgb_core.document.model import Document, Unit
from sgb_core.fields.record import codec_of
from sgb_core.findings.edits import BackwardRun, NoEdit
from sgb_core.findings.files import NoContent
from sgb_core.findings.refusal import MISSING, RefusalError

FORMAT = "sgb-segments"
VERSION = 1


def run_of(document: Document, first: int, last: int) -> Profile:
    """Return the segments from ``first`` to ``last``, with their rules, as an open profile."""
    segment_number(document, first)
    segment_number(document, last)
    profile = document.profile
    if last < first:
        raise EditError(BackwardRun(first, last))
    return Profile(profile.segments[first : last + 1], profile.rules[first:last])


@as_edit_error()
def paste_run(document: Document, index: int, run: Profile) -> Document:
    """Insert a run after segment ``index``, moved so that it starts where that segment ends.

    What follows is shifted along the axis to make room, so that no radius changes; where the
    radii then differ the joint after the run is free. Raises EditError on a ring.
    """
    segment_number(document, index)
    profile = document.profile
    if profile.closed:
        raise EditError(NoEdit.RING_HAS_NO_ROOM)
    points = profile.control_points
    shift = points[index, 3] - run.segments[0].points[0]
    pasted = [s.with_points(s.points + shift) for s in run.segments]
    end = pasted[-1].points[3]
    along = (0.0, float(end[1] - points[index, 3, 1]))
    later = [s.with_points(s.points + along) for s in profile.segments[index + 1 :]]
    joints: tuple[JointRule, ...] = (JointRule.G0, *run.rules)
    if later:
        apart = abs(float(later[0].points[0, 0] - end[0])) > GAP * profile.size
        joints = (*joints, JointRule.FREE if apart else JointRule.G0)
    longer = replace(
        profile,
        segments=(*profile.segments[: index + 1], *pasted, *later),
        rules=(*profile.rules[:index], *joints, *profile.rules[index + 1 :]),
    )
    count = len(profile)
    origin = [*range(index + 1), *(None for _ in pasted), *range(index + 1, count)]
    longer = lowered(longer, range(index, index + len(joints)))
    return with_profile(document, longer, follow(document.variation, origin), origin)


def remove_run(document: Document, first: int, last: int) -> Document:
    """Remove the segments from ``first`` to ``last``; at least one must be left."""
    for _ in range(last - first + 1):
        document = remove_segment(document, first)
    return document


def dumps_run(run: Profile, unit: Unit) -> str:
    """Return a run as text."""
    tree = {
        "format": FORMAT,
        "version": VERSION,
        "unit": str(unit),
        "profile": codec_of(Profile).to_plain(run),
    }
    return json.dumps(tree, ensure_ascii=False)


def loads_run(text: str, unit: Unit) -> Profile:
    """Return the run in a text, with its lengths in ``unit``. Raises FileError on other text."""
    try:
        tree = json.loads(text)
    except (ValueError, RecursionError):
        raise FileError(NoContent.NO_SEGMENTS) from None
    if not isinstance(tree, dict) or tree.get("format") != FORMAT:
        raise FileError(NoContent.NO_SEGMENTS)
    try:
        # A document, since its ends must meet where their rule says so.
        run = Document(
            codec_of(Profile).from_plain(tree.get("profile", MISSING), ("profile",)),
            unit=tree.get("unit", Unit.MM),
        )
        factor = run.unit.factor_to(unit)
        if factor == 1.0:
            return run.profile
        segments = [s.with_points(s.points * factor) for s in run.profile.segments]
        return run.profile.with_segments(segments)
    except RefusalError as error:
        raise FileError(error.finding) from None
