"""States and history, by real clicks and keys in a real window."""

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QLineEdit

from sgb_core.document import edits
from sgb_core.document.file import project_file
from tests.app.waiting import let_turn
from tests.app.window_stage import WindowStage


@pytest.fixture
def stage(qtbot):
    made = WindowStage(qtbot, wait_for_scene=False)
    made.window.panels.docks["states"].raise_()
    made.settle()
    yield made
    made.close()


def fuller(document):
    return edits.set_shape_parameter(document, 1, "lambda2", 6.0)


def names(stage):
    return [state.name for state in stage.document.states]


def rows(panel):
    return [panel.list.item(row).text() for row in range(panel.list.count())]


def click(button):
    QTest.mouseClick(button, Qt.MouseButton.LeftButton)
    let_turn()


def two_states(stage):
    panel, original = stage.window.panels["states"], stage.document.profile
    click(panel.store_button)
    stage.presenter.do("λ2", fuller)
    click(panel.store_button)
    return panel, original


def test_store_switch_and_undo(stage):
    panel, original = two_states(stage)
    assert names(stage) == rows(panel) == ["A", "B"]
    assert panel.chosen == "B"
    assert panel.list.item(1).font().bold()
    changed = stage.document
    panel.list.setFocus()
    QTest.keyClick(panel.list, Qt.Key.Key_Up)
    QTest.keyClick(panel.list, Qt.Key.Key_Return)
    assert stage.document.profile == original
    stage.settle()
    assert panel.list.item(0).font().bold()
    assert not panel.list.item(1).font().bold()
    assert stage.session.undo_label == "Show state A"
    stage.presenter.undo()
    assert stage.document is changed


def test_rename_duplicate_update_delete(stage):
    panel, _ = two_states(stage)
    panel.choose("A")
    panel.list.setFocus()
    QTest.keyClick(panel.list, Qt.Key.Key_F2)
    editor = panel.list.findChild(QLineEdit)
    editor.selectAll()
    QTest.keyClicks(editor, "slim")
    QTest.keyClick(editor, Qt.Key.Key_Return)
    stage.settle()
    assert names(stage) == rows(panel) == ["slim", "B"]
    # A name that is taken is refused, with a word.
    panel.choose("B")
    panel.list.currentItem().setText("slim")
    stage.settle()
    assert names(stage) == rows(panel) == ["slim", "B"]
    assert "slim" in stage.window.notice_bar.notice.text
    panel.choose("slim")
    click(panel.copy_button)
    assert names(stage) == ["slim", "A", "B"]
    assert panel.chosen == "A"
    click(panel.update_button)
    assert stage.document.states[1].profile == stage.document.profile
    QTest.keyClick(panel.list, Qt.Key.Key_Delete)
    stage.settle()
    assert names(stage) == rows(panel) == ["slim", "B"]
    for _ in range(5):
        stage.presenter.undo()
    stage.settle()
    assert names(stage) == rows(panel) == ["A", "B"][: len(names(stage))]


def test_states_live_in_the_file(stage, tmp_path):
    two_states(stage)
    path = tmp_path / "jar.sgb"
    assert stage.window.files._write(path)
    assert [state.name for state in project_file.load(path).states] == ["A", "B"]


def test_the_ghost_follows_the_choice_and_goes_with_its_state(stage):
    panel, _ = two_states(stage)
    panel.ghost.click()
    assert stage.presenter.view.ghost_state == "B"
    panel.choose("A")
    assert stage.presenter.view.ghost_state == "A"
    click(panel.delete_button)
    stage.settle()
    assert stage.presenter.view.ghost_state is None
    assert not panel.ghost.isChecked()


def test_keys_walk_through_the_states(stage):
    _, original = two_states(stage)
    stage.settle()
    keys = Qt.KeyboardModifier.ControlModifier | Qt.KeyboardModifier.AltModifier
    QTest.keyClick(stage.window, Qt.Key.Key_PageDown, keys)
    assert stage.document.profile == original
    QTest.keyClick(stage.window, Qt.Key.Key_PageUp, keys)
    assert stage.document.profile != original


def test_the_history_is_walked_by_click_and_key(stage):
    stage.window.panels.docks["history"].raise_()
    panel, start = stage.window.panels["history"], stage.document
    stage.presenter.do("Fuller", fuller)
    stage.presenter.do("Mirror", edits.mirror_height)
    end = stage.document
    stage.settle()
    assert rows(panel) == ["As opened", "Fuller 3 → 6", "Mirror"]
    assert panel.list.currentRow() == 2
    at = panel.list.visualItemRect(panel.list.item(0)).center()
    QTest.mouseClick(panel.list.viewport(), Qt.MouseButton.LeftButton, pos=at)
    assert stage.document is start
    stage.settle()
    assert panel.list.item(2).font().italic()
    assert "forward" in panel.list.item(2).toolTip()
    QTest.keyClick(panel.list, Qt.Key.Key_Down)
    assert stage.document.profile == fuller(start).profile
    QTest.keyClick(panel.list, Qt.Key.Key_End)
    assert stage.document is end
    stage.presenter.undo()
    stage.presenter.do("Reverse", edits.reverse_profile)
    stage.settle()
    assert rows(panel) == ["As opened", "Fuller 3 → 6", "Reverse"]


def test_an_empty_panel_says_how_to_begin(stage):
    panel = stage.window.panels["states"]
    assert panel.empty.isVisible()
    assert not panel.list.isVisible()
    assert panel.store_button.text() in panel.empty.label.text()
    two_states(stage)
    assert not panel.empty.isVisible()
    assert panel.list.isVisible()


def test_a_state_is_seen_beside_its_name(stage):
    panel, _ = two_states(stage)
    first, second = (panel.list.item(row).icon().pixmap(34, 34).toImage() for row in range(2))
    assert first != second
    # Updated, it looks like the one that it now equals.
    panel.choose("A")
    panel.update_chosen()
    stage.settle()
    assert panel.list.item(0).icon().pixmap(34, 34).toImage() == second
