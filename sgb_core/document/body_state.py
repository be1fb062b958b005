"""The body of a document as pictures and panels need it: mesh, sections, liquid, findings."""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cached_property

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.bodies.body import SectionPolygon, body_mesh, pierced_body, section_polygons
from sgb_core.bodies.cross_section import cross_section
from sgb_core.bodies.pierced import Pierced
from sgb_core.bodies.region import parameters
from sgb_core.bodies.solid import BodyKind
from sgb_core.bodies.solid_mesh import PieceRows, ring_section, rows_of, sweep_rings
from sgb_core.document.body_measures import BodyMeasures, body_measures
from sgb_core.document.model import Document
from sgb_core.findings.bodies import DoubtfulPlace
from sgb_core.findings.errors import FindingError
from sgb_core.findings.finding import Finding
from sgb_core.surfaces.mesh import Mesh
from sgb_core.surfaces.revolution import RevolutionSurface
from sgb_core.surfaces.turn import turn_of

# Rows along the whole profile, least per segment, and columns of a full turn: while the hand
# moves, and at rest.
COARSE = (64, 6, 72)
FINE = (192, 12, 192)


@dataclass(frozen=True, eq=False)
class BodyState:
    """What became of a document's body.

    ``error`` is why there is none; then ``mesh`` is None, as for a bare surface. ``doubts`` are
    what is doubtful about the one there is, ``uncut`` why its cut-outs could not be made.
    ``measures`` come with the fine body, and with the coarse one too where no laws hold: only size,
    stand and lean are the mesh's, the rest is exact in both.
    """

    document: Document
    surface: RevolutionSurface
    fine: bool
    mesh: Mesh | None = None
    liquid: Mesh | None = None
    doubts: tuple[DoubtfulPlace, ...] = ()
    measures: BodyMeasures | None = None
    error: Finding | None = None
    uncut: Finding | None = None
    _sections: dict[float, tuple[SectionPolygon, ...]] = field(default_factory=dict)

    @property
    def findings(self) -> tuple[Finding, ...]:
        """What is wrong or doubtful."""
        if self.error is not None:
            return (self.error,)
        return self.doubts if self.uncut is None else (*self.doubts, self.uncut)

    @cached_property
    def liquid_section(self) -> tuple[Floats, ...]:
        """The liquid's section at the start angle as polygons (k, 2), without what they enclose."""
        if self.error is not None or self.liquid is None:
            return ()
        side = -1.0 if cross_section(self.surface, self.document.solid).meridian.mirrored else 1.0
        return tuple(
            np.concatenate([rows.points[0, :-1] for rows in rings[0]]) * (side, 1.0)
            for rings in _liquid_rows(self.document, self.surface)
        )

    def section(self, angle: float) -> tuple[SectionPolygon, ...]:
        """Return the section at an absolute angle in radians; empty where there is none."""
        if self.mesh is None:
            return ()
        key = angle if self.surface.laws else 0.0
        if key not in self._sections:
            self._sections[key] = section_polygons(
                self.surface, self.document.solid, theta=key if self.surface.laws else None
            )
        return self._sections[key]


def body_state(
    document: Document, surface: RevolutionSurface, *, fine: bool, measured: bool = True
) -> BodyState:
    """Return the body of a document, coarse or fine; never raises for what cannot be made.

    A picture needs no measures, which can take longer than all else: ``measured`` off.
    """
    solid = document.solid
    if solid.kind is BodyKind.SURFACE:
        return BodyState(document, surface, fine)
    rows, least, columns = FINE if fine else COARSE
    samples = (max(least, rows // len(surface.profile)), _around(columns, surface))
    try:
        mesh = body_mesh(surface, solid, samples=samples)
        section = cross_section(surface, solid)
        liquid = _liquid(document, surface, samples[1])
        measured = measured and (fine or not surface.laws)
        # While the hand moves the wall is whole.
        cut = _pierced(document, surface) if fine and document.cut_outs else None
        if isinstance(cut, Pierced):
            mesh = cut.mesh
        measures = body_measures(document, surface, mesh, cut) if measured else None
    except FindingError as error:
        return BodyState(document, surface, fine, error=error.finding)
    refused = cut if isinstance(cut, Finding) else None
    doubts = section.findings
    return BodyState(document, surface, fine, mesh, liquid, doubts, measures, None, refused)


def _pierced(document: Document, surface: RevolutionSurface) -> Pierced | Finding:
    """Return the body with its cut-outs, or why they cannot be cut: the wall then stays whole."""
    try:
        return pierced_body(surface, document.solid, document.cut_outs)
    except FindingError as error:
        return error.finding


def _liquid_rows(
    document: Document, surface: RevolutionSurface
) -> list[tuple[list[PieceRows], ...]]:
    """Return the rows of the rings around what the vessel holds up to its fill line."""
    height = document.fill_height
    if height is None or document.solid.kind is not BodyKind.VESSEL:
        return []
    section = cross_section(surface, document.solid)
    if section.brim is None:
        return []
    grids = section.grids
    return [
        tuple(
            rows_of(ring, surface.profile.size, lambda piece: parameters(piece, grids))
            for ring in outline.rings
        )
        for outline in section.filled_to(height)
    ]


def _liquid(document: Document, surface: RevolutionSurface, columns: int) -> Mesh | None:
    rows = _liquid_rows(document, surface)
    if not rows:
        return None
    size = surface.profile.size
    sections = [tuple(ring_section(ring, size) for ring in rings) for rings in rows]
    mirrored = cross_section(surface, document.solid).meridian.mirrored
    return sweep_rings(sections, turn_of(surface, columns), surface, mirrored)


def _around(columns: int, surface: RevolutionSurface) -> int:
    return max(8, int(np.ceil(columns * surface.sweep / (2.0 * np.pi))))
