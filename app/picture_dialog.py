"""Asks how large a picture of the viewport is to be, and whether its ground is transparent."""

from __future__ import annotations

from PySide6.QtWidgets import (
    QCheckBox,
    QComboBox,
    QDialog,
    QDialogButtonBox,
    QFormLayout,
    QVBoxLayout,
    QWidget,
)

from app.number_edits import take_labels
from app.number_field import NumberField

SMALLEST, LARGEST = 16, 8192


class PictureDialog(QDialog):
    """Size in pixels and ground of a picture; the caller draws it."""

    def __init__(self, viewport: tuple[int, int], parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setWindowTitle("Picture")
        self._preset = QComboBox()
        self._preset.setAccessibleName("Size")
        self._preset.setToolTip("Common sizes")
        width, height = viewport
        for text, size in (
            ("As on screen", (width, height)),
            ("Twice the screen", (2 * width, 2 * height)),
            ("Four times the screen", (4 * width, 4 * height)),
            ("Full HD", (1920, 1080)),
            ("4K", (3840, 2160)),
            ("Square", (2000, 2000)),
        ):
            self._preset.addItem(f"{text}  ({size[0]} × {size[1]})", size)
        self._width = _pixels(width, "Width in pixels")
        self._height = _pixels(height, "Height in pixels")
        self._transparent = QCheckBox("Transparent ground")
        self._transparent.setToolTip("Leave out the background, for putting on a page")
        form = QFormLayout()
        form.addRow("Size", self._preset)
        form.addRow("Width", self._width)
        form.addRow("Height", self._height)
        form.addRow("", self._transparent)
        buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Cancel)
        buttons.addButton("Save…", QDialogButtonBox.ButtonRole.AcceptRole)
        copy = buttons.addButton("Copy to clipboard", QDialogButtonBox.ButtonRole.ActionRole)
        copy.clicked.connect(self._choose_clipboard)
        buttons.accepted.connect(self.accept)
        buttons.rejected.connect(self.reject)
        layout = QVBoxLayout(self)
        layout.addLayout(form)
        layout.addStretch(1)
        layout.addWidget(buttons)
        take_labels(self)
        self.to_clipboard = False
        self._preset.currentIndexChanged.connect(self._take_preset)

    @property
    def size_in_pixels(self) -> tuple[int, int]:
        """The chosen (width, height)."""
        return round(self._width.value), round(self._height.value)

    @property
    def transparent(self) -> bool:
        """Whether the ground is left out."""
        return self._transparent.isChecked()

    def _take_preset(self) -> None:
        width, height = self._preset.currentData()
        self._width.set_value(min(width, LARGEST))
        self._height.set_value(min(height, LARGEST))

    def _choose_clipboard(self) -> None:
        self.to_clipboard = True
        self.accept()


def _pixels(value: int, name: str) -> NumberField:
    field = NumberField(
        minimum=SMALLEST, maximum=LARGEST, step=10.0, whole=True, reset=min(value, LARGEST)
    )
    field.setAccessibleName(name)
    field.set_help(name)
    return field
