"""The real window used for long: what it holds before and after, counted.

``python -m tests.app.window.soak TICKS OPENS WINDOWS FOLDER`` prints its counts as JSON: after a
warm-up and after each of the three, the resident megabytes and the live objects of Qt and VTK.
"""

from __future__ import annotations

import gc
import json
import os
import sys
import threading
from pathlib import Path

from PySide6.QtCore import QCoreApplication, QEvent, QObject
from PySide6.QtWidgets import QApplication
from vtkmodules.vtkCommonCore import vtkObjectBase

import resources
from app.window.garbage_collector import GarbageCollector
from app.window.main_window import MainWindow, application
from sgb_core.document import edits

GESTURE = 50


def turn(times: int = 3) -> None:
    """Let the event loop turn, and what is to be deleted go."""
    for _ in range(times):
        QCoreApplication.processEvents()
    QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete.value)


def counts() -> dict[str, int]:
    """Return the resident megabytes and how many objects of each kind are alive."""
    for _ in range(3):
        turn()
        gc.collect()
    pages = int(Path("/proc/self/statm").read_text().split()[1])
    found = [type(each) for each in gc.get_objects()]
    return {
        "megabytes": pages * os.sysconf("SC_PAGE_SIZE") >> 20,
        "widgets": len(QApplication.allWidgets()),
        "qt": sum(issubclass(each, QObject) for each in found),
        "vtk": sum(issubclass(each, vtkObjectBase) for each in found),
        "threads": threading.active_count(),
    }


def shown() -> MainWindow:
    """Return a new window that has drawn."""
    window = MainWindow()
    window.resize(900, 650)
    window.show()
    while window.surface_view.scene is None:
        turn()
    return window


def drag(window: MainWindow, ticks: int) -> None:
    """Move a slider so many ticks, in gestures of GESTURE, each seen at once."""
    presenter = window.presenter
    for tick in range(ticks):
        if tick % GESTURE == 0:
            presenter.commit()
            presenter.begin("λ2")
        value = 0.5 + tick % 97 / 20.0
        presenter.apply(lambda d, v=value: edits.set_shape_parameter(d, 0, "lambda2", v))
        turn(1)
    presenter.commit()


def open_files(window: MainWindow, paths: list[Path], times: int) -> None:
    """Open so many files one after another."""
    for number in range(times):
        window.presenter.session.mark_saved()
        assert window.files.open_path(paths[number % len(paths)])
        turn(2)


def open_windows(times: int) -> None:
    """Open and close so many windows."""
    for _ in range(times):
        window = shown()
        window.close()
        turn()


def main(ticks: int, opens: int, windows: int, folder: Path) -> dict[str, dict[str, int]]:
    """Do it all; return the counts, the first after a warm-up."""
    GarbageCollector(application())
    paths = []
    for preset in resources.presets()[:6]:
        paths.append(folder / f"{preset.name}.sgb")
        paths[-1].write_bytes(resources.load_preset(preset.name))
    window = shown()
    # What is made once and kept: histories, caches, drivers.
    open_files(window, paths, 2 * len(paths))
    drag(window, 2 * GESTURE)
    open_windows(2)
    found = {"warm": counts()}
    drag(window, ticks)
    # The history of that many gestures is the user's own.
    open_files(window, paths[:1], 1)
    found["ticks"] = counts()
    open_files(window, paths, opens)
    open_files(window, paths[:1], 1)
    found["opens"] = counts()
    open_windows(windows)
    found["windows"] = counts()
    window.presenter.session.mark_saved()
    window.close()
    turn()
    return found


if __name__ == "__main__":
    print(json.dumps(main(*map(int, sys.argv[1:4]), Path(sys.argv[4]))))
