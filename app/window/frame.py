"""The frame of a window: the titles of its menus, its docks and bars, all still empty.

It is seen while what fills it is being loaded, so nothing of the core belongs here.
"""

from __future__ import annotations

from PySide6.QtCore import QEvent, QEventLoop, QObject, QSize, Qt, QTimer, Signal
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import (
    QApplication,
    QDockWidget,
    QMainWindow,
    QMenu,
    QPushButton,
    QStatusBar,
    QToolBar,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from app.theme import icons
from app.viewport.opengl import prepare_window_of
from app.viewport.placeholder import Ground
from app.window.panels import make_docks

# In the order of the menu bar.
MENUS = ("File", "Edit", "Segment", "View", "Export", "Help")
# The longest wait for a window system that shows no window, in milliseconds.
PATIENCE = 500


class WindowFrame(QMainWindow):
    """What a window shows before it is furnished; what stands in it then takes its places."""

    resized = Signal()

    def __init__(self) -> None:
        super().__init__()
        self.setWindowTitle("SGB Studio")
        self.setDockOptions(
            QMainWindow.DockOption.AllowNestedDocks
            | QMainWindow.DockOption.AllowTabbedDocks
            | QMainWindow.DockOption.AnimatedDocks
        )
        self.titles: dict[str, QMenu] = {}
        for title in MENUS:
            self.titles[title] = self.menuBar().addMenu(f"&{title}")
            self.titles[title].setToolTipsVisible(True)
        centre = QWidget(self)
        self._middle = QVBoxLayout(centre)
        self._middle.setContentsMargins(0, 0, 0, 0)
        self._middle.setSpacing(0)
        self._ground = Ground()
        self._middle.addWidget(self._ground, 1)
        prepare_window_of(centre)
        self.setCentralWidget(centre)
        self.docks: dict[str, QDockWidget] = make_docks(self)
        self.toolbar = _toolbar(self)
        self.addToolBar(self.toolbar)
        foot = QStatusBar(self)
        # As high as with what is seen now and then.
        room = QPushButton(" ", foot)
        foot.addPermanentWidget(room)
        room.hide()
        self.setStatusBar(foot)

    def show_frame(self) -> None:
        """Show the window, and return when it has been painted once."""
        watch, loop = _Painted(), QEventLoop()
        self.installEventFilter(watch)
        # Painted with the window are all its parts; only then comes what waits.
        watch.painted.connect(lambda: QTimer.singleShot(0, loop.quit))
        QTimer.singleShot(PATIENCE, loop.quit)
        self.show()
        loop.exec(QEventLoop.ProcessEventsFlag.ExcludeUserInputEvents)
        self.removeEventFilter(watch)

    def fill_middle(self, viewport: QWidget) -> None:
        """Put the viewport where only its ground was."""
        self._middle.replaceWidget(self._ground, viewport)
        self._ground.deleteLater()

    def toggle_full_screen(self) -> None:
        """Use the whole screen, or stop doing so."""
        self.setWindowState(self.windowState() ^ Qt.WindowState.WindowFullScreen)

    def quit(self) -> None:
        """Close every window, asking about each one's unsaved work."""
        QApplication.closeAllWindows()

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self.resized.emit()


class _Painted(QObject):
    """Tells that what it watches is being painted."""

    painted = Signal()

    def eventFilter(self, _watched: QObject, event: QEvent) -> bool:
        if event.type() == QEvent.Type.Paint:
            self.painted.emit()
        return False


def _toolbar(window: QMainWindow) -> QToolBar:
    """Return the empty toolbar, as high as its buttons will be."""
    bar = QToolBar("Toolbar", window)
    bar.setObjectName("toolbar")
    bar.setIconSize(QSize(20, 20))
    bar.setMovable(False)
    button = QToolButton(bar)
    button.setText(" ")
    icons.bind(button, "open")
    button.setEnabled(False)
    bar.addWidget(button)
    return bar


def application() -> QApplication:
    """Return the running application, a new one where none runs."""
    running = QApplication.instance()
    return running if isinstance(running, QApplication) else QApplication([])
