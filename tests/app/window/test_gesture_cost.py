"""What a whole gesture may do no more than once: counted, not timed."""

import pytest

from app.profile_editor import inset
from app.state.view_state import Hover
from sgb_core.document import edits
from sgb_core.surfaces.ambient_occlusion import BodyLight
from tests.app.window_stage import WindowStage
from tests.benchmarks.window import preset


@pytest.fixture
def stage(qtbot):
    made = WindowStage(qtbot, make_panels=False)
    yield made
    made.presenter.cancel()
    made.close()


def counted(monkeypatch, owner, name):
    """Return the list that grows whenever ``owner.name`` is called."""
    real, calls = getattr(owner, name), []

    def call(*args, **more):
        calls.append(name)
        return real(*args, **more)

    monkeypatch.setattr(owner, name, call)
    return calls


def slide(stage, first, last):
    for k in range(first, last):
        value = 0.30 + 0.02 * k
        stage.presenter.apply(lambda d, v=value: edits.set_shape_parameter(d, 1, "omega", v))
        stage.settle()
        stage.until(lambda: not stage.window.body_work._thread)


def test_a_vessel_is_refined_once_when_the_hand_has_let_go(stage):
    stage.presenter.replace_document(preset("bowl"))
    stage.settle()
    view = stage.window.surface_view
    # However slow the machine is: the body comes first.
    view._painter._patience.setInterval(600_000)
    stage.presenter.begin("ω of segment 2")
    slide(stage, 0, 3)
    finely = []
    window = view.plotter.ren_win
    window.AddObserver("EndEvent", lambda *_: finely.append(window.GetMultiSamples() > 0))
    stage.presenter.commit()
    stage.settle()
    assert finely.count(True) == 1
    assert finely[-1]
    assert view.scene.solid.state.fine


def test_a_coarse_body_is_refined_where_the_fine_one_does_not_come(stage):
    stage.presenter.replace_document(preset("bowl"))
    stage.settle()
    view = stage.window.surface_view
    view._painter._patience.setInterval(0)
    stage.presenter.begin("ω of segment 2")
    slide(stage, 0, 2)
    stage.window.body_work.stop()
    stage.presenter.commit()
    stage.until(lambda: view._refined)
    assert not view.scene.solid.state.fine


def test_the_light_on_a_body_is_laid_anew_when_it_rests_not_when_it_moves(stage, monkeypatch):
    stage.presenter.replace_document(preset("bowl"))
    stage.settle()
    stage.presenter.begin("ω of segment 2")
    slide(stage, 0, 2)
    laid = counted(monkeypatch, BodyLight, "on_corners")
    slide(stage, 2, 6)
    assert laid == []
    stage.presenter.commit()
    stage.settle()
    assert laid


def test_the_fan_of_a_slider_is_painted_once_while_it_moves(stage, monkeypatch):
    stage.presenter.set_view(segment=1, hover=Hover("omega", 1))
    fans = counted(monkeypatch, inset, "_draw_range")
    curves = counted(monkeypatch, inset, "_draw_segment")
    stage.presenter.begin("ω of segment 2")
    slide(stage, 0, 4)
    assert len(fans) == 1
    assert len(curves) >= 4
    points = stage.document.profile.segments[1].points
    stage.presenter.apply(lambda d: edits.move_point(d, 1, 1, tuple(points[1] + 2.0)))
    stage.settle()
    assert len(fans) == 2
