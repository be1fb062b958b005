"""The guided tour: λ1, λ2, λ3 and ω move one after another, with words for what is seen.

What moves is a passing gesture, which is always taken back, so that the document, its history and
its saved mark are left as they were.
"""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import QElapsedTimer, QEvent, Qt, QTimer, Signal
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import (
    QFrame,
    QHBoxLayout,
    QLabel,
    QProgressBar,
    QPushButton,
    QVBoxLayout,
    QWidget,
)

from app.state.parameter_animation import TICK_MILLISECONDS, swung, visibly_moved
from app.state.presenter import Frame, Presenter
from app.state.view_state import Hover
from sgb_core.curves.parameter_fan import most_telling
from sgb_core.curves.segment import PARAMETER_RANGES, SYMBOLS, ParameterName
from sgb_core.values import dataclass

WIDTH = 400


@dataclass(frozen=True, slots=True)
class Step:
    """One station: its title, what is seen, and what moves."""

    title: str
    words: str
    parameter: ParameterName | None = None


STEPS = (
    Step(
        "A curve that turns",
        "The yellow line is the profile; turned about the axis it makes the surface. Each of its "
        "segments has four points, and four sliders that reshape it without moving any of them.",
    ),
    Step(
        "λ1: how the curve leaves",
        "λ1 slides the quartic point Q1 along the first leg, from P1 to P0. The smaller λ1, the "
        "longer the curve follows the first leg, towards the circle marked *.",
        "lambda1",
    ),
    Step(
        "λ2: how far the middle goes",
        "λ2 slides Q2 along the middle leg: a small λ2 draws the segment towards P2 (mark o), "
        "a large one towards P1 (mark *). A belly sinks or rises.",
        "lambda2",
    ),
    Step(
        "λ3: how the curve arrives",
        "λ3 does at the far end what λ1 does at the near one: the smaller, the longer the curve "
        "keeps to the last leg, towards the circle marked o.",
        "lambda3",
    ),
    Step(
        "ω: how strongly",
        "ω says how much the three count. At 0 the curve is a plain cubic, whatever the λ are; "
        "at 1 they act in full. Ends and tangents stay where they are.",
        "omega",
    ),
    Step(
        "Now you",
        "Drag λ2 yourself: the slider that is lit up in the Shape panel, or Q2 on its leg, which "
        "is the same. So far nothing has changed your document; every drag can be undone.",
    ),
)
# What is the user's own to move at the end.
LAST: ParameterName = "lambda2"
WELL_DONE = "That is all: a belly moved and no point did. Undo takes it back."


class _Button(QPushButton):
    """Leaves the arrow keys to the card, instead of walking to the next button."""

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.key() in (Qt.Key.Key_Left, Qt.Key.Key_Right):
            event.ignore()
        else:
            super().keyPressEvent(event)


