"""What is drawn of the profile itself: generatrix, polygon, circles, marks and axis, in a table."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray
from vtkmodules.vtkRenderingCore import vtkRenderer

from app.hand.density import ENDS, leg_lengths, presence
from app.scene import shapes
from app.scene.actors import Array, LinePart, MarkPart, SurfacePart, rgb
from app.scene.camera import Pose
from app.state.cut import Cut
from app.state.overlays import Overlay
from app.state.view_state import ViewState
from app.theme.palette import Palette
from sgb_core.document.evaluation import Evaluation
from sgb_core.surfaces.revolution import RevolutionSurface
from sgb_core.values import dataclass

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


# How much of a segment's spacing its legs and its circles have: circles go all around the shape,
# and take more room.
ROOM = (1.0, 0.5)

_LINES = {
    "generatrix": _Line(Overlay.GENERATRIX, "generatrix", 4.0, lift=4.0),
    "chosen_generatrix": _Line(Overlay.GENERATRIX, "selection", 4.5, lift=6.0),
    "offending": _Line(Overlay.GENERATRIX, "error", 4.5, lift=8.0, hidden=1.0),
    "polygon": _Line(Overlay.POLYGON, "polygon", 2.0, lift=2.0),
    "chosen_polygon": _Line(Overlay.POLYGON, "selection", 3.0, lift=2.0),
    "circles_p1": _Line(Overlay.CIRCLES, "circle_p1", 1.0, 1.0, hidden=0.12, opacity=0.45),
    "circles_p2": _Line(Overlay.CIRCLES, "circle_p2", 1.0, 1.0, hidden=0.12, opacity=0.45),
    "quiet_circles_p1": _Line(Overlay.CIRCLES, "circle_p1", 1.0, 1.0, hidden=0.0, opacity=0.25),
    "quiet_circles_p2": _Line(Overlay.CIRCLES, "circle_p2", 1.0, 1.0, hidden=0.0, opacity=0.25),
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

    They are drawn in ``renderer``, and faintly in ``through``, a layer that nothing hides. In a
    ``quiet`` scene only the segment that is chosen or pointed at has all its marks; those of the
    others are faint, smaller as they crowd, and then gone.
    """

    def __init__(self, renderer: vtkRenderer, through: vtkRenderer, *, quiet: bool) -> None:
        self._quiet = quiet
        self._ratio = 1.0
        self._lit: frozenset[int] = frozenset()
        self._pointed: int | None = None
        self._chosen = 0
        self._legs: Array = np.zeros((0, 4, 3))
        self._circles: Array = np.zeros((2, 0, 0, 3))
        self._spacing: Array = np.zeros(0)
        self._roomy: tuple[object, ...] | None = None
        self._visible: dict[str, bool] = {}
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
        self._legs, self._circles = points, shapes.circle_lines(surface)
        self._spacing = leg_lengths(points)
        placed = shapes.circle_marks(surface)
        rooms = 0.42 * np.linalg.norm(placed[:, :, 1] - placed[:, :, 0], axis=-1)
        for name, places, room in zip(("stars", "rings"), placed, rooms, strict=True):
            marks[name].write(places.reshape(-1, 3), np.repeat(room, places.shape[1]))
        marks["points_p1"].write(points[:, 1])
        marks["points_p2"].write(points[:, 2])
        marks["ends"].write(points[:, [0, 3]].reshape(-1, 3))
        lines["axis"].write(list(shapes.axis_line(surface)))
        self._roomy = None

    def write_chain(self, surface: RevolutionSurface, level: SurfacePart, segment: int) -> None:
        """Show curve and polygon with one segment chosen; the curve is the level's first column."""
        grid = level.grid
        first = grid.points.reshape(len(surface.profile), -1, grid.columns, 3)[:, :, 0]
        # With one segment there is nothing to tell it apart from.
        chosen_one = segment if len(surface.profile) > 1 else None
        plain, chosen = self.lines["generatrix"], self.lines["chosen_generatrix"]
        plain.write([run for k, run in enumerate(first) if k != chosen_one])
        chosen.write([run for k, run in enumerate(first) if k == chosen_one])
        self._chosen = segment
        self.point_at(self._pointed)
        if not self._quiet:
            self._write_density(np.ones((2, len(first)), dtype=bool))

    def point_at(self, segment: int | None) -> None:
        """Show the marks of a segment in full, besides the chosen one's; None for no other."""
        self._pointed = segment
        self._lit = frozenset((self._chosen,) if segment is None else (self._chosen, segment))
        self._roomy = None

    def _write_density(self, roomy: NDArray[np.bool_]) -> None:
        """Show legs and circles of lit segments, and where there is room: ``roomy`` is (2, n)."""
        count = len(self._legs)
        lit = {k for k in range(count) if k in self._lit or not self._quiet}
        legs, rings = ([k for k in range(count) if k in lit or row[k]] for row in roomy)
        for name, circles in zip(("circles_p1", "circles_p2"), self._circles, strict=True):
            self._rewrite(name, [circles[k] for k in rings if k in lit])
            self._rewrite(f"quiet_{name}", [circles[k] for k in rings if k not in lit])
        chosen = {self._chosen} if count > 1 else set()
        self._rewrite("polygon", [self._legs[k] for k in legs if k not in chosen])
        self._rewrite("chosen_polygon", [self._legs[k] for k in legs if k in chosen])
        if self._quiet:
            room = self._spacing / self._ratio
            spacing = np.where([k in lit for k in range(count)], np.inf, room)
            self.marks["ends"].crowd(np.repeat(ENDS * spacing, 2))
            self.marks["quartic"].crowd(np.repeat(spacing, 3))
            for name in ("points_p1", "points_p2"):
                self.marks[name].crowd(spacing)
            for name in ("stars", "rings"):
                each = self.marks[name].count // max(count, 1)
                self.marks[name].crowd(np.repeat(ROOM[1] * spacing, each))

    def _rewrite(self, name: str, runs: list[Array]) -> None:
        part = self.lines[name]
        part.write(runs)
        part.show(self._visible.get(name, False))

    def show(self, view: ViewState) -> None:
        """Show what is switched on; a section is drawn without the circles across it."""
        for parts, rows in ((self.lines, _LINES), (self.marks, _MARKS)):
            for name, row in rows.items():
                across = row.overlay is Overlay.CIRCLES and view.cut is Cut.SECTION
                seen = view.shows(row.overlay) and not across
                if parts is self.lines:
                    self._visible[name] = seen
                parts[name].show(seen)

    def style(self, palette: Palette) -> None:
        """Take all colours from a theme; :meth:`show` is to follow."""
        for name, line in _LINES.items():
            self.lines[name].style(rgb(getattr(palette, line.colour)), line.hidden, line.opacity)
        for name, mark in _MARKS.items():
            self.marks[name].style(rgb(getattr(palette, mark.colour)), mark.hidden)

    def set_pixel_ratio(self, ratio: float) -> None:
        """Set how many pixels of the picture one pixel of line width is."""
        self._ratio, self._roomy = ratio, None
        for name, line in _LINES.items():
            self.lines[name].set_width(line.width * ratio)
        for name, mark in _MARKS.items():
            self.marks[name].set_size(mark.size * ratio)

    def face(self, pose: Pose, height_px: float) -> None:
        """Turn the marks that are seen to the viewer; ``height_px`` is the whole picture's."""
        if self._quiet and len(self._spacing):
            pixel = 2.0 * pose.parallel_scale * self._ratio / height_px
            roomy = np.stack([presence(part * self._spacing / pixel) > 0.0 for part in ROOM])
            key = (roomy.tobytes(), self._lit)
            if key != self._roomy:
                self._roomy = key
                self._write_density(roomy)
        for part in self.marks.values():
            if part.actor.GetVisibility():
                part.face(pose, height_px)

    @property
    def shown_positions(self) -> list[Array]:
        """The points of the lines that are shown, each (P, 3), those that give way included."""
        whole = {"circles_p1": self._circles[0], "circles_p2": self._circles[1]}
        whole["polygon"] = self._legs
        crowding = {*whole, "chosen_polygon", "quiet_circles_p1", "quiet_circles_p2"}
        return [
            *(
                part.positions
                for name, part in self.lines.items()
                if name not in crowding and part.actor.GetVisibility()
            ),
            *(lines.reshape(-1, 3) for name, lines in whole.items() if self._visible.get(name)),
        ]
