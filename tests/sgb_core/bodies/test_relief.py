"""Relief as geometry: as deep as asked for, on the outside alone, closed, never through a wall."""

from __future__ import annotations

import io
from dataclasses import replace
from itertools import pairwise
from math import pi

import numpy as np
import pytest
import trimesh
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from PIL import Image

from sgb_core import exchange
from sgb_core.bodies.body_mesh import body_mesh
from sgb_core.bodies.cut_outs import CutOut
from sgb_core.bodies.meridian import SolidError
from sgb_core.bodies.solid import BodyKind, Rim, Solid, WallSide
from sgb_core.curves.primitives import line
from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import Segment, ShapeParameters
from sgb_core.document import edits
from sgb_core.document.appearance.model import (
    Along,
    Appearance,
    Layer,
    LayerKind,
    Picture,
    Raised,
    Texture,
)
from sgb_core.document.model import Document, Revolution, Unit
from sgb_core.exchange.errors import ExportError
from sgb_core.findings.errors import FindingError
from sgb_core.findings.exports import NoStep
from sgb_core.findings.relief import (
    EdgeWidened,
    ReliefHeldBack,
    ReliefMeets,
    ReliefPierces,
    ThinUnderRelief,
)
from sgb_core.findings.surfaces import TooManyTriangles
from sgb_core.surfaces.laws.law import Law
from sgb_core.surfaces.twist import Twist
from tests.sgb_core.bodies.test_random_bodies import crossings
from tests.sgb_core.exchange.shapes import ring

RADIUS, HEIGHT = 40.0, 100.0
TUBE = Profile.of([line((RADIUS, 0.0), (RADIUS, HEIGHT))])
BELLY = Profile((Segment([(30, 0), (70, 20), (62, 80), (25, 110)], ShapeParameters(1, 3, 1, 0.4)),))
KINKED = Profile.of([line((0.0, 0.0), (30.0, 0.0)), line((30.0, 0.0), (45.0, 60.0))])
WALL = Solid(BodyKind.VESSEL, wall=3.0, base=4.0)
BAND = Layer(LayerKind.BAND, start=0.4, end=0.6, relief=1.5, edge=3.0)
STRIPES = Layer(
    LayerKind.STRIPES, start=0.15, end=0.85, count=9, width=0.4, twist=0.1, relief=-1.0, edge=2.0
)


def document(*layers: Layer, profile: Profile = TUBE, solid: Solid = WALL, **more) -> Document:
    look = Appearance(drawing=layers, **more)
    return Document(profile, solid=solid, appearance=look)


def smooth(share):
    share = np.clip(share, 0.0, 1.0)
    return share * share * (3.0 - 2.0 * share)


def met(mesh, angles, heights):
    """Return the radii at which level rays from the axis meet a mesh, each sorted."""
    corners = mesh.triangles
    a, b, c = np.moveaxis(corners, 1, 0)
    low, high = corners[..., 2].min(axis=1), corners[..., 2].max(axis=1)
    found = []
    for angle, height in zip(angles, heights, strict=True):
        way = np.array([np.cos(angle), np.sin(angle), 0.0])
        near = np.flatnonzero((low <= height) & (high >= height))
        origin = np.array([0.0, 0.0, height])
        e, f = b[near] - a[near], c[near] - a[near]
        p = np.cross(way, f)
        det = (e * p).sum(1)
        det = np.where(np.abs(det) < 1e-14, np.inf, det)
        t = origin - a[near]
        q = np.cross(t, e)
        u, v = (t * p).sum(1) / det, (q @ way) / det
        r = (f * q).sum(1) / det
        hit = (u >= 0.0) & (v >= 0.0) & (u + v <= 1.0) & (r > 0.0)
        found.append(np.sort(r[hit]))
    return found


def exported(of: Document, tmp_path, tolerance: float):
    path = tmp_path / "body.stl"
    exchange.write(of, path, tolerance=tolerance)
    return trimesh.load(path)


