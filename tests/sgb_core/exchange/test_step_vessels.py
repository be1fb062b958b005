"""STEP of vessels: one valid solid, what is drawn exact, walls as near as they are said to be."""

from __future__ import annotations

import re
from dataclasses import replace
from math import pi

import numpy as np
import pytest
import shapely
from scipy.interpolate import BSpline

from app.__main__ import main
from sgb_core.bodies.cross_section import cross_section
from sgb_core.bodies.meridian import SolidError
from sgb_core.bodies.outline import Role, Trace
from sgb_core.bodies.solid import BodyKind, Rim, Solid, WallSide
from sgb_core.curves.crossings import self_intersections
from sgb_core.curves.primitives import cubic, line
from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import Segment, ShapeParameters
from sgb_core.document.file import project_file
from sgb_core.document.model import Document, Revolution, Unit
from sgb_core.exchange.errors import ExportError
from sgb_core.exchange.format import Request
from sgb_core.exchange.registry import FORMATS
from sgb_core.exchange.step import writer
from sgb_core.exchange.step.writer import step_parts
from sgb_core.findings.bodies import TouchingCircle
from sgb_core.findings.exports import NoStep
from sgb_core.surfaces.fineness import Fineness
from sgb_core.surfaces.revolution import Axis
from tests.sgb_core.exchange.shapes import ring
from tests.sgb_core.exchange.step_files import stepped

TUBE = Profile.of([line((20.0, 0.0), (20.0, 60.0))])
CUP = Solid(BodyKind.VESSEL, wall=3.0, base=4.0)
VASE = Document(
    Profile.of(
        [
            Segment([(15, 0), (45, 20), (40, 50), (20, 60)], ShapeParameters(2, 4, 1, 0.6)),
            cubic([(20, 60), (10, 65), (14, 75), (22, 82)]),
        ]
    ),
    solid=Solid(BodyKind.VESSEL, wall=2.5, base=3.0),
)


def _said(document: Document, tolerance: float | None = None) -> str:
    return FORMATS[".step"].contents(Request(document, Fineness(tolerance)))


def _random(rng: np.random.Generator) -> Document:
    """Return a vessel: poles with vanishing ends, punts, rings, points in place of segments."""
    while True:
        count = int(rng.integers(1, 4))
        radii = rng.uniform(8.0, 40.0, 3 * count + 1)
        heights = np.concatenate([[0.0], rng.uniform(2.0, 15.0, 3 * count).cumsum()])
        if rng.random() < 0.3:
            radii[0] = 0.0
        if rng.random() < 0.15:
            radii[0], heights[:3] = 0.0, (6.0, 6.0, 0.0)
        if rng.random() < 0.15:
            radii[-1] = 0.0
        shapes = rng.uniform((0.0, 0.0, 0.0, 0.0), (4.0, 6.0, 4.0, 1.0), (count, 4))
        if rng.random() < 0.5:
            shapes[0, [0, 3]] = 4.0, 1.0
            shapes[-1, [2, 3]] = 4.0, 1.0
        points = np.stack([radii, heights], axis=1)
        segments = [
            Segment(points[3 * k : 3 * k + 4], ShapeParameters(*shapes[k])) for k in range(count)
        ]
        if rng.random() < 0.3:
            segments.insert(0, Segment([points[0]] * 4))
        profile = Profile.of(segments)
        if not self_intersections(profile):
            break
    solid = Solid(
        BodyKind.VESSEL,
        wall=float(rng.uniform(1.0, 4.0)),
        side=WallSide.INSIDE if rng.random() < 0.5 else WallSide.OUTSIDE,
        base=float(rng.choice([0.0, 2.0, 4.0])),
        rim=Rim.ROUND if rng.random() < 0.5 else Rim.FLAT,
        drain_hole=float(rng.choice([0.0, 0.0, 4.0])),
        foot_ring=float(rng.choice([0.0, 0.0, 3.0])),
    )
    sweep = 360.0 if rng.random() < 0.6 else 270.0
    turn = Revolution(list(Axis)[int(rng.integers(3))], float(rng.uniform(0.0, 360.0)), sweep)
    return Document(profile, solid=solid, revolution=turn)


@pytest.mark.parametrize("start", range(0, 60, 15))
def test_random_vessels_are_single_solids_of_their_material(tmp_path, start) -> None:
    made = 0
    for seed in range(start, start + 15):
        document = _random(np.random.default_rng(seed))
        try:
            section = cross_section(document.surface, document.solid)
        except SolidError as error:
            # No room for a hole, a ring or a cavity: the same line as everywhere.
            with pytest.raises(ExportError, match=re.escape(str(error))):
                step_parts(document)
            continue
        if any(isinstance(finding, TouchingCircle) for finding in section.findings):
            with pytest.raises(ExportError) as refused:
                step_parts(document)
            assert refused.value.finding is NoStep.TOUCHES
            continue
        assert len(section.outlines) == 1
        read = stepped(document, tmp_path)
        assert read.solids == 1
        assert read.volume == pytest.approx(document.body().material_volume, rel=1e-3)
        made += 1
    assert made > 10


