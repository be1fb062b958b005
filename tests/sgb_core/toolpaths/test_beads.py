"""Beads as they are seen: on the path, facing outwards, all of them however many points go."""

from dataclasses import replace

import numpy as np
import pytest

import resources
from sgb_core.bodies.solid import BodyKind, Solid
from sgb_core.curves.primitives import line
from sgb_core.curves.profile import Profile
from sgb_core.document.model import Document
from sgb_core.surfaces.variation import Law
from sgb_core.toolpaths.beads import beads, bed_lines
from sgb_core.toolpaths.plan_path import toolpath
from sgb_core.toolpaths.printer import BedShape, read_printer
from sgb_core.toolpaths.settings import Wanted
from sgb_core.toolpaths.strand import Part

PLASTIC = read_printer(resources.printers()[0])
CUP = Document(Profile.of([line((20.0, 0.0), (26.0, 30.0))]))
FLUTED = replace(CUP, variation=(Law("radius", "cosine", 1.0, 1.2, count=12),))
VESSEL = replace(CUP, solid=Solid(BodyKind.VESSEL, wall=0.9, base=1.0))
SHAPES = {"cup": CUP, "fluted": FLUTED, "vessel": VESSEL}


@pytest.fixture(params=SHAPES)
def path(request):
    return toolpath(SHAPES[request.param], PLASTIC, Wanted(skirt=2, walls=2))


def faces(found):
    quads = found.quads.reshape(-1, 4)
    corners = found.corners.reshape(-1, 3)[quads]
    across = np.cross(corners[:, 1] - corners[:, 0], corners[:, 3] - corners[:, 0])
    return across, found.normals.reshape(-1, 3)[quads].mean(axis=1)


def test_tops_lie_on_the_path_and_are_as_wide_as_the_bead(path):
    found = beads(path, 10**9)
    assert np.array_equal(found.kept, np.arange(len(path.points)))
    middle = found.corners[:, 1:3].mean(axis=1)
    assert np.allclose(middle, path.points, atol=1e-9)
    wide = np.linalg.norm(found.corners[:, 1] - found.corners[:, 2], axis=1)
    assert np.allclose(wide, path.plan.bead)
    assert found.corners[..., 2].min() >= 0.0


def test_there_is_a_bead_for_each_move_that_prints(path):
    found = beads(path, 10**9)
    assert np.array_equal(found.moves, np.flatnonzero(path.parts != Part.TRAVEL))


@pytest.mark.parametrize("most", [10**9, 3_000])
def test_they_face_outwards(path, most):
    across, facing = faces(beads(path, most))
    large = np.linalg.norm(across, axis=1) > 1e-9
    assert ((across * facing).sum(axis=1)[large] > 0.0).mean() > 0.97


def test_fewer_points_keep_the_shape(path):
    found = beads(path, 4_000)
    assert len(found.kept) < len(path.points)
    assert len(found.kept) < 3 * 4_000
    drawn, whole = found.corners[:, 1:3].reshape(-1, 3), path.bounds
    assert np.abs(drawn.min(axis=0) - whole[0]).max() < 2.0 * path.plan.bead
    assert np.abs(drawn.max(axis=0) - whole[1]).max() < 2.0 * path.plan.bead
    # No bead leads from one piece to the next.
    wall = path.parts[found.kept[found.moves]] == Part.WALL
    ends = np.stack([found.kept[found.moves - 1], found.kept[found.moves]], axis=-1)[wall]
    steps = np.linalg.norm(np.diff(path.points[ends], axis=1)[:, 0], axis=1)
    assert steps.max() < 0.5 * np.ptp(path.points[:, 0])


@pytest.mark.parametrize("shape", BedShape)
def test_the_lines_of_a_bed_lie_within_its_outline(shape):
    bed = replace(PLASTIC.bed, shape=shape, width=200.0, depth=160.0)
    outline, *lines = bed_lines(bed)
    assert np.allclose(outline[0], outline[-1])
    points = np.concatenate(lines)
    assert np.abs(points[:, 0]).max() <= 100.0 + 1e-9
    if shape is BedShape.CIRCLE:
        assert np.hypot(*points[:, :2].T).max() <= 100.0 + 1e-9
        assert np.ptp(outline[:, 1]) == pytest.approx(200.0)
    else:
        assert np.ptp(outline[:, 1]) == pytest.approx(160.0)
