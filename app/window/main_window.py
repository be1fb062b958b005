"""The window: which views there are and where they sit. Layout and docks only."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING

from PySide6.QtCore import QEvent, QSettings, Qt, QTimer
from PySide6.QtGui import (
    QCloseEvent,
    QDragEnterEvent,
    QDropEvent,
    QHideEvent,
    QImage,
    QKeyEvent,
)
from PySide6.QtWidgets import QWidget

from app.state import preferences
from app.state.stored import unkept
from app.state.unforeseen import guarded
from app.theme import theme
from app.window.frame import WindowFrame
from app.window.frame import application as application
from app.window.garbage_collector import collect_closed
from app.window.layout import WindowLayout

# All else is loaded when the frame is furnished, which by then can be seen.
if TYPE_CHECKING:
    from app.commands.command import CommandSet
    from app.export.exporter import Exporting
    from app.files.files import Files
    from app.files.safekeeping import Safekeeping
    from app.files.thumbnails import Thumbnails
    from app.intake.commands import Importer
    from app.profile_editor.view import ProfileView
    from app.settings.dialog import PreferencesDialog
    from app.settings.shortcuts import Keys
    from app.start.welcome import Welcome
    from app.state.body_work import BodyWork
    from app.state.jobs import Jobs
    from app.state.path_work import PathWork
    from app.state.preferences import Preferences
    from app.state.presenter import Frame, Presenter
    from app.viewport.view import SurfaceView
    from app.window.menus import WindowMenus
    from app.window.notice_bar import NoticeBar
    from app.window.panels import Panels
    from app.window.status_bar import StatusBar
    from sgb_core.document.model import Document


class MainWindow(WindowFrame):
    """One document in one window."""

    windows: list[MainWindow] = []  # noqa: RUF012 - Qt deletes windows nobody holds

    presenter: Presenter
    jobs: Jobs
    files: Files
    surface_view: SurfaceView
    exporting: Exporting
    importer: Importer
    notice_bar: NoticeBar
    panels: Panels
    body_work: BodyWork
    path_work: PathWork
    status: StatusBar
    commands: CommandSet
    menus: WindowMenus
    keys: Keys
    safekeeping: Safekeeping
    thumbnails: Thumbnails
    welcome: Welcome

    def __init__(self, document: Document | None = None, *, furnished: bool = True) -> None:
        """``furnished`` False leaves it a bare frame, to be shown and then furnished."""
        super().__init__()
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.arrangement = WindowLayout(
            self,
            self.docks,
            lambda: self.surface_view,
            lambda: self.profile_view,
            lambda: self.presenter.refresh_now(),
        )
        self.resized.connect(self.arrangement.follow_size)
        self._furnished = self._keeps_work = False
        self._preferences: PreferencesDialog | None = None
        if furnished:
            self.furnish(document)

    def furnish(self, document: Document | None = None) -> None:
        """Load what the window is for, and put it into the frame."""
        from app.export.exporter import Exporting
        from app.files.files import Files, opening_document
        from app.files.outside_changes import OutsideChanges
        from app.files.safekeeping import Safekeeping
        from app.files.thumbnails import Thumbnails
        from app.intake.commands import Importer
        from app.panels.shape.panel import ShapePanel
        from app.start.welcome import Landmarks, Welcome
        from app.state.jobs import Jobs
        from app.state.presenter import Presenter
        from app.viewport.view import SurfaceView
        from app.window.named_actions import NamedActions
        from sgb_core.document.session import Session

        self.setAcceptDrops(True)
        self.presenter = Presenter(Session(document or opening_document()), self)
        self.jobs = Jobs(self)
        self.files = Files(self.presenter, self, self.jobs)
        self.surface_view = SurfaceView(self.presenter, self)
        self.exporting = Exporting(self.presenter, self.files, self.jobs, self.surface_view, self)
        self.importer = Importer(self.presenter, self, self._fit_all)
        self._place_views()
        self._make_commands()
        self.presenter.refreshed.connect(self._refreshed)
        self.files.path_changed.connect(self._show_title)
        self._by_name = NamedActions(self.commands, self.docks, self.arrangement.go_to, self)
        self.safekeeping = Safekeeping(self.presenter, self.files, self, self._another)
        OutsideChanges(self.presenter, self.files, self)
        self.thumbnails = Thumbnails(self.presenter, self.files, self._grab_viewport)
        landmarks = Landmarks(
            self.panels.of("shape", ShapePanel), self.profile_view, self.surface_view
        )
        self.welcome = Welcome(self, self.presenter, self.files, self.safekeeping, landmarks)
        self.resized.connect(self.welcome.follow_size)
        self._take_preferences(preferences.current())
        preferences.notifier().changed.connect(self._take_preferences)
        preferences.notifier().changed.connect(self._say_unkept)
        MainWindow.windows.append(self)
        self._furnished = True
        for slot in self.panels:
            slot.look()

    def _make_commands(self) -> None:
        from app.commands.command import CommandSet
        from app.settings.shortcuts import Keys
        from app.window.all_commands import all_commands
        from app.window.menus import WindowMenus

        self.commands = CommandSet(self, all_commands(self), self.titles)
        self.profile_view.add_switch(self.commands["live_fair"])
        self.menus = WindowMenus(self, self.commands, self.files, self.docks, self.toolbar)
        self.keys = Keys(self.commands)

    # Layout.

    def _place_views(self) -> None:
        from app.state.body_work import BodyWork
        from app.state.joint_findings import JointFindings
        from app.state.lock_findings import LockFindings
        from app.state.path_work import PathWork
        from app.state.problems import Problems
        from app.window.notice_bar import NoticeBar
        from app.window.panels import Panels
        from app.window.status_bar import StatusBar

        presenter = self.presenter
        self.fill_middle(self.surface_view)
        self.notice_bar = NoticeBar(presenter, self.centralWidget())
        self.panels = Panels(presenter, self, self.docks, self._put_out_lights)
        self.body_work = BodyWork(presenter, self)
        self.path_work = PathWork(presenter, self)
        self.status = StatusBar(presenter, self.jobs, self)
        self.setStatusBar(self.status)
        for view in (
            self.surface_view,
            *self.panels,
            self.body_work,
            self.path_work,
            self.status,
            JointFindings(presenter),
            Problems(presenter),
            LockFindings(presenter),
        ):
            presenter.add_view(view)

    @property
    def profile_view(self) -> ProfileView:
        """The profile editor, which is one of the panels."""
        from app.profile_editor.view import ProfileView

        return self.panels.of("profile", ProfileView)

    def _fit_all(self) -> None:
        """Show the whole of another profile in both views."""
        self.profile_view.fit()
        self.surface_view.fit()

    def walked(self) -> list[QWidget]:
        """Return what the keyboard can walk through: the viewport, a notice, and the panels."""
        viewport: QWidget = self.surface_view.plotter or self.surface_view
        # A dock lends the editor away while that fills the window alone.
        docked = [dock.widget() for dock in self.docks.values()]
        parts = [viewport, self.notice_bar, self.profile_view, *docked]
        return list(dict.fromkeys(part for part in parts if part is not None))

    def _put_out_lights(self, shown: bool = False) -> None:
        """Forget what is pointed at where a panel goes from under a pointer that rests."""
        if not shown:
            self.presenter.set_view(hover=None, angle=None, mark=None)

    def save_copy(self) -> bool:
        """Ask for a file, and save a copy there."""
        return self.files.save_copy()

    # What happens to the window as a whole.

    def _refreshed(self, frame: Frame) -> None:
        self.commands.refresh(frame)
        self._show_title()

    def _show_title(self) -> None:
        title, modified = f"{self.files.title}[*] — SGB Studio", self.presenter.session.is_modified
        # Either asks the window system, which costs more than a whole tick of a slider.
        if title != self.windowTitle():
            self.setWindowTitle(title)
        if modified != self.isWindowModified():
            self.setWindowModified(modified)

    def set_theme(self, choice: theme.Choice) -> None:
        """Choose the theme for all windows, and remember it."""
        QSettings().setValue("theme", choice)
        theme.apply(application(), choice)
        self._say_unkept()
        for window in MainWindow.windows:
            window.presenter.refresh_now()

    def new_window(self) -> None:
        """Open another window with a document of its own."""
        MainWindow().show()

    def _another(self) -> Safekeeping:
        self.new_window()
        return MainWindow.windows[-1].safekeeping

    def end(self) -> None:
        """Close without asking; unsaved work is kept, to be offered at the next start."""
        self._keeps_work = True
        self.jobs.cancel_all()
        self.close()

    def show_palette(self) -> None:
        """Offer every action by its name."""
        from app.commands.asked import asked
        from app.commands.palette import CommandPalette

        below, ask = self.notice_bar.foot, partial(asked, self.presenter)
        CommandPalette(self._by_name.entries(), self, asked=ask, below=below).show()

    def show_preferences(self) -> None:
        """Show the preferences beside the window."""
        if self._preferences is None:
            from app.settings.dialog import PreferencesDialog
            from app.settings.shortcut_editor import KeyEditor

            editor = KeyEditor(self.commands, self.keys, _reload_keys)
            self._preferences = PreferencesDialog(self.set_theme, editor, self)
        self._preferences.show()
        self._preferences.raise_()
        self._preferences.activateWindow()

    def _take_preferences(self, wanted: Preferences) -> None:
        self.surface_view.set_navigation_style(wanted.navigation_style)

    def _say_unkept(self, _wanted: Preferences | None = None) -> None:
        place = unkept()
        if place:
            self.presenter.notify(
                f"Preferences hold until the program ends: {place} cannot be written.", "warning"
            )

    def _grab_viewport(self) -> QImage | None:
        plotter = self.surface_view.plotter
        return None if plotter is None else plotter.grabFramebuffer()

    def show_shortcuts(self) -> None:
        """Show the sheet of all keys."""
        from app.window import help_pages

        help_pages.shortcuts(self, self.commands)

    def show_about(self) -> None:
        """Say what this program is."""
        from app.window import help_pages

        help_pages.about(self)

    def closeEvent(self, event: QCloseEvent) -> None:
        from app.state.jobs import Jobs

        if not self._furnished or (not self._keeps_work and not self.files.may_discard()):
            event.ignore()
            return
        # Whatever fails in one part, the others end as they should, and the window goes.
        guarded(self.welcome.tour.stop)()
        for jobs in self.findChildren(Jobs):
            guarded(jobs.close)()
        guarded(self.body_work.stop)()
        guarded(self.safekeeping.stop)(keep=self._keeps_work)
        guarded(self.arrangement.save)()
        guarded(self.surface_view.shut_down)()
        MainWindow.windows.remove(self)
        collect_closed()
        event.accept()

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.WindowStateChange and self._furnished:
            QTimer.singleShot(0, self.presenter.refresh_now)

    def hideEvent(self, event: QHideEvent) -> None:
        if self._furnished:
            self._put_out_lights()
        super().hideEvent(event)

    def focusNextPrevChild(self, forward: bool) -> bool:
        from app.commands import focus_walk

        return focus_walk.tab(lambda: super(MainWindow, self).focusNextPrevChild(forward))

    def keyPressEvent(self, event: QKeyEvent) -> None:
        # What no view wanted: with nothing under way Escape brings the other views back, and
        # the viewport's own keys turn it from anywhere.
        navigator = self.surface_view.navigator if self.surface_view.isVisible() else None
        held = event.modifiers() & ~Qt.KeyboardModifier.KeypadModifier
        if event.key() == Qt.Key.Key_Escape and self.arrangement.alone is not None:
            self.arrangement.leave_alone()
        elif event.key() == Qt.Key.Key_Escape and self.welcome.hints.put_away():
            event.accept()
        elif navigator is None or not navigator.look(Qt.Key(event.key()), held):
            super().keyPressEvent(event)

    def dragEnterEvent(self, event: QDragEnterEvent) -> None:
        from app.window import drops

        drops.enter(event, self.importer)

    def dropEvent(self, event: QDropEvent) -> None:
        from app.window import drops

        drops.drop(event, self.files, self.importer)


def _reload_keys() -> None:
    for window in MainWindow.windows:
        window.keys.load()
