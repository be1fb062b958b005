"""What a body measures: what it holds, what it is made of, how thin its wall is, what to glaze.

Volumes and areas are integrals over the exact outlines of the section, not taken from a mesh.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from functools import lru_cache

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.bodies.cross_section import (
    CrossSection,
    cross_section,
    section_at,
    working_tolerance,
)
from sgb_core.bodies.flux import flux, swept_area
from sgb_core.bodies.meridian import SolidError
from sgb_core.bodies.outline import Arc, Piece, Role, Trace
from sgb_core.bodies.rays import first_meetings
from sgb_core.bodies.region import Outline, parameters
from sgb_core.bodies.solid import BodyKind, Solid, WallSide
from sgb_core.bodies.thickness import least_distance
from sgb_core.bodies.varying_solid import sections_at
from sgb_core.findings.bodies import DoubtfulPlace, NoBody
from sgb_core.interruption import checkpoint
from sgb_core.surfaces.angular import representative_angles
from sgb_core.surfaces.revolution import RevolutionSurface
from sgb_core.surfaces.twist import Twist
from sgb_core.values import dataclass

# Gauss points between two angles where a law is not smooth or turns back.
ANGLES = 12
# What is neither inside nor outside to glaze.
_BARE = (Role.AXIS, Role.FOOT, Role.HOLE, Role.LEVEL)


@dataclass(frozen=True, slots=True)
class VesselMeasures:
    """Measures of a filled body or a vessel, lengths in unit.

    ``capacity`` is the volume of the cavity up to the brim (the crest of the body standing
    upright; drain hole ignored), None for what has no rim; ``brim`` that height above h = 0 and
    ``floor`` the lowest height of the cavity. ``wall_min`` is the smallest thickness of the wall
    without rim and floor, None for filled bodies. ``inner_area`` is that of the cavity's walls,
    ``outer_area`` that of the rest without underside and foot ring. ``findings`` are what is
    doubtful.
    """

    capacity: float | None
    material_volume: float
    wall_min: float | None
    inner_area: float
    outer_area: float
    brim: float | None
    floor: float | None
    findings: tuple[DoubtfulPlace, ...]


@lru_cache(maxsize=8)
def vessel_measures(surface: RevolutionSurface, solid: Solid) -> VesselMeasures:
    """Return the measures of a body that is not a bare surface.

    Those of a part of a turn are its share of a full one. With laws areas are those of the
    meridians, without the ripple that the angle adds. A twist changes the thinnest wall alone.
    Raises SolidError where the body cannot be made and for kind "surface".
    """
    if solid.kind is BodyKind.SURFACE:
        raise SolidError(NoBody.BARE)
    if surface.twist.turns:
        found = vessel_measures(replace(surface, twist=Twist()), solid)
        if surface.twisting is None or not surface.laws or found.wall_min is None:
            return found
        return replace(found, wall_min=min(found.wall_min, least_distance(surface, solid)))
    shares, sections = _sections(surface, solid)
    brims = [section.brim for section in sections if section.brim is not None]
    # A liquid stands no higher than the lowest place of the rim.
    brim = min(brims) if len(brims) == len(sections) else None
    material = inner = outer = 0.0
    for share, section in zip(shares.tolist(), sections, strict=True):
        checkpoint()
        whole = swept_area(_pieces(section.outlines, bare=False))
        wetted = swept_area(_wetted(section))
        material += share * 0.5 * flux(_pieces(section.outlines))
        inner, outer = inner + share * wetted, outer + share * (whole - wetted)
    floors = [low for section in sections if (low := _lowest(section.cavity)) is not None]
    return VesselMeasures(
        capacity=None if brim is None else _held(shares, sections, brim),
        material_volume=material,
        wall_min=_thinnest(surface, solid, sections),
        inner_area=inner,
        outer_area=outer,
        brim=brim,
        floor=min(floors) if floors else None,
        findings=_findings(sections),
    )


def section_findings(surface: RevolutionSurface, solid: Solid) -> tuple[DoubtfulPlace, ...]:
    """Return what is doubtful about a body's sections, named once for all angles.

    Raises SolidError where the body cannot be made.
    """
    return _findings(_sections(surface, solid)[1])


def _findings(sections: Iterable[CrossSection]) -> tuple[DoubtfulPlace, ...]:
    """Return what is doubtful about sections, named once for all angles."""
    found: list[DoubtfulPlace] = []
    for section in sections:
        known = {finding.subject for finding in found}
        found += [finding for finding in section.findings if finding.subject not in known]
    return tuple(found)


def _sections(surface: RevolutionSurface, solid: Solid) -> tuple[Floats, list[CrossSection]]:
    """Return the different sections to integrate over, and the angle that each stands for."""
    if not surface.laws:
        return np.array([surface.sweep]), [cross_section(surface, solid)]
    theta, weights = representative_angles(surface, ANGLES)
    shares: dict[int, float] = {}
    sections = sections_at(surface, solid, theta, section_at)
    for section, weight in zip(sections, weights.tolist(), strict=True):
        shares[id(section)] = shares.get(id(section), 0.0) + weight
    different = {id(section): section for section in sections}
    return np.array(list(shares.values())), list(different.values())


def _held(shares: Floats, sections: list[CrossSection], height: float) -> float:
    return sum(
        float(share) * 0.5 * flux(_pieces(section.filled_to(height)))
        for share, section in zip(shares, sections, strict=True)
    )


def _thinnest(
    surface: RevolutionSurface, solid: Solid, sections: list[CrossSection]
) -> float | None:
    if solid.kind is not BodyKind.VESSEL:
        return None
    found = [wall_min(section, solid) for section in sections]
    flat = [width for width in found if width is not None]
    if not flat or not surface.laws:
        return min(flat, default=None)
    return min(*flat, least_distance(surface, solid))


def capacity_to(surface: RevolutionSurface, solid: Solid, height: float) -> float | None:
    """Return the volume of the cavity below a height (an h of the profile), in unit³.

    At most to the brim; 0 below the floor; None for what has no rim. Errors as for
    :func:`vessel_measures`.
    """
    if solid.kind is not BodyKind.VESSEL:
        return None
    shares, sections = _sections(surface, solid)
    brims = [section.brim for section in sections if section.brim is not None]
    if len(brims) < len(sections):
        return None
    return _held(shares, sections, min(height, *brims))


def _pieces(outlines: Iterable[Outline], bare: bool = True) -> list[Piece]:
    return [
        piece
        for outline in outlines
        for ring in outline.rings
        for piece in ring
        if bare or piece.role not in _BARE
    ]


def _wetted(section: CrossSection) -> list[Piece]:
    """Return the cavity's walls, without a flat rim that rounding puts just below the brim."""
    pieces = _pieces(section.hollow, bare=False)
    if section.brim is None:
        return pieces
    top = section.brim - 1e-9 * section.meridian.size
    return [p for p in pieces if p.role is not Role.RIM or p.ends[:, 1].min() < top]


