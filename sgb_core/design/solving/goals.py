"""What targets measure, with derivatives by the quartic points."""

from __future__ import annotations

from dataclasses import replace
from enum import StrEnum
from typing import Protocol

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.bodies.cross_section import CrossSection, cross_section
from sgb_core.bodies.flux import flux
from sgb_core.bodies.meridian import Meridian
from sgb_core.bodies.outline import Arc, Piece, Trace
from sgb_core.bodies.solid import BodyKind, Solid, WallSide
from sgb_core.curves import basis
from sgb_core.curves.nodes import panels
from sgb_core.design.demands import measures
from sgb_core.design.demands.chain import Chain
from sgb_core.design.demands.measures import Measured
from sgb_core.findings.errors import FindingError
from sgb_core.findings.solving import NoTarget
from sgb_core.surfaces.curvature import cross
from sgb_core.surfaces.revolution import RevolutionSurface

# Panels and points of each for the derivatives of a body's volumes.
_PANELS, _POINTS = 6, 10
# Of the size: nearer than this is in the same place; and the step of differences.
_SAME, _STEP = 1e-9, 1e-6
# A leg fraction below this moves nothing that differences could tell.
_SHORT = 1e-3


class Goal(StrEnum):
    """What can be a target; MATERIAL is the volume of the material. Lengths in the unit."""

    CAPACITY = "capacity"
    VOLUME = "volume"
    MATERIAL = "material"
    HEIGHT = "height"
    MAX_DIAMETER = "max_diameter"
    RIM_DIAMETER = "rim_diameter"
    FOOT_DIAMETER = "foot_diameter"


class GoalMeasure(Protocol):
    """A measure of chains, in the document's unit."""

    def value(self, chain: Chain) -> float:
        """Return the value alone."""
        ...

    def __call__(self, chain: Chain) -> Measured:
        """Return the value with its slopes by the chain's quartic points."""
        ...


def goal_measure(goal: Goal, surface: RevolutionSurface, solid: Solid, start: Chain) -> GoalMeasure:
    """Return a goal's measure of chains that come from a surface's profile, ``start``.

    Values are in the document's unit, slopes by the chain's quartic points. Raises FindingError
    for a goal that this profile or body does not have, the measure SolidError where the body
    cannot be made.
    """
    if goal in (Goal.CAPACITY, Goal.MATERIAL):
        if solid.kind is BodyKind.SURFACE:
            raise FindingError(NoTarget.NO_BODY)
        if goal is Goal.CAPACITY and solid.kind is not BodyKind.VESSEL:
            raise FindingError(NoTarget.NO_CAPACITY)
        return _Body(goal, surface, solid, start)
    if goal in (Goal.RIM_DIAMETER, Goal.FOOT_DIAMETER) and surface.profile.closed:
        raise FindingError(NoTarget.NO_ENDS)
    return _Drawn(goal, surface.sweep / (2.0 * np.pi))


class _Drawn:
    """A measure of the drawn surface; ``share`` is the part of a full turn."""

    def __init__(self, goal: Goal, share: float) -> None:
        self._goal, self._share = goal, share

    def value(self, chain: Chain) -> float:
        """Return the value alone."""
        return self(chain).value

    def __call__(self, chain: Chain) -> Measured:
        goal = self._goal
        quartics = chain.quartics
        if goal is Goal.VOLUME:
            found, factor = measures.volume(quartics), self._share * chain.size**3
            return _times(found, factor if found.value >= 0.0 else -factor)
        if goal is Goal.HEIGHT:
            return _times(measures.height(quartics), chain.size)
        if goal is Goal.MAX_DIAMETER:
            return _times(measures.largest_diameter(quartics), chain.size)
        return _times(measures.end_diameter(quartics, goal is Goal.RIM_DIAMETER), chain.size)


def _times(found: Measured, factor: float) -> Measured:
    bend = None if found.bend is None else found.bend * factor
    return Measured(found.value * factor, found.slope * factor, bend)


