"""SVG, PDF and DXF of one drawing, read back by readers of others and by one of our own."""

from __future__ import annotations

import re
from dataclasses import replace
from io import BytesIO, StringIO
from xml.etree import ElementTree

import ezdxf
import numpy as np
import pytest
import shapely
import svgelements

from sgb_core.bodies.solid import Rim
from sgb_core.document.model import Document
from sgb_core.drawings.drawing import draw, write_drawing
from sgb_core.drawings.dxf import drawing_dxf
from sgb_core.drawings.errors import DrawingError
from sgb_core.drawings.fonts import width
from sgb_core.drawings.page import Drawing, Layer, Words
from sgb_core.drawings.pdf import pdf_bytes
from sgb_core.drawings.section import TOLERANCE
from sgb_core.drawings.svg import svg_bytes
from sgb_core.drawings.wanted import Side, Wanted
from tests.sgb_core.drawings.pdf_reading import read_pdf
from tests.sgb_core.drawings.shapes import BENT, CUP, OTHERS, preset

# A rounded rim takes the place of a little of the curve.
FLAT = replace(BENT, solid=replace(BENT.solid, rim=Rim.FLAT))
DOCUMENTS = {"cup": CUP, "bent": FLAT, "vase": preset("vase"), "tower": preset("tower")}
SIDES = {"vase": Side.LEFT}


def drawn(name: str) -> Drawing:
    return draw([DOCUMENTS[name]], Wanted(side=SIDES.get(name, Side.RIGHT), day="2026-03-31"))


def true_curve(document: Document, mirrored: bool) -> np.ndarray:
    """Return points of the drawn profile in mm of the object."""
    points = document.profile.sample(101).reshape(-1, 2) * document.unit.millimetres
    return points * (-1.0 if mirrored else 1.0, 1.0)


def farthest(points: np.ndarray, lines: list[np.ndarray]) -> float:
    drawn_lines = shapely.union_all([shapely.LineString(line) for line in lines])
    return float(shapely.distance(drawn_lines, shapely.points(points)).max())


@pytest.mark.parametrize("name", DOCUMENTS)
def test_svg_has_the_curve_within_the_stated_tolerance(name: str) -> None:
    drawing = drawn(name)
    page, data = drawing.pages[0], svg_bytes(drawing)
    svg = svgelements.SVG.parse(BytesIO(data), ppi=25.4)
    # The millimetre of svgelements is off by a little.
    assert float(svg.width) == pytest.approx(page.width, rel=1e-5)
    (group,) = [each for each in svg.select() if each.id == "outline"]
    lines = []
    for path in group.select(lambda each: isinstance(each, svgelements.Path)):
        for part in path.segments():
            if isinstance(part, svgelements.Move) or part.start is None:
                continue
            places = [part.point(t) for t in np.linspace(0.0, 1.0, 200)]
            lines.append(np.array([(p.x, page.height - p.y) for p in places]))
    stated = float(re.search(rb"curves within ([\d.e-]+) mm", data)[1])
    curve = true_curve(DOCUMENTS[name], SIDES.get(name) is Side.LEFT) * page.scale + page.origin
    assert farthest(curve, lines) <= stated + 2e-4
    assert stated == TOLERANCE


@pytest.mark.parametrize("name", DOCUMENTS)
def test_dxf_has_the_curve_at_true_size(name: str) -> None:
    drawing = drawn(name)
    data = drawing_dxf(drawing)
    read = ezdxf.read(StringIO(data.decode()))
    assert read.header["$INSUNITS"] == 4
    assert [str(error) for error in read.audit().errors] == []
    space = read.modelspace()
    lines = []
    for entity in space.query('*[layer=="OUTLINE"]'):
        if entity.dxftype() == "LINE":
            lines.append(np.array([entity.dxf.start.vec2, entity.dxf.end.vec2]))
        else:
            flat = list(entity.construction_tool().flattening(1e-5, 16))
            lines.append(np.array([(p.x, p.y) for p in flat]))
    said = dict(read.header.custom_vars.properties)
    stated = float(re.search(r"curves within ([\d.e-]+) mm", said["Subject"])[1])
    curve = true_curve(DOCUMENTS[name], SIDES.get(name) is Side.LEFT)
    assert farthest(curve, lines) <= stated + 1e-5 * np.ptp(curve)
    assert {"OUTLINE", "AXIS", "DIMENSIONS", "FRAME", "TEXT"} <= {
        layer.dxf.name for layer in read.layers
    }
    assert said["Title"] == DOCUMENTS[name].name
    texts = {entity.dxf.text for entity in space.query("TEXT")}
    assert {w.text for w in drawing.pages[0].marks if isinstance(w, Words)} == texts


