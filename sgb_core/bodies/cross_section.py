"""The cross-section of a body: filled, or a vessel's wall and floor, and the cavity they leave."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from functools import lru_cache
from itertools import pairwise
from types import MappingProxyType

import numpy as np
import shapely

from sgb_core.arrays import Floats
from sgb_core.bodies.flux import flux
from sgb_core.bodies.foot import ringed
from sgb_core.bodies.hollow import (
    SectionFrame,
    air_within,
    cut_below,
    drained,
    gathered,
    settled,
    touching,
)
from sgb_core.bodies.meridian import Meridian, SolidError, check_simple, meridian_of, sample_grids
from sgb_core.bodies.outline import Piece, Role
from sgb_core.bodies.region import SLIVER, Outline
from sgb_core.bodies.solid import BodyKind, Rim, Solid, WallSide
from sgb_core.bodies.wall_curve import closing_lines
from sgb_core.findings.bodies import (
    DoubtfulPlace,
    NoBody,
    NoBodyFor,
    NoCavity,
    RimTooShort,
    WallBeyondEnds,
    WallOutOfReach,
)
from sgb_core.surfaces.revolution import RevolutionSurface
from sgb_core.surfaces.sections import Sections
from sgb_core.surfaces.twist import Twist
from sgb_core.values import dataclass

# Part of the size to which curves are sampled to find the section's topology.
WORKING = 2e-4
# A vessel's wall as parts of the size: thinner ones are lost in the samples, and one as large as
# the shape leaves nothing of it.
LEAST_WALL, MOST_WALL = 2e-5, 1.0


@dataclass(frozen=True, slots=True, eq=False)
class CrossSection:
    """A body's section at one angle.

    ``outlines`` bound the material, ``hollow`` the cavity (drain hole ignored; a ring's excepted).
    ``cavity`` is the hollow up to the ``brim``, the body's crest, where there is a rim. ``grids``
    gives by segment the parameters at which traces of it are sampled to find the topology.
    """

    outlines: tuple[Outline, ...]
    hollow: tuple[Outline, ...]
    brim: float | None
    findings: tuple[DoubtfulPlace, ...]
    meridian: Meridian
    grids: Mapping[int, Floats]

    @property
    def cavity(self) -> tuple[Outline, ...]:
        """What a body with a rim holds; empty where there is no rim."""
        return () if self.brim is None else self.hollow

    def filled_to(self, height: float) -> tuple[Outline, ...]:
        """Return the outlines of the cavity below a height."""
        if self.brim is None or height >= self.brim:
            return self.cavity
        return cut_below(self.hollow, height, self.grids, self.meridian.size)


class SectionBuilder(SectionFrame):
    """Makes the section of one meridian."""

    def build(self) -> CrossSection:
        """Return the section. Raises SolidError where no body or no cavity is left."""
        solid, meridian = self.solid, self.meridian
        brim: float | None = None
        air: shapely.Geometry = shapely.MultiPolygon()
        if solid.kind is BodyKind.FILLED:
            material = self._filled()
        else:
            material = self._vessel()
            if material.area <= SLIVER * meridian.size**2:
                raise SolidError(WallBeyondEnds(solid.wall))
            self.wall.find_tight_curves()
            if not meridian.closed:
                air = air_within(self, material)
            material, air = settled(self, material, air)
            if not (meridian.closed or meridian.rim_on_axis):
                brim = self._brim(material)
            if solid.foot_ring > 0.0 and not meridian.closed:
                material = ringed(self, material)
            if solid.drain_hole > 0.0 and not meridian.closed:
                material = drained(self, material, air)
        material = gathered(self, material)
        outlines = self.register.outlines(material)
        if not outlines:
            raise SolidError(NoBody.EMPTY)
        self.wall.note(*touching(outlines, meridian.size))
        hollow = self.register.outlines(air)
        rings = (ring for outline in hollow for ring in outline.rings)
        if brim is not None and sum(map(flux, rings)) <= 0.0:
            # Exact curves of a wall that folds over itself may turn what the samples show.
            raise SolidError(NoCavity(solid.wall, solid.base))
        grids = MappingProxyType(dict(self.register.grids))
        return CrossSection(outlines, hollow, brim, self.wall.findings, meridian, grids)

    def _enclosed(self, drawn: list[Piece], lid: Role) -> list[Piece]:
        """Return the loop of the profile closed to the axis by level lines, the upper a ``lid``."""
        meridian, wall = self.meridian, self.wall
        if meridian.closed:
            return drawn
        solid = self.solid
        below = (
            solid.kind is BodyKind.VESSEL and solid.side is WallSide.OUTSIDE and solid.base > 0.0
        )
        top, bottom = np.array([0.0, meridian.rim[1]]), np.array([0.0, meridian.foot[1]])
        return [
            *drawn,
            wall.line(lid, meridian.rim, top),
            wall.line(Role.AXIS, top, bottom),
            wall.line(Role.FLOOR if below else Role.FOOT, bottom, meridian.foot),
        ]

    def _enclosure(self, drawn: list[Piece], lid: Role) -> tuple[shapely.Geometry, bool]:
        """Return the region that the profile encloses, and whether its outline is simple.

        It is not where a level line from an end crosses the profile, as at a lip rolled over.
        """
        loop = self._enclosed(drawn, lid)
        region = self.register.polygon(loop)
        plain = shapely.Polygon(self.register.samples(loop))
        return region, abs(plain.area - region.area) <= 1e-9 * self.meridian.size**2

    def _filled(self) -> shapely.Geometry:
        region, simple = self._enclosure(self.wall.traces(0.0, Role.DRAWN), Role.RIM)
        if not simple:
            raise SolidError(NoBodyFor.END_BARRED)
        return region

    def _vessel(self) -> shapely.Geometry:
        meridian, wall = self.meridian, self.wall
        drawn, path = wall.traces(0.0, Role.DRAWN), wall.path()
        enclosed, simple = self._enclosure(drawn, Role.LEVEL)
        if meridian.closed:
            loop = closing_lines(path, wall, Role.WALL)
            if self.solid.side is WallSide.INSIDE:
                return enclosed.difference(self._far(self.register.polygon(loop), drawn))
            moved = self.register.polygon(loop, self._near(drawn))
            return moved.difference(enclosed).intersection(self.half_plane())
        kept = drawn
        rim: list[Piece] = []
        if not meridian.rim_on_axis:
            rounded = None
            if self.solid.rim is Rim.ROUND:
                rounded = wall.round_rim(drawn, path)
                if rounded is None:
                    rim_end = (float(meridian.rim[0]), float(meridian.rim[1]))
                    wall.note(RimTooShort(rim_end))
            if rounded is None:
                path = wall.cut_at_rim(path)
            else:
                kept, path, rim = rounded
        allowed = enclosed
        if rim:
            disc = self.register.polygon(
                [*rim, wall.line(Role.RIM, rim[-1].ends[1], rim[0].ends[0])]
            )
            inside = self.solid.side is WallSide.INSIDE
            allowed = enclosed.union(disc) if inside else enclosed.difference(disc)
        if self.solid.side is WallSide.INSIDE:
            material = self._wall_inside(kept, path, rim, enclosed)
            # In a fold narrower than the wall its curve comes out on the other side.
            material = material.intersection(allowed) if simple else material
        else:
            material = self._wall_outside(kept, path, rim, enclosed)
            material = material.difference(allowed) if simple else material
        return self._attached(material.intersection(self.half_plane()), drawn)

    def _attached(self, material: shapely.Geometry, drawn: list[Piece]) -> shapely.Geometry:
        """Return the parts that the drawn curve bounds: others are what loops leave beyond it."""
        size = self.meridian.size
        curve, _ = self._near(drawn)
        shapely.prepare(curve)
        parts = shapely.get_parts(material)
        # As in positive_region: flags that GEOS leaves behind say nothing.
        with np.errstate(all="ignore"):
            close = shapely.dwithin(curve, parts, 1e-9 * size)
        return shapely.MultiPolygon(
            [
                part
                for part in parts[close]
                if isinstance(part, shapely.Polygon) and part.area > SLIVER * size**2
            ]
        )

    def _wall_inside(
        self, drawn: list[Piece], path: list[Piece], rim: list[Piece], enclosed: shapely.Geometry
    ) -> shapely.Geometry:
        meridian, wall, base = self.meridian, self.wall, self.solid.base
        foot, floor = meridian.foot, self.floor
        if not meridian.foot_on_axis:
            path = wall.cut_at_foot(path, floor)
        loop = [*drawn, *rim, *(piece.reversed() for piece in reversed(path))]
        end = path[0].ends[0]
        if not meridian.foot_on_axis and base > 0.0 and end[1] > foot[1]:
            # Whatever lies below the wall's end, down to the foot, is floor.
            loop += self._polyline(Role.FOOT, end, np.array([end[0], foot[1]]), foot)
        else:
            loop += self._polyline(Role.FOOT, end, foot)
        material = self.register.polygon(closing_lines(loop, wall, Role.RIM), self._near(drawn))
        if base == 0.0:
            return material
        slab = self.box(self.wide, self.low, floor, (Role.FOOT, Role.WALL, Role.FLOOR))
        return material.union(enclosed.intersection(slab))

    def _wall_outside(
        self, drawn: list[Piece], path: list[Piece], rim: list[Piece], enclosed: shapely.Geometry
    ) -> shapely.Geometry:
        meridian, wall, base = self.meridian, self.wall, self.solid.base
        foot = meridian.foot
        bottom = float(foot[1]) - base
        slab: shapely.Geometry | None = None
        backwards = [piece.reversed() for piece in reversed(drawn)]
        if meridian.foot_on_axis:
            closing = self._polyline(Role.AXIS, foot, path[0].ends[0])
            punt = meridian.lowest < float(foot[1]) - 1e-9 * meridian.size
            if not punt and base > float(foot[1] - path[0].ends[0, 1]) + 1e-12 * meridian.size:
                slab = self._disc(path, bottom).difference(enclosed)
        else:
            downwards = meridian.end_directions()[0][0][1] > 0.0
            path = wall.cut_at_foot(path, bottom)
            end = path[0].ends[0]
            closing = self._polyline(Role.FOOT, foot, end)
            if base > 0.0 and downwards:
                axis = np.array([(0.0, foot[1]), (0.0, bottom)])
                closing = self._polyline(Role.FLOOR, foot, axis[0])
                closing += self._polyline(Role.AXIS, axis[0], axis[1])
                closing += self._polyline(Role.FOOT, axis[1], np.array([end[0], bottom]), end)
            elif base > 0.0:
                roles = (Role.FOOT, Role.FOOT, Role.FLOOR)
                slab = self.box(float(foot[0]), bottom, float(foot[1]), roles)
                slab = slab.difference(enclosed)
        loop = closing_lines([*path, *rim, *backwards], wall, Role.RIM)
        material = self.register.polygon([*loop, *closing], self._near(drawn))
        whole = material if slab is None else material.union(slab)
        # A groove that the wall closes over is wall, not a void.
        return shapely.multipolygons(
            [
                shapely.Polygon(part.exterior)
                for part in shapely.get_parts(whole)
                if isinstance(part, shapely.Polygon)
            ]
        )

    def _far(self, region: shapely.Geometry, drawn: list[Piece]) -> shapely.Geometry:
        """Return the parts of a ring's hollow that are as far from the drawn curve as the wall."""
        curve, distance = self._near(drawn)
        shapely.prepare(curve)
        parts = shapely.get_parts(region)
        with np.errstate(all="ignore"):
            near = shapely.dwithin(curve, shapely.point_on_surface(parts), distance)
        return shapely.union_all(parts[~near])

    def _near(self, drawn: list[Piece]) -> tuple[shapely.Geometry, float]:
        """Return the drawn curve and a little less than the wall."""
        return shapely.LineString(self.register.samples(drawn)), 0.98 * self.solid.wall

    def _disc(self, path: list[Piece], bottom: float) -> shapely.Geometry:
        """Return the disc below the foot, as wide as the wall's outside is at the foot's height."""
        level = float(self.meridian.foot[1])
        samples = self.register.samples(path)
        low = samples[samples[:, 1] <= level]
        right = float(low[:, 0].max()) if len(low) else float(samples[0, 0])
        return self.box(right, bottom, level, (Role.FOOT, Role.FOOT, Role.FLOOR))

    def _polyline(self, role: Role, *points: Floats) -> list[Piece]:
        return [self.wall.line(role, first, last) for first, last in pairwise(points)]

    def _brim(self, material: shapely.Geometry) -> float:
        """Return how high the body holds a liquid: the height of its crest.

        What reaches from the floor on the axis to its own highest point keeps all below apart.
        """
        return float(material.bounds[3])


@lru_cache(maxsize=8)
def cross_section(surface: RevolutionSurface, solid: Solid) -> CrossSection:
    """Return the exact section of a filled body or a vessel, at the start angle where laws hold.

    Raises SolidError in words where there is none.
    """
    if surface.twist.turns:
        # Slices turn; what they are made of stays.
        return cross_section(replace(surface, twist=Twist()), solid)
    if not surface.laws:
        return section_at(surface, solid)
    if surface.fades:
        return section_at(surface, solid, surface.section)
    return cross_section(RevolutionSurface(surface.profile_at(surface.start)), solid)


def section_at(
    surface: RevolutionSurface, solid: Solid, section: Sections | None = None
) -> CrossSection:
    """Return the section of a body, where laws hold made from that of one angle, (n,)."""
    meridian = meridian_of(surface, section)
    if solid.kind is BodyKind.VESSEL:
        _check_wall(meridian.size, solid)
    offset = solid.wall if solid.side is WallSide.INSIDE else -solid.wall
    offsets = (0.0,) if solid.kind is BodyKind.FILLED else (0.0, offset)
    grids = sample_grids(meridian, offsets, _working(meridian.size, solid))
    check_simple(surface, meridian, grids)
    try:
        return SectionBuilder(meridian, solid, grids).build()
    except shapely.errors.GEOSException:
        # Its overlay gives up on lines that nearly coincide all along.
        raise SolidError(NoBodyFor.NOT_RESOLVED) from None


def _check_wall(size: float, solid: Solid) -> None:
    """Refuse a wall too thin to be told from none, and one larger than the shape itself."""
    low, high = LEAST_WALL * size, MOST_WALL * size
    if not low <= solid.wall <= high:
        raise SolidError(WallOutOfReach(solid.wall, low, high))


def _working(size: float, solid: Solid) -> float:
    thin = solid.wall / 16.0 if solid.kind is BodyKind.VESSEL else size
    return max(min(WORKING * size, thin), 1e-6 * size)


def working_tolerance(section: CrossSection, solid: Solid) -> float:
    """Return how closely the samples that decide a section's topology follow its curves."""
    return _working(section.meridian.size, solid)
