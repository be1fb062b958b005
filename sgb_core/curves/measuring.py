"""What can be read off a profile with a ruler: distances, angles, curvature, length along it."""

from __future__ import annotations

from math import atan2, degrees, hypot, isfinite

import numpy as np

from sgb_core.curves.nearest import arc_length
from sgb_core.curves.profile import Profile
from sgb_core.values import dataclass

Place = tuple[float, float]
# Curvature times size below this is a straight line's.
_STRAIGHT = 1e-9


@dataclass(frozen=True, slots=True)
class Between:
    """From one place to another: lengths in the unit, the angle from the r axis to the h axis."""

    length: float
    dr: float
    dh: float
    angle_deg: float


@dataclass(frozen=True, slots=True)
class OnCurve:
    """A place on a profile: its ``radius`` of curvature, None where straight or endless.

    ``centre`` is that of the circle which touches and bends as the curve does; ``angle_deg`` is
    the tangent's, from the r axis to the h axis, None where the curve stands still.
    """

    place: Place
    angle_deg: float | None
    radius: float | None
    centre: Place | None


def between(start: Place, end: Place) -> Between:
    """Return what lies between two places.

    >>> between((0, 0), (3, 4)).length
    5.0
    """
    dr, dh = end[0] - start[0], end[1] - start[1]
    return Between(hypot(dr, dh), dr, dh, degrees(atan2(dh, dr)))


def opening(one: Place, vertex: Place, other: Place) -> float | None:
    """Return the angle between the ways from a vertex, 0 to 180 degrees; None without two ways.

    >>> opening((1, 0), (0, 0), (0, 2))
    90.0
    """
    (a, b), (c, d) = ((place[0] - vertex[0], place[1] - vertex[1]) for place in (one, other))
    if hypot(a, b) == 0.0 or hypot(c, d) == 0.0:
        return None
    return degrees(atan2(abs(a * d - b * c), a * c + b * d))


def on_curve(profile: Profile, segment: int, s: float) -> OnCurve:
    """Return what there is to read at a place: κ = (r'h'' − r''h') / (r'² + h'²)^{3/2}."""
    curve, at = profile.segments[segment], np.array(s)
    place = _pair(curve.point(at))
    slope = curve.derivative(at)
    speed = float(np.hypot(*slope))
    if speed <= _STRAIGHT * profile.size:
        return OnCurve(place, None, None, None)
    angle = degrees(atan2(float(slope[1]), float(slope[0])))
    bend = float(curve.curvature(at))
    if not isfinite(bend) or abs(bend) * profile.size <= _STRAIGHT:
        return OnCurve(place, angle, None, None)
    normal = np.array((-slope[1], slope[0])) / speed
    return OnCurve(place, angle, 1.0 / abs(bend), _pair(place + normal / bend))


def along(profile: Profile, one: tuple[int, float], other: tuple[int, float]) -> float | None:
    """Return the length of the profile between two (segment, s), None across a gap.

    On a closed profile the shorter way.

    >>> along(sgb.Profile.of([sgb.line((20, 0), (20, 60))]), (0, 0.25), (0, 0.75))
    30.0
    """
    first, last = sorted((one, other))
    if not all(profile.joined[first[0] : last[0]]):
        return None
    length = sum(map(arc_length, profile.segments[first[0] : last[0]]))
    length += arc_length(profile.segments[last[0]], 0.0, last[1])
    length -= arc_length(profile.segments[first[0]], 0.0, first[1])
    if profile.closed and all(profile.joined):
        return min(length, sum(map(arc_length, profile.segments)) - length)
    return length


def _pair(place: np.ndarray) -> Place:
    return float(place[0]), float(place[1])
