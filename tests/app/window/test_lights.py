"""What is lit by pointing goes out with the panel under a pointer that rests."""

import pytest
from PySide6.QtCore import QPoint
from PySide6.QtWidgets import QApplication

from app.state.view_state import Hover
from tests.app.mouse import hover
from tests.app.window_stage import WindowStage


@pytest.fixture
def stage(qtbot):
    stage = WindowStage(qtbot, wait_for_scene=False)
    yield stage
    stage.close()


def light(stage):
    """Point at the first slider, as the enter event of a real pointer does."""
    row = stage.window.panels["shape"].cards[0].rows["lambda2"]
    row.hovered.emit(True)
    assert stage.presenter.view.hover == Hover("lambda2", 0)


@pytest.mark.parametrize("way", ["tab", "hide", "alone", "window"])
def test_a_fan_goes_out_when_its_panel_does(qtbot, stage, way):
    window = stage.window
    light(stage)
    if way == "tab":
        window.panels.docks["turn"].raise_()
    elif way == "hide":
        window.panels.docks["shape"].hide()
    elif way == "alone":
        window.arrangement.toggle_alone("viewport")
    else:
        window.hide()
    qtbot.waitUntil(lambda: stage.presenter.view.hover is None)
    window.show()


def test_the_marks_of_other_panels_go_out_too(qtbot, stage):
    window = stage.window
    window.panels.docks["vary"].raise_()
    QApplication.processEvents()
    stage.presenter.set_view(angle=30.0, mark=(0, 0.5))
    window.panels.docks["measures"].raise_()
    qtbot.waitUntil(lambda: stage.presenter.view.angle is None)
    assert stage.presenter.view.mark is None


def test_a_quartic_point_is_let_go_when_the_editor_is_hidden(qtbot, stage):
    editor = stage.window.profile_view
    qtbot.waitUntil(lambda: editor.isVisible() and editor.transform.scale != 1.0)
    quartic = stage.document.profile.segments[0].quartic[2]
    x, y = editor.transform.map(quartic).tolist()
    hover(editor, QPoint(round(x), round(y)))
    assert stage.presenter.view.hover is not None
    stage.window.panels.docks["profile"].hide()
    qtbot.waitUntil(lambda: stage.presenter.view.hover is None)
    assert editor.active is None


def test_the_map_of_influence_follows_the_slider_in_use(stage):
    commands, presenter = stage.window.commands, stage.presenter
    rows = stage.window.panels["shape"].cards[0].rows
    commands["influence_follows"].trigger()
    assert presenter.view.influence == "lambda2"
    rows["omega"].hovered.emit(True)
    rows["omega"].hovered.emit(False)
    assert presenter.view.influence == "omega"
    last = len(stage.document.profile) - 1
    presenter.set_view(hover=Hover("lambda3", last))
    assert (presenter.view.influence, presenter.view.influenced) == ("lambda3", last)
    presenter.set_view(hover=None)
    assert (presenter.view.influence, presenter.view.influenced) == ("lambda3", 0)
    commands["influence_lambda1"].trigger()
    rows["omega"].hovered.emit(True)
    assert (presenter.view.influence, presenter.view.influence_follows) == ("lambda1", False)
    commands["influence_lambda1"].trigger()
    assert presenter.view.influence is None
