"""Asks before a file is overwritten that others have changed, or work on."""

from __future__ import annotations

from datetime import datetime
from enum import Enum
from pathlib import Path

from PySide6.QtWidgets import QDialog, QGridLayout, QHBoxLayout, QLabel, QPushButton, QWidget

from app.files.silhouette import silhouette
from sgb_core.document.errors import FileError
from sgb_core.document.file import project_file
from sgb_core.document.file.versions import Version
from sgb_core.document.model import Document
from sgb_core.values import dataclass

SIDE = 140


class Answer(Enum):
    """What is to become of the two versions."""

    SAVE_AS = "Save as…"
    COMPARE = "Compare"
    OVERWRITE = "Overwrite"
    CANCEL = "Cancel"


TIPS = {
    Answer.SAVE_AS: "Keep both: save this version under another name",
    Answer.COMPARE: "Save nothing yet, and lay the version on the disk over this one as a ghost",
    Answer.OVERWRITE: "Replace the version on the disk; it is kept as a backup",
    Answer.CANCEL: "Save nothing (Esc)",
}


@dataclass(frozen=True, slots=True)
class Conflict:
    """Two versions of a file: that on the disk, None where it is as it was opened, and ours.

    ``base`` is the version that ours began from; ``elsewhere`` says that another window or
    program has the file open.
    """

    path: Path
    ours: Document
    base: Version | None
    disk: Version | None
    elsewhere: bool

    @property
    def words(self) -> str:
        """What is at stake, in a sentence or two."""
        found = []
        if self.disk is not None:
            found.append(f"{self.path.name} was changed on the disk since it was opened here.")
        if self.elsewhere:
            found.append(f"{self.path.name} is open in another window.")
        return " ".join(found)

    def theirs(self) -> Document | None:
        """Return the document on the disk, None where it cannot be read."""
        try:
            return project_file.load(self.path)
        except FileError:
            return None


def ask(conflict: Conflict, parent: QWidget) -> Answer:
    """Show both versions with their times, and return what is to be done."""
    dialog = ConflictDialog(conflict, parent)
    dialog.exec()
    return dialog.answer


class ConflictDialog(QDialog):
    """The question; closing it saves nothing."""

    def __init__(self, conflict: Conflict, parent: QWidget) -> None:
        super().__init__(parent)
        self.setWindowTitle("Save")
        self.answer = Answer.CANCEL
        words = QLabel(conflict.words, self)
        words.setWordWrap(True)
        grid = QGridLayout(self)
        grid.addWidget(words, 0, 0, 1, 2)
        base = "never saved" if conflict.base is None else f"opened or saved {_time(conflict.base)}"
        disk = conflict.disk or conflict.base
        theirs = conflict.theirs()
        for column, (title, when, document) in enumerate(
            (
                ("This window", f"from what was {base}", conflict.ours),
                ("On the disk", f"written {_time(disk)}" if disk else "", theirs),
            )
        ):
            picture = QLabel(self)
            if document is not None:
                picture.setPixmap(silhouette(document, SIDE))
            else:
                picture.setText("It cannot be read.")
            picture.setAccessibleName(f"Picture: {title}")
            grid.addWidget(picture, 1, column)
            grid.addWidget(QLabel(f"<b>{title}</b><br>{when}", self), 2, column)
        row = QHBoxLayout()
        self.buttons = {answer: self._button(answer) for answer in Answer}
        self.buttons[Answer.COMPARE].setEnabled(theirs is not None)
        for button in self.buttons.values():
            row.addWidget(button)
        self.buttons[Answer.SAVE_AS].setDefault(True)
        grid.addLayout(row, 3, 0, 1, 2)

    def _button(self, answer: Answer) -> QPushButton:
        button = QPushButton(answer.value, self)
        button.setToolTip(TIPS[answer])
        button.setAutoDefault(False)
        button.clicked.connect(lambda: self._end(answer))
        return button

    def _end(self, answer: Answer) -> None:
        self.answer = answer
        self.accept()


def _time(version: Version) -> str:
    return datetime.fromtimestamp(version.seconds).strftime("%d %b %Y, %H:%M:%S")
