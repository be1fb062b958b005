"""The dimensioned section: on the paper, nothing over anything else, every number true."""

from __future__ import annotations

import re
from dataclasses import replace
from math import pi

import numpy as np
import pytest
import shapely

import resources
import resources.library
from sgb_core.bodies.contours import seen_lines
from sgb_core.bodies.cut_outs import CutOut
from sgb_core.bodies.solid import BodyKind, Solid, WallSide
from sgb_core.design.locks.dimension import Dimension, DimensionKind
from sgb_core.document.appearance.model import Appearance, LayerKind
from sgb_core.document.appearance.model import Layer as Paint
from sgb_core.document.model import Document, Unit
from sgb_core.drawings import outside as outside_of
from sgb_core.drawings.errors import DrawingError
from sgb_core.drawings.half_view import half_view
from sgb_core.drawings.page import Area, Layer, Page, Stroke, Words
from sgb_core.drawings.plate import measure_lines
from sgb_core.drawings.scales import SIZES, Paper, Scale
from sgb_core.drawings.section import section_page
from sgb_core.drawings.template import TemplateWanted, template
from sgb_core.drawings.wanted import Fill, Side, Wanted
from sgb_core.findings.errors import FindingError
from sgb_core.surfaces.laws.law import Law
from sgb_core.surfaces.twist import Twist
from tests.sgb_core.drawings.looking import outside, overlaps
from tests.sgb_core.drawings.shapes import BENT, CUP, OTHERS, chain, preset

PRESETS = [found.name for found in resources.presets()]


def words_of(page: Page) -> list[str]:
    return [mark.text for mark in page.marks if isinstance(mark, Words)]


def level_lengths(page: Page) -> list[float]:
    """Return how long the level and upright lines with arrows are, in mm of the object."""
    return [
        float(np.abs(np.diff(path.flat(), axis=0)).max() / page.scale)
        for mark in page.of_layer(Layer.DIMENSIONS)
        if isinstance(mark, Stroke)
        for path in mark.paths
    ]


@pytest.mark.parametrize("side", Side)
@pytest.mark.parametrize("name", PRESETS)
def test_presets_fit_and_nothing_lies_over_words(name: str, side: Side) -> None:
    page, _ = section_page(preset(name), Wanted(side=side))
    assert overlaps(page) == []
    assert outside(page) == []


@pytest.mark.parametrize("side", Side)
@pytest.mark.parametrize("name", OTHERS)
def test_odd_shapes_fit_and_nothing_lies_over_words(name: str, side: Side) -> None:
    page, _ = section_page(OTHERS[name], Wanted(side=side))
    assert overlaps(page) == []
    assert outside(page) == []


def test_the_cup_is_dimensioned_as_it_is() -> None:
    page, told = section_page(CUP, Wanted(day="2026-03-31"))
    words = words_of(page)
    for each in ("60", "⌀40", "wall 3", "floor 4", "2026-03-31", "2:1", "mm"):
        assert each in words
    # The worked example of the contract.
    assert f"{pi * 17**2 * 56 / 1000:.1f} ml" in words
    assert told == "2:1 on A4 portrait"
    lengths = level_lengths(page)
    for expected in (60.0, 40.0):
        assert any(length == pytest.approx(expected, abs=1e-9) for length in lengths)


@pytest.mark.parametrize("name", ["vase", "pagoda", "tower", "candlestick"])
def test_heights_and_diameters_are_those_of_the_file(name: str) -> None:
    document = preset(name)
    words = words_of(section_page(document, Wanted())[0])
    points = document.profile.sample(2001).reshape(-1, 2)
    ends = document.profile.segments[0].points[0], document.profile.segments[-1].points[3]
    shown = [float(word[1:]) for word in words if re.fullmatch(r"⌀[\d.]+", word)]
    step = 0.01 if document.unit is Unit.MM else 0.001
    assert max(shown) == pytest.approx(2 * points[:, 0].max(), abs=step)
    rim = 2 * max(ends, key=lambda end: end[1])[0]
    assert rim == 0.0 or any(value == pytest.approx(rim, abs=step) for value in shown)
    heights = [float(word) for word in words if re.fullmatch(r"[\d.]+", word)]
    assert any(value == pytest.approx(np.ptp(points[:, 1]), abs=step) for value in heights)


