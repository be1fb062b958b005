"""The only subscriber of the session: turns what changed into one refresh per event turn.

Views call the presenter to change the document or what is shown; the presenter answers with a
:class:`Frame` that every view compares, by identity, with the one it drew last.
"""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import replace
from typing import TYPE_CHECKING, Literal, Protocol, Unpack

from PySide6.QtCore import QObject, QTimer, Signal

from app.state.comparison import Comparison
from app.state.overlays import Overlay
from app.state.unforeseen import guarded
from app.state.view_state import ViewChanges, ViewState
from app.state.window_reader import why
from sgb_core.document.edits import EditError
from sgb_core.document.evaluation import Evaluation, evaluate
from sgb_core.document.model import Document
from sgb_core.document.session import Refining, Session
from sgb_core.findings.locks import LocksInTheWay
from sgb_core.findings.refusal import RefusalError
from sgb_core.values import dataclass

if TYPE_CHECKING:
    from app.state.printed import Printed
    from sgb_core.document.body_state import BodyState

Edit = Callable[[Document], Document]
Level = Literal["info", "warning", "error"]

# When a document of more segments is opened, views that take longer are left for the next turn.
LONG, TURN_SECONDS = 100, 0.05


@dataclass(frozen=True, slots=True)
class Frame:
    """Everything a view needs to draw itself: the evaluated document and the view state.

    ``generation`` counts the documents opened in this window, so that a view knows when to fit.
    ``body`` is the newest body that has been made, which may be that of an older document.
    ``compared`` is another state, laid over the document as a ghost; ``in_the_way`` are the locks
    that stopped the last edit; ``printed`` is the newest path of a printer, where one is shown.
    """

    evaluation: Evaluation
    view: ViewState
    dragging: bool
    generation: int
    compared: Evaluation | None = None
    body: BodyState | None = None
    in_the_way: LocksInTheWay | None = None
    printed: Printed | None = None

    @property
    def document(self) -> Document:
        """The document that was evaluated."""
        return self.evaluation.document


@dataclass(frozen=True, slots=True)
class Notice:
    """A message of the window, with at most one button that mends what it says.

    ``holds`` says of a frame whether its cause is still there: it goes with it. Without, it goes
    with the document that it was about, unless it ``stays``, as an offer to restore work does.
    """

    text: str
    level: Level = "info"
    action: str = ""
    callback: Callable[[], object] | None = None
    holds: Callable[[Frame], bool] | None = None
    stays: bool = False


class View(Protocol):
    """Whatever draws frames."""

    def refresh(self, frame: Frame) -> None:
        """Show ``frame``; called at most once per event turn."""


