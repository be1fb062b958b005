"""One parameter moved over its range, there and back, before the eyes of who asked for it.

What moves is a passing gesture, which is always taken back: the document, its history and its
saved mark are left as they were.
"""

from __future__ import annotations

from collections.abc import Callable
from math import cos, tau

from PySide6.QtCore import QCoreApplication, QElapsedTimer, QEvent, QObject, Qt, QTimer
from PySide6.QtGui import QKeyEvent

from app.state.presenter import Edit, Presenter
from sgb_core.curves.segment import ParameterName
from sgb_core.document import edits
from sgb_core.document.model import Document

# One swing over the whole range and back, and the time between two pictures.
SWING_SECONDS = 4.0
TICK_MILLISECONDS = 33
# While a λ moves ω is at least this, or nothing would be seen.
VISIBLE_OMEGA = 0.8
# While ω moves the λ are these where all are neutral.
VISIBLE_LAMBDAS: tuple[tuple[ParameterName, float], ...] = (
    ("lambda1", 4.0),
    ("lambda2", 6.0),
    ("lambda3", 4.0),
)


class Sway(QObject):
    """Moves what it is told to, once; Esc, a press of the mouse or any edit ends it early."""

    def __init__(self, presenter: Presenter, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._presenter = presenter
        self._edit_for: Callable[[float], Edit] | None = None
        self._mine: object = None
        self._low, self._high = 0.0, 1.0
        self._clock = QElapsedTimer()
        self._timer = QTimer(self, interval=TICK_MILLISECONDS)
        self._timer.timeout.connect(self._tick)

    @property
    def running(self) -> bool:
        """Whether something is being moved."""
        return self._timer.isActive()

    def start(self, label: str, low: float, high: float, edit_for: Callable[[float], Edit]) -> None:
        """Show the edits of all values from ``low`` to ``high`` and back to ``low``, then none."""
        self.stop()
        self._low, self._high, self._edit_for = low, high, edit_for
        self._presenter.session.begin(label, passing=True)
        self._mine = self._presenter.session.gesture_start
        _application().installEventFilter(self)
        self._clock.start()
        self._timer.start()

    def stop(self) -> None:
        """Take back what was moved."""
        if not self.running:
            return
        self._timer.stop()
        _application().removeEventFilter(self)
        if self._holds:
            self._presenter.cancel()

    @property
    def _holds(self) -> bool:
        """Whether the session's gesture is still the one begun here."""
        session = self._presenter.session
        return session.in_passing_gesture and session.gesture_start is self._mine

    def _tick(self) -> None:
        seconds = self._clock.elapsed() / 1000.0
        # Whoever else begins to edit has taken back what moved.
        if seconds >= SWING_SECONDS or not self._holds or self._edit_for is None:
            self.stop()
            return
        value = swung(self._low, self._high, seconds)
        if not self._presenter.apply(self._edit_for(value)):
            self.stop()

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        kind = event.type()
        if kind == QEvent.Type.MouseButtonPress:
            self.stop()
        elif (
            kind in (QEvent.Type.ShortcutOverride, QEvent.Type.KeyPress)
            and isinstance(event, QKeyEvent)
            and event.key() == Qt.Key.Key_Escape
        ):
            # The same key must not also cancel or close something else.
            event.accept()
            if kind == QEvent.Type.KeyPress:
                self.stop()
            return True
        return super().eventFilter(watched, event)


def _application() -> QCoreApplication:
    application = QCoreApplication.instance()
    assert application is not None
    return application


def swung(low: float, high: float, seconds: float) -> float:
    """Return where a swing from ``low`` to ``high`` and back is after some seconds."""
    return low + (high - low) * (1.0 - cos(tau * seconds / SWING_SECONDS)) / 2.0


def visibly_moved(
    document: Document, segment: int | None, parameter: ParameterName, value: float
) -> Document:
    """Return the document with one parameter moved (None: of all segments), others so it is seen.

    A λ is not seen where ω is 0, and ω not where all λ are neutral.
    """
    result = document
    count = len(document.profile.segments)
    for each in range(count) if segment is None else (segment,):
        shape = document.profile.segments[each].shape
        if parameter == "omega":
            if shape.lambda2 == 3.0 and shape.lambda1 == 1.0 and shape.lambda3 == 1.0:
                for other, wanted in VISIBLE_LAMBDAS:
                    result = edits.set_shape_parameter(result, each, other, wanted)
        elif shape.omega < VISIBLE_OMEGA:
            result = edits.set_shape_parameter(result, each, "omega", VISIBLE_OMEGA)
    return edits.set_shape_parameter(result, segment, parameter, value)
