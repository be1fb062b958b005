import numpy as np
import pytest

from sgb_core.bodies.rays import first_meetings

# A square with the corner (3, 2), counter-clockwise: material on the left of the edges.
CORNERS = np.array([(1.0, 0.0), (3.0, 0.0), (3.0, 2.0), (1.0, 2.0)])
STARTS, ENDS = CORNERS, np.roll(CORNERS, -1, axis=0)
OUTWARD = np.array([(0.0, -1.0), (1.0, 0.0), (0.0, 1.0), (-1.0, 0.0)])


@pytest.mark.parametrize("count", [1, 2000])
def test_rays_from_the_middle_end_at_the_circle_of_the_square(count):
    angles = np.linspace(0.1, 6.2, count)
    rays = np.stack([np.cos(angles), np.sin(angles)], axis=-1)
    origins = np.tile((2.0, 1.0), (count, 1))
    expected = 1.0 / np.abs(rays).max(axis=1)
    np.testing.assert_allclose(first_meetings(origins, rays, STARTS, ENDS), expected, rtol=1e-12)


def test_a_ray_meets_a_corner_and_misses_what_is_beside_or_behind_it():
    origins = np.array([(2.0, 1.0), (0.0, 1.0), (0.0, 3.0), (4.0, 1.0)])
    diagonal = np.array([1.0, 1.0]) / np.sqrt(2.0)
    rays = np.array([diagonal, (1.0, 0.0), (1.0, 0.0), (1.0, 0.0)])
    found = first_meetings(origins, rays, STARTS, ENDS)
    np.testing.assert_allclose(found, [np.sqrt(2.0), 1.0, np.inf, np.inf])


def test_only_edges_that_face_along_the_ray_count_where_normals_are_given():
    # From outside, through the near side, to the far one.
    found = first_meetings(np.array([(0.0, 1.0)]), np.array([(1.0, 0.0)]), STARTS, ENDS, OUTWARD)
    np.testing.assert_allclose(found, 3.0)
    # Along an edge at 80° from square a ray only slips: it does not leave by it.
    slope = np.radians(80.0)
    normal = np.array([(np.cos(slope), np.sin(slope))])
    edge = np.array([(2.0 - np.sin(slope), 1.0 + np.cos(slope))]), np.array([(2.0, 1.0)])
    ray = np.array([(0.0, 1.0)]), np.array([(1.0, 0.0)])
    assert np.isfinite(first_meetings(*ray, *edge))
    assert np.isinf(first_meetings(*ray, *edge, normal))