def _lowest(outlines: Iterable[Outline]) -> float | None:
    ends = [piece.ends[:, 1].min() for piece in _pieces(outlines)]
    return float(min(ends)) if ends else None


def wall_min(section: CrossSection, solid: Solid) -> float | None:
    """Return the smallest thickness of the wall, leaving out rim and floor.

    By construction the wall's curve keeps ``wall`` from the drawn one; it is thinner only where two
    stretches of the drawn profile come closer to each other, which rays across the material find.
    None where nothing of the wall's curve is left.
    """
    pieces = _pieces(section.outlines, bare=False)
    if not any(p.role is Role.WALL and isinstance(p, Trace | Arc) for p in pieces):
        return None
    checkpoint()
    grids = section.grids
    meridian = section.meridian
    starts: list[Floats] = []
    ends: list[Floats] = []
    normals: list[Floats] = []
    for piece in pieces:
        if piece.role is not Role.DRAWN:
            continue
        u = parameters(piece, grids)
        points, out = piece.points(u), piece.normals(u)
        middle = out[:-1] + out[1:]
        starts.append(points[:-1])
        ends.append(points[1:])
        normals.append(middle / np.hypot(middle[:, 0], middle[:, 1])[:, None])
    if not starts:
        return None
    first, last, out = np.concatenate(starts), np.concatenate(ends), np.concatenate(normals)
    # Rim and floor: near the upper end, and below the floor's upper side.
    middle = (first + last) / 2.0
    away = middle - meridian.rim
    kept = (np.hypot(away[:, 0], away[:, 1]) > 1.5 * solid.wall) | meridian.rim_on_axis
    if solid.side is WallSide.INSIDE and not meridian.closed:
        floor = meridian.lowest if meridian.foot_on_axis else meridian.foot[1]
        kept &= middle[:, 1] > floor + solid.base
    first, last, out = first[kept], last[kept], out[kept]
    middle = (first + last) / 2.0
    across = first_meetings(middle, -out, first, last, out, farthest=solid.wall)
    least = float(across.min(initial=np.inf))
    # Less than the sampling's own error is none.
    return solid.wall if least > solid.wall - 3.0 * working_tolerance(section, solid) else least
