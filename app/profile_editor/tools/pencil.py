"""The pencil: a freehand stroke is traced into the profile, on from an end, or over a part."""

from __future__ import annotations

import numpy as np
from PySide6.QtCore import Qt

from app.hand.canvas import Canvas
from app.hand.coordinates import ScreenPoint
from app.hand.drag import START_DISTANCE
from app.hand.keys import NUDGES
from app.hand.snapping import DragKeys
from app.profile_editor.tools.tool import Sheet, Tool
from app.state.blank import is_blank
from app.state.presenter import Presenter
from sgb_core.arrays import Floats
from sgb_core.curves.nearest import nearest
from sgb_core.document.edits.stroke import Stroke, StrokeKind, draw_stroke, seen

# How true the chain is to the stroke, and how near to the profile a stroke begins there, in pixels.
TOLERANCE, REACH = 1.2, 10.0
# A step of the keyboard's pencil, in pixels.
_STEP = 8.0
_LABELS = {
    StrokeKind.WHOLE: "Draw the profile by hand",
    StrokeKind.ON: "Draw on by hand",
    StrokeKind.PART: "Redraw a part by hand",
}
_SAID = {
    StrokeKind.WHOLE: "A new profile",
    StrokeKind.ON: "On from the end",
    StrokeKind.PART: "Redraws this part",
}
_PUT = (Qt.Key.Key_Space, Qt.Key.Key_Return, Qt.Key.Key_Enter)


class PencilTool(Tool):
    """Drag freehand; each stroke is one undo entry.

    With the keyboard Space puts the pencil down at its cursor, arrows draw, Enter lets go.
    """

    def __init__(self, presenter: Presenter, sheet: Sheet) -> None:
        super().__init__(presenter, sheet)
        # In design coordinates, so that the paper may be zoomed and panned under the stroke.
        self._stroke: list[tuple[float, float]] = []
        self._pointer: ScreenPoint | None = None
        self._by_keys = False

    @property
    def busy(self) -> bool:
        """Whether a stroke is being drawn."""
        return bool(self._stroke)

    @property
    def held(self) -> bool:
        """The same: the pencil is down as long as it draws."""
        return bool(self._stroke)

    # The mouse.

    def press(self, at: ScreenPoint, keys: DragKeys) -> None:
        """Put the pencil down."""
        self._pointer, self._by_keys = at, False
        self._stroke = [self._sheet.transform.to_design(at).pair]

    def move(self, at: ScreenPoint | None, keys: DragKeys) -> None:
        """Draw where the pencil is down."""
        if at is None:
            if not self.held:
                self._pointer = None
            return
        if self.held and not self._by_keys and at != self._pointer:
            self._stroke.append(self._sheet.transform.to_design(at).pair)
        self._pointer = at

    def release(self, at: ScreenPoint, keys: DragKeys) -> None:
        """Trace what was drawn; a mere click draws nothing."""
        if not self.held:
            return
        points, self._stroke = np.array(self._stroke), []
        scale = self._sheet.transform.scale
        if float(np.hypot(*np.ptp(points, axis=0))) * scale < START_DISTANCE:
            return
        stroke = self._meaning(points)
        self._presenter.do(
            _LABELS[stroke.kind],
            lambda document: draw_stroke(document, stroke, TOLERANCE / scale, REACH / scale),
        )

    def _meaning(self, points: Floats) -> Stroke:
        document, scale = self._presenter.document, self._sheet.transform.scale
        # The blank sheet's own curve is nothing to go on from.
        profile = None if is_blank(document) else document.profile
        return seen(profile, points, REACH / scale)

    # The keyboard.

    def wants(self, key: int, modifiers: Qt.KeyboardModifier) -> bool:
        """Want the arrows, and what puts the pencil down and lifts it."""
        held = modifiers & ~(Qt.KeyboardModifier.ShiftModifier | Qt.KeyboardModifier.KeypadModifier)
        return not held and (key in NUDGES or key in _PUT)

    def key(self, key: int, modifiers: Qt.KeyboardModifier) -> bool:
        """Move the pencil, drawing where it is down; put it down, or lift it."""
        at = self._pointer or self._middle()
        if key in NUDGES:
            far = _STEP * (5.0 if modifiers & Qt.KeyboardModifier.ShiftModifier else 1.0)
            dx, dy = NUDGES[key]
            at = ScreenPoint(at.x + far * dx, at.y - far * dy)
            if self.held:
                self._stroke.append(self._sheet.transform.to_design(at).pair)
            self._pointer = at
        elif self.held:
            self.release(at, DragKeys())
        elif key == Qt.Key.Key_Space:
            self.press(at, DragKeys())
            self._by_keys = True
        return True

    def _middle(self) -> ScreenPoint:
        area = self._sheet.area
        return ScreenPoint((area.left + area.right) / 2.0, (area.top + area.bottom) / 2.0)

    def escape(self) -> None:
        """Drop the stroke in the hand."""
        self._stroke = []

    def put_away(self) -> None:
        """Trace what is being drawn, as letting go does."""
        if self._pointer is not None:
            self.release(self._pointer, DragKeys())

    # The picture.

    def draw(self, canvas: Canvas) -> None:
        """Draw the stroke as it is drawn, and mark where one would go on from the profile."""
        if len(self._stroke) > 1:
            places = canvas.transform.map(np.array(self._stroke))
            canvas.polyline(places, canvas.pen("canvas", 4.5, 170))
            canvas.polyline(places, canvas.pen("accent", 2.2))
        if self._pointer is None or is_blank(self._presenter.document):
            return
        transform = self._sheet.transform
        place = transform.to_design(self._pointer).pair
        foot = nearest(self._presenter.document.profile, place)
        if foot.distance * transform.scale <= REACH:
            x, y = transform.map(foot.point).tolist()
            canvas.painter.setPen(canvas.pen("accent", 1.8))
            canvas.painter.drawEllipse(int(x) - 6, int(y) - 6, 12, 12)

    def told(self) -> tuple[ScreenPoint, list[str]] | None:
        """Say what letting go would do."""
        if self._pointer is None or len(self._stroke) < 2:
            return None
        return self._pointer, [_SAID[self._meaning(np.array(self._stroke)).kind]]
