"""Makes the body of the newest document aside: coarse while the hand moves, fine when it rests."""

from __future__ import annotations

import threading
from collections.abc import Callable
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Qt, QTimer, Signal
from shiboken6 import isValid

from app.state.jobs import Cancelled, Stop
from app.state.presenter import Frame, Presenter
from app.state.unforeseen import tell_unforeseen
from app.state.window_reader import why
from sgb_core.document.appearance.relief import relief_of
from sgb_core.document.model import Document
from sgb_core.findings.bodies import BodyFailure
from sgb_core.interruption import interruptible
from sgb_core.surfaces.revolution import RevolutionSurface

if TYPE_CHECKING:
    from sgb_core.document.body_state import BodyState

# The hand has stopped when nothing has changed for this long, in milliseconds.
REST = 100

Make = Callable[..., "BodyState"]


class BodyWork(QObject):
    """Keeps the presenter's body up to date, one at a time, always for the newest document.

    What was made for an older document is shown only while it is the newest there is, as during a
    drag; it never replaces that of a newer one. A fine body that is outdated before it is done is
    dropped; a coarse one is not, or a steady drag would show none.
    """

    finished = Signal(object, int)

    def __init__(
        self, presenter: Presenter, parent: QObject | None = None, make: Make | None = None
    ) -> None:
        super().__init__(parent)
        self._presenter = presenter
        self._make = make or _make
        self._wanted: Frame | None = None
        self._made_for: Document | None = None
        self._generation = -1
        self._made_fine = False
        self._thread: threading.Thread | None = None
        self._making: Frame | None = None
        self._making_fine = False
        self._drop = Stop()
        self._stopped = False
        self._timer = QTimer(self, singleShot=True, interval=REST)
        self._timer.timeout.connect(lambda: self._start(fine=True))
        self.finished.connect(self._take, Qt.ConnectionType.QueuedConnection)

    @property
    def busy(self) -> bool:
        """Whether a body is being made or about to be."""
        return self._thread is not None or self._timer.isActive()

    def refresh(self, frame: Frame) -> None:
        """Make the body of ``frame`` where it differs from what is there."""
        self._wanted = frame
        if self._is_outdated(frame):
            self._drop.set()
        if not frame.document.has_body:
            self._timer.stop()
            self._made_for = None
            self._presenter.set_body(None)
            return
        if frame.generation != self._generation:
            self._generation = frame.generation
            self._presenter.set_body(None)
        if not same_body(self._made_for, frame.document):
            self._start(fine=False)
        if not (self._made_fine and same_body(self._made_for, frame.document)):
            self._timer.start()

    def stop(self) -> None:
        """Drop what is under way, and start nothing more."""
        self._stopped = True
        self._timer.stop()
        self._drop.set()
        if self._thread is not None:
            self._thread.join()

    def _start(self, *, fine: bool) -> None:
        frame = self._wanted
        if self._stopped or frame is None or not frame.document.has_body:
            return
        if fine and frame.dragging:
            self._timer.start()
            return
        if fine and self._made_fine and same_body(self._made_for, frame.document):
            return
        if self._thread is not None:
            # What has been made by then is followed by what is wanted then.
            if fine:
                self._timer.start()
            return
        document, surface = frame.document, frame.evaluation.surface
        self._making, self._making_fine, self._drop = frame, fine, Stop()
        self._thread = threading.Thread(
            target=self._run,
            args=(document, surface, fine, frame.generation, self._drop),
            daemon=True,
        )
        self._thread.start()

    def _is_outdated(self, frame: Frame) -> bool:
        """Whether what is being made is no longer worth its time."""
        making = self._making
        return making is not None and (
            not frame.document.has_body
            or frame.generation != making.generation
            or (self._making_fine and not same_body(making.document, frame.document))
        )

    def _run(
        self,
        document: Document,
        surface: RevolutionSurface,
        fine: bool,
        generation: int,
        drop: Stop,
    ) -> None:
        state: BodyState | None
        try:
            with interruptible(drop.ask):
                state = self._make(document, surface, fine=fine)
        except Cancelled:
            state = None
        except Exception as error:
            from sgb_core.document.body_state import BodyState

            state = BodyState(document, surface, fine, error=BodyFailure(why(error)))
            tell_unforeseen(error)
        # A window that has closed meanwhile wants it no more.
        if isValid(self):
            self.finished.emit(state, generation)

    def _take(self, state: BodyState | None, generation: int) -> None:
        self._thread = self._making = None
        frame = self._wanted
        if frame is None or not frame.document.has_body:
            return
        if state is not None and generation == frame.generation:
            self._made_for, self._made_fine = state.document, state.fine
            self._presenter.set_body(state)
        if not same_body(self._made_for, frame.document):
            self._start(fine=False)


def same_body(first: Document | None, second: Document) -> bool:
    """Whether two documents have the same body, told from the identity of their parts."""
    return first is not None and (
        first.profile is second.profile
        and first.revolution is second.revolution
        and first.variation is second.variation
        and first.twist == second.twist
        and first.placement is second.placement
        and first.solid == second.solid
        and first.cut_outs == second.cut_outs
        and same_relief(first, second)
        and first.manufacture.fill == second.manufacture.fill
        and first.unit is second.unit
    )


def same_relief(first: Document, second: Document) -> bool:
    """Whether what paint raises is the same in two documents."""
    if first.appearance is second.appearance:
        return True
    return relief_of(first.appearance) == relief_of(second.appearance)


def _make(document: Document, surface: RevolutionSurface, *, fine: bool) -> BodyState:
    # Imported when first needed, aside: the window is painted sooner.
    from sgb_core.document.body_state import body_state

    state = body_state(document, surface, fine=fine)
    if state.mesh is not None:
        # The profile editor draws both at once: worked out here they do not hold up its picture.
        _ = state.section(surface.start), state.liquid_section
    return state
