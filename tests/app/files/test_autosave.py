"""Unsaved work survives a crash, and only a crash."""

import subprocess
import sys

import pytest

from app.state import preferences, user_folders
from sgb_core.document import edits
from sgb_core.document.file import recovery
from sgb_core.document.file.recovery import Journal
from tests.app.window_stage import WindowStage


@pytest.fixture
def stage(qtbot):
    for entry in user_folders.recovery().glob("*"):
        entry.unlink()
    made = WindowStage(qtbot, wait_for_scene=False)
    yield made
    made.close()


def fuller(document):
    return edits.set_shape_parameter(document, 0, "lambda2", 6.0)


def ended_process():
    """Return the number of a process that runs no more."""
    child = subprocess.Popen([sys.executable, "-c", ""])
    child.wait()
    return child.pid


def crash_with(document, target=None):
    """Leave behind what a program that crashed would have."""
    journal = Journal(user_folders.recovery())
    journal.write(document, target)
    left = journal.entry.with_name(f"{ended_process()}-{journal.entry.name.partition('-')[2]}")
    return journal.entry.rename(left)


def test_work_is_set_aside_while_it_is_unsaved_and_the_hand_rests(stage, tmp_path):
    autosave = stage.window.autosave
    assert not autosave.write()
    stage.presenter.do("λ2", fuller)
    stage.presenter.begin("drag")
    assert not autosave.write()
    stage.presenter.cancel()
    assert autosave.write()
    assert autosave.journal.entry.is_file()
    assert not autosave.write()
    stage.window.files._write(tmp_path / "pot.sgb")
    assert not autosave.journal.entry.exists()


def test_the_timer_does_it(stage, qtbot):
    preferences.change(autosave_seconds=1)
    stage.presenter.do("λ2", fuller)
    qtbot.waitUntil(stage.window.autosave.journal.entry.is_file)
    preferences.change(autosave_seconds=0)
    assert not stage.window.autosave.journal.entry.exists()
    preferences.change(autosave_seconds=5)


def test_undoing_all_or_closing_leaves_nothing(qtbot, stage):
    stage.presenter.do("λ2", fuller)
    stage.window.autosave.write()
    stage.presenter.undo()
    assert not stage.window.autosave.journal.entry.exists()
    other = WindowStage(qtbot, wait_for_scene=False)
    other.presenter.do("λ2", fuller)
    other.window.autosave.write()
    entry = other.window.autosave.journal.entry
    assert entry.is_file()
    other.close()
    assert not entry.exists()


def test_what_a_crash_left_is_offered_and_restored(stage, tmp_path):
    work, target = fuller(stage.document), tmp_path / "jar.sgb"
    left = crash_with(work, target)
    assert stage.window.autosave.offer()
    bar = stage.window.notice_bar
    assert "jar" in bar.notice.text
    assert bar.notice.action == "Restore"
    bar._button.click()
    assert stage.document == work
    assert stage.session.is_modified
    assert stage.window.isWindowModified() or stage.window.files.path == target
    assert stage.window.files.path == target
    assert not left.exists()
    # Another crash would leave it to be found again.
    assert stage.window.autosave.journal.entry.is_file()
    assert not stage.window.autosave.offer()


def test_windows_do_not_eat_each_others_work(stage, qtbot):
    other = WindowStage(qtbot, wait_for_scene=False)
    for each in (stage, other):
        each.presenter.do("λ2", fuller)
        each.window.autosave.write()
    journals = {each.window.autosave.journal.entry for each in (stage, other)}
    assert len(journals) == 2
    # What still runs is not offered.
    assert not stage.window.autosave.offer()
    stage.presenter.undo()
    assert other.window.autosave.journal.entry.is_file()
    other.close()


def test_only_one_of_two_gets_the_work(stage):
    crash_with(fuller(stage.document))
    item = recovery.recoverable(user_folders.recovery())[0]
    assert Journal(user_folders.recovery()).adopt(item)
    assert not stage.window.autosave.restore(item)
    assert "elsewhere" in stage.window.notice_bar.notice.text
    assert not stage.session.is_modified
