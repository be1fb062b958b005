"""The widget in which the scene is drawn: pyvistaqt's interactor, or pictures of it.

Where OpenGL is computed by the processor, putting an OpenGL widget and the panels around it
together costs more than most pictures. There the interactor stays unseen, and what it draws is
painted as any picture is.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from PySide6.QtCore import QPointF, Qt, Signal
from PySide6.QtGui import (
    QCloseEvent,
    QImage,
    QPainter,
    QPaintEvent,
    QResizeEvent,
)
from PySide6.QtWidgets import QWidget

from app.viewport.opengl import draws_in_software


def new_interactor(parent: QWidget) -> Any:
    """Return the widget to draw in, with the render window and the renderer of a QtInteractor."""
    drawn = RasterInteractor(parent) if draws_in_software() else _interactor(parent)
    drawn.setAcceptDrops(False)
    drawn.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
    drawn.setAccessibleName("3-D viewport")
    return drawn


def _interactor(parent: QWidget | None) -> Any:
    from pyvistaqt import QtInteractor

    # Its timer would draw without end; the smoothing is the scene's own affair.
    return QtInteractor(parent, auto_update=False, multi_samples=0)


class RasterInteractor(QWidget):
    """Shows what a QtInteractor draws that is itself never seen; to be used in its place.

    A picture is drawn when :meth:`update` has asked for it, or another size has; what else uncovers
    a part of the widget shows the last one again.
    """

    resized = Signal()
    frameSwapped = Signal()

    def __init__(self, parent: QWidget) -> None:
        from vtkmodules.vtkCommonCore import vtkUnsignedCharArray

        super().__init__(parent)
        self.setMouseTracking(True)
        # Without a parent: an OpenGL widget in the window, hidden or not, has it put together.
        self._drawing = _interactor(None)
        self._drawing.setAttribute(Qt.WidgetAttribute.WA_DontShowOnScreen)
        # Shown once it has its context; hidden it paints nothing of its own accord.
        self._drawing.show()
        self._drawing.hide()
        self.ren_win: Any = self._drawing.ren_win
        self.renderer: Any = self._drawing.renderer
        self._read = vtkUnsignedCharArray()
        self._pixels = np.zeros((1, 1, 4), dtype=np.uint8)
        self._stale = True

    def update(self) -> None:  # type: ignore[override]
        """Draw a new picture with the next painting."""
        self._stale = True
        super().update()

    def grabFramebuffer(self) -> QImage:
        """Return the present picture in pixels of the screen, drawn now."""
        self._draw()
        ratio = self.devicePixelRatioF()
        size = self.size() * ratio
        picture = self._picture.copy()
        if picture.size() != size:
            picture = picture.scaled(size, mode=Qt.TransformationMode.SmoothTransformation)
        picture.setDevicePixelRatio(ratio)
        return picture

    def paintEvent(self, _event: QPaintEvent) -> None:
        if self._stale:
            self._draw()
        picture, painter = self._picture, QPainter(self)
        ratio = self.devicePixelRatioF()
        if picture.size() == self.size() * ratio:
            picture.setDevicePixelRatio(ratio)
            painter.drawImage(QPointF(0.0, 0.0), picture)
        else:
            painter.setRenderHint(QPainter.RenderHint.SmoothPixmapTransform)
            painter.drawImage(self.rect(), picture)
        painter.end()
        self.frameSwapped.emit()

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._stale = True
        self.resized.emit()

    def closeEvent(self, event: QCloseEvent) -> None:
        self._drawing.close()
        super().closeEvent(event)

    def _draw(self) -> None:
        from vtkmodules.util.numpy_support import vtk_to_numpy

        self._stale = False
        self.ren_win.Render()
        width, height = self.ren_win.GetSize()
        self.ren_win.GetRGBACharPixelData(0, 0, width - 1, height - 1, 1, self._read)
        # Its lowest row comes first.
        self._pixels = np.ascontiguousarray(
            vtk_to_numpy(self._read).reshape(height, width, 4)[::-1]
        )

    @property
    def _picture(self) -> QImage:
        height, width, _ = self._pixels.shape
        return QImage(self._pixels.data, width, height, 4 * width, QImage.Format.Format_RGBX8888)
