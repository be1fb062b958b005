"""What the parts of the look panel share: rows of a form that edit the appearance."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from functools import partial
from typing import Any

from PySide6.QtCore import QSignalBlocker
from PySide6.QtGui import QIcon
from PySide6.QtWidgets import QCheckBox, QFormLayout, QLabel, QSizePolicy, QWidget

from app.state.number_edits import NumberEdits, Span
from app.state.presenter import Edit, Presenter
from app.widgets.colour_button import ColourButton
from app.widgets.combo_box import QuietComboBox
from app.widgets.number_field import NumberField, Reset
from app.widgets.number_kind import limits
from sgb_core.document import edits
from sgb_core.document.appearance.model import Appearance
from sgb_core.document.model import Document
from sgb_core.fields.kinds import FINITE, Kind

# The appearance with a value set somewhere in it.
Change = Callable[[Appearance, Any], Appearance]


class LookForm(QWidget):
    """A form whose rows each change the document's appearance, one undo entry a gesture."""

    def __init__(self, presenter: Presenter, title: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.presenter = presenter
        self._edits = NumberEdits(presenter, self)
        self._gesture = self._edits.gesture
        self.form = QFormLayout(self)
        self.form.setContentsMargins(0, 0, 0, 6)
        self.form.setHorizontalSpacing(8)
        self.form.setVerticalSpacing(6)
        heading = QLabel(title, self)
        heading.setProperty("role", "heading")
        self.form.addRow(heading)

    @property
    def appearance(self) -> Appearance:
        """The present appearance."""
        return self.presenter.document.appearance

    def do(self, label: str, change: Callable[[Appearance], Appearance]) -> None:
        """Change the appearance as one undo entry."""
        self.presenter.do(
            label, lambda document: edits.replace_appearance(document, change(document.appearance))
        )

    def combo(
        self,
        name: str,
        entries: Iterable[tuple[str, Any]],
        chosen: Callable[[Any], object],
        tip: str,
        swatch: Callable[[Any], QIcon] | None = None,
    ) -> QuietComboBox:
        """Add a row to choose from (text, value) pairs; ``swatch`` draws a value."""
        box = QuietComboBox(self)
        for text, value in entries:
            if swatch is None:
                box.addItem(text, value)
            else:
                box.addItem(swatch(value), text, value)
        box.setAccessibleName(name)
        box.setToolTip(tip)
        box.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        box.setMinimumContentsLength(8)
        box.activated.connect(lambda index: chosen(box.itemData(index)))
        self.form.addRow(name, box)
        return box

    def check(self, text: str, change: Change, tip: str) -> QCheckBox:
        """Add a row for a field that is true or false."""
        box = QCheckBox(text, self)
        box.setToolTip(tip)
        box.clicked.connect(lambda on: self.do(text, lambda look: change(look, on)))
        self.form.addRow("", box)
        return box

    def number(
        self,
        name: str,
        change: Change,
        tip: str,
        *,
        reset: Reset,
        span: tuple[float, float] | Span,
        allowed: Kind = FINITE,
        scale: float = 1.0,
        step: float = 1.0,
        unit: str = "",
        to_all: Change | None = None,
    ) -> NumberField:
        """Add a row for a number; ``change`` sets it where it belongs, ``to_all`` everywhere.

        The field shows ``scale`` times what is ``allowed``, in a ``unit``; an animation passes
        through ``span``.
        """
        field = NumberField(**limits(allowed, scale), step=step, reset=reset, parent=self)
        field.setAccessibleName(name)
        field.set_suffix(unit)
        field.set_help(tip)
        field.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        passed = span if callable(span) else lambda: span
        self._edits.connect(field, name, self._edit_for(change), passed)
        if to_all is not None:
            field.offer(
                "Apply to all",
                lambda: self.do(f"{name} of all", lambda look: to_all(look, field.value)),
            )
        self.form.addRow(name, field)
        field.take_label(self.form.labelForField(field))
        return field

    def colour(self, name: str, change: Change) -> ColourButton:
        """Add a row for a colour."""
        button = ColourButton(name, self)
        button.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        self._edits.connect(button, name, self._edit_for(change))
        self.form.addRow(name, button)
        return button

    def _edit_for(self, change: Change) -> Callable[[Any], Edit]:
        return lambda value: partial(_changed, change, value)


def _changed(change: Change, value: Any, document: Document) -> Document:
    return edits.replace_appearance(document, change(document.appearance, value))


def show_choice(box: QuietComboBox, value: Any) -> None:
    """Let a combo box show a value, without a signal."""
    with QSignalBlocker(box):
        box.setCurrentIndex(max(0, box.findData(value)))


def show_depths(
    document: Document, relief: NumberField, depth: float, edge: NumberField, width: float
) -> None:
    """Let two fields show the depth of a relief and the width of its edge, in the unit."""
    for field, value in ((relief, depth), (edge, width)):
        field.set_suffix(document.unit.value)
        field.set_value(value)
