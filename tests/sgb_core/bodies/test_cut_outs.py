"""Holes through walls: closed meshes with as many tunnels as asked for, of the right size."""

from __future__ import annotations

from dataclasses import replace
from math import pi

import numpy as np
import pytest
import shapely
import trimesh

from sgb_core.bodies.cut_outs import CutOut, HoleShape, place_count
from sgb_core.bodies.hole_layout import holes
from sgb_core.bodies.hole_pattern import Pattern
from sgb_core.bodies.meridian import SolidError
from sgb_core.bodies.solid import BodyKind, Rim, Solid, WallSide
from sgb_core.curves.primitives import line
from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import Segment, ShapeParameters
from sgb_core.document import edits
from sgb_core.document.model import Document, Revolution, Unit
from sgb_core.findings.cut_outs import HolesTooNear, HoleTooLarge, NoCutOuts, NoRoomForHoles
from sgb_core.surfaces.laws.law import Law
from sgb_core.surfaces.placement import Placement
from sgb_core.surfaces.revolution import Axis
from sgb_core.surfaces.twist import Twist
from tests.sgb_core.exchange.shapes import ring

TUBE = Profile.of([line((40.0, 0.0), (40.0, 100.0))])
BELLY = Profile((Segment([(30, 0), (70, 20), (62, 80), (25, 110)], ShapeParameters(1, 3, 1, 0.4)),))
WALL = Solid(BodyKind.VESSEL, wall=3.0, base=4.0)
DRILLED = [shape for shape in HoleShape if not shape.is_drawn]
FIVE = CutOut(width=9.0, height=13.0, rows=5, around=16)


