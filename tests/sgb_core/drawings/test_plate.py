"""The vessel plate: many vessels at one scale, sides, paint, measures and their uncertainty."""

from __future__ import annotations

import re
from dataclasses import replace
from math import hypot, pi

import numpy as np
import pytest
import shapely

from sgb_core.bodies.solid import BodyKind, Solid
from sgb_core.document.appearance.model import Along, Appearance, LayerKind
from sgb_core.document.appearance.model import Layer as Paint
from sgb_core.document.appearance.picture_file import Picture
from sgb_core.document.appearance.pictures import encode_png
from sgb_core.document.model import Document, Unit
from sgb_core.document.reference import Reference
from sgb_core.drawings.drawing import draw
from sgb_core.drawings.errors import DrawingError
from sgb_core.drawings.page import Area, Layer, Page, Words
from sgb_core.drawings.paint import grey, paint_of
from sgb_core.drawings.plate import capacity_words, plate_page
from sgb_core.drawings.scales import Paper, Scale
from sgb_core.drawings.uncertainty import volume_uncertainty
from sgb_core.drawings.wanted import Fill, Side, Style, Wanted
from sgb_core.findings.errors import FindingError
from tests.sgb_core.drawings.looking import outside, overlaps
from tests.sgb_core.drawings.shapes import BENT, CUP, OTHERS, chain, preset

PLATE = Wanted(Style.VESSEL)
SET = (CUP, BENT, OTHERS["plate"], OTHERS["closed"], preset("bowl"), OTHERS["filled"], CUP)


def words_of(page: Page) -> list[str]:
    return [mark.text for mark in page.marks if isinstance(mark, Words)]


@pytest.mark.parametrize("side", Side)
@pytest.mark.parametrize("fill", Fill)
@pytest.mark.parametrize("count", [1, 3, len(SET)])
def test_vessels_stand_apart_on_one_page(side: Side, fill: Fill, count: int) -> None:
    page, _ = plate_page(SET[:count], replace(PLATE, side=side, fill=fill))
    assert overlaps(page) == []
    assert outside(page) == []
    assert [word for word in words_of(page) if re.fullmatch(r"\d", word) and word != "0"] == [
        str(k + 1) for k in range(count)
    ]


def test_each_vessel_has_the_size_of_the_scale() -> None:
    page, _ = plate_page((CUP, BENT), PLATE)
    outlines = [
        shapely.MultiLineString([path.flat() for path in mark.paths]).bounds
        for mark in page.of_layer(Layer.MATERIAL)
    ]
    boxes = [(right - left, high - low) for left, low, right, high in outlines]
    curve = BENT.profile.sample(2001).reshape(-1, 2)
    expected = [(20.0, 60.0), (curve[:, 0].max(), 95.0)]
    for (wide, high), (radius, height) in zip(boxes, expected, strict=True):
        assert wide / page.scale == pytest.approx(radius, abs=0.01)
        assert high / page.scale == pytest.approx(height, abs=0.01)


def test_the_scale_bar_is_as_long_as_it_says() -> None:
    page, _ = plate_page(SET, PLATE)
    (end,) = [m for m in page.of_layer(Layer.SCALE) if isinstance(m, Words) and "cm" in m.text]
    (start,) = [m for m in page.of_layer(Layer.SCALE) if isinstance(m, Words) and m.text == "0"]
    length = (end.at[0] - start.at[0]) / page.scale
    assert length == pytest.approx(10.0 * float(end.text.removesuffix(" cm")), abs=1e-9)
    fields = [m for m in page.of_layer(Layer.SCALE) if isinstance(m, Area)]
    areas = [shapely.Polygon(field.paths[0].flat()).bounds for field in fields]
    assert min(box[0] for box in areas) == pytest.approx(start.at[0])
    assert max(box[2] for box in areas) == pytest.approx(end.at[0])


def test_the_section_changes_sides() -> None:
    for side, sign in ((Side.RIGHT, 1.0), (Side.LEFT, -1.0)):
        page, _ = plate_page((CUP,), replace(PLATE, side=side))
        (area,) = page.of_layer(Layer.MATERIAL)
        away = (shapely.Polygon(area.paths[0].flat()).centroid.x - page.origin[0]) / page.scale
        assert sign * away > 5.0