def test_radii_are_those_of_the_curve() -> None:
    words = words_of(section_page(BENT, Wanted())[0])
    first, last = BENT.profile.segments
    expected = [1.0 / abs(float(first.curvature(1.0))), 1.0 / abs(float(last.curvature(0.0)))]
    (found,) = [word for word in words if word.startswith("R")]
    assert [float(part[1:]) for part in found.split(" / ")] == pytest.approx(expected, abs=0.006)


OWN = (
    Dimension(DimensionKind.DIAMETER_AT, height=20.0),
    Dimension(DimensionKind.NECK_DIAMETER),
    Dimension(DimensionKind.NECK_HEIGHT),
    Dimension(DimensionKind.DISTANCE, points=((0, 1), (0, 2))),
    Dimension(DimensionKind.ANGLE, points=((1, 0), (1, 1))),
    Dimension(DimensionKind.RADIUS, segment=0, s=0.5),
    Dimension(DimensionKind.MATERIAL),
    Dimension(DimensionKind.MASS),
    Dimension(DimensionKind.JOINT, locked=True, joint=0, rule="G1"),
)


def test_the_projects_own_dimensions_are_drawn_instead() -> None:
    document = replace(BENT, dimensions=OWN)
    page, _ = section_page(document, Wanted())
    words = words_of(page)
    assert "95" not in words
    points = document.profile.control_points
    apart = float(np.hypot(*(points[0, 2] - points[0, 1])))
    step = points[1, 1] - points[1, 0]
    angle = float(np.degrees(np.arctan2(step[1], step[0])))
    curve = document.profile.sample(20_001)
    crossing = np.abs(curve[..., 1] - 20.0).argmin()
    across = 2.0 * float(curve[..., 0].ravel()[crossing])
    material = document.body().material_volume
    numbers = [float(found) for word in words for found in re.findall(r"-?\d+\.?\d*", word)]
    for expected in (apart, angle, across, material / 1000.0):
        assert any(number == pytest.approx(expected, abs=0.06) for number in numbers)
    assert overlaps(page) == []


def test_a_body_larger_than_its_profile_shows_both() -> None:
    document = OTHERS["bent, wall outside"]
    words = words_of(section_page(document, Wanted())[0])
    mesh = document.body().mesh(tolerance=1e-3)
    assert "95" in words
    assert f"{np.ptp(mesh.positions[:, 2]):.2f}".rstrip("0").rstrip(".") in words


@pytest.mark.parametrize("name", ["bowl", "plant-pot", "lantern"])
def test_a_round_rim_is_as_wide_as_the_body_is(name: str) -> None:
    """What the rounding takes off the drawn edge is not there to be measured."""
    document = preset(name)
    page, _ = section_page(document, Wanted())
    mesh = replace(document, cut_outs=()).body().mesh(tolerance=1e-3).positions
    r = np.hypot(mesh[:, 0], mesh[:, 1])
    near_rim = mesh[:, 2] > mesh[:, 2].max() - document.solid.wall
    shown = [float(word[1:]) for word in words_of(page) if word.startswith("⌀")]
    for expected in (2.0 * r.max(), 2.0 * r[near_rim].max()):
        assert any(value == pytest.approx(expected, abs=0.012) for value in shown)
    ends = document.profile.segments[0].points[0], document.profile.segments[-1].points[3]
    drawn = 2.0 * max(ends, key=lambda end: end[1])[0]
    assert drawn > 2.0 * r[near_rim].max() + 0.1
    assert drawn not in shown