class Presenter(QObject):
    """Connects one session with the views of one window."""

    noticed = Signal(object)
    refreshed = Signal(object)

    def __init__(self, session: Session, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.session = session
        self.view = ViewState()
        self._views: list[View] = []
        self._generation = 0
        # The generation that all views show, and the views that are still to be refreshed.
        self._shown = 0
        self._waiting: list[View] = []
        self._changed = False
        self._body: BodyState | None = None
        self._printed: Printed | None = None
        self._evaluation = evaluate(session.document)
        self._comparison = Comparison()
        self._timer = QTimer(self)
        self._timer.setSingleShot(True)
        self._timer.setInterval(0)
        self._timer.timeout.connect(self._refresh_due)
        session.subscribe(guarded(self._session_changed))

    # What views read.

    @property
    def document(self) -> Document:
        """The present document, which may be newer than the last frame."""
        return self.session.document

    @property
    def frame(self) -> Frame:
        """The present state as a frame."""
        if self._evaluation.document is not self.session.document:
            self._evaluation = evaluate(self.session.document, self._evaluation)
        return Frame(
            self._evaluation,
            self.view,
            self.session.in_gesture,
            self._generation,
            compared=self._comparison.evaluation(self.session, self.view),
            body=self._body,
            in_the_way=self.session.in_the_way,
            printed=self._printed,
        )

    def add_view(self, view: View) -> None:
        """Refresh ``view`` from now on, beginning with the next event turn."""
        self._views.append(view)
        self._schedule()

    # What views ask for.

    def begin(self, label: str) -> None:
        """Begin a gesture that becomes one undo entry called ``label``."""
        self.session.begin(label)
        self._schedule()

    def apply(self, edit: Edit, *, settled: bool = False, refining: Refining | None = None) -> bool:
        """Apply an edit to the document as it was when the gesture began.

        One that is ``settled`` has kept the locks itself; ``refining`` goes on after them.

        An edit that is not allowed leaves the last good state and says why; returns whether
        the edit was done.
        """
        return self._guarded(lambda: self.session.apply(edit, settled=settled, refining=refining))

    def commit(self) -> None:
        """End the gesture and keep what it did."""
        self.session.commit()
        self._schedule()

    def cancel(self) -> None:
        """End the gesture and restore the document from before it."""
        self.session.cancel()
        self._schedule()

    def do(self, label: str, edit: Edit) -> bool:
        """Do one edit as a gesture of its own; returns whether it was allowed."""
        return self._guarded(lambda: self.session.do(label, edit))

    def undo(self) -> None:
        """Go back by one gesture."""
        self.session.undo()

    def redo(self) -> None:
        """Go forward by one gesture."""
        self.session.redo()

    def replace_document(
        self, document: Document, *, saved: bool = True, evaluation: Evaluation | None = None
    ) -> None:
        """Show another document with an empty history, as after opening a file.

        ``evaluation`` is the document's, where what follows from it has been computed aside.
        """
        self._generation += 1
        self.view = replace(
            self.view,
            segment=0,
            points=frozenset(),
            hover=None,
            angle=None,
            mark=None,
            preview=None,
            before=None,
            ghost_state=None,
            ghost=None,
        )
        self.session.replace(document, saved=saved)
        if evaluation is not None:
            self._evaluation = evaluation
        self._schedule()

    def select(self, segment: int | None, point: int | None = None) -> None:
        """Select a segment (None keeps the present one) and, with ``point``, a control point."""
        chosen = self.view.segment if segment is None else segment
        points = frozenset() if point is None else frozenset({(chosen, point)})
        self.set_view(segment=chosen, points=points)

    def set_view(self, **changes: Unpack[ViewChanges]) -> None:
        """Change fields of the view state."""
        view = replace(self.view, **changes)
        if view.influence_follows and view.hover is not None:
            view = replace(view, influence=view.hover.parameter)
        if view != self.view:
            self.view = view
            self._schedule()

    def toggle_overlay(self, overlay: Overlay) -> None:
        """Show what is hidden, hide what is shown."""
        self.set_view(show=self.view.show ^ {overlay})

    def toggle_projection(self) -> None:
        """Change between perspective and parallel projection."""
        parallel = self.view.projection == "parallel"
        self.set_view(projection="perspective" if parallel else "parallel")

    def set_body(self, body: BodyState | None) -> None:
        """Take the body that has been made, None for a bare surface, and show it."""
        if body is not self._body:
            self._body = body
            self._schedule()

    def set_printed(self, printed: Printed | None) -> None:
        """Take the path that has been planned, None where none is shown, and show it."""
        if printed is not self._printed:
            self._printed = printed
            self._schedule()

    def notify(
        self,
        text: str,
        level: Level = "info",
        action: str = "",
        callback: Callable[[], object] | None = None,
        *,
        holds: Callable[[Frame], bool] | None = None,
        stays: bool = False,
    ) -> None:
        """Say something in the window's notice bar; see :class:`Notice`."""
        self.noticed.emit(Notice(text, level, action, callback, holds, stays))

    # The one refresh.

    def refresh_now(self) -> None:
        """Refresh all views with the newest state; normally once per event turn by itself."""
        self._timer.stop()
        self._waiting.clear()
        self._changed = False
        frame = self.frame
        for view in self._views:
            # One that fails keeps no other from showing what is there now.
            guarded(view.refresh)(frame)
        self._shown = self._generation
        self.refreshed.emit(frame)

    def _refresh_due(self) -> None:
        """Refresh all views; those of a long document just opened in several event turns."""
        frame = self.frame
        long = len(frame.document.profile) > LONG
        if not self._waiting and (self._shown == self._generation or not long):
            self.refresh_now()
            return
        if not self._waiting:
            self._waiting, self._changed = list(self._views), False
        begun = time.perf_counter()
        while self._waiting and time.perf_counter() - begun < TURN_SECONDS:
            guarded(self._waiting.pop(0).refresh)(frame)
        if not self._waiting:
            self._shown = self._generation
            self.refreshed.emit(frame)
        if self._waiting or self._changed:
            self._timer.start()

    def _schedule(self) -> None:
        # What changes while views wait is new to those that have been refreshed already.
        self._changed = bool(self._waiting)
        if not self._timer.isActive():
            self._timer.start()

    def _session_changed(self, _old: Document, new: Document) -> None:
        count = len(new.profile.segments)
        segment = min(self.view.segment, count - 1)
        points = frozenset(key for key in self.view.points if key[0] < count)
        self.view = replace(self.view, segment=segment, points=points, preview=None, before=None)
        self._schedule()

    def _guarded(self, action: Callable[[], object]) -> bool:
        try:
            action()
        except (EditError, RefusalError) as error:
            self.notify(why(error), "warning")
            return False
        return True
