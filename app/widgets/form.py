"""Forms as tables: each row says what it is called, what it holds and what that is for."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TypeVar

from PySide6.QtWidgets import QComboBox, QFormLayout, QLayout, QWidget

from app.widgets.number_field import NumberField
from sgb_core.values import dataclass

Control = TypeVar("Control", bound=QWidget)
Box = TypeVar("Box", bound=QComboBox)


@dataclass(frozen=True, slots=True)
class Row:
    """One line of a form: a label, and a control or several in a layout of their own.

    ``tip`` is the control's tooltip and ``name`` what assistive technology calls it, by default
    the label. A control without a tip keeps the name and the tooltip that it has.
    """

    label: str | QWidget
    control: QWidget | QLayout
    tip: str = ""
    name: str | None = None


def add_rows(form: QFormLayout, rows: Iterable[Row]) -> None:
    """Put rows at the end of a form."""
    for row in rows:
        if row.tip and isinstance(row.control, QWidget):
            label = row.label if isinstance(row.label, str) else ""
            named(row.control, label if row.name is None else row.name, row.tip)
        form.addRow(row.label, row.control)


def named(control: Control, name: str, tip: str) -> Control:
    """Return a control that tells its name and, in a tooltip, what it is for."""
    control.setAccessibleName(name)
    if isinstance(control, NumberField):
        control.set_help(tip)
    else:
        control.setToolTip(tip)
    return control


def offering(box: Box, entries: Iterable[tuple[str, object]]) -> Box:
    """Return a box to choose from these pairs of words and value."""
    for text, value in entries:
        box.addItem(text, value)
    return box
