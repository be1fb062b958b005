"""The paper of the profile editor: what is shown, at which zoom, and painting it."""

from __future__ import annotations

import numpy as np
from PySide6.QtCore import QRectF, QSize, Qt
from PySide6.QtGui import QAction, QFont, QPainter, QPaintEvent, QPixmap, QResizeEvent
from PySide6.QtWidgets import QSizePolicy, QWidget

from app.hand.coordinates import Area, ScreenPoint, Transform
from app.hand.cursor import cursor_for
from app.hand.dimension_lines import pick_dimension
from app.hand.drag import Gesture, State
from app.hand.hand import Hand
from app.hand.hit_test import Handle, Target, pick
from app.hand.scale_frame import PointFrame
from app.profile_editor.body import pick_feature, pick_level
from app.profile_editor.cached_layer import CachedLayers
from app.profile_editor.clear_fit import Cut, clear_fit
from app.profile_editor.grid import ruler_sizes
from app.profile_editor.picture import Picture, paint, paint_background
from app.profile_editor.slump_line import SLUMP_WIDTH
from app.profile_editor.tools.tool import Tool
from app.state import preferences
from app.state.overlays import Overlay
from app.state.presenter import Frame, Presenter
from app.state.same_size import factor_between
from app.theme import theme
from app.theme.fonts import small_font
from sgb_core.curves.profile import Profile

_FIT_MARGIN = 30.0
# The mirror image is shown in full where that costs less than a tenth of the scale.
_MIRROR_WORTH = 0.9


