"""Where the parts of a window sit: docks, what is remembered of them, one view filling all."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Literal

from PySide6.QtCore import QByteArray, QObject, QSettings, Qt, QTimer
from PySide6.QtWidgets import QBoxLayout, QDockWidget, QMainWindow, QToolBar, QWidget

from app.state.stored import stored

# Raised whenever docks change, so that a remembered layout of older docks is not forced on them.
LAYOUT_VERSION = 3
# From these window widths on the docks left and right of the surface are given so much room.
DOCK_WIDTHS = ((2000, 480, 430), (1300, 380, 350), (0, 290, 312))

# What a window manager puts around a window at most, which is not known before it is shown: with
# it the first window still lies within the screen.
FRAME = (16, 56)

Alone = Literal["viewport", "editor"]


# With these bytes all geometries that Qt saves begin.
_GEOMETRY = QByteArray(b"\x01\xd9\xd0\xcb")


class WindowLayout(QObject):
    """The arrangement of one window; made when its docks and bars stand, be they empty.

    ``viewport`` and ``editor`` give the views once there are any; ``refresh`` shows anew what was
    hidden.
    """

    def __init__(
        self,
        window: QMainWindow,
        docks: Mapping[str, QDockWidget],
        viewport: Callable[[], QWidget],
        editor: Callable[[], QWidget],
        refresh: Callable[[], object],
    ) -> None:
        super().__init__(window)
        self._window, self._docks = window, docks
        self._viewport, self._editor = viewport, editor
        self._refresh = refresh
        self._default_state = window.saveState(LAYOUT_VERSION)
        self._widths = DOCK_WIDTHS[0][1:]
        # What alone fills the window, and what it was like before.
        self.alone: Alone | None = None
        self._before_alone: tuple[QByteArray, Qt.WindowState] | None = None
        for dock in docks.values():
            dock.toggleViewAction().triggered.connect(
                lambda shown, dock=dock: self._dock_wanted(dock, shown)
            )
        self._restore()

    def save(self) -> None:
        """Remember the arrangement for the next window."""
        settings = QSettings()
        self.leave_alone()
        settings.setValue("geometry", self._window.saveGeometry())
        settings.setValue("state", self._window.saveState(LAYOUT_VERSION))

    def reset(self) -> None:
        """Put all docks back where they were at first."""
        self.leave_alone()
        self._window.restoreState(self._default_state, LAYOUT_VERSION)
        self._size_docks()

    def toggle_alone(self, which: Alone) -> None:
        """Let one view fill the whole screen, or bring everything back."""
        if self.alone == which:
            self.leave_alone()
            return
        self.leave_alone()
        window = self._window
        self._before_alone = (window.saveState(LAYOUT_VERSION), window.windowState())
        self.alone = which
        for dock in window.findChildren(QDockWidget):
            dock.hide()
        for bar in (window.menuBar(), *window.findChildren(QToolBar), window.statusBar()):
            bar.hide()
        if which == "editor":
            self._viewport().hide()
            centre = window.centralWidget()
            assert centre is not None
            layout = centre.layout()
            assert isinstance(layout, QBoxLayout)
            editor = self._editor()
            layout.addWidget(editor, 1)
            editor.show()
            editor.setFocus(Qt.FocusReason.OtherFocusReason)
        window.setWindowState(window.windowState() | Qt.WindowState.WindowFullScreen)
        self._refresh()

    def leave_alone(self) -> None:
        """Show all parts again; nothing happens where all are shown."""
        if self.alone is None or self._before_alone is None:
            return
        window = self._window
        state, window_state = self._before_alone
        if self.alone == "editor":
            self._docks["profile"].setWidget(self._editor())
            self._viewport().show()
        self.alone = self._before_alone = None
        for bar in (window.menuBar(), window.statusBar()):
            bar.show()
        window.restoreState(state, LAYOUT_VERSION)
        window.setWindowState(window_state)
        self._refresh()

    def go_to(self, dock: QDockWidget) -> None:
        """Show a panel, before others in its place, and give it the keyboard."""
        from app.commands import focus_walk

        self.leave_alone()
        dock.show()
        dock.raise_()
        focus_walk.enter(dock)

    def _dock_wanted(self, dock: QDockWidget, shown: bool) -> None:
        """Bring all back where a panel is asked for beside what is alone: it has no place there."""
        if self.alone is not None and shown:
            self.leave_alone()
            dock.show()
            dock.raise_()

    def follow_size(self) -> None:
        """Give the docks what a window of its present size has for them."""
        # Docks wide enough for a large window would leave a small one no room for the surface.
        if self._dock_widths() != self._widths:
            self._widths = self._dock_widths()
            QTimer.singleShot(0, self, self._size_docks)

    def _restore(self) -> None:
        window = self._window
        state = stored("state", None, _bytes)
        placed = stored("geometry", False, self._take_geometry)
        if not placed:
            room = window.screen().availableGeometry()
            width, height = room.width() - FRAME[0], room.height() - FRAME[1]
            window.resize(min(1440, width), min(900, height))
        self._widths = self._dock_widths()
        restored = state is not None and window.restoreState(state, LAYOUT_VERSION)
        # Docks that a larger screen had room for would leave the surface none.
        if not (restored and placed):
            self._size_docks()

    def _take_geometry(self, value: object) -> bool:
        """Take up a stored place; returns whether it is one of this screen."""
        data = _bytes(value)
        if self._window.restoreGeometry(data):
            return True
        # Qt refuses what was kept on a screen of another size too, and that is no fault.
        if not data.startsWith(_GEOMETRY):
            raise ValueError(value)
        return False

    def _dock_widths(self) -> tuple[int, int]:
        width = self._window.width()
        return next((left, right) for least, left, right in DOCK_WIDTHS if width >= least)

    def _size_docks(self) -> None:
        window = self._window
        horizontal, vertical = Qt.Orientation.Horizontal, Qt.Orientation.Vertical
        profile, points, shape = (self._docks[k] for k in ("profile", "points", "shape"))
        window.resizeDocks([profile, shape], list(self._dock_widths()), horizontal)
        window.resizeDocks([profile, points], [620, 260], vertical)


def _bytes(value: object) -> QByteArray:
    if not isinstance(value, QByteArray):
        raise TypeError(value)
    return value
