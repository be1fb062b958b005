"""The live 3-D viewport: a scene in a window of its own, with navigation and a few buttons."""

from __future__ import annotations

import contextlib
import importlib
import threading
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from PySide6.QtCore import QEvent, QRectF, Qt, QTimer
from PySide6.QtGui import (
    QColor,
    QLinearGradient,
    QPainter,
    QPaintEvent,
    QResizeEvent,
    QShowEvent,
    QSurfaceFormat,
)
from PySide6.QtOpenGLWidgets import QOpenGLWidget
from PySide6.QtWidgets import QStackedLayout, QWidget

from app import theme
from app.colour_key import ColourKey
from app.scene_camera import VIEWS, Pose, standard_pose
from app.surface_buttons import ViewportButtons
from app.surface_navigation import Navigator
from app.view_state import Overlay

if TYPE_CHECKING:
    from app.presenter import Frame, Presenter
    from app.scene import Scene
    from sgb_core.document.model import Document

# How long the hand rests before the picture is refined, in milliseconds.
REFINE_AFTER = 150
# What takes long to import: with it aside the window is painted and answers at once.
HEAVY = ("pyvistaqt", "app.scene")


class Ground(QWidget):
    """What is seen until the 3-D part is loaded: its background, quietly."""

    def paintEvent(self, _event: QPaintEvent) -> None:
        palette = theme.current()
        gradient = QLinearGradient(0, 0, 0, self.height())
        gradient.setColorAt(0.0, QColor(palette.viewport_top))
        gradient.setColorAt(1.0, QColor(palette.viewport_bottom))
        QPainter(self).fillRect(QRectF(self.rect()), gradient)


