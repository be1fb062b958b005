"""The profile editor with a tool in its hand: taking, showing and feeding it."""

from __future__ import annotations

from PySide6.QtCore import QRectF, Qt, QTimer
from PySide6.QtGui import QAction, QKeyEvent, QPaintEvent
from PySide6.QtWidgets import QWidget

from app.hand.coordinates import ScreenPoint
from app.hand.drag import State
from app.hand.keys import keys_of, modifier_of
from app.profile_editor.sheet import ProfileSheet
from app.profile_editor.tools.buttons import ToolButtons
from app.profile_editor.tools.table import BY_NAME, SELECT
from app.profile_editor.tools.tool import Tool
from app.profile_editor.turn_dial import TurnDial
from app.state.presenter import Frame, Presenter
from sgb_core.curves.profile import Profile

# A place to draw at is kept so far from the edge, in pixels; how often the picture shrinks for it.
_ROOM = 30.0
_ROOM_STEPS = 60


class ToolSheet(ProfileSheet):
    """The paper, and one tool of the table; without one the hand selects and drags."""

    def __init__(self, presenter: Presenter, parent: QWidget | None = None) -> None:
        super().__init__(presenter, parent)
        self._tool_name = SELECT
        self._buttons = ToolButtons(self.take, self)
        self._buttons.show_taken(SELECT)
        self._dial = TurnDial(presenter, self)

    def refresh(self, frame: Frame) -> None:
        """Show a frame, and the tool that it names."""
        before = self._frame
        super().refresh(frame)
        self._dial.refresh(frame)
        if frame.generation == before.generation and not frame.dragging:
            self._show_added(before.document.profile)
        self._take_up(frame.view.tool)
        if self._tool is not None:
            self._tool.follow(frame)
            self.update()

    def _show_added(self, before: Profile) -> None:
        """Make room for an end that has been added to the profile."""
        profile = self._profile
        if len(profile) > len(before) and self._tool is None and not self._fit_wanted:
            for end in (profile.segments[0].points[0], profile.segments[-1].points[3]):
                self.make_room(ScreenPoint(*self._transform.map(end).tolist()))

    def paintEvent(self, event: QPaintEvent) -> None:
        super().paintEvent(event)
        if (self._buttons.x(), self._dial.x()) != self._places():
            # A part that is moved amid painting stays half painted.
            QTimer.singleShot(0, self, self._place_parts)

    def _place_parts(self) -> None:
        left, right = self._places()
        self._buttons.move(left, 6)
        self._dial.move(right, 6)

    def _places(self) -> tuple[int, int]:
        """Return where the tools and the dial lie: clear of the ruler, which follows its words."""
        return round(self.area.left) + 6, self.width() - self._dial.width() - 6

    def _over(self) -> tuple[QRectF, ...]:
        tools, dial = self._buttons.size(), self._dial.size()
        left, right = self._places()
        return (
            QRectF(left, 6.0, tools.width(), tools.height()),
            QRectF(right, 6.0, dial.width(), dial.height()),
        )

    def add_switch(self, action: QAction) -> None:
        """Let a button below the tools switch what an action switches."""
        self._buttons.add_switch(action)

    def take(self, name: str) -> None:
        """Take a tool of the table into the hand, and the focus with it."""
        self._presenter.set_view(tool=name)
        self._take_up(name)
        self.setFocus(Qt.FocusReason.OtherFocusReason)

    def _take_up(self, name: str) -> None:
        if name == self._tool_name:
            return
        self._hand.end()
        if self._tool is not None:
            self._tool.put_away()
        make = BY_NAME[name].make
        self._tool_name = name
        self._tool = None if make is None else make(self._presenter, self)
        self._active = None
        self._buttons.show_taken(name)
        self._show_cursor()
        self.update()

    @property
    def tool(self) -> Tool | None:
        """The tool in the hand; None for selecting and dragging."""
        return self._tool

    def make_room(self, at: ScreenPoint) -> None:
        """Zoom out where a place is at the edge, or beyond it, until it is well inside."""
        for _ in range(_ROOM_STEPS):
            area = self.area
            if area.grown(-_ROOM).contains(at):
                return
            # What is opposite stays, so that the picture grows on the side where it is wanted.
            x = area.left + area.right - min(max(at.x, area.left), area.right)
            y = area.top + area.bottom - min(max(at.y, area.top), area.bottom)
            place = self._transform.to_design(at)
            self.zoom(0.8, ScreenPoint(x, y))
            at = self._transform.to_screen(place)

    def bring_in(self, at: ScreenPoint) -> None:
        """Move the picture until a place at the edge, or beyond it, is well inside."""
        area = self.area.grown(-_ROOM)
        x, y = min(max(at.x, area.left), area.right), min(max(at.y, area.top), area.bottom)
        if (x, y) != (at.x, at.y):
            self._transform = self._transform.panned(x - at.x, y - at.y)
            self._follows_size = False
            self.update()

    @property
    def _drawing(self) -> bool:
        return self._tool is not None and self._tool.busy

    def _tool_key(self, event: QKeyEvent) -> bool:
        """Give the tool in the hand a key that it wants, or a modifier that changes its aim."""
        if self._tool is None or self._hand.gesture.state is not State.IDLE:
            return False
        if modifier_of(event.key()) != Qt.KeyboardModifier.NoModifier:
            self._tool.modified(keys_of(event.modifiers() | modifier_of(event.key())))
        wanted = self._tool.wants(event.key(), event.modifiers())
        return wanted and self._tool.key(event.key(), event.modifiers())

    def _tool_again(self, modifiers: Qt.KeyboardModifier) -> None:
        if self._tool is not None and self._pointer is not None:
            self._tool.move(self._pointer, keys_of(modifiers))
