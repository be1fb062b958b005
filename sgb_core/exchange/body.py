"""Which mesh an export holds: the body that the document's ``solid`` section names."""

from __future__ import annotations

from sgb_core.document.model import Document
from sgb_core.exchange.errors import ExportError
from sgb_core.findings.errors import FindingError
from sgb_core.findings.exports import NoExport
from sgb_core.surfaces.mesh import Mesh


def exported_mesh(
    document: Document,
    *,
    tolerance: float | None = None,
    samples: tuple[int, int] | None = None,
) -> Mesh:
    """Return the mesh of the document's body, placed, in its unit.

    ``tolerance`` is the largest distance from the true body, ``samples`` the intervals per
    segment and around; with neither, the tessellation's default. Raises ExportError where the
    body cannot be made or nothing of it is left.
    """
    try:
        mesh = document.body().mesh(tolerance=tolerance, samples=samples)
    except FindingError as error:
        raise ExportError(error.finding) from error
    if len(mesh.triangles) == 0:
        raise ExportError(NoExport.NO_AREA)
    return mesh
