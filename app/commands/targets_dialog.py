"""Reaching targets: what is wanted, by what, seen as soon as it is found."""

from __future__ import annotations

from functools import partial

from PySide6.QtCore import Qt
from PySide6.QtWidgets import (
    QCheckBox,
    QDialog,
    QDialogButtonBox,
    QFormLayout,
    QGridLayout,
    QHBoxLayout,
    QLabel,
    QPushButton,
    QVBoxLayout,
    QWidget,
)

from app.commands.fairing import moved_words
from app.commands.targets import LABEL, LINES, WAYS, Asked, Line, Search, values_now
from app.state.edit_gesture import EditGesture
from app.state.jobs import Jobs
from app.state.presenter import Frame, Presenter
from app.state.window_reader import reason
from app.widgets.combo_box import QuietComboBox
from app.widgets.form import named, offering
from app.widgets.number_field import NumberField
from app.widgets.quantity import format_number
from sgb_core.curves.segment import PARAMETERS, SYMBOLS
from sgb_core.design.fairing.findings import Keep
from sgb_core.design.solving.goals import Goal
from sgb_core.design.solving.solve import Solved
from sgb_core.design.solving.ways import Slider, Way
from sgb_core.document.edits.solve import OutOfReachError
from sgb_core.document.model import Document

_KEEPS = {
    Keep.ENDS: ("The ends", "Both ends of the profile stay in their places"),
    Keep.TANGENTS: ("Directions of all legs", "Points move along their legs, none of which turns"),
}
_ONE = "one shape parameter"
_FIELD, _TOLD = 110, 44


class TargetLine:
    """One line of the dialog: whether it is wanted, its value, and what it is now."""

    def __init__(self, line: Line) -> None:
        self.line = line
        self.check = QCheckBox(line.words)
        self.check.setToolTip(f"{line.tip}; ticked, it is reached or kept")
        self.field = NumberField(minimum=0.0, above_minimum=True, decimals=3)
        self.field.setFixedWidth(_FIELD)
        self.now = QLabel()
        self.now.setProperty("role", "muted")
        self._factor = 1.0
        self.value = 0.0

    def show_value(self, document: Document, values: dict[Goal, float]) -> None:
        """Show what it measures now; a value that is wanted stays."""
        value, unit = values.get(self.line.goal), self.line.unit_in(document)
        for part in (self.check, self.field):
            part.setEnabled(value is not None)
        self.field.set_unit(unit)
        named(self.field, self.line.words, f"{self.line.tip}; takes sums and units")
        if value is None:
            self.check.setChecked(False)
            self.now.setText("–")
            return
        self._factor = self.line.factor(document)
        self.now.setText(f"Now {format_number(self._factor * value)} {unit}")
        if not self.check.isChecked():
            # In full precision: what is ticked as it is, is kept as it is.
            self.value = value
            self.field.set_value(self._factor * value)

    def take(self, shown: float) -> None:
        """Take a value that was typed, and want it."""
        self.value = shown / self._factor
        self.check.setChecked(True)


