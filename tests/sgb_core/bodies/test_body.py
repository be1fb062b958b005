from __future__ import annotations

from dataclasses import replace
from math import pi

import manifold3d
import numpy as np
import pytest
import trimesh
from hypothesis import HealthCheck, assume, given, settings
from hypothesis import strategies as st

from sgb_core.bodies.body import SolidError, body_mesh, section_polygons
from sgb_core.bodies.solid import BodyKind, Rim, Solid, WallSide
from sgb_core.bodies.vessel import vessel_measures
from sgb_core.curves.profile import Profile
from sgb_core.findings.bodies import TightCurve
from sgb_core.findings.words import say
from sgb_core.surfaces.mesh import Mesh
from sgb_core.surfaces.revolution import RevolutionSurface
from sgb_core.surfaces.variation import Law
from tests.sgb_core.bodies.crossing_triangles import crossing_triangles
from tests.sgb_core.bodies.vessels import TUBE, bodies, pots, vessel
from tests.sgb_core.surfaces.chains import CROSSING, RING, chain, degenerate_count

FLARED = RevolutionSurface(chain([[(15, 0), (45, 10), (10, 50), (30, 70)]]))


def check(mesh: Mesh, volume: float, tolerance: float) -> None:
    """Hold a mesh to the judges: closed, outward, a manifold also in single precision."""
    assert mesh.is_watertight
    assert degenerate_count(mesh) == 0
    solid = manifold3d.Manifold(
        manifold3d.Mesh(mesh.positions.astype(np.float32), mesh.faces.astype(np.uint32))
    )
    assert solid.status() == manifold3d.Error.NoError
    judged = trimesh.Trimesh(mesh.positions.astype(np.float32), mesh.faces, process=True)
    assert judged.is_watertight
    assert judged.is_winding_consistent
    assert judged.volume == pytest.approx(mesh.volume, rel=1e-3)
    # The mesh lies within the tolerance of the true body, so its volume within tolerance · area.
    assert abs(mesh.volume - volume) <= tolerance * mesh.area


@settings(max_examples=60, deadline=None, suppress_health_check=[HealthCheck.too_slow])
@given(st.data())
def test_random_bodies_are_closed_and_of_the_right_volume(data: st.DataObject) -> None:
    surface = data.draw(pots())
    size = surface.profile.size
    body = data.draw(bodies(size))
    try:
        measured = vessel_measures(surface, body)
    except SolidError:
        assume(False)
    tolerance = 2e-3 * size
    check(body_mesh(surface, body, tolerance=tolerance), measured.material_volume, tolerance)


@settings(max_examples=6, deadline=None, suppress_health_check=[HealthCheck.too_slow])
@given(st.data())
def test_no_triangle_of_a_random_body_crosses_another(data: st.DataObject) -> None:
    surface = data.draw(pots())
    body = data.draw(bodies(surface.profile.size))
    try:
        mesh = body_mesh(surface, body, samples=(3, 6))
    except SolidError:
        assume(False)
    assert crossing_triangles(mesh) == []


def test_triangles_that_cross_are_found() -> None:
    ball = trimesh.creation.icosphere(1)
    count = len(ball.vertices)
    faces = np.concatenate([ball.faces, ball.faces + count])
    rest = np.zeros((2 * count, 3)), np.zeros((2 * count, 2)), faces
    for away, crossing in ((3.0, False), (0.7, True)):
        moved = ball.vertices + np.array([away, 0.1, 0.03])
        both = Mesh(np.concatenate([ball.vertices, moved]), np.arange(2 * count), *rest)
        assert bool(crossing_triangles(both)) == crossing


@pytest.mark.parametrize("side", WallSide)
@pytest.mark.parametrize("rim", Rim)
@pytest.mark.parametrize("sweep", [2.0 * pi, 2.0])
def test_the_mesh_comes_as_near_as_one_likes(side: WallSide, rim: Rim, sweep: float) -> None:
    surface = replace(FLARED, sweep=sweep)
    body = vessel(side=side, rim=rim, drain_hole=5.0)
    volume = vessel_measures(surface, body).material_volume
    errors = [
        abs(body_mesh(surface, body, tolerance=tolerance).volume / volume - 1)
        for tolerance in (0.1, 0.01)
    ]
    assert errors[0] < 0.1
    assert errors[1] < 0.15 * errors[0] + 1e-6


