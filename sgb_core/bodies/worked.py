"""A body as it is in the end: its outer face raised and sunk, its wall pierced."""

from __future__ import annotations

from functools import lru_cache

from sgb_core.bodies.body_mesh import relieved_mesh
from sgb_core.bodies.hole_pattern import Pattern
from sgb_core.bodies.meridian import SolidError
from sgb_core.bodies.pierced import pierced
from sgb_core.bodies.solid import BodyKind, Solid
from sgb_core.bodies.vessel import vessel_measures
from sgb_core.findings.errors import FindingError
from sgb_core.findings.finding import Finding
from sgb_core.findings.relief import EdgeWidened, ReliefHeldBack, ReliefPierces, ThinUnderRelief
from sgb_core.findings.surfaces import TooManyTriangles
from sgb_core.surfaces.displacement import MOST_TRIANGLES, Relief
from sgb_core.surfaces.fineness import Fineness
from sgb_core.surfaces.mesh import Mesh
from sgb_core.surfaces.relief import Heights
from sgb_core.surfaces.revolution import RevolutionSurface
from sgb_core.values import dataclass

# What is shown and measured with relief and holes is of a mesh within this part of the size; with
# relief of one that has at most so many triangles, and is that many times as coarse for it.
WITHIN = 5e-4
MOST_SHOWN = 600_000
COARSER = (2.0, 4.0, 8.0, 16.0)
# A relief that leaves less than this part of the wall is doubtful.
THIN = 0.4
# Less than this part of what was asked for is not worth a word.
_NOTED = 0.05


@dataclass(frozen=True, slots=True, eq=False)
class Worked:
    """A mesh with its relief and its ``count`` holes.

    It is ``within`` that distance of the true body. ``added`` is the volume that the relief adds,
    negative where it takes more, ``removed`` what the holes take, in unit³. ``wall_min`` is the
    smallest thickness of the wall below the relief, None for what has no wall.
    """

    mesh: Mesh
    count: int = 0
    removed: float = 0.0
    added: float = 0.0
    wall_min: float | None = None
    within: float = 0.0
    doubts: tuple[Finding, ...] = ()


def worked_mesh(
    surface: RevolutionSurface,
    solid: Solid,
    patterns: tuple[Pattern, ...],
    heights: Heights | None,
    *,
    tolerance: float | None = None,
    samples: tuple[int, int] | None = None,
    most: int = MOST_TRIANGLES,
) -> Worked:
    """Return a body with relief and holes, as fine as for :func:`body_mesh`.

    Raises SolidError where a relief would pierce the wall, for what the cut-outs cannot be, and
    where there is no body.
    """
    mesh, relief = relieved_mesh(
        surface, solid, heights, tolerance=tolerance, samples=samples, most=most
    )
    wall, doubts = _below(surface, solid, relief)
    added = 0.0 if relief is None else relief.added
    within = Fineness(tolerance, samples).within(surface.profile.size)
    outward = 0.0 if heights is None else heights.reach[1]
    if not patterns:
        return Worked(mesh, 0, 0.0, added, wall, within, doubts)
    cut = pierced(surface, solid, patterns, mesh, outward, within)
    return Worked(cut.mesh, cut.count, cut.removed, added, wall, within, doubts)


@lru_cache(maxsize=4)
def worked_body(
    surface: RevolutionSurface,
    solid: Solid,
    patterns: tuple[Pattern, ...],
    heights: Heights | None,
) -> Worked:
    """Return a body as it is shown and measured: a mesh that can be drawn; errors as above."""
    size = surface.profile.size
    if heights is None:
        return worked_mesh(surface, solid, patterns, None, tolerance=WITHIN * size)
    for times in COARSER[:-1]:
        try:
            return worked_mesh(
                surface,
                solid,
                patterns,
                heights,
                tolerance=times * WITHIN * size,
                most=MOST_SHOWN,
            )
        except FindingError as error:
            if not isinstance(error.finding, TooManyTriangles):
                raise
    return worked_mesh(surface, solid, patterns, heights, tolerance=COARSER[-1] * WITHIN * size)


def _below(
    surface: RevolutionSurface, solid: Solid, relief: Relief | None
) -> tuple[float | None, tuple[Finding, ...]]:
    """Return the thinnest wall below a relief, and what is doubtful about it.

    No point of the outer face is nearer to the inner one than the wall less what it sank.
    """
    wall = None
    if solid.kind is BodyKind.VESSEL:
        wall = vessel_measures(surface, solid).wall_min
    if relief is None:
        return wall, ()
    doubts: list[Finding] = []
    low, high = relief.heights.source.reach
    if relief.held_back > _NOTED * max(-low, high):
        doubts.append(ReliefHeldBack(relief.held_back))
    narrowest = relief.heights.source.edges[0]
    if narrowest < relief.heights.least:
        doubts.append(EdgeWidened(narrowest, relief.heights.least))
    if wall is None or relief.lowest == 0.0:
        return wall, tuple(doubts)
    whole = min(wall, solid.base) if solid.base > 0.0 else wall
    left = whole + relief.lowest
    if left <= 1e-3 * whole:
        raise SolidError(ReliefPierces(-relief.lowest, whole))
    if left < THIN * whole:
        doubts.append(ThinUnderRelief(left, whole))
    return min(wall, left), tuple(doubts)
