"""The strokes of the pen: what a press, a drag and a release do to the run and the document."""

from __future__ import annotations

from dataclasses import replace

from app.commands.segment import split
from app.hand.coordinates import DesignPoint, GridSteps, ScreenPoint
from app.hand.drag import START_DISTANCE
from app.hand.pen_aim import Act, Aim, Run, aim, pulled
from app.hand.pen_stop import leg_stopped, side_of
from app.hand.preferences import snap_steps
from app.hand.snapping import DragKeys, Landing
from app.profile_editor.tools.tool import Sheet, Tool
from app.state.blank import is_blank
from app.state.presenter import Edit, Frame, Presenter
from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import Segment
from sgb_core.design.pen import Anchor, PenPath, closing_handle, rule_at
from sgb_core.document import edits
from sgb_core.document.model import Document

NO_KEYS = DragKeys()


class PenStrokes(Tool):
    """One run of the pen, stroke by stroke; mouse and keyboard both lead it."""

    def __init__(self, presenter: Presenter, sheet: Sheet) -> None:
        super().__init__(presenter, sheet)
        self._run: Run | None = None
        self._aim: Aim | None = None
        # What was where the pen stood after each stroke, for undo and redo.
        self._known: list[tuple[Profile, Run | None]] = []
        # While the button is down: what it was pressed for, and the run without this stroke.
        self._pressed: Aim | None = None
        self._before: Run | None = None
        self._press = ScreenPoint(0.0, 0.0)
        self._placed: PenPath | None = None
        self._drawn_out: PenPath | None = None
        self._pull: Landing | None = None
        self._pointer: ScreenPoint | None = None
        self._keys = NO_KEYS
        # The cursor of the keyboard; None while the mouse leads.
        self._cursor: DesignPoint | None = None
        self._carries = False
        # A press has just been in vain; said until the pointer moves.
        self._refused = False

    # What the editor asks.

    @property
    def busy(self) -> bool:
        """Whether a run is under way."""
        return self._run is not None or self.held

    @property
    def held(self) -> bool:
        """Whether a stroke is in the hand."""
        return self._pressed is not None

    @property
    def fades(self) -> bool:  # type: ignore[override]
        """Whether the blank profile is about to be replaced."""
        shown = self._pressed is not None and self._edits(self._pressed)
        return self._run is not None and self._run.bare and not shown

    @property
    def run(self) -> Run | None:
        """What the pen is in the middle of."""
        return self._run

    def follow(self, frame: Frame) -> None:
        """Take up what an undo, a redo or another edit has left."""
        if self._pressed is not None and self._edits(self._pressed) and not frame.dragging:
            self._forget_stroke()
        if self._pressed is None:
            self._take_up()

    def put_away(self) -> None:
        """End the stroke in the hand and the run."""
        if self.held:
            self.release(self._press, self._keys)
        self._end_run()
        self._cursor = None

    def release(self, at: ScreenPoint, keys: DragKeys) -> None:
        """Keep the stroke."""
        pressed = self._pressed
        if pressed is None:
            return
        if self._edits(pressed):
            self._presenter.commit()
            last = len(self._presenter.document.profile) - 1
            at_start = self._run is not None and self._run.at_start
            self._presenter.select(0 if at_start else last)
        self._forget_stroke(keep=True)
        if pressed.act in (Act.CLOSE, Act.POLE):
            self._run = None
        self._remember()
        if self._run is not None:
            self._sheet.make_room(self._screen(self._run.path.last.place))
        self._aim_again()

    def escape(self) -> None:
        """Drop the stroke in the hand, else end the run; what is drawn stays."""
        pressed = self._pressed
        if pressed is None:
            self._end_run()
            return
        if self._edits(pressed):
            self._presenter.cancel()
        self._forget_stroke()
        self._aim_again()

    def take_back(self) -> None:
        """Take the last stroke back, as undo does; an anchor alone just goes."""
        run = self._run
        if run is None or self.held:
            return
        session = self._presenter.session
        strokes = [known for known in self._known if known[1] is not None]
        if run.bare or len(strokes) < 2 or session.undo_label is None:
            self._end_run()
        else:
            self._presenter.undo()
            self._take_up()
        self._aim_again()

    # What a stroke does.

    def _press_at(self, at: ScreenPoint, keys: DragKeys) -> None:
        self._take_up()
        self._press = at
        if self._cursor is None:
            self._pointer = at
        found = self._aimed(at, keys)
        self._aim = found
        self._refused = found.act is Act.NOTHING
        if self._refused:
            return
        if found.act is Act.INSERT and found.curve is not None:
            split(self._presenter, found.curve.segment, found.curve.s)
            self._remember()
            return
        self._before, self._pressed = self._run, found
        place = found.landing.point.pair
        if found.act is Act.GO_ON:
            self._run = self._from_end(found.at_start)
        elif found.act is Act.START:
            self._run = Run(PenPath().placed(place, sharp=keys.break_rule))
        elif self._run is not None and found.act is Act.CLOSE:
            target = self._run.target(self._presenter.document.profile)
            if target is not None:
                self._run = replace(self._run, path=self._run.path.onto(target))
        elif self._run is not None and found.act is not Act.BREAK:
            path = self._run.path.placed(place, sharp=keys.break_rule)
            self._run = replace(self._run, path=path)
        if self._run is not None:
            self._placed = self._drawn_out = self._run.path
            if found.act is Act.BREAK or (found.act is Act.GO_ON and keys.break_rule):
                self._show(self._placed.with_last(self._placed.last.broken()))
            elif self._edits(found):
                self._presenter.begin(self._label(found))
                self._show(self._placed)

    def _drag(self, at: ScreenPoint, keys: DragKeys) -> None:
        pressed, placed = self._pressed, self._placed
        if pressed is None or placed is None or self._run is None:
            return
        if self._carries and pressed.act in (Act.START, Act.PLACE):
            there = self._sheet.transform.to_design(at).pair
            self._placed = placed.with_last(placed.last.moved(there))
            self._drawn_out = self._run.path.with_last(self._run.path.last.moved(there))
            self._press = at
            self._show(self._drawn_out)
            return
        if self._press.distance(at) < START_DISTANCE and self._pull is None:
            return
        cursor = self._sheet.transform.to_design(at)
        scale, last = self._sheet.transform.scale, placed.last
        self._pull = self._stopped(pulled(last, cursor, keys, scale, self._grid()), keys)
        to = self._pull.point.pair
        if pressed.act is Act.CLOSE:
            self._show(placed.with_last(replace(last, incoming=closing_handle(last, to))))
        elif pressed.act in (Act.BREAK, Act.GO_ON):
            self._show(placed.with_last(replace(last, outgoing=to)))
        elif keys.break_rule and self._drawn_out is not None:
            self._show(self._drawn_out.pulled(to, alone=True))
        else:
            self._drawn_out = placed.pulled(to)
            self._show(self._drawn_out)

    def _stopped(self, pull: Landing, keys: DragKeys) -> Landing:
        """Return the handle in the hand as short as the axis makes it."""
        pressed, placed = self._pressed, self._placed
        assert pressed is not None
        assert placed is not None
        bare = self._run is None or self._run.bare
        tip = leg_stopped(
            placed.last,
            pull.point,
            side_of(None if bare else self._presenter.document.profile, placed),
            leaves=pressed.act not in (Act.POLE, Act.CLOSE),
            arrives=pressed.act in (Act.PLACE, Act.POLE, Act.CLOSE) and not keys.break_rule,
        )
        return replace(pull, point=tip)

    def _show(self, path: PenPath) -> None:
        """Let the run be along a path, and the document hold its last segment."""
        if self._run is None or self._pressed is None:
            return
        self._run = replace(self._run, path=path)
        if self._edits(self._pressed):
            self._presenter.apply(self._edit(path, self._pressed))

    def _edit(self, path: PenPath, pressed: Aim) -> Edit:
        segment: Segment = path.segment
        if self._before is not None and self._before.bare:
            return lambda document: edits.draw_first(document, segment)
        assert self._run is not None
        at_start, rule = self._run.at_start, path.rule
        closing = rule_at(path.last) if pressed.act is Act.CLOSE else None

        def draw(document: Document) -> Document:
            return edits.draw_on(document, segment, rule, at_start=at_start, closing=closing)

        return draw

    def _edits(self, pressed: Aim) -> bool:
        return pressed.act in (Act.PLACE, Act.POLE, Act.CLOSE)

    def _label(self, pressed: Aim) -> str:
        if pressed.act is Act.CLOSE:
            return "Close the ring"
        if self._before is None or self._before.bare:
            return "Draw segment 1"
        count = len(self._presenter.document.profile)
        return f"Draw segment {1 if self._before.at_start else count + 1}"

    def _from_end(self, at_start: bool) -> Run:
        profile = self._presenter.document.profile
        segment = profile.segments[0 if at_start else -1]
        anchor = Anchor.going_on(segment, from_start=at_start)
        return Run(PenPath((anchor,)), at_start, bare=False)

    # The run and what is known of it.

    def _forget_stroke(self, *, keep: bool = False) -> None:
        """Let go; the run stays as it is with ``keep``, else as it was before the stroke."""
        if not keep:
            self._run = self._before
        elif self._run is not None and self._pressed is not None and self._edits(self._pressed):
            self._run = replace(self._run, bare=False)
        self._pressed = self._before = self._placed = self._drawn_out = self._pull = None
        self._carries = False

    def _remember(self) -> None:
        profile = self._presenter.document.profile
        self._known = [known for known in self._known if known[0] is not profile]
        self._known.append((profile, self._run))

    def _take_up(self) -> None:
        """Let the run be what it was with the present profile; there is none with unknown ones."""
        profile = self._presenter.document.profile
        for known, run in self._known:
            if known is profile:
                self._run = run
                return
        if self._run is not None or self._known:
            self._run, self._known = None, []

    def _end_run(self) -> None:
        if self.held:
            return
        self._run, self._known, self._cursor = None, [], None
        self._aim_again()

    def _aim_again(self) -> None:
        at = self._at
        if at is not None and not self.held:
            self._aim = self._aimed(at, self._keys)

    @property
    def _at(self) -> ScreenPoint | None:
        """Where the pen is: under the pointer, or at the keyboard's cursor."""
        return self._pointer if self._cursor is None else self._screen(self._cursor.pair)

    def _aimed(self, at: ScreenPoint, keys: DragKeys) -> Aim:
        document = self._presenter.document
        blank = self._run is None and is_blank(document)
        transform = self._sheet.transform
        return aim(
            document.profile,
            self._run,
            transform,
            at,
            keys,
            grid=self._grid(),
            blank=blank,
            guides=document.guides,
        )

    def _grid(self) -> GridSteps | None:
        return snap_steps(self._sheet.transform.scale) if self._presenter.view.snap else None

    def _screen(self, place: tuple[float, float]) -> ScreenPoint:
        return self._sheet.transform.to_screen(DesignPoint(*place))
