"""What the pen shows: the coming segment, handles, guides, and what a press would do."""

from __future__ import annotations

import math

import numpy as np
from PySide6.QtCore import QPointF, QRectF, Qt

from app.hand.canvas import Canvas
from app.hand.coordinates import ScreenPoint, decimals_for, number
from app.hand.pen_aim import Act, Aim, Run
from app.hand.snapping import Landing
from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import Segment
from sgb_core.design.pen import Anchor, between
from sgb_core.values import dataclass

_WORDS = {
    Act.NOTHING: "Begin at an end, or on the curve",
    Act.START: "Click a corner, or drag",
    Act.GO_ON: "Go on from here",
    Act.POLE: "Pole on the axis",
    Act.CLOSE: "Close the ring",
    Act.INSERT: "Insert a point",
    Act.BREAK: "Break the handle",
}
_RING = "A ring has no end: click on the curve"


@dataclass(frozen=True, slots=True)
class PenState:
    """All that one picture of the pen shows.

    ``pull`` is where the handle in the hand lands; ``at`` the pointer or the keyboard's cursor;
    ``refused`` says that a press was in vain there.
    """

    profile: Profile
    unit: str
    run: Run | None
    aim: Aim | None
    held: bool
    pull: Landing | None
    at: ScreenPoint | None
    by_keys: bool
    refused: bool

    @property
    def coming(self) -> Segment | None:
        """The segment that a press would add."""
        if self.run is None or self.aim is None or self.held or self.at is None:
            return None
        last = self.run.path.last
        if self.aim.act is Act.CLOSE:
            target = self.run.target(self.profile)
            return None if target is None else between(last, self.run.path.onto(target).last)
        if self.aim.act not in (Act.PLACE, Act.POLE):
            return None
        return self.run.path.coming(self.aim.landing.point.pair)


def draw(canvas: Canvas, state: PenState) -> None:
    """Draw it over the profile."""
    _draw_guides(canvas, state)
    if state.run is None:
        _draw_ends(canvas, state)
    else:
        coming = state.coming
        if coming is not None:
            canvas.quartic(coming.quartic, canvas.pen("canvas", 4.5, 170))
            canvas.quartic(coming.quartic, canvas.pen("accent", 2.0, 235))
        _draw_anchor(canvas, state.run.path.last)
        if state.run.bare and len(state.run.path.anchors) == 1:
            _square(canvas, state.run.path.last.place)
    _draw_aim(canvas, state)


def _draw_guides(canvas: Canvas, state: PenState) -> None:
    landing = state.pull if state.held else None if state.aim is None else state.aim.landing
    if landing is None or state.at is None:
        return
    area, pen = canvas.area, canvas.pen("accent", 1.0, 190, Qt.PenStyle.DashLine)
    if landing.on_axis:
        x = canvas.transform.x0
        canvas.line(np.array((x, area.top)), np.array((x, area.bottom)), canvas.pen("accent", 2.0))
    beside, level = landing.aligned
    if beside is not None and not landing.on_axis:
        x = float(canvas.transform.map((beside, 0.0))[0])
        canvas.line(np.array((x, area.top)), np.array((x, area.bottom)), pen)
    if level is not None:
        y = float(canvas.transform.map((0.0, level))[1])
        canvas.line(np.array((area.left, y)), np.array((area.right, y)), pen)
    if landing.guide is not None and state.run is not None:
        centre = canvas.transform.map(state.run.path.last.place)
        far = (area.width + area.height) * 2.0
        step = np.array((landing.guide[0], -landing.guide[1])) * far
        canvas.line(centre - step, centre + step, pen)


