"""What is drawn of the profile itself: generatrix, polygon, circles, marks and axis, in a table."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from vtkmodules.vtkRenderingCore import vtkRenderer

from app.scene import shapes
from app.scene.actors import Array, LinePart, MarkPart, SurfacePart, rgb
from app.scene.camera import Pose
from app.state.cut import Cut
from app.state.overlays import Overlay
from app.state.view_state import ViewState
from app.theme.palette import Palette
from sgb_core.document.evaluation import Evaluation
from sgb_core.surfaces.revolution import RevolutionSurface

# Parts of a hidden line's colour that shine through the surface.
HIDDEN = 0.32


@dataclass(frozen=True, slots=True)
class _Line:
    """Lines shown with an overlay; ``colour`` is a palette's name, ``width`` in pixels."""

    overlay: Overlay
    colour: str
    width: float
    lift: float = 0.0
    hidden: float = HIDDEN
    opacity: float = 1.0


@dataclass(frozen=True, slots=True)
class _Mark:
    """Glyphs shown with an overlay; ``colour`` is a palette's name, ``size`` in pixels."""

    overlay: Overlay
    colour: str
    size: float
    glyph: Callable[[], tuple[Array, Array]]
    hidden: float = HIDDEN


_LINES = {
    "generatrix": _Line(Overlay.GENERATRIX, "generatrix", 4.0, lift=4.0),
    "chosen_generatrix": _Line(Overlay.GENERATRIX, "selection", 4.5, lift=6.0),
    "offending": _Line(Overlay.GENERATRIX, "error", 4.5, lift=8.0, hidden=1.0),
    "polygon": _Line(Overlay.POLYGON, "polygon", 2.0, lift=2.0),
    "chosen_polygon": _Line(Overlay.POLYGON, "selection", 3.0, lift=2.0),
    "circles_p1": _Line(Overlay.CIRCLES, "circle_p1", 1.0, 1.0, hidden=0.12, opacity=0.45),
    "circles_p2": _Line(Overlay.CIRCLES, "circle_p2", 1.0, 1.0, hidden=0.12, opacity=0.45),
    "axis": _Line(Overlay.AXES, "axis", 1.3, hidden=0.5),
}
_MARKS = {
    "stars": _Mark(Overlay.CIRCLES, "circle_p1", 10.0, shapes.star, hidden=0.18),
    "rings": _Mark(Overlay.CIRCLES, "circle_p2", 9.0, shapes.ring, hidden=0.18),
    "points_p1": _Mark(Overlay.POLYGON, "circle_p1", 15.0, shapes.star),
    "points_p2": _Mark(Overlay.POLYGON, "circle_p2", 13.0, shapes.ring),
    "ends": _Mark(Overlay.POLYGON, "polygon", 8.0, shapes.disc),
    "quartic": _Mark(Overlay.QUARTIC, "quartic", 8.0, shapes.diamond),
}


class ProfileParts:
    """The ``lines`` and ``marks`` of one scene by name.

    They are drawn in ``renderer``, and faintly in ``through``, a layer that nothing hides.
    """

    def __init__(self, renderer: vtkRenderer, through: vtkRenderer) -> None:
        self.lines = {name: LinePart(lift=row.lift) for name, row in _LINES.items()}
        self.marks = {name: MarkPart(row.glyph()) for name, row in _MARKS.items()}
        self._control: tuple[object, ...] | None = None
        parts: list[LinePart | MarkPart] = [*self.lines.values(), *self.marks.values()]
        for part in parts:
            renderer.AddActor(part.actor)
            through.AddActor(part.hidden_actor)

    def write(self, evaluation: Evaluation) -> None:
        """Show another shape; what depends on the chosen segment is :meth:`write_chain`'s."""
        surface = evaluation.surface
        profile, lines, marks = surface.profile, self.lines, self.marks
        quartics = shapes.in_profile_plane(surface, profile.quartics[:, 1:4])
        marks["quartic"].write(quartics.reshape(-1, 3))
        lines["offending"].write(list(shapes.offending_runs(evaluation)))
        turn = (surface.axis, surface.start, surface.sweep, surface.placement)
        control = (profile.control_points.tobytes(), *turn)
        # The four sliders move no control point.
        if control != self._control:
            self._control = control
            self._write_control(surface)

    def _write_control(self, surface: RevolutionSurface) -> None:
        """Show what follows from the control points alone."""
        profile, lines, marks = surface.profile, self.lines, self.marks
        points = shapes.in_profile_plane(surface, profile.control_points)
        circles = shapes.circle_lines(surface)
        lines["circles_p1"].write(list(circles[0]))
        lines["circles_p2"].write(list(circles[1]))
        placed = shapes.circle_marks(surface)
        rooms = 0.42 * np.linalg.norm(placed[:, :, 1] - placed[:, :, 0], axis=-1)
        for name, places, room in zip(("stars", "rings"), placed, rooms, strict=True):
            marks[name].write(places.reshape(-1, 3), np.repeat(room, places.shape[1]))
        marks["points_p1"].write(points[:, 1])
        marks["points_p2"].write(points[:, 2])
        marks["ends"].write(points[:, [0, 3]].reshape(-1, 3))
        lines["axis"].write(list(shapes.axis_line(surface)))

    def write_chain(self, surface: RevolutionSurface, level: SurfacePart, segment: int) -> None:
        """Show curve and polygon with one segment chosen; the curve is the level's first column."""
        grid = level.grid
        first = grid.points.reshape(len(surface.profile), -1, grid.columns, 3)[:, :, 0]
        # With one segment there is nothing to tell it apart from.
        chosen_one = segment if len(surface.profile) > 1 else None
        legs = shapes.in_profile_plane(surface, surface.profile.control_points)
        for runs, name in ((first, "generatrix"), (legs, "polygon")):
            plain, chosen = self.lines[name], self.lines[f"chosen_{name}"]
            plain.write([run for k, run in enumerate(runs) if k != chosen_one])
            chosen.write([run for k, run in enumerate(runs) if k == chosen_one])

    def show(self, view: ViewState) -> None:
        """Show what is switched on; a section is drawn without the circles across it."""
        for parts, rows in ((self.lines, _LINES), (self.marks, _MARKS)):
            for name, row in rows.items():
                across = row.overlay is Overlay.CIRCLES and view.cut is Cut.SECTION
                parts[name].show(view.shows(row.overlay) and not across)

    def style(self, palette: Palette) -> None:
        """Take all colours from a theme; :meth:`show` is to follow."""
        for name, line in _LINES.items():
            self.lines[name].style(rgb(getattr(palette, line.colour)), line.hidden, line.opacity)
        for name, mark in _MARKS.items():
            self.marks[name].style(rgb(getattr(palette, mark.colour)), mark.hidden)

    def set_pixel_ratio(self, ratio: float) -> None:
        """Set how many pixels of the picture one pixel of line width is."""
        for name, line in _LINES.items():
            self.lines[name].set_width(line.width * ratio)
        for name, mark in _MARKS.items():
            self.marks[name].set_size(mark.size * ratio)

    def face(self, pose: Pose, height_px: float) -> None:
        """Turn the marks that are seen to the viewer; ``height_px`` is the whole picture's."""
        for part in self.marks.values():
            if part.actor.GetVisibility():
                part.face(pose, height_px)

    @property
    def shown_positions(self) -> list[Array]:
        """The points of the lines that are shown, each (P, 3)."""
        return [part.positions for part in self.lines.values() if part.actor.GetVisibility()]