class TargetsDialog(QDialog):
    """Stays open beside the window; what is found is seen at once, Cancel takes it back."""

    def __init__(self, presenter: Presenter, jobs: Jobs, parent: QWidget) -> None:
        super().__init__(parent)
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.setWindowTitle(LABEL)
        self._presenter = presenter
        self._gesture = EditGesture(presenter)
        self._start = presenter.document
        self._search = Search(jobs, self._found, self._refused, self._stopped)
        self._accepts = False
        self.lines = [TargetLine(line) for line in LINES]
        self.way = offering(QuietComboBox(), [(text, way) for way, text in WAYS.items()])
        self.way.addItem(_ONE)
        self.parameter = offering(QuietComboBox(), [(SYMBOLS[name], name) for name in PARAMETERS])
        self.segment = NumberField(minimum=1, whole=True, reset=1.0)
        self.keeps = {each: QCheckBox(words) for each, (words, _) in _KEEPS.items()}
        self.told = QLabel()
        self.longer = QPushButton("&Look longer")
        self._last: Asked | None = None
        self._build()
        self._rebase(presenter.document)
        presenter.refreshed.connect(self._refreshed)

    def _build(self) -> None:
        grid = QGridLayout()
        for row, each in enumerate(self.lines):
            for column, part in enumerate((each.check, each.field, each.now)):
                grid.addWidget(part, row, column)
            each.check.toggled.connect(partial(self._ticked, each))
            each.field.changed.connect(partial(self._entered, each))
        grid.setColumnStretch(2, 1)
        named(self.way, "By", "What may change to reach the targets")
        named(self.parameter, "Shape parameter", "The one that may change")
        named(self.segment, "Segment", "Of which segment")
        one = QHBoxLayout()
        one.addWidget(self.parameter)
        one.addWidget(QLabel("of segment"))
        one.addWidget(self.segment)
        one.addStretch(1)
        form = QFormLayout()
        form.addRow("By", self.way)
        form.addRow("", one)
        for name, check in self.keeps.items():
            check.setToolTip(_KEEPS[name][1])
            check.toggled.connect(self._ask)
            form.addRow("Keep" if name is Keep.ENDS else "", check)
        self.way.currentIndexChanged.connect(self._ask)
        self.parameter.currentIndexChanged.connect(self._ask)
        self.segment.changed.connect(self._ask)
        self.told.setWordWrap(True)
        self.told.setMinimumHeight(_TOLD)
        self.told.setAlignment(Qt.AlignmentFlag.AlignTop)
        self.told.setAccessibleName("Result")
        buttons = QDialogButtonBox(
            QDialogButtonBox.StandardButton.Ok | QDialogButtonBox.StandardButton.Cancel
        )
        self.longer.setToolTip("Go on looking, however long it takes; the status bar can cancel it")
        self.longer.setEnabled(False)
        self.longer.clicked.connect(self._look_longer)
        buttons.addButton(self.longer, QDialogButtonBox.ButtonRole.ActionRole)
        buttons.accepted.connect(self.accept)
        buttons.rejected.connect(self.reject)
        layout = QVBoxLayout(self)
        layout.addLayout(grid)
        layout.addLayout(form)
        layout.addWidget(self.told)
        layout.addWidget(buttons)

    # What the hand does.

    def _ticked(self, line: TargetLine, on: bool) -> None:
        if on:
            for other in self.lines:
                # A mass is that of the material: one of the two.
                if other is not line and other.line.goal is line.line.goal:
                    other.check.setChecked(False)
        self._ask()

    def _entered(self, line: TargetLine, shown: float) -> None:
        was = line.check.isChecked()
        line.take(shown)
        if was:
            self._ask()

    def _way(self) -> Way | Slider:
        way = self.way.currentData()
        if way is not None:
            return Way(way)
        return Slider(int(self.segment.value) - 1, self.parameter.currentData())

    def _ask(self, *_: object) -> None:
        """Look for what is wanted now; without a wish all is as it was."""
        for part in (self.parameter, self.segment):
            part.setEnabled(self.way.currentData() is None)
        targets = {each.line.goal: each.value for each in self.lines if each.check.isChecked()}
        self._accepts = False
        self.longer.setEnabled(False)
        if not targets:
            self._search.drop()
            self._gesture.cancel()
            self.told.setText("Tick what is to be reached or kept, and type its value.")
            return
        keep = frozenset(each for each, check in self.keeps.items() if check.isChecked())
        self._look(Asked(self._start, targets, self._way(), keep))

    def _look(self, asked: Asked) -> None:
        self.longer.setEnabled(False)
        self.told.setText("Looking…")
        self._last = asked
        self._search.start(asked)

    def _look_longer(self) -> None:
        """Look on for what was not found in time, to the end."""
        if self._last is not None:
            self._look(self._last.to_the_end)

    # What comes back.

    def _found(self, asked: Asked, result: Document, found: Solved) -> None:
        words = "It is so already."
        if found.factor is not None and found.moved:
            words = f"Reached by a factor of {found.factor:.6g}."
        elif found.moved:
            words = f"Reached: {moved_words(found.moved)}."
        if self._show(asked, result):
            self.told.setText(words)
            if self._accepts:
                self.accept()

    def _refused(self, asked: Asked, error: Exception) -> None:
        self._accepts = False
        self.told.setText(reason(error))
        if isinstance(error, OutOfReachError):
            self._show(asked, error.nearest)
            self.longer.setEnabled(not error.is_final)

    def _stopped(self) -> None:
        self._accepts = False
        self.told.setText("Stopped; nothing was found so far.")
        self.longer.setEnabled(True)

    def _show(self, asked: Asked, result: Document) -> bool:
        """Show what was found, unless the document has become another one meanwhile."""
        presenter = self._presenter
        idle = presenter.document is asked.document and not presenter.session.in_gesture
        if asked.document is not self._start or not (self._gesture.is_open or idle):
            return False
        if not self._gesture.is_open:
            self._gesture.begin(LABEL)
        return self._gesture.apply(lambda _: result, settled=True)

    def _refreshed(self, frame: Frame) -> None:
        """Begin anew with a document that was changed elsewhere."""
        if self._gesture.is_open or frame.dragging or frame.document is self._start:
            return
        self._rebase(frame.document)
        self._ask()

    def _rebase(self, document: Document) -> None:
        self._search.drop()
        self._start = document
        self.segment.set_range(1, len(document.profile))
        self.segment.set_value(min(self._presenter.view.segment, len(document.profile) - 1) + 1)
        values = values_now(document, self._presenter.frame.body)
        for each in self.lines:
            each.show_value(document, values)
        self._ask()

    # How it ends.

    def accept(self) -> None:
        """Keep what is seen; where a search goes on, what it finds."""
        if self._search.busy:
            self._accepts = True
            return
        self._gesture.commit()
        super().accept()

    def reject(self) -> None:
        """Take everything back."""
        self._search.drop()
        self._gesture.cancel()
        super().reject()

    def done(self, result: int) -> None:
        """Close, and follow the window no more."""
        self._presenter.refreshed.disconnect(self._refreshed)
        super().done(result)
