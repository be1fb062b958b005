"""The body of a document as pictures and panels need it: mesh, sections, liquid, findings."""

from __future__ import annotations

from dataclasses import field
from functools import cached_property

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.bodies.body import SectionPolygon, section_polygons
from sgb_core.bodies.body_mesh import body_mesh
from sgb_core.bodies.cross_section import cross_section
from sgb_core.bodies.mesh_section import Rings, mesh_section
from sgb_core.bodies.region import parameters
from sgb_core.bodies.solid import BodyKind
from sgb_core.bodies.solid_mesh import PieceRows, ring_section, rows_of, sweep_rings
from sgb_core.bodies.worked import Worked, worked_body
from sgb_core.document.appearance.relief import relief_of
from sgb_core.document.body_measures import BodyMeasures, body_measures
from sgb_core.document.model import Document
from sgb_core.findings.bodies import DoubtfulPlace
from sgb_core.findings.errors import FindingError
from sgb_core.findings.finding import Finding
from sgb_core.surfaces.mesh import Mesh
from sgb_core.surfaces.revolution import RevolutionSurface
from sgb_core.surfaces.turn import turn_of
from sgb_core.values import dataclass

# Rows along the whole profile, least per segment, and columns of a full turn: while the hand
# moves, and at rest.
COARSE = (64, 6, 72)
FINE = (192, 12, 192)


@dataclass(frozen=True, eq=False)
class BodyState:
    """What became of a document's body.

    ``error`` is why there is none; then ``mesh`` is None, as for a bare surface. ``doubts`` are
    what is doubtful about places of the one there is, ``more`` what else is, ``unworked`` why its
    relief and its cut-outs could not be made, and ``worked`` whether the mesh has them.
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
    unworked: Finding | None = None
    more: tuple[Finding, ...] = ()
    worked: bool = False
    _sections: dict[float, tuple[SectionPolygon, ...]] = field(default_factory=dict)

    @property
    def findings(self) -> tuple[Finding, ...]:
        """What is wrong or doubtful."""
        if self.error is not None:
            return (self.error,)
        refused = () if self.unworked is None else (self.unworked,)
        return (*self.doubts, *self.more, *refused)

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


def cut_faces(state: BodyState, angle: float) -> tuple[Rings, ...]:
    """Return where a half-plane at an absolute angle cuts a body, its relief and holes included.

    Each part is its outline and what it leaves out, (k, 2) each.
    """
    if state.worked and state.mesh is not None:
        return mesh_section(state.mesh, state.surface, angle)
    return tuple((part.exterior, *part.holes) for part in state.section(angle))


def body_state(
    document: Document, surface: RevolutionSurface, *, fine: bool, measured: bool = True
) -> BodyState:
    """Return the body of a document, coarse or fine; never raises for what cannot be made.

    A picture needs no measures, which can take longer than all else: ``measured`` off.
    """
    solid = document.solid
    if not document.has_body or (solid.kind is BodyKind.SURFACE and not fine):
        return BodyState(document, surface, fine)
    try:
        # While the hand moves the wall is whole and smooth.
        worked = _worked(document, surface) if fine and is_worked(document) else None
        shown = worked.mesh if isinstance(worked, Worked) else None
        if solid.kind is BodyKind.SURFACE:
            return _relieved(document, surface, worked)
        rows, least, columns = FINE if fine else COARSE
        samples = (max(least, rows // len(surface.profile)), _around(columns, surface))
        mesh = body_mesh(surface, solid, samples=samples) if shown is None else shown
        section = cross_section(surface, solid)
        liquid = _liquid(document, surface, samples[1])
        measured = measured and (fine or not surface.laws)
        measures = body_measures(document, surface, mesh, worked) if measured else None
    except FindingError as error:
        return BodyState(document, surface, fine, error=error.finding)
    refused = worked if isinstance(worked, Finding) else None
    doubts = section.findings
    more = worked.doubts if isinstance(worked, Worked) else ()
    return BodyState(
        document,
        surface,
        fine,
        mesh,
        liquid,
        doubts,
        measures,
        unworked=refused,
        more=more,
        worked=shown is not None,
    )


def is_worked(document: Document) -> bool:
    """Whether a document has relief or holes."""
    return bool(document.cut_outs) or relief_of(document.appearance) is not None


def _relieved(
    document: Document, surface: RevolutionSurface, worked: Worked | Finding | None
) -> BodyState:
    """Return the state of a bare surface with its relief."""
    if isinstance(worked, Worked):
        return BodyState(document, surface, True, worked.mesh, more=worked.doubts)
    return BodyState(document, surface, True, error=worked)


def _worked(document: Document, surface: RevolutionSurface) -> Worked | Finding:
    """Return the body with its relief and holes, or why they cannot be: it then stays as it was."""
    relief = relief_of(document.appearance)
    try:
        return worked_body(surface, document.solid, document.patterns, relief)
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
