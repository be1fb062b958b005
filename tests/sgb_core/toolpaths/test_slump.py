"""The slump line against closed forms and against the steps of the path itself."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

import resources
from sgb_core.bodies.solid import BodyKind, Solid
from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import Segment, ShapeParameters
from sgb_core.document.file import project_file
from sgb_core.document.manufacture import Manufacture, Shrinkage
from sgb_core.document.model import Document, Unit
from sgb_core.surfaces.laws.law import Law
from sgb_core.surfaces.twist import Twist
from sgb_core.toolpaths.errors import ToolpathError
from sgb_core.toolpaths.plan_path import toolpath
from sgb_core.toolpaths.printer import Bed, BedShape
from sgb_core.toolpaths.settings import Wanted
from sgb_core.toolpaths.slump import Build, slump
from sgb_core.toolpaths.strand import Part
from tests.sgb_core.toolpaths.printing import CLAY, chain, roomy

ROOMY = replace(roomy(CLAY), bead=replace(CLAY.bead, least=0.01))


def test_a_cone_leans_by_its_slope_in_layers_over_beads() -> None:
    for slope in (0.0, 0.4, -0.9, 2.0):
        cone = chain((80.0, 0.0), (80.0 + 30.0 * slope, 30.0))
        found = slump(cone, ROOMY, 1.2)
        expected = 1.2 * abs(slope) / ROOMY.bead.usual
        assert found.lean == pytest.approx(np.full((1, 33), expected), abs=1e-12)
        fails, leans = expected >= 1.0, expected > ROOMY.largest_lean
        wanted = Build.FAILS if fails else Build.LEANS if leans else Build.HOLDS
        assert set(found.build.ravel().tolist()) == {wanted}


def test_the_direction_in_which_the_profile_is_drawn_and_its_unit_change_nothing() -> None:
    up = chain((20.0, 0.0), (30.0, 20.0), (25.0, 40.0))
    one = slump(up, ROOMY)
    down = Document(Profile.of([segment.reversed() for segment in up.profile][::-1]))
    assert slump(down, ROOMY).lean[::-1, ::-1] == pytest.approx(one.lean)
    small = chain((2.0, 0.0), (3.0, 2.0), (2.5, 4.0))
    assert slump(replace(small, unit=Unit.CM), ROOMY).lean == pytest.approx(one.lean)


def test_what_is_level_at_the_foot_is_floor_and_what_falls_or_is_level_above_fails() -> None:
    found = slump(chain((0.0, 0.0), (20.0, 0.0), (20.0, 30.0), (40.0, 30.0), (40.0, 20.0)), ROOMY)
    assert (found.build[0] == Build.FLOOR).all()
    assert (found.build[1] == Build.HOLDS).all()
    assert (found.build[2:] == Build.FAILS).all()
    assert np.isinf(found.lean[2:]).all()


def test_what_the_printer_does_not_reach_fails() -> None:
    wall = chain((30.0, 0.0), (30.0, 100.0))
    low = replace(ROOMY, bed=Bed(100.0, 100.0, 50.0, BedShape.CIRCLE))
    assert (slump(wall, low).build == Build.FAILS).sum() == 16
    narrow = replace(ROOMY, bed=Bed(200.0, 50.0, 500.0))
    assert (slump(wall, narrow).build == Build.FAILS).all()
    assert (slump(wall, replace(ROOMY, bed=Bed(200.0, 80.0, 500.0))).build == Build.HOLDS).all()
    shrinks = replace(wall, manufacture=Manufacture(shrinkage=Shrinkage(50.0)))
    assert (slump(shrinks, replace(ROOMY, bed=Bed(200.0, 80.0, 500.0))).build == Build.FAILS).all()


def test_a_vessels_wall_is_divided_into_beads() -> None:
    cup = replace(chain((30.0, 0.0), (45.0, 60.0)), solid=Solid(BodyKind.VESSEL, wall=9.0))
    machine = replace(ROOMY, bead=replace(ROOMY.bead, usual=2.0, most=4.0))
    assert slump(cup, machine).bead == 3.0


@pytest.mark.parametrize("sweep", [90.0, 359.0])
def test_part_turns_and_rings_have_no_wall(sweep) -> None:
    cup = chain((30.0, 0.0), (45.0, 60.0))
    with pytest.raises(ToolpathError, match="part of a turn"):
        slump(replace(cup, revolution=replace(cup.revolution, sweep_deg=sweep)), ROOMY)
    with pytest.raises(ToolpathError, match="closed profile"):
        slump(project_file.load(resources.path("presets/ring.sgb")), ROOMY)


SHAPES = {
    "bellied": Document(
        Profile.of([Segment([(30, 0), (50, 20), (50, 40), (32, 60)], ShapeParameters(1, 3, 1, 1))])
    ),
    "vase": replace(
        project_file.load(resources.path("presets/vase.sgb")), solid=Solid(BodyKind.SURFACE)
    ),
}
WAVES = Law("lambda2", "cosine", start=2.0, end=4.0, count=4)
LOBES = Law("radius", "lobes", start=0.85, end=1.1, count=6)


# A law of λ lets the height of a place go up and down around the turn, and some angles stand for
# all; so the comparison at one height is a coarser one.
@pytest.mark.parametrize(
    ("laws", "tolerance"),
    [((), 2e-2), ((LOBES,), 8e-2), ((WAVES,), 0.12)],
    ids=["plain", "lobes", "waves"],
)
@pytest.mark.parametrize("turns", [0.0, 0.2])
def test_it_leans_where_and_as_far_as_the_path_does(laws, tolerance, turns) -> None:
    _as_the_path(replace(SHAPES["bellied"], variation=laws, twist=Twist(turns)), tolerance)


def test_a_presets_path_leans_as_its_slump_line_says() -> None:
    _as_the_path(SHAPES["vase"], 2e-2)


def _as_the_path(document: Document, tolerance: float) -> None:
    """Compare the lean at nodes with the largest step of the turn there, on the surface itself."""
    layer = 0.25
    machine = replace(ROOMY, bead=replace(ROOMY.bead, usual=1.0))
    found = slump(document, machine, layer)
    path = toolpath(document, machine, Wanted(layer=layer, bead=0.0, chord=0.1, anyway=True))
    wall = (path.parts == Part.WALL) & (path.turns > 1)
    heights, steps = path.points[wall, 2], path.steps[wall]
    h = (found.places[..., 1] - found.places[..., 1].min()) * document.unit.millimetres
    inside = (h > 4.0 * layer) & (h < h.max() - 4.0 * layer) & (found.build > Build.FLOOR)
    places = list(zip(h[inside].tolist(), found.lean[inside].tolist(), strict=True))[::3]
    assert len(places) >= 9
    slack = max(4e-3, 0.1 * tolerance)
    for height, lean in places:
        # A turn's step counts from the turn below, so it is that half a layer further down.
        turn = np.abs(heights - layer / 2.0 - height) <= layer / 2.0
        assert steps[turn].max() == pytest.approx(lean, rel=tolerance, abs=slack)
