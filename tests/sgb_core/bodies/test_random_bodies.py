"""Whatever is combined, law, twist, relief, cut-outs, kind and part turn: closed, or one line."""

from __future__ import annotations

import os
from dataclasses import replace

import numpy as np
import pytest
import shapely
import trimesh
from manifold3d import Error, Manifold, Mesh64

import resources.library  # noqa: F401
from sgb_core.bodies.cut_outs import CutOut, HoleShape
from sgb_core.bodies.solid import BodyKind, Rim, Solid, WallSide
from sgb_core.curves.primitives import line
from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import Segment, ShapeParameters
from sgb_core.document.appearance.model import Appearance, Layer, LayerKind, Texture
from sgb_core.document.model import Document, Revolution
from sgb_core.findings.errors import FindingError
from sgb_core.lettering.fonts import FontName
from sgb_core.surfaces.laws.law import Law
from sgb_core.surfaces.mesh import Mesh
from sgb_core.surfaces.revolution import Axis
from sgb_core.surfaces.twist import Ease, Twist

# SGB_BODIES=100 for a long run.
COUNT = int(os.environ.get("SGB_BODIES", "8"))
PROFILES = (
    Profile.of([line((40.0, 0.0), (40.0, 100.0))]),
    Profile.of([line((25.0, 0.0), (55.0, 80.0))]),
    Profile((Segment([(30, 0), (70, 20), (62, 80), (35, 110)], ShapeParameters(1, 3, 1, 0.4)),)),
    Profile((Segment([(0, 0), (60, 0), (50, 60), (45, 90)], ShapeParameters(1, 2, 1, 0.2)),)),
)
# Points of a triangle's edge this near to another's border do not tell.
_BORDER = 1e-6


def document_of(rng: np.random.Generator) -> Document:
    def chance(share: float) -> bool:
        return bool(rng.random() < share)

    law = Law("radius", "lobes", 1.0 - rng.uniform(0, 0.12), 1.0, count=int(rng.integers(2, 9)))
    if chance(0.3):
        law = replace(law, along=((0.0, 0.0), (0.6, 1.0), (1.0, 0.0)))
    layers = (
        Layer(LayerKind.STRIPES, start=0.2, end=0.8, count=9, width=0.4, twist=0.2),
        Layer(LayerKind.RINGS, start=0.2, end=0.8, count=4),
        Layer(LayerKind.TEXT, start=0.4, end=0.6, count=2, text="Ab%"),
    )
    layer = replace(layers[rng.integers(3)], relief=float(rng.uniform(-1.4, 2.0)), edge=4.0)
    tile = Texture("lotus", repeat=(5.0, 0.0), relief=float(rng.uniform(-1.0, 1.5)), edge=6.0)
    shape = list(HoleShape)[rng.integers(len(HoleShape))]
    many = not shape.is_drawn
    pattern = CutOut(
        shape,
        width=float(rng.uniform(4, 9)) if many else 40.0,
        height=float(rng.uniform(5, 14)),
        rows=int(rng.integers(1, 4)) if many else 1,
        around=int(rng.integers(3, 11)) if many else 2,
        bridge=1.0,
        text="Roß 8",
        font=list(FontName)[rng.integers(len(FontName))],
    )
    kind = BodyKind.VESSEL if chance(0.75) else list(BodyKind)[rng.integers(3)]
    solid = Solid(
        kind,
        wall=float(rng.uniform(2, 4)),
        base=4.0,
        side=list(WallSide)[rng.integers(2)],
        rim=list(Rim)[rng.integers(2)],
        drain_hole=float(10.0 * chance(0.2)),
    )
    return Document(
        PROFILES[rng.integers(len(PROFILES))],
        revolution=Revolution(list(Axis)[rng.integers(3)], 30.0, 360.0 if chance(0.6) else 210.0),
        variation=(law,) if chance(0.5) else (),
        twist=Twist(float(rng.uniform(-0.3, 0.3)) * chance(0.5), list(Ease)[rng.integers(2)]),
        solid=solid,
        cut_outs=(pattern,) if kind is BodyKind.VESSEL and chance(0.6) else (),
        appearance=Appearance(
            drawing=(layer,) if chance(0.4) else (), textures=(tile,) if chance(0.2) else ()
        ),
    )