class _Body:
    """Capacity or material of the body over a chain.

    Under a change δP of the boundary ∮ r² dh changes by ∮ 2 r δP·n |dP|, n the normal to the right
    of the travel. A wall's curve moves along its normal as the drawn one does, an arc with the
    joint about which it runs, brim and floor with the end of the profile that they start from.
    What else closes the wall at an open end (a rounded lip, a wall that goes on straight) depends
    on that end and its leg alone; there the derivatives are central differences.
    """

    def __init__(self, goal: Goal, surface: RevolutionSurface, solid: Solid, start: Chain) -> None:
        self._goal, self._surface, self._solid, self._start = goal, surface, solid, start

    def __call__(self, chain: Chain) -> Measured:
        section, pieces = self._section(chain)
        slope = np.zeros((len(chain), 5, 2))
        known = [_add(piece, self._solid, section, chain, slope) for piece in pieces]
        if section.meridian.mirrored:
            slope[..., 0] *= -1.0
        share = 0.5 * self._surface.sweep
        # By the chain's points, which are told in its size.
        slope *= share * chain.size
        if not all(known):
            self._correct(chain, section, slope)
        return Measured(share * flux(pieces), slope.reshape(len(chain), 10))

    def value(self, chain: Chain) -> float:
        """Return the value alone, which takes a part of the time."""
        return 0.5 * self._surface.sweep * flux(self._section(chain)[1])

    def _section(self, chain: Chain) -> tuple[CrossSection, list[Piece]]:
        profile = chain.profile(self._surface.profile, self._start)
        section = cross_section(replace(self._surface, profile=profile), self._solid)
        if self._goal is Goal.CAPACITY and section.brim is None:
            raise FindingError(NoTarget.NO_CAPACITY)
        outlines = section.outlines if self._goal is Goal.MATERIAL else section.cavity
        return section, [p for outline in outlines for ring in outline.rings for p in ring]

    def _correct(self, chain: Chain, section: CrossSection, slope: Floats) -> None:
        """Set the slopes by the outermost two quartic points of the ends off the axis."""
        ends = ((0, 0, 1, 0, 1, 0), (len(chain) - 1, 3, 2, 4, 3, 2))
        for segment, end, leg, outer, inner, part in ends:
            fraction = float(chain.fractions[segment, part])
            if abs(float(chain.points[segment, end, 0])) <= _SAME or fraction < _SHORT:
                continue
            # Q2 goes with P1 by b, with P2 by 1 − b.
            b = float(chain.fractions[segment, 1])
            middle = b if end == 0 else 1.0 - b
            by_end = self._differences(chain, segment, end)
            by_leg = self._differences(chain, segment, leg)
            slope[segment, inner] = (by_leg - middle * slope[segment, 2]) / fraction
            slope[segment, outer] = by_end - (1.0 - fraction) * slope[segment, inner]

    def _differences(self, chain: Chain, segment: int, point: int) -> Floats:
        found = np.zeros(2)
        for axis in range(2):
            values = []
            for step in (_STEP, -_STEP):
                blocks = chain.blocks.copy()
                blocks[segment, 3 + 2 * point + axis] += step
                pieces = self._section(chain.with_blocks(blocks))[1]
                values.append(0.5 * self._surface.sweep * flux(pieces))
            found[axis] = (values[0] - values[1]) / (2.0 * _STEP)
        return found


