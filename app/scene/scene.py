"""The 3-D picture: an evaluated document as VTK actors, updated in place, on screen and off."""

from __future__ import annotations

from typing import TYPE_CHECKING
from weakref import WeakSet

import numpy as np

# Imported for their side effect: they register the OpenGL implementation.
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
from numpy.typing import NDArray
from vtkmodules.vtkRenderingCore import vtkLight, vtkProperty, vtkRenderer

from app.scene import shapes
from app.scene.actors import (
    COARSE,
    FINE,
    HALVED,
    LIVE,
    MAGNIFIED,
    MAGNIFIED_FROM,
    Array,
    Detail,
    SurfacePart,
)
from app.scene.body import BodyScene
from app.scene.camera import Pose, standard_pose
from app.scene.grips import Grips
from app.scene.highlights import Highlights
from app.scene.look import SceneLook
from app.scene.overlays import SceneOverlays
from app.scene.print_path import PathPart
from app.scene.profile_parts import ProfileParts
from app.scene.reference import ReferencePart
from app.scene.theory_lines import TheoryLines
from app.state.overlays import Overlay
from app.state.view_state import ViewState
from app.theme.palette import Palette
from sgb_core.document.body_state import BodyState
from sgb_core.document.evaluation import Evaluation
from sgb_core.document.model import Document
from sgb_core.surfaces.revolution import RevolutionSurface

if TYPE_CHECKING:
    from app.state.presenter import Frame
    from app.state.printed import Printed

# Samples of a pixel in a smooth picture.
SAMPLES = 4
# Of more rows than this every second, or so, tells as well where the surface ends.
FITTED_ROWS = 1000


