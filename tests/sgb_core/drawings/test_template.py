"""Templates: true size on every page, tiles that fit together, nothing outside the margins."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
import shapely

from sgb_core.bodies.solid import WallSide
from sgb_core.document.manufacture import Manufacture, Shrinkage, Stage
from sgb_core.document.model import Document, Unit
from sgb_core.drawings.errors import DrawingError
from sgb_core.drawings.page import Drawing, Layer, Page, Words
from sgb_core.drawings.pdf import pdf_bytes
from sgb_core.drawings.scales import SIZES, Paper
from sgb_core.drawings.template import PAPERS, TemplateWanted, template
from sgb_core.drawings.tiles import tiles_of
from sgb_core.findings.errors import FindingError
from tests.sgb_core.drawings.looking import outside, overlaps
from tests.sgb_core.drawings.pdf_reading import read_pdf
from tests.sgb_core.drawings.shapes import BENT, CUP, OTHERS, chain, preset

WET = TemplateWanted()
INSIDE = TemplateWanted(wall=WallSide.INSIDE)
PIECES = {name: document for name, document in OTHERS.items() if name not in ("huge", "mast")}


def cut_lines(drawing: Drawing) -> list[np.ndarray]:
    """Return what is cut, of all pages, in mm of the object."""
    return [
        path.flat() - page.origin
        for page in drawing.pages
        for mark in page.of_layer(Layer.CUT)
        for path in mark.paths
    ]


def together(lines: list[np.ndarray]) -> shapely.Geometry:
    return shapely.union_all([shapely.LineString(line) for line in lines])


@pytest.mark.parametrize("wall", WallSide)
@pytest.mark.parametrize("name", PIECES)
def test_pages_hold_all_and_nothing_lies_over_words(name: str, wall: WallSide) -> None:
    if name == "filled" and wall is WallSide.INSIDE:
        return
    drawing = template(PIECES[name], TemplateWanted(wall=wall))
    for page in drawing.pages:
        assert overlaps(page) == []
        assert outside(page) == []


@pytest.mark.parametrize("paper", PAPERS)
def test_the_control_bar_is_100_mm_on_paper(paper: Paper) -> None:
    drawing = template(preset("vase"), replace(WET, paper=paper))
    for page in read_pdf(pdf_bytes(drawing)).pages:
        assert sorted(page.size) == pytest.approx(sorted(SIZES[paper]), abs=1e-3)
        bars = [path.points() for path in page.paths if path.layer == Layer.SCALE]
        assert any(np.ptp(bar[:, 0]) == pytest.approx(100.0, abs=1e-4) for bar in bars)


def test_the_height_is_true_on_paper() -> None:
    drawing = template(CUP, WET)
    (page,) = read_pdf(pdf_bytes(drawing)).pages
    cut = np.concatenate([path.points() for path in page.paths if path.layer == Layer.CUT])
    assert np.ptp(cut[:, 1]) == pytest.approx(60.0, abs=1e-4)


@pytest.mark.parametrize("name", ["vase", "amphora", "pagoda", "tower"])
def test_tiles_together_are_the_profile(name: str) -> None:
    document = preset(name)
    drawing = template(document, WET)
    whole = together(cut_lines(drawing))
    points = document.profile.sample(301)
    # The disc that it stands on is not cut.
    level = np.ptp(points[..., 1], axis=1) < 1e-9
    expected = points[~level].reshape(-1, 2) * document.unit.millimetres
    assert shapely.distance(whole, shapely.points(expected)).max() < 0.01
    drawn = np.concatenate(cut_lines(drawing))
    curve = shapely.LineString(points.reshape(-1, 2) * document.unit.millimetres)
    assert shapely.distance(curve, shapely.points(drawn)).max() < 0.05


def test_neighbours_share_their_crosses() -> None:
    drawing = template(preset("vase"), WET)
    assert len(drawing.pages) == 2
    crosses = [
        {
            tuple((path.flat().mean(axis=0) - page.origin).round(6).tolist())
            for mark in page.of_layer(Layer.CROSSES)
            for path in mark.paths
        }
        for page in drawing.pages
    ]
    assert [len(each) for each in crosses] == [4, 4]
    assert len(crosses[0] & crosses[1]) == 2


def test_one_page_needs_no_crosses() -> None:
    (page,) = template(CUP, WET).pages
    assert page.of_layer(Layer.CROSSES) == ()


def test_tiles_overlap_and_cover() -> None:
    columns, rows, tiles = tiles_of((0.0, -5.0), (500.0, 300.0), (190.0, 250.0))
    assert (columns, rows) == (3, 2)
    whole = shapely.union_all([shapely.box(t.left, t.low, t.right, t.high) for t in tiles])
    assert whole.contains(shapely.box(0.0, -5.0, 500.0, 300.0))
    assert tiles[0].right - tiles[1].left == pytest.approx(10.0)
    assert tiles[0].high - tiles[columns].low == pytest.approx(10.0)


def shrinking(document: Document) -> Document:
    return replace(document, manufacture=Manufacture(shrinkage=Shrinkage(12.0)))


@pytest.mark.parametrize(("stage", "factor"), [(Stage.WET, 1 / 0.88), (Stage.FIRED, 1.0)])
def test_wet_clay_is_larger(stage: Stage, factor: float) -> None:
    drawing = template(shrinking(CUP), replace(WET, stage=stage))
    height = np.ptp(np.concatenate(cut_lines(drawing))[:, 1])
    assert height == pytest.approx(60.0 * factor, abs=1e-6)
    assert f"{stage} size" in drawing.subject


def test_the_inside_is_a_wall_farther_in() -> None:
    points = np.concatenate(cut_lines(template(CUP, INSIDE)))
    assert points[:, 0].max() == pytest.approx(17.0, abs=1e-6)
    assert points[:, 1].min() == pytest.approx(4.0, abs=1e-6)
    outer = np.concatenate(cut_lines(template(CUP, WET)))
    assert outer[:, 0].max() == pytest.approx(20.0, abs=1e-6)


def test_a_wall_outside_puts_the_board_on_the_wall() -> None:
    document = OTHERS["bent, wall outside"]
    lines = np.concatenate(cut_lines(template(document, WET)))
    away = shapely.distance(
        shapely.LineString(BENT.profile.sample(2001).reshape(-1, 2)), shapely.points(lines)
    )
    # At its ends the wall is led on to the levels of foot and rim.
    assert np.quantile(away, [0.1, 0.9]) == pytest.approx([2.5, 2.5], abs=0.01)
    assert np.median(away) == pytest.approx(2.5, abs=0.01)


def words_of(page: Page) -> list[str]:
    return [mark.text for mark in page.marks if isinstance(mark, Words)]


def test_ticks_are_a_centimetre_apart() -> None:
    (page,) = template(CUP, WET).pages
    ticks = {
        round(float(path.flat()[0, 1] - page.origin[1]), 9)
        for mark in page.of_layer(Layer.SCALE)
        if not isinstance(mark, Words)
        for path in mark.paths
        if len(path.flat()) == 2 and np.ptp(path.flat()[:, 1]) < 1e-9
    }
    assert {0.0, 10.0, 20.0, 30.0, 40.0, 50.0, 60.0} <= ticks
    assert {"0", "1", "2", "3", "4", "5"} <= set(words_of(page))


def test_the_straight_edge_says_how_far_the_axis_is() -> None:
    (page,) = template(CUP, WET).pages
    (said,) = [word for word in words_of(page) if "straight edge" in word]
    (edge,) = [
        path.flat()[:, 0].max() - page.origin[0]
        for mark in page.of_layer(Layer.OUTLINE)
        for path in mark.paths
    ]
    assert f"{edge:.2f} mm from the axis" in said
    inch = replace(CUP, unit=Unit.IN)
    assert len(template(inch, WET).pages) > 1


@pytest.mark.parametrize(
    ("document", "wanted", "words"),
    [
        (OTHERS["filled"], INSIDE, "only a vessel has an inside"),
        (OTHERS["huge"], WET, "at most 100 are made"),
        (chain((5, 5), (5, 5)), WET, "single point"),
    ],
)
def test_what_cannot_be_cut_is_said(document: Document, wanted: TemplateWanted, words: str) -> None:
    with pytest.raises(DrawingError, match=words):
        template(document, wanted)


def test_other_papers_are_refused() -> None:
    with pytest.raises(FindingError, match="Letter"):
        TemplateWanted(Paper.A1)
