"""The undo history as a list: every step by its name, a click goes there."""

from __future__ import annotations

from itertools import pairwise

from PySide6.QtCore import QSignalBlocker, Qt
from PySide6.QtGui import QColor
from PySide6.QtWidgets import QListWidget, QVBoxLayout, QWidget

from app.state.presenter import Frame, Presenter
from app.state.step_words import step_words
from app.theme import theme
from app.widgets.empty_hint import EmptyHint


class HistoryPanel(QWidget):
    """All states that undo and redo reach; those that redo would bring back are greyed."""

    def __init__(self, presenter: Presenter, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._presenter = presenter
        self._shown: tuple[object, ...] = ()
        self.list = QListWidget(self)
        self.list.setAccessibleName("Undo history")
        self.list.setToolTip("Click a step to go back to what followed it, or forward again")
        layout = QVBoxLayout(self)
        layout.setContentsMargins(8, 6, 8, 8)
        self.empty = EmptyHint(
            "undo",
            "What you change is listed here step by step; a click on a step goes back to it.",
        )
        layout.addWidget(self.list)
        layout.addWidget(self.empty, 1)
        # Keys walk as clicks do: whatever becomes the current line is gone to.
        self.list.currentRowChanged.connect(self._go)
        theme.notifier().changed.connect(self._recolour)

    def refresh(self, frame: Frame) -> None:
        """Show the history as it is now; nothing changes while a gesture is under way."""
        if frame.dragging:
            return
        session = self._presenter.session
        history = session.history
        with QSignalBlocker(self.list):
            if self._shown != history:
                self._fill()
                self._shown = history
            self.list.setCurrentRow(session.position)
        self.list.setVisible(len(history) > 1)
        self.empty.setVisible(len(history) == 1)
        self._recolour()

    def _fill(self) -> None:
        session = self._presenter.session
        history, same = session.history, 0
        while same < min(len(history), self.list.count()):
            if history[same] is not self._shown[same]:
                break
            same += 1
        while self.list.count() > same:
            self.list.takeItem(self.list.count() - 1)
        first = ["As opened"] if same == 0 else []
        steps = pairwise(history[max(same - 1, 0) :])
        self.list.addItems([*first, *(step_words(old, new) for old, new in steps)])

    def _recolour(self, _palette: object = None) -> None:
        position, palette = self._presenter.session.position, theme.current()
        for row in range(self.list.count()):
            item, undone = self.list.item(row), row > position
            item.setForeground(QColor(palette.text_muted if undone else palette.text))
            font = item.font()
            # Not by colour alone.
            font.setItalic(undone)
            item.setFont(font)
            what = "Go forward to here (undone)" if undone else "Go back to here"
            item.setToolTip("You are here" if row == position else what)
            item.setData(Qt.ItemDataRole.AccessibleDescriptionRole, item.toolTip())

    def _go(self, row: int) -> None:
        if 0 <= row < len(self._presenter.session.history):
            self._presenter.session.jump_to(row)
