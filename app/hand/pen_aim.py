"""What a press of the pen would do where the pointer is, and where it lands."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from enum import Enum, auto

import numpy as np

from app.hand.coordinates import DesignPoint, GridSteps, ScreenPoint, Transform, nice_step
from app.hand.guides import guide_lines
from app.hand.hit_test import POINT_REACH, Handle, pick_curve
from app.hand.pen_stop import side_of, stopped
from app.hand.snapping import (
    AXIS_REACH,
    MAGNET_REACH,
    Direction,
    DragKeys,
    Landing,
    Snapping,
    land,
)
from sgb_core.arrays import Floats
from sgb_core.curves.profile import Profile
from sgb_core.design.pen import Anchor, PenPath
from sgb_core.document.guides import Guide
from sgb_core.values import dataclass

# A direction is taken where the hand is so near to it, in pixels.
TANGENT_REACH = 4.0
# How far, in pixels, a place may be moved so that its numbers are round.
ROUND_REACH = 3.0
_HALF = math.sqrt(0.5)
EIGHTHS: tuple[Direction, ...] = ((1.0, 0.0), (0.0, 1.0), (_HALF, _HALF), (_HALF, -_HALF))


class Act(Enum):
    """What a press would do."""

    NOTHING = auto()
    START = auto()  # the first anchor of a new profile
    GO_ON = auto()  # take up an end of the profile
    PLACE = auto()
    POLE = auto()  # an anchor on the axis, which ends the run
    CLOSE = auto()  # back onto the other end: a ring
    INSERT = auto()  # a joint on the curve
    BREAK = auto()  # on the last anchor: what comes next leaves it with a kink


@dataclass(frozen=True, slots=True)
class Run:
    """What the pen is in the middle of: its path, and whether it draws on from the start.

    ``bare`` says that nothing of it is in the document yet.
    """

    path: PenPath
    at_start: bool = False
    bare: bool = True

    def target(self, profile: Profile) -> Anchor | None:
        """Return the anchor at the other end of the profile, with the leg by which it leaves."""
        if self.bare:
            return None
        first = self.path.anchors[0]
        points = profile.segments[-1].points[::-1] if self.at_start else profile.segments[0].points
        place, leg = _pair(points[0]), _pair(points[1])
        # Where the run itself began there, its own handle still waits on the other side.
        incoming = first.incoming if first.place == place else None
        return Anchor(place, incoming, leg)


@dataclass(frozen=True, slots=True)
class Aim:
    """What a press does and where; ``curve`` is the place on the profile that is meant."""

    act: Act
    landing: Landing
    curve: Handle | None = None
    at_start: bool = False


def aim(
    profile: Profile,
    run: Run | None,
    paper: Transform,
    at: ScreenPoint,
    keys: DragKeys,
    *,
    grid: GridSteps | None,
    blank: bool,
    guides: Sequence[Guide] = (),
) -> Aim:
    """Return what a press at a place means, from what is nearest to it.

    ``blank`` says that the profile is there to be replaced. ``guides`` draw new anchors to them.
    """
    cursor = paper.to_design(at)
    magnets = Snapping(
        grid,
        AXIS_REACH / paper.scale,
        align_reach=MAGNET_REACH / paper.scale,
        guides=guide_lines(guides),
        guide_reach=MAGNET_REACH / paper.scale,
    )
    if run is None and not blank:
        return _taken_up(profile, paper, at, cursor)
    if run is None:
        return Aim(Act.START, _landing(None, PenPath(), cursor, keys, paper, magnets))
    last = DesignPoint(*run.path.last.place)
    if _near(paper, last, at):
        return Aim(Act.BREAK, Landing(last))
    target = run.target(profile)
    if target is not None and _near(paper, DesignPoint(*target.place), at):
        return Aim(Act.CLOSE, Landing(DesignPoint(*target.place)))
    if not run.bare and not keys.free:
        curve = pick_curve(profile, paper, at)
        if curve is not None:
            return _on_curve(profile, curve)
    known = None if run.bare else profile
    landing = _landing(known, run.path, cursor, keys, paper, magnets)
    landing = stopped(landing, last, side_of(known, run.path))
    on_axis = landing.point.r == 0.0 and run.path.last.place[0] != 0.0
    return Aim(Act.POLE if on_axis else Act.PLACE, landing)


def _taken_up(profile: Profile, paper: Transform, at: ScreenPoint, cursor: DesignPoint) -> Aim:
    if not profile.closed:
        ends = (profile.segments[-1].points[3], profile.segments[0].points[0])
        for at_start, end in enumerate(ends):
            if _near(paper, DesignPoint.of(end), at):
                return Aim(Act.GO_ON, Landing(DesignPoint.of(end)), at_start=bool(at_start))
    curve = pick_curve(profile, paper, at)
    return Aim(Act.NOTHING, Landing(cursor)) if curve is None else _on_curve(profile, curve)


def _on_curve(profile: Profile, curve: Handle) -> Aim:
    place = DesignPoint.of(profile.point(curve.segment, curve.s))
    return Aim(Act.INSERT, Landing(place), curve)


def _landing(
    profile: Profile | None,
    path: PenPath,
    cursor: DesignPoint,
    keys: DragKeys,
    paper: Transform,
    magnets: Snapping,
) -> Landing:
    """Return where a new anchor lands: on axis, guides, points, heights, grid, or the tangent."""
    snapping = replace(magnets, others=_marks(profile, path))
    if not path.anchors:
        return _tidied(land(cursor, cursor, replace(keys, constrain=False), snapping), keys, paper)
    start = DesignPoint(*path.last.place)
    tangent = _tangent(path.last)
    if keys.constrain:
        return land(start, cursor, keys, snapping, [*EIGHTHS[2:], *tangent])
    landing = land(start, cursor, keys, snapping)
    if not keys.free and not landing.on_axis and landing.aligned == (None, None):
        held = _on_line(start, cursor, tangent, TANGENT_REACH / paper.scale)
        if held is not None:
            return held
    return _tidied(landing, keys, paper)


def _tidied(landing: Landing, keys: DragKeys, paper: Transform) -> Landing:
    """Return a landing at the roundest numbers near by, but for what holds it."""
    if keys.free:
        return landing
    step = _round_steps(paper.scale)
    r, h = (
        value if aligned is not None or on_axis else step.snapped(value)
        for value, aligned, on_axis in zip(
            landing.point.pair, landing.aligned, (landing.on_axis, False), strict=True
        )
    )
    return replace(landing, point=DesignPoint(r, h))


def _round_steps(scale: float) -> GridSteps:
    """Return the largest step of 1, 2, 5 times a power of ten that moves nothing too far."""
    widest = 2.0 * ROUND_REACH / scale
    step = nice_step(widest)
    while step > widest:
        step = nice_step(step / 2.6)
    return GridSteps(5.0 * step, step)


def pulled(
    anchor: Anchor, cursor: DesignPoint, keys: DragKeys, scale: float, grid: GridSteps | None
) -> Landing:
    """Return where the handle of an anchor lands that is drawn out to the cursor.

    It is level, upright or along the tangent where it is near that; with Shift always one of
    these, or at 45°.
    """
    start = DesignPoint(*anchor.place)
    directions: list[Direction] = [*EIGHTHS[:2], *_tangent(anchor)]
    if keys.constrain:
        directions.extend(EIGHTHS[2:])
        found = _on_line(start, cursor, directions, math.inf)
    elif keys.free:
        return Landing(cursor)
    else:
        found = _on_line(start, cursor, directions, TANGENT_REACH / scale)
    snap = (grid or _round_steps(scale)).snapped
    if found is None:
        return Landing(DesignPoint(snap(cursor.r), snap(cursor.h)))
    if keys.free or found.guide not in EIGHTHS[:2]:
        return found
    # Level or upright: how long it is can be round.
    r, h = found.point.pair
    if found.guide == EIGHTHS[0]:
        return replace(found, point=DesignPoint(snap(r), h))
    return replace(found, point=DesignPoint(r, snap(h)))


def _on_line(
    start: DesignPoint, cursor: DesignPoint, directions: Sequence[Direction], reach: float
) -> Landing | None:
    """Return the nearest place on one of the lines through ``start``, if one is near enough."""
    step = np.array((cursor.r - start.r, cursor.h - start.h))
    best: tuple[float, Direction] | None = None
    for way in directions:
        off = abs(float(step[0] * way[1] - step[1] * way[0]))
        if off <= reach and (best is None or off < best[0]):
            best = (off, way)
    if best is None:
        return None
    way = best[1]
    along = float(step @ way)
    return Landing(DesignPoint(start.r + along * way[0], start.h + along * way[1]), way)


def _tangent(anchor: Anchor) -> list[Direction]:
    """Return the direction in which the curve arrives or leaves at an anchor, if it has one."""
    for handle in (anchor.outgoing, anchor.incoming):
        if handle is not None:
            dr, dh = handle[0] - anchor.place[0], handle[1] - anchor.place[1]
            long = math.hypot(dr, dh)
            if long > 0.0:
                return [(dr / long, dh / long)]
    return []


def _marks(profile: Profile | None, path: PenPath) -> Floats:
    """Return the places, shape (m, 2), with which a new anchor may line up.

    They are ends and joints, and the foot of the axis.
    """
    places = [(0.0, 0.0), *(anchor.place for anchor in path.anchors)]
    ends = np.zeros((0, 2)) if profile is None else profile.control_points[:, [0, 3]].reshape(-1, 2)
    return np.concatenate([ends, np.array(places).reshape(-1, 2)])


def _near(paper: Transform, place: DesignPoint, at: ScreenPoint) -> bool:
    return paper.to_screen(place).distance(at) <= POINT_REACH


def _pair(values: Floats) -> tuple[float, float]:
    return float(values[0]), float(values[1])
