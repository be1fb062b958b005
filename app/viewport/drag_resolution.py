"""How finely a moving picture is drawn: at half the resolution where drawing is what costs."""

from __future__ import annotations

from collections import deque
from time import perf_counter
from typing import Any, Protocol

from PySide6.QtCore import QEvent, QObject

# A picture that takes longer to draw, in seconds, is what holds up the hand.
BUDGET = 0.012
# Half the resolution is a quarter of the pixels: below this even the whole would be quick.
_QUICK = BUDGET / 5.0
# So many pictures tell; the first of a new shader alone is slow anywhere.
_TOLD_BY = 3
_HALF = 0.5


class Scene(Protocol):
    """The picture as this knows it."""

    def set_pixel_ratio(self, ratio: float) -> None:
        """Set how many pixels of the picture one pixel of line width is."""


class DragResolution(QObject):
    """Times the pictures of one drawing widget and sets the size in which they are drawn.

    Qt shows each as large as the widget, so that nothing moves or grows. A machine that draws
    quickly, as one with a graphics card does, gets the full resolution always.
    """

    def __init__(self, plotter: Any, scene: Scene) -> None:
        super().__init__(plotter)
        self._plotter, self._scene = plotter, scene
        self._window = plotter.ren_win
        self._taken: deque[float] = deque(maxlen=_TOLD_BY)
        self._began = 0.0
        self._moving = False
        self.coarse = False
        self._scale = 1.0
        self._window.AddObserver("StartEvent", self._start)
        self._window.AddObserver("EndEvent", self._end)
        # The widget sets the size anew whenever its own changes.
        plotter.resized.connect(self._apply)
        plotter.installEventFilter(self)
        self._apply()

    def move(self) -> None:
        """Draw the next pictures as a moving hand needs them."""
        self._moving = True
        self._use(_HALF if self.coarse else 1.0)

    def rest(self) -> None:
        """Draw the next pictures as finely as the screen is."""
        self._moving = False
        self._use(1.0)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        # The window has come to a screen with other pixels.
        if event.type() == QEvent.Type.DevicePixelRatioChange:
            self._apply()
        return super().eventFilter(watched, event)

    def _use(self, scale: float) -> None:
        if scale != self._scale:
            self._scale = scale
            self._apply()

    def _apply(self) -> None:
        scale = self._plotter.devicePixelRatioF() * self._scale
        self._scene.set_pixel_ratio(scale)
        size = [max(1, round(side * scale)) for side in self._plotter.size().toTuple()]
        if size != list(self._window.GetSize()):
            self._window.SetSize(*size)

    def _start(self, *_event: object) -> None:
        self._began = perf_counter()

    def _end(self, *_event: object) -> None:
        if not self._moving:
            return
        self._taken.append(perf_counter() - self._began)
        if len(self._taken) == _TOLD_BY:
            usual = sorted(self._taken)[_TOLD_BY // 2]
            coarse = usual > (_QUICK if self.coarse else BUDGET)
            if coarse != self.coarse:
                self.coarse = coarse
                self._taken.clear()
