"""Tiles share the width of their list, whatever it is."""

import pytest
from PySide6.QtGui import QPixmap
from PySide6.QtWidgets import QApplication, QWidget

from app.theme import theme
from app.widgets.tile_list import Tile, TileList, tile_size


@pytest.mark.parametrize("width", [360, *range(528, 536), 700, 900])
def test_tiles_fill_the_width(qtbot, width):
    theme.apply(QApplication.instance(), "light")
    holder = QWidget()
    qtbot.addWidget(holder)
    tiles = TileList("Shapes", holder)
    tiles.show_tiles([Tile(f"T{k}", "words", QPixmap(), lambda: None) for k in range(30)])
    tiles.resize(width, 400)
    with qtbot.waitExposed(holder):
        holder.show()
    least = tile_size(tiles).width()
    # All but what whole pixels leave over, and the list's own rim.
    qtbot.waitUntil(lambda: tiles.gridSize().width() * _columns(tiles) > _room(tiles) - 12)
    assert tiles.gridSize().width() >= least
    assert tiles.horizontalScrollBar().maximum() == 0


def _columns(tiles):
    tops = [tiles.visualItemRect(tiles.item(k)).top() for k in range(tiles.count())]
    return tops.count(tops[0])


def _room(tiles):
    return tiles.viewport().width()
