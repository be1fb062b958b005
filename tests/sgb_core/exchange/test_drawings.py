"""SVG, DXF and STEP of a document, read back by programs and parsers of others."""

import subprocess
import sys
from dataclasses import replace
from io import BytesIO, StringIO
from xml.etree import ElementTree

import ezdxf
import numpy as np
import pytest

import resources
from sgb_core import exchange
from sgb_core.bodies.cut_outs import CutOut, HoleShape
from sgb_core.bodies.solid import BodyKind, Solid
from sgb_core.curves.profile import JointRule, Profile
from sgb_core.curves.segment import Segment, ShapeParameters
from sgb_core.document.file import project_file
from sgb_core.document.model import Document, Revolution, Unit
from sgb_core.exchange.dxf import write_dxf
from sgb_core.exchange.errors import ExportError
from sgb_core.exchange.step import write_step
from sgb_core.exchange.svg import write_svg
from sgb_core.surfaces import measures
from sgb_core.surfaces.placement import Placement
from sgb_core.surfaces.revolution import Axis
from tests.sgb_core.exchange.step_files import read_step

SHAPE = ShapeParameters(2, 4, 0.5, 0.9)
LOWER = Segment([(0, 0), (30, 0), (40, 20), (35, 40)], SHAPE)
UPPER = Segment([(35, 40), (30, 60), (10, 62), (12, 80)], SHAPE)
POT = Document(Profile.of([LOWER, UPPER], ["G1"]), name="Pot <1>", unit=Unit.CM)
BALL = Document(Profile((Segment([(0, 0), (13, 0), (13, 20), (0, 20)], SHAPE),)))


def written(write, document, *rest):
    stream = BytesIO()
    write(document, stream, *rest)
    return stream.getvalue()


def preset(name):
    return project_file.loads(resources.load_preset(name))


def test_svg_has_true_size_and_passes_through_the_curve():
    root = ElementTree.fromstring(written(write_svg, POT, 1e-4))
    space = "{http://www.w3.org/2000/svg}"
    assert root.get("width").endswith("cm")
    x, y, width, height = map(float, root.get("viewBox").split())
    assert float(root.get("width")[:-2]) == width
    assert root.find(f"{space}title").text == "Pot <1>"
    path = next(p for p in root.iter(f"{space}path") if p.get("id") == "generatrix")
    words = path.get("d").split()
    assert words[0] == "M"
    assert words.count("M") == 1
    numbers = np.array([float(w) for w in words if w not in "MCZ"]).reshape(-1, 2)
    assert np.allclose(numbers[0], (0, 0))
    assert np.allclose(numbers[-1], (12, -80))
    assert (numbers[:, 0] >= x).all()
    assert (numbers[:, 0] <= x + width).all()
    assert (numbers[:, 1] >= y).all()
    assert (numbers[:, 1] <= y + height).all()


def test_svg_of_a_ring_is_closed_and_of_a_torn_chain_has_two_runs():
    ring = written(write_svg, preset("ring")).decode()
    assert " Z" in ring
    far = Segment(UPPER.points + 100.0)
    torn = Document(Profile((LOWER, far), (JointRule.FREE,)))
    assert written(write_svg, torn).decode().count("M ") == 3  # with the axis' own


def test_dxf_splines_are_the_very_curve():
    drawing = ezdxf.read(StringIO(written(write_dxf, POT).decode()))
    assert not drawing.audit().has_errors
    assert drawing.header["$INSUNITS"] == 5
    splines = drawing.modelspace().query("SPLINE")
    assert len(splines) == 2
    for spline, segment in zip(splines, POT.profile.segments, strict=True):
        points = list(spline.construction_tool().approximate(20))
        true = segment.point(np.linspace(0, 1, 21))
        assert np.allclose([(p.x, p.y) for p in points], true, rtol=0, atol=1e-12)


@pytest.mark.parametrize("axis", list(Axis))
@pytest.mark.parametrize("unit", [Unit.MM, Unit.IN])
def test_step_of_a_closed_surface_is_a_solid_of_its_volume(tmp_path, axis, unit):
    pytest.importorskip("OCP")
    document = replace(
        BALL,
        unit=unit,
        revolution=Revolution(axis, 30.0),
        placement=Placement((10, 20, 30), (1, 2, 3)),
    )
    data = written(write_step, document)
    assert b"AP242" in data
    read = read_step(data, tmp_path)
    assert read.shape.ShapeType().name == "TopAbs_SOLID"
    k = unit.millimetres
    assert read.volume == pytest.approx(measures.volume(document.surface) * k**3, rel=1e-6)
    assert read.area == pytest.approx(measures.area(document.surface) * k**2, rel=1e-6)


def test_step_of_an_open_surface_is_a_shell_and_filled_a_solid(tmp_path):
    pytest.importorskip("OCP")
    shell = read_step(written(write_step, POT), tmp_path)
    assert shell.shape.ShapeType().name == "TopAbs_SHELL"
    assert shell.area == pytest.approx(100 * measures.area(POT.surface), rel=1e-6)
    filled = replace(POT, solid=Solid(BodyKind.FILLED))
    read = read_step(written(write_step, filled), tmp_path)
    assert read.shape.ShapeType().name == "TopAbs_SOLID"
    assert read.volume == pytest.approx(1000 * measures.volume(POT.surface), rel=1e-6)


def test_step_of_a_partial_sweep_of_a_filled_body(tmp_path):
    pytest.importorskip("OCP")
    part = replace(POT, solid=Solid(BodyKind.FILLED), revolution=Revolution(sweep_deg=250.0))
    read = read_step(written(write_step, part), tmp_path)
    assert read.shape.ShapeType().name == "TopAbs_SOLID"
    assert read.volume == pytest.approx(1000 * measures.volume(part.surface), rel=1e-6)


def test_step_names_its_product_whatever_the_name(tmp_path):
    pytest.importorskip("OCP")
    data = written(write_step, replace(BALL, name="Ann's \\ tea\npot ☕"))
    assert b"PRODUCT('Ann''s \\\\ tea?pot ?','Ann''s" in data
    read_step(data, tmp_path)


def test_step_says_on_standard_output_only_what_it_holds(tmp_path):
    pytest.importorskip("OCP")
    source, target = tmp_path / "ball.sgb", tmp_path / "ball.step"
    project_file.save(BALL, source)
    done = subprocess.run(
        [sys.executable, "-m", "app", "export", str(source), str(target)],
        capture_output=True,
        text=True,
        check=True,
    )
    assert (done.stdout, done.stderr) == ("One solid, exact: 1 face, no mesh\n", "")
    assert target.read_bytes().startswith(b"ISO-10303-21")


@pytest.mark.parametrize(
    ("document", "words"),
    [
        (replace(preset("lantern"), cut_outs=(CutOut(HoleShape.TEXT, text="A"),)), "cut_outs"),
        (Document(Profile((Segment([(2, 0), (-4, 3), (-4, 6), (2, 9)]),))), "axis"),
        (Document(Profile((Segment([(1, 0), (30, 9), (-20, 9), (9, 0)]),))), "cross"),
    ],
)
def test_step_refuses_in_one_line_what_has_no_exact_form(document, words, tmp_path):
    path = tmp_path / "body.step"
    with pytest.raises(ExportError, match=words) as caught:
        exchange.write(document, path)
    assert "\n" not in str(caught.value)
    assert not path.exists()
