"""Asks what film to make: once around, a shape parameter or a state there and back."""

from __future__ import annotations

from PySide6.QtWidgets import (
    QComboBox,
    QDialog,
    QDialogButtonBox,
    QFormLayout,
    QVBoxLayout,
    QWidget,
)

from app.film.film import FORMATS, FRAMES, SPEEDS
from app.state.window_reader import segment_titles
from app.widgets.form import Row, add_rows
from app.widgets.labels import take_labels
from app.widgets.number_field import NumberField
from app.widgets.pixel_size import PixelSize
from sgb_core.curves.segment import PARAMETER_RANGES, PARAMETERS, SYMBOLS
from sgb_core.document.model import Document

SIZES = (
    ("Square", (480, 480)),
    ("Wide, 16:9", (1280, 720)),
    ("Full HD", (1920, 1080)),
    ("Upright, 9:16", (720, 1280)),
    ("Small, 4:3", (640, 480)),
)


class FilmDialog(QDialog):
    """What moves, how many frames, how quick, how large, and in which format."""

    def __init__(self, document: Document, segment: int, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setWindowTitle("Film")
        form = QFormLayout()
        self.what = QComboBox()
        self.what.addItem("Once around", None)
        for parameter in PARAMETERS:
            self.what.addItem(f"{SYMBOLS[parameter]} there and back", parameter)
        if document.states:
            self.what.addItem("To a state and back", "state")
        self.from_state, self.to_state = QComboBox(), QComboBox()
        self.from_state.addItem("As it is now", None)
        for state in document.states:
            self.from_state.addItem(state.name, state.name)
            self.to_state.addItem(state.name, state.name)
        self.segment = QComboBox()
        self.segment.addItem("All segments", "all")
        for number, title in enumerate(segment_titles(document.profile)):
            self.segment.addItem(title, str(number))
        self.segment.setCurrentIndex(segment + 1)
        self.start = NumberField(step=0.1, reset=lambda: self._ends[0])
        self.end = NumberField(step=0.1, reset=lambda: self._ends[1])
        self.frames = NumberField(minimum=FRAMES[0], maximum=FRAMES[1], whole=True, reset=60)
        self.fps = NumberField(minimum=SPEEDS[0], maximum=SPEEDS[1], reset=20)
        self.format = QComboBox()
        for suffix, text in FORMATS.items():
            self.format.addItem(text, suffix)
        add_rows(
            form,
            (
                Row(
                    "What moves",
                    self.what,
                    "The object on a turntable, one of its parameters, or all of its shape",
                ),
                Row("Of", self.segment, "Whose parameter"),
                Row("From", self.start, "Value in the first frame"),
                Row("To", self.end, "Value halfway; then it goes back"),
                Row("From state", self.from_state, "What the first frame shows"),
                Row("To state", self.to_state, "What is shown halfway; then it goes back"),
                Row("Frames", self.frames, "Number of pictures"),
                Row("Frames a second", self.fps, "Speed"),
                Row("Format", self.format, "MP4 needs the package imageio-ffmpeg"),
            ),
        )
        self.pixels = PixelSize(form, SIZES, 4096)
        self.what.currentIndexChanged.connect(self._show)
        buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Cancel)
        buttons.addButton("Make…", QDialogButtonBox.ButtonRole.AcceptRole)
        buttons.accepted.connect(self.accept)
        buttons.rejected.connect(self.reject)
        layout = QVBoxLayout(self)
        layout.addLayout(form)
        layout.addWidget(buttons)
        take_labels(self)
        self._form = form
        self._show()

    @property
    def suffix(self) -> str:
        """The suffix of the file to be written."""
        return str(self.format.currentData())

    @property
    def arguments(self) -> list[str]:
        """What the command ``animate`` is to be told beside its files."""
        what = self.what.currentData()
        moved = ["--turntable"]
        if what == "state":
            # In one word each: a state's name may begin with a dash.
            moved = [f"--to={self.to_state.currentData()}"]
            if self.from_state.currentData() is not None:
                moved.append(f"--from={self.from_state.currentData()}")
        elif what is not None:
            ends = [repr(self.start.value), repr(self.end.value)]
            moved = ["--vary", str(self.segment.currentData()), str(what), *ends]
        frames = round(self.frames.value)
        width, height = self.pixels.value
        return [
            *moved,
            *("--frames", str(frames), "--fps", f"{self.fps.value:g}"),
            *("--size", f"{width}x{height}"),
        ]

    def _show(self) -> None:
        what = self.what.currentData()
        for part in (self.segment, self.start, self.end):
            self._form.setRowVisible(part, what not in (None, "state"))
        for part in (self.from_state, self.to_state):
            self._form.setRowVisible(part, what == "state")
        if what in (None, "state"):
            return
        for part, value in zip((self.start, self.end), self._ends, strict=True):
            part.set_range(*self._ends)
            part.set_value(value)

    @property
    def _ends(self) -> tuple[float, float]:
        """The range of what moves; that of ω where it has none."""
        return PARAMETER_RANGES.get(self.what.currentData(), PARAMETER_RANGES["omega"])
