"""The profile editor while numbers are typed in the middle of a drag."""

from __future__ import annotations

from PySide6.QtCore import Qt
from PySide6.QtGui import QKeyEvent

from app.hand.keys import keys_of
from app.profile_editor.touch_sheet import TouchSheet


class TypedSheet(TouchSheet):
    """Digits begin a number for what is in the hand, Tab goes to the next, Enter lets go there."""

    def _types(self, event: QKeyEvent) -> bool:
        """Return whether a key belongs to a number."""
        held = event.modifiers() & ~(
            Qt.KeyboardModifier.ShiftModifier | Qt.KeyboardModifier.KeypadModifier
        )
        return held == Qt.KeyboardModifier.NoModifier and self._hand.would_type(
            event.key(), event.text()
        )

    def _type(self, event: QKeyEvent) -> bool:
        """Take a key of a number; return whether it was one."""
        if not self._types(event):
            return False
        self._hand.type(event.key(), event.text())
        self._typed_drag()
        return True

    def focusNextPrevChild(self, forward: bool) -> bool:
        if self._hand.type_next(forward):
            self.update()
            return True
        return super().focusNextPrevChild(forward)

    def _typed_drag(self) -> None:
        if self._pointer is not None and self._hand.gesture.edits:
            nothing = keys_of(Qt.KeyboardModifier.NoModifier)
            self._hand.drag(self._pointer, self._transform, nothing)
