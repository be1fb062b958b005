"""An exception in each piece of work that runs aside: it is told, nothing waits for ever.

Where work is begun is found in the program's text; for each there must be something to begin it.
"""

import inspect
import re
import sys
from contextlib import contextmanager
from pathlib import Path
from types import SimpleNamespace

import pytest
from PySide6.QtWidgets import QDialog

import app
import resources
from app.commands.targets import Asked, Search
from app.drawings.dialog import DrawingDialog
from app.export.dialog import ExportDialog
from app.export.exporter import Exporting
from app.printing.dialog import PrintDialog
from app.state.jobs import Job, Jobs
from app.state.log import Log
from app.window.triangle_count import TriangleCount
from app.window.trouble import Trouble
from sgb_core import exchange
from sgb_core.design.solving.goals import Goal
from sgb_core.design.solving.ways import Way
from sgb_core.document import edits
from tests.app.window_stage import WindowStage

pytestmark = pytest.mark.usefixtures("faults_are_for_the_tests")

ROOT = Path(inspect.getfile(app)).parent


def called_in(name):
    """Return the modules of the program that call something by a name."""
    call = re.compile(rf"(?<!class )(?<!\w){re.escape(name)}\(")
    return {
        ".".join(path.relative_to(ROOT.parent).with_suffix("").parts)
        for path in ROOT.rglob("*.py")
        if call.search(path.read_text(encoding="utf-8"))
    }


def write(stage, _folder):
    exporting = stage.window.exporting
    assert isinstance(exporting, Exporting)
    exporting.write(Path("out.stl"), lambda _report: None)


def open_large(stage, folder):
    place = folder / "large.sgb"
    place.write_bytes(resources.load_preset("vase") + b" " * 60_000)
    assert stage.window.files.open_path(place)


def count(stage, _folder):
    counting = stage.window.findChild(TriangleCount)
    counting._done_for = None
    counting._start()


def paint(stage, _folder):
    look = SimpleNamespace(fine_work=lambda *_: [lambda: None])
    painter = stage.window.surface_view._painter
    assert not painter.is_ready(SimpleNamespace(look=look), stage.presenter.frame)
    stage.until(lambda: not painter.running)
    # The coarse picture stays: it is not tried again and again.
    assert not painter.running


def search(stage, _folder):
    refused = []
    asked = Asked(stage.document, {Goal.HEIGHT: 1.0}, Way.ALL, frozenset())
    jobs = stage.window.jobs
    found = Search(jobs, print, lambda _asked, error: refused.append(error), print)
    found.start(asked)
    stage.until(lambda: bool(refused))
    assert not found.busy


def import_points(stage, folder):
    place = folder / "points.csv"
    place.write_text("x,y\n1,0\n2,1\n2,2\n1,3\n")
    sheet = stage.window.importer.sheet
    sheet.open_path(place)
    stage.until(lambda: not sheet.intake.busy)
    assert "something went wrong" in sheet.intake.problem


def outline(stage, folder):
    place = folder / "old.sgb"
    place.write_bytes(resources.load_preset("vase"))
    gallery = stage.window.welcome.gallery
    stage.window.files.recent.add(place)
    gallery.open()
    stage.until(lambda: not any(jobs.running for jobs in gallery.findChildren(Jobs)))
    assert gallery.recent.tiles[0].picture.isNull()
    gallery.leave()


@contextmanager
def shown(dialog):
    dialog.show()
    yield dialog
    dialog.done(0)


def draw(stage, _folder):
    with shown(DrawingDialog(stage.document, stage.window)) as dialog:
        stage.until(lambda: dialog.told.text().startswith("Something went wrong"))


def plan_print(stage, _folder):
    with shown(PrintDialog(stage.document, stage.window)) as dialog:
        stage.until(lambda: dialog.totals.text().startswith("Something went wrong"))


def see_print(stage, _folder):
    stage.window.commands["show_print"].trigger()
    stage.until(lambda: stage.presenter.frame.printed is not None)
    assert "omething went wrong" in stage.presenter.frame.printed.refused
    stage.window.commands["show_print"].trigger()


def command(name):
    def begin(stage, _folder):
        stage.window.commands[name].trigger()

    return begin


