"""What a vessel's material leaves hollow: its cavity, sealed chambers, and the drain hole."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from itertools import count

import numpy as np
import shapely

from sgb_core.arrays import Floats
from sgb_core.bodies.meridian import Meridian, SolidError
from sgb_core.bodies.outline import Piece, Role, line
from sgb_core.bodies.region import SLIVER, Outline, Register
from sgb_core.bodies.solid import Solid, WallSide
from sgb_core.bodies.traces import ends_of, points_of
from sgb_core.bodies.wall_curve import WallBuilder
from sgb_core.findings.bodies import (
    Crumb,
    HoleTooWide,
    LoosePart,
    NoBodyFor,
    NoCavity,
    SealedHollow,
    TouchingCircle,
)
from sgb_core.surfaces.section import AXIS, MERGE

# A part of the section smaller than this part of the largest is a crumb that cutting has left.
_CRUMB = 1e-4


class SectionFrame:
    """A meridian, the solid asked for, and the half-plane in which its section is made."""

    def __init__(self, meridian: Meridian, solid: Solid, grids: Mapping[int, Floats]) -> None:
        self.meridian = meridian
        self.solid = solid
        inside = solid.side is WallSide.INSIDE
        self.wall = WallBuilder(meridian, solid.wall if inside else -solid.wall, grids)
        self.register = Register(grids, meridian.size)
        reach = meridian.quartics.reshape(-1, 2)
        wide = float(reach[:, 0].max())
        if meridian.stretch is not None:
            # No strength is beyond its keys, and so no factor of the radius.
            wide *= meridian.stretch.widest
        spare = 4.0 * (solid.wall + solid.base + solid.foot_ring) + meridian.size
        self.low = float(reach[:, 1].min()) - spare
        self.high = float(reach[:, 1].max()) + spare
        self.wide = wide + spare

    @property
    def floor(self) -> float:
        """The height of the floor's upper side, of a wall inside.

        It counts from the foot; from the lowest point where the foot is on the axis, in a punt.
        """
        low = self.meridian.lowest if self.meridian.foot_on_axis else float(self.meridian.foot[1])
        return low + self.solid.base

    def box(
        self, right: float, low: float, high: float, roles: tuple[Role, Role, Role]
    ) -> shapely.Geometry:
        """Return the box from the axis to ``right``; roles of its bottom, side and top."""
        corners = np.array([(0.0, low), (right, low), (right, high), (0.0, high)])
        sides = (*roles, Role.AXIS)
        return self.register.polygon(
            [self.wall.line(role, corners[k], corners[(k + 1) % 4]) for k, role in enumerate(sides)]
        )

    def half_plane(self, low: float | None = None, high: float | None = None) -> shapely.Geometry:
        """Return the half-plane between two heights, by default all of it."""
        low = self.low if low is None else low
        high = self.high if high is None else high
        return self.box(self.wide, low, high, (Role.FOOT, Role.WALL, Role.LEVEL))


def gathered(frame: SectionFrame, material: shapely.Geometry) -> shapely.Geometry:
    """Return the material without crumbs, and find those and the parts that hang loose."""
    least = SLIVER * frame.meridian.size**2
    parts = [part for part in shapely.get_parts(material) if part.area > least]
    if len(parts) < 2:
        return material
    largest = max(parts, key=lambda part: float(part.area))
    kept = [part for part in parts if part.area > _CRUMB * largest.area]
    for part in parts:
        inside = part.representative_point()
        where = (float(inside.x), float(inside.y))
        if part.area <= _CRUMB * largest.area:
            frame.wall.note(Crumb(where))
        elif part is not largest:
            frame.wall.note(LoosePart(where))
    return shapely.multipolygons(kept)


def touching(outlines: Sequence[Outline], size: float) -> list[TouchingCircle]:
    """Return where corners of the outlines meet off the axis, which a mesh cannot keep apart."""
    pieces = [piece for outline in outlines for ring in outline.rings for piece in ring]
    # Corners nearer to each other along the outline are one.
    corners = ends_of(pieces)[_extents(pieces) > MERGE * size, 0]
    corners = corners[corners[:, 0] > AXIS * size]
    near = shapely.box(*(corners - MERGE * size).T, *(corners + MERGE * size).T)
    second, first = shapely.STRtree(shapely.points(corners)).query(near)
    met = np.unique(second[first < second])
    return [TouchingCircle((float(r), float(h))) for r, h in corners[met].tolist()]


def _extents(pieces: Sequence[Piece]) -> Floats:
    """Return about how far each piece reaches, also where it ends where it starts, (n,)."""
    shares = np.linspace(0.0, 1.0, 5)
    starts, ends = np.array([(piece.start, piece.end) for piece in pieces]).T[..., None]
    u = starts * (1.0 - shares) + ends * shares
    k = np.repeat(np.arange(len(pieces)), len(shares))
    reach = np.ptp(points_of(pieces, u.ravel(), k).reshape(-1, len(shares), 2), axis=1)
    return np.asarray(reach.max(axis=1))


def air_within(frame: SectionFrame, material: shapely.Geometry) -> shapely.Geometry:
    """Return the air within the body below its crest that the outside does not reach."""
    meridian = frame.meridian
    whole = material
    if not meridian.foot_on_axis:
        # An open bottom counts as closed, as it is when the body stands on something flat.
        roles = (Role.FOOT, Role.FOOT, Role.FLOOR)
        foot = float(meridian.foot[1])
        lid = frame.box(float(meridian.foot[0]), foot - frame.solid.wall, foot, roles)
        whole = whole.union(lid)
    crest = float(material.bounds[3])
    below = frame.half_plane(high=crest)
    found = []
    for part in shapely.get_parts(below.difference(whole)):
        _, low, right, _ = part.bounds
        outside = right >= frame.wide * (1.0 - 1e-9) or low <= frame.low + 1e-9 * abs(frame.low)
        if not outside and part.area > SLIVER * meridian.size**2:
            found.append(part)
    return shapely.MultiPolygon(found)


def settled(
    frame: SectionFrame, material: shapely.Geometry, air: shapely.Geometry
) -> tuple[shapely.Geometry, shapely.Geometry]:
    """Return the material with tiny voids filled, and the air that the opening reaches.

    Larger voids that it does not reach are noted. Raises SolidError where no cavity is left.
    """
    meridian, solid = frame.meridian, frame.solid
    if meridian.closed:
        if solid.side is WallSide.INSIDE and not any(
            part.interiors for part in shapely.get_parts(material)
        ):
            raise SolidError(NoCavity(solid.wall, None))
        return material, air
    crest, slack = float(material.bounds[3]), 1e-9 * meridian.size
    chambers = sorted(shapely.get_parts(air), key=lambda part: -float(part.area))
    reached = chambers[:1]
    if not meridian.rim_on_axis:
        reached = [part for part in chambers if part.bounds[3] >= crest - slack]
    if not reached:
        raise SolidError(NoCavity(solid.wall, solid.base))
    for part in chambers:
        if part in reached:
            continue
        low, high = float(part.bounds[1]), float(part.bounds[3])
        if part.area < solid.wall**2:
            # Between two folds or under a kink: too small to be meant.
            material = material.union(part)
            continue
        frame.wall.note(SealedHollow((float(part.bounds[0]), high), low))
    return material, shapely.multipolygons(reached)


def drained(
    frame: SectionFrame, material: shapely.Geometry, air: shapely.Geometry
) -> shapely.Geometry:
    """Return the material without the hole through its floor."""
    radius = frame.solid.drain_hole / 2.0
    strip = frame.box(radius, frame.low, frame.high, (Role.FOOT, Role.HOLE, Role.LEVEL))
    slack = 1e-9 * frame.meridian.size
    parts = [
        part
        for part in shapely.get_parts(material.intersection(strip))
        if part.area > SLIVER * frame.meridian.size**2 and part.bounds[0] <= slack
    ]
    if not parts:
        if frame.solid.base == 0.0 and not frame.meridian.foot_on_axis:
            return material
        raise SolidError(NoBodyFor.NO_FLOOR)
    plug = min(parts, key=lambda part: float(part.bounds[1]))
    edge = shapely.get_coordinates(plug)
    top = float(edge[edge[:, 0] >= radius - slack][:, 1].max(initial=-np.inf))
    beyond = shapely.Point(radius, top + 1e-6 * frame.meridian.size)
    if not np.isfinite(top) or not air.buffer(slack).contains(beyond):
        raise SolidError(HoleTooWide(frame.solid.drain_hole))
    above = [part.bounds[1] for part in parts if part.bounds[1] > plug.bounds[3]]
    end = (float(plug.bounds[3]) + min([frame.high, *above])) / 2.0
    drill = frame.box(radius, frame.low, end, (Role.FOOT, Role.HOLE, Role.LEVEL))
    return material.difference(drill)


def cut_below(
    outlines: Sequence[Outline], height: float, grids: Mapping[int, Floats], size: float
) -> tuple[Outline, ...]:
    """Return the outlines of what lies below a height, with a level line where they are cut.

    ``grids`` and ``size`` are those of the section that the outlines belong to.
    """
    if not outlines:
        return ()
    register, sources = Register(grids, size), count()

    def region(pieces: Sequence[Piece]) -> shapely.Geometry:
        return register.polygon([replace(piece, source=next(sources)) for piece in pieces])

    parts = []
    for outline in outlines:
        part = region(outline.exterior)
        for hole in outline.holes:
            part = part.difference(region([piece.reversed() for piece in reversed(hole)]))
        parts.append(part)
    left, low, right, _ = shapely.total_bounds(parts)
    if not low < height:
        return ()
    # Beyond the outlines on all sides but the upper one, so that only this one cuts.
    left, low, right = left - size, low - size, right + size
    corners = np.array([(left, low), (right, low), (right, height), (left, height)])
    box = region([line(Role.LEVEL, corners[k], corners[(k + 1) % 4]) for k in range(4)])
    return register.outlines(shapely.intersection(parts, box))
