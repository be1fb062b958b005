"""Ties labels to the fields they name."""

from __future__ import annotations

from PySide6.QtWidgets import QLabel, QWidget

from app.widgets.number_field import NumberField


def take_labels(holder: QWidget) -> None:
    """Join each number field in ``holder`` with the label whose buddy it is."""
    for label in holder.findChildren(QLabel):
        field = label.buddy()
        if isinstance(field, NumberField):
            field.take_label(label)
