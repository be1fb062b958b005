"""STEP where kernels fail: vanishing ends at poles, rings, touches of the axis, no length."""

from __future__ import annotations

import sys
from dataclasses import replace
from io import BytesIO
from math import pi

import numpy as np
import pytest

from sgb_core.bodies.solid import BodyKind, Solid
from sgb_core.curves.crossings import self_intersections
from sgb_core.curves.primitives import cubic, line
from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import Segment, ShapeParameters
from sgb_core.document.model import Document, Revolution
from sgb_core.exchange.errors import ExportError
from sgb_core.exchange.format import Request
from sgb_core.exchange.registry import FORMATS
from sgb_core.exchange.step import write_step
from sgb_core.findings.bodies import NoBodyFor
from sgb_core.findings.exports import KernelFailure, NoExport
from sgb_core.surfaces.placement import Placement
from sgb_core.surfaces.revolution import Axis
from tests.sgb_core.exchange.step_files import stepped

FILLED = Solid(BodyKind.FILLED)
SHAPE = ShapeParameters(2, 4, 0.5, 0.9)
DROP = [(0.0, 0.0), (40.0, 0.0), (40.0, 60.0), (0.0, 60.0)]
SQUARE = Profile.of(
    [
        line((10.0, 0.0), (20.0, 0.0)),
        line((20.0, 0.0), (20.0, 10.0)),
        line((20.0, 10.0), (10.0, 10.0)),
        line((10.0, 10.0), (10.0, 0.0)),
    ],
    closed=True,
)
# One segment whose ends meet, off the axis and on it.
LOOP = Profile.of([Segment([(20.0, 0.0), (60.0, -20.0), (60.0, 40.0), (20.0, 0.0)])], closed=True)
HORN = Profile.of([Segment([(0.0, 0.0), (60.0, -20.0), (60.0, 40.0), (0.0, 0.0)])], closed=True)
# r(s) = 21 (2s − 1)²: touches the axis half way, inside the segment.
HOURGLASS = Profile.of([cubic([(21.0, 0.0), (-7.0, 30.0), (-7.0, 60.0), (21.0, 90.0)])])


def contents(document: Document) -> str:
    return FORMATS[".step"].contents(Request(document))


def random_profile(rng: np.random.Generator, vanishing: tuple[bool, bool]) -> Profile:
    """Return a simple profile of one to three segments from pole to pole."""
    while True:
        count = int(rng.integers(1, 4))
        radii = rng.uniform(5.0, 40.0, 3 * count + 1)
        radii[[0, -1]] = 0.0
        heights = np.concatenate([[0.0], rng.uniform(2.0, 15.0, 3 * count).cumsum()])
        points = np.stack([radii, heights], axis=1)
        shapes = rng.uniform((0.2, 2.0, 0.2, 0.0), (4.0, 4.0, 4.0, 1.0), (count, 4))
        if vanishing[0]:
            shapes[0, [0, 3]] = 4.0, 1.0
        if vanishing[1]:
            shapes[-1, [2, 3]] = 4.0, 1.0
        profile = Profile.of(
            Segment(points[3 * k : 3 * k + 4], ShapeParameters(*shapes[k])) for k in range(count)
        )
        if not self_intersections(profile):
            return profile


@pytest.mark.parametrize("vanishing", [(True, False), (False, True), (True, True)])
def test_vanishing_ends_at_poles_give_solids_of_the_right_volume(tmp_path, vanishing) -> None:
    rng = np.random.default_rng(4)
    for turn in range(16):
        sweep = 360.0 if turn % 4 else float(rng.uniform(5.0, 355.0))
        profile = random_profile(rng, vanishing)
        document = Document(profile, solid=FILLED, revolution=Revolution(sweep_deg=sweep))
        read = stepped(document, tmp_path)
        assert read.solids == 1
        assert read.volume == pytest.approx(document.volume, rel=1e-9)


def test_a_spire_whose_derivative_vanishes_at_its_tip_is_a_cone(tmp_path) -> None:
    spire = Segment(line((30.0, 0.0), (0.0, 60.0)).points, ShapeParameters(1, 3, 4, 1))
    read = stepped(Document(Profile((spire,)), solid=FILLED), tmp_path)
    assert (read.solids, read.faces) == (1, 2)
    assert read.volume == pytest.approx(pi * 30.0**2 * 60.0 / 3.0, rel=1e-9)


@pytest.mark.parametrize("profile", [SQUARE, LOOP, HORN])
@pytest.mark.parametrize("sweep", [360.0, 270.0, 20.0])
def test_rings_are_solids_with_flat_ends_where_the_turn_is_a_part(tmp_path, profile, sweep) -> None:
    document = Document(profile, solid=FILLED, revolution=Revolution(Axis.X, 30.0, sweep))
    read = stepped(document, tmp_path)
    assert read.solids == 1
    assert read.faces == len(profile) + (0 if sweep == 360.0 else 2)
    assert read.volume == pytest.approx(document.volume, rel=1e-9)
    assert contents(document).startswith(f"One solid, exact: {read.faces} face")


