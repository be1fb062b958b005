"""An exception planted anywhere: the others are refreshed, it is told, the work goes on."""

import shutil
import subprocess
import sys
import threading
from functools import partial
from pathlib import Path

import pytest
from PySide6.QtCore import QCoreApplication
from PySide6.QtGui import QDesktopServices
from PySide6.QtWidgets import QFileDialog

from app.state import user_folders
from app.state.log import Log
from app.window.trouble import Trouble, TroubleDialog
from sgb_core.document import edits
from sgb_core.document.file import project_file, recovery
from tests.app.window_stage import WindowStage

pytestmark = pytest.mark.usefixtures("faults_are_for_the_tests")

ROOT = Path(__file__).resolve().parents[3]
CRASH = """
import os
import sys
from PySide6.QtCore import QCoreApplication
from app.state.log import Log
QCoreApplication.setApplicationName(sys.argv[1])
QCoreApplication.setOrganizationName(sys.argv[2])
log = Log()
os.kill(os.getpid(), int(sys.argv[3]))
"""


class Planted(Exception):  # noqa: N818 - not one of the program's
    """What nobody foresaw."""


def _note(refreshed, view, _frame):
    refreshed.append(view)


def fail(*_args, **_options):
    raise Planted("planted")


@pytest.fixture(scope="module")
def _stage_of_all(qapp):
    from tests.app.waiting import PatientBot

    class Request:
        node = None

    bot = PatientBot.__new__(PatientBot)
    bot._request = Request()
    made = WindowStage(bot, wait_for_scene=False)
    yield made
    made.close()


@pytest.fixture
def stage(qtbot, _stage_of_all):
    _stage_of_all.qtbot = qtbot
    return _stage_of_all


@pytest.fixture
def trouble(stage):
    log = Log()
    made = Trouble(stage.window, log, lambda: [stage.window])
    yield made
    made.close()
    log.close()
    stage.window.notice_bar.dismiss()


def told(stage, comfort="Your work is safe"):
    stage.until(lambda: stage.window.notice_bar.notice is not None)
    notice = stage.window.notice_bar.notice
    assert comfort in notice.text
    return notice


def test_a_failure_in_any_view_keeps_no_other_from_showing(stage, trouble, monkeypatch):
    views = list(stage.presenter._views)
    assert len(views) > 10
    for number, planted in enumerate(views):
        refreshed = []
        for view in views:
            monkeypatch.setattr(view, "refresh", partial(_note, refreshed, view))
        monkeypatch.setattr(planted, "refresh", fail)
        stage.presenter.do("name", lambda document, n=number: edits.rename(document, f"n{n}"))
        stage.presenter.refresh_now()
        assert refreshed[: len(views) - 1] == [view for view in views if view is not planted]
        monkeypatch.undo()
    told(stage)
    stage.window.safekeeping.flush()
    work = recovery._read(stage.window.safekeeping.journal.entry).document
    assert work == stage.document


def test_it_is_told_in_plain_words_once_and_logged(stage, trouble, monkeypatch):
    panel = stage.window.panels["shape"]
    # Panels behind other tabs do no work, and so cannot fail.
    stage.window.panels.docks["shape"].show()
    stage.window.panels.docks["shape"].raise_()
    stage.until(lambda: not panel.visibleRegion().isEmpty())
    monkeypatch.setattr(panel, "_show_selection", fail)
    before = trouble._log.path.read_text(encoding="utf-8").count("Traceback")
    for number in range(3):
        stage.presenter.do("name", lambda document, n=number: edits.rename(document, f"n{n}"))
        stage.presenter.refresh_now()
        if number == 0:
            assert "the Shape panel" in told(stage).text
            stage.window.notice_bar.dismiss()
    stage.settle()
    assert stage.window.notice_bar.notice is None
    assert trouble._log.path.read_text(encoding="utf-8").count("Traceback") == before + 1


def test_a_failure_on_a_worker_thread_is_told_on_the_gui_thread(stage, trouble):
    worker = threading.Thread(target=fail)
    worker.start()
    worker.join()
    assert "Planted" in told(stage).text


def test_after_a_failure_in_the_journal_the_next_step_is_written(stage, trouble, monkeypatch):
    monkeypatch.setattr(stage.window.safekeeping.journal, "write", fail)
    stage.presenter.do("name", lambda document: edits.rename(document, "lost"))
    stage.window.safekeeping.flush()
    # Nothing is called safe that is not on the disk.
    told(stage, "save your work")
    monkeypatch.undo()
    stage.presenter.do("name", lambda document: edits.rename(document, "kept"))
    stage.window.safekeeping.flush()
    work = recovery._read(stage.window.safekeeping.journal.entry).document
    assert work.name == "kept"


def test_a_copy_can_be_saved_and_the_log_opened(stage, trouble, tmp_path, monkeypatch):
    worker = threading.Thread(target=fail)
    worker.start()
    worker.join()
    told(stage)
    stage.window.notice_bar._button.click()
    dialog = stage.window.findChild(TroubleDialog)
    assert dialog.isVisible()
    copy, opened = tmp_path / "copy.sgb", []
    monkeypatch.setattr(QFileDialog, "getSaveFileName", lambda *_: (str(copy), ""))
    monkeypatch.setattr(QDesktopServices, "openUrl", opened.append)
    dialog.copy_button.click()
    assert project_file.load(copy) == stage.document
    assert stage.window.files.path is None
    dialog.log_button.click()
    assert opened[0].toLocalFile() == str(trouble._log.path)
    dialog.go_on_button.click()
    assert not dialog.isVisible()


def test_the_log_is_private_and_follows_no_link(tmp_path):
    shutil.rmtree(user_folders.log(), ignore_errors=True)
    victim = tmp_path / "victim"
    victim.write_bytes(b"untouched")
    log = Log()
    log.write("a line")
    assert log.path.stat().st_mode & 0o777 == 0o600
    assert log.path.parent.stat().st_mode & 0o777 == 0o700
    log.close()
    log.path.unlink()
    log.path.symlink_to(victim)
    other = Log()
    other.write("a line")
    other.close()
    assert victim.read_bytes() == b"untouched"
    log.path.unlink()


def test_the_log_never_grows_large(monkeypatch):
    shutil.rmtree(user_folders.log(), ignore_errors=True)
    monkeypatch.setattr("app.state.log.LARGEST", 2000)
    log = Log()
    for number in range(200):
        log.write(f"line {number} " + "x" * 100)
    log.close()
    sizes = [each.stat().st_size for each in log.path.parent.iterdir()]
    assert len(sizes) == 3
    assert max(sizes) <= 2000
    assert "line 199" in log.path.read_text(encoding="utf-8")


def test_a_program_that_did_not_end_is_noticed_at_the_next_start_once():
    shutil.rmtree(user_folders.log(), ignore_errors=True)
    for number in (9, 11):
        names = (QCoreApplication.applicationName(), QCoreApplication.organizationName())
        subprocess.run(
            [sys.executable, "-c", CRASH, *names, str(number)], capture_output=True, cwd=ROOT
        )
    log = Log()
    # The second of the two has noticed the first.
    assert log.crashes == 1
    text = log.path.read_text(encoding="utf-8")
    assert text.count("did not end as it should") == 2
    assert "Fatal Python error: Segmentation fault" in text
    # This one runs still.
    other = Log()
    assert other.crashes == 0
    other.close()
    log.close()
