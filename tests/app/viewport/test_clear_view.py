"""A fit of the live viewport beside what floats over it."""

import pytest

import resources
from sgb_core.document.file import project_file
from tests.app.viewport.helpers import document
from tests.app.viewport.test_view import Stage


@pytest.fixture
def stage(qtbot):
    made = Stage(qtbot, document())
    yield made
    made.view.shut_down()
    made.window.close()


@pytest.mark.parametrize("projection", ["perspective", "parallel"])
@pytest.mark.parametrize("preset", ["sphere", "bowl", "ring"])
@pytest.mark.parametrize("size", [(380, 330), (610, 620), (1400, 800)])
def test_a_fit_leaves_nothing_under_the_buttons_and_the_cube(stage, size, preset, projection):
    view = stage.view
    stage.presenter.generation += 1
    stage.presenter.edit(project_file.loads(resources.load_preset(preset)))
    if projection == "parallel":
        view.toggle_projection()
    stage.window.resize(*size)
    stage.settle()
    view.fit(smooth=False)
    places = view.pose.places(view.scene.points_to_fit())
    x = view.width() / 2.0 + places[:, 0] * view.height() / 2.0
    y = view.height() / 2.0 - places[:, 1] * view.height() / 2.0
    assert min(x.min(), y.min()) >= 0.0
    assert x.max() <= view.width()
    assert y.max() <= view.height()
    for part in (view.buttons, view.cube):
        box = part.geometry()
        inside = (x >= box.left()) & (x <= box.right()) & (y >= box.top()) & (y <= box.bottom())
        assert not inside.any(), part.accessibleName()
    # It is fitted: some side is nearly touched.
    room = min(x.min(), y.min(), view.width() - x.max(), view.height() - y.max())
    assert room < 0.12 * max(size)
