"""Unsaved work survives a crash, and only a crash."""

import shutil

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest

from app.files.silhouette import silhouette
from app.state import user_folders
from app.window.main_window import MainWindow
from sgb_core.document import edits
from sgb_core.document.file import recovery
from sgb_core.document.file.journal import Journal
from tests.app.waiting import let_turn
from tests.app.window_stage import WindowStage


@pytest.fixture
def stage(qtbot):
    shutil.rmtree(user_folders.recovery(), ignore_errors=True)
    made = WindowStage(qtbot, wait_for_scene=False)
    yield made
    for window in [each for each in MainWindow.windows if each is not made.window]:
        window.presenter.session.mark_saved()
        window.close()
    made.close()
    shutil.rmtree(user_folders.recovery(), ignore_errors=True)


def fuller(document, value=6.0):
    return edits.set_shape_parameter(document, 0, "lambda2", value)


def journal():
    return Journal(user_folders.recovery(), user_folders.locks())


def crash_with(document, target=None):
    """Leave behind what a program that crashed would have."""
    left = journal()
    left.write(document, target)
    left.close()
    return left.entry


def found():
    return recovery.recoverable(user_folders.recovery(), user_folders.locks())


def test_every_gesture_is_on_the_disk_when_it_ends(stage, tmp_path):
    safe = stage.window.safekeeping
    assert not safe.journal.entry.exists()
    for count in range(1, 6):
        stage.presenter.begin("drag")
        stage.presenter.apply(lambda document, n=count: fuller(document, 1.0 + n / 10))
        stage.presenter.commit()
        # Another has begun before this one is written.
        stage.presenter.begin("another")
        assert safe.writer.flush()
        item = recovery._read(safe.journal.entry)
        assert item.document == stage.session.gesture_start
        assert item.steps == count
        stage.presenter.cancel()
    stage.window.files._write(tmp_path / "pot.sgb")
    assert not safe.journal.entry.exists()


def test_undoing_all_or_closing_leaves_nothing(qtbot, stage):
    stage.presenter.do("λ2", fuller)
    stage.presenter.undo()
    assert not stage.window.safekeeping.journal.entry.exists()
    other = WindowStage(qtbot, wait_for_scene=False)
    other.presenter.do("λ2", fuller)
    other.window.safekeeping.flush()
    entry = other.window.safekeeping.journal.entry
    assert entry.is_file()
    other.close()
    assert not entry.exists()


def test_a_window_that_is_ended_keeps_its_work(qtbot, stage):
    other = WindowStage(qtbot, wait_for_scene=False)
    other.presenter.begin("λ2")
    other.presenter.apply(fuller)
    work = other.document
    other.window.end()
    assert other.window not in MainWindow.windows
    let_turn()
    (item,) = found()
    assert item.document == work


def test_what_a_crash_left_is_offered_and_restored(stage, tmp_path):
    work, target = fuller(stage.document), tmp_path / "jar.sgb"
    left = crash_with(work, target)
    assert stage.window.safekeeping.offer()
    dialog = stage.window.safekeeping.dialog
    assert "jar" in dialog.list.item(0).text()
    assert "1 gesture" in dialog.list.item(0).text()
    QTest.keyClick(dialog, Qt.Key.Key_Return)
    assert not dialog.isVisible()
    assert stage.document == work
    assert stage.session.is_modified
    assert stage.window.files.path == target
    assert not left.exists()
    # Another crash would leave it to be found again.
    assert stage.window.safekeeping.journal.entry.is_file()
    assert not stage.window.safekeeping.offer()


def test_several_are_restored_at_once_and_what_is_declined_is_kept(stage):
    for value in (2.0, 3.0, 4.0):
        crash_with(fuller(stage.document, value))
    assert stage.window.safekeeping.offer()
    dialog = stage.window.safekeeping.dialog
    assert dialog.list.count() == 3
    QTest.keyClick(dialog, Qt.Key.Key_Escape)
    assert stage.window.safekeeping.offer()
    dialog = stage.window.safekeeping.dialog
    dialog.list.item(2).setCheckState(Qt.CheckState.Unchecked)
    dialog.restore_button.click()
    restored = [window.presenter.document for window in MainWindow.windows[-2:]]
    values = {document.profile[0].shape.lambda2 for document in restored}
    assert values == {4.0, 3.0}
    assert [item.document.profile[0].shape.lambda2 for item in found()] == [2.0]


def test_only_what_is_thrown_away_is_gone(stage):
    crash_with(fuller(stage.document, 2.0))
    crash_with(fuller(stage.document, 3.0))
    stage.window.safekeeping.offer()
    dialog = stage.window.safekeeping.dialog
    dialog.list.item(0).setCheckState(Qt.CheckState.Unchecked)
    dialog.throw_button.click()
    assert [item.document.profile[0].shape.lambda2 for item in found()] == [3.0]


def test_windows_do_not_eat_each_others_work(stage, qtbot):
    other = WindowStage(qtbot, wait_for_scene=False)
    for each in (stage, other):
        each.presenter.do("λ2", fuller)
        each.window.safekeeping.flush()
    assert len(list(user_folders.recovery().glob("*.recovery"))) == 2
    # What still runs is not offered.
    assert not stage.window.safekeeping.offer()
    stage.presenter.undo()
    assert other.window.safekeeping.journal.entry.is_file()
    other.close()


def test_only_one_of_two_gets_the_work(stage):
    crash_with(fuller(stage.document))
    (item,) = found()
    other = journal()
    assert other.adopt(item)
    assert not stage.window.safekeeping.take(item)
    assert "elsewhere" in stage.window.notice_bar.notice.text
    assert not stage.session.is_modified
    other.clear()


def test_a_blocked_folder_is_said_once_and_written_again_when_it_is_free(stage):
    user_folders.recovery().parent.mkdir(parents=True, exist_ok=True)
    user_folders.recovery().write_bytes(b"in the way")
    stage.presenter.do("λ2", fuller)
    stage.until(lambda: stage.window.notice_bar.notice is not None)
    assert "cannot be kept safe" in stage.window.notice_bar.notice.text
    user_folders.recovery().unlink()
    stage.presenter.do("ω", lambda document: edits.rename(document, "later"))
    stage.window.safekeeping.flush()
    assert recovery._read(stage.window.safekeeping.journal.entry).document == stage.document


def test_the_picture_shows_the_shape(stage):
    image = silhouette(stage.document).toImage()
    middle, corner = image.rect().center(), image.rect().topLeft()
    assert image.pixelColor(middle).alpha() == 255
    assert image.pixelColor(corner).alpha() == 0
