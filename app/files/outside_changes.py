"""Tells at once that another program has changed or removed the file that a window works on."""

from __future__ import annotations

import os
from pathlib import Path

from PySide6.QtCore import QEvent, QFileSystemWatcher, QObject, QTimer
from PySide6.QtWidgets import QWidget

from app.files.files import Files
from app.state.presenter import Presenter
from app.state.window_reader import why
from sgb_core.document.errors import FileError
from sgb_core.document.file import project_file

# Programs write in several steps; what they leave is looked at.
SETTLED_MS = 300
GONE = "gone"


class OutsideChanges(QObject):
    """Watches one window's file, and looks again whenever the window is turned to.

    Systems do not tell of changes in every folder, such as those on other machines.
    """

    def __init__(self, presenter: Presenter, files: Files, window: QWidget) -> None:
        super().__init__(window)
        self._presenter = presenter
        self._files = files
        self._told = ""
        self._seen: tuple[int, int] | None = None
        self._watcher = QFileSystemWatcher(self)
        self._timer = QTimer(self)
        self._timer.setSingleShot(True)
        self._timer.setInterval(SETTLED_MS)
        self._timer.timeout.connect(self.look)
        self._watcher.fileChanged.connect(lambda _path: self._timer.start())
        self._watcher.directoryChanged.connect(lambda _path: self._timer.start())
        files.path_changed.connect(self._follow)
        window.installEventFilter(self)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() == QEvent.Type.WindowActivate:
            self._timer.start()
        return super().eventFilter(watched, event)

    def _follow(self) -> None:
        """Watch the window's file and its folder: writing anew replaces the file in it."""
        self._told, self._seen = "", None
        watched = [*self._watcher.files(), *self._watcher.directories()]
        if watched:
            self._watcher.removePaths(watched)
        self._watch()

    def _watch(self) -> None:
        path = self._files.path
        if path is not None:
            places = [str(place) for place in (path, path.parent) if os.path.exists(place)]
            known = {*self._watcher.files(), *self._watcher.directories()}
            new = [place for place in places if place not in known]
            if new:
                self._watcher.addPaths(new)

    def look(self) -> None:
        """Say what others have done to the file, once for each version that they leave."""
        path = self._files.path
        if path is None:
            return
        self._watch()
        seen = _looks(path)
        if seen is None:
            if self._files.custody.base is not None:
                self._tell(GONE, path)
        elif seen != self._seen:
            foreign = self._files.custody.foreign(path)
            self._tell(foreign.digest if foreign is not None else "", path)
        self._seen = seen

    def _tell(self, what: str, path: Path) -> None:
        if what in (self._told, ""):
            self._told = what
            return
        self._told = what
        if what == GONE:
            self._presenter.notify(
                f"{path.name} is no longer where it was; this window still holds it.",
                "warning",
                "Save",
                self._files.save,
            )
        elif self._presenter.session.is_modified:
            self._presenter.notify(
                f"Another program has changed {path.name}; saving will ask.",
                "warning",
                "Compare",
                self._compare,
            )
        else:
            self._presenter.notify(
                f"Another program has changed {path.name}.",
                "warning",
                "Show it",
                lambda: self._files.open_path(path),
            )

    def _compare(self) -> None:
        path = self._files.path
        if path is None:
            return
        try:
            self._presenter.set_view(ghost=project_file.load(path))
        except FileError as error:
            self._presenter.notify(f"Could not compare: {why(error)}", "error")


def _looks(path: Path) -> tuple[int, int] | None:
    """Return when a file was written and how large it is; None where it cannot be found."""
    try:
        found = path.stat()
    except (OSError, ValueError):
        return None
    return found.st_mtime_ns, found.st_size
