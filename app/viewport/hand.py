"""The hand in the viewport: what it grabs there it drags as the profile editor would."""

from __future__ import annotations

import math
from dataclasses import replace
from math import degrees
from typing import Protocol

import numpy as np
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QMenu, QWidget

from app.hand.coordinates import DesignPoint, ScreenPoint, number
from app.hand.cursor import along_cursor
from app.hand.drag import START_DISTANCE, State
from app.hand.hand import Hand
from app.hand.handle_field import type_into
from app.hand.hit_test import Handle, Target
from app.hand.keys import keys_of
from app.hand.quartic_light import QuarticLight
from app.hand.readout import told_lines
from app.hand.snapping import Landing
from app.hand.turn import TurnAngles, TurnEnd
from app.scene.grips import Grips
from app.state.presenter import Frame, Presenter
from app.viewport import grip_menu
from app.viewport.dimension_layer import DimensionLayer
from app.viewport.half_plane import Lens
from app.viewport.handles import Grip, Scenery, SideDrag, SideGrip
from app.viewport.hud import SurfaceHud
from app.viewport.turn_drag import TurnDrag
from sgb_core.document import edits

_NONE = np.zeros((0, 3))


class Stage(Protocol):
    """The viewport as the hand sees it."""

    @property
    def frame(self) -> Frame | None:
        """The newest frame."""

    @property
    def lens(self) -> Lens | None:
        """From where and how large it is seen."""

    def show_grips(self, grips: Grips) -> None:
        """Light up what can be grabbed or is held."""