def mesh_or_words(document: Document) -> Mesh | str:
    try:
        return document.body().mesh(tolerance=0.4)
    except FindingError as error:
        return str(error)


# Spikes of a picture's shapes once crossed themselves in a twisted wall, in the body of seed 66.
@pytest.mark.parametrize("seed", [*range(COUNT), 66])
def test_a_random_body_is_closed_and_does_not_cross_itself(seed: int) -> None:
    document = document_of(np.random.default_rng(seed))
    mesh = mesh_or_words(document)
    if isinstance(mesh, str):
        assert mesh
        assert "\n" not in mesh
        return
    if document.solid.kind is BodyKind.SURFACE:
        return
    assert mesh.is_watertight
    other = trimesh.Trimesh(mesh.positions, mesh.faces, process=False)
    assert other.is_volume
    assert other.volume > 0.0
    faces = np.array(mesh.faces, dtype=np.uint64, order="C")
    made = Manifold(Mesh64(np.array(mesh.positions, order="C"), faces))
    assert made.status() == Error.NoError
    assert made.volume() == pytest.approx(other.volume, rel=1e-6)
    assert crossings(mesh) == 0


def crossings(mesh: Mesh) -> int:
    """Return how many edges pass through the inside of a face that they do not touch."""
    triangles = mesh.positions[mesh.faces]
    size = float(np.ptp(mesh.positions, axis=0).max())
    low, high = triangles.min(axis=1), triangles.max(axis=1)
    # Boxes meet in the plane in which the mesh is seen largest, and then in the third direction.
    tree = shapely.STRtree(shapely.box(*low[:, :2].T, *high[:, :2].T))
    found = 0
    for begin in range(0, len(triangles), 2000):
        part = slice(begin, begin + 2000)
        boxes = shapely.box(*low[part, :2].T, *high[part, :2].T)
        first, second = tree.query(boxes)
        first += begin
        meet = (low[first, 2] <= high[second, 2]) & (low[second, 2] <= high[first, 2])
        meet &= first != second
        first, second = first[meet], second[meet]
        shared = (mesh.faces[first][:, :, None] == mesh.faces[second][:, None, :]).any(axis=(1, 2))
        found += passing(triangles[first[~shared]], triangles[second[~shared]], size)
    return found


def passing(edges_of: np.ndarray, faces: np.ndarray, size: float) -> int:
    """Return how many edges of the first triangles pass through the second ones' insides."""
    a, b, c = faces[:, 0], faces[:, 1], faces[:, 2]
    normal = np.cross(b - a, c - a)
    area = np.linalg.norm(normal, axis=1)
    found = 0
    for k in range(3):
        start, end = edges_of[:, k], edges_of[:, (k + 1) % 3]
        with np.errstate(divide="ignore", invalid="ignore"):
            before = ((start - a) * normal).sum(axis=1) / area
            after = ((end - a) * normal).sum(axis=1) / area
            place = start + (before / (before - after))[:, None] * (end - start)
            corners = (
                (np.cross(q - p, place - p) * normal).sum(axis=1) / area**2
                for p, q in ((a, b), (b, c), (c, a))
            )
            inside = np.logical_and.reduce([corner > _BORDER for corner in corners])
        apart = (before * after < 0.0) & (np.minimum(abs(before), abs(after)) > 1e-7 * size)
        found += int((apart & inside).sum())
    return found


def test_the_oracle_sees_a_crossing() -> None:
    box = trimesh.creation.box((10.0, 10.0, 10.0))
    moved = box.copy()
    moved.apply_translation((3.0, 4.0, 5.0))
    both = trimesh.util.concatenate([box, moved])
    corners = np.arange(len(both.vertices))
    mesh = Mesh(
        both.vertices,
        corners,
        np.tile((0.0, 0.0, 1.0), (len(corners), 1)),
        np.zeros((len(corners), 2)),
        np.asarray(both.faces),
    )
    assert crossings(mesh) > 0
