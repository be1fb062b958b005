"""The measures of the drawn surface, to read and to copy."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from PySide6.QtCore import Qt, QTimer
from PySide6.QtGui import QGuiApplication, QShowEvent
from PySide6.QtWidgets import QGridLayout, QLabel, QPushButton, QVBoxLayout, QWidget

from app import icons
from app.presenter import Frame, Presenter
from sgb_core.document.evaluation import Evaluation
from sgb_core.surfaces import measures

# The hand has stopped when nothing has changed for this long.
REST_MILLISECONDS = 150


@dataclass(frozen=True, slots=True)
class Measure:
    """One line: a name, what it means, and how it is read off an evaluation."""

    name: str
    meaning: str
    read: Callable[[Evaluation], str]


def _volume(evaluation: Evaluation) -> str:
    return f"{_digits(evaluation.volume)} {evaluation.document.unit}³"


def _capacity(evaluation: Evaluation) -> str:
    millilitres = evaluation.volume * evaluation.document.unit.millimetres**3 / 1000.0
    if millilitres >= 10_000.0:
        return f"{_digits(millilitres / 1000.0)} l"
    return f"{_digits(millilitres)} ml"


def _area(evaluation: Evaluation) -> str:
    return f"{_digits(measures.area(evaluation.surface))} {evaluation.document.unit}²"


def _height(evaluation: Evaluation) -> str:
    low, high = evaluation.bounds
    return f"{_digits(float(high[1] - low[1]))} {evaluation.document.unit}"


def _diameter(evaluation: Evaluation) -> str:
    low, high = evaluation.bounds
    diameter = 2.0 * max(abs(float(low[0])), abs(float(high[0])))
    return f"{_digits(diameter)} {evaluation.document.unit}"


def _length(evaluation: Evaluation) -> str:
    length = measures.generatrix_length(evaluation.document.profile)
    return f"{_digits(length)} {evaluation.document.unit}"


MEASURES = (
    Measure("Volume", "Enclosed when the profile is closed to the axis", _volume),
    Measure("as liquid", "The same volume in millilitres or litres", _capacity),
    Measure("Area", "Of the drawn surface, without end faces", _area),
    Measure("Height", "Of the profile along the axis", _height),
    Measure("Diameter", "The largest", _diameter),
    Measure("Profile length", "Length of the generatrix", _length),
)


class MeasuresPanel(QWidget):
    """Measures a moment after the hand has stopped, and only while it can be seen."""

    def __init__(self, presenter: Presenter, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._presenter = presenter
        self._frame: Frame | None = None
        self._shown: Evaluation | None = None
        self._timer = QTimer(self)
        self._timer.setSingleShot(True)
        self._timer.setInterval(REST_MILLISECONDS)
        self._timer.timeout.connect(self._measure)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(12, 8, 10, 10)
        layout.setSpacing(8)
        grid = QGridLayout()
        grid.setHorizontalSpacing(10)
        grid.setVerticalSpacing(5)
        grid.setColumnStretch(1, 1)
        self.values: dict[str, QLabel] = {}
        for line, measure in enumerate(MEASURES):
            name = QLabel(measure.name, self)
            name.setProperty("role", "muted")
            name.setToolTip(measure.meaning)
            value = QLabel("–", self)
            value.setAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
            value.setTextInteractionFlags(
                Qt.TextInteractionFlag.TextSelectableByMouse
                | Qt.TextInteractionFlag.TextSelectableByKeyboard
            )
            value.setAccessibleName(measure.name)
            value.setToolTip(measure.meaning)
            grid.addWidget(name, line, 0)
            grid.addWidget(value, line, 1)
            self.values[measure.name] = value
        layout.addLayout(grid)
        self.copy_button = QPushButton("Copy all", self)
        icons.bind(self.copy_button, "copy")
        self.copy_button.setToolTip("Copy all measures as text")
        self.copy_button.clicked.connect(self.copy_all)
        layout.addWidget(self.copy_button, 0, Qt.AlignmentFlag.AlignRight)
        layout.addStretch(1)

    def refresh(self, frame: Frame) -> None:
        """Note ``frame``; it is measured when nothing newer comes for a moment."""
        self._frame = frame
        if frame.evaluation is not self._shown and self.isVisible():
            self._timer.start()

    def copy_all(self) -> None:
        """Put all measures on the clipboard, a line each."""
        self._measure()
        lines = [f"{name}: {label.text()}" for name, label in self.values.items()]
        QGuiApplication.clipboard().setText("\n".join(lines))

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        if self._frame is not None and self._frame.evaluation is not self._shown:
            self._timer.start()

    def _measure(self) -> None:
        frame = self._frame
        if frame is None or frame.evaluation is self._shown:
            return
        if frame.dragging:
            self._timer.start()
            return
        self._shown = frame.evaluation
        for measure in MEASURES:
            self.values[measure.name].setText(measure.read(frame.evaluation))


def _digits(value: float) -> str:
    """Return five significant digits, without a power of ten where it can be avoided."""
    if value == 0.0:
        return "0"
    if not 1e-3 <= abs(value) < 1e9:
        return f"{value:.5g}"
    # No separators of thousands: what is copied must be read as a number elsewhere.
    whole = len(str(int(abs(value))))
    return f"{value:.{max(0, 5 - whole)}f}"