class Tour(QFrame):
    """A card over the window; Next, Back and Stop by mouse or keys (Right, Left, Esc)."""

    ended = Signal()

    def __init__(
        self,
        presenter: Presenter,
        window: QWidget,
        hand_over: Callable[[int, ParameterName], object] = lambda _segment, _parameter: None,
    ) -> None:
        """Make the tour; ``hand_over`` gives the keyboard to a parameter's slider of a segment."""
        super().__init__(window)
        self._presenter = presenter
        self._hand_over = hand_over
        self._untouched: object = None
        presenter.refreshed.connect(self._refreshed)
        self._window = window
        self._index = 0
        self._segment = 0
        self.setProperty("role", "overlay")
        self.setAutoFillBackground(True)
        self.setAccessibleName("Guided tour")
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self._title = QLabel(self)
        font = self._title.font()
        font.setBold(True)
        font.setPointSizeF(1.15 * font.pointSizeF())
        self._title.setFont(font)
        self._words = QLabel(self)
        self._words.setWordWrap(True)
        self._value = QLabel(self)
        self._value.setProperty("role", "muted")
        self._place_bar = QProgressBar(self)
        self._place_bar.setRange(0, len(STEPS))
        self._place_bar.setTextVisible(False)
        self._place_bar.setFixedHeight(4)
        self._place_bar.setAccessibleName("Station of the tour")
        self._place_bar.setToolTip("How far the tour has come")
        self.stop_button = self._button("Stop", "Leave the tour (Esc)", self.stop)
        self.back_button = self._button("Back", "The station before (Left)", self.back)
        self.next_button = self._button("Next", "The next station (Right)", self.next)
        self.next_button.setProperty("role", "primary")
        row = QHBoxLayout()
        row.addWidget(self.stop_button)
        row.addWidget(self._value, 1, Qt.AlignmentFlag.AlignCenter)
        row.addWidget(self.back_button)
        row.addWidget(self.next_button)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(16, 12, 16, 12)
        layout.setSpacing(8)
        for widget in (self._place_bar, self._title, self._words):
            layout.addWidget(widget)
        layout.addLayout(row)
        self._clock = QElapsedTimer()
        self._timer = QTimer(self, interval=TICK_MILLISECONDS)
        self._timer.timeout.connect(self._tick)
        self.hide()

    # Walking.

    @property
    def step(self) -> Step:
        """The station that is shown."""
        return STEPS[self._index]

    def start(self) -> None:
        """Begin at the first station, with the segment on which most is seen."""
        self._segment = most_telling(self._presenter.document.profile)
        self._presenter.select(self._segment)
        self.show()
        self._go(0)
        self.next_button.setFocus(Qt.FocusReason.OtherFocusReason)

    def next(self) -> None:
        """Go to the next station; after the last the tour ends."""
        self._go(self._index + 1)

    def back(self) -> None:
        """Go to the station before."""
        self._go(self._index - 1)

    def stop(self) -> None:
        """Leave the tour; everything is as it was before."""
        if self.isHidden():
            return
        self.rest()
        self.hide()
        self._window.setFocus(Qt.FocusReason.OtherFocusReason)
        self.ended.emit()

    def rest(self) -> None:
        """Stop what moves and put it back; the card stays."""
        self._timer.stop()
        if self._presenter.session.in_passing_gesture:
            self._presenter.cancel()
        self._presenter.set_view(hover=None)
        self._value.setText("")

    def _go(self, index: int) -> None:
        self.rest()
        if index >= len(STEPS):
            self.stop()
            return
        self._index = max(0, index)
        step = self.step
        last = self._index == len(STEPS) - 1
        self._untouched = self._presenter.document if last else None
        self._title.setText(step.title)
        self._words.setText(step.words)
        self._place_bar.setValue(self._index + 1)
        self.back_button.setEnabled(self._index > 0)
        self.next_button.setText("Done" if last else "Next")
        self.setAccessibleDescription(f"{step.title}. {step.words}")
        self.place()
        self.raise_()
        if step.parameter is not None:
            self._segment = min(self._segment, len(self._presenter.document.profile) - 1)
            self._presenter.set_view(hover=Hover(step.parameter, self._segment))
            self._presenter.session.begin(f"Tour of {SYMBOLS[step.parameter]}", passing=True)
            self._clock.start()
            self._timer.start()
        elif last:
            self._hand_over(self._segment, LAST)

    def _refreshed(self, frame: Frame) -> None:
        """End well where the user's own hand has moved something."""
        if self._untouched is None or self.isHidden() or frame.dragging:
            return
        if frame.document is not self._untouched:
            self._untouched = None
            self._words.setText(WELL_DONE)
            self.setAccessibleDescription(WELL_DONE)
            self.place()

    def _tick(self) -> None:
        parameter = self.step.parameter
        # Whoever else begins to edit has taken back what moved; the tour waits for Next.
        if parameter is None or not self._presenter.session.in_passing_gesture:
            self.rest()
            return
        seconds = self._clock.elapsed() / 1000.0
        low, high = PARAMETER_RANGES[parameter]
        value = swung(low, high, seconds)
        segment = self._segment
        self._presenter.apply(lambda document: visibly_moved(document, segment, parameter, value))
        self._value.setText(f"{SYMBOLS[parameter]} = {value:.2f}")

    # Keys.

    def keyPressEvent(self, event: QKeyEvent) -> None:
        acts = {
            Qt.Key.Key_Escape: self.stop,
            Qt.Key.Key_Right: self.next,
            Qt.Key.Key_Left: self.back,
        }
        act = acts.get(Qt.Key(event.key()))
        if act is None:
            super().keyPressEvent(event)
        else:
            act()

    def event(self, event: QEvent) -> bool:
        if (
            event.type() == QEvent.Type.ShortcutOverride
            and isinstance(event, QKeyEvent)
            and Qt.Key(event.key()) in (Qt.Key.Key_Escape, Qt.Key.Key_Left, Qt.Key.Key_Right)
        ):
            event.accept()
            return True
        return super().event(event)

    def _button(self, text: str, tip: str, run: Callable[[], object]) -> QPushButton:
        button = _Button(text, self)
        button.setToolTip(tip)
        button.setAccessibleName(f"{text}: guided tour")
        button.setAutoDefault(True)
        button.clicked.connect(run)
        return button

    def place(self) -> None:
        """Lie at the foot of the window, whatever its size has become."""
        width = min(WIDTH * self.fontMetrics().height() // 16, self._window.width() - 40)
        layout = self.layout()
        assert layout is not None
        # With the frame around it.
        height = max(layout.totalHeightForWidth(width), layout.totalMinimumSize().height())
        self.resize(width, height)
        self.move((self._window.width() - width) // 2, self._window.height() - self.height() - 44)
