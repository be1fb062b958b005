"""Pictures of recent files: taken off the viewport on opening and saving, kept in a cache."""

from __future__ import annotations

import hashlib
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path

from PySide6.QtCore import QBuffer, QIODevice, QObject, QRect, QSize, Qt, QTimer
from PySide6.QtGui import QImage, QImageWriter, QPixmap

from app.files.files import RECENT_LIMIT, Files
from app.files.silhouette import silhouette_image
from app.state import user_folders
from app.state.presenter import Frame, Presenter
from sgb_core.document.errors import FileError
from sgb_core.document.file import project_file
from sgb_core.document.file.atomic import write_whole

SIDE = 208
# By then an opened file has been drawn in full.
SETTLED_MILLISECONDS = 900
# Files up to this size are read for their outline.
OUTLINED_BYTES = 2_000_000


def picture_of(path: Path) -> QPixmap:
    """Return the picture of a project file as it was last seen here; null where it never was."""
    return QPixmap(str(_place(path)))


def outline_of(path: Path) -> QImage:
    """Return the outline of a project file, on any thread.

    Null where it cannot be read, or is so large that nobody would wait for an outline.
    """
    try:
        if path.stat().st_size <= OUTLINED_BYTES:
            return silhouette_image(project_file.load(path), SIDE)
    except (OSError, FileError):
        # A file without a picture is no loss that anybody should be told of.
        return QImage()
    return QImage()


def _place(path: Path) -> Path:
    name = hashlib.sha256(str(path.resolve()).encode()).hexdigest()[:24]
    return user_folders.thumbnails() / f"{name}.png"


class Thumbnails(QObject):
    """Takes the picture of one window's file whenever it is opened or saved."""

    def __init__(
        self, presenter: Presenter, files: Files, grab: Callable[[], QImage | None]
    ) -> None:
        """``grab`` returns what the viewport shows, None while it shows nothing."""
        super().__init__(files)
        self._presenter = presenter
        self._files = files
        self._grab = grab
        self._shown: Frame | None = None
        self._timer = QTimer(self, singleShot=True, interval=SETTLED_MILLISECONDS)
        self._timer.timeout.connect(self.take)
        presenter.refreshed.connect(self._refreshed)
        files.path_changed.connect(self._file_changed)

    def take(self) -> bool:
        """Keep a picture of the saved document, where that is what the viewport shows."""
        path, session = self._files.path, self._presenter.session
        shown = None if self._shown is None else self._shown.document
        if path is None or session.is_modified or shown is not session.document:
            return False
        image = self._grab()
        if image is None or image.isNull():
            return False
        write(path, image)
        return True

    def _refreshed(self, frame: Frame) -> None:
        self._shown = frame

    def _file_changed(self) -> None:
        # A saved document is on the screen already, an opened one will be in a moment.
        if not self.take():
            self._timer.start()


def write(path: Path, image: QImage) -> None:
    """Keep ``image``, its middle square made small, as the picture of a project file."""
    side = min(image.width(), image.height())
    middle = QRect(0, 0, side, side)
    middle.moveCenter(image.rect().center())
    small = image.copy(middle).scaled(
        QSize(SIDE, SIDE),
        Qt.AspectRatioMode.IgnoreAspectRatio,
        Qt.TransformationMode.SmoothTransformation,
    )
    buffer = QBuffer()
    buffer.open(QIODevice.OpenModeFlag.WriteOnly)
    QImageWriter(buffer, b"png").write(small.convertToFormat(QImage.Format.Format_RGB888))
    place = _place(path)
    # A file without a picture is no loss that anybody should be told of.
    with suppress(OSError, FileError):
        place.parent.mkdir(parents=True, exist_ok=True)
        write_whole(place, lambda stream: stream.write(buffer.data().data()))
        _prune(place.parent)


def _prune(folder: Path) -> None:
    kept = sorted(folder.glob("*.png"), key=lambda each: each.stat().st_mtime, reverse=True)
    for old in kept[2 * RECENT_LIMIT :]:
        old.unlink(missing_ok=True)
