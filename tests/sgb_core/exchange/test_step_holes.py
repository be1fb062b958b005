"""STEP of cut-outs: one valid solid, its holes' outlines true, whatever wall they pierce."""

from __future__ import annotations

from dataclasses import replace
from io import BytesIO
from math import pi, sqrt

import numpy as np
import pytest
from scipy.integrate import quad

from app.state.child_command import run_aside
from sgb_core.bodies.cut_outs import CutOut, HoleShape
from sgb_core.bodies.hole_layout import holes
from sgb_core.bodies.pierced import pierced
from sgb_core.bodies.solid import BodyKind, Solid, WallSide
from sgb_core.curves.primitives import cubic, line
from sgb_core.curves.profile import Profile
from sgb_core.document.model import Document, Revolution, Unit
from sgb_core.exchange.errors import ExportError
from sgb_core.exchange.format import Request
from sgb_core.exchange.registry import FORMATS
from sgb_core.exchange.step import writer
from sgb_core.interruption import interruptible
from sgb_core.surfaces.twist import Twist
from sgb_core.surfaces.variation import Law
from tests.sgb_core.exchange.step_files import stepped

CUP = Document(
    Profile.of([line((40.0, 0.0), (40.0, 100.0))]),
    solid=Solid(BodyKind.VESSEL, wall=3.0, base=4.0),
)
BOWL = Document(
    Profile.of([cubic([(25.0, 0.0), (60.0, 20.0), (60.0, 60.0), (45.0, 90.0)])]),
    solid=Solid(BodyKind.VESSEL, wall=3.0, base=4.0),
)


def _with(document: Document, **values: object) -> Document:
    return replace(document, cut_outs=(CutOut(**values),))


def _said(document: Document) -> str:
    return FORMATS[".step"].contents(Request(document))


def _chord(shape: HoleShape, width: float, height: float, x: float) -> float:
    """Return how high a hole is at x from its middle."""
    a, b = width / 2.0, height / 2.0
    if shape in (HoleShape.CIRCLE, HoleShape.ELLIPSE):
        return 2.0 * b * sqrt(max(0.0, 1.0 - (x / a) ** 2))
    if shape is HoleShape.HEXAGON:
        # Corners above and below, of which the flats are as wide as asked for.
        return 2.0 * b * (1.0 - abs(x) / (2.0 * a))
    if height >= width:
        return 2.0 * (b - a + sqrt(max(0.0, a * a - x * x)))
    inside = max(0.0, abs(x) - (a - b))
    return 2.0 * sqrt(max(0.0, b * b - inside * inside))


@pytest.mark.parametrize(
    ("shape", "height", "faces"),
    [
        (HoleShape.CIRCLE, 9.0, 1),
        (HoleShape.ELLIPSE, 14.0, 1),
        (HoleShape.ELLIPSE, 4.0, 1),
        (HoleShape.SLOT, 20.0, 4),
        (HoleShape.SLOT, 5.0, 4),
        (HoleShape.SLOT, 9.0, 1),
        (HoleShape.HEXAGON, 9.0, 6),
    ],
)
@pytest.mark.parametrize("side", WallSide)
def test_a_prism_through_a_tube_takes_what_it_must(tmp_path, shape, height, faces, side):
    """The prism leaves the tube between two cylinders: a chord high, at each x as long as they."""
    tube = replace(CUP, solid=replace(CUP.solid, side=side), unit=Unit.CM)
    holed = _with(tube, shape=shape, width=9.0, height=height, rows=2, around=3)
    read, whole = stepped(holed, tmp_path), stepped(tube, tmp_path)
    low, high = (37.0, 40.0) if side is WallSide.INSIDE else (40.0, 43.0)
    round_high = 9.0 if shape is HoleShape.CIRCLE else height

    def slice_of(x: float) -> float:
        chord = _chord(shape, 9.0, round_high, x)
        return chord * (sqrt(high**2 - x * x) - sqrt(low**2 - x * x))

    one, _ = quad(slice_of, -4.5, 4.5, points=(-2.0, 0.0, 2.0), epsabs=1e-10, limit=200)
    assert read.solids == 1
    assert read.faces == whole.faces + 6 * faces
    # Where surfaces cross the kernel draws splines, of its own tolerance.
    assert whole.volume - read.volume == pytest.approx(1000.0 * 6 * one, rel=2e-4)
    # The parallel of the wall is fitted, to the last digits where the wall is straight.
    assert _said(holed).startswith(f"One solid with 6 holes: {read.faces - 1} faces exact, 1 fit")


@pytest.mark.parametrize("turned", [{}, {"sweep_deg": 200.0}])
@pytest.mark.parametrize("laws", [(), (Law("radius", "lobes", 0.95, 1.05, count=5),)])
def test_curved_walls_are_pierced_as_the_mesh_is(tmp_path, turned, laws):
    """The mesh's holes have 40 sides, and take less by the area that these leave out."""
    document = replace(BOWL, revolution=Revolution(**turned), variation=laws)
    holed = _with(document, width=6.0, rows=1, around=5, foot_margin=30.0)
    read, whole = stepped(holed, tmp_path), stepped(document, tmp_path)
    assert read.solids == 1
    if not laws:
        assert read.faces == whole.faces + 5
    mesh = document.body().mesh(tolerance=0.005)
    found = pierced(document.surface, document.solid, holed.patterns, mesh)
    sides = 40 / (2.0 * pi) * np.sin(2.0 * pi / 40)
    assert whole.volume - read.volume == pytest.approx(found.removed / sides, rel=2e-3)
    assert "One solid with 5 holes" in _said(holed)


def test_what_cannot_be_pierced_is_said_before_it_is_written(tmp_path):
    near = _with(CUP, width=30.0, around=40)
    with pytest.raises(ExportError, match="hole"):
        _said(near)
    for bent in (
        _with(CUP, shape=HoleShape.TEXT, rows=1, around=1, height=12.0),
        replace(_with(CUP, rows=1), twist=Twist(0.2)),
    ):
        with pytest.raises(ExportError, match="straight holes"):
            _said(bent)
    bare = _with(replace(CUP, solid=Solid()))
    with pytest.raises(ExportError, match="vessel"):
        _said(bare)


def test_cutting_can_be_cancelled(tmp_path):
    asked = []

    class StopError(Exception):
        pass

    def stop():
        asked.append(1)
        raise StopError

    holed = _with(CUP, rows=1, around=3)
    assert len(holes(holed.surface, holed.solid, holed.patterns)) == 3
    with pytest.raises(StopError), interruptible(stop):
        stepped(holed, tmp_path)
    assert asked
    assert writer.FORMAT.holds_up


def test_progress_goes_on_from_lot_to_lot_of_holes(tmp_path):
    """A process beside the window prints it: without that a long cut stands still at nothing."""
    told: list[float] = []
    holed = _with(CUP, rows=1, around=14)
    FORMATS[".step"].write(Request(holed, report=told.append), BytesIO())
    assert told == sorted(told)
    # What is before three lots, and the end of each.
    assert len(set(told)) == 4
    assert told[0] > 0.0
    assert told[-1] < 1.0
    out = tmp_path / "cup.step"
    parts: list[float] = []
    run_aside("export", holed, out, parts.append, ["--progress"])
    assert {round(part, 2) for part in told} <= {round(part, 2) for part in parts}
    assert parts[-1] == 1.0
    assert out.stat().st_size > 1000
