"""The orientation cube in the viewport's corner: shows how the object is seen, and turns it."""

from __future__ import annotations

from collections.abc import Callable
from math import atan2, cos, hypot, sin

import numpy as np
from PySide6.QtCore import QEvent, QPointF, QRectF, QSize, Qt
from PySide6.QtGui import (
    QColor,
    QFont,
    QMouseEvent,
    QPainter,
    QPaintEvent,
    QPen,
    QPixmap,
    QPolygonF,
    QTransform,
)
from PySide6.QtWidgets import QWidget

from app.scene.camera import Pose, axis_frame
from app.scene.standard_views import KEYED_VIEWS, STANDARD_VIEWS, StandardView
from app.theme import theme
from sgb_core.arrays import Floats
from sgb_core.values import dataclass

SIDE = 96
# Half the cube's edge in pixels, and where on a face its rim begins, which stands for an edge.
_HALF = 22.0
_RIM = 0.58
_DRAG = 3.0

Way = tuple[int, int, int]


@dataclass(frozen=True, slots=True)
class Face:
    """A side of the cube: its words, outward normal, and where its text runs and stands up."""

    words: str
    normal: Way
    right: Way
    up: Way

    @classmethod
    def of(cls, view: StandardView) -> Face:
        """Return the side that a standard view looks at, in (u, v, height)."""
        across, along = (sin(view.azimuth), cos(view.azimuth))
        level, rise = cos(view.elevation), sin(view.elevation)
        normal, right, up = (
            (round(u), round(v), round(height))
            for u, v, height in (
                (level * along, level * across, rise),
                (-across, along, 0.0),
                (-rise * along, -rise * across, level),
            )
        )
        return cls(view.words, normal, right, up)


# The views along an axis; from the three-quarter view no side is seen straight on.
_FACES = tuple(Face.of(view) for view in STANDARD_VIEWS.values() if view.is_straight)
_AXES = (("x", "error"), ("y", "good"), ("z", "accent"))


@dataclass(frozen=True, slots=True)
class Zone:
    """A face, an edge or a corner: the direction from which it looks, and its patch on a face."""

    direction: Way
    face: int
    patch: tuple[float, float, float, float]

    @property
    def angles(self) -> tuple[float, float]:
        """Azimuth and elevation of the viewer, in radians."""
        u, v, height = self.direction
        level = hypot(u, v)
        azimuth = atan2(v, u) if level else -np.pi / 2.0
        return float(azimuth), float(atan2(height, level))


