"""Varying, comparing, influence and curvature in the whole window, by menu, key and mouse."""

import numpy as np
import pytest

from app.window.status_bar import certificate_text
from sgb_core.document import edits
from sgb_core.document.file import project_file
from sgb_core.document.model import Document
from sgb_core.surfaces.variation import Law
from tests.app.commands.test_segment_kinds import HALVES
from tests.app.mouse import move, press, release
from tests.app.window_stage import WindowStage

KEYS = ((0.0, 0.0), (120.0, 1.0), (240.0, 0.3))
LAW = Law("lambda2", "keyframes", 0.0, 6.0, keyframes=KEYS)


@pytest.fixture
def stage(qtbot):
    made = WindowStage(qtbot)
    yield made
    made.close()


def test_a_key_dragged_in_the_window_reshapes_the_surface_while_it_moves(stage):
    stage.presenter.do("law", lambda d: edits.add_law(d, LAW))
    stage.window.panels.docks["vary"].raise_()
    stage.settle()
    before, kept = stage.viewport(), stage.document
    curve = stage.window.panels["vary"].form.curve
    assert curve.isVisible()
    press(curve, curve.place(120.0, 1.0))
    move(curve, curve.place(60.0, 0.4))
    stage.settle()
    assert stage.session.in_gesture
    assert np.any(before != stage.viewport())
    release(curve, curve.place(60.0, 0.4))
    stage.settle()
    assert stage.session.undo_label == "Move key of λ2"
    stage.window.commands["undo"].trigger()
    assert stage.document is kept


def test_comparison_by_menu_draws_in_both_views_and_goes_again(stage):
    bare, paper = stage.viewport(), stage.window.profile_view.grab().toImage()
    action = stage.window.commands["compare_cubic"]
    action.trigger()
    stage.settle()
    assert action.isChecked()
    assert np.any(bare != stage.viewport())
    assert stage.window.profile_view.grab().toImage() != paper
    action.trigger()
    stage.settle()
    assert not action.isChecked()
    assert stage.presenter.frame.compared is None


def test_the_last_save_is_compared_live(stage):
    stage.window.commands["compare_saved"].trigger()
    stage.presenter.do("ω", lambda d: edits.set_shape_parameter(d, None, "omega", 0.0))
    stage.settle()
    assert stage.presenter.frame.compared.document is stage.session.saved_document


def test_influence_has_its_colours_and_its_key(stage):
    key = stage.window.surface_view.colour_key
    assert not key.isVisible()
    bare = stage.viewport()
    stage.presenter.set_view(all_segments=True)
    stage.window.commands["influence_lambda2"].trigger()
    stage.settle()
    assert key.isVisible()
    assert key.top.endswith("mm")
    assert np.mean(np.any(bare != stage.viewport(), axis=-1)) > 0.05
    stage.window.commands["influence_lambda2"].trigger()
    stage.settle()
    assert not key.isVisible()


def test_the_curvature_plot_comes_and_goes(stage):
    dock = stage.window.panels.docks["curvature"]
    assert dock.isHidden()
    stage.window.commands["curvature_plot"].trigger()
    stage.settle()
    assert dock.isVisible()
    assert stage.window.commands["curvature_plot"].isChecked()
    stage.window.commands["curvature_plot"].trigger()
    assert dock.isHidden()


def test_the_comb_is_made_longer_by_command(stage):
    commands = stage.window.commands
    assert not commands["comb_longer"].isEnabled()
    commands["show_comb"].trigger()
    stage.settle()
    before = stage.window.profile_view.grab().toImage()
    commands["comb_longer"].trigger()
    stage.settle()
    assert stage.presenter.view.comb_length > 1.0
    assert stage.window.profile_view.grab().toImage() != before


def test_opening_halves_in_one_direction_offers_to_join_them(stage, tmp_path):
    path = tmp_path / "ring.sgb"
    project_file.save(HALVES, path)
    assert stage.window.files.open_path(path)
    bar = stage.window.notice_bar
    assert bar.notice.action == "Put head to tail"
    bar._button.click()
    stage.settle()
    assert stage.document.profile.closed
    stage.window.commands["undo"].trigger()
    assert stage.document == HALVES


def test_certificates_are_told(stage):
    words = certificate_text(stage.presenter.frame.evaluation)
    assert "✓ it never crosses the axis" in words
    assert isinstance(stage.document, Document)
    label = stage.window.status._verdict
    assert label.toolTip() == words
