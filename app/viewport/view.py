"""The live 3-D viewport: a scene in a window of its own, with navigation and a few buttons."""

from __future__ import annotations

import threading
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from PySide6.QtCore import QTimer
from PySide6.QtGui import QResizeEvent, QShowEvent
from PySide6.QtWidgets import QStackedLayout, QWidget

from app.scene.camera import Pose, standard_pose
from app.scene.standard_views import STANDARD_VIEWS
from app.state.overlays import Overlay
from app.state.same_size import factor_between
from app.theme import theme
from app.viewport.buttons import ViewportButtons
from app.viewport.camera_transition import Glide, wanted
from app.viewport.clear_view import clear_pose
from app.viewport.colour_key import ColourKey
from app.viewport.drag_resolution import DragResolution
from app.viewport.half_plane import Lens
from app.viewport.hand import SurfaceHand
from app.viewport.hud import SurfaceHud
from app.viewport.interactor import new_interactor
from app.viewport.mouse_styles import STYLES
from app.viewport.navigation import Navigator, orbited
from app.viewport.opengl import prepare_window_of
from app.viewport.orientation_cube import OrientationCube
from app.viewport.placeholder import Ground, begin, import_heavy
from app.viewport.print_bar import PrintBar
from app.viewport.refine import FinePainter, completes

if TYPE_CHECKING:
    from app.scene.grips import Grips
    from app.scene.scene import Scene
    from app.state.presenter import Frame, Presenter
    from sgb_core.document.model import Document

# How long the hand rests before the picture is refined, in milliseconds.
REFINE_AFTER = 100


