"""What can be grabbed in the viewport, and what lies under the cursor there."""

from __future__ import annotations

from functools import cached_property

import numpy as np

from app.hand import texture_place
from app.hand.coordinates import DesignPoint, ScreenPoint, number
from app.hand.dimension_lines import dimension_lines, pick_dimension
from app.hand.features import on_fill_line, pick_band, pick_body
from app.hand.hit_test import POINT_REACH, Handle, Target, pick
from app.hand.turn import TurnEnd, handle_angles
from app.state.cut import Cut
from app.state.overlays import Overlay
from app.state.presenter import Frame
from app.viewport.axis_handle import AxisChoice, AxisDrag, AxisTip
from app.viewport.half_plane import Lens, Ring, SpacePaper
from app.viewport.rim_handle import Rim, RimDrag, RimGrip
from app.viewport.texture_handle import Sheet, TextureDrag, TextureGrip, grip_places
from sgb_core.arrays import Floats
from sgb_core.curves.profile import Profile
from sgb_core.surfaces.revolution import RevolutionSurface
from sgb_core.values import dataclass

# The handles of the turn stand this far out, as a part of the largest radius.
OUTSIDE = 1.06

# What the hand can take hold of.
Grip = Handle | TurnEnd | AxisTip | RimGrip | TextureGrip
# Grips that are no part of the profile but have one kind of drag each.
SideGrip = AxisTip | RimGrip | TextureGrip
SideDrag = AxisDrag | RimDrag | TextureDrag


