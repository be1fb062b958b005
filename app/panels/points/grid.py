"""The cells of the points table: how keys walk them, how wide they are and what is copied."""

from __future__ import annotations

from PySide6.QtCore import QModelIndex, QPoint, Qt, Signal
from PySide6.QtGui import QContextMenuEvent, QGuiApplication, QKeyEvent, QKeySequence
from PySide6.QtWidgets import QAbstractItemView, QTableView, QWidget

SEGMENT, POINT, RADIUS, HEIGHT = range(4)
# So many rows from either end have all kinds of names, and the longest numbers.
_WIDEST = 8


class PointGrid(QTableView):
    """A table in which Tab walks from coordinate to coordinate, and on after the last."""

    menu_wanted = Signal(QModelIndex, QPoint)

    def sizeHintForColumn(self, column: int) -> int:
        """Return the width of the widest name: such stand at the beginning and the end."""
        model = self.model()
        count = model.rowCount()
        rows = {*range(min(_WIDEST, count)), *range(max(count - _WIDEST, 0), count)}
        hints = [self.sizeHintForIndex(model.index(row, column)).width() for row in rows]
        return max(hints, default=0)

    def moveCursor(
        self, action: QAbstractItemView.CursorAction, modifiers: Qt.KeyboardModifier
    ) -> QModelIndex:
        steps = {
            QAbstractItemView.CursorAction.MoveNext: 1,
            QAbstractItemView.CursorAction.MovePrevious: -1,
        }
        index = self.currentIndex()
        if action not in steps or not index.isValid():
            return super().moveCursor(action, modifiers)
        cell = 2 * index.row() + max(index.column() - RADIUS, 0) + steps[action]
        if index.column() < RADIUS and steps[action] > 0:
            cell -= 1
        row, column = divmod(cell, 2)
        # Beyond the first and the last there is none: an invalid index.
        return self.model().index(row, RADIUS + column)

    def focusNextPrevChild(self, forward: bool) -> bool:
        way = self.CursorAction.MoveNext if forward else self.CursorAction.MovePrevious
        there = self.moveCursor(way, Qt.KeyboardModifier.NoModifier)
        if not there.isValid():
            return QWidget.focusNextPrevChild(self, forward)
        self.setCurrentIndex(there)
        return True

    def contextMenuEvent(self, event: QContextMenuEvent) -> None:
        keyboard = event.reason() == QContextMenuEvent.Reason.Keyboard
        index = self.currentIndex() if keyboard else self.indexAt(event.pos())
        self.menu_wanted.emit(index, event.globalPos())

    def keyPressEvent(self, event: QKeyEvent) -> None:
        enter = event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter)
        editing = self.state() == QAbstractItemView.State.EditingState
        if event.matches(QKeySequence.StandardKey.Copy):
            self._copy()
        elif enter and not editing:
            self.edit(self.currentIndex())
        else:
            super().keyPressEvent(event)

    def _copy(self) -> None:
        """Copy the selected points as lines of r, tab, h with every digit."""
        rows = sorted(index.row() for index in self.selectionModel().selectedRows())
        model = self.model()
        lines = [
            "\t".join(
                str(model.index(row, column).data(Qt.ItemDataRole.EditRole))
                for column in (RADIUS, HEIGHT)
            )
            for row in rows
        ]
        QGuiApplication.clipboard().setText("\n".join(lines))