def tunnels(mesh) -> int:
    """Return the genus of a closed mesh of one part, by Euler's formula."""
    edges = np.sort(mesh.faces[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
    count = len(np.unique(edges, axis=0))
    used = len(np.unique(mesh.faces))
    return 1 - (used - count + len(mesh.faces)) // 2


@pytest.mark.parametrize("shape", DRILLED)
@pytest.mark.parametrize("side", WallSide)
@pytest.mark.parametrize("sweep", [360.0, 200.0])
def test_a_pierced_wall_is_closed_with_a_tunnel_for_each_hole(shape, side, sweep) -> None:
    around = 16 if sweep == 360.0 else 8
    pattern = replace(FIVE, shape=shape, around=around)
    document = Document(
        BELLY,
        solid=replace(WALL, side=side, rim=Rim.ROUND),
        cut_outs=(pattern,),
        revolution=Revolution(Axis.Y, 20.0, sweep),
        placement=Placement((10.0, 20.0, 30.0), (5.0, -7.0, 9.0)),
    )
    mesh = document.body().mesh(tolerance=0.2)
    count = 80 if sweep == 360.0 else 38
    assert place_count(pattern, sweep == 360.0) == count == document.body().pierced[0]
    assert mesh.is_watertight
    assert tunnels(mesh) == count
    other = trimesh.Trimesh(mesh.positions, mesh.faces, process=False)
    assert other.is_volume
    assert other.volume == pytest.approx(mesh.volume, rel=1e-9)
    # Normals point as the triangles do, in the holes too.
    agree = np.einsum("ij,ij->i", mesh.triangle_normals, mesh.normals[mesh.triangles].mean(axis=1))
    assert (agree > 0.0).all()


@pytest.mark.parametrize("shape", DRILLED)
def test_what_holes_take_is_the_wall_within_their_outline(shape) -> None:
    pattern = CutOut(shape, width=14.0, height=20.0, rows=2, around=7)
    body = Document(TUBE, solid=WALL, cut_outs=(pattern,)).body()
    # ∫ (√(R² − x²) − √(r² − x²)) · height(x) dx over the outline's own height at each x.
    outline = pattern.outline()
    x = np.linspace(-7.0, 7.0, 20_001)
    upper = outline[outline[:, 1] >= -1e-9]
    order = np.argsort(upper[:, 0], kind="stable")
    height = 2.0 * np.interp(x, upper[order, 0], upper[order, 1])
    if shape is HoleShape.SLOT:
        height = 2.0 * (3.0 + np.sqrt(np.maximum(49.0 - x * x, 0.0)))
    if shape is HoleShape.HEXAGON:
        height = 20.0 * (1.0 - np.abs(x) / 14.0)
    depth = np.sqrt(40.0**2 - x * x) - np.sqrt(37.0**2 - x * x)
    expected = 14 * float(np.trapezoid(depth * height, x))
    count, removed = body.pierced
    assert count == 14
    assert removed == pytest.approx(expected, rel=5e-3)
    whole = pi * (40.0**2 * 100.0 - 37.0**2 * 96.0)
    # Round outlines have forty sides.
    assert body.material_volume == pytest.approx(whole - expected, rel=5e-4)
    assert body.mesh(tolerance=0.01).volume == pytest.approx(body.material_volume, rel=5e-4)
    assert body.capacity == pytest.approx(pi * 37.0**2 * 96.0, rel=1e-12)


def test_rays_pass_through_the_holes_and_meet_the_bridges() -> None:
    pattern = CutOut(width=10.0, rows=1, around=8, stagger=False)
    document = Document(TUBE, solid=WALL, cut_outs=(pattern,))
    mesh = document.body().mesh(tolerance=0.05)
    middle = (4.0 + 8.0 + 92.0) / 2.0
    origin = np.array([1e-3, 2e-3, middle])
    for k in range(16):
        angle = pi * (k + 1) / 8
        way = np.array([np.cos(angle), np.sin(angle), 0.0])
        # Half way between two holes the wall is met inside and outside.
        assert meetings(mesh, origin, way) == (0 if k % 2 == 0 else 2)


def meetings(mesh, origin, way) -> int:
    """Return how many triangles a ray meets."""
    a, b, c = np.moveaxis(mesh.positions[mesh.faces] - origin, 1, 0)
    # The ray passes within a triangle where it lies on one side of all three of its edges.
    sides = np.stack([np.cross(p, q) @ way for p, q in ((a, b), (b, c), (c, a))])
    ahead = (a + b + c) @ way > 0.0
    return int((((sides > 0.0).all(axis=0) | (sides < 0.0).all(axis=0)) & ahead).sum())


def test_holes_follow_a_profile_that_varies_with_the_angle() -> None:
    law = Law("omega", "cosine", 0.0, 1.0, count=5)
    document = Document(BELLY, solid=WALL, variation=(law,), cut_outs=(FIVE,))
    mesh = document.body().mesh(tolerance=0.3)
    assert mesh.is_watertight
    assert tunnels(mesh) == 80


@pytest.mark.parametrize(
    ("change", "kind"),
    [
        ({"foot_margin": 60.0, "rim_margin": 40.0}, NoRoomForHoles),
        ({"foot_margin": 45.0, "rim_margin": 45.0}, NoRoomForHoles),
        ({"around": 28}, HolesTooNear),
        ({"around": 24, "bridge": 3.0}, HolesTooNear),
        ({"rows": 12, "stagger": False}, HolesTooNear),
        ({"width": 70.0, "around": 1, "rows": 1}, HoleTooLarge),
    ],
)
def test_what_would_pierce_the_rim_or_leave_no_bridge_is_refused(change, kind) -> None:
    pattern = replace(CutOut(width=9.0, rows=3, around=16), **change)
    document = Document(TUBE, solid=WALL, cut_outs=(pattern,))
    with pytest.raises(SolidError) as refused:
        document.body().mesh()
    assert isinstance(refused.value.finding, kind)
    assert "\n" not in str(refused.value)
    assert "cut_outs[0]" in str(refused.value)


def test_bridges_are_measured_where_the_wall_is_narrowest() -> None:
    cone = Profile.of([line((40.0, 0.0), (20.0, 100.0))])
    pattern = CutOut(width=6.0, rows=2, around=24, stagger=False, bridge=0.5)
    with pytest.raises(SolidError) as refused:
        holes(Document(cone, solid=WALL).surface, WALL, (Pattern(pattern),))
    finding = refused.value.finding
    assert isinstance(finding, HolesTooNear)
    assert finding.row == 1
    assert holes(Document(TUBE, solid=WALL).surface, WALL, (Pattern(pattern),))


def test_only_the_wall_of_an_open_vessel_is_pierced() -> None:
    for document, reason in (
        (Document(TUBE), NoCutOuts.NO_VESSEL),
        (replace(ring(), solid=WALL), NoCutOuts.RING),
    ):
        with pytest.raises(SolidError) as refused:
            holes(document.surface, document.solid, (Pattern(FIVE),))
        assert refused.value.finding is reason


def test_patterns_that_meet_each_other_are_refused() -> None:
    twice = (FIVE, replace(FIVE, shape=HoleShape.HEXAGON, rows=4))
    with pytest.raises(SolidError) as refused:
        Document(BELLY, solid=WALL, cut_outs=twice).body().mesh(tolerance=0.5)
    assert refused.value.finding is NoCutOuts.BROKEN


def test_holes_grow_with_the_object() -> None:
    document = Document(TUBE, solid=WALL, cut_outs=(FIVE,))
    inches = edits.set_unit(document, Unit.IN, convert=True)
    assert inches.cut_outs[0].width == pytest.approx(9.0 / 25.4)
    assert inches.cut_outs[0].rows == 5
    assert inches.body().pierced[0] == 80
    assert inches.body().pierced[1] == pytest.approx(document.body().pierced[1] / 25.4**3, rel=1e-6)


def test_the_first_pattern_is_changed_and_the_others_stay() -> None:
    document = Document(TUBE, solid=WALL, cut_outs=(FIVE, replace(FIVE, rows=1)))
    changed = edits.set_cut_out(document, rows=2, shape="slot")
    assert changed.cut_outs == (replace(FIVE, rows=2, shape=HoleShape.SLOT), document.cut_outs[1])
    assert edits.set_cut_outs(document, document.cut_outs) is document
    with pytest.raises(edits.EditError, match="cut_outs"):
        edits.set_cut_out(document, rows=0)


@pytest.mark.parametrize("shape", [HoleShape.CIRCLE, HoleShape.ELLIPSE, HoleShape.SLOT])
@pytest.mark.parametrize("within", [0.3, 0.02])
def test_a_round_outline_is_as_near_as_asked_and_keeps_its_area(shape, within) -> None:
    pattern = CutOut(shape, width=10.0, height=18.0)
    true = shapely.Point(0.0, 0.0).buffer(1.0, quad_segs=2000)
    width, height = pattern.extent
    true = shapely.transform(true, lambda points: points * (width / 2.0, height / 2.0))
    if shape is HoleShape.SLOT:
        true = shapely.LineString([(0.0, -4.0), (0.0, 4.0)]).buffer(5.0, quad_segs=2000)
    outline = shapely.Polygon(pattern.outline(within))
    assert outline.area == pytest.approx(true.area, rel=1e-5)
    assert shapely.hausdorff_distance(outline, true, densify=0.01) <= within


def test_a_coarse_mesh_has_few_triangles_in_its_holes_under_a_twist_too() -> None:
    pattern = CutOut(HoleShape.SLOT, width=6.0, height=15.0, rows=3, around=12)
    for turns, most in ((0.0, 120), (0.1, 300)):
        whole = Document(TUBE, solid=WALL, twist=Twist(turns))
        pierced = replace(whole, cut_outs=(pattern,))
        more = len(pierced.body().mesh(tolerance=0.3).faces)
        more -= len(whole.body().mesh(tolerance=0.3).faces)
        assert more / 36 < most
