"""What keys mean to a hand: steps of the arrows, and modifiers during a drag."""

from __future__ import annotations

from PySide6.QtCore import Qt

from app.hand.snapping import DragKeys

NUDGES: dict[int, tuple[int, int]] = {
    Qt.Key.Key_Left: (-1, 0),
    Qt.Key.Key_Right: (1, 0),
    Qt.Key.Key_Up: (0, 1),
    Qt.Key.Key_Down: (0, -1),
}

_MODIFIERS: dict[int, Qt.KeyboardModifier] = {
    Qt.Key.Key_Control: Qt.KeyboardModifier.ControlModifier,
    Qt.Key.Key_Shift: Qt.KeyboardModifier.ShiftModifier,
    Qt.Key.Key_Alt: Qt.KeyboardModifier.AltModifier,
}


def keys_of(modifiers: Qt.KeyboardModifier) -> DragKeys:
    """Return what the modifier keys mean during a drag."""
    return DragKeys(
        free=bool(modifiers & Qt.KeyboardModifier.ControlModifier),
        constrain=bool(modifiers & Qt.KeyboardModifier.ShiftModifier),
        break_rule=bool(modifiers & Qt.KeyboardModifier.AltModifier),
    )


def modifier_of(key: int) -> Qt.KeyboardModifier:
    """Return the modifier that a key is, none for other keys.

    The events of a modifier key itself do not say reliably whether it counts already.
    """
    return _MODIFIERS.get(key, Qt.KeyboardModifier.NoModifier)
