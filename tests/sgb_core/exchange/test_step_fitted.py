"""STEP of bodies whose section changes with the angle: what the kernel reads back is the body."""

from __future__ import annotations

from dataclasses import replace
from io import BytesIO
from math import pi
from pathlib import Path

import numpy as np
import pytest

from sgb_core.bodies.solid import Solid
from sgb_core.bodies.vessel import vessel_measures
from sgb_core.curves.primitives import arc, line
from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import Segment, ShapeParameters
from sgb_core.document import edits
from sgb_core.document.model import Document, Unit
from sgb_core.exchange.errors import ExportError
from sgb_core.exchange.format import Request
from sgb_core.exchange.step import FORMAT, write_step
from sgb_core.exchange.step.fitted import patched_parts
from sgb_core.surfaces.fineness import Fineness
from sgb_core.surfaces.variation import Law
from tests.sgb_core.exchange.step_files import stepped

pytest.importorskip("OCP")

BELLY = Segment([(20, 0), (50, 10), (45, 60), (25, 80)], ShapeParameters(lambda2=5, omega=0.8))
LIP = Segment([(25, 80), (21, 88), (24, 104), (29, 110)])
VASE = Document(Profile.of([BELLY, LIP], ["G0"]), name="Vase")
KEYS = ((0.0, 0.0), (0.4, 1.0), (1.0, 0.2))
LOBES = Law("radius", "lobes", 0.92, 1.05, count=4)
FADING = replace(LOBES, along=KEYS)
SIDES = Law("radius", "polygon", 0.0, 1.0, count=5)
TEETH = Law("radius", "sawtooth", 0.95, 1.05, count=3, flank=20.0)
HALF = Law("omega", "paper", 0.2, 1.0)
WAVE = Law("lambda2", "cosine", 2.0, 5.0, count=2)
OWN = Law("radius", "keyframes", 0.9, 1.1, keyframes=((0.0, 0.0), (100.0, 1.0), (220.0, 0.4)))
VESSEL = Solid(kind="vessel", wall=3.0, base=4.0)
FILLED = Solid(kind="filled")

BODIES = [
    ((LOBES,), FILLED, 0.0, 360.0),
    ((FADING,), FILLED, 0.25, 360.0),
    ((SIDES,), FILLED, 0.1, 360.0),
    ((TEETH,), FILLED, 0.0, 200.0),
    ((HALF,), FILLED, 0.0, 360.0),
    ((OWN, WAVE), FILLED, 0.3, 360.0),
    ((FADING, HALF), FILLED, 0.0, 120.0),
    ((LOBES,), VESSEL, 0.0, 360.0),
    ((SIDES,), replace(VESSEL, rim="round", drain_hole=6.0), 0.15, 360.0),
    ((WAVE,), replace(VESSEL, side="outside"), 0.0, 360.0),
    ((FADING,), VESSEL, 0.0, 90.0),
    # The ends of twisted part turns are helical.
    ((LOBES,), FILLED, 0.2, 120.0),
    ((), VESSEL, -0.3, 200.0),
]


def body(
    laws: tuple[Law, ...], solid: Solid, turns: float, sweep: float, document: Document = VASE
) -> Document:
    """A document with laws, a body, a twist and a part of a turn."""
    made = edits.set_revolution(edits.set_variation(document, laws), sweep_deg=sweep)
    return replace(edits.set_twist(made, turns=turns), solid=solid)


@pytest.mark.parametrize(("laws", "solid", "turns", "sweep"), BODIES)
def test_a_body_with_laws_is_one_closed_solid_of_its_volume(
    laws: tuple[Law, ...], solid: Solid, turns: float, sweep: float, tmp_path: Path
) -> None:
    document = body(laws, solid, turns, sweep)
    tolerance = 0.05
    found = stepped(document, tmp_path, tolerance)
    wanted = vessel_measures(document.surface, document.solid)
    assert found.solids == 1
    # No farther than the tolerance all over both sides.
    slack = tolerance * (wanted.inner_area + wanted.outer_area)
    assert abs(found.volume - wanted.material_volume) < slack
    assert found.volume == pytest.approx(wanted.material_volume, rel=3e-4)


def test_finer_fits_come_nearer_and_say_how_near(tmp_path: Path) -> None:
    document = body((FADING,), FILLED, 0.2, 360.0)
    exact = vessel_measures(document.surface, FILLED).material_volume
    off, told = [], []
    for tolerance in (0.2, 0.002):
        off.append(abs(stepped(document, tmp_path, tolerance).volume - exact) / exact)
        parts = patched_parts(document.surface, FILLED, tolerance)
        told.append(max(parts[0].deviations))
        assert told[-1] <= tolerance
    assert off[1] < off[0] / 10.0
    assert off[1] < 1e-6
    request = Request(document, Fineness(tolerance=0.002))
    words = FORMAT.contents(request)
    assert words == (
        f"One solid: {len(parts[0].deviations)} fitted within {told[1]:.2g} mm, no mesh"
    )


def test_points_of_the_surface_lie_on_what_is_read_as_near_as_is_said(tmp_path: Path) -> None:
    from OCP.BRepBuilderAPI import BRepBuilderAPI_MakeVertex
    from OCP.BRepExtrema import BRepExtrema_DistShapeShape
    from OCP.gp import gp_Pnt

    document = body((FADING,), Solid(), 0.3, 300.0)
    found = stepped(document, tmp_path, 0.01)
    assert found.solids == 0
    rng = np.random.default_rng(3)
    segment, s, theta = rng.integers(0, 2, 12), rng.random(12), np.deg2rad(300.0) * rng.random(12)
    for k, at, turn in zip(segment.tolist(), s.tolist(), theta.tolist(), strict=True):
        place = document.surface.point(k, at, turn)
        vertex = BRepBuilderAPI_MakeVertex(gp_Pnt(*place.tolist())).Vertex()
        assert BRepExtrema_DistShapeShape(vertex, found.shape).Value() <= 0.01


def test_closed_surfaces_and_rings_are_solids_in_the_file_s_unit(tmp_path: Path) -> None:
    half = Segment([(0, -10), (14, -10), (14, 10), (0, 10)])
    ball = Document(Profile.of([half]), unit=Unit.CM)
    found = stepped(body((LOBES,), Solid(), 0.2, 360.0, ball), tmp_path)
    assert found.solids == 1
    whole = vessel_measures(body((LOBES,), FILLED, 0.0, 360.0, ball).surface, FILLED)
    assert found.volume == pytest.approx(1000.0 * whole.material_volume, rel=1e-5)
    quarters = [arc((30.0, 0.0), 8.0, k * pi / 2.0, (k + 1) * pi / 2.0)[0] for k in range(4)]
    ring = Document(Profile.of(quarters, ["G0"] * 4, closed=True))
    made = body((LOBES,), Solid(), 0.0, 100.0, ring)
    found = stepped(made, tmp_path)
    assert found.solids == 1
    assert found.volume == pytest.approx(made.volume, rel=1e-4)


def test_what_no_patches_follow_is_said_in_a_line() -> None:
    tube = Document(Profile.of([line((20.0, 0.0), (20.0, 60.0))]))
    waves = body((replace(LOBES, count=1000),), FILLED, 0.0, 360.0, tube)
    with pytest.raises(ExportError, match="no smooth patches"):
        write_step(waves, BytesIO())
    below = replace(VESSEL, side="outside")
    with pytest.raises(ExportError, match="beyond the heights"):
        write_step(body((LOBES,), below, 0.2, 200.0, tube), BytesIO())
