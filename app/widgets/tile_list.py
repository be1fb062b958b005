"""A list of tiles, each a picture over a title and a line of words; walked by mouse and keys."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import QModelIndex, QPersistentModelIndex, QRect, QRectF, QSize, Qt, Signal
from PySide6.QtGui import (
    QColor,
    QFont,
    QKeyEvent,
    QPainter,
    QPainterPath,
    QPen,
    QPixmap,
    QResizeEvent,
    QTextLayout,
)
from PySide6.QtWidgets import (
    QFrame,
    QListView,
    QListWidget,
    QListWidgetItem,
    QStyle,
    QStyledItemDelegate,
    QStyleOptionViewItem,
    QWidget,
)

from app.theme import theme
from sgb_core.values import dataclass

PICTURE = 104
WIDTH = 164
# Under the title.
WORD_LINES = 3
_PAD = 8


@dataclass(frozen=True, slots=True)
class Tile:
    """One thing to start from; ``picture`` may be null, then a plain sheet is drawn."""

    title: str
    words: str
    picture: QPixmap
    run: Callable[[], object]
    tip: str = ""


class TileList(QListWidget):
    """Tiles in rows, or in a single row that scrolls; Enter or a click chooses one."""

    chosen = Signal(object)

    def __init__(self, name: str, parent: QWidget, *, single_row: bool = False) -> None:
        super().__init__(parent)
        self._single_row = single_row
        self._tiles: list[Tile] = []
        self.setAccessibleName(name)
        self.setToolTip("Arrows walk, Enter opens")
        self.setViewMode(QListView.ViewMode.IconMode)
        self.setMovement(QListView.Movement.Static)
        self.setResizeMode(QListView.ResizeMode.Adjust)
        self.setWrapping(not single_row)
        self.setFrameShape(QFrame.Shape.NoFrame)
        self.setMouseTracking(True)
        self.setVerticalScrollMode(QListView.ScrollMode.ScrollPerPixel)
        self.setHorizontalScrollMode(QListView.ScrollMode.ScrollPerPixel)
        self.setItemDelegate(_TileDelegate(self))
        if single_row:
            self.setVerticalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
            self.setFixedHeight(tile_size(self).height() + 16)
        self.itemClicked.connect(self._choose)

    @property
    def tiles(self) -> tuple[Tile, ...]:
        """What is shown, in its order."""
        return tuple(self._tiles)

    def show_tiles(self, tiles: list[Tile]) -> None:
        """Show ``tiles`` in place of what was shown."""
        self._tiles = list(tiles)
        self.clear()
        for tile in tiles:
            item = QListWidgetItem(tile.title, self)
            item.setData(Qt.ItemDataRole.UserRole, tile)
            item.setToolTip(tile.tip or f"{tile.title}: {tile.words}")
            item.setData(Qt.ItemDataRole.AccessibleDescriptionRole, tile.words)
        self._fill_width()
        self.setCurrentRow(0 if tiles else -1)

    def exchange(self, old: Tile, new: Tile) -> None:
        """Show one tile in the place of another, where that is shown."""
        for row, tile in enumerate(self._tiles):
            if tile is old:
                self._tiles[row] = new
                self.item(row).setData(Qt.ItemDataRole.UserRole, new)

    def resizeEvent(self, event: QResizeEvent) -> None:
        self._fill_width()
        super().resizeEvent(event)

    def _fill_width(self) -> None:
        """Share the width among as many tiles as go beside each other."""
        # A row as wide as the view itself would be wrapped.
        size, room = tile_size(self), self.viewport().width() - 1
        if not self._single_row and room >= size.width():
            size.setWidth(room // (room // size.width()))
        if size != self.gridSize():
            self.setGridSize(size)
        for row in range(self.count()):
            self.item(row).setSizeHint(size)

    def run_current(self) -> bool:
        """Choose the current tile; returns whether there is one."""
        item = self.currentItem()
        if item is not None:
            self._choose(item)
        return item is not None

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter):
            self.run_current()
        else:
            super().keyPressEvent(event)

    def _choose(self, item: QListWidgetItem) -> None:
        self.chosen.emit(item.data(Qt.ItemDataRole.UserRole))


def tile_size(widget: QWidget) -> QSize:
    """Return how large a tile is with the widget's font."""
    line = widget.fontMetrics().height()
    return QSize(max(WIDTH, 11 * line), PICTURE + (1 + WORD_LINES) * line + 3 * _PAD + 8)


