"""The path under a relief against the mesh of the raised surface, and what is said about it."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
import trimesh
from scipy.spatial import cKDTree

import resources.library  # noqa: F401
from sgb_core.bodies.solid import BodyKind, Solid
from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import Segment, ShapeParameters
from sgb_core.document.appearance.model import Appearance, Layer, LayerKind, Texture
from sgb_core.document.model import Document
from sgb_core.findings.toolpaths import PathNote
from sgb_core.surfaces.laws.law import Law
from sgb_core.surfaces.twist import Twist
from sgb_core.toolpaths import raised as raised_module
from sgb_core.toolpaths.errors import ToolpathError
from sgb_core.toolpaths.plan_path import toolpath
from sgb_core.toolpaths.settings import Wanted
from tests.sgb_core.toolpaths.printing import BIG, CYLINDER, wall_of

BELLY = Profile.of([Segment([(30, 0), (50, 20), (50, 40), (32, 60)], ShapeParameters(1, 3, 1, 1))])
STRIPES = Layer(LayerKind.STRIPES, start=0.2, end=0.8, count=7, width=0.4, relief=1.5, edge=4.0)
LEANING = replace(STRIPES, count=3, twist=0.5)
LAW = Law("radius", "lobes", start=0.9, end=1.1, count=5)


def raised(document: Document, *layers: Layer, textures: tuple[Texture, ...] = ()) -> Document:
    return replace(document, appearance=Appearance(drawing=layers, textures=textures))


def away(points: np.ndarray, mesh: trimesh.Trimesh) -> np.ndarray:
    """Return how far points are from the nearest of the triangles whose middles are near."""
    near = cKDTree(mesh.triangles_center).query(points, 150)[1]
    found = np.full(len(points), np.inf)
    for k in range(near.shape[1]):
        closest = trimesh.triangles.closest_point(mesh.triangles[near[:, k]], points)
        found = np.minimum(found, np.linalg.norm(closest - points, axis=1))
    return found


@pytest.mark.parametrize(
    "document",
    [
        raised(Document(BELLY), STRIPES),
        raised(
            Document(BELLY), replace(STRIPES, relief=-1.0), replace(STRIPES, count=3, twist=0.5)
        ),
        raised(replace(Document(BELLY), variation=(LAW,), twist=Twist(0.2)), STRIPES),
        raised(replace(Document(BELLY), twist=Twist(-0.3)), STRIPES),
        raised(Document(Profile(tuple(s.reversed() for s in BELLY.segments[::-1]))), STRIPES),
        raised(Document(BELLY), textures=(Texture("lotus", repeat=(4.0, 0.0), relief=1, edge=5),)),
    ],
    ids=["stripes", "two", "twisted-law", "twisted", "backwards", "texture"],
)
def test_a_path_without_width_lies_on_the_raised_surface(document) -> None:
    points = wall_of(toolpath(document, BIG, Wanted(layer=1.0, bead=0.0, chord=0.02, anyway=True)))
    made = document.body().mesh(tolerance=0.04)
    mesh = trimesh.Trimesh(made.positions, made.faces, process=False)
    points = points[:: max(1, len(points) // 1200)]
    inside = points[(points[:, 2] > 1.0) & (points[:, 2] < 59.0)]
    assert away(inside, mesh).max() < 0.06


def test_a_bead_follows_the_relief_and_its_flow_is_the_wall_it_makes() -> None:
    document = raised(CYLINDER, replace(STRIPES, start=0.1, end=0.9))
    path = toolpath(document, BIG, Wanted(layer=0.5, bead=1.0, anyway=True))
    points = wall_of(path)
    middle = points[(points[:, 2] > 8.0) & (points[:, 2] < 12.0)]
    radius = np.hypot(*middle[:, :2].T)
    assert radius.min() == pytest.approx(29.5, abs=1e-3)
    assert radius.max() == pytest.approx(31.0, abs=0.02)
    assert path.extruded_volume == pytest.approx(path.material_volume, rel=1e-2)
    assert PathNote.RELIEF in path.findings


def test_several_beads_follow_it_side_by_side() -> None:
    vessel = replace(CYLINDER, solid=Solid(BodyKind.VESSEL, wall=2.0, base=1.0))
    document = raised(vessel, replace(STRIPES, start=0.1, end=0.9))
    path = toolpath(document, BIG, Wanted(layer=0.5, walls=2, anyway=True))
    points = wall_of(path)
    turn = path.turns[-len(points) + 1 :]
    level = (points[1:, 2] > 10.0) & (points[1:, 2] < 12.0)
    for bead in (0, 1):
        own = points[1:][level & (turn % 2 == bead)]
        angle = np.mod(np.arctan2(own[:, 1], own[:, 0]), 2.0 * np.pi)
        # At the beginning of each turn the path goes over from bead to bead.
        radius = np.hypot(*own[(angle > 0.5) & (angle < 6.2)].T[:2])
        assert np.ptp(radius) == pytest.approx(1.5, abs=0.02)
    assert path.extruded_volume == pytest.approx(path.material_volume, rel=2e-2)


def test_a_relief_finer_than_any_path_is_one_line(monkeypatch) -> None:
    monkeypatch.setattr(raised_module, "_MOST", 16)
    with pytest.raises(ToolpathError, match="too fine to be printed"):
        toolpath(raised(CYLINDER, replace(STRIPES, edge=3.0)), BIG, Wanted(anyway=True))