@pytest.mark.parametrize("tolerance", [0.2, 0.08])
def test_rays_meet_a_band_and_stripes_as_deep_as_asked_for(tmp_path, tolerance) -> None:
    mesh = exported(document(BAND, STRIPES), tmp_path, tolerance)
    assert mesh.is_volume
    rng = np.random.default_rng(5)
    angles, heights = rng.uniform(0, 2 * pi, 400), rng.uniform(8.0, 92.0, 400)
    rise = smooth(0.5 + (heights - 40.0) / 3.0) * smooth(0.5 + (60.0 - heights) / 3.0)
    part = (heights / HEIGHT - 0.15) / 0.7
    turns = 9 * (angles / (2 * pi) + 0.1 * part)
    # One stripe is so many stripes per millimetre across.
    slope = 9 * np.hypot(1.0 / (2 * pi * RADIUS), 0.1 / (0.7 * HEIGHT))
    across = 0.5 - (np.abs(turns - np.round(turns)) - 0.2) / (2.0 * slope)
    within = np.clip(0.5 + (heights - 15.0) / 2.0, 0, 1) * np.clip(0.5 + (85 - heights) / 2.0, 0, 1)
    expected = RADIUS + 1.5 * rise - smooth(np.clip(across, 0, 1) * within)
    radii = met(mesh, angles, heights)
    assert np.abs([each[-1] for each in radii] - expected).max() <= tolerance
    # The inner wall stays as it is, and both are met once each.
    assert np.abs([each[0] for each in radii] - np.float64(37.0)).max() <= tolerance
    assert {len(each) for each in radii} == {2}
    assert np.abs(expected - RADIUS).max() > 0.9


@pytest.mark.parametrize("raised", Raised)
def test_a_picture_is_as_high_as_its_grey(tmp_path, raised) -> None:
    # Grey goes up and down again around, and up along: no jump where the picture meets itself.
    x = (np.arange(256) + 0.5) / 256
    grey = 0.5 - 0.5 * np.cos(2 * pi * x[None]) * np.sin(pi * x[:, None]) ** 2
    stream = io.BytesIO()
    Image.fromarray(np.rint(255 * grey).astype(np.uint8)[::-1]).save(stream, "PNG")
    picture = Picture(stream.getvalue())
    texture = Texture(picture.name, repeat=(3.0, 1.0), relief=2.0, edge=1.0, raised=raised)
    of = document(textures=(texture,), pictures=(picture,))
    mesh = exported(of, tmp_path, 0.1)
    rng = np.random.default_rng(7)
    angles, heights = rng.uniform(0, 2 * pi, 300), rng.uniform(10.0, 90.0, 300)
    here = 0.5 - 0.5 * np.cos(3 * angles) * np.sin(pi * heights / HEIGHT) ** 2
    share = here if raised is Raised.LIGHT else 1.0 - here
    outer = np.array([each[-1] for each in met(mesh, angles, heights)])
    # 8 bits of grey, and a blur over a millimetre.
    assert np.abs(outer - RADIUS - 2.0 * share).max() <= 0.1 + 0.02


def test_what_a_band_adds_is_its_volume() -> None:
    whole = document().body()
    body = document(BAND).body()
    h = np.linspace(30.0, 70.0, 20_001)
    rise = 1.5 * smooth(0.5 + (h - 40.0) / 3.0) * smooth(0.5 + (60.0 - h) / 3.0)
    expected = pi * float(np.trapezoid((RADIUS + rise) ** 2 - RADIUS**2, h))
    assert body.worked.added == pytest.approx(expected, rel=5e-3)
    assert body.material_volume == pytest.approx(whole.material_volume + expected, rel=5e-4)
    assert body.mesh(tolerance=0.01).volume == pytest.approx(body.material_volume, rel=1e-3)
    assert body.capacity == whole.capacity
    assert body.wall_min == whole.wall_min


