"""Which keys belong to the text of a field, and which to the window's shortcuts."""

from __future__ import annotations

from PySide6.QtCore import Qt
from PySide6.QtGui import QKeyEvent

# With Ctrl, Alt or Meta these keys are the field's own; all others are the window's, among them
# those by which X11 moves the cursor: Ctrl+E is Export from every place.
_OWN_KEYS = frozenset(
    {
        Qt.Key.Key_A,
        Qt.Key.Key_C,
        Qt.Key.Key_X,
        Qt.Key.Key_V,
        Qt.Key.Key_Y,
        Qt.Key.Key_Z,
        Qt.Key.Key_Left,
        Qt.Key.Key_Right,
        Qt.Key.Key_Up,
        Qt.Key.Key_Down,
        Qt.Key.Key_Home,
        Qt.Key.Key_End,
        Qt.Key.Key_Insert,
        Qt.Key.Key_Delete,
        Qt.Key.Key_Backspace,
    }
)
_COMMAND = (
    Qt.KeyboardModifier.ControlModifier
    | Qt.KeyboardModifier.AltModifier
    | Qt.KeyboardModifier.MetaModifier
)
# AltGr, which types signs, comes as Ctrl and Alt together on some systems.
_ALT_GR = Qt.KeyboardModifier.ControlModifier | Qt.KeyboardModifier.AltModifier


def is_command(event: QKeyEvent) -> bool:
    """Whether a key belongs to the window's shortcuts and not to the text of a field."""
    held = event.modifiers() & _COMMAND
    typed = held == _ALT_GR and event.text().isprintable() and event.text() != ""
    return bool(held) and not typed and event.key() not in _OWN_KEYS
