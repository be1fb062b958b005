"""Influence colours, the ghost of another state and the meridian, written in place."""

from dataclasses import replace

import numpy as np
import pytest
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkRenderingCore import vtkRenderer, vtkRenderWindow

from app.scene.overlays import net
from app.scene.scene import Scene
from app.state.view_state import ViewState
from app.theme.palette import LIGHT
from sgb_core.curves.profile import Profile
from sgb_core.document.edits.compare import plain_cubic
from sgb_core.document.evaluation import evaluate
from sgb_core.surfaces.influence import section_influence
from sgb_core.surfaces.variation import Law
from tests.app.viewport.helpers import document, reshaped


@pytest.fixture
def scene():
    window = vtkRenderWindow()
    window.OffScreenRenderingOn()
    renderer = vtkRenderer()
    window.AddRenderer(renderer)
    yield Scene(renderer, LIGHT)
    window.Finalize()


def level_of(scene):
    return scene._levels[False]


def scalars(scene):
    data = level_of(scene).actor.GetMapper().GetInput().GetPointData().GetScalars()
    return None if data is None else vtk_to_numpy(data)


def test_influence_colours_follow_the_slider_in_place(scene):
    doc = document()
    view = ViewState(influence="lambda2", all_segments=True)
    scene.update(evaluate(doc), view)
    first = scalars(scene)
    kept = first.copy()
    mapper = level_of(scene).actor.GetMapper()
    assert mapper.GetScalarVisibility()
    s = np.linspace(0.0, 1.0, level_of(scene).grid.per_segment + 1)
    wanted = section_influence(doc.profile, "lambda2", s).max()
    assert scene.overlays.influence.largest == pytest.approx(wanted)
    moved = document(shape=replace(doc.profile.segments[0].shape, lambda1=4.0, omega=1.0))
    scene.update(evaluate(moved), ViewState(influence="lambda1", segment=1))
    again = scalars(scene)
    assert again.__array_interface__["data"] == first.__array_interface__["data"]
    assert np.any(again != kept)
    rows = again.reshape(3, -1, level_of(scene).grid.columns, 3)
    assert np.all(rows[0] == rows[0, 0, 0])
    assert np.any(rows[1] != rows[0, 0, 0])


def test_without_influence_there_is_no_paint(scene):
    doc = document()
    scene.update(evaluate(doc), ViewState(influence="omega"))
    scene.update(evaluate(doc), ViewState())
    assert scalars(scene) is None
    assert not level_of(scene).actor.GetMapper().GetScalarVisibility()


def test_with_laws_colours_vary_around(scene):
    doc = replace(document(), variation=(Law("omega", "raised-cosine", 0.0, 1.0),))
    scene.update(evaluate(doc), ViewState(influence="lambda2", all_segments=True))
    grid = level_of(scene).grid
    painted = scalars(scene).reshape(grid.rows, grid.columns, 3)
    middle = grid.per_segment // 2
    assert np.any(painted[middle, 0] != painted[middle, grid.columns // 2])


def test_the_ghost_is_the_other_state(scene):
    doc = document()
    other = evaluate(plain_cubic(doc))
    scene.update(evaluate(doc), ViewState(), compared=other)
    assert scene.overlays.ghost.actor.GetVisibility()
    points = scene.overlays.ghost.positions
    # Its points lie on the plain cubic's profile, wherever they stand around.
    profile = Profile(other.document.profile.segments).sample(25).reshape(-1, 2)
    places = np.stack([np.hypot(points[:, 0], points[:, 1]), points[:, 2]], axis=-1)
    apart = np.linalg.norm(places[:, None] - profile, axis=-1).min(axis=1)
    assert apart.max() < 1e-4
    scene.update(evaluate(doc), ViewState())
    assert not scene.overlays.ghost.actor.GetVisibility()


def test_the_ghost_is_cheap(scene):
    doc = document()
    scene.update(evaluate(doc), ViewState())
    drawn = sum(len(line) for line in net(evaluate(doc).surface))
    assert drawn < len(level_of(scene).grid.points) / 3


def test_the_meridian_stands_at_the_angle(scene):
    doc = document()
    scene.update(evaluate(doc), ViewState(angle=90.0))
    points = scene.overlays.meridian.positions
    assert np.abs(points[:, 0]).max() < 1e-4
    assert points[:, 1].max() > 1.0
    scene.update(evaluate(reshaped(document(sweep=45.0), 1.0)), ViewState(angle=90.0))
    assert not scene.overlays.meridian.actor.GetVisibility()
