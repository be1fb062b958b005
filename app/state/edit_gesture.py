"""One control's gesture on the document: many values, one undo entry."""

from __future__ import annotations

from collections.abc import Callable

from app.state.presenter import Presenter
from sgb_core.document.model import Document


class EditGesture:
    """One control's gesture on the document; it survives someone else's ending it."""

    def __init__(self, presenter: Presenter) -> None:
        self._presenter = presenter
        self._label = ""
        self._start: Document | None = None

    @property
    def is_open(self) -> bool:
        """Whether the session's gesture is the one begun here."""
        session = self._presenter.session
        return session.in_gesture and session.gesture_start is self._start

    def begin(self, label: str) -> None:
        """Begin a gesture that becomes one undo entry called ``label``."""
        self._presenter.begin(label)
        self._label = label
        self._start = self._presenter.session.gesture_start

    def apply(self, edit: Callable[[Document], Document], *, settled: bool = False) -> bool:
        """Apply ``edit`` to the document of the gesture's start; return whether it is allowed.

        One that is ``settled`` has kept the locks itself.
        """
        if not self.is_open:
            # An undo in the middle of a run of wheel steps has ended it: begin the next one.
            self.begin(self._label)
        return self._presenter.apply(edit, settled=settled)

    def commit(self) -> None:
        """End the gesture, keeping what it did."""
        if self.is_open:
            self._presenter.commit()
        self._start = None

    def cancel(self) -> None:
        """End the gesture, taking back what it did."""
        if self.is_open:
            self._presenter.cancel()
        self._start = None
