"""A profile editor on the bench: shown, with its presenter, worked by real events."""

import math

import numpy as np
from PySide6.QtCore import QEvent, QPoint, QPointF, Qt
from PySide6.QtGui import QMouseEvent, QWheelEvent
from PySide6.QtWidgets import QApplication

from app.profile_editor.view import ProfileView
from app.state.presenter import Presenter
from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import Segment, ShapeParameters
from sgb_core.document.model import Document
from sgb_core.document.session import Session

NONE = Qt.KeyboardModifier.NoModifier
SHIFT = Qt.KeyboardModifier.ShiftModifier
CTRL = Qt.KeyboardModifier.ControlModifier
ALT = Qt.KeyboardModifier.AltModifier
LEFT, MIDDLE = Qt.MouseButton.LeftButton, Qt.MouseButton.MiddleButton


def vase(rule="G0"):
    shape = ShapeParameters(1.5, 3.0, 1.0, 1.0)
    return Document(
        Profile.of(
            [
                Segment(np.array([(20.0, 0), (45, 10), (52, 40), (38, 60)]), shape),
                Segment(np.array([(38.0, 60), (24, 80), (14, 95), (15, 112)])),
            ],
            [rule],
        )
    )


def near(a, b, tolerance=1.0):
    return math.hypot(a.x() - b.x(), a.y() - b.y()) <= tolerance


class Bench:
    """A shown profile editor with its presenter, worked by real events."""

    def __init__(self, qtbot, document):
        self.qtbot = qtbot
        self.presenter = Presenter(Session(document))
        self.view = ProfileView(self.presenter)
        self.presenter.add_view(self.view)
        qtbot.addWidget(self.view)
        self.view.resize(500, 600)
        self.notices = []
        self.presenter.noticed.connect(self.notices.append)
        with qtbot.waitExposed(self.view):
            self.view.show()
        self.view.setFocus()
        self.settle()

    def settle(self):
        self.presenter.refresh_now()
        QApplication.processEvents()

    @property
    def document(self):
        return self.presenter.document

    @property
    def undo_entries(self):
        return [entry.label for entry in self.presenter.session.history[1:]]

    def point(self, segment, index):
        return self.document.profile.segments[segment].points[index]

    def place(self, segment, index):
        return self.screen(self.point(segment, index))

    def screen(self, pair):
        x, y = self.view.transform.map(pair).tolist()
        return QPointF(x, y)

    def mouse(self, kind, at, button=LEFT, modifiers=NONE):
        at = QPointF(at)
        buttons = Qt.MouseButton.NoButton if kind == QEvent.Type.MouseButtonRelease else button
        event = QMouseEvent(
            kind, at, QPointF(self.view.mapToGlobal(at)), button, buttons, modifiers
        )
        QApplication.sendEvent(self.view, event)

    def move(self, at, button=LEFT, modifiers=NONE):
        self.mouse(QEvent.Type.MouseMove, at, button, modifiers)
        self.settle()

    def press(self, at, button=LEFT, modifiers=NONE):
        self.mouse(QEvent.Type.MouseButtonPress, at, button, modifiers)

    def release(self, at, button=LEFT, modifiers=NONE):
        self.mouse(QEvent.Type.MouseButtonRelease, at, button, modifiers)
        self.settle()

    def drag(self, start, end, button=LEFT, modifiers=NONE):
        start, end = QPointF(start), QPointF(end)
        self.press(start, button, modifiers)
        for part in (0.2, 0.6, 1.0):
            self.move(start + (end - start) * part, button, modifiers)
        self.release(end, button, modifiers)

    def click(self, at, modifiers=NONE):
        self.press(at, modifiers=modifiers)
        self.release(at, modifiers=modifiers)

    def key(self, key, modifiers=NONE):
        self.qtbot.keyClick(self.view, key, modifiers)
        self.settle()

    def wheel(self, at, turned):
        at = QPointF(at)
        event = QWheelEvent(
            at,
            QPointF(self.view.mapToGlobal(at)),
            QPoint(),
            QPoint(0, turned),
            Qt.MouseButton.NoButton,
            NONE,
            Qt.ScrollPhase.NoScrollPhase,
            False,
        )
        QApplication.sendEvent(self.view, event)
        self.settle()
