"""What is laid over the surface on demand: another state, a meridian, the colours of influence."""

from __future__ import annotations

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkRenderingCore import vtkRenderer

# Imported for its side effect: it says where colour tables come from.
import resources.library  # noqa: F401
from app.scene import shapes
from app.scene.actors import Array, LinePart, SurfacePart, rgb
from app.state.view_state import ViewState
from app.theme.palette import Palette
from sgb_core.document.appearance.colour_maps import map_values
from sgb_core.document.appearance.colour_tables import colours, scale_of
from sgb_core.document.appearance.model import ColourMap, MapKind
from sgb_core.surfaces.revolution import RevolutionSurface

# The other state as a net: so many meridians in a full turn, and a parallel at each joint.
MERIDIANS = 12
_ALONG = 24
_AROUND = 72


class SceneOverlays:
    """Parts that are mostly off; each is written only when what it shows has changed."""

    def __init__(self, renderer: vtkRenderer, through: vtkRenderer) -> None:
        self.ghost = LinePart(lift=3.0)
        self.meridian = LinePart(lift=9.0)
        for part in (self.ghost, self.meridian):
            renderer.AddActor(part.actor)
            through.AddActor(part.hidden_actor)
        self.influence = InfluencePaint()
        self._ghosted: RevolutionSurface | None = None
        self._meridian_key: tuple[object, ...] | None = None

    def write(
        self,
        surface: RevolutionSurface,
        level: SurfacePart,
        view: ViewState,
        compared: RevolutionSurface | None,
    ) -> None:
        """Show what ``view`` asks for over a surface; ``compared`` is the other state."""
        if compared is not self._ghosted:
            self._ghosted = compared
            self.ghost.write([] if compared is None else net(compared))
        self.ghost.show(compared is not None)
        key = (surface, view.angle)
        if self._meridian_key is None or any(
            a is not b for a, b in zip(key, self._meridian_key, strict=True)
        ):
            self._meridian_key = key
            self.meridian.write(_meridian(surface, view.angle))
        self.meridian.show(view.angle is not None)
        self.influence.write(surface, level, view)

    def style(self, palette: Palette) -> None:
        """Take all colours from a theme."""
        self.ghost.style(rgb(palette.compare), 0.35, opacity=0.85)
        self.meridian.style(rgb(palette.accent), 0.5)

    def set_pixel_ratio(self, ratio: float) -> None:
        """Set how many pixels of the picture one pixel of line width is."""
        self.ghost.set_width(1.3 * ratio)
        self.meridian.set_width(3.0 * ratio)


class InfluencePaint:
    """Colours the surface by how far each point moves per unit of a shape parameter.

    ``largest`` is the greatest influence of what was last painted, in the document's unit per
    unit of the parameter; 0 where nothing moves.
    """

    def __init__(self) -> None:
        self.largest = 0.0
        self._painted: dict[SurfacePart, tuple[object, ...]] = {}
        self._buffers: dict[SurfacePart, Array] = {}

    def write(self, surface: RevolutionSurface, level: SurfacePart, view: ViewState) -> None:
        """Paint a level, or take the paint off."""
        mapper = level.actor.GetMapper()
        if view.influence is None:
            if level in self._painted:
                del self._painted[level], self._buffers[level]
                mapper.ScalarVisibilityOff()
                mapper.GetInput().GetPointData().SetScalars(None)
            return
        shown = ColourMap(MapKind.INFLUENCE, parameter=view.influence, segment=view.influenced)
        key = (surface, shown)
        if self._painted.get(level) == key:
            return
        fresh = level not in self._buffers
        self._forget_gone(level)
        self._painted[level] = key
        rows, columns = level.grid.rows, level.grid.columns
        values = map_values(surface, shown, level.grid.per_segment, columns - 1)
        self.largest = float(values.max(initial=0.0))
        painted = colours(scale_of(shown, 0.0, self.largest), values / (self.largest or 1.0))
        if fresh:
            self._buffers[level] = np.zeros((rows * columns, 3), np.uint8)
        buffer = self._buffers[level]
        buffer.reshape(rows, columns, 3)[:] = painted
        data = mapper.GetInput().GetPointData()
        if fresh:
            data.SetScalars(numpy_to_vtk(buffer, deep=False))
            mapper.SetColorModeToDirectScalars()
            mapper.ScalarVisibilityOn()
        data.GetScalars().Modified()

    def _forget_gone(self, level: SurfacePart) -> None:
        """Let go of levels of another shape, which are not drawn any more."""
        gone = [each for each in self._painted if each.shape[0] != level.shape[0]]
        for each in gone:
            del self._painted[each], self._buffers[each]


def net(surface: RevolutionSurface) -> list[Array]:
    """Return meridians and the parallels of the joints of a surface, each (count, 3)."""
    count = max(1, round(MERIDIANS * surface.sweep / (2.0 * np.pi)))
    angles = surface.angles(count)
    if surface.is_full_turn:
        angles = angles[:-1]
    around = surface.angles(max(8, round(_AROUND * surface.sweep / (2.0 * np.pi))))
    meridians = shapes.meridians(surface, angles, _ALONG)
    ends = surface.profile.control_points[:, [0, 3]].reshape(-1, 2)
    # A joint's two ends are one point mostly; a parallel on the axis is none.
    rings = np.unique(np.round(ends, 12), axis=0)
    parallels = shapes.place(surface, rings[:, :1], rings[:, 1:], around)
    return [*meridians, *parallels]


def _meridian(surface: RevolutionSurface, degrees: float | None) -> list[Array]:
    if degrees is None or np.deg2rad(degrees) > surface.sweep + 1e-9:
        return []
    angle = surface.start + np.deg2rad(np.array([degrees]))
    return list(shapes.meridians(surface, angle, _ALONG))
