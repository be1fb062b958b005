"""The gallery: presets with pictures, recent files, and a blank sheet, laid over the window."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

from PySide6.QtCore import QEvent, QObject, QSize, Qt, Signal
from PySide6.QtGui import QImage, QKeyEvent, QPixmap
from PySide6.QtWidgets import (
    QFrame,
    QHBoxLayout,
    QLabel,
    QLineEdit,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

import resources
from app.commands.fuzzy_match import ranked
from app.files import thumbnails
from app.files.files import Files
from app.start.shape_words import BLANK_WORDS, SHAPE_WORDS
from app.state.jobs import Job, Jobs
from app.theme import icons
from app.widgets.scrim import Scrim
from app.widgets.tile_list import Tile, TileList

LARGEST = QSize(940, 720)
MARGIN = 24
HINT = "Arrows walk, Enter opens, Esc or a click beside leaves everything as it is."
NOTHING = "Nothing is called that. Enter opens a blank sheet to draw it on."

_COMMANDS = Qt.KeyboardModifier.ControlModifier | Qt.KeyboardModifier.AltModifier


class Gallery(QFrame):
    """Not a dialog: the window's keys go on working; Escape leaves, or a click beside it."""

    left = Signal()

    def __init__(self, files: Files, window: QWidget) -> None:
        super().__init__(window)
        self._files = files
        self._window = window
        self._jobs = Jobs(self)
        self.scrim = Scrim(window)
        self.scrim.clicked.connect(self.leave)
        self.setProperty("role", "overlay")
        self.setAccessibleName("Gallery")
        self.setAutoFillBackground(True)
        title = QLabel("Start from", self)
        font = title.font()
        font.setPointSizeF(1.4 * font.pointSizeF())
        font.setBold(True)
        title.setFont(font)
        self.search = QLineEdit(self)
        self.search.setPlaceholderText("Search shapes and recent files")
        self.search.setAccessibleName("Search the gallery")
        self.search.setToolTip("A few letters narrow the gallery; Enter opens the first match")
        self.search.setClearButtonEnabled(True)
        self.search.installEventFilter(self)
        self.open_button = QToolButton(self)
        self.open_button.setText("Open file…")
        self.open_button.setToolTip("Open a project file")
        self.open_button.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextBesideIcon)
        icons.bind(self.open_button, "open")
        self.open_button.clicked.connect(self._open_file)
        self.close_button = QToolButton(self)
        icons.bind(self.close_button, "close")
        self.close_button.setToolTip("Leave the gallery (Esc)")
        self.close_button.setAccessibleName("Leave the gallery")
        self.close_button.clicked.connect(self.leave)
        top = QHBoxLayout()
        top.addWidget(title)
        top.addSpacing(16)
        top.addWidget(self.search, 1)
        top.addWidget(self.open_button)
        top.addWidget(self.close_button)
        self._recent_title = self._heading("Recent files")
        self.recent = TileList("Recent files", self, single_row=True)
        self._presets_title = self._heading("Shapes")
        self.presets = TileList("Shapes", self)
        self._nothing = QLabel(NOTHING, self)
        self._nothing.setProperty("role", "muted")
        hint = QLabel(HINT, self)
        hint.setProperty("role", "muted")
        layout = QVBoxLayout(self)
        layout.setContentsMargins(18, 14, 18, 12)
        layout.addLayout(top)
        for widget in (self._recent_title, self.recent, self._presets_title):
            layout.addWidget(widget)
        layout.addWidget(self._nothing)
        layout.addWidget(self.presets, 1)
        layout.addWidget(hint)
        self.search.textChanged.connect(self._narrow)
        for tiles in (self.recent, self.presets):
            tiles.chosen.connect(self._take)
            tiles.installEventFilter(self)
        self.hide()

    def open(self) -> None:
        """Show the gallery, with the recent files as they are now."""
        self.search.clear()
        paths = self._files.recent.paths()
        self._recent_tiles = [self._recent_tile(path) for path in paths]
        blank = Tile("Blank", "One plain segment to draw from", QPixmap(), self._files.new_blank)
        presets = resources.presets()
        self._preset_tiles = [blank, *(self._preset_tile(each) for each in presets)]
        self._other_words = [
            BLANK_WORDS,
            *(f"{SHAPE_WORDS[each.name]} {each.description}" for each in presets),
        ]
        self._narrow("")
        self.place()
        for each in (self.scrim, self):
            each.show()
            each.raise_()
        self.presets.setFocus(Qt.FocusReason.OtherFocusReason)
        self._jobs.drop_all()
        for tile, path in zip(self._recent_tiles, paths, strict=True):
            if tile.picture.isNull():
                self._outline(tile, path)

    def _outline(self, tile: Tile, path: Path) -> None:
        """Read a file that was never seen here, aside, and show its outline."""

        def done(outline: QImage) -> None:
            if outline.isNull():
                return
            pictured = replace(tile, picture=QPixmap.fromImage(outline))
            self._recent_tiles = [pictured if each is tile else each for each in self._recent_tiles]
            self.recent.exchange(tile, pictured)

        # A file that cannot be read has no picture; opening it says why.
        self._jobs.start(
            Job("Outline", lambda _report: thumbnails.outline_of(path), done, lambda _error: None)
        )

    def leave(self) -> None:
        """Hide the gallery; the document stays as it is."""
        if self.isHidden():
            return
        self.hide()
        self.scrim.hide()
        self._window.setFocus(Qt.FocusReason.OtherFocusReason)
        self.left.emit()

    def _heading(self, text: str) -> QLabel:
        label = QLabel(text, self)
        label.setProperty("role", "heading")
        return label

    def _preset_tile(self, preset: resources.Preset) -> Tile:
        return Tile(
            preset.title,
            preset.description,
            QPixmap(str(preset.picture)),
            lambda: self._files.new_from_preset(preset.name),
        )

    def _recent_tile(self, path: Path) -> Tile:
        return Tile(
            path.stem,
            str(path.parent),
            thumbnails.picture_of(path),
            lambda: self._files.open_path(path),
            str(path),
        )

    def _narrow(self, query: str) -> None:
        """Show what matches by its title, by a preset's words or by others for it.

        Where nothing does the blank sheet is left.
        """
        recent = [self._recent_tiles[k] for k in ranked(query, _titles(self._recent_tiles))]
        tiles = self._preset_tiles
        presets = [tiles[k] for k in ranked(query, _titles(tiles), self._other_words)]
        nothing = not recent and not presets
        if nothing:
            presets = tiles[:1]
        self.recent.show_tiles(recent)
        self.presets.show_tiles(presets)
        for widget in (self._recent_title, self.recent):
            widget.setVisible(bool(recent))
        self.presets.setVisible(bool(presets))
        self._presets_title.setVisible(bool(presets) and not nothing)
        self._nothing.setVisible(nothing)

    def _take(self, tile: Tile) -> None:
        # A question about unsaved work comes first; whoever says no stays in the gallery.
        if tile.run():
            self.leave()

    def _open_file(self) -> None:
        if self._files.open():
            self.leave()

    def event(self, event: QEvent) -> bool:
        if (
            event.type() == QEvent.Type.ShortcutOverride
            and isinstance(event, QKeyEvent)
            and event.key() == Qt.Key.Key_Escape
        ):
            # What lies under the gallery does not answer Escape before it: a notice, for one.
            event.accept()
            return True
        return super().event(event)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.key() == Qt.Key.Key_Escape:
            self.leave()
        else:
            super().keyPressEvent(event)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if watched is self.search and isinstance(event, QKeyEvent):
            return event.type() == QEvent.Type.KeyPress and self._search_key(event)
        if (
            isinstance(event, QKeyEvent)
            and event.type() == QEvent.Type.KeyPress
            and event.text().isalnum()
            and not event.modifiers() & _COMMANDS
        ):
            # Letters typed over the pictures search at once.
            self.search.setFocus(Qt.FocusReason.OtherFocusReason)
            self.search.insert(event.text())
            return True
        return super().eventFilter(watched, event)

    def _search_key(self, event: QKeyEvent) -> bool:
        lists = [tiles for tiles in (self.recent, self.presets) if tiles.count()]
        if not lists:
            return False
        if event.key() == Qt.Key.Key_Down:
            lists[0].setFocus(Qt.FocusReason.OtherFocusReason)
        elif event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter):
            lists[0].run_current()
        else:
            return False
        return True

    def place(self) -> None:
        """Lie in the middle of the window, whatever its size has become."""
        self.scrim.cover()
        room = self._window.size() - QSize(2 * MARGIN, 2 * MARGIN)
        size = room.boundedTo(LARGEST)
        self.resize(size)
        self.move(
            (self._window.width() - size.width()) // 2,
            (self._window.height() - size.height()) // 2,
        )


def _titles(tiles: list[Tile]) -> list[str]:
    return [tile.title for tile in tiles]
