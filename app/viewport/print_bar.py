"""The bar under a print path in the viewport: by what it is coloured, and up to which moment."""

from __future__ import annotations

import numpy as np
from PySide6.QtCore import QPointF, QRectF, QSignalBlocker, Qt, QTimer
from PySide6.QtGui import QColor, QLinearGradient, QPainter, QPaintEvent
from PySide6.QtWidgets import (
    QComboBox,
    QFrame,
    QHBoxLayout,
    QLabel,
    QSlider,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from app.state import printers
from app.state.overlays import Overlay
from app.state.path_colours import MEASURES, shades
from app.state.presenter import Frame, Presenter
from app.state.window_reader import sentence
from app.theme import icons, theme
from app.widgets.form import named, offering
from sgb_core.toolpaths.toolpath import Toolpath

# Steps of the slider through the time of printing.
MOMENTS = 1_000
# A whole print is played in so many pictures, so many milliseconds apart.
_PLAYED, _APART = 240, 40
_WIDEST = 620


class PrintBar(QFrame):
    """Floats over the viewport's lower edge. Opaque, so that it costs no drawing below."""

    def __init__(self, presenter: Presenter, parent: QWidget) -> None:
        super().__init__(parent)
        self._presenter = presenter
        self._path: Toolpath | None = None
        self._told: tuple[object, ...] = ()
        self.setObjectName("viewport-buttons")
        self.setAutoFillBackground(True)
        self.setAccessibleName("Print path")
        self.printer = QComboBox()
        self.colouring = offering(QComboBox(), [(MEASURES[key].words, key) for key in MEASURES])
        self.least, self.most = QLabel(), QLabel()
        self.shades = _Shades()
        self.play = QToolButton(autoRaise=True)
        self.play.setText("▶")
        self.play.setCheckable(True)
        self.moment = QSlider(Qt.Orientation.Horizontal)
        self.moment.setMaximum(MOMENTS)
        self.moment.setValue(MOMENTS)
        self.moment.setPageStep(MOMENTS // 20)
        self.now = QLabel()
        self.told = QLabel(wordWrap=True)
        self.close_button = QToolButton(autoRaise=True)
        icons.bind(self.close_button, "close")
        self._timer = QTimer(self, interval=_APART)
        self._build()
        self._connect()
        self.hide()

    def _build(self) -> None:
        above, below = QHBoxLayout(), QHBoxLayout()
        for box in (self.printer, self.colouring):
            box.setSizeAdjustPolicy(
                QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon
            )
            box.setMinimumContentsLength(8)
        above.addWidget(named(self.printer, "Printer", "The machine that the path is for"), 2)
        above.addWidget(named(self.colouring, "Colour by", "What the colours of the path say"), 2)
        above.addWidget(self.least)
        above.addWidget(self.shades, 1)
        above.addWidget(self.most)
        tip = "Show the surface again (Ctrl+Alt+G)"
        above.addWidget(named(self.close_button, "Hide the print path", tip))
        below.addWidget(named(self.play, "Play", "Let the nozzle run through the whole print"))
        below.addWidget(named(self.moment, "Moment", "How far printing has come"), 1)
        below.addWidget(self.now)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(8, 5, 8, 5)
        layout.setSpacing(3)
        layout.addLayout(above)
        layout.addLayout(below)
        layout.addWidget(self.told)
        self.told.setAccessibleName("What is said of the path")

    def _connect(self) -> None:
        self.printer.activated.connect(self._choose)
        self.colouring.activated.connect(
            lambda: self._presenter.set_view(path_measure=str(self.colouring.currentData()))
        )
        self.moment.valueChanged.connect(
            lambda at: self._presenter.set_view(path_moment=at / MOMENTS)
        )
        self.moment.sliderPressed.connect(lambda: self.play.setChecked(False))
        self.play.toggled.connect(self._play)
        self._timer.timeout.connect(self._next)
        self.close_button.clicked.connect(lambda: self._presenter.toggle_overlay(Overlay.PRINT))

    def show_state(self, frame: Frame) -> None:
        """Say what is so of a frame's path."""
        view, printed = frame.view, frame.printed
        shown = view.shows(Overlay.PRINT)
        if not shown:
            self.play.setChecked(False)
            self.hide()
            return
        here = printed is not None and printed.document is frame.document
        path = printed.path if here and printed is not None else None
        refused = printed.refused if here and printed is not None else ""
        key = (path, refused, here, view.path_measure, view.path_moment, self.isHidden())
        if key == self._told:
            return
        if self.isHidden():
            self._list_printers()
        self._path = path
        with QSignalBlocker(self.colouring):
            self.colouring.setCurrentIndex(list(MEASURES).index(view.path_measure))
        with QSignalBlocker(self.moment):
            self.moment.setValue(round(view.path_moment * MOMENTS))
        for control in (self.play, self.moment):
            control.setEnabled(path is not None)
        self._tell(path, refused if here else "The path is planned once the hand rests…", view)
        self.show()
        self.place()
        self.raise_()
        self._told = (*key[:-1], False)

    def _tell(self, path: Toolpath | None, why: str, view: object) -> None:
        moment = self.moment.value() / MOMENTS
        self.shades.setVisible(path is not None)
        if path is None:
            self.least.clear()
            self.most.clear()
            self.now.clear()
            self.told.setText(why)
            self.told.show()
            return
        measure = MEASURES[str(self.colouring.currentData())]
        low, high = measure.limits(path)
        self.least.setText(f"{low:.3g}")
        self.most.setText(f"{high:.3g} {measure.unit}".strip())
        now = moment * path.time
        layer = int(path.layers[min(_at(path, now), len(path.layers) - 1)]) + 1
        self.now.setText(
            f"{_clock(now)} of {_clock(path.time)}, layer {layer} of {path.layer_count}"
        )
        risks = [sentence(finding) for finding in path.findings]
        more = f" (and {len(risks) - 1} more under Export > Print path)" if len(risks) > 1 else ""
        self.told.setText(risks[0] + more if risks else "")
        self.told.setVisible(bool(risks))

    def place(self) -> None:
        """Keep to the middle of the viewport's lower edge."""
        parent = self.parentWidget()
        assert parent is not None
        width = min(parent.width() - 20, _WIDEST)
        layout = self.layout()
        assert layout is not None
        layout.activate()
        height = layout.totalHeightForWidth(width) if layout.hasHeightForWidth() else 0
        height = max(height, self.minimumSizeHint().height())
        self.setGeometry(
            (parent.width() - width) // 2, parent.height() - height - 10, width, height
        )

    def _list_printers(self) -> None:
        known = printers.known()
        chosen, _ = printers.chosen(known)
        with QSignalBlocker(self.printer):
            self.printer.clear()
            offering(self.printer, [(each.title, each) for each in known])
            self.printer.setCurrentIndex([each.name for each in known].index(chosen.name))

    def _choose(self) -> None:
        printer = self.printer.currentData()
        printers.choose(printer, printer.layer.usual)

    def _play(self, on: bool) -> None:
        if not on:
            self._timer.stop()
            return
        if self.moment.value() == MOMENTS:
            self.moment.setValue(0)
        self._timer.start()

    def _next(self) -> None:
        at = min(self.moment.value() + max(1, MOMENTS // _PLAYED), MOMENTS)
        self.moment.setValue(at)
        if at == MOMENTS:
            self.play.setChecked(False)


class _Shades(QWidget):
    """The colours from the least to the largest value."""

    def __init__(self) -> None:
        super().__init__()
        self.setMinimumSize(40, 12)
        self.setMaximumHeight(12)

    def paintEvent(self, _event: QPaintEvent) -> None:
        painter = QPainter(self)
        gradient = QLinearGradient(QPointF(0.0, 0.0), QPointF(self.width(), 0.0))
        found = shades(theme.current()).tolist()
        for k, colour in enumerate(found):
            gradient.setColorAt(k / (len(found) - 1), QColor(*colour))
        painter.fillRect(QRectF(self.rect()), gradient)
        painter.end()


def _at(path: Toolpath, now: float) -> int:
    return int(np.searchsorted(np.cumsum(path.times), now))


def _clock(seconds: float) -> str:
    """Return hours, minutes and seconds as short as they are told: "1:05:09", "4:30"."""
    whole = round(seconds)
    hours, minutes, rest = whole // 3600, whole // 60 % 60, whole % 60
    return f"{hours}:{minutes:02}:{rest:02}" if hours else f"{minutes}:{rest:02}"
