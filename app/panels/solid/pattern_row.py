"""Which of several patterns of holes is edited, and a button for another one."""

from __future__ import annotations

from collections.abc import Sequence

from PySide6.QtCore import QSignalBlocker, Signal
from PySide6.QtWidgets import QHBoxLayout, QSizePolicy, QToolButton, QWidget

from app.theme import icons
from app.widgets.combo_box import QuietComboBox
from sgb_core.bodies.cut_outs import MOST_PATTERNS


class PatternRow(QWidget):
    """A list of patterns and a plus; there where there is any pattern."""

    chosen = Signal(int)
    added = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        layout = QHBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        self.which = QuietComboBox(self)
        self.which.setAccessibleName("Pattern of holes")
        self.which.setToolTip("Which pattern of holes is edited below; None removes it")
        self.which.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        self.which.activated.connect(self.chosen)
        self.more = QToolButton(self)
        icons.bind(self.more, "segment-append")
        self.more.setAccessibleName("Another pattern of holes")
        self.more.setToolTip("Cut another pattern of holes beside those there are")
        self.more.clicked.connect(lambda: self.added.emit())
        layout.addWidget(self.which, 1)
        layout.addWidget(self.more)

    def show_patterns(self, titles: Sequence[str], number: int) -> None:
        """Show what the patterns are, with the one of a number chosen."""
        self.setVisible(bool(titles))
        texts = [f"{k + 1} · {title}" for k, title in enumerate(titles)]
        with QSignalBlocker(self.which):
            if texts != [self.which.itemText(k) for k in range(self.which.count())]:
                self.which.clear()
                self.which.addItems(texts)
            self.which.setCurrentIndex(number)
        self.more.setEnabled(len(titles) < MOST_PATTERNS)
