"""The command palette: every action of the window, found by a few letters of its name."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QObject, QSize, Qt
from PySide6.QtGui import QAction, QIcon, QKeyEvent, QKeySequence, QPixmap
from PySide6.QtWidgets import (
    QDialog,
    QLineEdit,
    QListWidget,
    QListWidgetItem,
    QStyle,
    QVBoxLayout,
    QWidget,
)

from app.commands.fuzzy_match import ranked

WIDTH, HEIGHT = 520, 380
WALKING = (Qt.Key.Key_Up, Qt.Key.Key_Down, Qt.Key.Key_PageUp, Qt.Key.Key_PageDown)


class CommandPalette(QDialog):
    """Type to narrow, arrows to choose, Enter to do, Escape to leave."""

    def __init__(self, entries: list[tuple[str, QAction]], parent: QWidget | None = None) -> None:
        super().__init__(parent, Qt.WindowType.Popup)
        self.setWindowTitle("Command palette")
        self.setProperty("role", "overlay")
        self._entries = [entry for entry in entries if entry[1].isEnabled()]
        self._query = QLineEdit(self)
        self._query.setPlaceholderText("What would you like to do?")
        self._query.setAccessibleName("Command")
        self._query.installEventFilter(self)
        self._list = QListWidget(self)
        self._list.setAccessibleName("Matching commands")
        self._list.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(8, 8, 8, 8)
        layout.addWidget(self._query)
        layout.addWidget(self._list)
        self._query.textChanged.connect(self._narrow)
        self._query.returnPressed.connect(self._do)
        self._list.itemClicked.connect(lambda _item: self._do())
        self.resize(WIDTH, HEIGHT)
        # A popup is never made the active window, which alone would give its field the focus.
        self._query.setFocus()
        self._narrow("")
        if parent is not None:
            middle = parent.mapToGlobal(parent.rect().center())
            top = parent.mapToGlobal(parent.rect().topLeft()).y()
            self.move(middle.x() - WIDTH // 2, top + 80)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Let the arrow keys walk through the list while the text field has the focus."""
        if (
            isinstance(event, QKeyEvent)
            and event.type() == QEvent.Type.KeyPress
            and event.key() in WALKING
        ):
            self._list.event(event)
            return True
        return super().eventFilter(watched, event)

    def _narrow(self, query: str) -> None:
        self._list.clear()
        for index in ranked(query, [text for text, _ in self._entries]):
            text, action = self._entries[index]
            keys = action.shortcut().toString(QKeySequence.SequenceFormat.NativeText)
            item = QListWidgetItem(self._icon(action), f"{text}    {keys}" if keys else text)
            item.setData(Qt.ItemDataRole.UserRole, index)
            item.setToolTip(action.toolTip())
            self._list.addItem(item)
        self._list.setCurrentRow(0)

    def _icon(self, action: QAction) -> QIcon:
        """Return an action's icon as it is in a menu, a blank one where it has none.

        A style recolours the icon of the chosen row for a ground that is not the theme's; and
        rows without an icon would be lower than the others.
        """
        size, ratio = self._list.iconSize(), self.devicePixelRatioF()
        if not size.isValid() or size.isEmpty():
            extent = self.style().pixelMetric(QStyle.PixelMetric.PM_ListViewIconSize)
            size = QSize(extent, extent)
        picture = action.icon().pixmap(size, ratio)
        if picture.isNull():
            picture = QPixmap(size * ratio)
            picture.setDevicePixelRatio(ratio)
            picture.fill(Qt.GlobalColor.transparent)
        icon = QIcon()
        for mode in (QIcon.Mode.Normal, QIcon.Mode.Selected):
            icon.addPixmap(picture, mode)
        return icon

    def _do(self) -> None:
        item = self._list.currentItem()
        if item is None:
            return
        action = self._entries[item.data(Qt.ItemDataRole.UserRole)][1]
        self.close()
        action.trigger()
