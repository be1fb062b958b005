"""Segments of a familiar kind, mirrors and the order of the chain."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sgb_core.curves.continuity import measure_joint
from sgb_core.curves.profile import GAP, JointRule, Profile
from sgb_core.curves.segment import Segment, ShapeParameters
from sgb_core.document import edits
from sgb_core.document.edits.segments import Kind
from sgb_core.document.errors import EditError
from sgb_core.document.file.project_file import dumps, loads
from sgb_core.document.model import Document
from sgb_core.document.session import Session
from sgb_core.surfaces.measures import volume
from sgb_core.surfaces.variation import Law
from tests.sgb_core.document.strategies import documents

VASE = Document(
    Profile.of(
        [
            Segment([(2, 0), (5, 1), (5, 4), (3, 6)], ShapeParameters(2, 4, 1, 0.6)),
            Segment([(3, 6), (1, 8), (2, 9), (2, 11)], ShapeParameters(0, 2, 3, 0.9)),
        ],
        ["G1"],
    )
)


def _edit(data, document):
    index = data.draw(st.integers(0, len(document.profile) - 1))
    return data.draw(
        st.sampled_from(
            [
                *(lambda d, kind=kind: edits.append_kind(d, kind)[0] for kind in Kind),
                lambda d: edits.mirror_segment(d, index),
                lambda d: edits.move_segment(d, index, 1),
                lambda d: edits.move_segment(d, index, -1),
                edits.append_mirror_image,
            ]
        )
    )


@given(documents(), st.data())
def test_every_edit_can_be_saved_and_undone(document, data):
    edit = _edit(data, document)
    session = Session(document)
    try:
        session.do("edit", edit)
    except EditError:
        assert session.document is document
        return
    assert loads(dumps(session.document)) == session.document
    session.undo()
    assert session.document is document


@pytest.mark.parametrize("kind", list(Kind))
def test_what_is_added_goes_on_smoothly(kind):
    longer, deviation = edits.append_kind(VASE, kind)
    assert len(longer.profile) == 3
    assert measure_joint(longer.profile, 1).kink_deg < 1e-6
    assert longer.profile.rules[1] is JointRule.G1
    assert longer.profile.sample(33)[..., 0].min() >= 0.0
    assert deviation < 1e-3


def test_a_line_is_straight_and_an_arc_round():
    line = edits.append_kind(VASE, "line")[0].profile.segments[2]
    assert line.curvature(np.linspace(0, 1, 9)) == pytest.approx(np.zeros(9), abs=1e-12)
    document, deviation = edits.append_kind(VASE, "arc")
    arc = document.profile.segments[2]
    points = arc.point(np.linspace(0, 1, 101))
    first, last = points[0], points[-1]
    radius = float(np.hypot(*(last - first))) / np.sqrt(2.0)
    centre = first + radius * np.array([1.0, 0.0])
    assert np.abs(np.hypot(*(points - centre).T) - radius).max() <= deviation + 1e-12


def test_what_is_added_keeps_to_its_side_of_the_axis():
    leaning = Document(Profile.of([Segment([(5, 0), (4, 1), (2, 1), (0.5, 1)])]))
    for kind in Kind:
        longer = edits.append_kind(leaning, kind)[0]
        assert longer.profile.sample(65)[..., 0].min() >= -1e-12, kind


def test_what_cannot_be_added():
    ring = edits.close_profile(VASE)
    for edit in (lambda d: edits.append_kind(d, "line"), edits.append_mirror_image):
        with pytest.raises(EditError, match="ring has no end"):
            edit(ring)
    with pytest.raises(EditError, match="no kind 'spline'"):
        edits.append_kind(VASE, "spline")


def test_mirrored_twice_is_the_same_segment():
    once = edits.mirror_segment(VASE, 0)
    twice = edits.mirror_segment(once, 0)
    assert twice.profile.segments[0].points == pytest.approx(VASE.profile.segments[0].points)
    assert twice.profile.segments[0].shape == VASE.profile.segments[0].shape
    old, new = VASE.profile.segments[0], once.profile.segments[0]
    assert np.array_equal(new.points[[0, 3]], old.points[[0, 3]])
    # What was near one end is as near the other end.
    assert np.hypot(*(new.point(0.2) - new.points[3])) == pytest.approx(
        np.hypot(*(old.point(0.8) - old.points[0]))
    )
    loop = Document(Profile.of([Segment([(1, 0), (4, 1), (4, 2), (1, 0)])]))
    with pytest.raises(EditError, match="coincide"):
        edits.mirror_segment(loop, 0)


def test_a_mirror_image_doubles_the_volume():
    doubled = edits.append_mirror_image(VASE)
    assert volume(doubled.surface) == pytest.approx(2.0 * volume(VASE.surface), rel=1e-12)
    assert len(doubled.profile) == 4
    assert doubled.profile.rules == ("G1", "G1", "G1")


def test_laws_go_with_the_segments():
    law = Law("lambda1", "raised-cosine", 0.0, 4.0, (0,))
    document = edits.set_variation(VASE, [law])
    assert edits.mirror_segment(document, 0).variation[0].parameter == "lambda3"
    assert edits.move_segment(document, 0, 1).variation[0].segments == (1,)
    first, second = edits.append_mirror_image(document).variation
    assert (first.parameter, first.segments) == ("lambda1", (0,))
    assert (second.parameter, second.segments) == ("lambda3", (3,))


def test_segments_change_places_and_back():
    swapped = edits.move_segment(VASE, 0, 1)
    old, new = VASE.profile.segments, swapped.profile.segments
    assert np.array_equal(new[0].points[0], old[0].points[0])
    assert np.array_equal(new[1].points[3], old[1].points[3])
    assert np.diff(new[0].points, axis=0) == pytest.approx(np.diff(old[1].points, axis=0))
    assert measure_joint(swapped.profile, 0).gap <= GAP
    back = edits.move_segment(swapped, 1, -1)
    assert back.profile.control_points == pytest.approx(VASE.profile.control_points)
    for index, step in ((0, -1), (1, 1)):
        with pytest.raises(EditError, match="no segment on that side"):
            edits.move_segment(VASE, index, step)
    with pytest.raises(EditError, match="by 1 or -1"):
        edits.move_segment(VASE, 0, 2)
