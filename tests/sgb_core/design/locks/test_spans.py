"""Where dimensions lie: each reaches over what it measures, on every side of the axis."""

from dataclasses import replace

import numpy as np
import pytest

import sgb_core as sgb
from sgb_core.curves.nearest import nearest
from sgb_core.design.locks.spans import Span, Way, spans
from sgb_core.document.dimensions import dimension_value, setting_of
from tests.sgb_core.design.locks.samples import pot

KINDS = (
    "height",
    "max_diameter",
    "max_diameter_height",
    "rim_diameter",
    "neck_diameter",
    "neck_height",
    "wall",
    "base",
    "fill_line",
)


def filled() -> sgb.Document:
    return sgb.edits.set_fill(pot(4), 90.0)


def mirrored(document: sgb.Document) -> sgb.Document:
    points = document.profile.control_points * (-1.0, 1.0)
    segments = [
        segment.with_points(own)
        for segment, own in zip(document.profile.segments, points, strict=True)
    ]
    return replace(document, profile=document.profile.with_segments(segments))


def span(document: sgb.Document, kind: str) -> Span:
    (found,) = spans(document.profile, (sgb.Dimension(kind),), setting_of(document))
    assert found is not None
    return found


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("reverse", [False, True])
def test_the_end_of_a_line_says_the_value(kind: str, reverse: bool) -> None:
    document = filled()
    if reverse:
        document = sgb.edits.reverse_profile(document)
    value = dimension_value(document, sgb.Dimension(kind))
    found = span(document, kind)
    assert found.value_at(found.end) == pytest.approx(value, rel=1e-9)


@pytest.mark.parametrize("side", ["inside", "outside"])
@pytest.mark.parametrize("reverse", [False, True])
@pytest.mark.parametrize("mirror", [False, True])
def test_wall_and_floor_reach_through_the_material(side: str, reverse: bool, mirror: bool) -> None:
    document = sgb.edits.set_solid(filled(), side=side)
    if reverse:
        document = sgb.edits.reverse_profile(document)
    if mirror:
        document = mirrored(document)
    wall, floor = span(document, "wall"), span(document, "base")
    assert nearest(document.profile, wall.start).distance < 1e-9
    inwards = abs(wall.end[0]) < abs(wall.start[0])
    assert inwards == (side == "inside")
    assert floor.start[1] == pytest.approx(0.0, abs=1e-9)
    assert floor.end[1] == pytest.approx(4.0 if side == "inside" else -4.0)
    assert np.sign(floor.end[0]) == (-1.0 if mirror else 1.0)


def test_a_level_is_dragged_below_zero_and_a_thickness_is_not() -> None:
    document = filled()
    assert span(document, "fill_line").value_at((3.0, -7.0)) == -7.0
    wall = span(document, "wall")
    beyond = 2.0 * np.array(wall.start) - wall.end
    assert 0.0 < wall.value_at((float(beyond[0]), float(beyond[1]))) < 1e-3


def test_what_is_not_there_has_no_line() -> None:
    bare = sgb.edits.set_solid(pot(3), kind="surface")
    wanted = tuple(sgb.Dimension(kind) for kind in ("wall", "base", "fill_line"))
    assert spans(bare.profile, wanted, setting_of(bare)) == [None, None, None]


def test_an_angle_turns_about_its_first_point() -> None:
    document = pot(4)
    angle = sgb.Dimension("angle", points=((1, 0), (1, 1)))
    (found,) = spans(document.profile, (angle,), setting_of(document))
    assert found is not None
    assert found.way is Way.TURN
    assert found.value_at(found.end) == pytest.approx(dimension_value(document, angle), abs=1e-9)
    up = (found.start[0], found.start[1] + 7.0)
    assert found.value_at(up) == pytest.approx(90.0)
