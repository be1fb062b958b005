"""The turn seen along the axis, in the editor's corner: both its ends are dragged there."""

from __future__ import annotations

from math import atan2, cos, degrees, hypot, radians, sin, tau

from PySide6.QtCore import QEvent, QPointF, QRectF, Qt
from PySide6.QtGui import QKeyEvent, QMouseEvent, QPainter, QPaintEvent
from PySide6.QtWidgets import QToolTip, QWidget

from app.hand.canvas import Canvas
from app.hand.coordinates import Area, Transform, number
from app.hand.keys import keys_of
from app.hand.turn import TurnAngles, TurnEnd, handle_angles
from app.state.presenter import Frame, Presenter
from app.theme import theme
from sgb_core.document import edits
from sgb_core.values import dataclass

SIDE = 48
RADIUS = 18.0
_REACH = 8.0
# Qt's angles of arcs count sixteenths of a degree.
_SIXTEENTHS = 16


@dataclass(frozen=True, slots=True)
class _Drag:
    """One end in the hand: the turn before, and the angle under the hand, its turns counted."""

    end: TurnEnd
    before: TurnAngles
    grabbed: float
    angle: float


class TurnDial(QWidget):
    """A small circle with the turn as its sector; a full turn has both handles side by side."""

    def __init__(self, presenter: Presenter, parent: QWidget) -> None:
        super().__init__(parent)
        self._presenter = presenter
        self._near: TurnEnd | None = None
        self._drag: _Drag | None = None
        self._shown = presenter.document.revolution
        self.setFixedSize(SIDE, SIDE)
        self.setMouseTracking(True)
        self.setAccessibleName("Turn seen along the axis")
        self.setAccessibleDescription("The Turn panel has both angles as numbers")

    def refresh(self, frame: Frame) -> None:
        """Show a frame; a drag that was ended elsewhere is dropped."""
        if self._drag is not None and not frame.dragging:
            self._let_go()
        # The editor under it is painted along: only where what it shows has changed.
        if frame.document.revolution != self._shown:
            self._shown = frame.document.revolution
            self.update()

    @property
    def turn(self) -> TurnAngles:
        """The turn that is shown."""
        revolution = self._presenter.document.revolution
        return TurnAngles(revolution.start_deg, revolution.sweep_deg)

    def place(self, end: TurnEnd) -> QPointF:
        """Return where the handle of an end is."""
        turn = self.turn
        angles = handle_angles(radians(turn.start), radians(turn.sweep))
        angle = angles[int(end is TurnEnd.END)]
        return self._middle + QPointF(RADIUS * cos(angle), -RADIUS * sin(angle))

    @property
    def _middle(self) -> QPointF:
        return QPointF(SIDE / 2.0, SIDE / 2.0)

    def _pick(self, at: QPointF) -> TurnEnd | None:
        def away(end: TurnEnd) -> float:
            way = self.place(end) - at
            return hypot(way.x(), way.y())

        nearest = min(TurnEnd, key=away)
        return nearest if away(nearest) <= _REACH else None

    def _angle(self, at: QPointF, near: float) -> float:
        """Return the angle under the hand in radians, the turn of it nearest to ``near``."""
        way = at - self._middle
        found = atan2(-way.y(), way.x())
        return near + (found - near + tau / 2.0) % tau - tau / 2.0

    # The mouse.

    def mousePressEvent(self, event: QMouseEvent) -> None:
        end = self._pick(event.position())
        if event.button() == Qt.MouseButton.LeftButton and end is not None:
            angle = self._angle(event.position(), 0.0)
            self._drag = _Drag(end, self.turn, angle, angle)
            self._presenter.begin(end.label)
            # Until the hand lets go Escape takes the drag back, whoever has the focus.
            self.grabKeyboard()

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        drag = self._drag
        if drag is None:
            self._near = self._pick(event.position())
        else:
            angle = self._angle(event.position(), drag.angle)
            self._drag = _Drag(drag.end, drag.before, drag.grabbed, angle)
            keys = keys_of(event.modifiers())
            moved = angle - drag.grabbed
            new = drag.before.dragged(drag.end, moved, snap=not keys.free, hold=keys.constrain)
            self._presenter.apply(
                lambda d: edits.set_revolution(d, start_deg=new.start, sweep_deg=new.sweep)
            )
        self._tell(event)
        self.update()

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        if self._drag is not None and event.button() == Qt.MouseButton.LeftButton:
            self._let_go()
            self._presenter.commit()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.key() == Qt.Key.Key_Escape and self._drag is not None:
            self._let_go()
            self._presenter.cancel()
        else:
            super().keyPressEvent(event)

    def leaveEvent(self, event: QEvent) -> None:
        self._near = None
        self.update()
        super().leaveEvent(event)

    def _let_go(self) -> None:
        self._drag = None
        self.releaseKeyboard()
        self.update()

    @property
    def _held(self) -> TurnEnd | None:
        return self._near if self._drag is None else self._drag.end

    def _tell(self, event: QMouseEvent) -> None:
        held = self._held
        shape = Qt.CursorShape.ArrowCursor
        if held is not None:
            dragging = self._drag is not None
            shape = Qt.CursorShape.ClosedHandCursor if dragging else Qt.CursorShape.OpenHandCursor
        self.setCursor(shape)
        QToolTip.showText(event.globalPosition().toPoint(), self.told(), self)

    def told(self) -> str:
        """Return what is said of the end that is pointed at or held, or of the dial."""
        turn, held = self.turn, self._held
        span = f"from {number(turn.start, 1)}° to {number(turn.start + turn.sweep, 1)}°"
        if held is None:
            return f"The turn seen along the axis, {span}: drag an end"
        value = turn.sweep if held is TurnEnd.END else turn.start
        return f"{held.label} {number(value, 1)}°\n{span}"

    # The picture.

    def paintEvent(self, _event: QPaintEvent) -> None:
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        area = Area(0.0, 0.0, float(SIDE), float(SIDE))
        canvas = Canvas(painter, Transform(1.0, 0.0, 0.0), theme.current(), area, self.font())
        lit = self.underMouse() or self._drag is not None
        circle = QRectF(0.0, 0.0, 2.0 * RADIUS, 2.0 * RADIUS)
        circle.moveCenter(self._middle)
        turn = self.turn
        painter.setPen(canvas.pen("border", 1.0))
        painter.setBrush(canvas.color("canvas", 210))
        painter.drawEllipse(circle)
        painter.setPen(canvas.pen("surface", 1.6, 255 if lit else 170))
        painter.setBrush(canvas.color("surface", 90 if lit else 45))
        spans = round(_SIXTEENTHS * turn.start), round(_SIXTEENTHS * turn.sweep)
        if turn.sweep < degrees(tau):
            painter.drawPie(circle, *spans)
        else:
            painter.drawEllipse(circle)
        for end in TurnEnd:
            radius = 4.5 if end is self._held else 3.2
            painter.setPen(canvas.pen("canvas", 1.0))
            painter.setBrush(canvas.color("accent" if lit else "text_muted"))
            painter.drawEllipse(self.place(end), radius, radius)
        painter.end()
