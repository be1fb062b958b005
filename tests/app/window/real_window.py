"""The real program in a process of its own, driven from inside; for tests that end it.

``python -m tests.app.window.real_window FOLDER``: gestures without end on a project in FOLDER,
every fourth followed by a save. After each gesture a line on standard output: its number, the
nanoseconds of the system's clock, and "saved" or "done". With ``KIND NUMBER PART`` it dies in
writing, see :mod:`tests.app.window.dying`, and says "dies" before it does; each save is then
followed by an export.
"""

from __future__ import annotations

import os
import sys
import time
from pathlib import Path

from PySide6.QtCore import QTimer

from app.export.plan import ExportPlan
from app.window import program
from app.window.main_window import MainWindow, application
from sgb_core.document import edits
from sgb_core.document.file import journal
from sgb_core.document.model import Document
from tests.app.window.dying import Death

TICKS, SAVES = 2, 4


class Driver:
    """Drags, tick by tick, as a hand does; the document's name is the number of the gesture."""

    def __init__(self, folder: Path, *, exports: bool) -> None:
        self._path = folder / "project" / "pot.sgb"
        self._export = folder / "exports" / "pot.stl" if exports else None
        self._gesture, self._tick = 0, 0
        self._timer = QTimer(interval=3)
        self._timer.timeout.connect(self._next)
        self._timer.start()

    def _next(self) -> None:
        window = MainWindow.windows[0] if MainWindow.windows else None
        if window is None or window.surface_view.scene is None:
            return
        presenter = window.presenter
        if self._tick == 0:
            self._gesture += 1
            presenter.begin(f"gesture {self._gesture}")
        self._tick += 1
        number, value = self._gesture, 1.0 + (self._gesture * TICKS + self._tick) % 50 / 10.0
        presenter.apply(lambda document: _moved(document, number, value))
        if self._tick < TICKS:
            return
        self._tick = 0
        presenter.commit()
        self._tell("done")
        if self._gesture % SAVES == 0:
            window.files._write(self._path)
            self._tell("saved")
            if self._export is not None and not window.jobs.running:
                plan = ExportPlan(presenter.document, ".stl", samples=(8, 24))
                window.exporting.write_plan(self._export, plan)

    def _tell(self, what: str) -> None:
        os.write(1, f"{self._gesture} {time.monotonic_ns()} {what}\n".encode())


def _moved(document: Document, number: int, value: float) -> Document:
    shaped = edits.set_shape_parameter(document, 0, "lambda2", value)
    return edits.rename(shaped, str(number))


if __name__ == "__main__":
    # Timers run in the thread of the application alone.
    app = application()
    place, *death = sys.argv[1:]
    if death:
        Death(death[0], int(death[1]), float(death[2])).prepare()
        if death[0] == "rewrite":
            # Entries are begun anew all the time.
            journal.LARGE, journal.GROWN = 0, 1
    driver = Driver(Path(place), exports=bool(death))
    sys.exit(program.run())