class Scene:
    """Everything drawn in one renderer; ``pose`` says from where it is seen.

    Lines and marks are also drawn, faintly, in a second layer that the surface cannot hide.
    ``pixel_ratio`` is how many pixels of the picture one pixel of line width is; in a ``quiet``
    scene, that of a window, marks give way to the shape where they crowd, and what is not magnified
    and long chains are drawn with fewer quads. ``halved`` says that pictures that are not fine are
    drawn at half the resolution.
    """

    def __init__(
        self,
        renderer: vtkRenderer,
        palette: Palette,
        pixel_ratio: float = 1.0,
        *,
        quiet: bool = False,
    ) -> None:
        self.renderer = renderer
        self._pose: Pose | None = None
        self._document: Document | None = None
        self._levels: dict[bool, SurfacePart] = {}
        # Those that hold the present surface.
        self._written: WeakSet[SurfacePart] = WeakSet()
        self._surface: RevolutionSurface | None = None
        self._view: ViewState | None = None
        self._fine = False
        self._quiet = quiet
        self.halved = False
        self._ball: tuple[NDArray[np.float64], float] = (np.zeros(3), 1.0)
        self._front, self._back, self._net = vtkProperty(), vtkProperty(), vtkProperty()
        self._set_up_layers()
        self.profile = ProfileParts(renderer, self._through, quiet=quiet)
        self.lights = Highlights(renderer, self._through)
        self.overlays = SceneOverlays(renderer, self._through)
        self.theory = TheoryLines(renderer, self._through)
        self.reference = ReferencePart(renderer)
        self.look = SceneLook(renderer, self._front, self._back, self._net)
        self.solid = BodyScene(renderer, self._front, self._back)
        self.path = PathPart(renderer)
        self.set_pixel_ratio(pixel_ratio)
        self.set_palette(palette)

    def _set_up_layers(self) -> None:
        renderer = self.renderer
        camera = renderer.GetActiveCamera()
        renderer.RemoveAllLights()
        renderer.AutomaticLightCreationOff()
        renderer.RemoveCuller(renderer.GetCullers().GetLastItem())
        renderer.SetTwoSidedLighting(True)
        key = vtkLight()
        key.SetLightTypeToCameraLight()
        key.SetPosition(-0.45, 0.65, 1.0)
        key.SetFocalPoint(0.0, 0.0, 0.0)
        key.PositionalOff()
        renderer.AddLight(key)
        self._through = vtkRenderer()
        self._through.SetLayer(1)
        self._through.SetActiveCamera(camera)
        self._through.InteractiveOff()
        self._through.AutomaticLightCreationOff()
        self._through.RemoveCuller(self._through.GetCullers().GetLastItem())
        for layer in (renderer, self._through):
            # Its passes over the whole picture cost more than all else that is drawn.
            layer.SetUseOIT(False)
        window = renderer.GetRenderWindow()
        window.SetNumberOfLayers(2)
        window.AddRenderer(self._through)
        renderer.AddObserver("StartEvent", self._before_drawing)

    # What is shown.

    def show_frame(self, frame: Frame, *, fine: bool) -> None:
        """Show all of a frame."""
        view, compared = frame.view, frame.compared
        self.update(
            frame.evaluation,
            view,
            fine=fine,
            compared=compared,
            body=frame.body,
            printed=frame.printed,
        )

    def update(
        self,
        evaluation: Evaluation,
        view: ViewState,
        *,
        fine: bool = False,
        compared: Evaluation | None = None,
        body: BodyState | None = None,
        printed: Printed | None = None,
    ) -> None:
        """Show an evaluation; only what differs from what is shown is written.

        ``compared`` is another state, laid over it as a ghost; ``body`` what is drawn in the
        surface's place, and ``printed`` in the place of both.
        """
        surface = evaluation.surface
        reshaped = self._surface is None or evaluation.document is not self._document
        selected = reshaped or self._view is None or view.segment != self._view.segment
        self._document = evaluation.document
        self._fine = fine
        if reshaped:
            self._surface = surface
            self._written.clear()
            self._measure(surface)
        assert self._surface is not None
        level = self._write_level(self._surface, fine)
        if reshaped:
            self.profile.write(evaluation)
        if reshaped or self._view is None or view.hover != self._view.hover:
            self.lights.range.write(self._surface, view.hover)
        if selected:
            self.profile.write_chain(self._surface, level, view.segment)
        other = None if compared is None else compared.surface
        self.overlays.write(self._surface, level, view, other)
        self.theory.write(self._surface, view)
        self.reference.update(evaluation.document.reference, self._surface)
        hurried, painted = self.halved and not fine, view.influence is None
        self.look.update(evaluation, level, fine, hurried, painted=painted)
        self._view = view
        self._show(view)
        self.solid.update(body, view, level.actor, self._surface)
        self.look.dress_solid(self.solid, level)
        self.look.shade(evaluation, level, self.solid, view, fine)
        self.path.update(printed, evaluation.document, view, surface, fine=fine)
        if self.path.shown:
            level.actor.VisibilityOff()
            level.net_actor.VisibilityOff()
            self.solid.hide()

    def _write_level(self, surface: RevolutionSurface, fine: bool) -> SurfacePart:
        segments = len(surface.profile)
        per_segment, around = self._detail(segments, fine).intervals(segments, surface.sweep)
        level, other = self._levels.get(fine), self._levels.get(not fine)
        shape = (segments, per_segment, around)
        if level is None or level.shape != shape:
            if level is not None and level is not other:
                self.renderer.RemoveActor(level.actor)
                self.renderer.RemoveActor(level.net_actor)
            # A very long chain is drawn as finely in motion: one level serves for both.
            shared = other is not None and other.shape == shape
            level = other if other is not None and shared else self._new_level(*shape)
            self._levels[fine] = level
        if level not in self._written:
            level.grid.write(surface)
            level.written()
            self._written.add(level)
        return level

    def _detail(self, segments: int, fine: bool) -> Detail:
        """Return how finely the surface is drawn; a very long chain moves as finely as it rests."""
        if not fine:
            short = segments * HALVED.least_per_segment < HALVED.most_rows
            return HALVED if self.halved and short else COARSE
        if not self._quiet:
            return FINE
        return MAGNIFIED if self._radius_in_pixels() > MAGNIFIED_FROM else LIVE

    def _radius_in_pixels(self) -> float:
        """Return with which radius all that can be drawn appears in the picture."""
        if self._pose is None:
            return 0.0
        height = self.renderer.GetRenderWindow().GetSize()[1]
        return float(self._ball[1] / self._pose.parallel_scale * height / 2.0)

    def _new_level(self, segments: int, per_segment: int, around: int) -> SurfacePart:
        rows_at = max(1, per_segment // max(2, 16 // segments))
        net = shapes.net_lines(segments, per_segment, around, rows_at, max(1, around // 32))
        level = SurfacePart((segments, per_segment, around), net)
        level.actor.SetProperty(self._front)
        level.actor.SetBackfaceProperty(self._back)
        level.net_actor.SetProperty(self._net)
        self.renderer.AddActor(level.actor)
        self.renderer.AddActor(level.net_actor)
        return level

    def _measure(self, surface: RevolutionSurface) -> None:
        """Note the ball that holds all that can be drawn, for the clipping range."""
        points = surface.profile.control_points.reshape(-1, 2)
        low, high = points[:, 1].min(), points[:, 1].max()
        centre = shapes.place(surface, np.zeros(1), np.array([(low + high) / 2]), np.zeros(1))[0]
        reach = max(high - low, np.abs(points[:, 0]).max())
        radius = np.hypot(np.abs(points[:, 0]).max(), (high - low) / 2 + 0.2 * reach)
        self._ball = (centre, max(float(radius) * 1.05, 1e-12))

    def _show(self, view: ViewState) -> None:
        solid = self._surface is not None and shapes.is_closed(self._surface)
        self._front.SetBackfaceCulling(solid)
        shown = self._levels[self._fine]
        for level in self._levels.values():
            level.actor.SetVisibility(view.shows(Overlay.SURFACE) and level is shown)
            level.net_actor.SetVisibility(view.shows(Overlay.MESH) and level is shown)
        self.profile.show(view)
        self.lights.range.show(view.hover is not None)

    def show_grips(self, grips: Grips) -> None:
        """Light up what the hand can grab or holds, and the marks of that segment."""
        self.profile.point_at(grips.segment)
        self.lights.grips.write(grips)

    # How it looks.

    def paint_rows(self, colours: Array) -> None:
        """Paint the surface as it is shown now, its rows along the profile: (rows, 3), 0 to 1."""
        self._levels[self._fine].paint_rows(colours)

    def set_palette(self, palette: Palette) -> None:
        """Take all colours from a theme."""
        self.palette = palette
        self.look.set_palette(palette)
        self.solid.set_palette(palette)
        self.profile.style(palette)
        self.lights.style(palette)
        self.overlays.style(palette)
        self.theory.style(palette)
        self.path.style(palette)
        if self._view is not None:
            self._show(self._view)

    def set_pixel_ratio(self, ratio: float) -> None:
        """Set how many pixels of the picture one pixel of line width is."""
        self.profile.set_pixel_ratio(ratio)
        self.lights.set_pixel_ratio(ratio)
        self.overlays.set_pixel_ratio(ratio)
        self.theory.set_pixel_ratio(ratio)
        self.look.set_pixel_ratio(ratio)
        self.path.set_pixel_ratio(ratio)

    def set_smooth(self, smooth: bool) -> None:
        """Draw edges antialiased, or plainly and quickly."""
        self.renderer.GetRenderWindow().SetMultiSamples(SAMPLES if smooth else 0)

    # From where it is seen.

    @property
    def pose(self) -> Pose | None:
        """From where it is seen; None before that was said."""
        return self._pose

    def see_from(self, pose: Pose) -> None:
        """See all from ``pose`` in the pictures that follow."""
        self._pose = pose

    def points_to_fit(self) -> Array:
        """Return the points of all that is shown, shape (P, 3); of very many rows some."""
        grid = self._levels[self._fine].grid
        rows = grid.points.reshape(grid.rows, grid.columns, 3)[:: max(1, grid.rows // FITTED_ROWS)]
        return np.concatenate([rows.reshape(-1, 3), *self.profile.shown_positions])

    def fit(self, aspect: float, pose: Pose | None = None) -> Pose:
        """Fit all that is shown into a picture of width over height ``aspect``."""
        assert self._surface is not None
        start = pose or self._pose or standard_pose(self._surface.axis)
        self._pose = start.fitted(self.points_to_fit(), aspect)
        return self._pose

    def pick(self, pose: Pose, x: float, y: float) -> tuple[float, float, float] | None:
        """Return the point of the surface seen at (x, y), in half-heights from the middle.

        None beside the surface.
        """
        grid = self._levels[self._fine].grid
        return pose.seen_at(grid.points, grid.quads, x, y)

    def _before_drawing(self, *_event: object) -> None:
        if self._pose is None:
            return
        centre, radius = self._ball
        reach = max(radius * self.look.reach, self.path.reach(centre))
        self._pose.apply(self.renderer.GetActiveCamera(), centre, reach)
        height = self.renderer.GetRenderWindow().GetSize()[1]
        self.profile.face(self._pose, height)
        self.lights.face(self._pose, height)