def test_a_part_turn_stands_where_the_mesh_of_it_does(tmp_path) -> None:
    document = Document(
        SQUARE,
        solid=FILLED,
        revolution=Revolution(Axis.Y, 40.0, 90.0),
        placement=Placement((10.0, 20.0, 30.0), (3.0, -50.0, 7.0)),
    )
    read = stepped(document, tmp_path)
    mesh = document.body().mesh(samples=(4, 180))
    corners = mesh.positions[mesh.faces]
    origin = corners[0, 0]
    volumes = np.linalg.det(corners - origin)
    centre = origin + (volumes[:, None] * (corners - origin).sum(axis=1)).sum(axis=0) / (
        4.0 * volumes.sum()
    )
    assert read.centre == pytest.approx(centre.tolist(), abs=1e-2)


def test_a_profile_that_touches_the_axis_gives_solids_that_meet_there(tmp_path) -> None:
    document = Document(HOURGLASS, solid=FILLED)
    read = stepped(document, tmp_path)
    assert (read.solids, read.faces) == (2, 4)
    # 2 · π ∫ 21² (h / 45)⁴ dh from 0 to 45.
    assert read.volume == pytest.approx(2.0 * pi * 21.0**2 * 45.0 / 5.0, rel=1e-9)
    assert contents(document) == "2 solids that meet on the axis, exact: 4 faces, no mesh"


def test_a_stretch_along_the_axis_parts_two_solids(tmp_path) -> None:
    lower, upper = Segment(DROP), Segment([(r, h + 70.0) for r, h in DROP])
    pair = Document(Profile.of([lower, line((0.0, 60.0), (0.0, 70.0)), upper]))
    single = Document(Profile((lower,)))
    for sweep in (360.0, 100.0):
        turn, solid = Revolution(sweep_deg=sweep), FILLED
        read = stepped(replace(pair, revolution=turn, solid=solid), tmp_path)
        assert read.solids == 2
        alone = stepped(replace(single, revolution=turn, solid=solid), tmp_path)
        assert read.volume == pytest.approx(2.0 * alone.volume, rel=1e-9)


def test_a_ring_that_reaches_the_axis_inside_its_run_is_cut_there(tmp_path) -> None:
    cone = Profile.of(
        [
            line((10.0, 0.0), (0.0, 10.0)),
            line((0.0, 10.0), (0.0, 0.0)),
            line((0.0, 0.0), (10.0, 0.0)),
        ],
        closed=True,
    )
    read = stepped(Document(cone), tmp_path)
    assert (read.solids, read.faces) == (1, 2)
    assert read.volume == pytest.approx(pi * 10.0**3 / 3.0, rel=1e-9)


def test_segments_of_no_length_are_left_out(tmp_path) -> None:
    corner = (20.0, 30.0)
    whole = [line((20.0, 0.0), corner), line(corner, (10.0, 60.0))]
    point = Segment([corner] * 4, SHAPE)
    for segments in ([whole[0], point, whole[1]], [Segment([(20.0, 0.0)] * 4), *whole]):
        document = Document(Profile.of(segments), solid=FILLED)
        read = stepped(document, tmp_path)
        assert (read.solids, read.faces) == (1, 4)
        assert read.volume == pytest.approx(document.volume, rel=1e-9)


def test_the_preview_says_an_open_surface_and_why_there_is_none() -> None:
    tube = Document(Profile.of([line((20.0, 0.0), (20.0, 60.0))]))
    assert contents(tube) == "An open surface, exact: 1 face, no mesh"
    part = Document(Profile((Segment(DROP),)), revolution=Revolution(sweep_deg=90.0))
    assert contents(part) == "An open surface, exact: 1 face, no mesh"
    assert contents(replace(part, solid=FILLED)) == "One solid, exact: 3 faces, no mesh"
    lip = Profile.of(
        [
            cubic([(10.0, 0.0), (40.0, 20.0), (40.0, 60.0), (20.0, 60.0)]),
            cubic([(20.0, 60.0), (0.0, 60.0), (25.0, 10.0), (30.0, 30.0)]),
        ]
    )
    for wrong, finding in (
        (replace(tube, solid=FILLED, profile=lip), NoBodyFor.END_BARRED),
        (replace(tube, profile=Profile.of([line((0.0, 0.0), (0.0, 9.0))])), NoExport.NO_AREA),
        (replace(tube, profile=Profile((Segment([(5.0, 5.0)] * 4),))), NoExport.POINT),
    ):
        with pytest.raises(ExportError) as refused:
            contents(wrong)
        assert refused.value.finding is finding


def test_what_the_kernel_raises_or_lacks_is_one_line(monkeypatch) -> None:
    pytest.importorskip("OCP")
    from OCP import BRepBuilderAPI
    from OCP.StdFail import StdFail_NotDone

    document = Document(Profile((Segment(DROP),)))

    def fail(*_: object) -> None:
        raise StdFail_NotDone("BRep_API: command not done")

    monkeypatch.setattr(BRepBuilderAPI, "BRepBuilderAPI_MakeSolid", fail)
    with pytest.raises(ExportError) as refused:
        write_step(document, BytesIO())
    assert refused.value.finding is KernelFailure.SHAPE
    monkeypatch.setitem(sys.modules, "OCP.BRepBuilderAPI", None)
    with pytest.raises(ExportError) as refused:
        write_step(document, BytesIO())
    assert refused.value.finding is KernelFailure.MISSING
