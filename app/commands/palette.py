"""The command palette: every action of the window, found by a few letters of its name."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import (
    QEvent,
    QModelIndex,
    QObject,
    QPersistentModelIndex,
    QSize,
    Qt,
)
from PySide6.QtGui import QAction, QIcon, QKeyEvent, QKeySequence, QPainter, QPalette, QPixmap
from PySide6.QtWidgets import (
    QDialog,
    QLabel,
    QLineEdit,
    QListWidget,
    QListWidgetItem,
    QStyle,
    QStyledItemDelegate,
    QStyleOptionViewItem,
    QVBoxLayout,
    QWidget,
)

from app.commands.fuzzy_match import ranked
from app.commands.synonyms import SYNONYMS

WIDTH, HEIGHT = 520, 380
# Under this role a row keeps its action's keys.
KEYS = Qt.ItemDataRole.UserRole + 1
NOTHING = (
    "Nothing is called so here. Try another word, such as draw, thick, volume or smooth; or a name "
    "and a number, such as height 95 or wall 4."
)
Index = QModelIndex | QPersistentModelIndex
# Of what is typed: a command in words and what does it, None where it is none.
Asked = Callable[[str], tuple[str, Callable[[], object]] | None]
WALKING = (Qt.Key.Key_Up, Qt.Key.Key_Down, Qt.Key.Key_PageUp, Qt.Key.Key_PageDown)


class KeysAtRight(QStyledItemDelegate):
    """Draws the keys of an action at the right of its row."""

    def paint(self, painter: QPainter, option: QStyleOptionViewItem, index: Index) -> None:
        super().paint(painter, option, index)
        keys = index.data(KEYS)
        if keys:
            box, palette = option.rect, option.palette
            painter.save()
            painter.setPen(palette.color(QPalette.ColorRole.PlaceholderText))
            painter.drawText(
                box.adjusted(0, 0, -8, 0),
                Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter,
                keys,
            )
            painter.restore()


class CommandPalette(QDialog):
    """Type to narrow, arrows to choose, Enter to do, Escape to leave."""

    def __init__(
        self,
        entries: list[tuple[str, QAction]],
        parent: QWidget | None = None,
        *,
        asked: Asked = lambda _query: None,
        below: int = 0,
    ) -> None:
        """Offer actions under these names; ``asked`` may find one more in what is typed.

        It lies ``below`` that height of the screen, where the parent has room.
        """
        super().__init__(parent, Qt.WindowType.Popup)
        self._asked = asked
        self._run: Callable[[], object] | None = None
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
        self._list.setItemDelegate(KeysAtRight(self._list))
        self._nothing = QLabel(NOTHING, self)
        self._nothing.setProperty("role", "muted")
        self._nothing.setWordWrap(True)
        self._nothing.hide()
        layout = QVBoxLayout(self)
        layout.setContentsMargins(8, 8, 8, 8)
        layout.addWidget(self._query)
        layout.addWidget(self._list, 1)
        layout.addWidget(self._nothing, 0, Qt.AlignmentFlag.AlignTop)
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
            lowest = max(top, top + parent.height() - HEIGHT)
            self.move(middle.x() - WIDTH // 2, min(max(top + 80, below), lowest))

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
        found = self._asked(query)
        self._run = None if found is None else found[1]
        if found is not None:
            item = QListWidgetItem(self._icon(QIcon()), found[0])
            item.setData(Qt.ItemDataRole.UserRole, -1)
            item.setToolTip(f"{found[0]}, as one step")
            self._list.addItem(item)
        also = [SYNONYMS.get(action.objectName(), "") for _, action in self._entries]
        for index in ranked(query, [text for text, _ in self._entries], also):
            text, action = self._entries[index]
            keys = action.shortcut().toString(QKeySequence.SequenceFormat.NativeText)
            item = QListWidgetItem(self._icon(action.icon()), text)
            item.setData(Qt.ItemDataRole.UserRole, index)
            item.setData(KEYS, keys)
            item.setData(Qt.ItemDataRole.AccessibleTextRole, f"{text} {keys}".strip())
            item.setToolTip(action.toolTip())
            self._list.addItem(item)
        self._list.setCurrentRow(0)
        empty = self._list.count() == 0
        self._list.setVisible(not empty)
        self._nothing.setVisible(empty)

    def _icon(self, own: QIcon) -> QIcon:
        """Return an action's icon as it is in a menu, a blank one where it has none.

        A style recolours the icon of the chosen row for a ground that is not the theme's; and
        rows without an icon would be lower than the others.
        """
        size, ratio = self._list.iconSize(), self.devicePixelRatioF()
        if not size.isValid() or size.isEmpty():
            extent = self.style().pixelMetric(QStyle.PixelMetric.PM_ListViewIconSize)
            size = QSize(extent, extent)
        picture = own.pixmap(size, ratio)
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
        index, run = item.data(Qt.ItemDataRole.UserRole), self._run
        self.close()
        if index >= 0:
            self._entries[index][1].trigger()
        elif run is not None:
            run()
