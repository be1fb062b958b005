"""What curves with keys have in common: their keyboard keys, and a key in the hand."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType

from PySide6.QtCore import QPointF, Qt
from PySide6.QtGui import QKeyEvent

from sgb_core.surfaces.variation import Law

# A key moves once the pointer has gone so many pixels.
START_DISTANCE = 3.0
# Within so many pixels a key snaps to round places, and to what else there is.
SNAP = 5.0
# Which way an arrow key moves a key, across and up.
NUDGES: Mapping[Qt.Key, tuple[float, float]] = MappingProxyType(
    {
        Qt.Key.Key_Left: (-1.0, 0.0),
        Qt.Key.Key_Right: (1.0, 0.0),
        Qt.Key.Key_Up: (0.0, 1.0),
        Qt.Key.Key_Down: (0.0, -1.0),
    }
)
STEPS: Mapping[Qt.Key, int] = MappingProxyType({Qt.Key.Key_PageUp: -1, Qt.Key.Key_PageDown: 1})
REMOVALS = (Qt.Key.Key_Delete, Qt.Key.Key_Backspace)


@dataclass(frozen=True, slots=True)
class KeyDrag:
    """A key in the hand: where it was pressed, and the law as it was then."""

    index: int
    press: QPointF
    law: Law
    moving: bool = False


def keeps(event: QKeyEvent, *, busy: bool) -> bool:
    """Whether a curve keeps a keyboard key from the window's shortcuts.

    Escape only while it is ``busy``: with a key in the hand, or in a run of steps.
    """
    if event.key() == Qt.Key.Key_Escape:
        return busy
    ours = event.key() in (*NUDGES, *STEPS, *REMOVALS, Qt.Key.Key_Insert)
    return ours and not event.modifiers() & Qt.KeyboardModifier.ControlModifier
