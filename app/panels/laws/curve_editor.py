"""The angle-curve editor: how a shape parameter runs around the turn, with keys to drag."""

from __future__ import annotations

from PySide6.QtCore import QEvent, Signal
from PySide6.QtGui import QMouseEvent
from PySide6.QtWidgets import QWidget

from app.panels.laws.key_curve import HELP, SNAP
from app.panels.laws.key_sheet import Key
from app.panels.laws.plot import value_at
from app.panels.laws.sheet import AngleSheet
from sgb_core.document import edits
from sgb_core.surfaces.variation import Law

ROUND_DEGREES, ROUND_VALUE = 15.0, 0.25


class AngleCurve(AngleSheet):
    """Shows f(θ) of one law and lets its keys be moved.

    ``hovered`` gives the angle under the pointer in degrees, or None. ``keys_wanted`` asks
    whether a law of several waves is to become so many keys first.
    """

    NUDGE = (1.0, 0.01)

    hovered = Signal(object)
    keys_wanted = Signal(int)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setAccessibleName("Angle curve")
        self.setToolTip(
            "How the parameter runs around the turn, from the start angle on; the curve stays\n"
            f"between neighbouring keys.\n{HELP}"
        )

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        super().mouseMoveEvent(event)
        at = event.position()
        inside = self.plot.box.contains(at)
        self.hovered.emit(min(max(self.read(at)[0], 0.0), 360.0) if inside else None)

    def leaveEvent(self, event: QEvent) -> None:
        self.hovered.emit(None)
        super().leaveEvent(event)

    def _step_name(self, verb: str) -> str:
        return f"{verb} key {'to' if verb == 'Add' else 'of'} {self._name}"

    def _snapped(self, at: Key, levels: list[float]) -> Key:
        (degrees, value), plot = at, self.plot
        nearest = ROUND_DEGREES * round(degrees / ROUND_DEGREES)
        close = abs(nearest - degrees) * plot.width / 360.0 <= SNAP
        degrees = nearest if close else round(degrees, 1)
        marks = [ROUND_VALUE * round(value / ROUND_VALUE), *levels]
        mark = min(marks, key=lambda each: abs(each - value))
        close = abs(mark - value) * plot.height <= SNAP
        return degrees, mark if close else round(value, 3)

    def _moved(self, law: Law, index: int, to: Key) -> Law:
        return edits.with_key_moved(law, index, *to)

    def _without(self, law: Law, index: int) -> Law:
        return edits.without_key(law, index)

    def _with(self, law: Law, key: Key) -> Law | None:
        keys = edits.as_keyframes(law)
        if keys is not law and (law.waves or 1) > 1:
            # One key is what was asked for, not the dozens that all the waves need.
            self.keys_wanted.emit(len(keys.keyframes))
            return None
        return edits.with_key(keys, key[0], min(max(key[1], 0.0), 1.0))

    def _between(self, law: Law, selected: int | None) -> Key:
        turns = sorted(key[0] % 360.0 for key in self._keys)
        if selected is None or not turns:
            degrees = (turns[0] + 45.0) % 360.0 if turns else 90.0
        else:
            here = self._keys[selected][0] % 360.0
            after = next((turn for turn in turns if turn > here), turns[0] + 360.0)
            degrees = ((here + after) / 2.0) % 360.0
        span = law.end - law.start
        return degrees, (value_at(law, degrees) - law.start) / span if span else 0.5
