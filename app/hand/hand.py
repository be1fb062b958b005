"""The hand of the profile editor: turns gestures into edits of the document."""

from __future__ import annotations

from dataclasses import replace
from decimal import Decimal
from typing import TYPE_CHECKING

from PySide6.QtCore import Qt

from app.hand.coordinates import DesignPoint, Paper, ScreenPoint
from app.hand.dimension_drag import measure
from app.hand.drag import IDLE, START_DISTANCE, Gesture, State, slide_fraction
from app.hand.guides import guide_lines
from app.hand.hit_test import Handle, PointId, Target, canonical, twin
from app.hand.moving import live_fair, move_edit, move_label
from app.hand.preferences import snap_steps
from app.hand.scale_frame import SIDES, PointFrame
from app.hand.snapping import (
    ALIGN_REACH,
    AXIS_REACH,
    MAGNET_REACH,
    DragKeys,
    Landing,
    Snapping,
    land,
    leg_directions,
    other_points,
)
from app.hand.typed import Typed
from app.hand.typed_drag import typed_edit, typed_factors, typed_place, typing
from app.state import preferences
from app.state.presenter import Frame, Presenter
from app.state.view_state import Hover
from app.state.window_reader import WINDOW
from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import LAMBDAS, SYMBOLS
from sgb_core.document import edits

if TYPE_CHECKING:
    from sgb_core.document.session import Refining


