"""The foot ring: a straight ring below a vessel's floor, on which it stands."""

from __future__ import annotations

import numpy as np
import shapely

from sgb_core.arrays import Floats
from sgb_core.bodies.hollow import SectionFrame
from sgb_core.bodies.meridian import SolidError
from sgb_core.bodies.outline import Piece, Role
from sgb_core.bodies.region import parameters
from sgb_core.bodies.solid import WallSide
from sgb_core.curves.search import sign_change
from sgb_core.findings.bodies import NoRoomForRing

# Under a round bottom the ring is at most this part of the body's width.
WIDEST = 0.5


def ringed(frame: SectionFrame, material: shapely.Geometry) -> shapely.Geometry:
    """Return the material with its foot ring, as wide as the wall.

    Its outside stands below the edge of a level underside. Below a round one it stands where the
    outside begins to rise more steeply than 45°, at most at half of the body's width. Raises
    SolidError where there is no room for it.
    """
    meridian, solid = frame.meridian, frame.solid
    low = float(material.bounds[1])
    material = _levelled(material, low, 1e-9 * meridian.size)
    radius, top = _edge(frame, material, low)
    inner = radius - solid.wall
    if inner <= max(solid.drain_hole / 2.0, 1e-3 * meridian.size):
        raise SolidError(NoRoomForRing(solid.wall, radius))
    corners = np.array([(inner, low), (radius, low), (radius, top), (inner, top)])
    corners[:2, 1] -= solid.foot_ring
    ring = frame.register.polygon(
        [frame.wall.line(Role.FOOT, corners[k], corners[(k + 1) % 4]) for k in range(len(corners))]
    )
    return material.union(ring)


def _levelled(material: shapely.Geometry, low: float, slack: float) -> shapely.Geometry:
    """Return the material with all of its underside at one height, to the last bit.

    Else rounding would leave gaps between it and what is put against it.
    """

    def level(points: Floats) -> Floats:
        under = points[:, 1] <= low + slack
        return np.stack([points[:, 0], np.where(under, low, points[:, 1])], axis=1)

    return shapely.transform(material, level)


def _edge(frame: SectionFrame, material: shapely.Geometry, low: float) -> tuple[float, float]:
    """Return r and h of the place of the underside below which the ring's outside stands."""
    size = frame.meridian.size
    points = shapely.get_coordinates(material)
    level = points[points[:, 1] == low, 0]
    if np.ptp(level) > 1e-6 * size:
        return float(level.max()), low
    half = WIDEST * float(material.bounds[2])
    inside = frame.solid.side is WallSide.INSIDE
    started = False
    for piece in frame.wall.traces(0.0, Role.DRAWN) if inside else frame.wall.path():
        u = parameters(piece, frame.wall.grids)
        if not started:
            lowest = np.flatnonzero(piece.points(u)[:, 1] <= low + 1e-3 * size)
            if len(lowest) == 0:
                continue
            u, started = u[lowest[0] :], True

        def beyond(places: Floats, piece: Piece = piece) -> Floats:
            across, up = np.abs(piece.tangents(places)).T
            return np.asarray(np.maximum(up - across, piece.points(places)[:, 0] - half))

        reached = np.flatnonzero(beyond(u) >= 0.0)
        if len(reached):
            first = int(reached[0])
            place = (
                sign_change(beyond, float(u[first - 1]), float(u[first])) if first else float(u[0])
            )
            radius, height = piece.points(np.array([place]))[0].tolist()
            # A little into the wall, which the ring is to join.
            return radius, height + 0.1 * frame.solid.wall
    return 0.0, low
