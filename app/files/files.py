"""Opening, saving and never losing a document: the File menu's behaviour."""

from __future__ import annotations

from os.path import isfile
from pathlib import Path

from PySide6.QtCore import QObject, QSettings, Signal
from PySide6.QtWidgets import QFileDialog, QMessageBox, QWidget

import resources
from app.commands.segment_kinds import offer_head_to_tail
from app.files.conflict import Answer, Conflict, ask
from app.files.custody import Custody
from app.state import preferences, written_folders
from app.state.blank import blank_document
from app.state.jobs import Job, Jobs, Report
from app.state.presenter import Presenter
from app.state.stored import stored_words
from app.state.window_reader import told, why
from sgb_core.curves.parameter_fan import most_telling
from sgb_core.document import edits
from sgb_core.document.evaluation import Evaluation, prepared
from sgb_core.document.file import project_file
from sgb_core.document.file.project_file import FileError
from sgb_core.document.file.versions import Version, version_of
from sgb_core.document.model import Document
from sgb_core.findings.finding import Finding
from sgb_core.findings.line import InFile
from sgb_core.values import dataclass

SUFFIX = ".sgb"
FILTER = "SGB Studio project (*.sgb)"
RECENT_LIMIT = 10
OPENING_PRESET = "vase"
# A file of so many bytes is read within a fifth of a second, checks included.
READ_AT_ONCE = 50_000


@dataclass(frozen=True, slots=True)
class _Read:
    """A file that was read: its document, with what all views ask of it, or why there is none."""

    path: Path
    base: Version | None
    found: Evaluation | Finding


def _read(path: Path, report: Report = lambda _fraction: None) -> _Read:
    # Of before the reading: what changes meanwhile is seen when it is saved.
    base = version_of(path)
    report(0.1)
    try:
        document = project_file.load(path)
    except FileError as error:
        found = error.finding
        return _Read(path, base, found.finding if isinstance(found, InFile) else found)
    # Cancelled at the very last, it is not shown either.
    return _Read(path, base, prepared(document, lambda part: report(0.4 + 0.6 * part)))


def _bytes_in(path: Path) -> int:
    try:
        return path.stat().st_size
    except (OSError, ValueError):
        return 0


class RecentFiles:
    """The paths opened or saved last, newest first, remembered between sessions."""

    KEY = "recent_files"

    def paths(self) -> list[Path]:
        """Return the remembered paths that still exist."""
        # Not Path.is_file, which raises where a folder cannot be looked into.
        return [path for path in map(Path, stored_words(self.KEY)) if isfile(path)]

    def add(self, path: Path) -> None:
        """Put ``path`` first."""
        path = path.resolve()
        rest = [other for other in self.paths() if other != path]
        QSettings().setValue(self.KEY, [str(p) for p in [path, *rest][:RECENT_LIMIT]])

    def clear(self) -> None:
        """Forget all."""
        QSettings().remove(self.KEY)


