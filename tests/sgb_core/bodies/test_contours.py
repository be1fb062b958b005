"""What is seen of a mesh from one side, against known views and an independent silhouette."""

from __future__ import annotations

from math import cos, pi, sin

import numpy as np
import pytest
import shapely
from scipy.spatial.transform import Rotation

from sgb_core.bodies.body import Body
from sgb_core.bodies.contours import seen_lines
from sgb_core.bodies.solid import BodyKind, Solid
from sgb_core.curves.primitives import arc, line
from sgb_core.curves.profile import Profile
from sgb_core.surfaces.laws.law import Law
from sgb_core.surfaces.mesh import Mesh
from sgb_core.surfaces.revolution import RevolutionSurface
from sgb_core.surfaces.tessellation import tessellate

# Across, up and towards the eye: from the front, along +y.
FRONT = np.array([[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, -1.0, 0.0]])
FILLED = Solid(BodyKind.FILLED)
TUBE = Profile.of([line((40.0, 0.0), (40.0, 100.0))])


def prism(corners: int, first: float) -> Mesh:
    law = Law("radius", "polygon", cos(pi / corners), 1.0, count=corners)
    return Body(RevolutionSurface(TUBE, start=first, laws=(law,)), FILLED).mesh(tolerance=0.02)


def upright_at(lines: list[np.ndarray]) -> list[float]:
    """Return where lines from bottom to top stand, from left to right."""
    found = [line[:, 0] for line in lines if np.ptp(line[:, 1]) > 95.0 and np.ptp(line[:, 0]) < 1.0]
    return sorted(float(each.mean()) for each in found)


def test_of_a_sphere_one_circle_is_seen_from_anywhere() -> None:
    arcs = [arc((0.0, 0.0), 1.0, a, a + pi / 2.0)[0] for a in (-pi / 2.0, 0.0)]
    mesh = tessellate(RevolutionSurface(Profile.of(arcs)), tolerance=1e-3)
    for frame in (FRONT, Rotation.from_rotvec([0.4, 1.1, -0.3]).as_matrix() @ FRONT):
        middle = 0.5 * (mesh.positions.min(axis=0) + mesh.positions.max(axis=0))
        away = np.concatenate(seen_lines(mesh, frame, 1e-3)) - (frame @ middle)[:2]
        assert np.hypot(*away.T) == pytest.approx(np.ones(len(away)), rel=2e-3)
        turned = np.sort(np.arctan2(away[:, 1], away[:, 0]))
        assert np.diff(turned).max() < 0.2


def test_of_a_prism_the_edges_in_front_are_seen_and_none_behind() -> None:
    # A corner towards the eye, two at the sides, one behind.
    assert upright_at(seen_lines(prism(4, 0.0), FRONT, 0.02)) == pytest.approx(
        [-40.0, 0.0, 40.0], abs=0.1
    )
    # A face towards the eye: of six corners two stand in front and two at the sides.
    half = 40.0 * sin(pi / 6.0)
    assert upright_at(seen_lines(prism(6, 0.0), FRONT, 0.02)) == pytest.approx(
        [-40.0, -half, half, 40.0], abs=0.1
    )


def test_what_stands_behind_is_seen_only_beside_what_stands_before() -> None:
    small, large = prism(4, 0.0), prism(6, 0.0)
    back = small.positions * (0.5, 0.5, 1.4) + (30.0, 200.0, 0.0)
    count, corners = len(large.positions), len(large.normals)
    both = Mesh(
        np.concatenate([large.positions, back]),
        np.concatenate([large.corner_positions, small.corner_positions + count]),
        np.concatenate([large.normals, small.normals]),
        np.concatenate([large.uv, small.uv]),
        np.concatenate([large.triangles, small.triangles + corners]),
    )
    seen = shapely.union_all([shapely.LineString(part) for part in seen_lines(both, FRONT, 0.02)])
    # Its corners stand at 10, 30 and 50: the last beside the front one, the others above it.
    for x, low in ((10.0, 100.0), (30.0, 100.0), (50.0, 0.0)):
        edge = shapely.intersection(seen, shapely.box(x - 0.3, 1.0, x + 0.3, 139.0))
        assert edge.bounds[1] == pytest.approx(max(low, 1.0), abs=3.0)
        assert edge.bounds[3] == pytest.approx(139.0, abs=1.0)


@pytest.mark.parametrize("turn", [0.0, 0.3, 1.7])
def test_the_outermost_of_the_lines_is_the_silhouette(turn: float) -> None:
    law = Law("radius", "lobes", 1.0, 0.8, count=5)
    mesh = Body(RevolutionSurface(TUBE, start=turn, laws=(law,)), FILLED).mesh(tolerance=0.02)
    flat = (mesh.positions @ FRONT.T)[mesh.faces][..., :2]
    shadow = shapely.union_all(shapely.make_valid(shapely.polygons(flat)), grid_size=1e-6)
    lines = shapely.union_all([shapely.LineString(part) for part in seen_lines(mesh, FRONT, 0.02)])
    assert shapely.hausdorff_distance(shapely.convex_hull(lines), shapely.convex_hull(shadow)) < 0.1
    # Every place of the shadow's border is drawn.
    border = shapely.segmentize(shapely.boundary(shapely.buffer(shadow, 1e-3)), 1.0)
    away = shapely.distance(shapely.points(shapely.get_coordinates(border)), lines)
    assert away.max() < 0.3
