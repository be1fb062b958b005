"""Asks what to draw on paper and shows the page as it will be printed."""

from __future__ import annotations

from pathlib import Path

from PySide6.QtCore import Qt, QTimer
from PySide6.QtWidgets import (
    QComboBox,
    QDialog,
    QDialogButtonBox,
    QFileDialog,
    QHBoxLayout,
    QLabel,
    QListWidget,
    QPushButton,
    QVBoxLayout,
    QWidget,
)

from app.drawings import clipboard
from app.drawings.choices import Choices, Chosen
from app.drawings.page_view import PageView
from app.drawings.picture import DPI, PNG
from app.drawings.sort import Sort
from app.files.files import FILTER
from app.state.jobs import Job, Jobs
from app.state.window_reader import reason, why
from app.widgets.form import named, offering
from app.widgets.labels import take_labels
from app.widgets.number_field import NumberField
from sgb_core.document.errors import FileError
from sgb_core.document.file import project_file
from sgb_core.document.model import Document
from sgb_core.document.plates import MAX_DPI, MIN_DPI
from sgb_core.drawings.comparison_plate import comparison_plate
from sgb_core.drawings.curvature_figure import curvature_figure
from sgb_core.drawings.drawing import draw
from sgb_core.drawings.page import Drawing
from sgb_core.drawings.template import template

# How long to wait for the next change before the page is drawn, in milliseconds.
_PAUSE = 150