def test_a_sunk_relief_leaves_the_wall_that_is_said() -> None:
    body = document(STRIPES).body()
    assert body.wall_min == pytest.approx(2.0, abs=1e-6)
    mesh = trimesh.Trimesh(body.mesh().positions, body.mesh().faces, process=False)
    rng = np.random.default_rng(3)
    radii = met(mesh, rng.uniform(0, 2 * pi, 200), rng.uniform(6.0, 98.0, 200))
    walls = np.array([each[1] - each[0] for each in radii])
    assert body.wall_min - 0.1 <= walls.min() < 2.1
    deep = document(replace(BAND, relief=-2.4)).body()
    assert [type(each) for each in deep.worked.doubts] == [ThinUnderRelief]
    for depth in (-3.0, -7.0):
        with pytest.raises(SolidError) as refused:
            document(replace(BAND, relief=depth)).body().mesh()
        assert isinstance(refused.value.finding, ReliefPierces)
        assert "\n" not in str(refused.value)


def test_an_edge_finer_than_a_relief_is_taken_apart_is_said() -> None:
    for edge, doubts in ((0.1, [EdgeWidened]), (1.0, [])):
        layer = Layer(LayerKind.BAND, start=0.4, end=0.6, relief=1.0, edge=edge)
        body = Document(TUBE, appearance=Appearance(drawing=(layer,))).body()
        found = body.worked.doubts
        assert [type(each) for each in found] == doubts
        # Three samples over an edge of the 4096 around.
        assert all(each.made == pytest.approx(3 * 2 * np.pi * 40 / 4096) for each in found)


def test_a_relief_is_held_back_where_it_would_fold() -> None:
    waist = Profile((Segment([(30, 0), (-5, 45), (-5, 55), (30, 100)]),))
    solid = Solid(BodyKind.FILLED)
    body = document(replace(BAND, relief=-40.0), profile=waist, solid=solid).body()
    assert [type(each) for each in body.worked.doubts] == [ReliefHeldBack]
    mesh = body.mesh()
    assert mesh.is_watertight
    assert mesh.volume > 0.0


@st.composite
def reliefs(draw: st.DrawFn) -> tuple[Layer, ...]:
    """Draw up to three layers that are raised or sunk by less than half of the wall."""
    return tuple(
        Layer(
            draw(st.sampled_from(list(LayerKind))),
            start=draw(st.sampled_from([0.0, 0.2, 0.5])),
            end=draw(st.sampled_from([0.6, 0.9, 1.0])),
            by=draw(st.sampled_from(Along)),
            count=draw(st.integers(1, 9)),
            width=draw(st.sampled_from([0.2, 0.5, 1.0])),
            twist=draw(st.sampled_from([0.0, 0.3])),
            stops=((0.0, "#000000"), (1.0, "#ffffff")),
            segments=(0,),
            relief=draw(st.sampled_from([-0.4, 0.4, 1.5])),
            edge=draw(st.sampled_from([2.0, 6.0])),
        )
        for _ in range(draw(st.integers(1, 3)))
    )


LAWS = (
    (),
    (Law("omega", "cosine", 0.0, 1.0, count=5),),
    (Law("radius", "cosine", 0.9, 1.1, count=4),),
)


@settings(deadline=None, suppress_health_check=list(HealthCheck), max_examples=10)
@given(
    reliefs(),
    st.sampled_from([TUBE, BELLY, KINKED, ring().profile]),
    st.sampled_from(LAWS),
    st.sampled_from([0.0, 0.2]),
    st.sampled_from([360.0, 200.0]),
    st.sampled_from(
        [
            WALL,
            replace(WALL, side=WallSide.OUTSIDE, rim=Rim.ROUND),
            replace(WALL, foot_ring=3.0, drain_hole=6.0),
            Solid(BodyKind.FILLED),
        ]
    ),
    st.booleans(),
)
def test_whatever_is_raised_stays_closed_and_outward(
    layers, profile, laws, turns, sweep, solid, cut
) -> None:
    plain = Document(
        profile,
        variation=laws,
        twist=Twist(turns=turns),
        revolution=Revolution(sweep_deg=sweep),
        solid=solid,
        cut_outs=(CutOut(width=4.0, rows=1, around=5),) if cut else (),
    )
    try:
        body_mesh(plain.surface, plain.solid, tolerance=1.0)
        plain.body().mesh(tolerance=1.0)
    except FindingError:
        return
    body = replace(plain, appearance=Appearance(drawing=layers)).body()
    mesh = body.mesh(tolerance=0.6)
    assert mesh.is_watertight
    other = trimesh.Trimesh(mesh.positions, mesh.faces, process=False)
    assert other.is_winding_consistent
    assert other.volume > 0.0
    assert body.surface.laws or body.wall_min is None or body.wall_min >= 3.0 - 1.2 - 1e-9
    bare = replace(plain, solid=Solid(), cut_outs=(), appearance=Appearance(drawing=layers)).body()
    assert bare.mesh(tolerance=0.6).is_oriented