@pytest.mark.parametrize("name", DOCUMENTS)
def test_pdf_has_the_curve_and_the_words(name: str) -> None:
    drawing = drawn(name)
    page = drawing.pages[0]
    read = read_pdf(pdf_bytes(drawing))
    (got,) = read.pages
    assert got.size == pytest.approx((page.width, page.height), abs=1e-4)
    lines = [path.points() for path in got.paths if path.layer == Layer.OUTLINE]
    curve = true_curve(DOCUMENTS[name], SIDES.get(name) is Side.LEFT)
    assert farthest(curve * page.scale + page.origin, lines) <= TOLERANCE + 2e-4
    expected = [mark for mark in page.marks if isinstance(mark, Words)]
    assert sorted(text for text, *_ in got.words) == sorted(mark.text for mark in expected)
    for text, _, length, size in got.words:
        assert length == pytest.approx(width(text, size * 0.729), rel=2e-3)
    assert read.about["Title"] == DOCUMENTS[name].name
    assert "Dimensioned section" in read.about["Subject"]
    widths = {round(path.width, 3) for path in got.paths if path.operator == "S"}
    assert {0.5, 0.25, 0.7} <= widths


def test_the_letters_of_a_pdf_travel_with_it() -> None:
    read = read_pdf(pdf_bytes(drawn("cup")))
    words = {letter for text, *_ in read.pages[0].words for letter in text}
    cmap = read.font.getBestCmap()
    assert words - {chr(code) for code in cmap} == set()
    glyphs = read.font["glyf"]
    assert all(glyphs[cmap[ord(letter)]].numberOfContours > 0 for letter in words - {" "})
    # No more than those: a part of the font is embedded.
    assert len(cmap) < 80


def test_words_of_svg_are_words_and_carry_their_letters() -> None:
    root = ElementTree.fromstring(svg_bytes(drawn("cup")))
    space = "{http://www.w3.org/2000/svg}"
    texts = {text.text for text in root.iter(f"{space}text")}
    assert {"⌀40", "60", CUP.name} <= texts
    assert "font/woff;base64," in root.find(f"{space}style").text
    assert root.find(f"{space}title").text == CUP.name
    groups = [group.get("id") for group in root.iter(f"{space}g")]
    assert len(groups) == len(set(groups))


@pytest.mark.parametrize("make", [svg_bytes, pdf_bytes, drawing_dxf])
def test_the_same_drawing_gives_the_same_file(make) -> None:
    assert make(drawn("bent")) == make(drawn("bent"))


def test_letters_that_no_font_has_are_no_obstacle() -> None:
    drawing = draw([Document(CUP.profile, name="花瓶 \U0001f3fa")], Wanted())
    assert read_pdf(pdf_bytes(drawing)).about["Title"] == "花瓶 \U0001f3fa"
    ElementTree.fromstring(svg_bytes(drawing))
    ezdxf.read(StringIO(drawing_dxf(drawing).decode()))


def test_several_sections_are_pages_of_one_pdf(tmp_path) -> None:
    drawing = draw([CUP, OTHERS["plate"]], Wanted())
    write_drawing(drawing, tmp_path / "both.pdf")
    assert len(read_pdf((tmp_path / "both.pdf").read_bytes()).pages) == 2
    with pytest.raises(DrawingError, match="needs PDF"):
        write_drawing(drawing, tmp_path / "both.svg")
    with pytest.raises(DrawingError, match=r"allowed are \.svg \.pdf \.dxf"):
        write_drawing(drawing, tmp_path / "both.png")
    assert [path.name for path in tmp_path.iterdir()] == ["both.pdf"]
