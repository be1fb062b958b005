"""Ties number fields to the document: a gesture each, and what their menus offer beyond it."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from types import MappingProxyType

from PySide6.QtWidgets import QWidget

from app.state.edit_gesture import EditGesture
from app.state.parameter_animation import Sway
from app.state.presenter import Edit, Presenter
from app.widgets.colour_button import ColourButton
from app.widgets.number_field import NumberField
from app.widgets.slider_row import SliderRow
from sgb_core.curves.segment import ParameterName
from sgb_core.document.model import Document

Part = NumberField | SliderRow | ColourButton
Span = Callable[[], tuple[float, float]]

# One notch of the wheel or one arrow key.
PARAMETER_STEPS: Mapping[ParameterName, float] = MappingProxyType(
    {"lambda1": 0.1, "lambda2": 0.1, "lambda3": 0.1, "omega": 0.02}
)


class NumberEdits:
    """The fields of one panel; ``show`` lets it show the document's numbers again."""

    def __init__(
        self, presenter: Presenter, owner: QWidget, show: Callable[[], object] | None = None
    ) -> None:
        self._presenter = presenter
        self._show = show or (lambda: None)
        self.gesture = EditGesture(presenter)
        self.sway = Sway(presenter, owner)

    @property
    def origin(self) -> Document:
        """The document as last saved or opened: what sizes without a neutral value reset to."""
        session = self._presenter.session
        return session.saved_document or session.history[0].document

    def connect(
        self,
        part: Part,
        label: str,
        edit_for: Callable[..., Edit],
        span: Span | None = None,
    ) -> None:
        """Let ``part`` do the edit of its value as gestures called ``label``.

        Where there is a ``span`` its menu offers to animate: the edits of all values between.
        """
        part.began.connect(lambda: self.gesture.begin(label))
        part.changed.connect(lambda value: self._changed(edit_for(value)))
        part.ended.connect(self._ended)
        part.cancelled.connect(self._cancelled)
        if not isinstance(part, ColourButton):
            part.refused.connect(lambda text: self._presenter.notify(f"{label}: {text}", "warning"))
            if span is not None:
                part.offer("Animate", lambda: self.sway.start(label, *span(), edit_for))

    def _changed(self, edit: Edit) -> None:
        if not self.gesture.apply(edit):
            self._show()

    def _ended(self) -> None:
        self.gesture.commit()
        self._show()

    def _cancelled(self) -> None:
        self.gesture.cancel()
        self._show()


def around(field: NumberField) -> Span:
    """Return the span from half of what a field shows to half as much again."""
    return lambda: (0.5 * field.value, 1.5 * field.value)