class SurfaceHand:
    """Hovers, grabs, drags and lets go of handles in the viewport; the rest is navigation's."""

    def __init__(self, presenter: Presenter, stage: Stage, hud: SurfaceHud) -> None:
        self._presenter = presenter
        self._stage = stage
        self._hud = hud
        owner = hud.parentWidget()
        assert owner is not None
        self._owner = owner
        self._dimensions = DimensionLayer(owner)
        self._hand = Hand(presenter)
        self._anchor = DesignPoint(0.0, 0.0)
        self._turn: TurnDrag | None = None
        self._side: SideDrag | None = None
        self._pointer: ScreenPoint | None = None
        self._clicked: tuple[Handle, ScreenPoint] | None = None
        self._light = QuarticLight(presenter)
        self.active: Grip | None = None
        # What the cursor should look like; None for nothing special.
        self.cursor: Qt.CursorShape | None = None

    @property
    def busy(self) -> bool:
        """Whether something is in the hand."""
        held = any(drag is not None for drag in self._drags)
        return held or self._hand.gesture.state is not State.IDLE

    @property
    def _drags(self) -> tuple[TurnDrag | SideDrag | None, ...]:
        return self._turn, self._side

    @property
    def landing(self) -> Landing | None:
        """Where the point in the hand lands, and what it snapped to."""
        return self._hand.landing

    # The mouse; each returns whether the event is used up.

    def press(self, at: ScreenPoint, modifiers: Qt.KeyboardModifier) -> bool:
        """Take hold of what is under the cursor; a press on the generatrix may be a click."""
        self._pointer, self._clicked = at, None
        scenery = self._scenery()
        if scenery is None:
            return False
        self.active = found = scenery.pick(at)
        if isinstance(found, TurnEnd):
            revolution = self._presenter.document.revolution
            before = TurnAngles(revolution.start_deg, revolution.sweep_deg)
            near = scenery.surface.start + (scenery.surface.sweep if found is TurnEnd.END else 0.0)
            grabbed = scenery.ring.angle_at(scenery.lens, at, near)
            self._turn = TurnDrag(found, at, before, grabbed, grabbed)
        elif isinstance(found, SideGrip):
            self._side = scenery.grab(found, at)
        elif found is not None and found.target is not Target.CURVE:
            self._hand.press(at, found, self._presenter.document.profile)
            self._anchor = scenery.design_place(found)
        else:
            if found is not None:
                self._clicked = (found, at)
            return False
        self.show(modifiers)
        return True

    def move(self, at: ScreenPoint, modifiers: Qt.KeyboardModifier) -> bool:
        """Drag what is in the hand, or light up what could be grabbed."""
        self._pointer = at
        gesture = self._hand.gesture
        if self._turn is not None:
            self._drag_turn(at, modifiers)
        elif self._side is not None:
            self._drag_side(self._side, at, modifiers)
        elif gesture.state is State.ARMED:
            scenery = self._scenery()
            paper = None if scenery is None else scenery.paper_at(self._anchor)
            if self._hand.pull(at, None if paper is None else paper.to_design(gesture.press)):
                self._light.forget()
                self._drag(modifiers)
        elif gesture.state is not State.IDLE:
            self._drag(modifiers)
        else:
            scenery = self._scenery()
            self.active = None if scenery is None else scenery.pick(at)
        self.show(modifiers)
        return self.busy

    def release(self, at: ScreenPoint, modifiers: Qt.KeyboardModifier) -> bool:
        """Let go; what was pressed and not moved is selected."""
        clicked, was_busy = self._clicked, self.busy
        self._clicked = None
        shift = bool(modifiers & Qt.KeyboardModifier.ShiftModifier)
        if clicked is not None and clicked[1].distance(at) < START_DISTANCE:
            self._hand.click(clicked[0], shift)
        for drag in self._drags:
            if drag is not None and drag.moved:
                self._presenter.commit()
        self._turn = self._side = None
        pressed = self._hand.gesture
        self._hand.release(shift)
        type_into(self._presenter, pressed, at, self._owner)
        self._light.forget()
        if was_busy:
            self.move(at, modifiers)
        return was_busy

    def would_type(self, key: int, text: str) -> bool:
        """Return whether a key would be typed as a number of what is in the hand."""
        turn = self._turn
        if turn is not None and turn.moved:
            return turn.numbers.wants(key, text)
        return self._hand.would_type(key, text)

    def type(self, key: int, text: str) -> None:
        """Take a key of a number: what is in the hand goes exactly there; Enter lets go."""
        turn, at = self._turn, self._pointer
        if turn is None:
            self._hand.type(key, text)
            self._typed_drag()
        elif key in (Qt.Key.Key_Return, Qt.Key.Key_Enter):
            self._presenter.commit()
            self._turn = None
        elif at is not None:
            self._turn = replace(turn, typed=turn.numbers.with_key(key, text))
            self._drag_turn(at, Qt.KeyboardModifier.NoModifier)
        self.show(Qt.KeyboardModifier.NoModifier)

    def type_next(self, forward: bool) -> bool:
        """Let the next number take the keys; return whether there is one."""
        return self._hand.type_next(forward)

    def _typed_drag(self) -> None:
        if self._hand.gesture.edits:
            self._drag(Qt.KeyboardModifier.NoModifier)

    def key(self, modifiers: Qt.KeyboardModifier, key: int = 0) -> None:
        """Take a modifier key pressed or let go in the middle of a drag, or the H for its legs."""
        if key == Qt.Key.Key_H:
            self._hand.switch_legs()
        if self._pointer is not None and self.busy and self._hand.gesture.state is not State.ARMED:
            self.move(self._pointer, modifiers)

    def cancel(self) -> bool:
        """Put back what is in the hand; returns whether there was anything."""
        if not self.busy:
            return False
        for drag in self._drags:
            if drag is not None and drag.moved:
                self._presenter.cancel()
        self._turn = self._side = None
        self._hand.cancel()
        self._light.forget()
        self.show(Qt.KeyboardModifier.NoModifier)
        return True

    def menu(self, at: ScreenPoint, parent: QWidget) -> QMenu | None:
        """Return a menu of what can be done with what is under a place; None for empty space."""
        scenery = self._scenery()
        found = None if scenery is None or self.busy else scenery.pick(at)
        return None if found is None else grip_menu.build(parent, self._presenter, found)

    def leave(self) -> None:
        """Forget the pointer, which has gone elsewhere."""
        if not self.busy:
            self._pointer = self.active = None
            self.show(Qt.KeyboardModifier.NoModifier)

    def rest(self) -> None:
        """Light up nothing while the camera is being moved, unless a hand holds it."""
        if not self.busy and self.active is not None:
            self.active = None
            self.show(Qt.KeyboardModifier.NoModifier)

    def refresh(self, frame: Frame) -> None:
        """Follow a new frame; a gesture that was ended elsewhere is dropped."""
        self._hand.follow(frame)
        if not frame.dragging and any(drag is not None and drag.moved for drag in self._drags):
            self._turn = self._side = None
        count = len(frame.document.profile)
        if isinstance(self.active, Handle) and self.active.segment >= count:
            self.active = None
        self.show(None)

    # What the mouse leads to.

    def _scenery(self) -> Scenery | None:
        frame, lens = self._stage.frame, self._stage.lens
        return None if frame is None or lens is None else Scenery(frame, lens)

    def _drag(self, modifiers: Qt.KeyboardModifier) -> None:
        scenery, gesture = self._scenery(), self._hand.gesture
        if scenery is None or gesture.profile is None or self._pointer is None:
            return
        # From where the point was: a plane seen edge-on is left only along a line through there.
        paper = scenery.paper_at(self._anchor)
        self._hand.drag(self._pointer, paper, keys_of(modifiers))

    def _drag_turn(self, at: ScreenPoint, modifiers: Qt.KeyboardModifier) -> None:
        turn, scenery = self._turn, self._scenery()
        if turn is None or scenery is None:
            return
        if not turn.moved:
            if turn.press.distance(at) < START_DISTANCE:
                return
            turn = replace(turn, moved=True)
            self._presenter.begin(turn.end.label)
        keys = keys_of(modifiers)
        angle = scenery.ring.angle_at(scenery.lens, at, turn.angle)
        self._turn = turn = replace(turn, angle=angle)
        new = turn.typed_angles() or turn.before.dragged(
            turn.end, turn.angle - turn.grabbed, snap=not keys.free, hold=keys.constrain
        )
        self._presenter.apply(
            lambda d: edits.set_revolution(d, start_deg=new.start, sweep_deg=new.sweep)
        )

    def _drag_side(self, drag: SideDrag, at: ScreenPoint, modifiers: Qt.KeyboardModifier) -> None:
        scenery = self._scenery()
        if scenery is None or not (drag.moved or drag.press.distance(at) >= START_DISTANCE):
            return
        if not drag.moved:
            self._presenter.begin(drag.label)
        self._side = drag.pulled(
            self._presenter, scenery.frame, scenery.lens, at, keys_of(modifiers)
        )

    # What is shown of it.

    def show(self, modifiers: Qt.KeyboardModifier | None) -> None:
        """Show grips, label and cursor as things are now."""
        scenery = self._scenery()
        if scenery is None:
            return
        held = self.active
        inside = self._pointer is not None
        grips = Grips(
            held=scenery.place(held if self._side is None else self._side.held),
            chosen=scenery.chosen_places(),
            ends=scenery.end_places if inside else _NONE,
            lines=scenery.grip_lines(held),
            segment=held.segment if isinstance(held, Handle) and held.on_profile else None,
        )
        self._stage.show_grips(grips)
        self.show_dimensions()
        self.cursor = self._cursor(scenery)
        told = self._lines(scenery) if inside and held is not None else []
        place = self._pointer or ScreenPoint(0.0, 0.0)
        self._hud.tell(told, place, scenery.curve if told else _NONE)
        if modifiers is not None and not self._hand.gesture.edits:
            self._light.show(held)

    def show_dimensions(self) -> None:
        """Show the dimension lines from where the object is seen now."""
        held = self.active if isinstance(self.active, Handle) else None
        self._dimensions.show_dimensions(self._stage.frame, self._stage.lens, held)

    def _lines(self, scenery: Scenery) -> list[str]:
        held, frame = self.active, scenery.frame
        if isinstance(held, TurnEnd):
            revolution = frame.document.revolution
            start, sweep = revolution.start_deg, revolution.sweep_deg
            name = held.label
            if self._turn is not None and self._turn.typed is not None:
                return [name, *self._turn.typed.lines()]
            return [
                f"{name} {number(sweep if held is TurnEnd.END else start, 1)}°",
                f"from {number(start, 1)}° to {number(start + sweep, 1)}°",
            ]
        if isinstance(held, SideGrip):
            return scenery.told(held)
        if held is None:
            return []
        hand = self._hand
        scale = scenery.paper(held).scale
        return told_lines(frame, hand.gesture, hand.landing, held, scale)

    def _cursor(self, scenery: Scenery) -> Qt.CursorShape | None:
        held = self.active
        if held is None:
            return None
        if isinstance(held, TurnEnd | SideGrip):
            return Qt.CursorShape.ClosedHandCursor if self.busy else Qt.CursorShape.OpenHandCursor
        if held.target is Target.CURVE:
            return Qt.CursorShape.PointingHandCursor
        if held.target in (Target.POINT, Target.DIMENSION):
            return Qt.CursorShape.SizeAllCursor
        if held.target is Target.LEVEL:
            return Qt.CursorShape.SizeVerCursor
        if held.feature is not None:
            return along_cursor(held.feature.angle)
        points = scenery.frame.document.profile.segments[held.segment].points
        near, far = scenery.paper().map(points[held.index : held.index + 2])
        return along_cursor(degrees(math.atan2(near[1] - far[1], far[0] - near[0])))
