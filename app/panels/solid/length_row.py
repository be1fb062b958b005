"""Rows for the lengths of a record: a slider that reaches as far as suits the object."""

from __future__ import annotations

from collections.abc import Iterable

from PySide6.QtWidgets import QWidget

from app.widgets.slider_row import SliderRow
from sgb_core.fields.kinds import Range
from sgb_core.fields.record import Row


def length_row(length: Row, parent: QWidget) -> SliderRow:
    """Return the row of a length, named and explained; it resets to the default of its record."""
    allowed = length.kind
    assert isinstance(allowed, Range)
    assert isinstance(length.default, float)
    row = SliderRow(
        length.label,
        0.0,
        10.0,
        length.default,
        0.1,
        unit="mm",
        typed=(allowed.low, allowed.high),
        above_low=allowed.above >= allowed.low,
        parent=parent,
    )
    row.set_help(length.tip)
    row.set_name(length.label)
    return row


def align(rows: Iterable[SliderRow]) -> None:
    """Give the labels of rows one width."""
    rows = tuple(rows)
    width = max(row.label.sizeHint().width() for row in rows) + 4
    for row in rows:
        row.label.setMinimumWidth(width)


def set_reach(row: SliderRow, high: float) -> None:
    """Let a slider reach to ``high``: a hundredth of it a step, a drag ten times finer."""
    row.slider.set_limits(0.0, high, high / 100.0, high / 1000.0)
    row.field.set_step(high / 100.0)
