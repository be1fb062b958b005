"""Measuring: any distance, angle, radius of curvature and wall, read where the hand is."""

from __future__ import annotations

from decimal import Decimal
from itertools import pairwise
from math import atan2, cos, pi, sin

import numpy as np
from PySide6.QtCore import Qt

from app.hand.canvas import Canvas
from app.hand.coordinates import DesignPoint, GridSteps, ScreenPoint, number
from app.hand.keys import NUDGES, keys_of
from app.hand.snapping import DragKeys
from app.profile_editor.tools.measured import MOST, Spot, dimension_of, spot_at, told_lines
from app.profile_editor.tools.tool import Sheet, Tool
from app.state.presenter import Presenter
from sgb_core.curves.measuring import on_curve
from sgb_core.document import edits

_PLACES = (Qt.Key.Key_Space, Qt.Key.Key_Return, Qt.Key.Key_Enter)
_BACK = (Qt.Key.Key_Backspace, Qt.Key.Key_Delete)
_KEEP = Qt.Key.Key_D
_FAR = 4.0
_CROSS, _ARC, _CIRCLE = 5.0, 26.0, 96
# A circle of curvature so many times as large as the picture is a line.
_LARGEST = 20.0


class MeasureTool(Tool):
    """Click from place to place: distance, then the angle between two ways; a press ends it.

    Nothing of the document changes, but for a dimension that is kept of what is read (D).
    """

    def __init__(self, presenter: Presenter, sheet: Sheet) -> None:
        super().__init__(presenter, sheet)
        self._placed: tuple[Spot, ...] = ()
        self._here: Spot | None = None
        self._keys = DragKeys()
        self._cursor: DesignPoint | None = None
        self._pressed: ScreenPoint | None = None

    @property
    def busy(self) -> bool:
        """Whether something is being measured."""
        return bool(self._placed)

    @property
    def held(self) -> bool:
        """Whether the button is down."""
        return self._pressed is not None

    @property
    def placed(self) -> tuple[Spot, ...]:
        """The places that are measured from so far."""
        return self._placed

    # The mouse.

    def press(self, at: ScreenPoint, keys: DragKeys) -> None:
        """Measure from here, or to here and on."""
        self._cursor, self._pressed = None, at
        self._point_at(self._sheet.transform.to_design(at), keys)
        self._place()

    def move(self, at: ScreenPoint | None, keys: DragKeys) -> None:
        """Read between the last place and the pointer."""
        self._keys = keys
        if at is None:
            if self._cursor is None:
                self._here = None
            return
        self._cursor = None
        self._point_at(self._sheet.transform.to_design(at), keys)

    def modified(self, keys: DragKeys) -> None:
        """Read again with other keys held."""
        self._keys = keys
        if self._here is not None and self._cursor is None:
            self._point_at(self._here.place, keys)

    def release(self, at: ScreenPoint, keys: DragKeys) -> None:
        """Measure to here, where the button was held on the way."""
        pressed, self._pressed = self._pressed, None
        if pressed is not None and pressed.distance(at) >= _FAR:
            self._point_at(self._sheet.transform.to_design(at), keys)
            self._place()

    # The keyboard.

    def wants(self, key: int, modifiers: Qt.KeyboardModifier) -> bool:
        """Want the arrows, what places, takes back and keeps."""
        if modifiers & ~(Qt.KeyboardModifier.ShiftModifier | Qt.KeyboardModifier.KeypadModifier):
            return False
        if key in NUDGES or key in (_KEEP, Qt.Key.Key_Space):
            return True
        if key in _PLACES:
            return self._here is not None
        return key in _BACK and self.busy

    def key(self, key: int, modifiers: Qt.KeyboardModifier) -> bool:
        """Move the tool's own cursor, place, take back, or keep what is read."""
        if key in NUDGES:
            self._step(NUDGES[key], large=bool(modifiers & Qt.KeyboardModifier.ShiftModifier))
        elif key in _PLACES and self._here is not None:
            self._place()
        elif key in _BACK:
            self._placed = self._placed[:-1]
        elif key == _KEEP:
            self._keep()
        return True

    def escape(self) -> None:
        """Measure nothing any more."""
        self._placed, self._pressed = (), None

    def put_away(self) -> None:
        """Forget what was measured: another tool is taken."""
        self.escape()

    def _step(self, way: tuple[int, int], *, large: bool) -> None:
        """Move the keyboard's cursor by a step of the grid, five with Shift."""
        transform, area = self._sheet.transform, self._sheet.area
        start = self._cursor
        if start is None:
            middle = ScreenPoint((area.left + area.right) / 2.0, (area.top + area.bottom) / 2.0)
            start = self._placed[-1].place if self._placed else transform.to_design(middle)
        steps = GridSteps.at(transform.scale)
        step = Decimal(repr(steps.minor)) * (5 if large else 1)
        r, h = (
            float(Decimal(repr(steps.snapped(value))) + sign * step)
            for value, sign in zip(start.pair, way, strict=True)
        )
        self._cursor = DesignPoint(r, h)
        self._sheet.bring_in(transform.to_screen(self._cursor))
        self._point_at(self._cursor, keys_of(Qt.KeyboardModifier.NoModifier))

    # What both lead to.

    def _point_at(self, cursor: DesignPoint, keys: DragKeys) -> None:
        last = self._placed[-1] if self._placed else None
        self._here = spot_at(self._sheet.frame, self._sheet.transform, cursor, keys, last)
        self._sheet.update()

    def _place(self) -> None:
        if self._here is None:
            return
        if len(self._placed) == MOST:
            self._placed = ()
        if not self._placed or self._placed[-1].place != self._here.place:
            self._placed = (*self._placed, self._here)
        self._sheet.update()

    def _keep(self) -> None:
        """Keep what is read as a dimension of the project."""
        if self._here is None:
            return
        placed = self._placed
        if placed and placed[-1].place == self._here.place:
            placed = placed[:-1]
        dimension = dimension_of(placed, self._here)
        if dimension is None:
            said = "Only distances between points, diameters and radii are kept as dimensions"
            self._presenter.notify(f"{said}.", "info")
            return
        label = f"Add {dimension.label.lower()}"
        self._presenter.do(label, lambda d: edits.add_dimension(d, dimension))

    # The picture.

    def draw(self, canvas: Canvas) -> None:
        """Draw the ways that are measured, their angle, and the circle that bends as the curve."""
        spots = self._spots()
        if self._here is not None and not self._placed:
            self._draw_circle(canvas, self._here)
        places = [canvas.transform.map(np.array(spot.place.pair)) for spot in spots]
        pen = canvas.pen("accent", 1.6)
        for start, end in pairwise(places):
            canvas.line(start, end, pen)
        for place in places:
            for way in (np.array((_CROSS, 0.0)), np.array((0.0, _CROSS))):
                canvas.line(place - way, place + way, pen)
        if len(places) == MOST:
            _draw_opening(canvas, *places)

    def _spots(self) -> tuple[Spot, ...]:
        if self._here is None or len(self._placed) == MOST:
            return self._placed
        return (*self._placed, self._here)

    def _draw_circle(self, canvas: Canvas, spot: Spot) -> None:
        if spot.curve is None:
            return
        read = on_curve(self._sheet.frame.document.profile, *spot.curve)
        if read.radius is None or read.centre is None:
            return
        if read.radius * canvas.transform.scale > _LARGEST * canvas.area.height:
            return
        turn = np.linspace(0.0, 2.0 * pi, _CIRCLE + 1)
        ring = np.stack([np.cos(turn), np.sin(turn)], axis=-1) * read.radius
        pen = canvas.pen("accent", 1.0, 130, Qt.PenStyle.DashLine)
        canvas.polyline(canvas.transform.map(ring + np.array(read.centre)), pen)
        centre = canvas.transform.map(np.array(read.centre))
        canvas.line(centre, canvas.transform.map(np.array(spot.place.pair)), pen)

    def told(self) -> tuple[ScreenPoint, list[str]] | None:
        """Say what is read, and what can be kept of it."""
        frame, transform = self._sheet.frame, self._sheet.transform
        if len(self._placed) == MOST:
            placed, here = self._placed[:-1], self._placed[-1]
        elif self._here is not None:
            placed, here = self._placed, self._here
        else:
            return None
        if placed and placed[-1].place == here.place and len(placed) > 1:
            placed = placed[:-1]
        lines = told_lines(frame, transform.scale, placed, here)
        if dimension_of(placed, here) is not None:
            lines.append("D keeps it as a dimension")
        return transform.to_screen(here.place), lines


def _draw_opening(canvas: Canvas, one: np.ndarray, vertex: np.ndarray, other: np.ndarray) -> None:
    """Draw the arc between two ways on the screen, the shorter way round."""
    ways = [one - vertex, other - vertex]
    if any(float(np.hypot(*way)) < 1.0 for way in ways):
        return
    start, end = (atan2(float(way[1]), float(way[0])) for way in ways)
    turn = (end - start + pi) % (2.0 * pi) - pi
    angles = np.linspace(start, start + turn, 33)
    radius = min(_ARC, *(0.6 * float(np.hypot(*way)) for way in ways))
    arc = vertex + radius * np.stack([np.cos(angles), np.sin(angles)], axis=-1)
    canvas.polyline(arc, canvas.pen("accent", 1.4))
    middle = start + turn / 2.0
    at = vertex + (radius + 4.0) * np.array((cos(middle), sin(middle)))
    text = f"{number(abs(turn) * 180.0 / pi, 1)}°"
    canvas.label(at, text, canvas.color("text"), 4.0)
