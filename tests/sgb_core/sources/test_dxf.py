"""DXF drawings: entities, blocks, layers and units."""

from __future__ import annotations

from collections.abc import Callable
from io import BytesIO, StringIO
from pathlib import Path
from typing import Any

import ezdxf
import numpy as np
import pytest

from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import Segment, ShapeParameters
from sgb_core.document.model import Document, Unit
from sgb_core.exchange.dxf import write_dxf
from sgb_core.findings.sources import NoSource, NoUnit, TooMuch, Unreadable
from sgb_core.sources import Options, SourceError, Taken
from tests.sgb_core.sources.files import apart, taken

AT_ZERO = Options(axis=0.0)


def drawn(
    folder: Path, draw: Callable[[Any, Any], None], options: Options = AT_ZERO, units: int = 4
) -> Taken:
    """Return what is taken from a drawing that ``draw`` fills, given it and its model space."""
    drawing = ezdxf.new("R2010")
    drawing.header["$INSUNITS"] = units
    draw(drawing, drawing.modelspace())
    stream = StringIO()
    drawing.write(stream)
    return taken(folder, "drawing.dxf", stream.getvalue(), options)


def test_lines_are_exact_in_the_drawing_s_unit(tmp_path: Path) -> None:
    def draw(_: Any, space: Any) -> None:
        space.add_line((2, 5), (3, 9))
        space.add_line((2, 5), (1, 0))

    found = drawn(tmp_path, draw, Options(axis=0.0, unit=Unit.CM), units=1)
    assert found.trace.exact
    ends = [segment.points[0] for segment in found.trace.profile.segments]
    np.testing.assert_allclose(ends, np.array([[1, 0], [2, 5]]) * 2.54)
    assert drawn(tmp_path, draw, units=0).notes == (NoUnit("mm"),)


def test_a_cubic_spline_is_kept_to_rounding(tmp_path: Path) -> None:
    points = [(10.0, 0.0), (40.0, 10.0), (50.0, 50.0), (20.0, 70.0)]

    def draw(_: Any, space: Any) -> None:
        space.add_open_spline([(*point, 0.0) for point in points], degree=3)

    found = drawn(tmp_path, draw)
    (segment,) = found.trace.profile.segments
    np.testing.assert_allclose(segment.points, points, atol=1e-12)
    assert found.trace.exact


def test_a_bulge_is_an_arc(tmp_path: Path) -> None:
    def draw(_: Any, space: Any) -> None:
        space.add_lwpolyline([(30, 0, 1.0), (30, 40, 0.0), (30, 60, 0.0)], format="xyb")

    found = drawn(tmp_path, draw)
    angle = np.linspace(-np.pi / 2, np.pi / 2, 33)
    half = np.stack([30 + 20 * np.cos(angle), 20 + 20 * np.sin(angle)], axis=1)
    assert apart(found.trace.profile, half) < 1e-5
    assert apart(found.trace.profile, np.array([[30.0, 50.0]])) < 1e-9
    assert not found.trace.exact


@pytest.mark.parametrize("ratio", [1.0, 0.5])
def test_arcs_and_ellipses_are_followed(tmp_path: Path, ratio: float) -> None:
    def draw(_: Any, space: Any) -> None:
        if ratio == 1.0:
            space.add_arc((0, 0), 20.0, -90.0, 90.0)
        else:
            space.add_ellipse((0, 0), (20.0, 0.0), ratio, -np.pi / 2, np.pi / 2)

    found = drawn(tmp_path, draw)
    angle = np.linspace(-np.pi / 2, np.pi / 2, 65)
    half = np.stack([20 * np.cos(angle), ratio * 20 * np.sin(angle)], axis=1)
    assert apart(found.trace.profile, half) < 1e-5


def test_blocks_come_moved_scaled_and_mirrored(tmp_path: Path) -> None:
    def draw(drawing: Any, space: Any) -> None:
        inner = drawing.blocks.new("inner")
        inner.add_arc((1, 0), 1.0, -90.0, 90.0)
        outer = drawing.blocks.new("outer")
        outer.add_blockref("inner", (1, 0))
        space.add_blockref("outer", (10, 5), dxfattribs={"xscale": 2.0, "yscale": 2.0})
        space.add_blockref("outer", (300, 5), dxfattribs={"xscale": -1.0, "yscale": 1.0})

    found = drawn(tmp_path, draw)
    angle = np.linspace(-np.pi / 2, np.pi / 2, 33)
    half = np.stack([14 + 2 * np.cos(angle), 5 + 2 * np.sin(angle)], axis=1)
    assert apart(found.trace.profile, half) < 1e-5