def test_the_measures_are_those_of_the_file() -> None:
    words = words_of(plate_page((CUP,), PLATE)[0])
    assert "rim ⌀ 4 cm, H 6 cm" in words
    assert f"{pi * 17**2 * 56 / 1000:.0f} ml" in words
    inch = replace(CUP, unit=Unit.IN)
    assert "rim ⌀ 101.6 cm, H 152.4 cm" in words_of(plate_page((inch,), PLATE)[0])


def test_what_holds_nothing_has_no_capacity() -> None:
    assert capacity_words(OTHERS["closed"]) == ""
    assert capacity_words(chain((20, 0), (20, 60))) == f"{pi * 400 * 60 / 1000:.0f} ml"


TRACED = Reference(name="jar.csv", kind="points", rms_deviation=0.4, left_right=0.6)


def test_a_traced_vessel_tells_how_well_its_capacity_is_known() -> None:
    jar = replace(chain((100, 0), (100, 200)), reference=TRACED)
    area, volume = 2 * pi * 100 * 200, pi * 100**2 * 200
    known = volume_uncertainty(jar, volume)
    assert known == pytest.approx(hypot(0.4 * area, 0.3 * area), rel=1e-9)
    assert capacity_words(jar) == f"{volume / 1e6:.3f} ± {known / 1e6:.3f} l"
    assert volume_uncertainty(chain((100, 0), (100, 200)), volume) is None


def test_a_picture_adds_the_half_pixel_of_its_scale() -> None:
    picture = Picture(encode_png(np.zeros((4, 4, 3), dtype=np.uint8)))
    jar = chain((100, 0), (100, 200))
    kept = replace(TRACED, left_right=None, rms_deviation=0.0, picture=picture, scale=0.5)
    volume = pi * 100**2 * 200
    found = volume_uncertainty(replace(jar, reference=kept), volume)
    # 400 pixels high, each end to half a pixel: the length to 0.18 %, the volume to three times.
    assert found == pytest.approx(volume * 3 * hypot(0.5, 0.5) / 400, rel=1e-9)


def painted(*layers: Paint) -> Document:
    return replace(CUP, appearance=Appearance(drawing=layers))


def test_bands_lie_where_they_are_painted() -> None:
    document = painted(
        Paint(LayerKind.BAND, "#000000", 0.5, 0.75), Paint(LayerKind.RINGS, "#ffffff", 0.0, 0.3)
    )
    bands = [(band.low, band.high) for band in paint_of(document)]
    assert bands[0] == pytest.approx((30.0, 45.0))
    assert len(bands) == 4
    assert bands[1] == pytest.approx((2.1, 3.9))
    page, _ = plate_page((document,), PLATE)
    area = page.of_layer(Layer.PAINT)[0]
    left, low, right, high = shapely.Polygon(area.paths[0].flat()).bounds
    assert (right - left) / page.scale == pytest.approx(20.0, abs=1e-6)
    assert (low - page.origin[1]) / page.scale == pytest.approx(30.0)
    assert (high - page.origin[1]) / page.scale == pytest.approx(45.0)
    assert right == pytest.approx(page.origin[0])
    assert overlaps(page) == []


def test_bands_by_length_and_painted_segments_follow_the_profile() -> None:
    profile = chain((30, 0), (30, 40), (60, 40), (60, 90)).profile
    layers = (
        Paint(LayerKind.BAND, start=0.75, end=1.0, by=Along.LENGTH),
        Paint(LayerKind.SEGMENTS, segments=(0,)),
    )
    document = Document(profile, appearance=Appearance(drawing=layers))
    first, last = paint_of(document)
    assert (first.low, first.high) == pytest.approx((60.0, 90.0), abs=1e-6)
    assert (last.low, last.high) == pytest.approx((0.0, 40.0))


