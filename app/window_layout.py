"""Where the parts of a window sit: docks, what is remembered of them, one view filling all."""

from __future__ import annotations

from typing import TYPE_CHECKING, Literal

from PySide6.QtCore import QByteArray, QEvent, QObject, QSettings, Qt, QTimer
from PySide6.QtWidgets import QDockWidget

if TYPE_CHECKING:
    from app.main_window import MainWindow

# Raised whenever docks change, so that a remembered layout of older docks is not forced on them.
LAYOUT_VERSION = 2
# From this width on the docks are given more room.
WIDE = 1300

Alone = Literal["viewport", "editor"]


class WindowLayout(QObject):
    """The arrangement of one window; made when its docks and bars stand."""

    def __init__(self, window: MainWindow) -> None:
        super().__init__(window)
        self._window = window
        self._default_state = window.saveState(LAYOUT_VERSION)
        self._was_wide = True
        # What alone fills the window, and what it was like before.
        self.alone: Alone | None = None
        self._before_alone: tuple[QByteArray, Qt.WindowState] | None = None
        self._restore()
        window.installEventFilter(self)

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
        for bar in (window.menuBar(), window.menus.toolbar, window.status):
            bar.hide()
        if which == "editor":
            window.surface_view.hide()
            window.centralWidget().layout().addWidget(window.profile_view, 1)
            window.profile_view.show()
            window.profile_view.setFocus(Qt.FocusReason.OtherFocusReason)
        window.setWindowState(window.windowState() | Qt.WindowState.WindowFullScreen)
        window.presenter.refresh_now()

    def leave_alone(self) -> None:
        """Show all parts again; nothing happens where all are shown."""
        if self.alone is None or self._before_alone is None:
            return
        window = self._window
        state, window_state = self._before_alone
        if self.alone == "editor":
            window.docks["profile"].setWidget(window.profile_view)
            window.surface_view.show()
        self.alone = self._before_alone = None
        for bar in (window.menuBar(), window.status):
            bar.show()
        window.restoreState(state, LAYOUT_VERSION)
        window.setWindowState(window_state)
        window.presenter.refresh_now()

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        # Docks wide enough for a large window would leave a small one no room for the surface.
        if event.type() == QEvent.Type.Resize and self._is_wide() != self._was_wide:
            self._was_wide = self._is_wide()
            QTimer.singleShot(0, self, self._size_docks)
        return super().eventFilter(watched, event)

    def _restore(self) -> None:
        settings, window = QSettings(), self._window
        geometry, state = settings.value("geometry"), settings.value("state")
        if isinstance(geometry, QByteArray):
            window.restoreGeometry(geometry)
        else:
            room = window.screen().availableGeometry()
            window.resize(min(1440, room.width()), min(900, room.height()))
        self._was_wide = self._is_wide()
        if not isinstance(state, QByteArray) or not window.restoreState(state, LAYOUT_VERSION):
            self._size_docks()

    def _is_wide(self) -> bool:
        return self._window.width() >= WIDE

    def _size_docks(self) -> None:
        window, wide = self._window, self._is_wide()
        horizontal, vertical = Qt.Orientation.Horizontal, Qt.Orientation.Vertical
        profile, points, shape = (window.docks[k] for k in ("profile", "points", "shape"))
        window.resizeDocks(
            [profile, shape], [380 if wide else 300, 320 if wide else 280], horizontal
        )
        window.resizeDocks([profile, points], [620, 260], vertical)
