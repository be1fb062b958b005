"""Fit the profile to an ellipse: what each freedom reaches, beside the profile as it is."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import QTimer
from PySide6.QtGui import QShowEvent
from PySide6.QtWidgets import (
    QButtonGroup,
    QCheckBox,
    QDialog,
    QDialogButtonBox,
    QFormLayout,
    QGridLayout,
    QLabel,
    QRadioButton,
    QVBoxLayout,
    QWidget,
)

from app.state.jobs import Job, Jobs
from app.state.presenter import Presenter
from app.state.window_reader import WINDOW, reason
from app.widgets.combo_box import QuietComboBox
from app.widgets.form import Row, add_rows
from app.widgets.labels import take_labels
from app.widgets.number_field import NumberField
from app.widgets.number_kind import limits
from sgb_core.design.fitting import Deviation, Freedom
from sgb_core.design.target_curves import SuperellipseArc
from sgb_core.document.edits.fit import (
    SUPERELLIPSE,
    FitChoices,
    arc_for,
    fit_choices,
    take_fit,
)
from sgb_core.document.errors import EditError
from sgb_core.document.model import Document
from sgb_core.fields.record import table_of

WORDS = {
    Freedom.OMEGA: "Best ω, all else as it is",
    Freedom.SHAPE: "Best λ1, λ2, λ3 and ω",
    Freedom.POLYGON: "Best control polygon",
}
# How long the numbers rest before the fits begin, in milliseconds.
REST = 300


class FitDialog(QDialog):
    """Stays open beside the window; Apply is one undo entry."""

    def __init__(self, presenter: Presenter, jobs: Jobs, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setWindowTitle("Fit to an ellipse")
        self._presenter = presenter
        self._jobs = jobs
        self._job: Job | None = None
        self._fitted: Document | None = None
        self.choices: FitChoices | None = None
        form, grid, buttons = self._build_form(), self._build_results(), self._build_buttons()
        self.problem = QLabel()
        self.problem.setWordWrap(True)
        layout = QVBoxLayout(self)
        layout.addLayout(form)
        layout.addSpacing(grid.horizontalSpacing())
        layout.addLayout(grid)
        layout.addWidget(self.problem)
        layout.addWidget(buttons)
        take_labels(self)
        self.setMinimumWidth(520)
        self._rest = QTimer(self, singleShot=True, interval=REST)
        self._rest.timeout.connect(self._begin)
        self.kind.currentIndexChanged.connect(self._show_kind)
        for field in (self.a, self.b, self.centre, self.exponent):
            field.changed.connect(self._rest.start)
        for box in (self.keep_ends, self.slide_poles, self.squares):
            box.toggled.connect(self._rest.start)
        presenter.refreshed.connect(self._refreshed)

    def _build_form(self) -> QFormLayout:
        self.kind = QuietComboBox()
        self.kind.addItems(["Circle", "Ellipse", "Superellipse"])
        unit = str(self._presenter.document.unit)
        self.a, self.b = _field("a", 1.0, unit), _field("b", 1.0, unit)
        self.centre = _field("centre", 0.0, unit)
        self.exponent = _field("exponent", SUPERELLIPSE, "")
        self.keep_ends = QCheckBox("Keep the directions of the end legs")
        self.keep_ends.setChecked(True)
        self.slide_poles = QCheckBox("Let the poles slide along the axis")
        self.squares = QCheckBox("Least squares instead of the largest deviation")
        self._form = QFormLayout()
        add_rows(
            self._form,
            (
                Row(
                    "Target",
                    self.kind,
                    "The curve that the profile is to come near, from pole to pole",
                ),
                Row("Half height a", self.a, "From the centre up to the target's pole"),
                Row("Half width b", self.b, "From the centre out to the target's equator"),
                Row("Centre", self.centre, "Height of the centre", "Height of the centre"),
                Row("Exponent", self.exponent, "Exponent"),
                Row(
                    "",
                    self.keep_ends,
                    "A profile that meets the axis level stays smooth at its poles",
                ),
                Row(
                    "",
                    self.slide_poles,
                    "The ends of the best control polygon may leave the target's poles, which "
                    "comes nearer elsewhere",
                ),
                Row(
                    "",
                    self.squares,
                    "Makes the sum of squared deviations small: nearer on the whole, farther at "
                    "the worst place",
                ),
            ),
        )
        return self._form

    def _build_results(self) -> QGridLayout:
        grid = QGridLayout()
        grid.addWidget(QLabel("As it is"), 0, 0)
        self.present = QLabel("…")
        grid.addWidget(self.present, 0, 1)
        group = QButtonGroup(self)
        self.radios: dict[Freedom, QRadioButton] = {}
        self.results: dict[Freedom, QLabel] = {}
        for row, (freedom, words) in enumerate(WORDS.items(), start=1):
            self.radios[freedom], self.results[freedom] = QRadioButton(words), QLabel("…")
            self.radios[freedom].setToolTip(f"Apply the {words[0].lower()}{words[1:]}")
            group.addButton(self.radios[freedom])
            grid.addWidget(self.radios[freedom], row, 0)
            grid.addWidget(self.results[freedom], row, 1)
        self.radios[Freedom.POLYGON].setChecked(True)
        return grid

    def _build_buttons(self) -> QDialogButtonBox:
        buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Close)
        self.apply_button = buttons.addButton("Apply", QDialogButtonBox.ButtonRole.ApplyRole)
        self.apply_button.setToolTip("Take the chosen profile; one step of undo")
        self.apply_button.setDefault(True)
        self.apply_button.setEnabled(False)
        self.apply_button.clicked.connect(self.apply)
        buttons.rejected.connect(self.reject)
        return buttons

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        try:
            arc = arc_for(self._presenter.document)
        except EditError as error:
            self.problem.setText(reason(error))
            return
        for field, value in ((self.a, arc.a), (self.b, arc.b), (self.centre, arc.centre)):
            field.set_value(value)
        self.kind.setCurrentIndex(1)
        self._show_kind()

    def _show_kind(self) -> None:
        self._form.setRowVisible(self.b, self.kind.currentIndex() != 0)
        self._form.setRowVisible(self.exponent, self.kind.currentIndex() == 2)
        self._rest.start()

    def _refreshed(self, frame: object) -> None:
        changed = self._fitted is not None and self._presenter.document is not self._fitted
        if self.isVisible() and changed and not self._presenter.session.in_gesture:
            self._rest.start()

    @property
    def target(self) -> SuperellipseArc:
        """The chosen target; raises EditError for one without size."""
        circle = self.kind.currentIndex() == 0
        return arc_for(
            self._presenter.document,
            a=self.a.value,
            b=None if circle else self.b.value,
            centre=self.centre.value,
            exponent=self.exponent.value if self.kind.currentIndex() == 2 else 2.0,
            circle=circle,
        )

    def _begin(self) -> None:
        """Fit aside; a result for older numbers or an older document is dropped."""
        if self._job is not None:
            self._job.cancel()
        self.choices = None
        self.apply_button.setEnabled(False)
        self.problem.setText("")
        for label in (self.present, *self.results.values()):
            label.setText("…")
        document, keep = self._presenter.document, self.keep_ends.isChecked()
        slide, squares = self.slide_poles.isChecked(), self.squares.isChecked()
        self._fitted = document
        try:
            target = self.target
        except EditError as error:
            self.problem.setText(reason(error))
            return

        def work(report: Callable[[float], None]) -> FitChoices:
            return fit_choices(
                document, target, keep_ends=keep, slide_poles=slide, squares=squares, report=report
            )

        def done(choices: FitChoices) -> None:
            if job is self._job and self._presenter.document is document:
                self._show(choices)

        def failed(error: Exception) -> None:
            if job is self._job:
                self.problem.setText(reason(error))

        job = self._job = Job("Fitting the profile", work, done, failed)
        self._jobs.start(job)

    def _show(self, choices: FitChoices) -> None:
        self.choices = choices
        self.present.setText(self._told(choices.present))
        for found in choices.fits:
            self.results[found.freedom].setText(self._told(found.deviation))
        self.apply_button.setEnabled(True)

    def _told(self, found: Deviation) -> str:
        return (
            f"off by {found.largest:.3g} {self._presenter.document.unit}, in "
            f"{WINDOW.segment(found.segment)} at s = {found.s:.2f}"
        )

    def done(self, result: int) -> None:
        """Close, and stop a fit that nobody waits for any more."""
        if self._job is not None:
            self._job.cancel()
        super().done(result)

    def apply(self) -> None:
        """Take the profile of the chosen freedom."""
        if self.choices is None:
            return
        chosen = next(f for f in self.choices.fits if self.radios[f.freedom].isChecked())
        self._presenter.do("Fit to an ellipse", lambda document: take_fit(document, chosen))


def _field(name: str, value: float, unit: str) -> NumberField:
    allowed = table_of(SuperellipseArc).row(name).kind
    return NumberField(**limits(allowed), step=0.1, unit=unit, reset=value)
