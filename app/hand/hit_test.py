"""What lies under the pointer in the profile editor."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from enum import Enum, auto

import numpy as np

from app.hand.coordinates import Area, Paper, ScreenPoint, Transform
from app.hand.density import shown_points
from app.hand.features import Feature
from sgb_core.arrays import Floats
from sgb_core.curves.profile import Profile
from sgb_core.values import dataclass

POINT_REACH = 9.0
QUARTIC_REACH = 9.0
CURVE_REACH = 6.0
# A quartic point nearer than HIDDEN to an end of its leg is grabbed ASIDE pixels along the leg.
HIDDEN = 12.0
ASIDE = 15.0
_PER_SEGMENT = 65

PointId = tuple[int, int]


class Target(Enum):
    """The kinds of things that can be grabbed."""

    POINT = auto()
    QUARTIC = auto()
    CURVE = auto()
    LEVEL = auto()  # the fill line
    DIMENSION = auto()  # the line of the dimension of that index
    GRIP = auto()  # a handle of the frame around several points
    BODY = auto()  # the inside of that frame
    FEATURE = auto()  # of the body or its paint: wall, floor, a band


@dataclass(frozen=True, slots=True)
class Handle:
    """One thing that can be grabbed.

    ``index`` is 0..3 of a control point, 0..2 of the inner quartic points Q1..Q3, 0..7 of a grip;
    ``s`` is the place on a curve, ``feature`` what of the body is meant. Handles of a curve are
    equal wherever they touch it.
    """

    target: Target
    segment: int
    index: int = 0
    s: float = 0.0
    feature: Feature | None = None

    @property
    def on_profile(self) -> bool:
        """Whether it is of one segment: a control point, a quartic point or the curve."""
        return self.target in (Target.POINT, Target.QUARTIC, Target.CURVE)

    def same(self, other: Handle | None) -> bool:
        """Whether both are the same thing, wherever a curve is touched."""
        if self.feature is not None:
            return other is not None and self.feature.same(other.feature)
        return other is not None and (self.target, self.segment, self.index) == (
            other.target,
            other.segment,
            other.index,
        )


def twin(profile: Profile, point: PointId) -> PointId | None:
    """Return the end of the neighbouring segment that is the same point, if there is one."""
    return twin_among(profile.joined, len(profile), point)


def twin_among(joined: Sequence[bool], count: int, point: PointId) -> PointId | None:
    """Return :func:`twin` of a point where it is known which of ``count`` segments join."""
    segment, index = point
    if index == 3 and segment < len(joined) and joined[segment]:
        return (segment + 1) % count, 0
    before = (segment - 1) % count
    if index == 0 and before < len(joined) and joined[before]:
        return before, 3
    return None


def distinct_points(profile: Profile) -> list[PointId]:
    """Return all control points in order along the chain, a joined joint only once."""
    joined, last = profile.joined, len(profile) - 1
    return [
        (segment, index)
        for segment in range(len(profile))
        for index in range(4)
        if not (index == 0 and segment > 0 and joined[segment - 1])
        and not (index == 3 and segment == last and profile.closed and joined[last])
    ]


def canonical(profile: Profile, points: Collection[PointId]) -> list[PointId]:
    """Return the points, ordered, with each joined joint named once as its own row names it."""
    joined, known = profile.joined, set(points)
    if not known:
        return []
    return [
        point
        for point in distinct_points(profile)
        if point in known or twin_among(joined, len(profile), point) in known
    ]


def pick(
    profile: Profile,
    paper: Paper,
    at: ScreenPoint,
    *,
    selected: int,
    quartics: bool,
    points: bool = True,
    curves: bool = True,
    lit: Collection[int] = (),
) -> Handle | None:
    """Return the handle that a press at ``at`` would grab.

    Control points come before quartic points and these before curves; among equals the
    selected segment comes first. Of crowded segments only the curve can be grabbed, but for the
    selected one and those that are ``lit``, too.
    """
    cursor = np.array((at.x, at.y))
    control = paper.map(profile.control_points)
    seen = shown_points(control, {selected, *lit})
    handle = _nearest(control, cursor, selected, POINT_REACH, seen) if points else None
    if handle is not None:
        return Handle(Target.POINT, *handle)
    if quartics:
        places = graspable(control, paper.map(profile.quartics[:, 1:4]))
        handle = _nearest(places, cursor, selected, QUARTIC_REACH, seen[:, [1, 1, 1]])
        if handle is not None and _leg_pixels(control, handle) > 1.0:
            return Handle(Target.QUARTIC, *handle)
    return pick_curve(profile, paper, at) if curves else None


def _nearest(
    places: Floats, cursor: Floats, selected: int, reach: float, seen: np.ndarray
) -> tuple[int, int] | None:
    distances = np.hypot(*np.moveaxis(places - cursor, -1, 0))
    distances[~seen] = np.inf
    if distances.min() > reach:
        return None
    ranked = distances.copy()
    if selected < len(ranked):
        ranked[selected] -= 1.5  # where two lie together, the selected segment's own is meant
    segment, index = np.unravel_index(int(ranked.argmin()), ranked.shape)
    return int(segment), int(index)


def graspable(points: Floats, quartics: Floats) -> Floats:
    """Return where quartic points are grabbed: a little along the leg where an end hides them.

    At λ1 = 4, ω = 1 the point Q1 lies on P0, and could not be dragged out again. ``points``
    has shape (n, 4, 2), ``quartics`` and the result (n, 3, 2), all in pixels.
    """
    ends = points[:, [0, 2, 3]], points[:, [1, 1, 2]]
    places = quartics.copy()
    for end, other in (ends, ends[::-1]):
        leg = other - end
        length = np.hypot(leg[..., 0], leg[..., 1])
        away = quartics - end
        hidden = (np.hypot(away[..., 0], away[..., 1]) < HIDDEN) & (length > 2.0 * ASIDE)
        aside = end + leg * (ASIDE / np.where(length > 0.0, length, 1.0))[..., None]
        places[hidden] = aside[hidden]
    return places


def _leg_pixels(points: Floats, handle: tuple[int, int]) -> float:
    segment, leg = handle
    return float(np.hypot(*(points[segment, leg + 1] - points[segment, leg])))


def pick_curve(profile: Profile, paper: Paper, at: ScreenPoint) -> Handle | None:
    """Return the place on the curve that a press at ``at`` would grab."""
    cursor = np.array((at.x, at.y))
    places = paper.map(profile.sample(_PER_SEGMENT))
    start, step = places[:, :-1], np.diff(places, axis=1)
    squared = (step**2).sum(axis=-1)
    along = ((cursor - start) * step).sum(axis=-1) / np.where(squared > 0.0, squared, 1.0)
    along = np.clip(along, 0.0, 1.0)
    foot = start + along[..., None] * step
    distances = np.hypot(*np.moveaxis(foot - cursor, -1, 0))
    segment, piece = np.unravel_index(int(distances.argmin()), distances.shape)
    if distances[segment, piece] > CURVE_REACH:
        return None
    s = (piece + along[segment, piece]) / (_PER_SEGMENT - 1)
    return Handle(Target.CURVE, int(segment), 0, float(s))


def points_in(profile: Profile, transform: Transform, box: Area) -> frozenset[PointId]:
    """Return the control points inside a rectangle of the screen, a joined joint once."""
    places = transform.map(profile.control_points)
    return frozenset(
        (segment, index)
        for segment, index in distinct_points(profile)
        if box.contains(ScreenPoint(*places[segment, index].tolist()))
    )