class OrientationCube(QWidget):
    """A click on a face, an edge or a corner looks from there; a drag orbits.

    ``look`` gets azimuth and elevation, ``orbit`` a step in pixels.
    """

    def __init__(
        self,
        look: Callable[[float, float], object],
        orbit: Callable[[float, float], object],
        parent: QWidget,
    ) -> None:
        super().__init__(parent)
        self._look, self._orbit = look, orbit
        self._pose: Pose | None = None
        self._turned = np.eye(3)
        # Drawn once: the picture below is drawn anew with every frame, and this over it.
        self._drawn: QPixmap | None = None
        self._lit: Zone | None = None
        self._press: QPointF | None = None
        self._dragging = False
        self.setFixedSize(SIDE, SIDE)
        self.setMouseTracking(True)
        self.setAccessibleName("Orientation cube")
        self.setAccessibleDescription(
            f"Standard views: keys {KEYED_VIEWS}, with Ctrl from the other side"
        )
        self.setToolTip("Click a face, an edge or a corner to look from there; drag to orbit")
        theme.notifier().changed.connect(self._take_palette)

    def sizeHint(self) -> QSize:
        return QSize(SIDE, SIDE)

    def show_pose(self, pose: Pose) -> None:
        """Turn with the view."""
        if pose is self._pose:
            return
        if self._pose is None or not np.array_equal(pose.basis, self._pose.basis):
            self._pose = pose
            self._turned = pose.basis @ axis_frame(pose.axis).T
            self._redraw()

    def face_centre(self, name: str) -> QPointF | None:
        """Return where a face is seen, None where it is turned away."""
        for number, face in enumerate(_FACES):
            if face.words.lower() == name.lower() and self._pose is not None:
                if self._turn(face.normal)[2] <= 0.05:
                    return None
                return self._at(number, 0.0, 0.0)
        return None

    # Geometry.

    def _turn(self, direction: Way) -> Floats:
        """Return a direction of the cube as (right, up, towards the viewer)."""
        return np.asarray(self._turned @ direction)

    def _at(self, face: int, a: float, b: float) -> QPointF:
        """Return the place of (a, b), both −1 to 1, on a face."""
        side = _FACES[face]
        place = self._turn(side.normal) + a * self._turn(side.right) + b * self._turn(side.up)
        return QPointF(SIDE / 2.0 + _HALF * place[0], SIDE / 2.0 - _HALF * place[1])

    def _quad(self, face: int, patch: tuple[float, float, float, float]) -> QPolygonF:
        a0, b0, a1, b1 = patch
        corners = ((a0, b0), (a1, b0), (a1, b1), (a0, b1))
        return QPolygonF([self._at(face, a, b) for a, b in corners])

    def _visible(self) -> list[int]:
        return [k for k, face in enumerate(_FACES) if self._turn(face.normal)[2] > 0.05]

    def zone_at(self, at: QPointF) -> Zone | None:
        """Return what a click at a place would look from."""
        if self._pose is None:
            return None
        for face in self._visible():
            side = _FACES[face]
            x, y = self._turn(side.right)[:2], self._turn(side.up)[:2]
            middle = self._turn(side.normal)[:2]
            place = np.array((at.x() - SIDE / 2.0, SIDE / 2.0 - at.y())) / _HALF - middle
            a, b = np.linalg.solve(np.stack([x, y], axis=1), place)
            if max(abs(a), abs(b)) > 1.0:
                continue
            steps = [0 if abs(c) < _RIM else (1 if c > 0 else -1) for c in (a, b)]
            direction = np.array(side.normal) + steps @ np.array([side.right, side.up])
            low = [{-1: -1.0, 0: -_RIM, 1: _RIM}[step] for step in steps]
            high = [{-1: -_RIM, 0: _RIM, 1: 1.0}[step] for step in steps]
            u, v, height = (int(c) for c in direction)
            return Zone((u, v, height), face, (low[0], low[1], high[0], high[1]))
        return None

    # Events.

    def mousePressEvent(self, event: QMouseEvent) -> None:
        if event.button() == Qt.MouseButton.LeftButton:
            self._press, self._dragging = event.position(), False

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        at = event.position()
        if self._press is None:
            self._light(self.zone_at(at))
            return
        step = at - self._press
        if self._dragging or hypot(step.x(), step.y()) >= _DRAG:
            self._dragging = True
            self._press = at
            self._light(None)
            self._orbit(step.x(), step.y())

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        if event.button() != Qt.MouseButton.LeftButton:
            return
        zone = None if self._dragging or self._press is None else self.zone_at(event.position())
        self._press, self._dragging = None, False
        if zone is not None:
            self._look(*zone.angles)
        self._light(self.zone_at(event.position()))

    def leaveEvent(self, event: QEvent) -> None:
        self._light(None)
        super().leaveEvent(event)

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.FontChange:
            self._redraw()

    def _take_palette(self, _palette: theme.Palette) -> None:
        self._redraw()

    def _light(self, zone: Zone | None) -> None:
        if zone != self._lit:
            self._lit = zone
            self._redraw()

    def _redraw(self) -> None:
        self._drawn = None
        self.update()

    # Painting.

    def paintEvent(self, _event: QPaintEvent) -> None:
        if self._pose is None:
            return
        ratio = self.devicePixelRatioF()
        if self._drawn is None or self._drawn.devicePixelRatio() != ratio:
            side = round(SIDE * ratio)
            self._drawn = QPixmap(side, side)
            self._drawn.setDevicePixelRatio(ratio)
            self._drawn.fill(Qt.GlobalColor.transparent)
            self._paint(self._drawn)
        painter = QPainter(self)
        painter.drawPixmap(0, 0, self._drawn)
        painter.end()

    def _paint(self, sheet: QPixmap) -> None:
        palette = theme.current()
        painter = QPainter(sheet)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        self._paint_axes(painter, palette, behind=True)
        for face in self._visible():
            self._paint_face(painter, palette, face)
        if self._lit is not None:
            tint = QColor(palette.accent)
            tint.setAlpha(120)
            painter.setPen(Qt.PenStyle.NoPen)
            painter.setBrush(tint)
            painter.drawPolygon(self._quad(self._lit.face, self._lit.patch))
        self._paint_axes(painter, palette, behind=False)
        painter.end()

    def _paint_face(self, painter: QPainter, palette: theme.Palette, face: int) -> None:
        normal = _FACES[face].normal
        # Lit from above and from the viewer, so that the faces are told apart.
        light = float(np.clip(0.55 * self._turn(normal)[2] + 0.35 * self._turn(normal)[1], 0, 1))
        painter.setPen(QPen(QColor(palette.text_muted), 1.0))
        painter.setBrush(_mixed(QColor(palette.panel), QColor(palette.border), light))
        quad = self._quad(face, (-1.0, -1.0, 1.0, 1.0))
        painter.drawPolygon(quad)
        if self._turn(normal)[2] < 0.3:
            return
        sheet = QPolygonF([QPointF(0, 60), QPointF(60, 60), QPointF(60, 0), QPointF(0, 0)])
        transform = QTransform()
        if QTransform.quadToQuad(sheet, quad, transform):
            painter.save()
            painter.setTransform(transform, True)
            font = QFont(self.font())
            font.setPixelSize(15)
            font.setWeight(QFont.Weight.DemiBold)
            painter.setFont(font)
            painter.setPen(QColor(palette.text))
            painter.drawText(QRectF(0, 0, 60, 60), Qt.AlignmentFlag.AlignCenter, _FACES[face].words)
            painter.restore()

    def _paint_axes(self, painter: QPainter, palette: theme.Palette, *, behind: bool) -> None:
        """Draw x, y and z from the cube's corner: those that point away before the faces."""
        assert self._pose is not None
        corner = self._turn((-1, -1, -1)) * 1.12
        font = QFont(self.font())
        font.setPixelSize(11)
        painter.setFont(font)
        for k, (name, colour) in enumerate(_AXES):
            way = self._pose.basis @ np.eye(3)[k]
            if bool(corner[2] + way[2] < 0.0) is not behind:
                continue
            tip, beyond = corner + 2.7 * way, corner + 3.05 * way
            start, end, label = (
                QPointF(SIDE / 2.0 + _HALF * p[0], SIDE / 2.0 - _HALF * p[1])
                for p in (corner, tip, beyond)
            )
            painter.setPen(QPen(QColor(getattr(palette, colour)), 1.8))
            painter.drawLine(start, end)
            box = QRectF(label.x() - 6.0, label.y() - 7.0, 12.0, 14.0)
            painter.drawText(box, Qt.AlignmentFlag.AlignCenter, name)


def _mixed(one: QColor, other: QColor, share: float) -> QColor:
    """Return a colour that is ``share`` of one and the rest of the other."""
    rest = 1.0 - share
    return QColor.fromRgbF(
        share * one.redF() + rest * other.redF(),
        share * one.greenF() + rest * other.greenF(),
        share * one.blueF() + rest * other.blueF(),
    )
