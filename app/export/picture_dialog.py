"""Asks how large a picture of the viewport is to be, and whether its ground is transparent."""

from __future__ import annotations

from PySide6.QtWidgets import (
    QCheckBox,
    QDialog,
    QDialogButtonBox,
    QFormLayout,
    QVBoxLayout,
    QWidget,
)

from app.scene.standard_views import LARGEST_PICTURE
from app.widgets.labels import take_labels
from app.widgets.pixel_size import PixelSize


class PictureDialog(QDialog):
    """Size in pixels and ground of a picture; the caller draws it."""

    def __init__(self, viewport: tuple[int, int], parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setWindowTitle("Picture")
        width, height = viewport
        common = (
            ("As on screen", (width, height)),
            ("Twice the screen", (2 * width, 2 * height)),
            ("Four times the screen", (4 * width, 4 * height)),
            ("Full HD", (1920, 1080)),
            ("4K", (3840, 2160)),
            ("Square", (2000, 2000)),
        )
        form = QFormLayout()
        self._size = PixelSize(form, common, LARGEST_PICTURE)
        self._transparent = QCheckBox("Transparent ground")
        self._transparent.setToolTip("Leave out the background, for putting on a page")
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

    @property
    def size_in_pixels(self) -> tuple[int, int]:
        """The chosen (width, height)."""
        return self._size.value

    @property
    def transparent(self) -> bool:
        """Whether the ground is left out."""
        return self._transparent.isChecked()

    def _choose_clipboard(self) -> None:
        self.to_clipboard = True
        self.accept()
