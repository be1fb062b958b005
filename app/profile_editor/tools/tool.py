"""What a tool of the profile editor is, and what it may ask of the editor."""

from __future__ import annotations

from collections.abc import Callable
from typing import Protocol

from PySide6.QtCore import Qt

from app.hand.canvas import Canvas
from app.hand.coordinates import Area, ScreenPoint, Transform
from app.hand.snapping import DragKeys
from app.state.presenter import Frame, Presenter
from sgb_core.values import dataclass


class Sheet(Protocol):
    """The editor as its tools know it."""

    @property
    def transform(self) -> Transform:
        """Where design coordinates lie on the screen."""

    @property
    def area(self) -> Area:
        """The part of the editor inside the rulers."""

    @property
    def frame(self) -> Frame:
        """What is shown."""

    def update(self) -> None:
        """Paint anew, soon."""

    def make_room(self, at: ScreenPoint) -> None:
        """Zoom out where a place is at the edge, or beyond it."""

    def bring_in(self, at: ScreenPoint) -> None:
        """Move the picture, as large as it is, where a place is at the edge, or beyond it."""


class Tool:
    """One tool in the hand: it gets the left button and the keys it wants; this one does nothing.

    Panning, zooming and the context menu stay the editor's. Places are in pixels. ``keys`` are
    the modifiers by what they mean during a drag.
    """

    cursor = Qt.CursorShape.CrossCursor
    # Whether what the document holds now is only drawn faintly, about to be replaced.
    fades = False

    def __init__(self, presenter: Presenter, sheet: Sheet) -> None:
        self._presenter = presenter
        self._sheet = sheet

    @property
    def busy(self) -> bool:
        """Whether something is under way that Escape would end."""
        return False

    @property
    def held(self) -> bool:
        """Whether the button, or the key that stands for it, is down."""
        return False

    def press(self, at: ScreenPoint, keys: DragKeys) -> None:
        """Take a press of the left button; a second one of a double click is a press, too."""

    def move(self, at: ScreenPoint | None, keys: DragKeys) -> None:
        """Follow the pointer, pressed or not; None where it has gone elsewhere."""

    def modified(self, keys: DragKeys) -> None:
        """Take modifier keys pressed or let go while the pointer rests."""

    def release(self, at: ScreenPoint, keys: DragKeys) -> None:
        """Let go."""

    def wants(self, key: int, modifiers: Qt.KeyboardModifier) -> bool:
        """Whether a key is this tool's own just now, whatever the menus bind to it."""
        return False

    def key(self, key: int, modifiers: Qt.KeyboardModifier) -> bool:
        """Take a key pressed; returns whether it was of use."""
        return False

    def key_released(self, key: int, modifiers: Qt.KeyboardModifier) -> bool:
        """Take a key let go; returns whether it was of use."""
        return False

    def escape(self) -> None:
        """End what is under way."""

    def follow(self, frame: Frame) -> None:
        """Take note of a new frame, which may be of another document."""

    def put_away(self) -> None:
        """End everything: another tool is taken."""

    def draw(self, canvas: Canvas) -> None:
        """Draw over the profile."""

    def told(self) -> tuple[ScreenPoint, list[str]] | None:
        """Return where the heads-up label stands and its lines; None for no label."""
        return None


@dataclass(frozen=True, slots=True)
class ToolKind:
    """A tool as menus, buttons and keys know it: ``key`` takes it while the editor has the focus.

    ``make`` is None for selecting and dragging, which the editor itself does.
    """

    name: str
    words: str
    key: Qt.Key
    icon: str
    tip: str
    make: Callable[[Presenter, Sheet], Tool] | None = None