class DrawingDialog(QDialog):
    """Sort, paper, scale and more; the caller asks for the file and writes ``drawing``."""

    def __init__(
        self, document: Document, parent: QWidget | None = None, sort: Sort = Sort.SECTION
    ) -> None:
        super().__init__(parent)
        self.setWindowTitle("Drawing on paper")
        self._document = document
        self._others: list[Document] = []
        self._page = 0
        self.drawing: Drawing | None = None
        self._jobs = Jobs(self)
        self._timer = QTimer(self, singleShot=True, interval=_PAUSE)
        self._timer.timeout.connect(self._make)
        self.choices = Choices()
        self.view = PageView()
        self.told = QLabel()
        self.others = QListWidget()
        self.add_files = QPushButton("Add files…")
        self.remove_file = QPushButton("Remove")
        self.format = QComboBox()
        self.dpi = NumberField(
            minimum=MIN_DPI, maximum=MAX_DPI, step=50.0, whole=True, reset=DPI, unit="dpi"
        )
        self.back, self.forth = QPushButton("◀"), QPushButton("▶")
        self.where = QLabel()
        self._build()
        self._connect()
        self.choices.sort.setCurrentIndex(self.choices.sort.findData(sort))
        self._adapt()
        self._later()

    def _build(self) -> None:
        self.told.setWordWrap(True)
        self.told.setAccessibleName("Scale and paper")
        self.told.setMinimumHeight(4 * self.told.fontMetrics().height())
        self.told.setAlignment(Qt.AlignmentFlag.AlignTop)
        named(self.others, "Further vessels", "The other vessels on the plate, after this one")
        named(self.add_files, "Add files", "Put vessels of other project files on the plate")
        named(self.remove_file, "Remove", "Take the vessel chosen in the list off the plate")
        named(self.format, "Format", "The kind of file to save")
        named(self.dpi, "Resolution", "Pixels to the inch of the picture")
        named(self.back, "Page before", "Show the page before")
        named(self.forth, "Next page", "Show the next page")
        self.files = QWidget()
        files, row = QVBoxLayout(self.files), QHBoxLayout()
        files.setContentsMargins(0, 0, 0, 0)
        files.addWidget(self.others)
        row.addWidget(self.add_files)
        row.addWidget(self.remove_file)
        files.addLayout(row)
        left, formats = QVBoxLayout(), QHBoxLayout()
        formats.addWidget(QLabel("Format"))
        formats.addWidget(self.format, 1)
        formats.addWidget(self.dpi)
        left.addWidget(self.choices)
        left.addWidget(self.files, 1)
        left.addLayout(formats)
        left.addWidget(self.told)
        left.addStretch(0)
        pages, right = QHBoxLayout(), QVBoxLayout()
        pages.addStretch(1)
        for widget in (self.back, self.where, self.forth):
            pages.addWidget(widget)
        pages.addStretch(1)
        right.addWidget(self.view, 1)
        right.addLayout(pages)
        columns = QHBoxLayout()
        columns.addLayout(left, 2)
        columns.addLayout(right, 3)
        buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Cancel)
        self.copy = buttons.addButton("Copy page", QDialogButtonBox.ButtonRole.ActionRole)
        tip = "Put the page on the clipboard as PDF, SVG and picture"
        named(self.copy, "Copy page", tip)
        self.save = buttons.addButton("Save…", QDialogButtonBox.ButtonRole.AcceptRole)
        named(self.save, "Save", "Ask for a file name and write the drawing")
        buttons.accepted.connect(self.accept)
        buttons.rejected.connect(self.reject)
        layout = QVBoxLayout(self)
        layout.addLayout(columns, 1)
        layout.addWidget(buttons)
        self.resize(900, 620)
        take_labels(self)

    def _connect(self) -> None:
        choices = self.choices
        for box in (choices.paper, choices.scale, choices.side, choices.fill):
            box.currentIndexChanged.connect(self._later)
        for box in (choices.stage, choices.wall):
            box.currentIndexChanged.connect(self._later)
        self.format.currentIndexChanged.connect(lambda: self.dpi.setVisible(self.suffix == PNG))
        choices.sort.currentIndexChanged.connect(self._adapt)
        choices.sort.currentIndexChanged.connect(self._later)
        choices.first.changed.connect(self._later)
        self.add_files.clicked.connect(self._add)
        self.remove_file.clicked.connect(self._remove)
        self.back.clicked.connect(lambda: self._turn(-1))
        self.forth.clicked.connect(lambda: self._turn(1))
        self.copy.clicked.connect(self._copy)

    @property
    def suffix(self) -> str:
        """The suffix of the file that is wanted."""
        return str(self.format.currentData())

    def _adapt(self) -> None:
        kept = self.format.currentData()
        self.format.clear()
        offering(self.format, [(each[1:].upper(), each) for each in self.choices.suffixes])
        self.format.setCurrentIndex(max(0, self.format.findData(kept)))
        self.files.setVisible(self.choices.chosen_sort is Sort.VESSEL)

    def _add(self) -> None:
        names, _ = QFileDialog.getOpenFileNames(self, "Vessels of the plate", "", FILTER)
        for name in names:
            try:
                document = project_file.load(name)
            except (FileError, ValueError) as error:
                self.told.setText(f"{Path(name).name}: {why(error)}")
                return
            self._others.append(document)
            self.others.addItem(document.name)
        self._later()

    def _remove(self) -> None:
        row = self.others.currentRow()
        if row >= 0:
            self.others.takeItem(row)
            self._others.pop(row)
            self._later()

    def _later(self) -> None:
        # What is still being drawn is of choices that no longer hold.
        self._jobs.drop_all()
        self.drawing = None
        self.save.setEnabled(False)
        self.copy.setEnabled(False)
        self._timer.start()

    def _make(self) -> None:
        chosen, document = self.choices.chosen, self._document
        vessels = (document, *self._others) if chosen.sort is Sort.VESSEL else (document,)
        self.told.setText("…")
        self._jobs.start(
            Job("Drawing", lambda _: _drawn(vessels, chosen), self._show, self._refused)
        )

    def _show(self, drawing: Drawing) -> None:
        self.drawing = drawing
        self._page = min(self._page, len(drawing.pages) - 1)
        self.told.setText(f"{drawing.subject}.")
        self.save.setEnabled(True)
        self.copy.setEnabled(True)
        self._turn(0)

    def _refused(self, error: Exception) -> None:
        self.drawing = None
        self.view.show_page(None)
        self.where.clear()
        self.told.setText(reason(error))

    def _turn(self, step: int) -> None:
        if self.drawing is None:
            return
        pages = self.drawing.pages
        self._page = min(max(self._page + step, 0), len(pages) - 1)
        self.view.show_page(pages[self._page])
        self.where.setText(f"Page {self._page + 1} of {len(pages)}")
        self.back.setEnabled(self._page > 0)
        self.forth.setEnabled(self._page < len(pages) - 1)

    def _copy(self) -> None:
        if self.drawing is not None:
            clipboard.copy_page(self.drawing, self._page)
            self.told.setText("Copied the page to the clipboard.")

    def done(self, result: int) -> None:
        """End with what is being drawn dropped."""
        self._timer.stop()
        self._jobs.drop_all()
        self._jobs.wait()
        super().done(result)


def _drawn(documents: tuple[Document, ...], chosen: Chosen) -> Drawing:
    match chosen.sort:
        case Sort.TEMPLATE:
            return template(documents[0], chosen.template)
        case Sort.CURVES:
            return comparison_plate(documents[0])
        case Sort.CURVATURE:
            return curvature_figure(documents[0])
    return draw(documents, chosen.wanted)
