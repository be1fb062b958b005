"""The keys of all actions in one list: change, take away, give back; conflicts are shown."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import QSignalBlocker, Qt
from PySide6.QtGui import QColor, QKeySequence
from PySide6.QtWidgets import (
    QHBoxLayout,
    QKeySequenceEdit,
    QLabel,
    QLineEdit,
    QPushButton,
    QTreeWidget,
    QTreeWidgetItem,
    QVBoxLayout,
    QWidget,
)

from app.commands.command import CommandSet
from app.commands.fuzzy_match import score
from app.settings.shortcuts import Keys
from app.theme import theme

_NAME = Qt.ItemDataRole.UserRole


class KeyEditor(QWidget):
    """Applies at once; ``changed`` lets other windows follow."""

    def __init__(
        self,
        commands: CommandSet,
        keys: Keys,
        changed: Callable[[], object],
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(parent)
        self._commands = commands
        self._keys = keys
        self._changed = changed
        self.search = QLineEdit(self)
        self.search.setPlaceholderText("Search actions")
        self.search.setAccessibleName("Search actions")
        self.search.setToolTip("A few letters of an action's name")
        self.search.setClearButtonEnabled(True)
        self.search.textChanged.connect(self._narrow)
        self.list = QTreeWidget(self)
        self.list.setAccessibleName("Actions and their keys")
        self.list.setToolTip("Choose an action, then press its new key below")
        self.list.setHeaderLabels(["Action", "Key", ""])
        self.list.setRootIsDecorated(False)
        self.list.setUniformRowHeights(True)
        self.list.currentItemChanged.connect(lambda _new, _old: self._show_current())
        self.edit = QKeySequenceEdit(self)
        self.edit.setMaximumSequenceLength(1)
        self.edit.setAccessibleName("New key")
        self.edit.setToolTip("Press the key for the chosen action")
        self.edit.editingFinished.connect(self._take)
        self.clear_button = self._button("No key", "Take the key away", self._clear)
        self.reset_button = self._button("Reset", "Give back the key it came with", self._reset)
        self.reset_all_button = self._button(
            "Reset all", "Give all actions the keys they came with", self._reset_all
        )
        self.conflict = QLabel(self)
        self.conflict.setProperty("role", "warning")
        self.conflict.setWordWrap(True)
        row = QHBoxLayout()
        row.addWidget(QLabel("New key", self))
        row.addWidget(self.edit, 1)
        for button in (self.clear_button, self.reset_button, self.reset_all_button):
            row.addWidget(button)
        layout = QVBoxLayout(self)
        layout.addWidget(self.search)
        layout.addWidget(self.list, 1)
        layout.addLayout(row)
        layout.addWidget(self.conflict)
        for name in commands.actions:
            item = QTreeWidgetItem(self.list, [commands.words(name).rstrip("…"), "", ""])
            item.setData(0, _NAME, name)
        self.refresh()
        self.list.setCurrentItem(self._items()[0])
        for column in (0, 1):
            self.list.resizeColumnToContents(column)

    @property
    def chosen(self) -> str | None:
        """The name of the chosen action."""
        item = self.list.currentItem()
        return None if item is None else item.data(0, _NAME)

    def choose(self, name: str) -> None:
        """Choose an action by its name."""
        for item in self._items():
            if item.data(0, _NAME) == name:
                self.list.setCurrentItem(item)

    def refresh(self) -> None:
        """Show all keys as they are now."""
        palette = theme.current()
        for item in self._items():
            name = item.data(0, _NAME)
            item.setText(1, self._keys.text(name))
            clash = self._keys.sharing(name)
            words = ["⚠ used twice"] if clash else []
            words += ["changed"] if self._keys.is_own(name) else []
            item.setText(2, ", ".join(words))
            item.setForeground(2, QColor(palette.warning if clash else palette.text_muted))
        self._show_current()

    def _items(self) -> list[QTreeWidgetItem]:
        rows = map(self.list.topLevelItem, range(self.list.topLevelItemCount()))
        return [item for item in rows if item is not None]

    def _narrow(self, query: str) -> None:
        for item in self._items():
            words = f"{item.text(0)} {item.text(1)}"
            item.setHidden(score(query, words) is None)

    def _show_current(self) -> None:
        name = self.chosen
        some = name is not None
        for widget in (self.edit, self.clear_button, self.reset_button):
            widget.setEnabled(some)
        if name is None:
            return
        with QSignalBlocker(self.edit):
            self.edit.setKeySequence(self._commands[name].shortcut())
        others = [self._commands.words(other).rstrip("…") for other in self._keys.sharing(name)]
        key = self._keys.text(name)
        self.conflict.setText(
            f"⚠ {key} is also the key of {', '.join(others)}: neither will answer."
            if others
            else ""
        )

    def _take(self) -> None:
        name, key = self.chosen, self.edit.keySequence()
        if name is not None and key != self._commands[name].shortcut():
            self._give(name, key)

    def _give(self, name: str, key: QKeySequence) -> None:
        self._keys.give(name, key)
        self._tell()

    def _clear(self) -> None:
        if self.chosen is not None:
            self._give(self.chosen, QKeySequence())

    def _reset(self) -> None:
        self._keys.reset(self.chosen)
        self._tell()

    def _reset_all(self) -> None:
        self._keys.reset()
        self._tell()

    def _tell(self) -> None:
        self.refresh()
        self._changed()

    def _button(self, text: str, tip: str, run: object) -> QPushButton:
        button = QPushButton(text, self)
        button.setToolTip(tip)
        button.setAccessibleName(f"{text}: key of the action")
        button.setAutoDefault(False)
        button.clicked.connect(run)
        return button
