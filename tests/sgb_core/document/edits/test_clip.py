"""Runs of segments: copied, written as text, read again, pasted."""

import numpy as np
import pytest

import resources
from sgb_core.curves.profile import JointRule
from sgb_core.document import edits
from sgb_core.document.edits import clip
from sgb_core.document.errors import EditError, FileError
from sgb_core.document.file import project_file
from sgb_core.document.model import Unit


@pytest.fixture
def vase():
    return project_file.loads(resources.load_preset("vase"))


def test_text_and_back_is_the_same_run(vase):
    run = clip.run_of(vase, 1, 3)
    again = clip.loads_run(clip.dumps_run(run, vase.unit), vase.unit)
    assert again == run
    assert again.rules == vase.profile.rules[1:3]


def test_lengths_follow_the_unit(vase):
    run = clip.run_of(vase, 0, 0)
    inches = clip.loads_run(clip.dumps_run(run, Unit.MM), Unit.IN)
    assert inches.control_points * 25.4 == pytest.approx(run.control_points)


@pytest.mark.parametrize("text", ["", "{", "[1]", '{"format": "sgb-document"}', "[" * 100_000])
def test_other_text_holds_no_segments(text):
    with pytest.raises(FileError, match="no segments"):
        clip.loads_run(text, Unit.MM)


def test_a_bad_run_says_where(vase):
    text = clip.dumps_run(clip.run_of(vase, 0, 0), vase.unit).replace('"omega": ', '"omega": 7')
    with pytest.raises(FileError, match=r"profile\.segments\[0\]\.omega"):
        clip.loads_run(text, vase.unit)


@pytest.mark.parametrize("after", [0, 2, 5])
def test_a_pasted_run_starts_where_the_segment_ends_and_no_radius_changes(vase, after):
    run = clip.run_of(vase, 1, 2)
    pasted = clip.paste_run(vase, after, run)
    old, new = vase.profile.control_points, pasted.profile.control_points
    assert len(new) == len(old) + 2
    assert new[: after + 1] == pytest.approx(old[: after + 1])
    assert new[after + 1, 0] == pytest.approx(old[after, 3])
    inner = run.control_points
    assert np.diff(new[after + 1 : after + 3], axis=1) == pytest.approx(np.diff(inner, axis=1))
    assert new[after + 3 :, :, 0] == pytest.approx(old[after + 1 :, :, 0])
    heights = new[after + 3 :, :, 1] - old[after + 1 :, :, 1]
    assert np.ptp(heights) < 1e-9 if heights.size else True
    assert project_file.loads(project_file.dumps(pasted)) == pasted


def test_a_run_that_ends_at_another_radius_leaves_an_open_joint_that_can_be_closed(vase):
    pasted = clip.paste_run(vase, 1, clip.run_of(vase, 0, 0))
    assert pasted.profile.rules[2] is JointRule.FREE
    joined = edits.set_rule(pasted, 2, JointRule.G0)
    points = joined.profile.control_points
    assert points[2, 3] == pytest.approx(points[3, 0])


def test_cutting_and_what_is_not_allowed(vase):
    assert len(clip.remove_run(vase, 1, 3).profile) == len(vase.profile) - 3
    with pytest.raises(EditError, match="only segment"):
        clip.remove_run(vase, 0, len(vase.profile) - 1)
    ring = project_file.loads(resources.load_preset("ring"))
    with pytest.raises(EditError, match="ring"):
        clip.paste_run(ring, 0, clip.run_of(vase, 0, 0))
    with pytest.raises(EditError, match="run"):
        clip.run_of(vase, 2, 1)


def test_scaling_points_about_their_middle_or_a_place(vase):
    keys = [(0, 1), (0, 2), (3, 1)]
    old = vase.profile.control_points
    places = np.array([old[key] for key in keys])
    middle = (places.min(axis=0) + places.max(axis=0)) / 2
    scaled = edits.scale_points(vase, keys, (0.5, 2.0), keep_rules=False).profile.control_points
    for key in keys:
        assert scaled[key] == pytest.approx(middle + (old[key] - middle) * (0.5, 2.0))
    about = edits.scale_points(vase, keys, (1.0, -1.0), (0.0, 10.0), keep_rules=False)
    assert about.profile.control_points[0, 1, 1] == pytest.approx(20.0 - old[0, 1, 1])
    twice = edits.scale_points(
        edits.scale_points(vase, keys, (-1, 1), (5.0, 0.0), keep_rules=False),
        keys,
        (-1, 1),
        (5.0, 0.0),
        keep_rules=False,
    )
    assert twice.profile.control_points == pytest.approx(old)
    assert edits.scale_points(vase, [], (2.0, 2.0)) is vase


def test_placing_points(vase):
    placed = edits.place_points(vase, {(0, 1): (30.0, 280.0), (2, 2): (60.0, 120.0)})
    assert placed.profile.control_points[0, 1] == pytest.approx((30.0, 280.0))
    assert placed.profile.control_points[2, 2] == pytest.approx((60.0, 120.0))
    assert edits.place_points(vase, {}) is vase
