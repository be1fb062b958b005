"""How mouse buttons and keys move the camera: our own way, and those of other programs."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field
from enum import Enum, auto

from PySide6.QtCore import Qt

from app.state import preferences
from sgb_core.values import dataclass

_LEFT, _MIDDLE, _RIGHT = (
    Qt.MouseButton.LeftButton,
    Qt.MouseButton.MiddleButton,
    Qt.MouseButton.RightButton,
)
_NONE, _SHIFT, _CTRL, _ALT = (
    Qt.KeyboardModifier.NoModifier,
    Qt.KeyboardModifier.ShiftModifier,
    Qt.KeyboardModifier.ControlModifier,
    Qt.KeyboardModifier.AltModifier,
)


class Hand(Enum):
    """What the pressed mouse does to the camera."""

    IDLE = auto()
    ORBIT = auto()
    PAN = auto()
    ZOOM = auto()


Press = tuple[Qt.MouseButton, Qt.KeyboardModifier]


@dataclass(frozen=True, slots=True)
class Style:
    """One program's habits: what a drag does, and its own keys for "fit" and "projection"."""

    title: str
    drags: Mapping[Press, Hand]
    keys: Mapping[Qt.Key, str] = field(default_factory=dict)
    fits_on: Qt.MouseButton = Qt.MouseButton.NoButton

    def hand_for(self, button: Qt.MouseButton, modifiers: Qt.KeyboardModifier) -> Hand:
        """Return what a drag with this button and these keys does."""
        held = modifiers & (_SHIFT | _CTRL | _ALT)
        return self.drags.get((button, held), Hand.IDLE)


STYLES: Mapping[str, Style] = {
    "studio": Style(
        "SGB Studio",
        {
            (_LEFT, _NONE): Hand.ORBIT,
            (_LEFT, _SHIFT): Hand.PAN,
            (_LEFT, _CTRL): Hand.ORBIT,
            (_LEFT, _ALT): Hand.ORBIT,
            (_MIDDLE, _NONE): Hand.PAN,
            (_MIDDLE, _SHIFT): Hand.PAN,
        },
    ),
    "blender": Style(
        "Blender",
        {
            (_MIDDLE, _NONE): Hand.ORBIT,
            (_MIDDLE, _SHIFT): Hand.PAN,
            (_MIDDLE, _CTRL): Hand.ZOOM,
            (_LEFT, _ALT): Hand.ORBIT,
            (_LEFT, _ALT | _SHIFT): Hand.PAN,
            (_LEFT, _ALT | _CTRL): Hand.ZOOM,
        },
        {Qt.Key.Key_5: "projection", Qt.Key.Key_Period: "fit", Qt.Key.Key_Home: "fit"},
    ),
    "rhino": Style(
        "Rhino",
        {
            (_RIGHT, _NONE): Hand.ORBIT,
            (_RIGHT, _SHIFT): Hand.PAN,
            (_RIGHT, _CTRL): Hand.ZOOM,
            (_MIDDLE, _NONE): Hand.PAN,
        },
    ),
    "fusion": Style(
        "Fusion",
        {
            (_MIDDLE, _NONE): Hand.PAN,
            (_MIDDLE, _SHIFT): Hand.ORBIT,
            (_MIDDLE, _CTRL): Hand.ZOOM,
        },
        {Qt.Key.Key_F6: "fit"},
        fits_on=_MIDDLE,
    ),
}


def remembered() -> str:
    """Return the name of the style chosen in the preferences."""
    return preferences.current().navigation_style
