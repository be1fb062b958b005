"""The profile editor with guides pulled from its rulers, moved, and dragged back to be removed."""

from __future__ import annotations

from dataclasses import replace

from PySide6.QtCore import QEvent, Qt
from PySide6.QtGui import QContextMenuEvent, QKeyEvent, QMouseEvent
from PySide6.QtWidgets import QMenu

from app.hand.coordinates import ScreenPoint
from app.hand.drag import START_DISTANCE, State
from app.hand.guides import pick_guide, ruler_at
from app.hand.preferences import snap_steps
from app.hand.snapping import MAGNET_REACH
from app.profile_editor.typed_sheet import TypedSheet
from sgb_core.document import edits
from sgb_core.document.guides import Guide, GuideAt
from sgb_core.values import dataclass

_LABELS = {True: "Add a guide", False: "Move a guide"}


@dataclass(frozen=True, slots=True)
class GuideDrag:
    """A guide in the hand: where it was pressed, and its number, None for one from a ruler."""

    press: ScreenPoint
    at: GuideAt
    number: int | None
    moving: bool = False


class GuideSheet(TypedSheet):
    """A press on a ruler, or on a guide where nothing else lies, takes a guide into the hand."""

    _guide: GuideDrag | None = None

    def event(self, event: QEvent) -> bool:
        if isinstance(event, QKeyEvent) and self._guide is not None and self._escapes(event):
            return True
        if isinstance(event, QContextMenuEvent) and self._asks(event):
            return True
        if isinstance(event, QMouseEvent) and self._guided(event):
            event.accept()
            return True
        return super().event(event)

    def _escapes(self, event: QKeyEvent) -> bool:
        """Take Escape while a guide is in the hand; a shortcut of that key has to wait."""
        if event.key() != Qt.Key.Key_Escape:
            return False
        event.accept()
        if event.type() == QEvent.Type.KeyPress:
            drag, self._guide = self._guide, None
            if drag is not None and drag.moving:
                self._presenter.cancel()
            self._show_cursor()
        return True

    def _guided(self, event: QMouseEvent) -> bool:
        """Take a mouse event that is a guide's."""
        at = ScreenPoint(event.position().x(), event.position().y())
        if event.type() in (QEvent.Type.MouseButtonPress, QEvent.Type.MouseButtonDblClick):
            if event.button() != Qt.MouseButton.LeftButton or self._guide is not None:
                return self._guide is not None
            self._guide = self._grabbed(at)
            self._show_cursor()
            return self._guide is not None
        if self._guide is None:
            return False
        if event.type() == QEvent.Type.MouseMove:
            self._drag_guide(at, free=bool(event.modifiers() & Qt.KeyboardModifier.ControlModifier))
            self._pointer = at
            self.update()
        elif event.type() == QEvent.Type.MouseButtonRelease:
            if self._guide.moving:
                self._presenter.commit()
            self._guide = None
            self._show_cursor()
        return True

    def _grabbed(self, at: ScreenPoint) -> GuideDrag | None:
        if self._hand.gesture.state is not State.IDLE or self._pan_ready:
            return None
        pulled = ruler_at(self.area, at)
        if pulled is not None:
            return GuideDrag(at, pulled, None)
        number = self._guide_under(at)
        if number is None:
            return None
        return GuideDrag(at, self._frame.document.guides[number].at, number)

    def _guide_under(self, at: ScreenPoint) -> int | None:
        """Return the guide at a place where nothing of the profile can be grabbed."""
        if self._tool is not None or not self.area.contains(at) or self._pick(at) is not None:
            return None
        return pick_guide(self._frame.document.guides, self._transform, at)

    def _drag_guide(self, at: ScreenPoint, *, free: bool) -> None:
        drag = self._guide
        if drag is None:
            return
        if not drag.moving:
            if drag.press.distance(at) < START_DISTANCE:
                return
            drag = self._guide = replace(drag, moving=True)
            self._presenter.begin(_LABELS[drag.number is None])
        number = drag.number
        if not self.area.contains(at):
            # Back on the ruler, or out of the picture: it goes.
            self._presenter.apply(lambda d: d if number is None else edits.remove_guide(d, number))
            return
        value = self._guide_value(drag.at, at, free=free)
        if number is None:
            self._presenter.apply(lambda d: edits.add_guide(d, Guide(drag.at, value)))
        else:
            self._presenter.apply(lambda d: edits.move_guide(d, number, value))

    def _guide_value(self, along: GuideAt, at: ScreenPoint, *, free: bool) -> float:
        """Return where a guide goes: to a control point's own place, to the grid, or freely."""
        which, scale = along.coordinate, self._transform.scale
        value = self._transform.to_design(at).pair[which]
        if free:
            return value
        places = self._profile.control_points[..., which].ravel()
        nearest = float(places[abs(places - value).argmin()])
        if abs(nearest - value) * scale <= MAGNET_REACH:
            return nearest
        return snap_steps(scale).snapped(value) if self._frame.view.snap else value

    def _asks(self, event: QContextMenuEvent) -> bool:
        """Offer what can be done with the guide under the pointer."""
        at = ScreenPoint(event.pos().x(), event.pos().y())
        keyboard = event.reason() == QContextMenuEvent.Reason.Keyboard
        number = None if keyboard else self._guide_under(at)
        if number is None:
            return False
        menu, presenter = QMenu(self), self._presenter
        menu.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        remove = menu.addAction("Remove guide")
        remove.triggered.connect(
            lambda: presenter.do("Remove a guide", lambda d: edits.remove_guide(d, number))
        )
        every = menu.addAction("Remove all guides")
        every.triggered.connect(lambda: presenter.do("Remove all guides", edits.remove_guides))
        menu.popup(event.globalPos())
        return True

    def _show_cursor(self) -> None:
        super()._show_cursor()
        idle = self._hand.gesture.state is State.IDLE and self._tool is None
        along = None if self._guide is None else self._guide.at
        if along is None and idle and self._pointer is not None and self._active is None:
            along = ruler_at(self.area, self._pointer)
            number = self._guide_under(self._pointer)
            if number is not None:
                along = self._frame.document.guides[number].at
        if along is not None:
            upright = along is GuideAt.RADIUS
            self.setCursor(Qt.CursorShape.SplitHCursor if upright else Qt.CursorShape.SplitVCursor)