class SurfaceView(QWidget):
    """Shows frames; its camera is moved by the user alone.

    The drawing widget is made after the first paint. ``pose`` is where the viewer stands.
    """

    def __init__(self, presenter: Presenter, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._presenter = presenter
        self._frame: Frame | None = None
        self._generation: int | None = None
        self._refined = False
        self._shut = False
        # The document that was fitted, until the user moves the camera.
        self._fitted: Document | None = None
        self.pose: Pose | None = None
        self.scene: Scene | None = None
        self.plotter: Any = None
        self.setMinimumSize(240, 200)
        self.setAccessibleName("3-D viewport")
        self._stack = QStackedLayout(self)
        self._stack.setStackingMode(QStackedLayout.StackingMode.StackOne)
        self._stack.addWidget(Ground())
        # A top-level window that meets its first OpenGL widget when it is already shown is made
        # anew, with a flash. This one is never drawn; the drawing widget comes later.
        QSurfaceFormat.setDefaultFormat(_surface_format())
        self._forerunner = QOpenGLWidget(self)
        self._forerunner.hide()
        self.buttons = ViewportButtons(self, self)
        self.colour_key = ColourKey(self)
        self._refine_timer = QTimer(self, singleShot=True, interval=REFINE_AFTER)
        self._refine_timer.timeout.connect(self._refine)
        self._loader: threading.Thread | None = None
        self._load_timer = QTimer(self, interval=15)
        self._load_timer.timeout.connect(self._build_when_loaded)
        theme.notifier().changed.connect(self._take_palette)

    # What the window asks for.

    def refresh(self, frame: Frame) -> None:
        """Show a frame: at once and plainly during a gesture, refined when the hand rests."""
        self._frame = frame
        self.buttons.show_state(frame.view)
        if self.scene is not None:
            self._show(frame)

    def fit(self) -> None:
        """See all of the object, from where it is seen now."""
        if self.scene is not None and self.pose is not None:
            self.move_camera(self.pose.fitted(self.scene.points_to_fit(), self._aspect))
            self.hand_rested()
            self._fitted = None if self._frame is None else self._frame.evaluation.document

    def set_view_direction(self, name: str) -> None:
        """See the object from one of :data:`app.scene_camera.VIEWS`; raises KeyError."""
        direction = VIEWS[name]
        if self.pose is not None:
            self.move_camera(self.pose.turned_to(*direction))
            self.hand_rested()

    def toggle_projection(self) -> None:
        """Change between perspective and parallel projection."""
        parallel = self._presenter.view.projection == "parallel"
        self._presenter.set_view(projection="perspective" if parallel else "parallel")

    def toggle_overlay(self, overlay: Overlay) -> None:
        """Show what is hidden, hide what is shown."""
        self._presenter.set_view(show=self._presenter.view.show ^ {overlay})

    def size_in_pixels(self) -> tuple[int, int]:
        """Return the viewport's own (width, height) in pixels of the screen."""
        ratio = self.devicePixelRatioF()
        return max(1, round(self.width() * ratio)), max(1, round(self.height() * ratio))

    def picture(self, size: tuple[int, int], transparent: bool) -> bytes:
        """Return a PNG of the present view at any size, drawn off screen.

        What is seen from top to bottom stays; a narrower picture shows as much from side to side.
        """
        from app.scene_offscreen import png_bytes, render_image

        frame = self._frame or self._presenter.frame
        image = render_image(
            frame.evaluation,
            frame.view,
            size,
            pose=None if self.pose is None else self._widened(self.pose, size),
            palette=theme.current(),
            transparent=transparent,
            line_scale=size[1] / max(1, self.height()),
        )
        return png_bytes(image)

    def shut_down(self) -> None:
        """Let go of the graphics; nothing is drawn any more. To be called before closing."""
        self._shut = True
        self._refine_timer.stop()
        self._load_timer.stop()
        if self.plotter is not None:
            self.plotter.close()
            self.scene = None

    # The camera.

    def move_camera(self, pose: Pose) -> None:
        """See from ``pose``, drawn plainly until :meth:`hand_rested`."""
        self._fitted = None
        self.pose = pose
        if self.scene is not None:
            self.scene.pose = pose
            self._plain()
            self.plotter.update()

    def hand_rested(self) -> None:
        """Refine the picture after a moment, unless the hand moves again."""
        if not (self._frame is not None and self._frame.dragging):
            self._refine_timer.start()

    def set_pivot(self, x: float, y: float) -> None:
        """Turn about the point of the surface seen at (x, y); beside it about its middle."""
        if self.scene is None or self.pose is None:
            return
        right, up = (2 * x / self.height() - self._aspect, 1 - 2 * y / self.height())
        found = self.scene.pick(self.pose, right, up)
        if found is not None:
            self.pose = replace(self.pose, pivot=found)
            self.scene.pose = self.pose

    @property
    def _aspect(self) -> float:
        return max(1, self.width()) / max(1, self.height())

    def _widened(self, pose: Pose, size: tuple[int, int]) -> Pose:
        aspect = size[0] / size[1]
        return replace(pose, distance=pose.distance * max(1.0, self._aspect / aspect))

    # Drawing.

    def _show(self, frame: Frame) -> None:
        scene = self.scene
        assert scene is not None
        scene.update(frame.evaluation, frame.view, fine=False, compared=frame.compared)
        self.colour_key.show_state(frame, scene.overlays.influence.largest)
        axis = frame.evaluation.surface.axis
        parallel = frame.view.projection == "parallel"
        if self.pose is None or frame.generation != self._generation:
            self._generation = frame.generation
            pose = standard_pose(axis, parallel=parallel)
            self.pose = pose.fitted(scene.points_to_fit(), self._aspect)
            self._fitted = frame.evaluation.document
        if axis != self.pose.axis:
            self.pose = self.pose.carried_to(axis)
        if parallel != self.pose.parallel:
            self.pose = replace(self.pose, parallel=parallel)
        scene.pose = self.pose
        self._plain()
        self.plotter.update()
        self.hand_rested()

    def _plain(self) -> None:
        self._refine_timer.stop()
        if self._refined and self.scene is not None and self._frame is not None:
            self._refined = False
            self.scene.set_smooth(False)
            frame = self._frame
            self.scene.update(frame.evaluation, frame.view, fine=False, compared=frame.compared)

    def _refine(self) -> None:
        if self.scene is None or self._frame is None:
            return
        self._refined = True
        frame = self._frame
        self.scene.update(frame.evaluation, frame.view, fine=True, compared=frame.compared)
        self.scene.set_smooth(True)
        self.plotter.update()

    def _take_palette(self, palette: theme.Palette) -> None:
        if self.scene is not None:
            self.scene.set_palette(palette)
            self.plotter.update()

    # Life.

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        if self._loader is None and not self._shut:
            self._loader = threading.Thread(target=_import_heavy, daemon=True)
            # Only after the window has been painted once.
            QTimer.singleShot(0, self._load)

    def _load(self) -> None:
        if self._loader is not None and not self._shut:
            self._loader.start()
            self._load_timer.start()

    def _build_when_loaded(self) -> None:
        if self._loader is None or self._loader.is_alive():
            return
        self._load_timer.stop()
        try:
            self._build()
        except Exception as error:
            # Whatever a driver may raise: the rest of the window goes on working.
            self.plotter = self.scene = None
            self._stack.setCurrentIndex(0)
            self._presenter.notify(f"The 3-D view could not start: {error}", "error")

    def _build(self) -> None:
        from pyvistaqt import QtInteractor

        from app.scene import Scene

        # Its timer would draw without end; the smoothing is the scene's own affair.
        self.plotter = QtInteractor(self, auto_update=False, multi_samples=0)
        self.plotter.setAcceptDrops(False)
        self.plotter.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.plotter.setAccessibleName("3-D viewport")
        ratio = self.devicePixelRatioF()
        self.scene = Scene(self.plotter.renderer, theme.current(), pixel_ratio=ratio)
        Navigator(self.plotter, self)
        self._stack.addWidget(self.plotter)
        self._stack.setCurrentWidget(self.plotter)
        self.buttons.raise_()
        if self._frame is not None:
            self._show(self._frame)

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self.buttons.adjustSize()
        self.buttons.move(self.width() - self.buttons.width() - 10, 10)
        self.colour_key.place()
        # While the window finds its size what was fitted stays so; an edited shape, or a camera
        # that the user has moved, is left as it is.
        fitted, frame = self._fitted, self._frame
        if fitted is not None and frame is not None and frame.evaluation.document is fitted:
            self.fit()

    def event(self, event: QEvent) -> bool:
        if event.type() == QEvent.Type.DevicePixelRatioChange and self.scene is not None:
            self.scene.set_pixel_ratio(self.devicePixelRatioF())
        return super().event(event)


def _import_heavy() -> None:
    # What cannot be imported is reported where it is used.
    with contextlib.suppress(ImportError):
        for name in HEAVY:
            importlib.import_module(name)


def _surface_format() -> QSurfaceFormat:
    """Return what VTK needs of Qt's OpenGL; to be the default before the window is made."""
    wanted = QSurfaceFormat()
    wanted.setRenderableType(QSurfaceFormat.RenderableType.OpenGL)
    wanted.setProfile(QSurfaceFormat.OpenGLContextProfile.CoreProfile)
    wanted.setVersion(3, 2)
    wanted.setSwapBehavior(QSurfaceFormat.SwapBehavior.DoubleBuffer)
    wanted.setRedBufferSize(8)
    wanted.setGreenBufferSize(8)
    wanted.setBlueBufferSize(8)
    wanted.setAlphaBufferSize(8)
    wanted.setDepthBufferSize(8)
    wanted.setSamples(0)
    return wanted