@pytest.mark.parametrize("side", Side)
def test_the_section_stands_where_it_is_wanted(side: Side) -> None:
    page, _ = section_page(CUP, Wanted(side=side))
    hatching = [path.flat() for mark in page.of_layer(Layer.HATCH) for path in mark.paths]
    away = np.concatenate(hatching)[:, 0] - page.origin[0]
    assert (away > -1e-9).all() if side is Side.RIGHT else (away < 1e-9).all()


def test_hatching_fills_the_material_and_nothing_else() -> None:
    page, _ = section_page(CUP, Wanted())
    lines = np.array([path.flat() for mark in page.of_layer(Layer.HATCH) for path in mark.paths])
    middles = (lines.mean(axis=1) - page.origin) / page.scale
    r, h = middles.T
    assert (((r >= 17) & (r <= 20)) | ((h >= 0) & (h <= 4))).all()
    # Lines two millimetres apart: their length is the area over the distance.
    length = np.hypot(*(lines[:, 1] - lines[:, 0]).T).sum() / page.scale
    area = 3 * 56 + 20 * 4
    assert length * 2.0 / page.scale == pytest.approx(area, rel=0.03)


def test_filled_material_is_one_area() -> None:
    page, _ = section_page(CUP, Wanted(fill=Fill.FILLED))
    (area,) = page.of_layer(Layer.MATERIAL)
    assert isinstance(area, Area)
    assert page.of_layer(Layer.HATCH) == ()


@pytest.mark.parametrize("paper", Paper)
def test_papers_have_their_sizes(paper: Paper) -> None:
    page, told = section_page(preset("vase"), Wanted(paper=paper))
    assert sorted((page.width, page.height)) == sorted(SIZES[paper])
    assert str(paper) in told
    assert outside(page) == []


def test_a_scale_that_does_not_fit_is_refused_with_what_would() -> None:
    with pytest.raises(DrawingError, match=r"at 2:1 the drawing needs .* smaller scale"):
        section_page(preset("vase"), Wanted(paper=Paper.A4, scale=Scale(2, 1)))


def test_a_scale_is_taken_as_given() -> None:
    page, _ = section_page(CUP, Wanted(scale=Scale(1, 3)))
    assert page.scale == pytest.approx(1 / 3)


def test_what_has_no_extent_cannot_be_drawn() -> None:
    with pytest.raises(DrawingError, match="single point"):
        section_page(chain((5, 5), (5, 5)), Wanted())


def test_a_wall_that_leaves_nothing_is_said() -> None:
    with pytest.raises(FindingError, match="wall"):
        section_page(replace(CUP, solid=Solid(BodyKind.VESSEL, wall=30.0)), Wanted())


def test_a_date_is_checked() -> None:
    with pytest.raises(FindingError, match="date"):
        Wanted(day="31 March")


def test_names_of_any_length_are_cut_to_their_cell() -> None:
    document = Document(CUP.profile, name="Vase " * 200)
    page, _ = section_page(document, Wanted())
    assert any(word.startswith("Vase") and word.endswith("…") for word in words_of(page))


def test_under_laws_what_is_dimensioned_is_the_section_that_is_cut() -> None:
    law = Law("radius", "lobes", 0.8, 1.25, count=3)
    page, _ = section_page(replace(CUP, variation=(law,)), Wanted())
    words = words_of(page)
    # At the start a hollow; over the turn the lobes reach 25 %.
    assert "⌀32" in words
    assert not any(word in words for word in ("⌀40", "⌀50"))
    assert any("greatest diameter is 50 mm" in word for word in words)
    assert overlaps(page) == []