@pytest.mark.parametrize("sweep", [360.0, 200.0])
@pytest.mark.parametrize("unit", [Unit.MM, Unit.CM])
def test_a_straight_cup_is_exact(tmp_path, sweep, unit) -> None:
    document = Document(TUBE, unit=unit, solid=CUP, revolution=Revolution(sweep_deg=sweep))
    read = stepped(document, tmp_path)
    # Outside, rim, inside, floor, underside.
    assert (read.solids, read.faces) == (1, 5 if sweep == 360.0 else 7)
    share = sweep / 360.0 * unit.millimetres**3
    exact = pi * (20.0**2 * 60.0 - 17.0**2 * 56.0) * share
    assert read.volume == pytest.approx(exact, rel=1e-9)


@pytest.mark.parametrize("side", WallSide)
@pytest.mark.parametrize("rim", Rim)
def test_walls_come_as_near_as_asked_and_material_with_them(tmp_path, side, rim) -> None:
    document = replace(VASE, solid=replace(VASE.solid, side=side, rim=rim))
    true = document.body().material_volume
    for tolerance in (1e-2, 1e-4, 1e-6):
        within = re.search(r"fitted within ([0-9.e-]+) mm", _said(document, tolerance))
        assert within is not None
        assert float(within[1]) <= tolerance
        (part,) = step_parts(document, tolerance)
        assert _farthest(document, part) <= tolerance
        read = stepped(document, tmp_path, tolerance)
        # The wall's area times the tolerance, and what the reader's own integrals leave.
        slack = tolerance * document.body().measures.inner_area + 1e-6 * true
        assert abs(read.volume - true) <= 2.0 * slack


def _farthest(document: Document, part) -> float:
    """Return how far points of the fitted curves lie from the moved curves, by brute force."""
    section = cross_section(document.surface, document.solid)
    pieces = [piece for outline in section.outlines for piece in outline.exterior]
    moved = [piece for piece in pieces if isinstance(piece, Trace) and piece.role is Role.WALL]
    # Chords of so many points stray by far less than any tolerance here.
    true = shapely.MultiLineString(
        [piece.points(np.linspace(piece.start, piece.end, 50_001)) for piece in moved]
    )
    worst = 0.0
    for curve in part.curves:
        if curve.deviation == 0.0:
            continue
        points = BSpline(curve.knots, curve.poles, curve.degree)(np.linspace(0.0, 1.0, 57))
        worst = max(worst, float(shapely.distance(true, shapely.points(points)).max()))
    return worst


def test_the_drawn_side_is_exact_in_one_face_a_segment() -> None:
    (part,) = step_parts(VASE)
    drawn = [curve for curve in part.curves if getattr(curve, "degree", 0) == 4]
    assert len(drawn) == len(VASE.profile)
    for curve, quartic in zip(drawn, VASE.profile.quartics, strict=True):
        assert curve.poles == pytest.approx(quartic, abs=1e-12)


def test_hollow_bodies_and_tubes_have_their_hollow_inside(tmp_path) -> None:
    drop = Profile((Segment([(0.0, 0.0), (40.0, 0.0), (40.0, 60.0), (0.0, 60.0)]),))
    for document in (Document(drop, solid=CUP), replace(ring(), solid=CUP)):
        for sweep in (360.0, 270.0):
            turned = replace(document, revolution=Revolution(sweep_deg=sweep))
            read = stepped(turned, tmp_path)
            assert read.solids == 1
            assert read.volume == pytest.approx(turned.body().material_volume, rel=1e-4)


def test_the_line_says_what_is_exact_and_what_is_fitted(tmp_path, capsys) -> None:
    said = _said(VASE)
    assert re.fullmatch(r"One solid: 5 faces exact, 2 fitted within [0-9.e-]+ mm, no mesh", said)
    project_file.save(VASE, tmp_path / "vase.sgb")
    source, out = str(tmp_path / "vase.sgb"), tmp_path / "vase.step"
    assert main(["export", source, str(out)]) == 0
    assert capsys.readouterr().out == f"{said}\n"
    assert main(["export", source, str(out), "--tolerance", "1e-6"]) == 0
    assert capsys.readouterr().out == f"{_said(VASE, 1e-6)}\n"


def test_what_is_told_of_a_file_is_fitted_only_once(tmp_path, monkeypatch) -> None:
    fits = []
    made = writer.section_parts
    monkeypatch.setattr(writer, "section_parts", lambda *given: fits.append(given) or made(*given))
    document = replace(VASE, solid=replace(VASE.solid, wall=2.7))
    format_ = FORMATS[".step"]
    format_.contents(Request(document))
    with (tmp_path / "vase.step").open("wb") as stream:
        writer.write_step(document, stream)
    format_.contents(Request(replace(document, name="Other")))
    assert len(fits) == 1
    format_.contents(Request(document, Fineness(0.02)))
    assert len(fits) == 2
