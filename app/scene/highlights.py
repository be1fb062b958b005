"""What the scene lights up: the range of a slider, and what the hand is about to grab."""

from __future__ import annotations

import numpy as np
from vtkmodules.vtkRenderingCore import vtkRenderer

from app.scene import shapes
from app.scene.actors import Array, LinePart, MarkPart, rgb
from app.scene.camera import Pose
from app.scene.grips import Grips
from app.state.view_state import Hover
from app.theme.palette import Palette
from sgb_core.curves import basis
from sgb_core.curves.parameter_fan import SLID, TOWARDS, parameter_fan
from sgb_core.surfaces.revolution import RevolutionSurface

# Intervals of one curve of the fan; with many segments fewer, they are small in the picture.
_PIECES = 40
_FEWEST = 12
# Length of an arrow's head as a part of its leg.
_HEAD = 0.16


class RangePart:
    """The picture that explains the method: leg, arrow, circle, and the fan of all curves.

    The fan depends on everything but the value of the parameter it belongs to: while that
    slider is dragged nothing here is written again.
    """

    def __init__(self) -> None:
        self.legs, self.arrows = LinePart(lift=10.0), LinePart(lift=12.0)
        self.circles = {1: LinePart(lift=10.0), 2: LinePart(lift=10.0)}
        self.fan, self.ends = LinePart(lift=2.5), LinePart(lift=3.0)
        self._written: tuple[object, ...] | None = None

    @property
    def lines(self) -> tuple[LinePart, ...]:
        """All parts."""
        return (*self.circles.values(), self.fan, self.ends, self.legs, self.arrows)

    def write(self, surface: RevolutionSurface, hover: Hover | None) -> None:
        """Show the range of a parameter, or of none."""
        if hover is None:
            self._written = None
            for part in self.lines:
                part.write([])
            return
        chosen = hover.segments(len(surface.profile))
        segments = [surface.profile.segments[k] for k in chosen]
        quartics = parameter_fan(segments, hover.parameter)
        turn = (surface.axis, surface.start, surface.sweep, surface.placement)
        written = (hover, *turn, quartics.tobytes())
        if written == self._written:
            return
        self._written = written
        points = shapes.in_profile_plane(surface, surface.profile.control_points)
        moved = SLID[hover.parameter]
        self.legs.write([points[k, leg : leg + 2] for k in chosen for leg in moved])
        spans = quartics[:, [0, -1]][:, :, [leg + 1 for leg in moved]]
        self.arrows.write(_arrows(surface, spans.swapaxes(1, 2).reshape(-1, 2, 2)))
        circles = shapes.circle_lines(surface)
        for which, part in self.circles.items():
            near = which in TOWARDS[hover.parameter]
            part.write([circles[which - 1, k] for k in chosen] if near else [])
        pieces = max(_FEWEST, _PIECES // max(1, len(chosen) // 2))
        weights = basis.bernstein(4, np.linspace(0.0, 1.0, pieces + 1))
        curves = shapes.in_profile_plane(surface, weights @ quartics)
        self.fan.write(list(curves[:, 1:-1].reshape(-1, pieces + 1, 3)))
        self.ends.write(list(curves[:, [0, -1]].reshape(-1, pieces + 1, 3)))

    def show(self, visible: bool) -> None:
        """Show or hide all of it."""
        for part in self.lines:
            part.show(visible)

    def style(self, palette: Palette) -> None:
        """Take the colours: the quartic's own, and those of the circles."""
        quartic = rgb(palette.quartic)
        self.legs.style(quartic, 0.5, opacity=0.75)
        self.arrows.style(quartic, 0.8)
        self.fan.style(quartic, 0.24, opacity=0.5)
        self.ends.style(quartic, 0.5, opacity=0.9)
        self.circles[1].style(rgb(palette.circle_p1), 0.45)
        self.circles[2].style(rgb(palette.circle_p2), 0.45)

    def set_pixel_ratio(self, ratio: float) -> None:
        """Set how many pixels of the picture one pixel of line width is."""
        widths = (3.0, 3.0, 1.3, 2.0, 6.0, 3.0)
        for part, width in zip(self.lines, widths, strict=True):
            part.set_width(width * ratio)


def _arrows(surface: RevolutionSurface, spans: Array) -> list[Array]:
    """Return arrow heads as polylines, at the far ends of (r, h) spans of shape (m, 2, 2)."""
    heads = []
    for start, end in spans:
        way = end - start
        if np.hypot(*way) > 1e-6 * surface.profile.size:
            across = np.array((-way[1], way[0]))
            wings = [end - _HEAD * (way + side * 0.5 * across) for side in (1.0, -1.0)]
            heads.append(np.stack([wings[0], end, wings[1]]))
    return list(shapes.in_profile_plane(surface, np.stack(heads))) if heads else []


class GripPart:
    """Draws grips; they are not part of a picture that is saved."""

    def __init__(self) -> None:
        self.held, self.chosen = MarkPart(shapes.ring(28, 0.74)), MarkPart(shapes.ring(28, 0.8))
        self.ends = MarkPart(shapes.disc())
        self.turn = LinePart(lift=8.0)

    @property
    def marks(self) -> tuple[MarkPart, ...]:
        """The parts that face the viewer."""
        return self.held, self.chosen, self.ends

    def write(self, grips: Grips) -> None:
        """Show these grips."""
        for part, places in zip(self.marks, (grips.held, grips.chosen, grips.ends), strict=True):
            part.write(places)
            part.show(True)
        self.turn.write(list(grips.lines))
        self.turn.show(True)

    def style(self, palette: Palette) -> None:
        """Take the colours."""
        self.held.style(rgb(palette.accent), 0.9)
        self.chosen.style(rgb(palette.selection), 0.6)
        self.ends.style(rgb(palette.accent), 0.45)
        self.turn.style(rgb(palette.accent), 0.5)

    def set_pixel_ratio(self, ratio: float) -> None:
        """Set how many pixels of the picture one pixel of line width is."""
        for part, size in zip(self.marks, (23.0, 20.0, 11.0), strict=True):
            part.set_size(size * ratio)
        self.turn.set_width(2.5 * ratio)


class Highlights:
    """Both kinds of light in one scene, drawn in its two layers."""

    def __init__(self, renderer: vtkRenderer, through: vtkRenderer) -> None:
        self.range, self.grips = RangePart(), GripPart()
        parts: tuple[LinePart | MarkPart, ...] = (
            *self.range.lines,
            *self.grips.marks,
            self.grips.turn,
        )
        for part in parts:
            renderer.AddActor(part.actor)
            through.AddActor(part.hidden_actor)
            part.show(False)

    def style(self, palette: Palette) -> None:
        """Take all colours from a theme."""
        self.range.style(palette)
        self.grips.style(palette)

    def set_pixel_ratio(self, ratio: float) -> None:
        """Set how many pixels of the picture one pixel of line width is."""
        self.range.set_pixel_ratio(ratio)
        self.grips.set_pixel_ratio(ratio)

    def face(self, pose: Pose, height_px: float) -> None:
        """Turn the marks to the viewer."""
        for part in self.grips.marks:
            if part.actor.GetVisibility():
                part.face(pose, height_px)
