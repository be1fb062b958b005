"""What the paper builds the surface from, as lines on it: circles of ends, (17), steps of t."""

from __future__ import annotations

from math import pi

import numpy as np
from vtkmodules.vtkRenderingCore import vtkRenderer

from app.scene import shapes
from app.scene.actors import Array, LinePart, rgb
from app.state.cut import Cut
from app.state.overlays import Overlay
from app.state.view_state import ViewState
from app.theme.palette import Palette
from sgb_core.surfaces.revolution import RevolutionSurface
from sgb_core.surfaces.turn import turn_of

# Steps of t over a full turn, and intervals of each segment between parallels of its net.
STEPS = 48
ROWS = 6
_ALONG = 48
_AROUND = 96
_COLOURS = {
    Overlay.ENDS: ("polygon", 1.6),
    Overlay.RATIONAL_MESH: ("quartic", 1.0),
    Overlay.INTERPOLATED: ("text", 2.4),
}


class TheoryLines:
    """Lines that are mostly off; each kind is written only while it is shown."""

    def __init__(self, renderer: vtkRenderer, through: vtkRenderer) -> None:
        self.parts = {overlay: LinePart(lift=2.0) for overlay in _COLOURS}
        self._written: dict[Overlay, RevolutionSurface] = {}
        for part in self.parts.values():
            renderer.AddActor(part.actor)
            through.AddActor(part.hidden_actor)

    def write(self, surface: RevolutionSurface, view: ViewState) -> None:
        """Show what ``view`` asks for; a section is drawn without lines across it."""
        for overlay, part in self.parts.items():
            shown = view.shows(overlay) and view.cut is not Cut.SECTION
            if shown and self._written.get(overlay) is not surface:
                self._written[overlay] = surface
                part.write(_MAKERS[overlay](surface))
            part.show(shown)

    def style(self, palette: Palette) -> None:
        """Take all colours from a theme."""
        for overlay, (colour, _) in _COLOURS.items():
            self.parts[overlay].style(rgb(getattr(palette, colour)), 0.2)

    def set_pixel_ratio(self, ratio: float) -> None:
        """Set how many pixels of the picture one pixel of line width is."""
        for overlay, (_, width) in _COLOURS.items():
            self.parts[overlay].set_width(width * ratio)


def end_circles(surface: RevolutionSurface) -> list[Array]:
    """Return the circles, or arcs, of all P0 and P3, each (count, 3); a joint's is one."""
    ends = surface.profile.control_points[:, [0, 3]].reshape(-1, 2)
    rings = np.unique(np.round(ends, 12), axis=0)
    around = surface.angles(max(8, round(_AROUND * surface.sweep / (2.0 * pi))))
    return list(shapes.place(surface, rings[:, :1], rings[:, 1:], around))


def interpolated_curves(surface: RevolutionSurface) -> list[Array]:
    """Return A0, A½ of both halves and A1 of (17), as far as the sweep goes, each (count, 3).

    They stand at θ = 0, ±π/2 and π from the profile plane; between them leads (24).
    """
    turned = np.array([0.0, 0.5, 1.0, 1.5]) * pi
    turned = turned[turned <= surface.sweep + 1e-9]
    return list(shapes.meridians(surface, surface.start + turned, _ALONG))


def rational_net(surface: RevolutionSurface) -> list[Array]:
    """Return meridians at equal steps of the parameter t of (24), and parallels at equal s."""
    count = max(4, round(STEPS * surface.sweep / (2.0 * pi)))
    turned = turn_of(surface, count, "rational")
    meridians = shapes.meridians(surface, surface.start + turned.angles, _ALONG)
    # Between the meridians the parallels need angles of their own to be round.
    around = np.union1d(turned.angles, np.linspace(0.0, surface.sweep, _AROUND + 1))
    rows = shapes.meridians(surface, surface.start + around, ROWS)
    parallels = rows.reshape(len(around), -1, 3).swapaxes(0, 1)
    return [*meridians, *parallels]


_MAKERS = {
    Overlay.ENDS: end_circles,
    Overlay.RATIONAL_MESH: rational_net,
    Overlay.INTERPOLATED: interpolated_curves,
}