@dataclass(frozen=True, eq=False)
class Scenery:
    """A frame as it is seen: where its handles lie on the screen."""

    frame: Frame
    lens: Lens

    @property
    def surface(self) -> RevolutionSurface:
        """The surface that is shown."""
        return self.frame.evaluation.surface

    def paper(self, handle: Handle | None = None) -> SpacePaper:
        """Return the profile's half-plane, measured at ``handle`` or at its first point."""
        handle = handle or Handle(Target.POINT, 0)
        return SpacePaper.of(self.surface, self.lens, self.design_place(handle))

    @property
    def curve(self) -> Floats:
        """Places on the generatrix in pixels, shape (m, 2), for labels to keep clear of."""
        return self.paper().map(self.frame.evaluation.sample).reshape(-1, 2)

    def paper_at(self, place: DesignPoint) -> SpacePaper:
        """Return the profile's half-plane, measured at a place of it."""
        return SpacePaper.of(self.surface, self.lens, place)

    def design_place(self, handle: Handle) -> DesignPoint:
        """Return where a handle is in the half-plane."""
        if handle.target is Target.LEVEL:
            return DesignPoint(0.0, self.frame.document.fill_height or 0.0)
        if handle.target is Target.DIMENSION:
            return self._dimension_end(handle.index)
        return DesignPoint.of(_place(self.frame.document.profile, handle))

    def _dimension_end(self, number: int) -> DesignPoint:
        document = self.frame.document
        lines = dimension_lines(document, self.paper())
        end = next((each.span.end for each in lines if each.number == number), (0.0, 0.0))
        return DesignPoint(*end)

    def pick(self, at: ScreenPoint) -> Grip | None:
        """Return what a press would grab: a point, a quartic point, the turn's ends, the axis.

        Then what of the body can be dragged; last the generatrix, which a click selects. Only what
        is shown can be grabbed.
        """
        view = self.frame.view
        found = pick(
            self.frame.document.profile,
            self.paper(),
            at,
            selected=view.segment,
            points=view.shows(Overlay.POLYGON),
            quartics=view.shows(Overlay.QUARTIC),
            curves=view.shows(Overlay.GENERATRIX),
        )
        if found is not None and found.target is not Target.CURVE:
            return found
        away = self.lens.to_screen(self.turn_places) - (at.x, at.y)
        distances = np.hypot(*away.T)
        if distances.min() <= POINT_REACH:
            return (TurnEnd.START, TurnEnd.END)[int(distances.argmin())]
        away = self.lens.to_screen(self.axis_place) - (at.x, at.y)
        if np.hypot(*away[0]) <= POINT_REACH:
            return AxisTip()
        if self.rim.shown:
            away = self.lens.to_screen(self.rim.place) - (at.x, at.y)
            if np.hypot(*away[0]) <= POINT_REACH:
                return RimGrip()
        away = self.lens.to_screen(self.texture_places) - (at.x, at.y)
        if len(away) and np.hypot(*away.T).min() <= POINT_REACH:
            return TextureGrip(tuple(self.textures)[int(np.hypot(*away.T).argmin())])
        return self._dimension(at) or self._feature(at) or found

    def _dimension(self, at: ScreenPoint) -> Handle | None:
        """Return the dimension whose line is under the cursor, where they are shown."""
        if not self.frame.view.dimensions_in_space:
            return None
        document = self.frame.document
        return pick_dimension(document, self.paper(), at)

    def _feature(self, at: ScreenPoint) -> Handle | None:
        """Return a painted band's edge, or wall and floor where the section is seen."""
        paper = self.paper()
        document = self.frame.document
        feature = pick_band(document, paper, at)
        cut = self.frame.view.cut is not Cut.NONE or document.revolution.sweep_deg < 360.0
        if feature is None and cut and on_fill_line(self.frame, paper, at):
            return Handle(Target.LEVEL, 0)
        if feature is None and cut:
            feature = pick_body(self.frame, paper, at)
        return None if feature is None else Handle(Target.FEATURE, 0, feature=feature)

    def place(self, handle: Grip | None) -> Floats:
        """Return where a handle is in space, shape (1, 3); of none and of curves (0, 3)."""
        if isinstance(handle, AxisTip):
            return self.axis_place
        if isinstance(handle, RimGrip):
            return self.rim.place
        if isinstance(handle, TextureGrip):
            where = handle.at or self.textures.get(handle.number)
            return np.zeros((0, 3)) if where is None else self._sheet.in_space(*where)[None]
        if isinstance(handle, TurnEnd):
            return self.turn_places[[int(handle is TurnEnd.END)]]
        if handle is None or handle.target in (Target.CURVE, Target.LEVEL, Target.DIMENSION):
            return np.zeros((0, 3))
        return self.paper().in_space(_place(self.frame.document.profile, handle)[None])

    def chosen_places(self) -> Floats:
        """Return where the selected points are in space, shape (m, 3)."""
        view, points = self.frame.view, self.frame.document.profile.control_points
        chosen = [points[key] for key in sorted(view.points) if key[0] < len(points)]
        if not chosen or not view.shows(Overlay.POLYGON):
            return np.zeros((0, 3))
        return self.paper().in_space(chosen)

    # The turn.

    @property
    def axes(self) -> AxisChoice:
        """The axes about which the profile can turn."""
        return AxisChoice.of(self.surface, *self.frame.evaluation.bounds)

    @property
    def axis_place(self) -> Floats:
        """Where the handle of the axis is, shape (1, 3)."""
        return self.axes.tip(self.surface.axis)

    @property
    def rim(self) -> Rim:
        """The rim that is turned to twist."""
        return Rim(self.frame.evaluation)

    @cached_property
    def textures(self) -> dict[int, tuple[float, float]]:
        """Where each texture is grabbed, as shares of the turn and of the length."""
        document = self.frame.document
        return grip_places(document, self._sheet) if document.appearance.textures else {}

    @cached_property
    def texture_places(self) -> Floats:
        """Where the handles of the textures are, shape (m, 3)."""
        places = [self._sheet.in_space(*where) for where in self.textures.values()]
        return np.array(places).reshape(-1, 3)

    @cached_property
    def _sheet(self) -> Sheet:
        return Sheet.of(self.frame.document, self.lens)

    def grab(self, grip: SideGrip, at: ScreenPoint) -> SideDrag:
        """Return the drag that a press on a grip begins."""
        if isinstance(grip, AxisTip):
            return AxisDrag(at)
        if isinstance(grip, RimGrip):
            return self.rim.grab(self.lens, at)
        where = self._sheet.under(at, self.textures[grip.number])
        return TextureDrag(at, grip.number, where, where)

    def told(self, grip: SideGrip) -> list[str]:
        """Return what the heads-up label says of a grip."""
        document = self.frame.document
        if isinstance(grip, AxisTip):
            return [f"Axis {document.revolution.axis}", "drag towards x, y or z"]
        if isinstance(grip, RimGrip):
            turns = document.twist.turns
            return [f"Twist {number(360.0 * turns, 1)}°", f"{number(turns, 3)} turns"]
        gone = grip.number >= len(document.appearance.textures)
        return [] if gone else texture_place.told(document, grip.number)

    @property
    def ring(self) -> Ring:
        """The circle around the foot on which the turn's handles stand."""
        low, high = self.frame.evaluation.bounds
        radius = OUTSIDE * max(abs(float(low[0])), abs(float(high[0])))
        return Ring.of(self.surface, radius, float(low[1]))

    @property
    def turn_places(self) -> Floats:
        """Where the handles of the turn's start and end are, shape (2, 3)."""
        surface = self.surface
        return self.ring.in_space(handle_angles(surface.start, surface.sweep))

    @property
    def end_places(self) -> Floats:
        """Where the dots stand that are shown while the pointer is near, shape (m, 3)."""
        return np.vstack([self.turn_places, self.axis_place, self.rim.place, self.texture_places])

    def grip_lines(self, held: Grip | None) -> tuple[Floats, ...]:
        """Return the lines that explain a held handle of the turn; other handles have none."""
        if isinstance(held, AxisTip):
            return self.axes.lines
        if isinstance(held, RimGrip):
            return self.rim.lines
        return self.turn_lines(held) if isinstance(held, TurnEnd) else ()

    def turn_lines(self, end: TurnEnd) -> tuple[Floats, ...]:
        """Return the arc of the turn, and the meridian with its spoke at the end that is held."""
        surface, ring = self.surface, self.ring
        angle = surface.start + (surface.sweep if end is TurnEnd.END else 0.0)
        sections = surface.sections(angle - surface.start).on(np.linspace(0.0, 1.0, 33))
        across, _, up = surface.directions(np.asarray(angle))
        origin = np.asarray(surface.placement.translation)
        meridians = origin + sections[..., :1] * across + sections[..., 1:] * up
        spoke = np.stack([ring.centre, ring.in_space(angle)])
        return ring.in_space(surface.angles(96)), spoke, *meridians


def _place(profile: Profile, handle: Handle) -> Floats:
    if handle.feature is not None:
        return np.asarray(handle.feature.at)
    segment = profile.segments[handle.segment]
    if handle.target is Target.POINT:
        return np.asarray(segment.points[handle.index])
    if handle.target is Target.QUARTIC:
        return np.asarray(segment.quartic[handle.index + 1])
    return np.asarray(segment.point(handle.s))
