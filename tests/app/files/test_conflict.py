"""What others did to a file is seen before it is overwritten: two writers, and a third outside."""

import os
import shutil
import subprocess
import sys

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QFileDialog

from app.files import conflict, files
from app.files.conflict import Answer, ConflictDialog
from app.files.custody import Custody
from app.state import user_folders
from sgb_core.document import edits
from sgb_core.document.file import project_file, versions
from tests.app.window_stage import WindowStage

HOLDER = """
import sys
from pathlib import Path
from sgb_core.document.file import private, versions
held = private.lock(Path(sys.argv[1]), versions.lock_name(sys.argv[2]))
print("held" if held else "taken", flush=True)
sys.stdin.read()
"""


@pytest.fixture
def stage(qtbot):
    made = WindowStage(qtbot, wait_for_scene=False)
    yield made
    made.close()
    shutil.rmtree(user_folders.backups(), ignore_errors=True)


@pytest.fixture
def asked(monkeypatch):
    """Answer the question with what the test put in; keep what was asked."""

    class Asked(list):
        answer = Answer.CANCEL

    found = Asked()

    def answer(question, _parent):
        found.append(question)
        return found.answer

    monkeypatch.setattr(files, "ask", answer)
    return found


@pytest.fixture
def project(stage, tmp_path):
    path = tmp_path / "pot.sgb"
    project_file.save(edits.rename(stage.document, "first"), path)
    return path


def name(window, text):
    window.presenter.do("Name", lambda document: edits.rename(document, text))


def change_outside(path, text):
    project_file.save(edits.rename(project_file.load(path), text), path)


def test_a_file_that_only_this_window_wrote_is_saved_without_a_question(stage, project, asked):
    stage.window.files.open_path(project)
    for text in ("second", "third"):
        name(stage.window, text)
        assert stage.window.files.save()
    os.utime(project, (1, 1))
    name(stage.window, "fourth")
    assert stage.window.files.save()
    assert asked == []
    # The version before the last save is kept.
    backup = versions.backup_place(project, user_folders.backups())
    assert project_file.load(backup).name == "third"
    assert backup.stat().st_mode & 0o777 == 0o600


@pytest.mark.parametrize("answer", [Answer.CANCEL, Answer.COMPARE, Answer.OVERWRITE])
def test_a_change_from_outside_is_never_overwritten_silently(stage, project, asked, answer):
    stage.window.files.open_path(project)
    name(stage.window, "ours")
    change_outside(project, "theirs")
    asked.answer = answer
    saved = stage.window.files.save()
    assert saved is (answer is Answer.OVERWRITE)
    assert project_file.load(project).name == ("ours" if saved else "theirs")
    (question,) = asked
    assert "changed on the disk" in question.words
    assert question.theirs().name == "theirs" or saved
    ghost = stage.presenter.frame.compared
    assert (ghost is not None) is (answer is Answer.COMPARE)
    if saved:
        # What was overwritten on purpose is kept too, and the next save asks nothing.
        kept = versions.backup_place(project, user_folders.backups())
        assert project_file.load(kept).name == "theirs"
        name(stage.window, "ours again")
        assert stage.window.files.save()
    if ghost is not None:
        assert ghost.document.name == "theirs"
        stage.window.notice_bar._button.click()
        assert stage.presenter.frame.compared is None


def test_saving_elsewhere_keeps_both(stage, project, asked, tmp_path, monkeypatch):
    stage.window.files.open_path(project)
    name(stage.window, "ours")
    change_outside(project, "theirs")
    asked.answer = Answer.SAVE_AS
    other = str(tmp_path / "other.sgb")
    monkeypatch.setattr(QFileDialog, "getSaveFileName", lambda *_: (other, ""))
    assert stage.window.files.save()
    assert project_file.load(project).name == "theirs"
    assert project_file.load(other).name == "ours"


def test_two_windows_on_one_file_both_ask(qtbot, stage, project, asked):
    other = WindowStage(qtbot, wait_for_scene=False)
    stage.window.files.open_path(project)
    other.window.files.open_path(project)
    assert "another window" in other.window.notice_bar.notice.text
    name(other.window, "second window")
    assert not other.window.files.save()
    assert "open in another window" in asked[-1].words
    asked.answer = Answer.OVERWRITE
    assert other.window.files.save()
    name(stage.window, "first window")
    asked.answer = Answer.CANCEL
    assert not stage.window.files.save()
    assert "changed on the disk" in asked[-1].words
    assert project_file.load(project).name == "second window"
    other.close()


def test_another_process_holds_a_file_until_it_ends_however_it_ends(project):
    holder = subprocess.Popen(
        [sys.executable, "-c", HOLDER, str(user_folders.locks()), str(project)],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
    )
    assert holder.stdout.readline() == b"held\n"
    mine = Custody()
    assert not mine.take(project, None)
    link = project.with_name("link.sgb")
    link.symlink_to(project)
    assert not mine.holds(link)
    holder.kill()
    holder.communicate()
    assert mine.holds(project)
    mine.release()


def test_restored_work_does_not_overwrite_what_is_younger(stage, project, asked):
    work = edits.rename(stage.document, "restored")
    seconds = project.stat().st_mtime
    stage.window.files.show_unsaved(work, project, seconds - 60.0)
    assert not stage.window.files.save()
    assert len(asked) == 1
    stage.window.files.show_unsaved(work, project, seconds + 60.0)
    assert stage.window.files.save()
    assert len(asked) == 1


def test_the_question_shows_both_versions_and_escape_saves_nothing(stage, project, qtbot):
    base = versions.version_of(project)
    change_outside(project, "theirs")
    question = conflict.Conflict(
        project, stage.document, base, versions.version_of(project), elsewhere=True
    )
    dialog = ConflictDialog(question, stage.window)
    dialog.show()
    assert dialog.buttons[Answer.COMPARE].isEnabled()
    dialog.buttons[Answer.OVERWRITE].click()
    assert dialog.answer is Answer.OVERWRITE
    dialog = ConflictDialog(question, stage.window)
    dialog.show()
    QTest.keyClick(dialog, Qt.Key.Key_Escape)
    assert dialog.answer is Answer.CANCEL
