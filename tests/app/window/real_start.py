"""The real program, started once and left: prints what it said, as JSON.

``python -m tests.app.window.real_start``
"""

from __future__ import annotations

import json
import sys

from PySide6.QtCore import QTimer

from app.state.presenter import Presenter
from app.window import program
from app.window.main_window import MainWindow, application
from app.window.panels import PANELS


def main() -> int:
    """Start, wait until the window is drawn and its panels are made, and close it."""
    said: list[str] = []
    notify = Presenter.notify

    def noted(presenter: Presenter, text: str, *args: object, **options: object) -> None:
        said.append(text)
        notify(presenter, text, *args, **options)  # type: ignore[arg-type]

    Presenter.notify = noted  # type: ignore[method-assign]
    app = application()
    timer = QTimer(interval=20)

    def look() -> None:
        window = MainWindow.windows[0] if MainWindow.windows else None
        if window is None or window.surface_view.scene is None:
            return
        timer.stop()
        for kind in PANELS:
            assert window.panels[kind.key] is not None
        window.show_preferences()
        app.processEvents()
        last = window.notice_bar.notice
        offered = window.safekeeping.dialog is not None
        shown = {"visible": window.isVisible(), "offered": offered, "said": said}
        print(json.dumps({**shown, "last": last.text if last else ""}), flush=True)
        window.presenter.session.mark_saved()
        window.close()
        app.quit()

    timer.timeout.connect(look)
    timer.start()
    return program.run()


if __name__ == "__main__":
    sys.exit(main())
