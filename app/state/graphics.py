"""What draws here: the names of OpenGL."""

from __future__ import annotations

from PySide6.QtGui import QOffscreenSurface, QOpenGLContext, QSurfaceFormat

_VENDOR, _RENDERER, _VERSION = 0x1F00, 0x1F01, 0x1F02


def opengl_names(wanted: QSurfaceFormat | None = None) -> tuple[str, str, str] | None:
    """Return the vendor, the renderer and the version of OpenGL; None where there is none.

    ``wanted`` is what is asked of it, by default nothing but Qt's own default.
    """
    context, surface = QOpenGLContext(), QOffscreenSurface()
    if wanted is not None:
        context.setFormat(wanted)
        surface.setFormat(wanted)
    surface.create()
    if not (context.create() and context.makeCurrent(surface)):
        return None
    read = context.functions().glGetString
    found = str(read(_VENDOR)), str(read(_RENDERER)), str(read(_VERSION))
    context.doneCurrent()
    return found