def _draw_ends(canvas: Canvas, state: PenState) -> None:
    """Ring the ends from which the pen can go on."""
    if state.profile.closed or (state.aim is not None and state.aim.act is Act.START):
        return
    points = state.profile.control_points
    for end in (points[0, 0], points[-1, 3]):
        x, y = canvas.transform.map(end).tolist()
        canvas.painter.setPen(canvas.pen("accent", 1.8))
        canvas.painter.setBrush(canvas.color("accent", 45))
        canvas.painter.drawEllipse(QPointF(x, y), 8.0, 8.0)
    canvas.painter.setBrush(Qt.BrushStyle.NoBrush)


def _draw_anchor(canvas: Canvas, anchor: Anchor) -> None:
    """Draw the handles of the last anchor, as long as it has some."""
    place = canvas.transform.map(anchor.place)
    for handle in (anchor.incoming, anchor.outgoing):
        if handle is None:
            continue
        tip = canvas.transform.map(handle)
        canvas.line(place, tip, canvas.pen("accent", 1.4))
        canvas.painter.setPen(canvas.pen("canvas", 1.2))
        canvas.painter.setBrush(canvas.color("accent"))
        canvas.painter.drawEllipse(QPointF(*tip.tolist()), 4.0, 4.0)
    canvas.painter.setBrush(Qt.BrushStyle.NoBrush)


def _square(canvas: Canvas, place: tuple[float, float]) -> None:
    x, y = canvas.transform.map(place).tolist()
    canvas.painter.setPen(canvas.pen("canvas", 1.4))
    canvas.painter.setBrush(canvas.color("accent"))
    canvas.painter.drawRect(QRectF(x - 4.0, y - 4.0, 8.0, 8.0))
    canvas.painter.setBrush(Qt.BrushStyle.NoBrush)


def _draw_aim(canvas: Canvas, state: PenState) -> None:
    """Mark where a press lands, and what kind it is: a ring to close, a plus to insert."""
    if state.aim is None or state.held or state.at is None:
        return
    act, painter = state.aim.act, canvas.painter
    at = canvas.transform.map(state.aim.landing.point.pair)
    x, y = at.tolist()
    pen = canvas.pen("accent", 2.0)
    painter.setPen(pen)
    if act in (Act.CLOSE, Act.GO_ON):
        painter.drawEllipse(QPointF(x, y), 10.0, 10.0)
    elif act is Act.INSERT:
        for step in ((6.0, 0.0), (0.0, 6.0)):
            canvas.line(at - step, at + step, pen)
    elif act in (Act.PLACE, Act.POLE, Act.START):
        painter.setBrush(canvas.color("canvas"))
        painter.drawRect(QRectF(x - 3.0, y - 3.0, 6.0, 6.0))
        painter.setBrush(Qt.BrushStyle.NoBrush)
    if state.by_keys:
        for step in ((14.0, 0.0), (0.0, 14.0)):
            canvas.line(at - step, at + step, canvas.pen("accent", 1.0))


def told(state: PenState, scale: float) -> tuple[ScreenPoint, list[str]] | None:
    """Return where the heads-up label stands and what it says; None where there is nothing."""
    if state.aim is None or state.at is None:
        return None
    decimals, unit = decimals_for(1.0 / scale), state.unit
    landing = state.pull if state.held and state.pull is not None else state.aim.landing
    r, h = landing.point.pair
    lines = [f"r {number(r, decimals)}   h {number(h, decimals)} {unit}"]
    act = state.aim.act
    if not state.held and act in _WORDS:
        ringed = act is Act.NOTHING and state.profile.closed
        lines.insert(0, _RING if ringed else _WORDS[act])
    if act is Act.NOTHING:
        return (state.at, lines[:1]) if state.refused else None
    path = None if state.run is None else state.run.path
    base = None
    if path is not None and state.held:
        base = path.last.place if state.pull is not None else None
    elif path is not None and act in (Act.PLACE, Act.POLE):
        base = path.last.place
    if base is not None:
        dr, dh = r - base[0], h - base[1]
        angle = number(math.degrees(math.atan2(dh, dr)), 1)
        lines.append(f"{number(math.hypot(dr, dh), decimals)} {unit}   ∠ {angle}°")
    return state.at, lines