# What begins the work of each module, in the window as far as a command does.
JOBS = {
    "app.export.exporter": write,
    "app.files.files": open_large,
    "app.window.triangle_count": count,
    "app.viewport.refine": paint,
    "app.start.gallery": outline,
    "app.commands.targets": search,
    "app.commands.fairing": command("make_fair"),
    "app.commands.variants_dialog": command("variants"),
    "app.figures.fit_dialog": command("fit_ellipse"),
    "app.figures.studio": command("figure_studio"),
    "app.intake.work": import_points,
    "app.drawings.dialog": draw,
    "app.printing.dialog": plan_print,
    "app.state.path_work": see_print,
}


@pytest.fixture(scope="module")
def _stage_of_all(qapp):
    from tests.app.waiting import PatientBot

    bot = PatientBot.__new__(PatientBot)
    bot._request = SimpleNamespace(node=None)
    made = WindowStage(bot)
    yield made
    made.close()


@pytest.fixture
def stage(qtbot, _stage_of_all):
    _stage_of_all.qtbot = qtbot
    _stage_of_all.settle()
    return _stage_of_all


@pytest.fixture
def trouble(stage):
    log = Log()
    made = Trouble(stage.window, log, lambda: [stage.window])
    yield made
    made.close()
    log.close()
    stage.window.notice_bar.dismiss()


def fail(*_args, **_options):
    raise ZeroDivisionError("planted")


def goes_on(stage, monkeypatch):
    """See that the trouble is told in plain words, and that all goes on as ever without it."""
    bar = stage.window.notice_bar
    stage.until(lambda: bar.notice is not None and "Something failed in" in bar.notice.text)
    assert "Your work is safe" in bar.notice.text
    monkeypatch.undo()
    before = stage.document
    assert stage.presenter.do("name", lambda document: edits.rename(document, "next"))
    stage.presenter.refresh_now()
    stage.presenter.undo()
    assert stage.document is before
    for dialog in stage.window.findChildren(QDialog):
        dialog.close()
    stage.until(lambda: not any(jobs.running for jobs in stage.window.findChildren(Jobs)))


def test_everything_that_runs_aside_is_tried():
    assert called_in("Job") == set(JOBS)
    assert called_in("threading.Thread") == {
        "app.state.body_work",
        "app.export.dialog",
        "app.files.journal_writer",
        "app.state.child_command",
        # What it cannot import is told where it is used: app/viewport/view.py.
        "app.viewport.view",
    }


@pytest.mark.parametrize("module", JOBS)
def test_work_that_fails_aside_is_told(stage, trouble, monkeypatch, tmp_path, module):
    made, init = [], Job.__init__

    def planting(job, label, work, *callbacks):
        if sys._getframe(1).f_globals["__name__"] == module:
            made.append(label)
            work = fail
        init(job, label, work, *callbacks)

    monkeypatch.setattr(Job, "__init__", planting)
    JOBS[module](stage, tmp_path)
    stage.until(lambda: bool(made))
    goes_on(stage, monkeypatch)


def test_a_body_that_cannot_be_made_is_told(stage, trouble, monkeypatch):
    monkeypatch.setattr(stage.window.body_work, "_make", fail)
    stage.presenter.do("solid", lambda document: edits.set_solid(document, kind="vessel", wall=3))
    goes_on(stage, monkeypatch)
    stage.presenter.undo()


def test_an_export_that_cannot_be_examined_is_told(stage, trouble, monkeypatch):
    monkeypatch.setattr("app.export.dialog.examine", fail)
    dialog = ExportDialog(stage.document, exchange.suffixes(), stage.window)
    with shown(dialog):
        stage.until(lambda: "something went wrong" in dialog._summary.text())
    goes_on(stage, monkeypatch)


def test_a_window_closes_whatever_fails_on_its_way_out(qtbot, trouble, stage, monkeypatch):
    other = WindowStage(qtbot, wait_for_scene=False)
    window, failed = other.window, []

    def failing_after(leave):
        def leaving(**options):
            leave(**options)
            failed.append(leave)
            raise ZeroDivisionError("planted")

        return leaving

    for part in (window.welcome.tour, window.body_work, window.safekeeping):
        monkeypatch.setattr(part, "stop", failing_after(part.stop))
    monkeypatch.setattr(window.arrangement, "save", failing_after(window.arrangement.save))
    other.close()
    assert len(failed) == 4
    # The windows that are left go on.
    goes_on(stage, monkeypatch)