class SurfaceView(QWidget):
    """Shows frames; ``pose`` is where the viewer stands, moved by the user alone."""

    def __init__(self, presenter: Presenter, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._presenter = presenter
        self._frame: Frame | None = None
        self._generation: int | None = None
        self._refined = self._shut = False
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
        prepare_window_of(self)
        self.buttons = ViewportButtons(self, self)
        self.colour_key = ColourKey(self)
        self.print_bar = PrintBar(presenter, self)
        self.cube = OrientationCube(self.look_from, self._orbit_by_hand, self)
        self.hud = SurfaceHud(self)
        self.hand = SurfaceHand(presenter, self, self.hud)
        self._grips: Grips | None = None
        self.navigator: Navigator | None = None
        self._glide = Glide(self, self._glide_through)
        self._refine_timer = QTimer(self, singleShot=True, interval=REFINE_AFTER)
        self._refine_timer.timeout.connect(self._refine)
        self._painter = FinePainter(self._refine, self)
        self._loader: threading.Thread | None = None
        self._load_timer = QTimer(self, interval=15)
        self._load_timer.timeout.connect(self._build_when_loaded)
        theme.notifier().changed.connect(self._take_palette)

    def refresh(self, frame: Frame) -> None:
        """Show a frame: at once and plainly during a gesture, refined when the hand rests."""
        before, self._frame = self._frame, frame
        if before is not None and self.pose is not None:
            self.pose = self.pose.enlarged(factor_between(before.document, frame.document))
        self.buttons.show_state(frame.view)
        self.print_bar.show_state(frame)
        if self.scene is not None:
            if completes(before, frame) and not self._refine_timer.isActive():
                self._refine()
            else:
                self._show(frame)
            self.hand.refresh(frame)

    def fit(self, smooth: bool = True) -> None:
        """See all of the object, from where it is seen now."""
        if self.scene is not None and self.pose is not None:
            points = self.scene.points_to_fit()
            self._go_to(clear_pose(self.pose, points, self.buttons, self.cube), smooth)
            self._fitted = None if self._frame is None else self._frame.evaluation.document

    def set_view_direction(self, name: str) -> None:
        """See the object from one of :data:`STANDARD_VIEWS`; raises KeyError."""
        self.look_from(*STANDARD_VIEWS[name].direction)

    def look_from(self, azimuth: float, elevation: float) -> None:
        """See the object from a direction, in radians as :class:`Pose` has them."""
        if self.pose is not None:
            self._go_to(self.pose.turned_to(azimuth, elevation))

    def set_navigation_style(self, name: str) -> None:
        """Let the mouse do what it does in one of :data:`app.viewport.mouse_styles.STYLES`."""
        style = STYLES[name]
        if self.navigator is not None:
            self.navigator.take_style(style)

    def toggle_projection(self) -> None:
        """Change between perspective and parallel projection."""
        self._presenter.toggle_projection()

    def toggle_overlay(self, overlay: Overlay) -> None:
        """Show what is hidden, hide what is shown."""
        self._presenter.toggle_overlay(overlay)

    def size_in_pixels(self) -> tuple[int, int]:
        """Return the viewport's own (width, height) in pixels of the screen."""
        ratio = self.devicePixelRatioF()
        return max(1, round(self.width() * ratio)), max(1, round(self.height() * ratio))

    def picture(self, size: tuple[int, int], transparent: bool) -> bytes:
        """Return a PNG of the present view at any size, drawn off screen; nothing seen is lost."""
        from app.scene.offscreen import frame_png

        frame, scale = self._frame or self._presenter.frame, size[1] / max(1, self.height())
        pose = None if self.pose is None else self.pose.widened(self._aspect, size[0] / size[1])
        return frame_png(frame, size, pose, theme.current(), scale, transparent)

    def shut_down(self) -> None:
        """Let go of the graphics; nothing is drawn any more. To be called before closing."""
        self._shut = True
        self._glide.stop()
        self._refine_timer.stop()
        self._load_timer.stop()
        self._painter.wait()
        if self.plotter is not None:
            self.plotter.close()
            self.scene = None

    # The camera.

    def move_camera(self, pose: Pose) -> None:
        """See from ``pose``, drawn plainly until :meth:`hand_rested`."""
        self._glide.stop()
        self._fitted, self.pose = None, pose
        self._see_from(pose)
        self.hand.rest()

    def interrupt(self) -> None:
        """Stop a view change that is under way where it is."""
        if self._glide.active and self.scene is not None and self.scene.pose is not None:
            self.move_camera(replace(self.scene.pose, opening=1.0))
            self.hand_rested()

    def _go_to(self, pose: Pose, smooth: bool = True) -> None:
        """Let the picture move to ``pose``, which is where the viewer stands at once."""
        start = None if self.scene is None else self.scene.pose
        self.move_camera(pose)
        if smooth and start is not None and start.axis == pose.axis and wanted():
            self._see_from(start)
            self._glide.start(start, pose)
        self.hand_rested()

    def _see_from(self, pose: Pose) -> None:
        self.cube.show_pose(pose)
        if self.scene is not None:
            self.scene.see_from(pose)
            self.hand.show_dimensions()
            self._plain()
            self.plotter.update()

    def _glide_through(self, pose: Pose) -> None:
        self._see_from(pose)
        self.hand_rested()

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
            self.scene.see_from(self.pose)

    def _orbit_by_hand(self, dx: float, dy: float) -> None:
        if self.pose is not None:
            self.move_camera(orbited(self.pose, dx, dy))
            self.hand_rested()

    @property
    def _aspect(self) -> float:
        return max(1, self.width()) / max(1, self.height())

    # What the hand asks for.

    @property
    def frame(self) -> Frame | None:
        """The frame that is shown."""
        return self._frame

    @property
    def lens(self) -> Lens | None:
        """From where the picture is seen just now, and its size in logical pixels."""
        if self.scene is None or self.scene.pose is None:
            return None
        return Lens(self.scene.pose, float(self.plotter.width()), float(self.plotter.height()))

    def show_grips(self, grips: Grips) -> None:
        """Light up what can be grabbed or is held."""
        if self.scene is not None and (self._grips is None or not self._grips.same(grips)):
            self._grips = grips
            self.scene.show_grips(grips)
            self.plotter.update()

    # Drawing.

    def _show(self, frame: Frame) -> None:
        scene, axis = self.scene, frame.evaluation.surface.axis
        assert scene is not None
        self._show_plainly(scene, frame)
        self.colour_key.show_state(frame, scene.overlays.influence.largest)
        parallel = frame.view.projection == "parallel"
        if self.pose is None or frame.generation != self._generation:
            self._generation = frame.generation
            pose = standard_pose(axis, parallel=parallel)
            self.pose = clear_pose(pose, scene.points_to_fit(), self.buttons, self.cube)
            self._fitted = frame.evaluation.document
            self._glide.stop()
        if axis != self.pose.axis and not frame.dragging:
            self.pose = self.pose.carried_to(axis)
            self._glide.stop()
        if parallel != self.pose.parallel:
            self.pose = replace(self.pose, parallel=parallel)
            if scene.pose is not None and scene.pose.axis == axis and wanted():
                self._glide.start(scene.pose, self.pose)
        if not self._glide.active:
            scene.see_from(self.pose)
            self.cube.show_pose(self.pose)
        # What grows out of the view is followed until the user chooses one.
        fitted = None if frame.dragging else self._fitted
        if fitted is not None and fitted is not frame.document:
            tool, points = frame.view.tool, scene.points_to_fit()
            if tool != "select" or not self.pose.holds(points, self._aspect):
                self.fit()
        self._plain()
        self.plotter.update()
        self.hand_rested()

    def _plain(self) -> None:
        self._refine_timer.stop()
        self._resolution.move()
        scene, frame = self.scene, self._frame
        if scene and frame and (self._refined or scene.halved != self._resolution.coarse):
            self._show_plainly(scene, frame)

    def _show_plainly(self, scene: Scene, frame: Frame) -> None:
        self._refined = False
        scene.set_smooth(False)
        scene.halved = self._resolution.coarse
        scene.show_frame(frame, fine=False)

    def _refine(self) -> None:
        scene, frame = self.scene, self._frame
        if scene is None or frame is None or frame.dragging or self._refine_timer.isActive():
            return
        if not self._painter.is_ready(scene, frame):
            return
        self._refined = True
        self._resolution.rest()
        scene.show_frame(frame, fine=True)
        scene.set_smooth(True)
        self.plotter.update()

    def _take_palette(self, palette: theme.Palette) -> None:
        if self.scene is not None:
            self.scene.set_palette(palette)
            self.plotter.update()

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        if self._loader is None and not self._shut:
            self._loader = threading.Thread(target=import_heavy, daemon=True)
            # Only after the window has been painted once.
            QTimer.singleShot(0, self._load)

    def _load(self) -> None:
        if self._loader is not None and not self._shut:
            begin(self._loader)
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
        from app.scene.scene import Scene

        self.plotter = new_interactor(self)
        self.setFocusProxy(self.plotter)
        drawn = self.plotter.renderer
        self.scene = Scene(drawn, theme.current(), self.devicePixelRatioF(), quiet=True)
        self._resolution = DragResolution(self.plotter, self.scene)
        self.navigator = Navigator(self.plotter, self, self.hand)
        self._stack.addWidget(self.plotter)
        self._stack.setCurrentWidget(self.plotter)
        self.buttons.come_after(self.plotter)
        self.buttons.raise_()
        self.cube.raise_()
        if self._frame is not None:
            self._show(self._frame)

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self.buttons.adjustSize()
        self.buttons.move(self.width() - self.buttons.width() - 10, 10)
        self.colour_key.place()
        self.print_bar.place()
        self.cube.move(self.width() - self.cube.width() - 10, self.buttons.height() + 16)
        # While the window finds its size what was fitted stays so; an edited shape, or a camera
        # that the user has moved, is left as it is.
        if self._frame is not None and self._frame.document is self._fitted:
            self.fit(smooth=False)
