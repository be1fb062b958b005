"""The real program in a process of its own that does what a line on its input says.

``open PATH``, ``name TEXT`` edits, ``save ANSWER`` answers the question, should one be asked, by a
click on that button of it, and ``flush`` waits for the disk. Each is answered with a line of JSON.
"""

from __future__ import annotations

import json
import os
import sys
from pathlib import Path
from typing import Any

from PySide6.QtCore import QSocketNotifier, QTimer
from PySide6.QtWidgets import QFileDialog, QLabel

from app.files.conflict import Answer, ConflictDialog
from app.window import program
from app.window.main_window import MainWindow, application
from sgb_core.document import edits


class Commanded:
    """Reads commands while the program runs."""

    def __init__(self) -> None:
        self._asked: dict[str, Any] = {}
        self._answer = Answer.CANCEL
        self._notifier = QSocketNotifier(0, QSocketNotifier.Type.Read)
        self._notifier.activated.connect(lambda *_: self._next())
        self._exec = ConflictDialog.exec
        ConflictDialog.exec = lambda dialog: self._click(dialog)  # type: ignore[method-assign]

    def _click(self, dialog: ConflictDialog) -> int:
        labels = dialog.findChildren(QLabel)
        self._asked = {
            "asked": " ".join(each.text() for each in labels),
            "pictures": sum(not each.pixmap().isNull() for each in labels),
        }
        QTimer.singleShot(200, dialog.buttons[self._answer].click)
        if place := os.environ.get("SGB_PICTURES"):
            dialog.grab().save(f"{place}/{os.getpid()}-{self._answer.name}.png")
        return self._exec(dialog)

    def _next(self) -> None:
        if not MainWindow.windows:
            # The frame alone is there so far; what is to be read will be told again.
            return
        line = os.read(0, 4096).decode().strip()
        self._notifier.setEnabled(False)
        print(json.dumps(self._do(*line.split(" ", 1))), flush=True)
        self._notifier.setEnabled(True)

    def _do(self, verb: str, rest: str = "") -> dict[str, Any]:
        window = MainWindow.windows[0]
        found: dict[str, Any] = {"done": True}
        self._asked = {}
        if verb == "open":
            found["done"] = window.files.open_path(Path(rest))
        elif verb == "name":
            window.presenter.do("Name", lambda document: edits.rename(document, rest))
            found["done"] = window.safekeeping.flush()
        elif verb == "save":
            name, _, other = rest.partition(" ")
            self._answer = Answer[name]
            QFileDialog.getSaveFileName = lambda *_: (other, "")  # type: ignore[method-assign, assignment]
            found["done"] = window.files.save()
        window.presenter.refresh_now()
        ghost = window.presenter.frame.compared
        notice = window.notice_bar.notice
        found["ghost"] = "" if ghost is None else ghost.document.name
        found["notice"] = "" if notice is None else notice.text
        return {**found, **self._asked}


if __name__ == "__main__":
    application()
    commanded = Commanded()
    sys.exit(program.run())
