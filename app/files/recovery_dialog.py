"""Offers unsaved work that crashes left: each with its picture, time and number of steps."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from datetime import datetime

from PySide6.QtCore import QSize, Qt
from PySide6.QtGui import QIcon
from PySide6.QtWidgets import (
    QDialog,
    QHBoxLayout,
    QLabel,
    QListWidget,
    QListWidgetItem,
    QPushButton,
    QVBoxLayout,
    QWidget,
)

from app.files.silhouette import SIDE, silhouette
from sgb_core.document.file.recovery import Recoverable

Chosen = Callable[[Sequence[Recoverable]], object]


def title(item: Recoverable) -> str:
    """Return what unsaved work is called: as its file, or as its document."""
    return item.target.stem if item.target else item.document.name


def described(item: Recoverable) -> str:
    """Return what tells one piece of work from another, in two lines."""
    when = datetime.fromtimestamp(item.seconds).strftime("%d %b %Y, %H:%M:%S")
    count = "1 gesture" if item.steps == 1 else f"{item.steps} gestures"
    return f"{title(item)}: {when}, {count}\n{item.target or 'never saved'}"


class RecoveryDialog(QDialog):
    """What is checked is restored or thrown away; whatever is not decided on stays kept."""

    def __init__(
        self, items: Sequence[Recoverable], restore: Chosen, throw_away: Chosen, parent: QWidget
    ) -> None:
        super().__init__(parent)
        self.setWindowTitle("Unsaved work")
        self.setModal(False)
        self._items = items
        intro = QLabel("This work was not saved when the program last ended.", self)
        intro.setWordWrap(True)
        self.list = QListWidget(self)
        self.list.setAccessibleName("Unsaved work")
        self.list.setToolTip("Space checks or unchecks a piece of work")
        self.list.setIconSize(QSize(SIDE, SIDE))
        for item in items:
            entry = QListWidgetItem(QIcon(silhouette(item.document)), described(item), self.list)
            entry.setFlags(entry.flags() | Qt.ItemFlag.ItemIsUserCheckable)
            entry.setCheckState(Qt.CheckState.Checked)
        self.list.setCurrentRow(0)
        self.restore_button = self._button(
            "Restore", "Show what is checked again, each in a window of its own", restore
        )
        self.keep_button = self._button(
            "Keep for later", "Decide at the next start (Esc)", lambda _items: None
        )
        self.throw_button = self._button(
            "Throw away", "Forget what is checked for good", throw_away
        )
        self.restore_button.setDefault(True)
        row = QHBoxLayout()
        row.addWidget(self.throw_button)
        row.addStretch(1)
        row.addWidget(self.keep_button)
        row.addWidget(self.restore_button)
        layout = QVBoxLayout(self)
        layout.addWidget(intro)
        layout.addWidget(self.list, 1)
        layout.addLayout(row)
        self.resize(560, min(560, 170 + len(items) * (SIDE + 8)))

    def _button(self, text: str, tip: str, action: Chosen) -> QPushButton:
        button = QPushButton(text, self)
        button.setToolTip(tip)
        button.setAutoDefault(False)
        button.clicked.connect(lambda: self._end(action))
        return button

    def _end(self, action: Chosen) -> None:
        checked = [
            item
            for row, item in enumerate(self._items)
            if self.list.item(row).checkState() is Qt.CheckState.Checked
        ]
        self.close()
        action(checked)