@pytest.mark.parametrize("samples", [(4, 12), (16, 48), (1, 3)])
def test_samples_fix_the_intervals(samples: tuple[int, int]) -> None:
    mesh = body_mesh(RevolutionSurface(TUBE), vessel(), samples=samples)
    assert mesh.is_watertight
    assert mesh.volume < vessel_measures(RevolutionSurface(TUBE), vessel()).material_volume


def test_a_profile_on_the_far_side_gives_the_same_body_half_a_turn_on() -> None:
    profile = Profile(tuple(s.with_points(s.points * (-1, 1)) for s in FLARED.profile.segments))
    for sweep in (2.0 * pi, 2.0):
        there = body_mesh(replace(FLARED, profile=profile, sweep=sweep), vessel())
        here = body_mesh(replace(FLARED, sweep=sweep, start=pi), vessel())
        assert there.is_watertight
        assert there.volume == pytest.approx(here.volume, rel=1e-12)
        assert np.allclose(there.bounds, here.bounds, atol=1e-9)


def distances_across(mesh: Mesh, origins: np.ndarray, directions: np.ndarray) -> np.ndarray:
    """Return how far rays that start just inside the mesh run until they leave it."""
    a, b, c = np.moveaxis(mesh.positions[mesh.faces], 1, 0)
    result = []
    for origin, direction in zip(origins, directions, strict=True):
        p = np.cross(direction, c - a)
        det = np.einsum("ij,ij->i", b - a, p)
        with np.errstate(divide="ignore", invalid="ignore"):
            u = np.einsum("ij,ij->i", origin - a, p) / det
            q = np.cross(origin - a, b - a)
            v = q @ direction / det
            t = np.einsum("ij,ij->i", c - a, q) / det
        hit = (u >= -1e-9) & (v >= -1e-9) & (u + v <= 1 + 1e-9) & (t > 1e-6)
        result.append(t[hit].min())
    return np.array(result)


@pytest.mark.parametrize("side", WallSide)
def test_rays_across_the_wall_measure_its_thickness(side: WallSide) -> None:
    """Also at the shoulder, where a wall measured level would be thin."""
    mesh = body_mesh(FLARED, vessel(side=side), tolerance=0.005)
    s = np.linspace(0.2, 0.85, 40)
    theta = np.linspace(0.1, 6.0, 40)
    points, normals = FLARED.point(0, s, theta), FLARED.normal(0, s, theta)
    inward = -normals if side is WallSide.INSIDE else normals
    across = distances_across(mesh, points + 0.02 * inward, inward) + 0.02
    assert np.abs(across - 3.0).max() < 0.02


def test_a_kink_keeps_the_wall_as_thick_on_its_convex_side() -> None:
    bent = RevolutionSurface(
        chain(
            [
                [(30, 0), (30, 10), (30, 20), (30, 30)],
                [(30, 30), (40, 30), (50, 30), (60, 30.0)],
                [(60, 30), (60, 40), (60, 50), (60, 60)],
            ]
        )
    )
    for side in WallSide:
        mesh = body_mesh(bent, vessel(side=side), tolerance=0.002)
        drawn = np.array([(30, 30.0), (60, 30)])
        other = mesh.positions[np.abs(mesh.positions[:, 1]) < 1e-9]
        other = other[other[:, 0] > 0][:, [0, 2]]
        gaps = np.hypot(*(other[:, None] - drawn).transpose(2, 0, 1))
        # The wall's own points; those of the drawn profile lie on it.
        on_drawn = (
            (np.abs(other[:, 0] - 30) < 1e-6) & (other[:, 1] <= 30)
            | (np.abs(other[:, 1] - 30) < 1e-6) & (other[:, 0] >= 30) & (other[:, 0] <= 60)
            | (np.abs(other[:, 0] - 60) < 1e-6) & (other[:, 1] >= 30)
        )
        assert gaps[~on_drawn].min() == pytest.approx(3.0, abs=0.003)