class _TileDelegate(QStyledItemDelegate):
    def paint(
        self,
        painter: QPainter,
        option: QStyleOptionViewItem,
        index: QModelIndex | QPersistentModelIndex,
    ) -> None:
        tile: Tile = index.data(Qt.ItemDataRole.UserRole)
        palette, area = theme.current(), option.rect.adjusted(4, 4, -4, -4)
        current = bool(option.state & QStyle.StateFlag.State_Selected)
        over = bool(option.state & QStyle.StateFlag.State_MouseOver)
        focused = current and bool(option.state & QStyle.StateFlag.State_HasFocus)
        painter.save()
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setRenderHint(QPainter.RenderHint.SmoothPixmapTransform)
        ground = palette.selected if focused else palette.hover if over else palette.field
        edge = palette.accent if focused else palette.axis if current or over else palette.border
        painter.setBrush(QColor(ground))
        painter.setPen(QPen(QColor(edge), 2.0 if focused else 1.0))
        painter.drawRoundedRect(QRectF(area).adjusted(1, 1, -1, -1), 7, 7)
        inner = area.adjusted(_PAD, _PAD, -_PAD, -_PAD)
        _draw_picture(painter, QRect(inner.left(), inner.top(), inner.width(), PICTURE), tile)
        line = option.fontMetrics.height()
        top = inner.top() + PICTURE + 4
        font = QFont(option.font)
        font.setWeight(QFont.Weight.DemiBold)
        painter.setFont(font)
        painter.setPen(QColor(palette.text))
        title = painter.fontMetrics().elidedText(
            tile.title, Qt.TextElideMode.ElideMiddle, inner.width()
        )
        painter.drawText(
            QRect(inner.left(), top, inner.width(), line), Qt.AlignmentFlag.AlignLeft, title
        )
        painter.setFont(option.font)
        painter.setPen(QColor(palette.text_muted))
        words = QRect(inner.left(), top + line, inner.width(), inner.bottom() - top - line + 1)
        _draw_words(painter, words, tile.words)
        painter.restore()


def _draw_words(painter: QPainter, room: QRect, words: str) -> None:
    """Draw as many whole lines as there is room for, the last one with an ellipsis."""
    metrics = painter.fontMetrics()
    lines = lines_of(words, painter.font(), room.width())
    count = max(1, (room.height() + 1) // metrics.height())
    if len(lines) > count:
        lines[count - 1 :] = [" ".join(lines[count - 1 :])]
    for number, line in enumerate(lines):
        text = metrics.elidedText(line, Qt.TextElideMode.ElideRight, room.width())
        painter.drawText(
            room.left(), room.top() + number * metrics.height() + metrics.ascent(), text
        )


def words_width(tile: int) -> int:
    """Return how wide the words of a tile may be that is as wide as this."""
    return tile - 2 * (4 + _PAD)


def lines_of(words: str, font: QFont, width: int) -> list[str]:
    """Return words broken into lines of a width in pixels."""
    layout = QTextLayout(words, font)
    layout.beginLayout()
    lines = []
    while (line := layout.createLine()).isValid():
        line.setLineWidth(width)
        lines.append(words[line.textStart() : line.textStart() + line.textLength()].strip())
    layout.endLayout()
    return lines


def _draw_picture(painter: QPainter, room: QRect, tile: Tile) -> None:
    if tile.picture.isNull():
        palette, height = theme.current(), room.height() - 24
        sheet = QRectF(0, 0, height * 0.75, height)
        sheet.moveCenter(QRectF(room).center())
        painter.setBrush(QColor(palette.canvas))
        painter.setPen(QPen(QColor(palette.axis), 1.5, Qt.PenStyle.DashLine))
        painter.drawRoundedRect(sheet, 4, 4)
        return
    size = tile.picture.size().scaled(room.size(), Qt.AspectRatioMode.KeepAspectRatio)
    target = QRect(0, 0, size.width(), size.height())
    target.moveCenter(room.center())
    if not tile.picture.hasAlphaChannel():
        corners = QPainterPath()
        corners.addRoundedRect(QRectF(target), 5, 5)
        painter.setClipPath(corners)
    painter.drawPixmap(target, tile.picture)
    painter.setClipping(False)
