"""The guided tour moves the real document and leaves no trace."""

import pytest
from PySide6.QtCore import QPointF, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QLabel

from app.start.tour import STEPS, WELL_DONE
from app.state.view_state import Hover
from app.widgets.mark_slider import MarkSlider
from sgb_core.curves.parameter_fan import most_telling
from sgb_core.document.file import project_file
from tests.app.mouse import drag, press, release
from tests.app.window_stage import WindowStage


@pytest.fixture
def stage(qtbot):
    made = WindowStage(qtbot, wait_for_scene=False)
    yield made
    made.close()


@pytest.fixture
def tour(stage):
    stage.window.commands["tour"].trigger()
    return stage.window.welcome.tour


def untouched(stage, original):
    return (
        stage.document is original
        and not stage.session.is_modified
        and not stage.session.in_gesture
        and len(stage.session.history) == 1
    )


def test_each_parameter_moves_and_nothing_remains(stage):
    original = stage.document
    stage.window.commands["tour"].trigger()
    tour = stage.window.welcome.tour
    assert tour.isVisible()
    moved = []
    for step in STEPS[1:]:
        QTest.keyClick(stage.window.focusWidget(), Qt.Key.Key_Right)
        assert tour.step is step
        assert step.words in [label.text() for label in tour.findChildren(QLabel)]
        if step.parameter is None:
            continue
        seen = set()

        def changed(step=step, seen=seen):
            segment = stage.presenter.view.segment
            shape = stage.document.profile.segments[segment].shape
            seen.add(getattr(shape, step.parameter))
            return len(seen) >= 4

        stage.until(changed)
        assert stage.presenter.view.hover.parameter == step.parameter
        # What moves is seen: the curve itself differs.
        segment = stage.presenter.view.segment
        assert stage.document.profile.segments[segment] != original.profile.segments[segment]
        moved.append(step.parameter)
    assert moved == ["lambda1", "lambda2", "lambda3", "omega"]
    tour.next_button.click()
    assert tour.isHidden()
    assert untouched(stage, original)


def test_the_tour_ends_with_the_users_own_hand_on_the_slider(stage, tour):
    original = stage.document
    segment = stage.presenter.view.segment
    assert segment == most_telling(original.profile)
    for _ in STEPS[1:]:
        tour.next_button.click()
    slider = stage.window.focusWidget()
    assert isinstance(slider, MarkSlider)
    assert slider.accessibleName() == f"λ2 of segment {segment + 1}"
    stage.until(lambda: stage.presenter.view.hover == Hover("lambda2", segment))
    drag(slider, slider.handle_centre(), slider.handle_centre(0.5))
    stage.until(lambda: WELL_DONE in [label.text() for label in tour.findChildren(QLabel)])
    assert stage.document.profile[segment] != original.profile[segment]
    assert len(stage.session.history) == 2
    tour.next_button.click()
    assert tour.isHidden()


def test_back_and_escape(stage, tour):
    original = stage.document
    tour.next_button.click()
    tour.next_button.click()
    QTest.keyClick(tour, Qt.Key.Key_Left)
    assert tour.step is STEPS[1]
    tour.back_button.click()
    assert tour.step is STEPS[0]
    assert not tour.back_button.isEnabled()
    tour.next_button.click()
    stage.until(lambda: stage.document is not original)
    QTest.keyClick(tour.next_button, Qt.Key.Key_Escape)
    assert tour.isHidden()
    assert untouched(stage, original)


def test_a_hand_on_a_slider_finds_the_document_as_it_was(stage, tour):
    original = stage.document
    slider = stage.slider(1, "omega")
    tour.next_button.click()
    tour.next_button.click()
    stage.until(lambda: stage.document is not original)
    press(slider, slider.handle_centre())
    assert stage.session.gesture_start is original
    release(slider, slider.handle_centre())
    drag(slider, slider.handle_centre(), slider.handle_centre() + QPointF(-25, 0))
    assert stage.session.undo_label == "ω of segment 2"
    assert len(stage.session.history) == 2
    changed = stage.document
    assert tour.isVisible()
    tour.stop()
    assert stage.document is changed


@pytest.mark.parametrize("key", [Qt.Key.Key_B, Qt.Key.Key_S])
def test_a_shortcut_finds_the_document_as_it_was(stage, tour, key, tmp_path):
    stage.window.files.path = tmp_path / "jar.sgb"
    original = stage.document
    tour.next_button.click()
    stage.until(lambda: stage.document is not original)
    QTest.keyClick(tour.next_button, key, Qt.KeyboardModifier.ControlModifier)
    assert not stage.session.in_gesture
    assert stage.document.profile is original.profile
    if key == Qt.Key.Key_S:
        assert project_file.load(tmp_path / "jar.sgb") == original
    tour.stop()


def test_closing_in_the_middle(qtbot):
    stage = WindowStage(qtbot, wait_for_scene=False)
    stage.window.commands["tour"].trigger()
    original = stage.document
    stage.window.welcome.tour.next_button.click()
    stage.until(lambda: stage.document is not original)
    # No question about unsaved work: there is none.
    assert stage.window.close()


def test_no_word_of_a_station_is_cut_off(stage, tour):
    for step in STEPS:
        stage.settle()
        assert tour.step is step
        (words,) = (label for label in tour.findChildren(QLabel) if label.text() == step.words)
        assert words.height() >= words.heightForWidth(words.width())
        QTest.keyClick(stage.window.focusWidget(), Qt.Key.Key_Right)
