"""What other programs do to an open file is told at once, and large files are opened aside."""

import threading
from pathlib import Path

import pytest
from PySide6.QtCore import QEvent
from PySide6.QtWidgets import QApplication

from app.files.files import READ_AT_ONCE
from app.files.outside_changes import OutsideChanges
from app.state.jobs import Job
from sgb_core.curves.primitives import line
from sgb_core.curves.profile import Profile
from sgb_core.document import edits
from sgb_core.document.file import project_file
from sgb_core.document.model import Document
from sgb_core.fields.extra import Extra
from tests.app.window_stage import WindowStage


@pytest.fixture
def stage(qtbot):
    made = WindowStage(qtbot, wait_for_scene=False)
    yield made
    made.close()


@pytest.fixture
def project(stage, tmp_path):
    path = tmp_path / "pot.sgb"
    project_file.save(edits.rename(stage.document, "first"), path)
    assert stage.window.files.open_path(path)
    return path


@pytest.fixture
def said(stage):
    found = []
    stage.presenter.noticed.connect(found.append)
    return found


def change(path: Path, name: str, in_place: bool = False) -> None:
    document = edits.rename(project_file.load(path), name)
    if in_place:
        path.write_bytes(project_file.dumps(document))
    else:
        project_file.save(document, path)


def wait_for(stage, said, words):
    stage.until(lambda: any(words in notice.text for notice in said))
    return next(notice for notice in said if words in notice.text)


@pytest.mark.parametrize("in_place", [True, False])
def test_a_change_is_told_at_once_and_can_be_shown(stage, project, said, in_place):
    change(project, "second", in_place)
    wait_for(stage, said, "has changed pot.sgb").callback()
    assert stage.document.name == "second"
    said.clear()
    # The file is watched on after it was replaced.
    change(project, "third", in_place)
    wait_for(stage, said, "has changed pot.sgb")


def test_with_work_that_is_not_saved_the_change_is_laid_over_it(stage, project, said):
    stage.presenter.do("Name", lambda document: edits.rename(document, "ours"))
    change(project, "theirs")
    wait_for(stage, said, "saving will ask").callback()
    assert stage.document.name == "ours"
    assert stage.presenter.frame.compared.document.name == "theirs"


def test_a_file_taken_away_is_told_and_can_be_saved_again(stage, project, said):
    project.unlink()
    wait_for(stage, said, "no longer where it was").callback()
    assert project_file.load(project).name == "first"


def test_a_folder_taken_away_is_told_when_the_window_is_turned_to(stage, project, said):
    project.parent.rename(project.parent.with_name("elsewhere"))
    QApplication.sendEvent(stage.window, QEvent(QEvent.Type.WindowActivate))
    wait_for(stage, said, "no longer where it was")
    project.parent.with_name("elsewhere").rename(project.parent)


def test_own_saving_and_touching_the_file_are_no_news(stage, project, said):
    watch = stage.window.findChild(OutsideChanges)
    stage.presenter.do("Name", lambda document: edits.rename(document, "ours"))
    assert stage.window.files.save()
    project.touch()
    watch.look()
    assert not any("has changed" in notice.text for notice in said)


def large_document() -> Document:
    walls = [line((20.0, 0.0), (30.0, 40.0)), line((30.0, 40.0), (20.0, 80.0))]
    return Document(Profile.of(walls), name="large", extra=Extra({"notes": ["x" * 30_000] * 3}))


def test_a_large_file_is_read_aside_and_the_last_one_asked_for_is_shown(stage, tmp_path):
    paths = [tmp_path / f"{name}.sgb" for name in ("first", "second")]
    for path in paths:
        project_file.save(large_document(), path)
        assert path.stat().st_size > READ_AT_ONCE
    before = stage.document
    files_of = stage.window.files
    opened = [files_of.open_path(path) for path in paths]
    assert opened == [True, True]
    assert stage.document is before
    assert [job.label for job in stage.window.jobs.running][-1] == "Opening second.sgb"
    stage.until(lambda: not stage.window.jobs.running)
    assert (files_of.path, stage.document.name) == (paths[1], "large")


def test_reading_aside_can_be_cancelled_and_a_bad_file_is_said(stage, tmp_path, said):
    path = tmp_path / "large.sgb"
    project_file.save(large_document(), path)
    before, go_on = stage.document, threading.Event()
    # Jobs run one after another: until this one ends the file is not read.
    stage.window.jobs.start(Job("waits", lambda _report: go_on.wait(), lambda _: None, print))
    stage.window.files.open_path(path)
    stage.window.jobs.cancel_all()
    go_on.set()
    stage.until(lambda: not stage.window.jobs.running)
    assert stage.document is before
    path.write_bytes(path.read_bytes()[:-9])
    stage.window.files.open_path(path)
    wait_for(stage, said, "Could not open large.sgb")
    assert stage.document is before
