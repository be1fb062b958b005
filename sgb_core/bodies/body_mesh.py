"""The mesh of a body: the rows of its section's outlines, turned about the axis."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import lru_cache
from math import acos, ceil, pi

import numpy as np

from sgb_core.arrays import Floats, distinct
from sgb_core.bodies.cross_section import CrossSection, cross_section, section_at
from sgb_core.bodies.meridian import SolidError, sample_grids
from sgb_core.bodies.outer_face import OuterFace, drawn_runs
from sgb_core.bodies.outline import Arc, Piece, Trace
from sgb_core.bodies.region import parameters
from sgb_core.bodies.solid import BodyKind, Solid, WallSide
from sgb_core.bodies.solid_mesh import (
    PieceRows,
    are_simple,
    loop_of,
    ring_section,
    rows_of,
    sweep_rings,
    thick_parts,
    widest,
)
from sgb_core.bodies.varying_solid import sections_at, varying_rows
from sgb_core.findings.bodies import NoBodyFor
from sgb_core.surfaces.displacement import MOST_TRIANGLES, Relief
from sgb_core.surfaces.fineness import Fineness
from sgb_core.surfaces.helix import UNTWISTED, helix_limits
from sgb_core.surfaces.mesh import Mesh
from sgb_core.surfaces.relief import NEAR, Heights, ReliefField, refined
from sgb_core.surfaces.revolution import RevolutionSurface
from sgb_core.surfaces.sampling import (
    check_triangle_count,
    columns_for_radius,
    samples_for_tolerance,
)
from sgb_core.surfaces.section import MERGE
from sgb_core.surfaces.tessellation import tessellate
from sgb_core.surfaces.turn import Turn, closed_up, turn_of
from sgb_core.surfaces.twist import Twist
from sgb_core.surfaces.uv import uv_map_of

# So many of the sections of a varying profile decide how finely all are sampled.
MOST_COMPARED = 12
LARGEST_ARC_STEP = pi / 6.0
# A section whose coarse samples cross is sampled twice as finely, at most so many times.
REFINEMENTS = 3
# Steps of s in a segment with which the generatrix is looked up.
STEPS = 128


def body_mesh(
    surface: RevolutionSurface,
    solid: Solid,
    *,
    tolerance: float | None = None,
    samples: tuple[int, int] | None = None,
) -> Mesh:
    """Return the mesh of a body: for kind "surface" the surface's own, else always watertight.

    ``tolerance`` (in unit, default 1e-3 of the profile's size) bounds the distance to the true
    body; ``samples`` = (NS, NT) fixes the intervals per segment and around instead. Raises
    SolidError where the body cannot be made, ValueError as :func:`tessellate` does.
    """
    return relieved_mesh(surface, solid, None, tolerance=tolerance, samples=samples)[0]


def relieved_mesh(
    surface: RevolutionSurface,
    solid: Solid,
    heights: Heights | None,
    *,
    tolerance: float | None = None,
    samples: tuple[int, int] | None = None,
    most: int = MOST_TRIANGLES,
) -> tuple[Mesh, Relief | None]:
    """Return the mesh of a body whose outer face is moved by ``heights``, and what became of them.

    Half of the tolerance is for the heights, whose rows and columns come on top of ``samples``;
    raises FindingError where that makes more than the ``most`` triangles.
    """
    limit = Fineness(tolerance, samples).within(surface.profile.size)
    if heights is not None:
        limit /= 2.0
        tolerance = None if samples is not None else limit
    if solid.kind is BodyKind.SURFACE:
        relief = None if heights is None else _drawn_relief(surface, heights, limit, most)
        return tessellate(surface, tolerance=tolerance, samples=samples, relief=relief), relief
    size = surface.profile.size
    section = cross_section(surface, solid)
    reach = widest(section)
    if surface.sweep * reach < MERGE * size:
        raise SolidError(NoBodyFor.TOO_NARROW)
    surface = closed_up(surface, reach, MERGE * size)
    columns = _columns(surface, section, limit, samples)
    turn = turn_of(surface, columns)
    held = _sections(surface, solid, section, turn)
    relief, face = None, None
    if heights is not None:
        relief, face = _body_relief(surface, solid, heights, held, limit, most)
        turn = turn_of(surface, columns, more=relief.columns)
        held = _sections(surface, solid, section, turn)
    for attempt in range(REFINEMENTS + 1):
        sampler = sampler_of(held, solid, 0.45 * limit, samples, 2**attempt)
        if surface.twisting is not None:
            sampler = _along_helices(sampler, surface, columns, limit)
        if relief is not None and face is not None:
            sampler = _with_relief(sampler, relief, face)
        parts = _rows(surface, held, turn, sampler, face)
        rings = [ring for part in parts for ring in part]
        count = sum(rows.points.shape[1] for ring in rings for rows in ring)
        check_triangle_count(count, len(turn.angles))
        if relief is not None:
            relief.check_count(count, len(turn.angles))
        # Where laws hold the sections at both ends and at the middle stand for all.
        probes = {0, len(turn.angles) // 2, -1} if surface.laws else {0}
        if all(
            are_simple([loop_of(ring, k, size) for ring in part]) for part in parts for k in probes
        ):
            break
    # A hole of two samples is none.
    sections = [
        tuple(ring_section(ring, size) for ring in part if len(loop_of(ring, 0, size)) > 2)
        for part in thick_parts(parts, probes, size)
    ]
    return sweep_rings(sections, turn, surface, section.meridian.mirrored, relief), relief


def _rows(
    surface: RevolutionSurface,
    held: Sequence[CrossSection],
    turn: Turn,
    sampler: Callable[[Piece], Floats],
    face: OuterFace | None,
) -> list[list[list[PieceRows]]]:
    """Return for each part and each of its rings the rows."""
    if surface.laws:
        return varying_rows(surface, held, turn, sampler, face)
    size = surface.profile.size
    return [
        [rows_of(ring, size, sampler, face) for ring in outline.rings]
        for outline in held[0].outlines
    ]


def _drawn_relief(surface: RevolutionSurface, heights: Heights, limit: float, most: int) -> Relief:
    uv_map = uv_map_of(surface, STEPS)
    faces = (drawn_runs(surface, uv_map),)
    whole = surface.is_full_turn
    return Relief.of(ReliefField(heights, uv_map, surface.sweep, whole, faces), limit, most)


def _body_relief(
    surface: RevolutionSurface,
    solid: Solid,
    heights: Heights,
    held: Sequence[CrossSection],
    limit: float,
    most: int,
) -> tuple[Relief, OuterFace]:
    """Return the relief of a body with these sections, and its outer face."""
    uv_map = uv_map_of(surface, STEPS)
    face = OuterFace.of(held[0], solid, uv_map.share)
    different = {id(each): each for each in held}.values()
    faces = tuple(dict.fromkeys(face.runs(each) for each in different))
    whole = surface.is_full_turn
    field = ReliefField(heights, uv_map, surface.sweep, whole, faces)
    return Relief.of(field, limit, most), face


def _with_relief(
    sampler: Callable[[Piece], Floats], relief: Relief, face: OuterFace
) -> Callable[[Piece], Floats]:
    """Return the sampling with the rows that heights need on the outer face."""

    def sampled(piece: Piece) -> Floats:
        u = sampler(piece)
        if not isinstance(piece, Trace):
            return u
        more = face.parameters(piece, relief.rows[piece.segment])
        low, high = min(piece.start, piece.end), max(piece.start, piece.end)
        dense = refined(np.sort(u), more[(more > low) & (more < high)], NEAR)
        return dense if piece.end >= piece.start else dense[::-1]

    return sampled


def _sections(
    surface: RevolutionSurface, solid: Solid, section: CrossSection, turn: Turn
) -> list[CrossSection]:
    """Return the sections at the columns, one alone where no laws hold."""
    if not surface.laws:
        return [section]
    untwisted = replace(surface, twist=Twist())
    return list(_held(untwisted, solid, turn.angles.tobytes()))


@lru_cache(maxsize=4)
def _held(surface: RevolutionSurface, solid: Solid, angles: bytes) -> tuple[CrossSection, ...]:
    """Return the sections at angles; a twist drags on the same ones."""
    return tuple(sections_at(surface, solid, np.frombuffer(angles), section_at))


def _along_helices(
    sampler: Callable[[Piece], Floats], surface: RevolutionSurface, columns: int, limit: float
) -> Callable[[Piece], Floats]:
    """Return the sampling with what a twist needs between: lines, too, are curves then."""
    limits, twisting = helix_limits(surface, columns, limit), surface.twisting
    assert twisting is not None

    def sampled(piece: Piece) -> Floats:
        u = sampler(piece)
        return limits.refined(u, piece.points(u), twisting)

    return sampled


def _columns(
    surface: RevolutionSurface,
    section: CrossSection,
    limit: float,
    samples: tuple[int, int] | None,
) -> int:
    if samples is not None:
        return samples[1]
    share = limit if surface.twisting is None else UNTWISTED * limit
    columns = columns_for_radius(surface, widest(section), 0.45 * share)
    if not surface.laws:
        return columns
    varying = samples_for_tolerance(surface, limit)[1]
    return varying * ceil(columns / varying)


def sampler_of(
    sections: Sequence[CrossSection],
    solid: Solid,
    limit: float,
    samples: tuple[int, int] | None,
    finer: int,
) -> Callable[[Piece], Floats]:
    """Return the function that gives the parameters at which a mesh samples a piece."""
    meridian = sections[0].meridian
    if samples is None:
        offset = solid.wall if solid.side is WallSide.INSIDE else -solid.wall
        offsets = (0.0,) if solid.kind is BodyKind.FILLED else (0.0, offset)
        grids = sample_grids(meridian, offsets, limit / finer**2, least=1)
        different = list({id(section): section for section in sections}.values())
        for other in different[1 :: max(1, len(different) // MOST_COMPARED)]:
            for number, s in sample_grids(
                other.meridian, offsets, limit / finer**2, least=1
            ).items():
                grids[number] = _merged(grids[number], s)
    else:
        even = np.linspace(0.0, 1.0, samples[0] * finer + 1)
        grids = dict.fromkeys(meridian.numbers, even)

    def sampled(piece: Piece) -> Floats:
        step = LARGEST_ARC_STEP / finer
        if samples is not None:
            step = min(step, pi / samples[0])
        elif isinstance(piece, Arc):
            step = min(step, 2.0 * acos(max(1.0 - limit / piece.radius, 0.0)) / finer)
        return parameters(piece, grids, max(step, 1e-3))

    return sampled


def _merged(first: Floats, second: Floats) -> Floats:
    # Extremes differ a little from angle to angle: of such a group one is enough.
    near = np.abs(second[:, None] - first).min(axis=1)
    return distinct(first, second[near > 2e-3])
