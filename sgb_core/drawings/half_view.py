"""What a drawing shows of a document: the section on one side, the outside on the other.

Lengths are in millimetres of the object; both halves are given at r ≥ 0.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
import shapely

from sgb_core.arrays import Floats
from sgb_core.bodies.cross_section import cross_section
from sgb_core.bodies.outline import Piece, Ring, Role, Trace
from sgb_core.bodies.outline_cubics import outline_cubics
from sgb_core.bodies.side_view import SideView, circles_of, side_view
from sgb_core.bodies.solid import BodyKind
from sgb_core.document.model import Document
from sgb_core.drawings.errors import DrawingError
from sgb_core.drawings.outside import outside_of_mesh
from sgb_core.drawings.page import Path
from sgb_core.findings.drawings import NoDrawing
from sgb_core.surfaces.revolution import RevolutionSurface
from sgb_core.values import dataclass

# Parts of the size: a level line ends where it is so near to the material; how near its end is
# to the circle that it shows.
_TOUCH, _MEETS = 1e-6, 1e-3
# On what is not higher than the lowest place by this part of the size it stands.
_STANDS = 1e-6
# Ends farther apart than this part of the size are a gap.
_GAP = 1e-9
_PLACES = np.linspace(0.0, 1.0, 33)


@dataclass(frozen=True, slots=True, eq=False)
class HalfView:
    """Section and outside of a document, in mm.

    ``material`` are the rings of each part of the section; ``bare`` the profile where it has no
    material. ``outside`` is what shows of the outline from outside, ``edges`` circles there as
    (radius, height), ``inside`` those behind the section. ``low``, ``high`` and ``reach`` bound
    all of it; ``foot`` is the radius on which it stands, where there is one.
    """

    material: tuple[tuple[Path, ...], ...]
    bare: tuple[Path, ...]
    outside: tuple[Path, ...]
    edges: tuple[tuple[float, float], ...]
    inside: tuple[tuple[float, float], ...]
    low: float
    high: float
    reach: float
    foot: float | None = None

    @property
    def height(self) -> float:
        """How high the object is."""
        return self.high - self.low

    def outside_at(self, heights: Floats) -> Floats:
        """Return how far out the outside is at heights, 0 where there is nothing."""
        found = np.zeros(len(heights))
        for path in self.outside:
            line = path.flat(64)
            order = np.argsort(line[:, 1], kind="stable")
            r = np.interp(heights, line[order, 1], line[order, 0], left=0.0, right=0.0)
            found = np.maximum(found, r)
        return found


def half_view(document: Document, tolerance: float, mirror: float = 1.0) -> HalfView:
    """Return both halves with curves within ``tolerance`` (mm of the object).

    Where laws hold the section is that at the start angle, and the outside, as where there are
    cut-outs, what is seen of the half beyond the axis from where the section lies to the right
    (``mirror`` 1) or to the left (−1). Raises DrawingError where there is nothing to draw, and
    SolidError where the body cannot be made.
    """
    factor = document.unit.millimetres
    within = tolerance / factor
    surface, size = document.surface, document.profile.size
    if size == 0.0:
        raise DrawingError(NoDrawing.POINT)
    if document.solid.kind is BodyKind.SURFACE:
        runs, rings = _drawn(surface)
        material: tuple[tuple[Path, ...], ...] = ()
        bare = tuple(_path(run, within, factor, _meet(run, size)) for run in runs)
        obstacle = shapely.union_all([shapely.LineString(path.flat()) for path in bare])
    else:
        outlines = cross_section(surface, document.solid).outlines
        rings = tuple(ring for outline in outlines for ring in outline.rings)
        material = tuple(
            tuple(_path(ring, within, factor, True) for ring in outline.rings)
            for outline in outlines
        )
        bare = ()
        obstacle = shapely.union_all([_polygon(part) for part in material])
    seen = SideView((), ()) if document.variation else side_view(rings, size)
    edges = tuple((r * factor, h * factor) for r, h in seen.edges)
    outside = tuple(_path([piece], within, factor, False) for piece in seen.stretches)
    if document.variation or document.cut_outs:
        outside = outside_of_mesh(document, within, mirror)
    paths = [path for part in material for path in part] + list(bare)
    # Holes leave a body as large as its section is, which is not of a mesh.
    bounding = paths if document.cut_outs and not document.variation else [*paths, *outside]
    points = np.concatenate([path.flat() for path in bounding])
    circles = [(r * factor, h * factor) for r, h in circles_of(rings, size)]
    low = float(points[:, 1].min())
    stands = [r for r, h in edges if h <= low + _STANDS * size * factor]
    return HalfView(
        material,
        bare,
        outside,
        () if document.cut_outs else edges,
        _inside([*circles, *edges], obstacle, size * factor),
        low,
        float(points[:, 1].max()),
        float(np.abs(points[:, 0]).max()),
        stands[0] if stands else None,
    )


def drawn_runs(surface: RevolutionSurface) -> list[list[Piece]]:
    """Return the runs of the drawn profile at the start angle that have no gap, at r ≥ 0."""
    section, size = surface.section, surface.profile.size
    sign = -1.0 if float(section.quartics[..., 0].sum()) < 0.0 else 1.0
    runs: list[list[Piece]] = [[]]
    for number, quartic in enumerate(section.quartics * (sign, 1.0)):
        stretch = None if section.stretch is None else section.stretch[number]
        piece = Trace(
            Role.DRAWN,
            quartic=quartic,
            stretch=stretch,
            size=size,
            segment=number,
            source=number,
        )
        if runs[-1] and float(np.hypot(*(piece.ends[0] - runs[-1][-1].ends[1]))) > _GAP * size:
            runs.append([])
        runs[-1].append(piece)
    return runs


def _drawn(surface: RevolutionSurface) -> tuple[list[list[Piece]], tuple[Ring, ...]]:
    """Return the runs of the bare profile, and them with what lies beyond the axis mirrored."""
    runs = drawn_runs(surface)
    rings = [tuple(run) for run in runs]
    points = np.concatenate([piece.points(_PLACES) for run in runs for piece in run])
    if float(points[:, 0].min()) < 0.0:
        rings += [
            tuple(
                replace(piece, quartic=piece.quartic * (-1.0, 1.0))
                for piece in ring
                if isinstance(piece, Trace)
            )
            for ring in rings
        ]
    return runs, tuple(rings)


def _meet(run: Sequence[Piece], size: float) -> bool:
    gap = run[0].ends[0] - run[-1].ends[1]
    return len(run) > 1 and float(np.hypot(*gap)) <= _GAP * size


def _path(pieces: Sequence[Piece], tolerance: float, factor: float, closed: bool) -> Path:
    path = Path(outline_cubics(pieces, tolerance), closed)
    return path.moved(factor, (0.0, 0.0))


def _polygon(rings: Sequence[Path]) -> shapely.Geometry:
    outer, *holes = (path.flat() for path in rings)
    return shapely.make_valid(shapely.Polygon(outer, [hole for hole in holes if len(hole) > 3]))


def _inside(
    circles: Sequence[tuple[float, float]], obstacle: shapely.Geometry, size: float
) -> tuple[tuple[float, float], ...]:
    """Return the circles that are seen behind the section, as level lines from the axis.

    Such a line meets no material before it comes to its circle.
    """
    blocked = shapely.buffer(obstacle, _TOUCH * size)
    found: list[tuple[float, float]] = []
    for r, h in sorted(circles, key=lambda circle: (circle[1], circle[0])):
        line = shapely.LineString([(0.0, h), (r, h)])
        free = shapely.get_coordinates(shapely.difference(line, blocked))
        if len(free) == 0 or free[:, 0].min() > _TOUCH * size:
            continue
        ends = np.sort(free[:, 0])
        if ends[1] >= r - _MEETS * size and not any(
            abs(h - other) <= _MEETS * size for _, other in found
        ):
            found.append((r, h))
    return tuple(found)
