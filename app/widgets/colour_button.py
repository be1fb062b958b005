"""A button that shows a colour and lets another be chosen, seen at once in the picture."""

from __future__ import annotations

from PySide6.QtCore import Signal
from PySide6.QtGui import QColor, QIcon, QPixmap
from PySide6.QtWidgets import QColorDialog, QToolButton, QWidget

SWATCH = 16


class ColourButton(QToolButton):
    """While one chooses: ``began``, ``changed`` with #rrggbb; then ``ended`` or ``cancelled``."""

    began = Signal()
    changed = Signal(str)
    ended = Signal()
    cancelled = Signal()

    def __init__(self, name: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setAccessibleName(name)
        self.setToolTip(f"{name}: choose")
        self.setProperty("segment", "only")
        self.colour = ""
        self._dialog: QColorDialog | None = None
        self.clicked.connect(self.choose)

    def set_colour(self, colour: str) -> None:
        """Show a colour; emits nothing."""
        # An icon that is set anew, even the same one, lays out the whole window.
        if colour == self.colour:
            return
        self.colour = colour
        swatch = QPixmap(SWATCH, SWATCH)
        swatch.fill(QColor(colour))
        self.setIcon(QIcon(swatch))

    def choose(self) -> None:
        """Open the chooser beside the window; the window stays usable."""
        if self._dialog is not None:
            self._dialog.raise_()
            return
        dialog = QColorDialog(QColor(self.colour), self)
        dialog.setWindowTitle(self.accessibleName())
        dialog.setOption(QColorDialog.ColorDialogOption.DontUseNativeDialog)
        dialog.currentColorChanged.connect(self._take)
        dialog.finished.connect(self._finish)
        self._dialog = dialog
        self.began.emit()
        dialog.show()

    def _take(self, colour: QColor) -> None:
        self.set_colour(colour.name())
        self.changed.emit(colour.name())

    def _finish(self, accepted: int) -> None:
        dialog, self._dialog = self._dialog, None
        (self.ended if accepted else self.cancelled).emit()
        if dialog is not None:
            dialog.deleteLater()
