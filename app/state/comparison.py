"""What the present document is laid over: saved, plain cubic, another's, a named state."""

from __future__ import annotations

from app.state.unforeseen import tell
from app.state.view_state import ViewState
from sgb_core.document.edits.compare import at_true_size, plain_cubic
from sgb_core.document.edits.states import state_in_unit
from sgb_core.document.evaluation import Evaluation, evaluate
from sgb_core.document.model import Document
from sgb_core.document.session import Session


class Comparison:
    """Evaluates the other state, and keeps it while what it follows from is the same."""

    def __init__(self) -> None:
        self._key: tuple[object, ...] = ()
        self._evaluation: Evaluation | None = None

    def evaluation(self, session: Session, view: ViewState) -> Evaluation | None:
        """Return the state to compare with, None where there is none."""
        document, saved = session.document, session.saved_document
        if view.before is not None:
            key: tuple[object, ...] = ("before", view.before)
        elif view.ghost is not None:
            key = (view.ghost, document.unit)
        elif view.ghost_state is not None:
            key = (view.ghost_state, document.states, document.unit)
        elif view.compare == "saved" and saved is not None:
            key = ("saved", saved, document.unit)
        elif view.compare == "cubic":
            key = ("cubic", document)
        else:
            key = ()
        if len(key) != len(self._key) or any(
            a is not b for a, b in zip(key, self._key, strict=True)
        ):
            self._key = key
            last, self._evaluation = self._evaluation, None
            try:
                other = _other(document, saved, view) if key else None
                self._evaluation = None if other is None else evaluate(other, last)
            except Exception as error:
                # Without the ghost the document itself is shown all the same.
                tell(error)
        return self._evaluation


def _other(document: Document, saved: Document | None, view: ViewState) -> Document | None:
    if view.before is not None:
        return view.before
    if view.ghost is not None:
        return at_true_size(view.ghost, document)
    if view.ghost_state is not None:
        names = [state.name for state in document.states]
        return state_in_unit(document, view.ghost_state) if view.ghost_state in names else None
    if view.compare == "cubic":
        return plain_cubic(document)
    return None if saved is None else at_true_size(saved, document)
