"""The current document, the gestures that change it, and the way back."""

from __future__ import annotations

from collections.abc import Callable
from typing import Protocol, TypeAlias

from sgb_core.document.errors import EditError
from sgb_core.document.lock_keeper import LockKeeper
from sgb_core.document.model import Document
from sgb_core.findings.locks import LocksInTheWay
from sgb_core.values import dataclass

Edit: TypeAlias = Callable[[Document], Document]
Subscriber: TypeAlias = Callable[[Document, Document], None]


class Refining(Protocol):
    """What goes on after the locks have been kept, in every tick of a gesture and at its end."""

    def after(self, start: Document, document: Document, *, final: bool) -> Document:
        """Return ``document``, made from ``start``, refined; the locks hold as they did."""
        ...


@dataclass(frozen=True, slots=True)
class HistoryEntry:
    """One state to go back to, and the name of the step that led to it."""

    label: str
    document: Document


class Session:
    """One document being edited: gestures, undo, redo, saved mark, subscribers.

    History is a list of whole frozen documents that share their unchanged parts; undo hands
    back the very value that was there before. A gesture (press, many moves, release) makes one
    entry, or none where it changed nothing. Every edit goes through the document's locks: what
    they do not allow is not done, or only as far as they do.
    """

    def __init__(self, document: Document, *, saved: bool = True) -> None:
        """Start with a document; ``saved`` says whether it is as it is on disk."""
        self._document = document
        self._saved = document if saved else None
        self._history = [HistoryEntry("", document)]
        self._position = 0
        self._gesture: str | None = None
        self._passing = False
        self._subscribers: list[Subscriber] = []
        self._keeper = LockKeeper()
        self._asked: Document | None = None
        self._asked_settled = False
        self._refining: Refining | None = None
        self._in_the_way: LocksInTheWay | None = None

    @property
    def document(self) -> Document:
        """The document as it is now, in the middle of a gesture too."""
        return self._document

    @property
    def saved_document(self) -> Document | None:
        """The document as it was last saved or opened; None where it never was."""
        return self._saved

    @property
    def is_modified(self) -> bool:
        """Whether closing now would lose something; a passing gesture is nothing to lose."""
        document = self.gesture_start if self.in_passing_gesture else self._document
        return document is not self._saved

    @property
    def in_gesture(self) -> bool:
        """Whether a gesture has begun and neither been committed nor cancelled."""
        return self._gesture is not None

    @property
    def in_passing_gesture(self) -> bool:
        """Whether the present gesture is one that leaves no trace."""
        return self._gesture is not None and self._passing

    @property
    def in_the_way(self) -> LocksInTheWay | None:
        """The locks that the last edit was stopped by, None where it was not."""
        return self._in_the_way

    @property
    def gesture_start(self) -> Document:
        """The document that edits of the present gesture start from."""
        return self._history[self._position].document

    @property
    def history(self) -> tuple[HistoryEntry, ...]:
        """All states from the first, which has no label, to the last that redo reaches."""
        return tuple(self._history)

    @property
    def position(self) -> int:
        """The index in :attr:`history` of the last committed state."""
        return self._position

    @property
    def undo_label(self) -> str | None:
        """The name of the step that undo would take back, None where there is none."""
        return self._history[self._position].label if self._position > 0 else None

    @property
    def redo_label(self) -> str | None:
        """The name of the step that redo would bring back, None where there is none."""
        following = self._position + 1
        return self._history[following].label if following < len(self._history) else None

    def subscribe(self, callback: Subscriber) -> Callable[[], None]:
        """Call ``callback(old, new)`` after every change; return what ends the subscription.

        ``old is new`` tells that only the history or the saved mark changed.
        """
        self._subscribers.append(callback)

        def unsubscribe() -> None:
            if callback in self._subscribers:
                self._subscribers.remove(callback)

        return unsubscribe

    def begin(self, label: str, *, passing: bool = False) -> None:
        """Begin a gesture. One that is still open is committed first, so no work is lost.

        A ``passing`` gesture only shows something: whatever ends it takes it back.
        """
        self.commit()
        self._keeper.begin()
        self._gesture, self._passing = label, passing
        self._in_the_way = None

    def apply(self, edit: Edit, *, settled: bool = False, refining: Refining | None = None) -> None:
        """Show ``edit`` applied to the document at the gesture's start.

        Each call starts afresh, so rounding never adds up. One that is ``settled`` keeps the locks
        itself: where they are measured to hold it is done as it is. ``refining`` goes on from what
        the locks have left. Where ``edit`` raises, the document stays as the last call left it.
        Raises RuntimeError outside a gesture and EditError where locks allow no part of it.
        """
        if self._gesture is None:
            raise RuntimeError("apply() needs a gesture: call begin() first")
        asked = edit(self.gesture_start)
        kept = self._keeper.keep(self.gesture_start, asked, settled=settled)
        self._asked, self._in_the_way = asked, kept.in_the_way
        self._asked_settled, self._refining = settled, refining
        document = kept.document
        if refining is not None:
            document = refining.after(self.gesture_start, document, final=False)
        self._show(document)

    def commit(self) -> None:
        """End the gesture and make one undo entry, none where nothing changed.

        A passing gesture is cancelled instead. Without a gesture this does nothing.
        """
        if self._gesture is None:
            return
        if self._passing:
            self.cancel()
            return
        self._settle()
        label, self._gesture = self._gesture, None
        start = self.gesture_start
        if self._document is start or self._document == start:
            # The very value of the start, so that an unmodified document stays unmodified.
            self._show(start)
            return
        del self._history[self._position + 1 :]
        self._history.append(HistoryEntry(label, self._document))
        self._position += 1
        self._notify(self._document)

    def _settle(self) -> EditError | None:
        """Set locks right by the body's own measures; what cannot be is not done at all."""
        start = self.gesture_start
        asked, self._asked = self._asked, None
        if asked is None or self._document is start:
            return None
        try:
            document = self._keeper.keep(
                start, asked, settle=True, settled=self._asked_settled
            ).document
            if self._refining is not None:
                refined = self._refining.after(start, document, final=True)
                document = self._keeper.keep(start, refined, settle=True, hand=False).document
        except EditError as error:
            self._show(start)
            return error
        self._show(document)
        return None

    def cancel(self) -> None:
        """End the gesture and go back to its start. Without a gesture this does nothing."""
        if self._gesture is not None:
            self._gesture = self._in_the_way = None
            self._show(self.gesture_start)

    def do(self, label: str, edit: Edit) -> None:
        """Apply one edit as a gesture of its own; where it raises, nothing has changed."""
        self.begin(label)
        try:
            self.apply(edit)
            error = self._settle()
            if error is not None:
                raise error
        except BaseException:
            self.cancel()
            raise
        self.commit()

    def undo(self) -> bool:
        """Go one step back, after committing an open gesture; return whether there was one."""
        self.commit()
        return self._go(self._position - 1)

    def redo(self) -> bool:
        """Go one step forward again, after committing an open gesture."""
        self.commit()
        return self._go(self._position + 1)

    def jump_to(self, index: int) -> None:
        """Go to a state of :attr:`history`. Raises IndexError where there is no such state."""
        self.commit()
        if not self._go(index):
            raise IndexError(f"history has states 0 to {len(self._history) - 1}, not {index}")

    def mark_saved(self, document: Document | None = None) -> None:
        """Remember ``document``, by default the present one, as the one on disk."""
        self._saved = self._document if document is None else document
        self._notify(self._document)

    def replace(self, document: Document, *, saved: bool = True) -> None:
        """Start afresh with another document: an open gesture and the history are dropped."""
        old = self._document
        self._gesture = None
        self._document = document
        self._saved = document if saved else None
        self._history = [HistoryEntry("", document)]
        self._position = 0
        self._notify(old)

    def _go(self, position: int) -> bool:
        if not 0 <= position < len(self._history):
            return False
        self._position, self._in_the_way = position, None
        old, self._document = self._document, self._history[position].document
        self._notify(old)
        return True

    def _show(self, document: Document) -> None:
        old, self._document = self._document, document
        if document is not old:
            self._notify(old)

    def _notify(self, old: Document) -> None:
        for callback in tuple(self._subscribers):
            callback(old, self._document)
