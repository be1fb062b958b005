"""Plans the newest document's print path aside, once the hand rests, while it is to be seen."""

from __future__ import annotations

from dataclasses import replace

from PySide6.QtCore import QObject, QTimer

from app.state import preferences, printers
from app.state.body_work import same_body
from app.state.jobs import Job, Jobs
from app.state.overlays import Overlay
from app.state.presenter import Frame, Presenter
from app.state.printed import Printed, planned
from app.state.window_reader import reason
from sgb_core.document.model import Document

# The hand has stopped when nothing has changed for this long, in milliseconds.
REST = 150


class PathWork(QObject):
    """Keeps the presenter's path up to date, for the printer and the layer chosen last.

    What leans too far is planned all the same: its colours say so.
    """

    def __init__(self, presenter: Presenter, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._presenter = presenter
        self._frame: Frame | None = None
        self._done: Printed | None = None
        # The document of the path that is being planned or about to be.
        self._begun: Document | None = None
        self._jobs = Jobs(self)
        self._timer = QTimer(self, singleShot=True, interval=REST)
        self._timer.timeout.connect(self._start)
        self._choice = _choice()
        preferences.notifier().changed.connect(self._preferred)

    @property
    def busy(self) -> bool:
        """Whether a path is being planned or about to be."""
        return bool(self._jobs.running) or self._timer.isActive()

    def refresh(self, frame: Frame) -> None:
        """Plan the path of ``frame`` where it differs from what is there."""
        self._frame = frame
        done, document = self._done, frame.document
        if not frame.view.shows(Overlay.PRINT):
            self._drop()
            self._take(None)
        elif done is not None and done.document is document:
            self._drop()
        elif done is not None and _same_path(done.document, document):
            self._take(replace(done, document=document))
        elif frame.dragging or self._begun is None or not _same_path(self._begun, document):
            self._drop()
            self._begun = document
            self._timer.start()

    def _start(self) -> None:
        frame = self._frame
        # The frame that ends a drag comes here again.
        if frame is None or frame.dragging or not frame.view.shows(Overlay.PRINT):
            return
        document = self._begun = frame.document
        printer, layer = printers.chosen(printers.known())
        self._jobs.start(
            Job(
                "",
                lambda _: planned(document, printer, layer),
                self._take,
                lambda error: self._take(Printed(document, None, refused=reason(error))),
            )
        )

    def _drop(self) -> None:
        self._timer.stop()
        self._jobs.drop_all()
        self._begun = None

    def _take(self, printed: Printed | None) -> None:
        self._done, self._begun = printed, None
        self._presenter.set_printed(printed)

    def _preferred(self, _changed: object) -> None:
        if _choice() != self._choice:
            self._choice = _choice()
            self._drop()
            self._take(None)
            if self._frame is not None and self._frame.view.shows(Overlay.PRINT):
                self._timer.start()


def _choice() -> tuple[str, float]:
    wanted = preferences.current()
    return wanted.printer, wanted.print_layer


def _same_path(first: Document, second: Document) -> bool:
    return same_body(first, second) and first.manufacture == second.manufacture
