import numpy as np
import pytest

from app.scene import shapes
from sgb_core.document.evaluation import evaluate
from sgb_core.surfaces.grid import SweepGrid
from tests.app.viewport.helpers import DRUM, VASE, document


@pytest.mark.parametrize("axis", ["x", "y", "z"])
def test_profile_plane_and_circles_agree_with_the_drawn_surface(axis):
    doc = document(axis=axis)
    grid = SweepGrid(3, 8, 16)
    grid.write(doc.surface)
    first_column = grid.points.reshape(3, 9, grid.columns, 3)[:, :, 0]
    samples = shapes.in_profile_plane(doc.surface, doc.profile.sample(9))
    assert np.allclose(first_column, samples, atol=1e-4)
    circles = shapes.circle_lines(doc.surface)
    points = shapes.in_profile_plane(doc.surface, doc.profile.control_points)
    assert np.allclose(circles[:, :, 0], points[:, 1:3].swapaxes(0, 1))
    assert np.allclose(circles[:, :, 0], circles[:, :, -1])


def test_marks_lie_on_their_circles_without_doubling():
    doc = document()
    marks = shapes.circle_marks(doc.surface)
    assert marks.shape == (2, 3, shapes.MARKS_PER_TURN, 3)
    radii = np.hypot(marks[..., 0], marks[..., 1])
    inner = doc.profile.control_points[:, 1:3, 0].T
    assert np.allclose(radii, inner[..., None])
    gaps = np.linalg.norm(np.diff(marks, axis=2), axis=-1)
    assert np.allclose(gaps, gaps[..., :1])
    assert np.linalg.norm(marks[0, 0, 0] - marks[0, 0, -1]) == pytest.approx(gaps[0, 0, 0])


def test_arcs_of_a_partial_sweep_end_where_the_surface_ends():
    doc = document(DRUM, sweep=90.0)
    circles = shapes.circle_lines(doc.surface)
    assert np.allclose(circles[0, 0, -1], [0.0, 0.9, 0.0], atol=1e-12)


def test_axis_line_reaches_beyond_the_object_and_ends_on_long_dashes():
    dashes = shapes.axis_line(document().surface)
    heights = dashes[..., 2]
    assert heights.min() < 0
    assert heights.max() > 122
    assert (np.diff(heights.ravel()) > 0).all()
    lengths = heights[:, 1] - heights[:, 0]
    assert lengths[0] == pytest.approx(lengths[-1])


@pytest.mark.parametrize("glyph", [shapes.star(), shapes.ring(), shapes.disc(), shapes.diamond()])
def test_glyphs_fill_the_unit_circle_with_whole_triangles(glyph):
    points, triangles = glyph
    assert np.linalg.norm(points, axis=1).max() <= 1.02
    a, b, c = (points[triangles[:, k]] for k in range(3))
    areas = np.cross(np.pad(b - a, ((0, 0), (0, 1))), np.pad(c - a, ((0, 0), (0, 1))))[:, 2]
    assert (np.abs(areas) > 1e-6).all()
    assert triangles.max() == len(points) - 1


def test_net_holds_the_ends_of_every_segment():
    lengths, vertices = shapes.net_lines(2, 6, 12, 3, 4)
    assert lengths.sum() == len(vertices)
    lines = np.split(vertices, np.cumsum(lengths)[:-1])
    drawn = {tuple(line) for line in lines}
    for row in (0, 6, 7, 13):
        assert tuple(row * 13 + np.arange(13)) in drawn
    meridians = [line for line in lines if len(line) == 7]
    assert len(meridians) == 2 * 4


def test_only_bodies_without_a_view_inside_count_as_closed():
    ball = (((0, -1), (1.35, -1), (1.35, 1), (0, 1)),)
    assert shapes.is_closed(document(ball).surface)
    assert not shapes.is_closed(document(ball, sweep=270.0).surface)
    assert not shapes.is_closed(document(VASE).surface)
    crossing = (((0, -1), (1.35, -1), (-0.4, 1), (0, 1)),)
    assert not shapes.is_closed(document(crossing).surface)


def test_stretches_beyond_the_axis_are_found_in_space():
    crossing = (((1.2, 0), (-0.6, 0.3), (-0.6, 0.7), (1.2, 1)),)
    runs = list(shapes.offending_runs(evaluate(document(crossing))))
    assert len(runs) == 1
    # θ = 0 is +x for the z-axis, so what lies beyond the axis has x < 0.
    assert runs[0][1:-1, 0].max() < 0.0
    assert list(shapes.offending_runs(evaluate(document(VASE)))) == []