def _add(piece: Piece, solid: Solid, section: CrossSection, chain: Chain, slope: Floats) -> bool:
    """Add what ∫ r² dh along a piece gains as the quartic points move; False where not known."""
    meridian = section.meridian
    if piece.start == piece.end or not np.abs(piece.ends[:, 0]).max() > _SAME * meridian.size:
        return True
    low, high = min(piece.start, piece.end), max(piece.start, piece.end)
    u, weights = panels(np.linspace(low, high, _PANELS + 1), _POINTS)
    speed = np.hypot(*piece.velocity(u).T)
    pull = (2.0 * piece.points(u)[:, 0] * speed * weights)[:, None] * piece.normals(u)
    if isinstance(piece, Trace):
        # Where the wall's curve runs back, its normal is that of the travel nonetheless.
        forward = (piece.velocity(u) * piece.tangents(u)).sum(axis=1)
        pull *= np.where(forward < 0.0, -1.0, 1.0)[:, None]
        rows = basis.bernstein(4, u).T @ pull
        slope[piece.segment] += rows[::-1] if meridian.reverse else rows
        return True
    if isinstance(piece, Arc):
        key = _joint_at(chain, meridian, np.asarray(piece.centre))
        if key is not None:
            slope[key] += pull.sum(axis=0)
        return key is not None
    if piece.ends[0, 1] != piece.ends[1, 1]:
        return _add_extension(piece, u, pull, solid, meridian, slope)
    moves = _level(float(piece.ends[0, 1]), solid, section, chain)
    if moves is None:
        return False
    slope[..., 1] += pull[:, 1].sum() * moves
    return True


def _add_extension(
    piece: Piece, u: Floats, pull: Floats, solid: Solid, meridian: Meridian, slope: Floats
) -> bool:
    """Add a line that goes on from the wall's end along the last leg, and turns with it.

    δP·n = δQ·n + t (δQ − δQ')·n / |Q − Q'|, t along it from the end Q, whose leg begins at Q'.
    """
    for row, end, following in ((0, 0, 1), (-1, 4, 3)):
        quartic = meridian.quartics[row]
        leg = quartic[end] - quartic[following]
        length = float(np.hypot(leg[0], leg[1]))
        if length <= _SAME * meridian.size:
            continue
        along = leg / length
        away = abs(float(cross(piece.ends[0] - quartic[end], along)))
        turned = abs(float(cross(piece.tangents(u[:1])[0], along)))
        if turned > _SAME or abs(away - solid.wall) > _SAME * meridian.size:
            continue
        parts = ((piece.points(u) - quartic[end]) @ along / length)[:, None]
        own, other = (4 - end, 4 - following) if meridian.reverse else (end, following)
        slope[meridian.numbers[row], own] += (pull * (1.0 + parts)).sum(axis=0)
        slope[meridian.numbers[row], other] -= (pull * parts).sum(axis=0)
        return True
    return False


def _joint_at(chain: Chain, meridian: Meridian, place: Floats) -> tuple[int, int] | None:
    """Return the quartic point (segment, number) of a joint at a place."""
    away = np.hypot(*np.moveaxis(meridian.quartics[1:, 0] - place, -1, 0))
    near = np.flatnonzero(away <= _SAME * meridian.size)
    if len(near) == 0:
        return None
    return meridian.numbers[int(near[0]) + 1], 4 if meridian.reverse else 0


def _level(height: float, solid: Solid, section: CrossSection, chain: Chain) -> Floats | None:
    """Return how a level line moves with the quartic points' heights, (n, 5); None if unknown."""
    meridian = section.meridian
    moves = np.zeros((len(chain), 5))
    top = float(meridian.rim[1]) if section.brim is None else section.brim
    base = solid.base if solid.side is WallSide.INSIDE else -solid.base

    def at(level: float) -> bool:
        return abs(height - level) <= _SAME * meridian.size

    if at(top):
        moves[measures.end_of(chain.quartics, upper=True)] = 1.0
    elif at(float(meridian.foot[1])) or at(float(meridian.foot[1]) + base):
        moves[measures.end_of(chain.quartics, upper=False)] = 1.0
    elif at(meridian.lowest) or at(meridian.lowest + base):
        moves += measures.lowest(chain.quartics).slope.reshape(-1, 5, 2)[..., 1]
    else:
        return None
    return moves
