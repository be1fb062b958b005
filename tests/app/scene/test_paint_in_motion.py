"""The painted picture that is shown while the hand moves, beside that of a window at rest."""

import numpy as np
import pytest
from vtkmodules.vtkRenderingCore import vtkRenderer

import resources
from app.scene.coats import QUICK
from app.scene.offscreen import grabbed, offscreen_window
from app.scene.scene import Scene
from app.state.view_state import ViewState
from app.theme.palette import LIGHT
from sgb_core.document.evaluation import evaluate
from sgb_core.document.file import project_file

SIZE = (160, 200)
BARE = ViewState(segment=-1, show=frozenset({"surface"}))


def stage():
    renderer = vtkRenderer()
    window = offscreen_window()
    window.SetSize(*SIZE)
    window.AddRenderer(renderer)
    return Scene(renderer, LIGHT), window


def test_a_moving_picture_that_costs_has_a_paint_of_its_own_painted_once():
    doc = project_file.loads(resources.load_preset("earthen-house"))
    evaluation = evaluate(doc)
    scene, window = stage()
    scene.update(evaluation, BARE, fine=True)
    kept = scene._levels[True].actor.GetTexture()
    scene.halved = True
    shown = []
    for _ in range(2):
        scene.update(evaluation, BARE)
        texture = scene._levels[False].actor.GetTexture()
        shown.append((texture, texture.GetInput()))
    assert shown[0] == shown[1]
    width, height, _ = texture.GetInput().GetDimensions()
    # All its tiles lie a multiple of four times around: one part says all.
    assert (width, height) == (QUICK // 4, QUICK)
    scene.update(evaluation, BARE, fine=True)
    assert scene._levels[True].actor.GetTexture() is kept
    window.Finalize()


@pytest.mark.parametrize("name", ["ceramic-pot", "earthen-house"])
def test_a_moving_picture_is_a_resting_one_seen_less_sharply(name):
    evaluation = evaluate(project_file.loads(resources.load_preset(name)))
    scene, window = stage()
    scene.halved = True
    scene.update(evaluation, BARE, fine=True)
    scene.fit(SIZE[0] / SIZE[1])
    seen = []
    for fine in (True, False):
        scene.update(evaluation, BARE, fine=fine)
        window.Render()
        rows, columns = SIZE[1] // 8, SIZE[0] // 8
        picture = grabbed(window, 1)[: 8 * rows, : 8 * columns, :3].astype(float)
        seen.append(picture.reshape(rows, 8, columns, 8, 3).mean(axis=(1, 3)))
    assert np.abs(seen[0] - seen[1]).mean() < 1.5
    assert np.quantile(np.abs(seen[0] - seen[1]), 0.98) < 16.0
    window.Finalize()
