"""Bodies whose section changes with the angle, or that twist, as patches of B-splines.

A patch stands for one piece of the section's outline between two creases of the laws: the tensor
product of splines through points at equal shares of the piece and of the angle. Neighbours share
the sites of the side where they meet, so that their edges are one curve. Sites are doubled until
what lies halfway between them is near enough.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import lru_cache
from itertools import pairwise
from math import ceil, pi
from typing import TypeAlias

import numpy as np

from sgb_core.arrays import Floats, frozen
from sgb_core.bodies.cross_section import section_at
from sgb_core.bodies.meridian import SolidError
from sgb_core.bodies.outline import Role
from sgb_core.bodies.piece_grids import PieceGrid, piece_grids
from sgb_core.bodies.solid import BodyKind, Solid
from sgb_core.bodies.varying_solid import sections_at
from sgb_core.curves.profile import GAP
from sgb_core.exchange.errors import ExportError
from sgb_core.findings.exports import NoStep
from sgb_core.interruption import checkpoint
from sgb_core.surfaces.revolution import RevolutionSurface
from sgb_core.surfaces.section import AXIS
from sgb_core.surfaces.turn import creases
from sgb_core.surfaces.twist import Twist
from sgb_core.values import dataclass

# Fits are quintic, as those of walls are.
DEGREE = 5
# Sites of a piece and of a sector at first, and how often they are doubled at most.
_SITES, _DOUBLED = 9, 5
# More places than this make no small file, and more angles take minutes.
_MOST_PLACES, _MOST_ANGLES = 600_000, 3_000
# The part of the tolerance that fits aim at: between the places looked at they may be farther off.
_AIM = 0.8
# No sector is wider, so that none closes upon itself.
_WIDEST = 2.0 * pi / 3.0
# How far a helical end goes on beyond its section, as a part of the size.
_ASIDE = 1e-5
# Pieces that reach no farther than this part of the size are corners.
_POINT = 1e-9

Grids: TypeAlias = tuple[tuple[tuple[PieceGrid, ...], ...], ...]


@dataclass(frozen=True, slots=True, eq=False)
class Patch:
    """Poles (m, n, 3) along the piece and around, and the clamped knots of both.

    ``deviation`` is the largest distance found from what it stands for, halfway between its sites.
    """

    poles: Floats
    knots: tuple[Floats, Floats]
    degrees: tuple[int, int]
    deviation: float


@dataclass(frozen=True, slots=True, eq=False)
class PatchedRing:
    """The patches of one ring of an outline: rows of pieces, each with one for every sector.

    ``axis`` are the ends (k, 2, 3) of what of the ring lies on the axis.
    """

    rows: tuple[tuple[Patch, ...], ...]
    axis: Floats


@dataclass(frozen=True, slots=True, eq=False)
class PatchedPart:
    """One connected part: its outer ring and those of its holes; ``solid`` where it is closed.

    ``ends`` are the helical faces at the start and the end of a twisted part of a turn, wider than
    the section that bounds them; without any they are flat.
    """

    rings: tuple[PatchedRing, ...]
    solid: bool
    ends: tuple[Patch, ...] = ()

    @property
    def patches(self) -> tuple[Patch, ...]:
        """The patches of all rings."""
        return tuple(patch for ring in self.rings for row in ring.rows for patch in row)

    @property
    def deviations(self) -> tuple[float, ...]:
        """How far each of the faces is off."""
        return tuple(patch.deviation for patch in (*self.patches, *self.ends))


@lru_cache(maxsize=1)
def patched_parts(
    surface: RevolutionSurface, solid: Solid, tolerance: float
) -> tuple[PatchedPart, ...]:
    """Return the parts of a body whose section changes or that twists, within ``tolerance``.

    In the document's unit, placed. Raises ExportError for a body that cannot be made, whose
    section is not the same pieces at every angle, and for what no fit of a fair size follows.
    """
    edges = _sectors(surface)
    along = around = _SITES
    try:
        for _ in range(_DOUBLED + 1):
            angles = around * (len(edges) - 1)
            if angles > _MOST_ANGLES or len(surface.profile) * along * angles > _MOST_PLACES:
                break
            checkpoint()
            parts, off = _fitted(surface, solid, edges, along, around)
            if max(off) <= _AIM * tolerance:
                return parts
            along = 2 * along - 1 if off[0] > 0.5 * _AIM * tolerance else along
            around = 2 * around - 1 if off[1] > 0.5 * _AIM * tolerance else around
    except SolidError as error:
        raise ExportError(error.finding) from error
    raise ExportError(NoStep.NO_PATCHES)


def _sectors(surface: RevolutionSurface) -> Floats:
    marks = np.concatenate([[0.0], creases(surface), [surface.sweep]])
    parts = [
        np.linspace(low, high, ceil((high - low) / _WIDEST) + 1)[:-1]
        for low, high in pairwise(marks.tolist())
    ]
    return np.append(np.concatenate(parts), surface.sweep)


def _fitted(
    surface: RevolutionSurface, solid: Solid, edges: Floats, along: int, around: int
) -> tuple[tuple[PatchedPart, ...], tuple[float, float]]:
    """Return the patches through so many sites, and how far they are off along and around."""
    shares = np.linspace(0.0, 1.0, 2 * along - 1)
    theta = np.unique(
        np.concatenate(
            [
                low + (high - low) * np.linspace(0.0, 1.0, 2 * around - 1)
                for low, high in pairwise(edges.tolist())
            ]
        )
    )
    grids = _grids(surface, solid, theta, shares)
    size, worst = surface.profile.size, [0.0, 0.0]
    closed = solid.kind is BodyKind.SURFACE and _is_closed(surface, grids)
    parts = []
    for part in grids:
        rings = []
        for ring in part:
            rows, axis = [], []
            for grid in ring:
                places = _placed(surface, theta, grid.points)
                if np.abs(grid.points[..., 0]).max() <= AXIS * size:
                    axis.append(places[0, [0, -1]])
                    continue
                if np.ptp(grid.points, axis=1).max() <= _POINT * size:
                    continue
                patches = []
                for k in range(len(edges) - 1):
                    sector = places[2 * (around - 1) * k : 2 * (around - 1) * (k + 1) + 1]
                    patch, off = _patch(sector.swapaxes(0, 1))
                    worst = [max(pair) for pair in zip(worst, off, strict=True)]
                    patches.append(patch)
                rows.append(tuple(patches))
            rings.append(PatchedRing(tuple(rows), np.array(axis).reshape(-1, 2, 3)))
        made = PatchedPart(tuple(rings), solid.kind is not BodyKind.SURFACE or closed)
        if made.solid and surface.twisting is not None and not surface.is_full_turn:
            made = replace(made, ends=_helical_ends(surface, part, max(made.deviations)))
        parts.append(made)
    return tuple(parts), (worst[0], worst[1])


def _grids(surface: RevolutionSurface, solid: Solid, theta: Floats, shares: Floats) -> Grids:
    if solid.kind is not BodyKind.SURFACE:
        untwisted = replace(surface, twist=Twist())
        return piece_grids(sections_at(untwisted, solid, theta, section_at), theta, shares)
    points = surface.sections(theta).on(shares)
    return ((tuple(PieceGrid(Role.DRAWN, points[:, k]) for k in range(points.shape[1])),),)


def _helical_ends(
    surface: RevolutionSurface, part: Sequence[Sequence[PieceGrid]], deviation: float
) -> tuple[Patch, ...]:
    """Return the ruled faces on which the section at the start and at the end lies.

    Their edges are those of the fits, ``deviation`` off. Raises ExportError where the section
    reaches beyond the heights between which it twists: there the face would have an edge.
    """
    # Late: most commands write no STEP.
    from scipy.interpolate import make_interp_spline

    twisting, size = surface.twisting, surface.profile.size
    assert twisting is not None
    points = np.concatenate([grid.points.reshape(-1, 2) for ring in part for grid in ring])
    low, high = float(points[:, 1].min()), float(points[:, 1].max())
    if low < twisting.low - GAP * size or high > twisting.high + GAP * size:
        raise ExportError(NoStep.TWIST)
    sites = np.linspace(0.0, 1.0, 65 + ceil(64.0 * abs(surface.twist.turns)))
    h = low + (high - low) * sites + _ASIDE * size * (2.0 * sites - 1.0)
    held = np.clip(h, low, high)
    turned = twisting.angle(held) + twisting.rate(held) * (h - held)
    reach = float(np.abs(points[:, 0]).max())
    found = []
    for angle in (0.0, surface.sweep):
        axes = surface.directions(surface.start + angle + turned)
        lines = [r * axes[:, 0] + h[:, None] * axes[:, 2] for r in (-1.1 * reach, 1.1 * reach)]
        places = np.array(lines) + np.asarray(surface.placement.translation)
        spline = make_interp_spline(sites, places.swapaxes(0, 1), DEGREE)
        poles = np.ascontiguousarray(spline.c.swapaxes(0, 1))
        knots = (np.array([0.0, 0.0, 1.0, 1.0]), spline.t)
        found.append(Patch(frozen(poles), knots, (1, DEGREE), deviation))
    return tuple(found)


def _is_closed(surface: RevolutionSurface, grids: Grids) -> bool:
    """Whether a bare surface bounds a solid; raises ExportError where it is no one chain."""
    ((chain,),), size = grids, surface.profile.size
    near = GAP * size
    radii = np.concatenate([grid.points[..., 0].ravel() for grid in chain])
    if radii.min() < -near and radii.max() > near:
        raise ExportError(NoStep.CROSSES_AXIS)
    ends = [(grid.points[:, 0], grid.points[:, -1]) for grid in chain]
    if any(float(np.abs(a[1] - b[0]).max()) > near for a, b in pairwise(ends)):
        raise ExportError(NoStep.GAPS)
    first, last = ends[0][0], ends[-1][1]
    if float(np.abs(last - first).max()) <= near:
        return True
    on_axis = max(float(np.abs(end[:, 0]).max()) for end in (first, last)) <= near
    return surface.is_full_turn and on_axis


def _placed(surface: RevolutionSurface, theta: Floats, points: Floats) -> Floats:
    """Return points (M, k, 2) of the half-planes at angles from the start in space, (M, k, 3)."""
    r, h = points[..., 0], points[..., 1]
    axes = surface.directions(surface.turned(surface.start + theta[:, None], h))
    placed = r[..., None] * axes[..., 0, :] + h[..., None] * axes[..., 2, :]
    return np.asarray(placed + np.asarray(surface.placement.translation))


def _patch(places: Floats) -> tuple[Patch, tuple[float, float]]:
    """Return the patch through every second one of places (2m − 1, 2n − 1, 3), and what it misses.

    The distances are the largest at places halfway along, and at all others.
    """
    # Late: most commands write no STEP.
    from scipy.interpolate import BSpline, make_interp_spline

    shares = [np.linspace(0.0, 1.0, (count + 1) // 2) for count in places.shape[:2]]
    sites = places[::2, ::2]
    first = make_interp_spline(shares[0], sites, DEGREE)
    second = make_interp_spline(shares[1], first.c.swapaxes(0, 1), DEGREE)
    poles = np.ascontiguousarray(second.c.swapaxes(0, 1))
    halves = [np.linspace(0.0, 1.0, count) for count in places.shape[:2]]
    across = BSpline(second.t, poles.swapaxes(0, 1), DEGREE)(halves[1]).swapaxes(0, 1)
    made = BSpline(first.t, across, DEGREE)(halves[0])
    off = np.linalg.norm(made - places, axis=-1)
    along, around = float(off[:, ::2].max()), float(off[::2].max())
    patch = Patch(frozen(poles), (first.t, second.t), (DEGREE, DEGREE), float(off.max()))
    return patch, (max(along, float(off.max()) - around), max(around, float(off.max()) - along))
