"""The two colour schemes of the window: one named colour per meaning, and how they are applied.

Widgets read ``current()`` when they paint, and connect to ``notifier().changed`` where they keep
something that depends on the colours (a recoloured icon, a cached picture).
"""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType
from typing import Literal

from PySide6.QtCore import QObject, Qt, Signal
from PySide6.QtGui import QColor, QPalette
from PySide6.QtWidgets import QApplication, QStyleFactory

from app.theme.palette import DARK, LIGHT, Palette
from app.theme.style_sheet import style_sheet

Choice = Literal["system", "light", "dark"]
# What can be chosen, and its words.
CHOICES: Mapping[Choice, str] = MappingProxyType(
    {"system": "Like the system", "light": "Light", "dark": "Dark"}
)

__all__ = [
    "CHOICES",
    "DARK",
    "LIGHT",
    "Choice",
    "Notifier",
    "Palette",
    "apply",
    "choice",
    "current",
    "notifier",
    "qt_palette",
]


class Notifier(QObject):
    """Tells widgets, with the new palette, that the colours have changed."""

    changed = Signal(object)


class _State:
    """The theme in force; one per process, as there is one QApplication."""

    palette: Palette = LIGHT
    choice: Choice = "system"
    notifier: Notifier | None = None
    follows_system: bool = False


def current() -> Palette:
    """Return the palette in force."""
    return _State.palette


def choice() -> Choice:
    """Return what was last asked for: a theme, or to follow the system."""
    return _State.choice


def notifier() -> Notifier:
    """Return the object whose ``changed`` signal follows every change of theme."""
    if _State.notifier is None:
        _State.notifier = Notifier()
    return _State.notifier


def apply(app: QApplication, choice: Choice = "system") -> Palette:
    """Dress the whole application in a theme and return its palette.

    "system" follows the desktop's colour scheme, now and whenever it changes.
    """
    hints = app.styleHints()
    _State.choice = choice
    # Where the platform listens, this colours its own parts too (title bars, file dialogs).
    # Several do nothing here, so every role is set below whatever it answers.
    hints.setColorScheme(
        {
            "system": Qt.ColorScheme.Unknown,
            "light": Qt.ColorScheme.Light,
            "dark": Qt.ColorScheme.Dark,
        }[choice]
    )
    if not _State.follows_system:
        _State.follows_system = True
        hints.colorSchemeChanged.connect(lambda _scheme: _follow(app))
    palette = _wanted(app, choice)
    _dress(app, palette)
    if palette is not _State.palette:
        _State.palette = palette
        notifier().changed.emit(palette)
    return palette


def _wanted(app: QApplication, choice: Choice) -> Palette:
    if choice == "system":
        return DARK if app.styleHints().colorScheme() == Qt.ColorScheme.Dark else LIGHT
    return DARK if choice == "dark" else LIGHT


def _follow(app: QApplication) -> None:
    # Setting a scheme changes it too; only a change by the system is news.
    if _State.choice == "system" and _wanted(app, "system") is not _State.palette:
        apply(app, "system")


def _dress(app: QApplication, palette: Palette) -> None:
    # Under a style sheet the style's own name can no longer be asked for.
    if app.property("fusion") is None:
        app.setStyle(QStyleFactory.create("Fusion"))
        app.setProperty("fusion", True)
    app.setPalette(qt_palette(palette))
    sheet = style_sheet(palette)
    # Setting a style sheet polishes every widget anew: not for nothing.
    if app.styleSheet() != sheet:
        app.setStyleSheet(sheet)


def qt_palette(palette: Palette) -> QPalette:
    """Return a QPalette with every role set, for the style to draw with."""
    role = QPalette.ColorRole
    colours = {
        role.Window: palette.window,
        role.WindowText: palette.text,
        role.Base: palette.field,
        role.AlternateBase: palette.panel,
        role.ToolTipBase: palette.panel,
        role.ToolTipText: palette.text,
        role.PlaceholderText: palette.text_muted,
        role.Text: palette.text,
        role.Button: palette.panel,
        role.ButtonText: palette.text,
        role.BrightText: palette.error,
        role.Link: palette.accent,
        role.LinkVisited: palette.circle_p2,
        role.Highlight: palette.accent,
        role.HighlightedText: palette.accent_text,
        role.Accent: palette.accent,
        role.Light: palette.field,
        role.Midlight: palette.hover,
        role.Mid: palette.groove,
        role.Dark: palette.border,
        role.Shadow: palette.ghost,
    }
    result = QPalette()
    for colour_role, colour in colours.items():
        result.setColor(colour_role, QColor(colour))
    disabled = QPalette.ColorGroup.Disabled
    for text_role in (role.WindowText, role.Text, role.ButtonText, role.HighlightedText):
        result.setColor(disabled, text_role, QColor(palette.text_disabled))
    result.setColor(disabled, role.Highlight, QColor(palette.groove))
    result.setColor(disabled, role.Base, QColor(palette.window))
    return result
