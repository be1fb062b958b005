"""A combo box that a scrolling wheel passes by."""

from __future__ import annotations

from PySide6.QtGui import QWheelEvent
from PySide6.QtWidgets import QComboBox


class QuietComboBox(QComboBox):
    """Changes by click and key only: in a panel that scrolls, the wheel belongs to the panel."""

    def wheelEvent(self, event: QWheelEvent) -> None:
        event.ignore()
