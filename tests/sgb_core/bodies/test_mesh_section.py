"""Faces of a cut through bodies with relief and holes, against what must be seen there."""

from __future__ import annotations

from dataclasses import replace
from math import pi

import numpy as np
import pytest
import shapely

from sgb_core.bodies.cut_outs import CutOut
from sgb_core.bodies.mesh_section import mesh_section
from sgb_core.bodies.solid import BodyKind, Solid
from sgb_core.curves.primitives import line
from sgb_core.curves.profile import Profile
from sgb_core.document.appearance.model import Appearance, Layer, LayerKind
from sgb_core.document.body_state import body_state, cut_faces
from sgb_core.document.model import Document, Revolution
from sgb_core.surfaces.laws.law import Law
from sgb_core.surfaces.placement import Placement
from sgb_core.surfaces.revolution import Axis

CUP = Document(
    Profile.of([line((40.0, 0.0), (40.0, 100.0))]), solid=Solid(BodyKind.VESSEL, wall=4.0, base=5.0)
)
WALL_AREA = 40.0 * 5.0 + 4.0 * 95.0
RING = Layer(LayerKind.BAND, start=0.4, end=0.6, relief=1.5, edge=2.0)
HOLES = CutOut(width=8.0, rows=1, around=4, foot_margin=60.0)


def area(rings) -> float:
    return sum(shapely.Polygon(part[0], part[1:]).area for part in rings)


@pytest.mark.parametrize("axis", Axis)
@pytest.mark.parametrize("sweep", [360.0, 200.0])
def test_relief_and_holes_are_seen_in_the_faces_of_a_cut(axis, sweep) -> None:
    document = replace(
        CUP,
        appearance=Appearance(drawing=(RING,)),
        cut_outs=(HOLES,),
        revolution=Revolution(axis, 20.0, sweep),
        placement=Placement((10.0, 20.0, 30.0), (5.0, -7.0, 9.0)),
    )
    state = body_state(document, document.surface, fine=True)
    surface = document.surface
    beside = cut_faces(state, surface.start + surface.sweep / 4.0)
    # The band is twenty high, its soft edges half in and half out.
    assert area(beside) == pytest.approx(WALL_AREA + 1.5 * 20.0, rel=2e-3)
    assert max(part[0][:, 0].max() for part in beside) == pytest.approx(41.5, abs=0.05)
    # Through the middle of a hole the wall is in two, eight apart.
    through = cut_faces(state, surface.start + surface.sweep / 8.0)
    assert len(through) == 2
    low, high = sorted(through, key=lambda part: part[0][:, 1].min())
    outside = [part[0][part[0][:, 0] > 38.0] for part in (low, high)]
    assert outside[1][:, 1].min() - outside[0][:, 1].max() == pytest.approx(8.0, abs=0.1)
    if sweep < 360.0:
        for end in (surface.start, surface.start + surface.sweep):
            # Relief fades towards the cuts of a part turn.
            assert area(cut_faces(state, end)) == pytest.approx(WALL_AREA, rel=1e-4)


def test_a_body_without_them_is_cut_exactly() -> None:
    state = body_state(CUP, CUP.surface, fine=True)
    assert not state.worked
    ((exterior,),) = cut_faces(state, 0.3)
    assert shapely.Polygon(exterior).area == pytest.approx(WALL_AREA, rel=1e-12)


def test_sections_of_lobed_meshes_are_those_of_the_body() -> None:
    document = replace(CUP, variation=(Law("radius", "lobes", 0.9, 1.1, count=5),))
    mesh = document.body().mesh(tolerance=0.02)
    for angle in np.linspace(0.0, 2.0 * pi, 7):
        found = shapely.Polygon(mesh_section(mesh, document.surface, float(angle))[0][0])
        (exact,) = document.body().section(theta=float(angle))
        assert found.symmetric_difference(shapely.Polygon(exact.exterior)).area < 0.02 * 200.0
