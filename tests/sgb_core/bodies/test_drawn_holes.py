"""Text and pictures cut through walls: closed meshes, as many tunnels as pieces, true to size."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
import trimesh

import resources.library  # noqa: F401
from sgb_core.bodies.cut_outs import CutOut, HoleShape
from sgb_core.bodies.hole_pattern import Pattern, drawn_of
from sgb_core.bodies.meridian import SolidError
from sgb_core.bodies.solid import Rim, WallSide
from sgb_core.document.model import Document, Revolution
from sgb_core.findings.cut_outs import (
    HolesTooNear,
    IslandsFallOut,
    NoRoomForHoles,
    NothingToCut,
    TooManyHoles,
)
from sgb_core.surfaces.laws.law import Law
from sgb_core.surfaces.placement import Placement
from sgb_core.surfaces.revolution import Axis
from sgb_core.surfaces.twist import Twist
from tests.sgb_core.bodies.test_cut_outs import BELLY, TUBE, WALL, tunnels

WORDS = CutOut(HoleShape.TEXT, height=18.0, rows=1, around=2, bridge=1.5, text="Abg 8%")
LEAVES = CutOut(HoleShape.PICTURE, width=45.0, rows=1, around=3, bridge=1.5, picture="lotus")


def check_closed(document: Document, tolerance: float = 0.2) -> trimesh.Trimesh:
    worked = document.body().worked
    mesh = document.body().mesh(tolerance=tolerance)
    assert mesh.is_watertight
    assert tunnels(mesh) == worked.count
    agree = np.einsum("ij,ij->i", mesh.triangle_normals, mesh.normals[mesh.triangles].mean(axis=1))
    assert (agree > 0.0).all()
    other = trimesh.Trimesh(mesh.positions, mesh.faces, process=False)
    assert other.is_volume
    return other


@pytest.mark.parametrize("pattern", [WORDS, LEAVES], ids=["text", "picture"])
@pytest.mark.parametrize("side", WallSide)
@pytest.mark.parametrize("sweep", [360.0, 250.0])
def test_drawn_holes_go_through_the_wall_and_leave_it_closed(pattern, side, sweep) -> None:
    document = Document(
        BELLY,
        solid=replace(WALL, side=side, rim=Rim.ROUND),
        cut_outs=(pattern,),
        revolution=Revolution(Axis.Y, 20.0, sweep),
        placement=Placement((10.0, 20.0, 30.0), (5.0, -7.0, 9.0)),
    )
    check_closed(document)


@pytest.mark.parametrize("pattern", [WORDS, LEAVES], ids=["text", "picture"])
def test_drawn_holes_take_the_sector_behind_their_shapes(pattern) -> None:
    document = Document(TUBE, solid=WALL, cut_outs=(pattern,))
    pieces = drawn_of(document.patterns[0], 0, True)
    # Widths are true at r = 40 outside and narrow towards the axis: ∫ r/40 dr over the wall.
    expected = pattern.around * pieces.union.area * (40.0**2 - 37.0**2) / 80.0
    count, removed = document.body().pierced
    assert count == pattern.around * len(pieces.outlines)
    assert removed == pytest.approx(expected, rel=2e-3)


def test_text_reads_from_the_outside_from_left_to_right() -> None:
    # An L: its foot lies to the right of its stem, seen from outside.
    pattern = CutOut(HoleShape.TEXT, height=30.0, rows=1, around=1, text="L")
    mesh = check_closed(Document(TUBE, solid=WALL, cut_outs=(pattern,)))
    stem, foot = [], []
    for degrees in np.arange(140.0, 220.0, 0.5):
        way = np.array([np.cos(np.radians(degrees)), np.sin(np.radians(degrees)), 0.0])
        for height, found in ((50.0, stem), (38.0, foot)):
            if not meets(mesh, np.array([0.0, 0.0, height]), way):
                found.append(degrees)
    # Counted against the clock seen from above, which is to the right seen from outside.
    assert min(foot) == pytest.approx(min(stem), abs=1.0)
    assert max(foot) > max(stem) + 8.0


def meets(mesh: trimesh.Trimesh, origin, way) -> bool:
    a, b, c = np.moveaxis(mesh.triangles - origin, 1, 0)
    sides = np.stack([np.cross(p, q) @ way for p, q in ((a, b), (b, c), (c, a))])
    within = (sides > 0.0).all(axis=0) | (sides < 0.0).all(axis=0)
    return bool((within & ((a + b + c) @ way > 0.0)).any())


@pytest.mark.parametrize("pattern", [WORDS, LEAVES, CutOut(width=9.0, rows=2)], ids=str)
def test_a_twist_turns_holes_with_their_wall(pattern) -> None:
    law = Law("radius", "lobes", 0.95, 1.05, count=6)
    still = Document(TUBE, solid=WALL, variation=(law,), cut_outs=(pattern,))
    turned = replace(still, twist=Twist(0.15))
    check_closed(turned)
    if pattern.shape is HoleShape.CIRCLE:
        # Slices keep their size: what is taken is the same.
        assert turned.body().pierced[1] == pytest.approx(still.body().pierced[1], rel=5e-3)


def test_text_follows_lobes() -> None:
    law = Law("radius", "lobes", 0.9, 1.1, count=7, sharp=0.5)
    check_closed(Document(BELLY, solid=WALL, variation=(law,), cut_outs=(WORDS,)))


@pytest.mark.parametrize(
    ("change", "kind"),
    [
        ({"bridge": 0.0}, IslandsFallOut),
        ({"text": "   "}, NothingToCut),
        ({"height": 1e-3, "bridge": 2.0}, NothingToCut),
        ({"text": "A long sentence that goes around more than once, and on"}, HolesTooNear),
        ({"around": 9}, HolesTooNear),
        ({"height": 90.0}, NoRoomForHoles),
        (
            {"text": "@" * 60, "rows": 60, "around": 400, "height": 0.5, "bridge": 0.01},
            TooManyHoles,
        ),
    ],
)
def test_what_cannot_be_cut_is_said_in_one_line(change, kind) -> None:
    document = Document(TUBE, solid=WALL, cut_outs=(replace(WORDS, **change),))
    with pytest.raises(SolidError) as refused:
        document.body().mesh()
    assert isinstance(refused.value.finding, kind)
    assert "\n" not in str(refused.value)
    assert "cut_outs[0]" in str(refused.value)


def test_a_picture_that_is_light_all_over_has_nothing_to_cut() -> None:
    pattern = replace(LEAVES, threshold=0.0)
    with pytest.raises(SolidError) as refused:
        Document(TUBE, solid=WALL, cut_outs=(pattern,)).body().pierced  # noqa: B018
    assert isinstance(refused.value.finding, NothingToCut)


def test_bridges_are_wider_where_a_twist_narrows_them() -> None:
    still, leaning = (drawn_of(Pattern(WORDS), 0, True, lean).union.area for lean in (0.0, 1.0))
    assert leaning < still