def test_a_layer_named_generatrix_and_one_named_axis_are_meant(tmp_path: Path) -> None:
    def draw(drawing: Any, space: Any) -> None:
        for layer in ("GENERATRIX", "AXIS"):
            drawing.layers.add(layer)
        space.add_line((0, 0), (0, 500))
        space.add_line((7, 0), (7, 100), dxfattribs={"layer": "AXIS"})
        space.add_line((10, 0), (12, 30), dxfattribs={"layer": "GENERATRIX"})

    found = drawn(tmp_path, draw, Options())
    assert found.axis == (7.0,)
    (segment,) = found.trace.profile.segments
    np.testing.assert_allclose(segment.points[[0, 3]], [[3, 0], [5, 30]])


def test_our_own_files_come_back_whole(tmp_path: Path) -> None:
    points = [[20.0, 0.0], [60.0, 10.0], [50.0, 40.0], [30.0, 50.0]]
    segment = Segment(np.array(points), ShapeParameters(2.0, 4.5, 0.25, 0.875))
    profile = Profile.of([segment, Segment(np.add(points, (10.0, 50.0)))])
    for unit in Unit:
        stream = BytesIO()
        write_dxf(Document(profile, "jar", unit), stream)
        found = taken(tmp_path, "jar.dxf", stream.getvalue(), Options(unit=unit))
        np.testing.assert_allclose(found.trace.profile.quartics, profile.quartics, atol=1e-9)
        assert found.notes == ()


def test_blocks_inside_themselves_are_refused(tmp_path: Path) -> None:
    def draw(drawing: Any, space: Any) -> None:
        block = drawing.blocks.new("loop")
        block.add_line((1, 0), (2, 1))
        block.add_blockref("loop", (1, 1))
        block.add_blockref("loop", (2, 1))
        space.add_blockref("loop", (0, 0))

    with pytest.raises(SourceError) as error:
        drawn(tmp_path, draw)
    assert isinstance(error.value.finding, TooMuch)


def test_many_blocks_in_many_blocks_are_refused(tmp_path: Path) -> None:
    def draw(drawing: Any, space: Any) -> None:
        drawing.blocks.new("0").add_line((1, 0), (2, 1))
        for k in range(12):
            block = drawing.blocks.new(str(k + 1))
            for _ in range(10):
                block.add_blockref(str(k), (1, 1))
        space.add_blockref("12", (0, 0))

    with pytest.raises(SourceError) as error:
        drawn(tmp_path, draw)
    assert isinstance(error.value.finding, TooMuch)


@pytest.mark.parametrize(
    "data",
    [b"not a drawing", b"\x89PNG\r\n\x1a\n\0\0", b"0\nSECTION\n2\nENT", b"\0" * 100],
    ids=["prose", "a picture", "cut off", "zeros"],
)
def test_what_is_no_dxf_is_refused_in_one_line(tmp_path: Path, data: bytes) -> None:
    with pytest.raises(SourceError) as error:
        taken(tmp_path, "drawing.dxf", data)
    assert isinstance(error.value.finding, Unreadable | NoSource)
    assert "\n" not in str(error.value)


def test_a_drawing_of_text_alone_has_no_path(tmp_path: Path) -> None:
    with pytest.raises(SourceError) as error:
        drawn(tmp_path, lambda _, space: space.add_text("jar"))
    assert error.value.finding is NoSource.NO_PATH


def test_a_spline_that_does_not_end_at_its_points_is_sampled_and_a_huge_one_refused(
    tmp_path: Path,
) -> None:
    def spline(count: int) -> bytes:
        drawing = ezdxf.new()
        drawing.header["$INSUNITS"] = 4
        drawn = drawing.modelspace().add_spline(degree=3)
        drawn.control_points = [(20.0 + 5.0 * np.sin(i / 4.0), i, 0.0) for i in range(count)]
        drawn.knots = range(count + 4)
        stream = StringIO()
        drawing.write(stream)
        return stream.getvalue().encode()

    found = taken(tmp_path, "free.dxf", spline(30), Options(axis=0.0))
    # A uniform cubic spline runs at the middle of three points, weighed 1, 4, 1.
    points = np.array([(20.0 + 5.0 * np.sin(i / 4.0), i) for i in range(30)])
    places = (points[:-2] + 4.0 * points[1:-1] + points[2:]) / 6.0
    assert apart(found.trace.profile, places) < 2e-3
    with pytest.raises(SourceError, match="more than 50000 points of a spline"):
        taken(tmp_path, "huge.dxf", spline(50_001))