class ProfileSheet(QWidget):
    """Shows the profile with its grid and marks.

    The zoom is the user's: it changes by wheel, pan, fit, and with another document; with an
    edit only where the shape grows out of a view that nobody has moved since it was fitted.
    """

    def __init__(self, presenter: Presenter, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._presenter = presenter
        self._frame: Frame = presenter.frame
        self._transform = Transform(1.0, 0.0, 0.0)
        self._fit_wanted = True
        self._follows_size = True
        # The profile as it was when the hand last rested.
        self._settled = self._profile
        self._hand = Hand(presenter)
        self._active: Handle | None = None
        self._pointer: ScreenPoint | None = None
        self._pan_ready = False
        self._tool: Tool | None = None
        self._background = QPixmap()
        self._background_key: object = None
        self._layers = CachedLayers()
        self.setAttribute(Qt.WidgetAttribute.WA_OpaquePaintEvent)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        self.setMinimumSize(160, 160)
        self.fit_action = QAction("&Fit the profile\tF", self)
        self.fit_action.triggered.connect(self.fit)
        theme.notifier().changed.connect(self._theme_changed)
        preferences.notifier().changed.connect(self._preferred)

    def refresh(self, frame: Frame) -> None:
        """Show a frame; another document than before is fitted."""
        old, self._frame = self._frame, frame
        self._transform = self._transform.told_in(factor_between(old.document, frame.document))
        if frame.generation != old.generation:
            self._hand.drop()
            self._active = None
            self._fit_wanted = True
        self._hand.follow(frame)
        if self._active is not None and self._active.segment >= len(self._profile):
            self._active = None
        if not frame.dragging:
            self._follow_growth()
        if _drawn(old) != _drawn(frame):
            self.update()

    def _follow_growth(self) -> None:
        """Fit a shape again that has grown out of the view that was fitted to it."""
        if self._profile is self._settled:
            return
        self._settled = self._profile
        corners = self._transform.map(np.stack(self._profile.bounds())).tolist()
        if self._follows_size and not all(
            self.area.contains(ScreenPoint(*corner)) for corner in corners
        ):
            self._fit_wanted = True

    @property
    def frame(self) -> Frame:
        """What is shown."""
        return self._frame

    @property
    def transform(self) -> Transform:
        """Where design coordinates lie in this widget."""
        return self._transform

    @property
    def gesture(self) -> Gesture:
        """What the hand is doing."""
        return self._hand.gesture

    @property
    def active(self) -> Handle | None:
        """The handle under the pointer, in the hand, or chosen by the keyboard."""
        return self._active

    def sizeHint(self) -> QSize:
        return QSize(320, 360)

    def fit(self) -> None:
        """Show the whole profile with the axis, and the mirror image where there is room."""
        points = self._profile.control_points.reshape(-1, 2)
        lower, upper = points.min(axis=0), points.max(axis=0)
        near, far = min(lower[0], 0.0), max(upper[0], 0.0)
        inner, outer = (float(corner[0]) for corner in self._frame.evaluation.bounds)
        self._transform = self._fitting((near - 0.12 * (far - near), lower[1]), (far, upper[1]))
        whole = self._fitting((min(near, -outer), lower[1]), (max(far, -inner), upper[1]))
        if whole.scale >= _MIRROR_WORTH * self._transform.scale:
            self._transform = whole
        self._fit_wanted = False
        self._follows_size = True
        self._pick_again()

    def _fitting(self, lower: tuple[float, float], upper: tuple[float, float]) -> Transform:
        margin = min(_FIT_MARGIN, 0.12 * min(self.width(), self.height()))

        def fitted(cut: Cut) -> Transform:
            transform = self._transform
            # The ruler's width follows the numbers and these the scale: the second round settles.
            for _ in range(2):
                room = cut.within(self._area_at(transform)).grown(-margin)
                transform = Transform.fitting(lower, upper, room)
            return transform

        points = self._profile.control_points.reshape(-1, 2)
        return clear_fit(fitted, points, self._over(), self._area_at(self._transform))

    @property
    def area(self) -> Area:
        """The part of the widget inside the rulers."""
        return self._area_at(self._transform)

    def _area_at(self, transform: Transform) -> Area:
        left, below = ruler_sizes(self._small_font(), transform, float(self.height()))
        return Area(left, 0.0, float(self.width()), float(self.height()) - below)

    def paintEvent(self, _event: QPaintEvent) -> None:
        if self._fit_wanted:
            self.fit()
        picture = Picture(
            self._frame,
            self._transform,
            self.area,
            self.size(),
            self._small_font(),
            self._active,
            self._hand.gesture,
            self._hand.landing,
            self._pointer,
            self._told(),
            self.hasFocus(),
            self._layers,
            self._tool,
            self._over(),
        )
        painter = QPainter(self)
        painter.drawPixmap(0, 0, self._painted_background(picture))
        paint(painter, picture)
        painter.end()

    def _painted_background(self, picture: Picture) -> QPixmap:
        ratio = self.devicePixelRatioF()
        key = (
            picture.transform,
            picture.size,
            picture.font.key(),
            picture.frame.document.unit,
            picture.frame.document.reference,
            theme.current(),
            ratio,
        )
        if key != self._background_key:
            self._background = QPixmap(self.size() * ratio)
            self._background.setDevicePixelRatio(ratio)
            painter = QPainter(self._background)
            paint_background(painter, picture)
            painter.end()
            self._background_key = key
        return self._background

    def resizeEvent(self, event: QResizeEvent) -> None:
        if self._follows_size and not self._hand.gesture.edits:
            self._fit_wanted = True
        elif event.oldSize().isValid():
            grown = event.size() - event.oldSize()
            self._transform = self._transform.panned(grown.width() / 2.0, grown.height() / 2.0)
        super().resizeEvent(event)

    def _told(self) -> ScreenPoint | None:
        """Where the heads-up label stands: beside the pointer, or the point of the keyboard."""
        if self._active is None or self._hand.gesture.state in (State.PANNING, State.BOXING):
            return None
        if self._pointer is not None and self._hand.gesture.state is not State.NUDGING:
            return self._pointer
        if self._active.target is not Target.POINT or not self.hasFocus():
            return None
        place = self._profile.segments[self._active.segment].points[self._active.index]
        return ScreenPoint(*self._transform.map(place).tolist())

    def _over(self) -> tuple[QRectF, ...]:
        """Return what lies over the paper."""
        return ()

    def _small_font(self) -> QFont:
        return small_font(self.font(), 0.88)

    def _theme_changed(self, _palette: object) -> None:
        self.update()

    def _preferred(self, _changed: object) -> None:
        self._layers.slump.forget()
        self.update()

    def _tip(self, at: ScreenPoint) -> str:
        """Return what a ruler or the slump line says; else the heads-up label tells already."""
        area = self.area
        if at.x < area.left and at.y > area.bottom:
            return f"All lengths are in {self._unit}"
        if at.y > area.bottom:
            return f"r, the distance from the axis, in {self._unit}; drag from here for a guide"
        if at.x < area.left:
            return f"h, the height along the axis, in {self._unit}; drag from here for a guide"
        if at.x < area.left + SLUMP_WIDTH and self._frame.view.shows(Overlay.SLUMP):
            return self._layers.slump.tip(self._frame.document, self._transform.to_design(at).h)
        return ""

    def zoom(self, factor: float, at: ScreenPoint) -> None:
        """Scale the picture; what lies under ``at`` stays there."""
        size = max(self._profile.size, 1e-9)
        least, most = 4.0 / size, 1e8 / size
        wanted = min(max(self._transform.scale * factor, least), most)
        self._transform = self._transform.zoomed(wanted / self._transform.scale, at)
        self._follows_size = False
        self._pick_again()

    @property
    def _profile(self) -> Profile:
        return self._frame.document.profile

    @property
    def _unit(self) -> str:
        return str(self._frame.document.unit)

    def _pick(
        self, at: ScreenPoint, *, quartics: bool = True, framed: bool = True
    ) -> Handle | None:
        if not self.area.contains(at) or self._tool is not None:
            return None
        view, paper = self._frame.view, self._transform
        frame = PointFrame.of(self._profile, view.points) if framed else None
        found = pick(
            self._profile,
            paper,
            at,
            selected=view.segment,
            quartics=quartics and view.shows(Overlay.QUARTIC),
            curves=view.shows(Overlay.GENERATRIX),
            lit={segment for segment, _ in view.points},
        )
        if frame is not None and (found is None or found.target is not Target.POINT):
            # The frame's handles lie over all but the points themselves.
            found = frame.pick_grip(paper, at) or found
        found = found or pick_level(self._frame, paper, at)
        if found is None or found.target is Target.CURVE:
            found = pick_feature(self._frame, paper, at) or found
        if found is None or found.target is Target.CURVE:
            found = pick_dimension(self._frame.document, paper, at) or found
        return frame.pick_body(paper, at) if found is None and frame is not None else found

    def _pick_again(self) -> None:
        if self._hand.gesture.state is State.IDLE and self._pointer is not None:
            self._active = self._pick(self._pointer)
        self._show_cursor()
        self.update()

    def _show_cursor(self) -> None:
        state = self._hand.gesture.state
        if self._tool is not None and state is State.IDLE and not self._pan_ready:
            shape = self._tool.cursor
        else:
            shape = cursor_for(self._profile, state, self._active, self._pan_ready)
        if self.cursor().shape() != shape:
            self.setCursor(shape)


def _drawn(frame: Frame) -> tuple[object, ...]:
    """Return what the picture depends on; sliders of the turn or the body leave it as it is."""
    document = frame.document
    return (
        id(document.profile),
        document.unit,
        id(document.reference),
        document.revolution.axis,
        frame.view,
        frame.generation,
        id(frame.compared),
        # The section at an angle follows the laws.
        None if frame.view.angle is None else id(document.variation),
        id(frame.body),
        document.manufacture.fill,
        document.appearance.drawing,
        document.appearance.textures,
        document.solid.kind,
        document.dimensions,
        document.guides,
        frame.in_the_way,
        # What a printer makes of it follows wall, laws and shrinkage, too.
        id(document) if frame.view.shows(Overlay.SLUMP) else None,
    )
