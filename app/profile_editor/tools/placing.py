"""Placing the picture behind the profile: moved, turned and scaled by the hand."""

from __future__ import annotations

from dataclasses import replace
from math import atan2, degrees, hypot

from PySide6.QtCore import Qt

from app.hand.coordinates import DesignPoint, ScreenPoint
from app.hand.keys import NUDGES
from app.hand.snapping import DragKeys
from app.profile_editor.tools.tool import Sheet, Tool
from app.state.presenter import Presenter
from sgb_core.document import edits
from sgb_core.document.reference import Reference

_LABELS = {"move": "Move the picture", "turn": "Turn the picture", "scale": "Scale the picture"}
_NONE = "No picture lies behind: File > Import brings one"
_LOCKED = "The picture is locked: View > Picture behind"
_SAID = "Drag moves it, Shift turns, Alt scales about r = 0, h = 0"


class PlacingTool(Tool):
    """Drag the picture; with Shift it turns, with Alt it scales about r = 0, h = 0."""

    cursor = Qt.CursorShape.SizeAllCursor

    def __init__(self, presenter: Presenter, sheet: Sheet) -> None:
        super().__init__(presenter, sheet)
        self._start: tuple[Reference, DesignPoint] | None = None
        self._pointer: ScreenPoint | None = None
        self._way = ""

    @property
    def busy(self) -> bool:
        """Whether the picture is in the hand."""
        return self._start is not None

    @property
    def held(self) -> bool:
        """The same."""
        return self._start is not None

    @property
    def _free(self) -> Reference | None:
        """The reference, where there is one that may be moved."""
        source = self._presenter.document.reference
        return source if source is not None and source.shown and not source.locked else None

    def press(self, at: ScreenPoint, keys: DragKeys) -> None:
        """Take hold of the picture."""
        self._pointer, source = at, self._free
        if source is None:
            return
        self._way = "turn" if keys.constrain else "scale" if keys.break_rule else "move"
        self._start = (source, self._sheet.transform.to_design(at))
        self._presenter.begin(_LABELS[self._way])

    def move(self, at: ScreenPoint | None, keys: DragKeys) -> None:
        """Move, turn or scale what is in the hand."""
        self._pointer = at
        if at is None or self._start is None:
            return
        (source, start), here = self._start, self._sheet.transform.to_design(at)
        moved = source.moved((here.r - start.r, here.h - start.h))
        if self._way == "turn":
            angle = atan2(here.h, here.r) - atan2(start.h, start.r)
            moved = replace(source, turn_deg=_within(source.turn_deg - degrees(angle)))
        elif self._way == "scale":
            factor = hypot(here.r, here.h) / max(hypot(start.r, start.h), 1e-9)
            moved = replace(source, scale=source.scale * min(max(factor, 1e-3), 1e3))
        self._presenter.apply(lambda document: edits.set_reference(document, moved))

    def release(self, at: ScreenPoint, keys: DragKeys) -> None:
        """Leave it where it is."""
        if self._start is not None:
            self._start = None
            self._presenter.commit()

    def escape(self) -> None:
        """Put it back."""
        if self._start is not None:
            self._start = None
            self._presenter.cancel()

    def put_away(self) -> None:
        """Leave it where it is."""
        if self._start is not None:
            self._start = None
            self._presenter.commit()

    def wants(self, key: int, modifiers: Qt.KeyboardModifier) -> bool:
        """Want the arrows."""
        return key in NUDGES and not modifiers & Qt.KeyboardModifier.ControlModifier

    def key(self, key: int, modifiers: Qt.KeyboardModifier) -> bool:
        """Nudge by a pixel of the screen, ten with Shift."""
        source = self._free
        if source is None or self.held:
            return True
        step = 10.0 if modifiers & Qt.KeyboardModifier.ShiftModifier else 1.0
        dx, dy = (step * way / self._sheet.transform.scale for way in NUDGES[key])
        moved = source.moved((dx, dy))
        self._presenter.do(_LABELS["move"], lambda d: edits.set_reference(d, moved))
        return True

    def told(self) -> tuple[ScreenPoint, list[str]] | None:
        """Say what the hand can do here."""
        if self._pointer is None or self.held:
            return None
        source = self._presenter.document.reference
        if source is None:
            return self._pointer, [_NONE]
        return self._pointer, [_SAID if self._free is not None else _LOCKED]


def _within(turn: float) -> float:
    """Return an angle in degrees from −180 to 180."""
    return (turn + 180.0) % 360.0 - 180.0
