"""The lines of the construction lie where the paper's formulas put them."""

from dataclasses import replace

import numpy as np
import pytest
from vtkmodules.vtkRenderingCore import vtkRenderer, vtkRenderWindow

from app.scene.scene import Scene
from app.scene.theory_lines import STEPS, end_circles, interpolated_curves, rational_net
from app.state.cut import Cut
from app.state.overlays import Overlay
from app.state.view_state import ViewState
from app.theme.palette import LIGHT
from sgb_core.document.evaluation import evaluate
from sgb_core.surfaces.variation import Law
from tests.app.viewport.helpers import DRUM, document, reshaped

THEORY = {Overlay.ENDS, Overlay.RATIONAL_MESH, Overlay.INTERPOLATED}
LAW = Law("omega", "cosine", 0.0, 1.0)


def angles_of(lines):
    """The angle in degrees of each line at the point farthest from the axis, z upwards."""
    points = np.stack([max(line, key=lambda p: np.hypot(p[0], p[1])) for line in lines])
    return np.rad2deg(np.arctan2(points[:, 1], points[:, 0])) % 360.0


def test_circles_of_ends_are_those_of_the_boundary_whatever_the_sliders_say():
    doc = replace(document(), variation=(LAW,))
    circles = end_circles(doc.surface)
    ends = {tuple(p) for p in doc.profile.control_points[:, [0, 3]].reshape(-1, 2).round(9)}
    assert len(circles) == len(ends)
    for circle in circles:
        radii, heights = np.hypot(circle[:, 0], circle[:, 1]), circle[:, 2]
        assert (round(radii[0], 9), round(heights[0], 9)) in ends
        assert np.allclose(radii, radii[0])
        assert np.allclose(circle[0], circle[-1])


@pytest.mark.parametrize(("sweep", "wanted"), [(360, [0, 90, 180, 270]), (100, [0, 90]), (45, [0])])
def test_the_interpolated_curves_stand_at_quarter_turns(sweep, wanted):
    doc = document(DRUM, sweep=float(sweep))
    lines = interpolated_curves(doc.surface)
    assert np.allclose(angles_of(lines), np.repeat(wanted, len(doc.profile)), atol=1e-9)


def test_meridians_stand_at_equal_steps_of_t():
    doc = document()
    count = len(doc.profile)
    meridians = rational_net(doc.surface)[: (STEPS + 1) * count : count]
    t = np.linspace(0.0, 1.0, STEPS // 2 + 1)
    cosine = (1 - 2 * t) / (2 * t * t - 2 * t + 1)
    half = np.rad2deg(np.arccos(cosine))
    wanted = np.concatenate([half, 360.0 - half[-2::-1]])
    apart = (angles_of(meridians) - wanted + 180.0) % 360.0 - 180.0
    assert np.abs(apart).max() < 1e-6


def test_under_a_law_the_half_turn_is_the_profile_as_it_is_there():
    doc = replace(document(), variation=(LAW,))
    lines = np.split(np.array(interpolated_curves(doc.surface)), 4)
    for line, omega in zip(lines, (0.0, 0.5, 1.0, 0.5), strict=True):
        wanted = reshaped(doc, omega).profile.sample(line.shape[1])
        assert np.allclose(np.hypot(line[..., 0], line[..., 1]), wanted[..., 0])
        assert np.allclose(line[..., 2], wanted[..., 1])


def test_they_are_made_only_when_shown_and_not_across_a_section():
    window = vtkRenderWindow()
    window.OffScreenRenderingOn()
    renderer = vtkRenderer()
    window.AddRenderer(renderer)
    scene, shape = Scene(renderer, LIGHT), evaluate(document())
    scene.update(shape, ViewState())
    parts = scene.theory.parts
    assert not any(len(parts[overlay].positions) for overlay in THEORY)
    for overlay in THEORY:
        scene.update(shape, ViewState(show=frozenset({overlay})))
        assert {o for o in THEORY if parts[o].actor.GetVisibility()} == {overlay}
        assert len(parts[overlay].positions)
        scene.update(shape, ViewState(show=frozenset({overlay}), cut=Cut.SECTION))
        assert not parts[overlay].actor.GetVisibility()
    window.Finalize()