def test_sections_are_polygons_with_roles_and_true_normals() -> None:
    (polygon,) = section_polygons(FLARED, vessel(rim=Rim.ROUND), tolerance=0.05)
    assert set(polygon.roles) >= {"drawn", "wall", "rim", "floor", "foot"}
    assert len(polygon.exterior) == len(polygon.roles) == len(polygon.normals)
    edges = np.roll(polygon.exterior, -1, axis=0) - polygon.exterior
    outward = np.stack([edges[:, 1], -edges[:, 0]], axis=1)
    outward /= np.hypot(*outward.T)[:, None]
    assert ((outward * polygon.normals).sum(axis=1) > 0.9).all()
    assert section_polygons(FLARED, Solid()) == ()


def test_rings_have_bodies() -> None:
    ring = RevolutionSurface(chain(RING, (1, 3, 1, 0), closed=True))
    for side in WallSide:
        (polygon,) = section_polygons(ring, vessel(side=side, wall=0.1))
        assert len(polygon.holes) == 1
        for sweep in (2.0 * pi, 1.0):
            turned = replace(ring, sweep=sweep)
            body = vessel(side=side, wall=0.1)
            volume = vessel_measures(turned, body).material_volume
            check(body_mesh(turned, body, tolerance=0.002), volume, 0.002)


@pytest.mark.parametrize(
    "law",
    [
        Law("lambda2", "raised-cosine", 1.0, 5.0),
        Law("omega", "paper", 0.0, 1.0),
        Law("lambda1", "cosine", 0.0, 3.0, count=2),
    ],
)
@pytest.mark.parametrize("side", WallSide)
def test_walls_of_varying_profiles(law: Law, side: WallSide) -> None:
    base = Law("omega", "cosine", 1.0, 1.0)
    surface = replace(FLARED, laws=(base, law))
    for sweep in (2.0 * pi, 2.5):
        turned = replace(surface, sweep=sweep)
        body = vessel(side=side, rim=Rim.ROUND, wall=2.0)
        measured = vessel_measures(turned, body)
        check(body_mesh(turned, body, tolerance=0.1), measured.material_volume, 0.1)
        assert measured.wall_min is not None
        assert 1.0 < measured.wall_min <= 2.0


@pytest.mark.parametrize("rim", Rim)
@pytest.mark.parametrize("base", [0.0, 1.1])
def test_a_lid_of_the_cavity_never_passes_for_the_body_at_some_angle(rim: Rim, base: float) -> None:
    """Its line lies on the foot's; rounding must not choose between them, angle by angle."""
    points = [
        [(24.5, 0.0), (22.1, 9.34), (40.1, 17.5), (45.4, 27.3)],
        [(45.4, 27.3), (52.9, 40.8), (29.3, 51.4), (25.0, 60.8)],
    ]
    law = Law("omega", "paper", 0.1, 0.37)
    surface = RevolutionSurface(chain(points, (2.8, 3.2, 0.9, 0.1)), laws=(law,))
    body = vessel(wall=1.475, base=base, rim=rim)
    for turned in (surface, replace(surface, profile=surface.profile.reversed())):
        volume = vessel_measures(turned, body).material_volume
        check(body_mesh(turned, body, tolerance=0.1), volume, 0.1)


