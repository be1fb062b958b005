"""A whole window on the (virtual) screen, and what tests ask of it."""

import numpy as np
from PySide6.QtCore import QPoint
from PySide6.QtGui import QImage
from PySide6.QtWidgets import QApplication

from app.theme import theme
from app.widgets.mark_slider import MarkSlider
from app.window.main_window import MainWindow
from app.window.panels import PANELS
from tests.app.waiting import activate, is_drawn, let_turn

PARAMETERS = ("lambda1", "lambda2", "lambda3", "omega")


class WindowStage:
    """Shows a MainWindow and waits until its 3-D part has drawn.

    All panels are made, as after a walk through the tabs; ``make_panels`` False leaves those that
    nobody has seen unmade, as in the program.
    """

    def __init__(self, qtbot, size=(1280, 800), wait_for_scene=True, make_panels=True):
        theme.apply(QApplication.instance(), "light")
        self.qtbot = qtbot
        self.window = MainWindow()
        if make_panels:
            for kind in PANELS:
                assert self.window.panels[kind.key] is not None
        self.window.resize(*size)
        self.window.show()
        activate(qtbot, self.window)
        if wait_for_scene:
            self.until(lambda: self.window.surface_view.scene is not None)
        self.settle()

    @property
    def presenter(self):
        return self.window.presenter

    @property
    def session(self):
        return self.window.presenter.session

    @property
    def document(self):
        return self.window.presenter.document

    def until(self, condition):
        """Wait until ``condition()`` holds."""
        self.qtbot.waitUntil(condition)

    def settle(self):
        """Wait until every view shows what is there now, refined, and nothing moves any more."""
        let_turn()
        self.until(self._is_settled)
        let_turn()

    def _is_settled(self):
        presenter, work = self.presenter, self.window.body_work
        if presenter._timer.isActive() or (work.busy and not presenter.session.in_gesture):
            return False
        return self.window.surface_view.scene is None or is_drawn(self.window.surface_view)

    def viewport(self):
        """What the viewport shows, shape (h, w, 3)."""
        picture = self.window.surface_view.plotter.grabFramebuffer()
        picture = picture.convertToFormat(QImage.Format.Format_RGB888)
        rows = np.frombuffer(picture.constBits(), np.uint8)
        rows = rows.reshape(picture.height(), picture.bytesPerLine())
        return rows[:, : picture.width() * 3].reshape(picture.height(), picture.width(), 3).copy()

    def slider(self, segment, parameter):
        """The slider of one parameter of one segment, unfolded by selecting the segment."""
        self.presenter.select(segment)
        self.settle()
        shown = [s for s in self.window.panels["shape"].findChildren(MarkSlider) if s.isVisible()]
        shown.sort(key=lambda s: s.mapToGlobal(QPoint(0, 0)).y())
        open_before = [
            s
            for s in shown
            if s.accessibleName().startswith(("λ", "ω"))
            and f"segment {segment + 1}" in s.accessibleName()
        ]
        return open_before[PARAMETERS.index(parameter)]

    def close(self):
        """Close without being asked about unsaved work, and let Qt delete the window."""
        self.session.mark_saved()
        self.window.close()
        assert self.window not in MainWindow.windows
        let_turn()
