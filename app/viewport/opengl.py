"""What OpenGL does here, and what a window needs for it before it is first shown."""

from __future__ import annotations

from functools import cache

from PySide6.QtGui import QSurfaceFormat
from PySide6.QtOpenGLWidgets import QOpenGLWidget
from PySide6.QtWidgets import QWidget

from app.state.graphics import opengl_names

# How drawers without hardware name themselves: those of Mesa, of Chromium and of Windows.
_SOFTWARE = ("llvmpipe", "softpipe", "swrast", "software", "swiftshader", "gdi generic", "basic re")


def surface_format() -> QSurfaceFormat:
    """Return what VTK needs of Qt's OpenGL; to be the default before the window is made."""
    wanted = QSurfaceFormat()
    wanted.setRenderableType(QSurfaceFormat.RenderableType.OpenGL)
    wanted.setProfile(QSurfaceFormat.OpenGLContextProfile.CoreProfile)
    wanted.setVersion(3, 2)
    wanted.setSwapBehavior(QSurfaceFormat.SwapBehavior.DoubleBuffer)
    wanted.setRedBufferSize(8)
    wanted.setGreenBufferSize(8)
    wanted.setBlueBufferSize(8)
    wanted.setAlphaBufferSize(8)
    wanted.setDepthBufferSize(8)
    wanted.setSamples(0)
    return wanted


@cache
def draws_in_software() -> bool:
    """Whether OpenGL is computed by the processor here."""
    names = opengl_names(surface_format())
    return names is not None and any(part in names[1].lower() for part in _SOFTWARE)


def prepare_window_of(view: QWidget) -> None:
    """Let the window of a view be made as its drawing widget, which comes later, will need it."""
    QSurfaceFormat.setDefaultFormat(surface_format())
    if not draws_in_software():
        # A top-level window that meets its first OpenGL widget when it is already shown is made
        # anew, with a flash. This one is never drawn.
        QOpenGLWidget(view).hide()