def test_a_gradient_is_drawn_in_steps_that_no_eye_sees() -> None:
    document = painted(
        Paint(LayerKind.GRADIENT, start=0.5, end=1.0, stops=((0.0, "#000000"), (1.0, "#ffffff")))
    )
    bands = paint_of(document)
    assert (bands[0].low, bands[-1].high) == pytest.approx((30.0, 60.0))
    # Each reaches to the end: between two that met a line would show.
    assert all(band.high == bands[-1].high for band in bands)
    assert np.diff([band.low for band in bands]) == pytest.approx(30.0 / len(bands))
    levels = [int(band.colour[1:3], 16) for band in bands]
    assert levels == sorted(levels)
    assert max(np.diff(levels)) <= 5
    page, _ = plate_page((document,), PLATE)
    assert len(page.of_layer(Layer.PAINT)) == len(bands)
    assert len(page.of_layer(Layer.EDGES)) == len(
        plate_page((CUP,), PLATE)[0].of_layer(Layer.EDGES)
    )


@pytest.mark.parametrize("section", Side)
@pytest.mark.parametrize("twist", [0.0, 0.1])
def test_stripes_lie_where_the_eye_sees_them(section: Side, twist: float) -> None:
    """Four stripes an eighth of a turn wide: of the middle ones, cosines tell where they are."""
    document = painted(
        Paint(LayerKind.STRIPES, "#000000", 0.0, 1.0, count=4, width=0.5, twist=twist)
    )
    page, _ = plate_page((document,), replace(PLATE, side=section))
    areas = page.of_layer(Layer.PAINT)
    radius = 20.0 * page.scale
    side = -1.0 if section is Side.RIGHT else 1.0
    seen = shapely.union_all([shapely.Polygon(area.paths[0].flat()).buffer(0) for area in areas])
    for share in (0.25, 0.5, 0.75):
        y = page.origin[1] + 60.0 * share * page.scale
        line = shapely.LineString([(page.origin[0] - radius, y), (page.origin[0] + radius, y)])
        # Of the quarter turn seen the angles, from the section's plane, that stripes cover.
        angles = np.radians(np.linspace(180.0, 270.0, 20001) * (-side))
        turns = 4 * (angles / (2.0 * np.pi) + twist * share)
        covered = np.abs(turns - np.round(turns)) < 0.25
        x = page.origin[0] + side * -np.cos(angles) * radius
        width = np.abs(np.diff(x))[covered[1:]].sum()
        assert seen.intersection(line).length == pytest.approx(width, rel=2e-3)
        for k in (2500, 7500, 12500, 17500):
            point = shapely.Point(x[k], y)
            if seen.boundary.distance(point) > 0.01:
                assert seen.contains(point) == covered[k]


def test_greys_are_as_dark_as_the_colours() -> None:
    levels = [int(grey(colour)[1:3], 16) for colour in ("#000000", "#0000ff", "#ff0000", "#ffffff")]
    assert levels == sorted(levels)
    assert 60 < levels[0] < levels[-1] < 255


def test_a_scale_too_large_is_refused() -> None:
    with pytest.raises(DrawingError, match="at 2:1"):
        plate_page(SET, replace(PLATE, scale=Scale(2, 1), paper=Paper.A4))


def test_numbers_begin_where_they_are_told() -> None:
    assert {"7", "8"} <= set(words_of(plate_page((CUP, BENT), replace(PLATE, first=7))[0]))
    with pytest.raises(FindingError, match="first number"):
        replace(PLATE, first=-1)


def test_a_plate_is_one_page_with_all_names_in_its_title() -> None:
    drawing = draw((CUP, BENT), PLATE)
    assert len(drawing.pages) == 1
    assert drawing.title == f"{CUP.name}, Bent"
    assert drawing.subject.startswith("Vessel plate, ")


def test_edges_inside_show_behind_the_section() -> None:
    document = replace(
        chain((30, 0), (30, 20), (40, 30), (40, 60)), solid=Solid(BodyKind.VESSEL, wall=3, base=3)
    )
    page, _ = plate_page((document,), PLATE)
    levels = [
        path.flat()
        for mark in page.of_layer(Layer.EDGES)
        for path in mark.paths
        if path.flat()[:, 0].max() > page.origin[0] + 1.0
    ]
    ends = [((line - page.origin) / page.scale).max(axis=0) for line in levels]
    # The wall's inside has a corner where the drawn line bends inwards, and an arc at the other.
    assert np.allclose(ends, [(37.0, 30.0 + 3.0 * (2**0.5 - 1.0)), (37.0, 60.0)], atol=0.01)
