"""The window: which views there are and where they sit. Layout and docks only."""

from __future__ import annotations

from pathlib import Path

from PySide6.QtCore import QByteArray, QEvent, QSettings, QSize, Qt, QTimer
from PySide6.QtGui import QCloseEvent, QDragEnterEvent, QDropEvent, QKeySequence, QResizeEvent
from PySide6.QtWidgets import (
    QApplication,
    QDockWidget,
    QMainWindow,
    QMenu,
    QScrollArea,
    QToolBar,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

import resources
from app import actions, help_pages, icons, theme
from app.command_palette import CommandPalette
from app.commands import CommandSet
from app.exporting import Exporting
from app.files import SUFFIX, Files, opening_document
from app.jobs import Jobs
from app.measures_panel import MeasuresPanel
from app.notice_bar import NoticeBar
from app.point_table import PointTable
from app.presenter import Frame, Presenter
from app.profile_view import ProfileView
from app.shape_panel import ShapePanel
from app.status_bar import StatusBar
from app.surface_view import SurfaceView
from app.turn_panel import TurnPanel
from sgb_core.document.model import Document
from sgb_core.document.session import Session

# Raised whenever docks change, so that a remembered layout of older docks is not forced on them.
LAYOUT_VERSION = 1
# From this width on the docks are given more room.
WIDE = 1300


class MainWindow(QMainWindow):
    """One document in one window."""

    windows: list[MainWindow] = []  # noqa: RUF012 - Qt deletes windows nobody holds

    def __init__(self, document: Document | None = None) -> None:
        super().__init__()
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.setAcceptDrops(True)
        self._was_wide = True
        self.setDockOptions(
            QMainWindow.DockOption.AllowNestedDocks
            | QMainWindow.DockOption.AllowTabbedDocks
            | QMainWindow.DockOption.AnimatedDocks
        )
        self.presenter = Presenter(Session(document or opening_document()), self)
        self.jobs = Jobs(self)
        self.files = Files(self.presenter, self)
        self.theme_choice = str(QSettings().value("theme", "system"))
        self.surface_view = SurfaceView(self.presenter, self)
        self.profile_view = ProfileView(self.presenter, self)
        self.exporting = Exporting(self.presenter, self.files, self.jobs, self.surface_view, self)
        self._place_views()
        self.commands = CommandSet(self, actions.all_commands(self))
        self._finish_menus()
        self._build_toolbar()
        self.presenter.refreshed.connect(self._refreshed)
        self.files.path_changed.connect(self._show_title)
        self._default_state = self.saveState(LAYOUT_VERSION)
        self._restore_layout()
        MainWindow.windows.append(self)

    # Layout.

    def _place_views(self) -> None:
        presenter = self.presenter
        centre = QWidget(self)
        layout = QVBoxLayout(centre)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(0)
        self.notice_bar = NoticeBar(presenter, centre)
        layout.addWidget(self.notice_bar)
        layout.addWidget(self.surface_view, 1)
        self.setCentralWidget(centre)
        self.point_table = PointTable(presenter, self)
        self.shape_panel = ShapePanel(presenter, self)
        self.turn_panel = TurnPanel(presenter, self)
        self.measures_panel = MeasuresPanel(presenter, self)
        left, right = Qt.DockWidgetArea.LeftDockWidgetArea, Qt.DockWidgetArea.RightDockWidgetArea
        self.docks = {
            "profile": self._dock("Profile", self.profile_view, left),
            "points": self._dock("Points", self.point_table, left),
            "shape": self._dock("Shape", self.shape_panel, right),
            "turn": self._dock("Turn", _scrolled(self.turn_panel), right),
            "measures": self._dock("Measures", _scrolled(self.measures_panel), right),
        }
        self.splitDockWidget(self.docks["profile"], self.docks["points"], Qt.Orientation.Vertical)
        self.tabifyDockWidget(self.docks["shape"], self.docks["turn"])
        self.tabifyDockWidget(self.docks["turn"], self.docks["measures"])
        self.docks["shape"].raise_()
        self.status = StatusBar(presenter, self.jobs, self)
        self.setStatusBar(self.status)
        for view in (
            self.profile_view,
            self.surface_view,
            self.shape_panel,
            self.point_table,
            self.turn_panel,
            self.measures_panel,
            self.status,
        ):
            presenter.add_view(view)

    def _dock(self, title: str, widget: QWidget, area: Qt.DockWidgetArea) -> QDockWidget:
        dock = QDockWidget(title, self)
        dock.setObjectName(f"dock_{title.lower()}")
        dock.setWidget(widget)
        self.addDockWidget(area, dock)
        return dock

    def _restore_layout(self) -> None:
        settings = QSettings()
        geometry, state = settings.value("geometry"), settings.value("state")
        if isinstance(geometry, QByteArray):
            self.restoreGeometry(geometry)
        else:
            room = self.screen().availableGeometry()
            self.resize(min(1440, room.width()), min(900, room.height()))
        self._was_wide = self._is_wide()
        if not isinstance(state, QByteArray) or not self.restoreState(state, LAYOUT_VERSION):
            self._size_docks()

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        # Docks wide enough for a large window would leave a small one no room for the surface.
        if self._is_wide() != self._was_wide:
            self._was_wide = self._is_wide()
            QTimer.singleShot(0, self._size_docks)

    def _is_wide(self) -> bool:
        return self.width() >= WIDE

    def _size_docks(self) -> None:
        wide = self._is_wide()
        horizontal, vertical = Qt.Orientation.Horizontal, Qt.Orientation.Vertical
        profile, points, shape = (self.docks[k] for k in ("profile", "points", "shape"))
        self.resizeDocks([profile, shape], [380 if wide else 300, 320 if wide else 280], horizontal)
        self.resizeDocks([profile, points], [620, 260], vertical)

    def reset_layout(self) -> None:
        """Put all docks back where they were at first."""
        self.restoreState(self._default_state, LAYOUT_VERSION)
        self._size_docks()

    def toggle_full_screen(self) -> None:
        """Use the whole screen, or stop doing so."""
        self.setWindowState(self.windowState() ^ Qt.WindowState.WindowFullScreen)

    # Menus and toolbar.

    def _finish_menus(self) -> None:
        self.commands["redo"].setShortcuts([QKeySequence("Ctrl+Shift+Z"), QKeySequence("Ctrl+Y")])
        file_menu = self.commands.menu("File")
        save = self.commands["save"]
        self._preset_menu = QMenu("New from preset", self)
        for preset in resources.presets():
            action = self._preset_menu.addAction(preset.title)
            action.setToolTip(preset.description)
            action.triggered.connect(
                lambda _checked=False, name=preset.name: self.files.new_from_preset(name)
            )
        self._preset_menu.setToolTipsVisible(True)
        file_menu.insertMenu(self.commands["open"], self._preset_menu)
        self._recent_menu = QMenu("Open recent", self)
        self._recent_menu.aboutToShow.connect(self._fill_recent)
        file_menu.insertMenu(save, self._recent_menu)
        view_menu = self.commands.menu("View")
        docks = QMenu("Panels", self)
        for dock in self.docks.values():
            docks.addAction(dock.toggleViewAction())
        view_menu.insertMenu(self.commands["reset_layout"], docks)

    def _fill_recent(self) -> None:
        self._recent_menu.clear()
        paths = self.files.recent.paths()
        for path in paths:
            action = self._recent_menu.addAction(path.name)
            action.setToolTip(str(path))
            action.triggered.connect(lambda _checked=False, path=path: self.files.open_path(path))
        if not paths:
            self._recent_menu.addAction("No recent files").setEnabled(False)
            return
        self._recent_menu.addSeparator()
        self._recent_menu.addAction("Clear list").triggered.connect(self.files.recent.clear)

    def _build_toolbar(self) -> None:
        bar = QToolBar("Toolbar", self)
        bar.setObjectName("toolbar")
        bar.setIconSize(QSize(20, 20))
        bar.setMovable(False)
        for name in ("open", "save", None, "undo", "redo", None):
            bar.addAction(self.commands[name]) if name else bar.addSeparator()
        self._presets_button = QToolButton(bar)
        self._presets_button.setText("Presets")
        icons.bind(self._presets_button, "presets")
        self._presets_button.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextBesideIcon)
        self._presets_button.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
        self._presets_button.setMenu(self._preset_menu)
        self._presets_button.setToolTip("Start from a ready-made shape")
        bar.addWidget(self._presets_button)
        bar.addSeparator()
        for name in ("append_segment", "split_segment", "remove_segment", None, "fit"):
            bar.addAction(self.commands[name]) if name else bar.addSeparator()
        spring = QWidget(bar)
        spring.setSizePolicy(
            spring.sizePolicy().Policy.Expanding, spring.sizePolicy().Policy.Minimum
        )
        bar.addWidget(spring)
        for name in ("export_mesh", "screenshot"):
            bar.addAction(self.commands[name])
            button = bar.widgetForAction(self.commands[name])
            button.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextBesideIcon)
        self.addToolBar(bar)

    # What happens to the window as a whole.

    def _refreshed(self, frame: Frame) -> None:
        self.commands.refresh(frame)
        self._show_title()

    def _show_title(self) -> None:
        self.setWindowTitle(f"{self.files.title}[*] — SGB Studio")
        self.setWindowModified(self.presenter.session.is_modified)

    def set_theme(self, choice: str) -> None:
        """Choose the theme "system", "light" or "dark" for all windows, and remember it."""
        QSettings().setValue("theme", choice)
        theme.apply(QApplication.instance(), choice)
        for window in MainWindow.windows:
            window.theme_choice = choice
            window.commands.reload_icons()
            window._presets_button.setIcon(icons.icon("presets"))
            window.presenter.refresh_now()

    def new_window(self) -> None:
        """Open another window with a document of its own."""
        MainWindow().show()

    def quit(self) -> None:
        """Close every window, asking about each one's unsaved work."""
        QApplication.closeAllWindows()

    def show_palette(self) -> None:
        """Offer every action by its name."""
        entries = [
            (action.text(), action)
            for name, action in self.commands.actions.items()
            if name != "palette"
        ]
        entries += [(f"New: {action.text()}", action) for action in self._preset_menu.actions()]
        CommandPalette(entries, self).show()

    def show_shortcuts(self) -> None:
        """Show the sheet of all keys."""
        help_pages.shortcuts(self, self.commands)

    def show_about(self) -> None:
        """Say what this program is."""
        help_pages.about(self)

    def closeEvent(self, event: QCloseEvent) -> None:
        if not self.files.may_discard():
            event.ignore()
            return
        self.jobs.wait()
        settings = QSettings()
        settings.setValue("geometry", self.saveGeometry())
        settings.setValue("state", self.saveState(LAYOUT_VERSION))
        self.surface_view.shut_down()
        MainWindow.windows.remove(self)
        event.accept()

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.WindowStateChange:
            QTimer.singleShot(0, self.presenter.refresh_now)

    def dragEnterEvent(self, event: QDragEnterEvent) -> None:
        if _dropped_project(event) is not None:
            event.acceptProposedAction()

    def dropEvent(self, event: QDropEvent) -> None:
        path = _dropped_project(event)
        if path is not None:
            event.acceptProposedAction()
            self.files.open_path(path)


def _dropped_project(event: QDropEvent) -> Path | None:
    for url in event.mimeData().urls():
        path = Path(url.toLocalFile())
        if url.isLocalFile() and path.suffix.lower() == SUFFIX:
            return path
    return None


def _scrolled(widget: QWidget) -> QScrollArea:
    area = QScrollArea()
    area.setWidget(widget)
    area.setWidgetResizable(True)
    area.setFrameShape(QScrollArea.Shape.NoFrame)
    area.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
    return area


def run(path: Path | None = None) -> int:
    """Open the window, with the project at ``path`` if given, and run until it is closed."""
    app = QApplication.instance() or QApplication([])
    app.setApplicationName("SGB Studio")
    app.setOrganizationName("SGB Studio")
    theme.apply(app, str(QSettings().value("theme", "system")))
    window = MainWindow()
    window.show()
    if path is not None:
        window.files.open_path(path)
    return int(app.exec())
