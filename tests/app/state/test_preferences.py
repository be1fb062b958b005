"""Preferences and keys: applied at once, remembered, shown where they clash."""

from typing import get_type_hints

import pytest
from PySide6.QtCore import QSettings, Qt
from PySide6.QtGui import QKeySequence
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

from app.settings import text_size
from app.state import preferences
from app.state.preferences import Preferences
from app.theme import theme
from sgb_core.document.model import Unit
from tests.app.waiting import activate, let_turn
from tests.app.window_stage import WindowStage


@pytest.fixture(autouse=True)
def _light_again(qapp):
    yield
    theme.apply(qapp, "light")


@pytest.fixture
def stage(qtbot):
    made = WindowStage(qtbot, wait_for_scene=False)
    yield made
    made.window.keys.reset()
    made.close()


@pytest.fixture
def dialog(stage):
    QTest.keyClick(stage.window, Qt.Key.Key_Comma, Qt.KeyboardModifier.ControlModifier)
    return stage.window._preferences


def test_what_is_changed_is_remembered():
    preferences.change(new_unit=Unit.IN, navigation_style="rhino", animate_views=False)
    preferences.change(snap_step=0.25)
    wanted = preferences.current()
    assert preferences.reload() == wanted
    assert wanted == Preferences(
        navigation_style="rhino",
        animate_views=False,
        snap_step=0.25,
        new_unit=Unit.IN,
    )


@pytest.mark.parametrize("junk", ["", "-5", "nan", "1e400", "purple"])
def test_junk_in_the_store_is_passed_over(junk):
    for name in Preferences.__slots__:
        QSettings().setValue(name, junk)
    read = preferences.reload()
    assert read.navigation_style == "studio"
    assert read.new_unit is Unit.MM
    assert 80 <= read.text_percent <= 200
    assert 0.0 <= read.snap_step < 1e9


def test_the_dialog_applies_at_once_and_blocks_nothing(stage, dialog):
    assert dialog.isVisible()
    assert not dialog.isModal()
    dialog.theme.setFocus()
    QTest.keyClick(dialog.theme, Qt.Key.Key_End)
    QTest.keyClick(dialog.theme, Qt.Key.Key_Return)
    assert theme.choice() == "dark"
    assert QSettings().value("theme") == "dark"
    QTest.keyClick(dialog.unit, Qt.Key.Key_End)
    assert preferences.current().new_unit is Unit.IN
    dialog.invert.setFocus()
    QTest.keyClick(dialog.invert, Qt.Key.Key_Space)
    assert preferences.current().invert_wheel
    dialog.navigation.setCurrentIndex(1)
    dialog.navigation.activated.emit(1)
    assert preferences.current().navigation_style == "blender"
    stage.window.files.new_blank()
    assert stage.document.unit is Unit.IN
    QTest.keyClick(dialog, Qt.Key.Key_Escape)
    assert dialog.isHidden()


def test_text_grows_in_everything_and_shrinks_back(stage, dialog):
    app = QApplication.instance()
    text_size.apply(app, 100)
    before, height = app.font().pointSizeF(), stage.window.menuBar().fontMetrics().height()
    dialog.text.enter(150)
    let_turn()
    assert app.font().pointSizeF() == pytest.approx(1.5 * before)
    assert stage.window.menuBar().fontMetrics().height() > height
    assert dialog.fontMetrics().height() > height
    dialog.text.enter(100)
    assert app.font().pointSizeF() == pytest.approx(before)


def test_a_key_of_ones_own_works_and_comes_back(stage, dialog):
    stage.window.welcome.gallery.leave()
    editor = dialog.keys
    editor.search.setText("append")
    editor.choose("append_segment")
    editor.edit.setFocus()
    editor.edit.setKeySequence(QKeySequence("Ctrl+J"))
    editor.edit.editingFinished.emit()
    assert "Ctrl+J" in stage.window.commands["append_segment"].toolTip()
    count = len(stage.document.profile)
    dialog.close()
    activate(stage.qtbot, stage.window)
    QTest.keyClick(stage.window, Qt.Key.Key_J, Qt.KeyboardModifier.ControlModifier)
    assert len(stage.document.profile) == count + 1
    # The next window knows it too, and so does one that is open.
    assert QSettings().value("keys/append_segment") == "Ctrl+J"
    editor.reset_button.click()
    assert stage.window.commands["append_segment"].shortcut() == QKeySequence("Ctrl+Return")
    assert not QSettings().contains("keys/append_segment")


def test_a_clash_is_shown_and_a_key_can_be_taken_away(stage, dialog):
    editor = dialog.keys
    editor.choose("fit")
    editor.edit.setKeySequence(QKeySequence("Ctrl+Z"))
    editor.edit.editingFinished.emit()
    assert "Undo" in editor.conflict.text()
    editor.clear_button.click()
    assert editor.conflict.text() == ""
    assert stage.window.commands["fit"].shortcut().isEmpty()
    editor.reset_all_button.click()
    assert stage.window.commands["fit"].shortcut() == QKeySequence("Ctrl+F")


def test_no_two_actions_come_with_the_same_key(stage):
    keys = stage.window.keys
    assert {n: keys.sharing(n) for n in stage.window.commands.actions if keys.sharing(n)} == {}


def test_every_action_is_in_a_menu_and_can_be_given_a_key(stage, dialog):
    listed = set()

    def walk(menu):
        for action in menu.actions():
            if action.menu():
                walk(action.menu())
            listed.add(action)

    walk(stage.window.menuBar())
    assert set(stage.window.commands.actions.values()) <= listed
    assert dialog.keys.list.topLevelItemCount() == len(stage.window.commands.actions)


def test_what_can_be_changed_are_the_preferences() -> None:
    fields = get_type_hints(Preferences)
    assert get_type_hints(preferences.Changes) == fields