BAD = [
    (chain([[(10, 0), (60, 40), (-20, 40), (30, 0.5)]]), vessel(wall=0.5), "crosses segment 0 at"),
    (chain(CROSSING), vessel(wall=0.05), "beyond the axis from s"),
    (
        chain([[(20, 0), (20, 5), (20, 8), (20, 10)], [(21, 10), (21, 15), (21, 18), (21, 20)]]),
        vessel(),
        "the ends are 1 apart",
    ),
    (TUBE, vessel(wall=25.0), "no cavity is left"),
    (TUBE, vessel(base=60.0), "no cavity is left"),
    (TUBE, vessel(drain_hole=36.0), "wider than the floor"),
    (chain(RING, closed=True), vessel(wall=2.0), "no hollow is left"),
    (chain([[(0, 0), (20, 0), (40, 0), (60, 0)]]), vessel(), "nothing is left"),
    (chain([[(0, 0), (0, 1), (0, 2), (0, 3)]]), vessel(), "lies on the axis"),
    (
        chain([[(20, 0), (20, 20), (20, 40), (20, 60)], [(20, 60), (30, 90), (40, 60), (40, 30)]]),
        Solid(BodyKind.FILLED),
        "cannot be closed to the axis",
    ),
]


@pytest.mark.parametrize(("profile", "solid", "words"), BAD)
def test_bodies_that_cannot_be_made_say_why(profile: Profile, solid: Solid, words: str) -> None:
    with pytest.raises(SolidError) as caught:
        body_mesh(RevolutionSurface(profile), solid)
    assert words in str(caught.value)
    assert "\n" not in str(caught.value)


def test_a_wall_thicker_than_a_curve_allows_is_found_and_says_where() -> None:
    tight = RevolutionSurface(
        chain([[(30, 0), (60, 0), (60, 2), (60, 4)], [(60, 4), (60, 20), (60, 40), (60, 60)]])
    )
    measured = vessel_measures(tight, vessel(wall=8.0))
    (finding,) = measured.findings
    assert isinstance(finding, TightCurve)
    assert finding.segment == 0
    assert "thicker there" in say(finding)
    # The tightest place lies on the curve of the first segment.
    assert 0.0 <= finding.where[1] <= 4.0
    assert measured.wall_min == 8.0


ROLLED = chain([[(20, 0), (20, 20), (20, 40), (20, 55)], [(20, 55), (20, 66), (32, 66), (32, 55)]])
CURLED = chain([[(40, 0), (40, 20), (40, 40), (40, 50)], [(40, 50), (40, 64), (24, 64), (24, 52)]])
PUNTED = chain([[(0, 15), (10, 15), (18, 0), (30, 0)], [(30, 0), (36, 0), (36, 30), (36, 60)]])
FOOTED = chain([[(15, 6), (17, 5), (18, 0), (20, 0)], [(20, 0), (26, 0), (40, 30), (42, 60)]])
DISHED = chain([[(0, 0), (20, 0), (50, 2), (60, 10)]])
BELL = chain([[(40, 0), (30, 30), (30, 60), (0, 60)]])


@pytest.mark.parametrize("profile", [ROLLED, CURLED, PUNTED, FOOTED, DISHED, BELL])
@pytest.mark.parametrize("side", WallSide)
@pytest.mark.parametrize("rim", Rim)
@pytest.mark.parametrize("base", [0.0, 3.0])
def test_lips_punts_feet_and_bells(profile: Profile, side: WallSide, rim: Rim, base: float) -> None:
    body = vessel(wall=2.0, side=side, rim=rim, base=base)
    for sweep in (2.0 * pi, 2.0):
        surface = RevolutionSurface(profile, sweep=sweep)
        volume = vessel_measures(surface, body).material_volume
        check(body_mesh(surface, body, tolerance=0.1), volume, 0.1)


def test_a_neck_narrower_than_the_wall_seals_a_hollow_off() -> None:
    hourglass = chain(
        [[(40, 0), (40, 40), (2, 40), (4, 60)], [(4, 60), (6, 80), (40, 80), (40, 120)]]
    )
    measured = vessel_measures(RevolutionSurface(hourglass), vessel(wall=8.0))
    assert any("closes up at height" in say(finding) for finding in measured.findings)
    mesh = body_mesh(RevolutionSurface(hourglass), vessel(wall=8.0), tolerance=0.1)
    check(mesh, measured.material_volume, 0.1)