def test_normals_follow_the_relief() -> None:
    mesh = document(BAND, STRIPES, profile=BELLY).body().mesh(tolerance=0.15)
    facets = mesh.triangle_normals
    facets = facets / np.linalg.norm(facets, axis=1, keepdims=True)
    corners = mesh.normals[mesh.triangles]
    assert np.einsum("tx,tkx->tk", facets, corners).min() > 0.7


def test_paint_alone_changes_no_mesh_and_no_file() -> None:
    layer = replace(BAND, relief=0.0, edge=1.0)
    assert document(layer).body() == document().body()
    from sgb_core.document.file import project_file

    assert b"relief" not in project_file.dumps(document(layer))
    raised = document(BAND)
    assert project_file.loads(project_file.dumps(raised)) == raised


def test_depths_grow_with_the_object_and_colours_play_no_part() -> None:
    inches = edits.set_unit(document(BAND), Unit.IN, convert=True)
    assert inches.appearance.drawing[0].relief == pytest.approx(1.5 / 25.4)
    assert inches.appearance.drawing[0].edge == pytest.approx(3.0 / 25.4)
    assert document(replace(BAND, color="#ff0000")).body() == document(BAND).body()


def test_what_cannot_hold_a_relief_says_so() -> None:
    with pytest.raises(ExportError) as refused:
        exchange.file_size(document(BAND), ".step")
    assert refused.value.finding is NoStep.RELIEF
    fine = replace(STRIPES, edge=0.0, count=900, relief=1.0)
    with pytest.raises(FindingError) as too_many:
        document(fine).body().mesh(tolerance=0.002)
    assert isinstance(too_many.value.finding, TooManyTriangles)


def test_a_relief_that_fills_a_narrow_place_is_refused_and_not_elsewhere() -> None:
    points = [(40.0, 0.0), (40.0, 30.0), (25.0, 30.0), (25.0, 32.0), (40.0, 32.0), (40.0, 60.0)]
    groove = Profile.of([line(a, b) for a, b in pairwise(points)])
    stripes = Layer(LayerKind.STRIPES, count=9, width=0.5, edge=3.0)
    for kind in (BodyKind.FILLED, BodyKind.VESSEL, BodyKind.SURFACE):
        solid = Solid(kind, wall=2.0, base=3.0)
        for depth in (0.6, 2.0):
            look = Appearance(drawing=(replace(stripes, relief=depth),))
            body = Document(groove, solid=solid, appearance=look).body()
            if depth < 1.0:
                assert crossings(body.mesh(tolerance=0.3)) == 0
                continue
            with pytest.raises(FindingError) as caught:
                body.mesh(tolerance=0.3)
            assert isinstance(caught.value.finding, ReliefMeets)
            assert 30.0 <= caught.value.finding.height <= 32.0


def test_columns_without_relief_are_passed_over() -> None:
    tube = Profile.of([line((40.0, 0.0), (40.0, 60.0))])
    letter = Layer(LayerKind.TEXT, start=0.4, end=0.6, count=1, text="A", relief=1.0, edge=1.0)
    look = Appearance(drawing=(letter,))
    mesh = Document(tube, solid=Solid(BodyKind.FILLED), appearance=look).body().mesh(tolerance=0.1)
    assert mesh.is_watertight
