"""Whatever lies in the program's places, a start shows the window."""

import shutil

import pytest
from PySide6.QtCore import QByteArray, QSettings

from app.files.files import RecentFiles
from app.state import preferences, stored, user_folders
from app.window import program
from app.window.main_window import MainWindow
from sgb_core.document.file import recovery
from tests.app.waiting import activate, let_turn

ENTRIES = (b"{}", b"", b"[]", b'{"document": 3}', b"\xff\xfe", b'{"target": [], "document": {}}')


@pytest.fixture
def start(qtbot):
    shown = []

    def begin():
        preferences.reload()
        window = MainWindow(furnished=False)
        window.show_frame()
        window.furnish()
        shown.append(window)
        program.begin(window, None)
        activate(qtbot, window)
        return window

    stored.faults()
    yield begin
    for window in shown:
        window.presenter.session.mark_saved()
        window.close()
    let_turn()
    shutil.rmtree(user_folders.recovery(), ignore_errors=True)


def test_settings_of_wrong_types_are_said_and_the_defaults_hold(start):
    wrong = {
        "theme": "sepia",
        "geometry": "no bytes",
        "state": QByteArray(b"junk"),
        "text_percent": ["80", "90"],
        "measures/overhang": "steep",
        "measures/length": 7,
        "keys/undo": "Ctrl+Nonsense",
        "hints_seen": 3.5,
        "recent_files": ["x" * 5000, "a\0b"],
        "welcomed": QByteArray(b"\0"),
    }
    for key, value in wrong.items():
        QSettings().setValue(key, value)
    window = start()
    assert window.isVisible()
    said = window.notice_bar.notice.text
    for key in ("geometry", "text_percent", "keys/undo"):
        assert key in said
    # A panel's own settings are read when it is first seen, and stop it no more.
    assert window.panels["measures"] is not None
    assert stored.stored_theme() == "system"
    assert RecentFiles().paths() == []
    assert not window.commands["undo"].shortcut().isEmpty()


def test_broken_entries_are_set_aside_and_the_good_one_is_offered(start):
    folder = user_folders.recovery()
    folder.mkdir(parents=True, exist_ok=True)
    for number, data in enumerate(ENTRIES):
        (folder / f"x{number}{recovery.SUFFIX}").write_bytes(data)
    window = start()
    assert window.isVisible()
    # What is empty was killed before its first step.
    assert len(recovery.aside(folder)) == len(ENTRIES) - 1
    assert list(folder.glob(f"*{recovery.SUFFIX}")) == []


@pytest.mark.parametrize("place", [user_folders.recovery, user_folders.thumbnails])
def test_a_file_in_the_place_of_a_folder_stops_nothing(start, place):
    shutil.rmtree(place(), ignore_errors=True)
    place().parent.mkdir(parents=True, exist_ok=True)
    place().write_bytes(b"in the way")
    window = start()
    assert window.isVisible()
    place().unlink()