class Files(QObject):
    """The file that one window's document lives in."""

    path_changed = Signal()

    def __init__(self, presenter: Presenter, window: QWidget, jobs: Jobs) -> None:
        super().__init__(window)
        self._presenter = presenter
        self._window = window
        self._jobs = jobs
        self._opening: Job | None = None
        self.path: Path | None = None
        self.custody = Custody()
        self.recent = RecentFiles()

    @property
    def title(self) -> str:
        """What the window's title calls the document."""
        return self.path.stem if self.path else self._presenter.document.name

    def new_from_preset(self, name: str) -> bool:
        """Show a preset as a new, unsaved document; returns whether it was shown."""
        if not self.may_discard():
            return False
        document = project_file.loads(resources.load_preset(name))
        self._show(edits.set_unit(document, preferences.current().new_unit, convert=True), None)
        # The first slider that a hand takes shows something.
        self._presenter.select(most_telling(document.profile))
        return True

    def new_blank(self) -> bool:
        """Show one plain segment as a new, unsaved document; returns whether it was shown."""
        if not self.may_discard():
            return False
        self._show(blank_document(), None)
        return True

    def open(self) -> bool:
        """Ask for a project file and open it."""
        start = str(self.path.parent) if self.path else ""
        name, _ = QFileDialog.getOpenFileName(self._window, "Open project", start, FILTER)
        return bool(name) and self.open_path(Path(name))

    def open_path(self, path: Path) -> bool:
        """Open a project file; a bad one leaves the present document and says why.

        A large one is read aside, with its progress in the status bar; only the last one asked
        for is shown. Returns whether it was opened, or is being read.
        """
        if self._opening is not None:
            self._opening.cancel()
            self._opening = None
        if _bytes_in(path) <= READ_AT_ONCE:
            return self._show_read(_read(path))
        self._opening = Job(
            f"Opening {path.name}",
            lambda report: _read(path, report),
            self._opened,
            self._not_read,
            lambda: self._presenter.notify(f"Opening {path.name} was cancelled."),
        )
        self._jobs.start(self._opening)
        return True

    def _opened(self, read: _Read) -> None:
        self._opening = None
        self._show_read(read)

    def _not_read(self, error: Exception) -> None:
        self._opening = None
        raise error

    def _show_read(self, read: _Read) -> bool:
        path, found = read.path, read.found
        if not isinstance(found, Evaluation):
            self._presenter.notify(f"Could not open {path.name}: {told(found)}", "error")
            return False
        if not self.may_discard():
            return False
        self._show(found.document, path, read.base, found)
        self.recent.add(path)
        for finding in found.findings[:1]:
            self._presenter.notify(f"{path.name}: {told(finding)}", "warning")
        offer_head_to_tail(self._presenter)
        if not self.custody.holds(path):
            self._presenter.notify(
                f"{path.name} is open in another window too; saving will ask.",
                "warning",
                stays=True,
            )
        return True

    def save(self) -> bool:
        """Save to the document's own file, or ask for one; returns whether it was saved."""
        return self._write(self.path) if self.path else self.save_as()

    def save_as(self) -> bool:
        """Ask for a file and save to it."""
        start = str(self.path or Path.home() / f"{self._presenter.document.name}{SUFFIX}")
        name, _ = QFileDialog.getSaveFileName(self._window, "Save project as", start, FILTER)
        if not name:
            return False
        path = Path(name)
        return self._write(path if path.suffix else path.with_suffix(SUFFIX))

    def save_copy(self) -> bool:
        """Ask for a file and write the document there; this window keeps its own file."""
        start = str((self.path or Path.home() / "x").with_name(f"{self.title} copy{SUFFIX}"))
        name, _ = QFileDialog.getSaveFileName(self._window, "Save a copy", start, FILTER)
        if not name:
            return False
        path = Path(name) if Path(name).suffix else Path(name).with_suffix(SUFFIX)
        written_folders.note(path)
        try:
            project_file.save(self._presenter.document, path)
        except FileError as error:
            self._presenter.notify(f"Could not save: {why(error)}", "error")
            return False
        self._presenter.notify(f"Saved a copy as {path.name}.")
        return True

    def show_unsaved(self, document: Document, path: Path | None, seconds: float) -> None:
        """Show restored work as not saved; saving it writes to ``path``, where there is one.

        ``seconds`` is when it was done, as a Unix time: a file that is younger is not its base.
        """
        self.path = path
        base = None if path is None else version_of(path)
        self.custody.take(path, base if base is None or base.seconds <= seconds else None)
        self._presenter.replace_document(document, saved=False)
        self.path_changed.emit()

    def may_discard(self) -> bool:
        """Ask about unsaved work; returns whether the document may be let go."""
        if not self._presenter.session.is_modified:
            return True
        button = QMessageBox.StandardButton
        answer = QMessageBox.warning(
            self._window,
            "Unsaved changes",
            f"“{self.title}” has changes that are not saved.",
            button.Save | button.Discard | button.Cancel,
            button.Save,
        )
        if answer == button.Save:
            return self.save()
        return answer == button.Discard

    def _write(self, path: Path) -> bool:
        # What is saved is what remains: a gesture that only shows something is taken back.
        self._presenter.session.commit()
        answer = self._asked(path)
        if answer is not Answer.OVERWRITE:
            return answer is Answer.SAVE_AS and self.save_as()
        self.custody.back_up(path)
        written_folders.note(path)
        try:
            project_file.save(self._presenter.document, path)
        except FileError as error:
            self._presenter.notify(
                f"Could not save: {why(error)}", "error", "Save as…", self._retry_elsewhere
            )
            return False
        self._presenter.session.mark_saved()
        self.path = path
        self.custody.take(path, version_of(path))
        self.recent.add(path)
        self._presenter.set_view(ghost=None)
        self.path_changed.emit()
        self._presenter.notify(f"Saved {path.name}.")
        return True

    def _asked(self, path: Path) -> Answer:
        """Ask where others have changed the file or work on it, else return to write it."""
        disk, elsewhere = self.custody.foreign(path), not self.custody.holds(path)
        if disk is None and not elsewhere:
            return Answer.OVERWRITE
        conflict = Conflict(path, self._presenter.document, self.custody.base, disk, elsewhere)
        answer = ask(conflict, self._window)
        if answer is Answer.COMPARE:
            self._presenter.set_view(ghost=conflict.theirs())
            self._presenter.notify(
                f"{path.name} as it is on the disk lies over this version; nothing is saved.",
                "warning",
                "Hide it",
                lambda: self._presenter.set_view(ghost=None),
            )
        return answer

    def _retry_elsewhere(self) -> None:
        self.save_as()

    def _show(
        self,
        document: Document,
        path: Path | None,
        base: Version | None = None,
        evaluation: Evaluation | None = None,
    ) -> None:
        self.path = path
        self.custody.take(path, base)
        self._presenter.replace_document(document, evaluation=evaluation)
        self.path_changed.emit()


def opening_document() -> Document:
    """Return the handsome shape on which the window opens."""
    return project_file.loads(resources.load_preset(OPENING_PRESET))