@pytest.mark.parametrize("side", Side)
def test_a_twist_keeps_its_hand_on_whichever_side_the_section_is(side: Side) -> None:
    law = Law("radius", "lobes", 0.8, 1.0, count=6, sharp=0.5)
    left, right = (replace(CUP, variation=(law,), twist=Twist(turns)) for turns in (-0.3, 0.3))
    other = Side.LEFT if side is Side.RIGHT else Side.RIGHT
    one = half_view(right, 0.05, Wanted(side=side).mirror)
    mirrored = half_view(left, 0.05, Wanted(side=other).mirror)
    same = half_view(right, 0.05, Wanted(side=other).mirror)
    lines, others, all_same = (
        shapely.union_all([shapely.LineString(path.flat()) for path in view.outside])
        for view in (one, mirrored, same)
    )
    assert shapely.hausdorff_distance(lines, others) < 0.5
    assert shapely.hausdorff_distance(lines, all_same) > 3.0


def test_holes_are_drawn_where_they_are_seen() -> None:
    # Four holes of 16 across, one of them in the middle of what is seen.
    pattern = CutOut(width=16.0, height=16.0, rows=1, around=4)
    view = half_view(replace(CUP, cut_outs=(pattern,)), 0.02)
    whole = half_view(CUP, 0.02)
    new = shapely.union_all([shapely.LineString(path.flat()) for path in view.outside]).difference(
        shapely.union_all(
            [shapely.LineString(path.flat()) for path in whole.outside]
            + [shapely.LineString([(0.0, h), (r, h)]) for r, h in whole.edges]
        ).buffer(0.05)
    )
    low, high = new.bounds[1], new.bounds[3]
    assert high - low == pytest.approx(16.0, abs=0.2)
    assert new.bounds[2] <= 20.0 + 1e-6
    # Half of the one in front, whose edge is a circle wrapped round the wall.
    front = np.concatenate([shapely.get_coordinates(part) for part in shapely.get_parts(new)])
    half = front[front[:, 0] < 8.0]
    along = 20.0 * np.arcsin(half[:, 0] / 20.0)
    away = np.hypot(along, half[:, 1] - 0.5 * (low + high))
    assert (np.abs(away - 8.0) < 0.3).mean() > 0.3


@pytest.mark.parametrize("side", Side)
def test_what_is_seen_of_a_mesh_is_looked_for_once_a_page(side: Side, monkeypatch) -> None:
    asked = []

    def counted(*given):
        asked.append(given)
        return seen_lines(*given)

    monkeypatch.setattr(outside_of, "seen_lines", counted)
    law = Law("radius", "lobes", 0.81, 1.0, count=5)
    section_page(replace(CUP, variation=(law,)), Wanted(side=side))
    assert len(asked) == 1


def test_holes_leave_the_dimensions_as_they_are() -> None:
    """What is drawn, curves or a mesh, may be a hair wider than the profile: no second diameter."""
    lantern = preset("lantern")
    pages = [section_page(each, Wanted())[0] for each in (lantern, replace(lantern, cut_outs=()))]
    said = [sorted(word for word in words_of(page) if "⌀" in word) for page in pages]
    assert said[0] == said[1]
    assert len(said[0]) == 3


def test_a_relief_is_said_to_be_left_out_with_how_wide_all_is_with_it() -> None:
    layer = Paint(LayerKind.RINGS, start=0.3, end=0.7, count=2, relief=1.5, edge=4.0)
    raised = replace(CUP, appearance=Appearance(drawing=(layer,)))
    page, _ = section_page(raised, Wanted())
    (said,) = [text for text in words_of(page) if text.startswith("Without the relief")]
    mesh = raised.body().worked.mesh.positions
    widest = 2.0 * float(np.hypot(*mesh[:, :2].T).max())
    assert float(re.search(r"diameter is ([\d.]+)", said).group(1)) == pytest.approx(
        widest, abs=0.01
    )
    assert "raised by up to 1.5 mm" in said
    assert measure_lines(raised, half_view(raised, 0.1))[0].endswith("without its relief")
    board = " ".join(words_of(template(raised, TemplateWanted()).pages[0]))
    assert "without its relief" in board
    inside = TemplateWanted(wall=WallSide.INSIDE)
    assert not any("relief" in text for text in words_of(template(raised, inside).pages[0]))
    assert not any("relief" in text for text in words_of(section_page(CUP, Wanted())[0]))
