"""An exception in whatever follows the document, in whatever paints: the rest goes on.

What is planted in is not listed here but found in the window itself, as it refreshes and paints.
"""

import inspect
from pathlib import Path

import pytest
from PySide6.QtCore import QCoreApplication
from PySide6.QtWidgets import QDialog, QLabel, QWidget

import app
from app.state.log import Log
from app.state.presenter import Presenter
from app.state.unforeseen import guarded
from app.window.panel_slot import PanelSlot
from app.window.panels import PANELS
from app.window.trouble import Trouble, TroubleDialog
from sgb_core.document import edits
from tests.app.helpers import tower
from tests.app.window.planting import function_of, noted, planted
from tests.app.window_stage import WindowStage

pytestmark = pytest.mark.usefixtures("faults_are_for_the_tests")

# Dialogs that follow the document while they are open.
FOLLOWING = ("fit_ellipse", "figure_studio", "make_fair_by", "reach_targets", "variants")
FOLLOWING += ("picture_behind",)
# What passes refreshes and failures on.
BETWEEN = {Presenter.__module__, Trouble.__module__, guarded.__module__}


@pytest.fixture
def stage(qtbot):
    made = WindowStage(qtbot, size=(1500, 950))
    made.presenter.replace_document(tower())
    yield made
    for dialog in made.window.findChildren(TroubleDialog):
        dialog.close()
    made.close()


@pytest.fixture
def trouble(stage):
    log = Log()
    made = Trouble(stage.window, log, lambda: [stage.window])
    yield made
    made.close()
    log.close()


def edited(stage, name):
    stage.presenter.do("name", lambda document: edits.rename(document, name))


def listeners(stage):
    """Return the functions that one refresh calls one after another, by their names."""
    found = {}
    refreshing = Presenter.refresh_now.__code__
    slot = PanelSlot.refresh.__code__

    def note(frame):
        if frame.f_code is slot or frame.f_code.co_name == "guarding":
            return
        caller = frame.f_back
        while caller.f_code is slot or caller.f_code.co_name == "guarding":
            caller = caller.f_back
        function = function_of(frame.f_code, frame)
        if caller.f_code is refreshing and function is not None:
            place = function.__module__, function.__qualname__
            if place[0] not in BETWEEN:
                found[place] = function

    with noted(note):
        stage.presenter.refresh_now()
    return found


def see(stage, key):
    dock = stage.window.panels.docks[key]
    dock.show()
    dock.raise_()
    panel = stage.window.panels[key]
    stage.until(lambda: not panel.visibleRegion().isEmpty())


def told(stage):
    """Wait until the window says in plain words that something failed; take it off."""
    bar, window = stage.window.notice_bar, stage.window
    stage.until(lambda: bar.notice is not None or window.findChild(TroubleDialog) is not None)
    dialog = window.findChild(TroubleDialog)
    said = bar.notice.text if dialog is None else dialog.findChild(QLabel).text()
    if dialog is not None:
        dialog.close()
    bar.dismiss()
    assert said.startswith("Something failed in ")
    assert "Your work is safe" in said
    return said


def test_whatever_follows_the_document_may_fail_alone(stage, trouble, capsys):
    for name in FOLLOWING:
        stage.window.commands[name].trigger()
    stage.settle()
    tried = {}
    for kind in PANELS:
        see(stage, kind.key)
        edited(stage, kind.key)
        present = listeners(stage)
        for place, function in present.items():
            if place in tried:
                continue
            before = stage.document
            edited(stage, f"{kind.key} {len(tried)}")
            with planted(function):
                assert listeners(stage).keys() | {place} == present.keys(), place
            tried[place] = told(stage)
            stage.presenter.undo()
            assert stage.document is before
            assert listeners(stage).keys() == present.keys()
        for dialog in stage.window.findChildren(QDialog):
            dialog.close()
    panels = {type(stage.window.panels[kind.key]).refresh.__module__ for kind in PANELS}
    modules = {module for module, _ in tried}
    assert panels <= modules
    # What starts the program hears of frames only there: test_broken_homes.py.
    assert subscribers() - {"app.window.program"} <= modules
    with capsys.disabled():
        print(f"\n{len(tried)} views, panels and sheets failed one by one")


def subscribers():
    """Return the modules of the program in which something connects to the refresh."""
    root = Path(inspect.getfile(app)).parent
    return {
        ".".join(path.relative_to(root.parent).with_suffix("").parts)
        for path in root.rglob("*.py")
        if ".refreshed.connect(" in path.read_text(encoding="utf-8")
    }


def painters(window):
    """Return what paints in a window, and what these functions call first, by their names."""
    found = {}

    def note(frame):
        names = (frame.f_code.co_name, frame.f_back.f_code.co_name)
        function = function_of(frame.f_code, frame)
        if "paintEvent" in names and function is not None:
            found[function.__module__, function.__qualname__] = function

    with noted(note):
        repaint(window)
    return found


def repaint(window):
    for each in window.findChildren(QWidget):
        # What VTK draws has no paintEvent of ours, and takes long.
        if each is not window.surface_view.plotter:
            each.update()
    # As in the program's own loop: while the functions of QTest run, Qt calls nothing of Python's
    # after one thing has failed.
    for _ in range(3):
        QCoreApplication.processEvents()


class Called:
    """Whether a function has been called that is planted in."""

    def __init__(self, function):
        self._code = function.__code__
        self.any = False

    def __call__(self, frame):
        self.any |= frame.f_code is self._code


def test_whatever_paints_may_fail_once(stage, trouble, capfd):
    tried = set()
    for kind in PANELS:
        see(stage, kind.key)
        for place, function in painters(stage.window).items():
            if place in tried:
                continue
            with planted(function), noted(called := Called(function)):
                repaint(stage.window)
            if called.any:
                # What is kept from an earlier painting is not called again.
                tried.add(place)
                assert told(stage)
                # What painted has let go of the widget, and paints it as before.
                assert place in painters(stage.window)
    assert len(tried) > 20
    # Qt would say of a painter that it is still at work.
    assert "painter" not in capfd.readouterr().err
    with capfd.disabled():
        print(f"\n{len(tried)} parts of the painting failed one by one")
