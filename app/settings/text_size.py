"""The size of all text: the system's, times what the user prefers."""

from __future__ import annotations

from PySide6.QtWidgets import QApplication

from app.state import preferences

_PROPERTY = "system_point_size"


def apply(app: QApplication, percent: int) -> None:
    """Scale the text of the whole application, now and whenever the preference changes."""
    if app.property(_PROPERTY) is None:
        app.setProperty(_PROPERTY, app.font().pointSizeF())
        preferences.notifier().changed.connect(lambda wanted: _scale(app, wanted.text_percent))
    _scale(app, percent)


def _scale(app: QApplication, percent: int) -> None:
    font, wanted = app.font(), float(app.property(_PROPERTY)) * percent / 100.0
    if font.pointSizeF() != wanted:
        font.setPointSizeF(wanted)
        app.setFont(font)
        # A style sheet keeps the fonts of widgets that it has dressed already.
        app.setStyleSheet(app.styleSheet())