class Hand:
    """One gesture at a time, from press to release; the document changes only through it."""

    def __init__(self, presenter: Presenter) -> None:
        self._presenter = presenter
        self._gesture: Gesture = IDLE
        self._landing: Landing | None = None
        self._nudged = (Decimal(0), Decimal(0))
        self._refining: Refining | None = None

    @property
    def gesture(self) -> Gesture:
        """What the hand is doing, and how all was when it began."""
        return self._gesture

    @property
    def landing(self) -> Landing | None:
        """Where the point in the hand lands, and what it snapped to."""
        return self._landing

    def press(self, at: ScreenPoint, handle: Handle | None, profile: Profile) -> None:
        """Press on a handle of a profile, or on empty paper: a click until the hand moves."""
        self.end()
        self._gesture = Gesture(State.ARMED, at, handle, profile)

    def pan(self, at: ScreenPoint) -> None:
        """Take hold of the paper itself."""
        self.end()
        self._gesture = Gesture(State.PANNING, at)

    def pull(self, at: ScreenPoint, grabbed: DesignPoint | None = None) -> bool:
        """Begin to drag what was pressed once the hand is far enough from there.

        ``grabbed`` is where a frame around points was pressed. Returns whether a drag begins.
        """
        armed = self._gesture
        if armed.state is not State.ARMED or armed.press.distance(at) < START_DISTANCE:
            return False
        self._start(armed, grabbed)
        return True

    def switch_legs(self) -> bool:
        """Let a dragged joint scale its legs instead of carrying them, or the other way round.

        To be followed by another :meth:`drag`. Returns whether a joint or an end is in the hand.
        """
        gesture = self._gesture
        joint = gesture.state is State.MOVING and len(gesture.points) == 1
        if not joint or gesture.handle is None or gesture.handle.index not in (0, 3):
            return False
        self._gesture = replace(gesture, scales=not gesture.scales)
        return True

    def would_type(self, key: int, text: str) -> bool:
        """Return whether a key would be typed as a number of what is in the hand."""
        typed = self._typing()
        return typed is not None and typed.wants(key, text)

    def type(self, key: int, text: str) -> None:
        """Take a key of a number, to be followed by another :meth:`drag`; Enter ends the drag."""
        if key in (Qt.Key.Key_Return, Qt.Key.Key_Enter):
            self.end()
            return
        typed = self._typing()
        if typed is not None:
            typed = typed.with_key(key, text)
            self._gesture = replace(self._gesture, typed=typed if any(typed.texts) else None)

    def type_next(self, forward: bool) -> bool:
        """Let the next number take the keys; return whether there is a drag with numbers."""
        typed = self._typing()
        if typed is not None:
            self._gesture = replace(self._gesture, typed=typed.next(forward))
        return typed is not None

    def _typing(self) -> Typed | None:
        return typing(self._gesture, self._presenter.session.gesture_start)

    def release(self, shift: bool) -> None:
        """Let go: what was pressed and not moved is selected, what was dragged is kept."""
        if self._gesture.state is State.ARMED:
            self.click(self._gesture.handle, shift)
        self.end()

    def follow(self, frame: Frame) -> None:
        """Drop a gesture that undo, or another view, has ended under the hand."""
        if not frame.dragging and self._gesture.edits:
            self.drop()

    def click(self, handle: Handle | None, shift: bool) -> None:
        """Select what was pressed and let go without moving; Shift adds and takes away."""
        presenter = self._presenter
        chosen = presenter.view.points
        if handle is None:
            if not shift:
                presenter.set_view(points=frozenset())
        elif handle.target is Target.BODY:
            self.click(None, shift)
        elif handle.target in (Target.LEVEL, Target.DIMENSION, Target.GRIP, Target.FEATURE):
            pass
        elif handle.target is not Target.POINT:
            presenter.select(handle.segment)
        else:
            point = (handle.segment, handle.index)
            names = {point, twin(presenter.document.profile, point)}
            if not shift:
                if not (names & chosen and len(chosen) == 1):
                    presenter.select(*point)
            elif names & chosen:
                presenter.set_view(points=chosen - names)
            else:
                presenter.set_view(points=chosen | {point}, segment=handle.segment)

    def _start(self, armed: Gesture, grabbed: DesignPoint | None) -> None:
        """Begin dragging what was pressed: points, a quartic point, or a box on empty paper."""
        handle, profile = armed.handle, armed.profile
        if handle is None or profile is None or handle.target is Target.CURVE:
            self._gesture = Gesture(State.BOXING, armed.press)
        elif handle.target in (Target.GRIP, Target.BODY):
            self._start_frame(armed, profile, grabbed or DesignPoint(0.0, 0.0))
        elif handle.target is Target.DIMENSION:
            self._gesture = Gesture(State.MEASURING, armed.press, handle, profile)
            self._presenter.begin(self._presenter.document.dimensions[handle.index].label)
        elif handle.target is Target.LEVEL:
            self._gesture = Gesture(State.FILLING, armed.press, handle, profile)
            self._presenter.begin("Fill line")
        elif handle.feature is not None:
            r, h = handle.feature.at
            offset = (grabbed.r - r, grabbed.h - h) if grabbed is not None else (0.0, 0.0)
            self._gesture = Gesture(State.SHAPING, armed.press, handle, profile, (), offset)
            self._presenter.begin(handle.feature.label)
        elif handle.target is Target.QUARTIC:
            self._gesture = Gesture(State.SLIDING, armed.press, handle, profile)
            name = LAMBDAS[handle.index]
            self._presenter.select(handle.segment)
            self._presenter.begin(f"Drag {SYMBOLS[name]} of {WINDOW.segment(handle.segment)}")
            self._presenter.set_view(hover=Hover(name, handle.segment))
        else:
            point = (handle.segment, handle.index)
            chosen = self._presenter.view.points
            if not chosen & {point, twin(profile, point)}:
                self._presenter.select(*point)
                chosen = frozenset({point})
            self._presenter.set_view(segment=handle.segment)
            points = tuple(canonical(profile, chosen))
            scales = preferences.current().scale_legs
            self._gesture = Gesture(
                State.MOVING, armed.press, handle, profile, points, scales=scales
            )
            self._begin_move(move_label(profile, points))

    def _start_frame(self, armed: Gesture, profile: Profile, grabbed: DesignPoint) -> None:
        """Begin to scale the selected points by a grip, or to move them by their frame's body."""
        frame, handle = PointFrame.of(profile, self._presenter.view.points), armed.handle
        if frame is None or handle is None:
            self._gesture = Gesture(State.BOXING, armed.press)
            return
        if handle.target is Target.GRIP:
            state, held = State.SCALING, frame.place(handle.index)
            label = f"Scale {len(frame.points)} points"
        else:
            point = frame.nearest(profile, grabbed)
            state, handle = State.MOVING, Handle(Target.POINT, *point)
            held = DesignPoint.of(profile.segments[point[0]].points[point[1]])
            label = move_label(profile, frame.points)
        offset = (grabbed.r - held.r, grabbed.h - held.h)
        self._gesture = Gesture(state, armed.press, handle, profile, frame.points, offset)
        self._begin_move(label)

    def _begin_move(self, label: str) -> None:
        gesture = self._gesture
        self._presenter.begin(label)
        self._refining = None
        if gesture.profile is not None and gesture.state is not State.SCALING:
            self._refining = live_fair(self._presenter.view, gesture.profile, gesture.points)

    def drag(self, cursor: ScreenPoint, paper: Paper, keys: DragKeys) -> None:
        """Move what is in the hand to the cursor."""
        gesture = self._gesture
        if gesture.handle is None or gesture.profile is None:
            return
        segment, index = gesture.handle.segment, gesture.handle.index
        under = paper.to_design(cursor)
        place = DesignPoint(under.r - gesture.offset[0], under.h - gesture.offset[1])
        typed = typed_edit(gesture, self._presenter.session.gesture_start)
        if typed is not None:
            self._presenter.apply(typed)
        elif gesture.state is State.FILLING:
            snaps = self._presenter.view.snap and not keys.free
            height = snap_steps(paper.scale).snapped(place.h) if snaps else place.h
            self._presenter.apply(lambda d: edits.move_fill(d, height))
        elif gesture.state is State.MEASURING:
            fine = keys.free or not self._presenter.view.snap
            grabbed, steps = paper.to_design(gesture.press), snap_steps(paper.scale)
            way = (under.r - grabbed.r, under.h - grabbed.h)
            measure(self._presenter, index, way, paper, None if fine else steps)
        elif gesture.state is State.SHAPING and gesture.handle.feature is not None:
            feature = gesture.handle.feature
            self._presenter.apply(lambda d: feature.dragged(d, place.pair))
        elif gesture.state is State.SLIDING:
            fraction = slide_fraction(gesture.profile.segments[segment], index, place)
            self._presenter.apply(lambda d: edits.set_leg_fraction(d, segment, index, fraction))
        elif gesture.state is State.MOVING:
            start = DesignPoint.of(gesture.profile.segments[segment].points[index])
            snapping = self._snapping(gesture.profile, gesture.points, paper)
            legs = leg_directions(gesture.profile, (segment, index))
            other = twin(gesture.profile, (segment, index))
            if other is not None:
                legs += leg_directions(gesture.profile, other)
            self._landing = land(start, place, keys, snapping, legs)
            if gesture.typed is not None:
                self._landing = Landing(typed_place(gesture, start, self._landing.point))
            self._move(gesture, start, self._landing.point, keep_rules=not keys.break_rule)
        elif gesture.state is State.SCALING:
            snapping = self._snapping(gesture.profile, gesture.points, paper)
            self._scale(gesture.profile, index, place, keys, snapping)

    def _snapping(self, profile: Profile, points: tuple[PointId, ...], paper: Paper) -> Snapping:
        grid = snap_steps(paper.scale) if self._presenter.view.snap else None
        reach = ALIGN_REACH if grid is None else MAGNET_REACH
        others = other_points(profile, points)
        guides = guide_lines(self._presenter.document.guides)
        return Snapping(
            grid,
            AXIS_REACH / paper.scale,
            others,
            reach / paper.scale,
            guides,
            MAGNET_REACH / paper.scale,
        )

    def _scale(
        self, profile: Profile, side: int, place: DesignPoint, keys: DragKeys, snapping: Snapping
    ) -> None:
        """Scale the frame's points so that a grip comes to ``place``.

        As in drawing programs Shift keeps the proportions and Alt scales about the centre.
        """
        frame = PointFrame.of(profile, self._gesture.points)
        if frame is None:
            return
        free = DragKeys(free=keys.free or keys.constrain)
        landing = land(frame.place(side), place, free, snapping)
        factors = frame.factors(
            side, landing.point, proportional=keys.constrain, centred=keys.break_rule
        )
        factors = typed_factors(self._gesture, factors)
        about = frame.fixed(side, centred=keys.break_rule).pair
        # A grip lines up only in the directions in which it moves.
        (beside, level), (wide, tall) = landing.aligned, SIDES[side]
        across = (beside if wide else None, level if tall else None)
        self._landing = replace(landing, aligned=across, on_axis=False, factors=factors)
        self._presenter.apply(lambda d: edits.scale_points(d, frame.points, factors, about))

    def nudge(
        self, points: tuple[PointId, ...], profile: Profile, way: tuple[Decimal, Decimal]
    ) -> None:
        """Move points by ``way``, adding to what the keys held down have moved already.

        Decimal arithmetic keeps 12.3 + 0.1 at 12.4, as the person who pressed the key expects.
        """
        if self._gesture.state is not State.NUDGING:
            self.end()
            self._gesture = Gesture(State.NUDGING, profile=profile, points=points)
            self._nudged = (Decimal(0), Decimal(0))
            self._begin_move(move_label(profile, points).replace("Move", "Nudge", 1))
        self._nudged = (self._nudged[0] + way[0], self._nudged[1] + way[1])
        segment, index = self._gesture.points[0]
        begun = self._gesture.profile or profile
        start = DesignPoint.of(begun.segments[segment].points[index])
        end = DesignPoint(
            float(Decimal(repr(start.r)) + self._nudged[0]),
            float(Decimal(repr(start.h)) + self._nudged[1]),
        )
        self._move(self._gesture, start, end, keep_rules=True)

    def _move(
        self, gesture: Gesture, start: DesignPoint, end: DesignPoint, *, keep_rules: bool
    ) -> None:
        edit = move_edit(gesture, start, end, keep_rules=keep_rules)
        self._presenter.apply(edit, refining=self._refining)

    def end(self) -> None:
        """End the gesture and keep what it did."""
        if self._gesture.edits:
            self._presenter.commit()
        self.drop()

    def cancel(self) -> None:
        """End the gesture and restore the document from before it."""
        if self._gesture.edits:
            self._presenter.cancel()
        self.drop()

    def drop(self) -> None:
        """Forget the gesture without touching the document: it has been ended elsewhere."""
        if self._gesture.state is State.SLIDING:
            self._presenter.set_view(hover=None)
        self._gesture = IDLE
        self._landing = None
