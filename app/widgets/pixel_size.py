"""The rows of a form that ask how many pixels wide and high a picture is to be."""

from __future__ import annotations

from collections.abc import Iterable

from PySide6.QtCore import QSignalBlocker
from PySide6.QtWidgets import QComboBox, QFormLayout

from app.widgets.number_field import NumberField

SMALLEST = 16


class PixelSize:
    """Common sizes to choose from, and a width and a height of one's own beside them."""

    def __init__(
        self, form: QFormLayout, common: Iterable[tuple[str, tuple[int, int]]], largest: int
    ) -> None:
        self.common = QComboBox()
        self.common.setAccessibleName("Size")
        self.common.setToolTip("Common sizes")
        self.common.addItem("Free", None)
        for text, size in common:
            width, height = (min(side, largest) for side in size)
            self.common.addItem(f"{text}  ({width} × {height})", (width, height))
        self.common.setCurrentIndex(1)
        width, height = self.common.currentData()
        self.width = _pixels("Width in pixels", width, largest)
        self.height = _pixels("Height in pixels", height, largest)
        form.addRow("Size", self.common)
        form.addRow("Width", self.width)
        form.addRow("Height", self.height)
        self.common.currentIndexChanged.connect(self._take)
        for field in (self.width, self.height):
            field.changed.connect(self._show)

    @property
    def value(self) -> tuple[int, int]:
        """The chosen (width, height)."""
        return round(self.width.value), round(self.height.value)

    def _take(self) -> None:
        size = self.common.currentData()
        if size is not None:
            for field, side in zip((self.width, self.height), size, strict=True):
                field.set_value(side)

    def _show(self) -> None:
        with QSignalBlocker(self.common):
            known = [self.common.itemData(k) for k in range(self.common.count())]
            self.common.setCurrentIndex(known.index(self.value) if self.value in known else 0)


def _pixels(name: str, value: int, largest: int) -> NumberField:
    field = NumberField(minimum=SMALLEST, maximum=largest, step=10.0, whole=True, reset=value)
    field.setAccessibleName(name)
    field.set_help(name)
    return field
