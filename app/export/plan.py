"""What an export will be: the document at its exported size, and what its file will hold."""

from __future__ import annotations

from dataclasses import replace
from math import log

from app.widgets.quantity import grouped, signed_percent
from sgb_core import exchange
from sgb_core.bodies.solid import BodyKind
from sgb_core.document.appearance.relief import relief_of
from sgb_core.document.edits import for_export, without_paint
from sgb_core.document.model import Document, Unit
from sgb_core.exchange.body import exported_mesh
from sgb_core.exchange.progress import GUESS
from sgb_core.exchange.skin import has_skin
from sgb_core.surfaces.deviation import deviation
from sgb_core.surfaces.fineness import Fineness
from sgb_core.surfaces.mesh import Mesh
from sgb_core.surfaces.revolution import Axis
from sgb_core.values import dataclass

# Meshes made at most to find the tolerance for a number of triangles, and of how many at most.
TRIES = 6
MOST_TRIED = 60_000
# How many times as coarse the coarser of two meshes to compare is.
COARSER = 16.0
# A file of more triangles is measured by its neighbour in size instead of by writing it nowhere.
MOST_SIZED = 1_500_000


@dataclass(frozen=True, slots=True)
class ExportPlan:
    """What the dialog asks for. ``factor`` is one of scale; None keeps unit and axis.

    With ``triangles`` the tolerance is sought that gives about so many; see :meth:`resolved`.
    Without ``look`` the file holds neither material nor paint.
    """

    document: Document
    suffix: str
    tolerance: float | None = None
    samples: tuple[int, int] | None = None
    unit: Unit | None = None
    factor: float = 1.0
    axis: Axis | None = None
    triangles: int | None = None
    look: bool = True

    @property
    def format(self) -> exchange.Format:
        """The format that the suffix names."""
        return exchange.FORMATS[self.suffix]

    @property
    def meshed(self) -> bool:
        """Whether the file holds a mesh."""
        return self.format.meshed

    @property
    def exported(self) -> Document:
        """The document as it is written."""
        wanted = for_export(self.document, unit=self.unit, factor=self.factor, axis=self.axis)
        return wanted if self.look else without_paint(wanted)

    @property
    def has_look(self) -> bool:
        """Whether there is a look that the format can hold."""
        return self.format.looks and has_skin(self.document.appearance)

    def resolved(self) -> ExportPlan:
        """Return the plan with the tolerance at which the mesh has about ``triangles``.

        Their number goes with a power of the tolerance: -1 for curved profiles, -1/2 for straight
        ones. Two coarse meshes tell it, which brings fine ones within a fifth.
        """
        if self.triangles is None or not self.meshed:
            return self
        coarse = 1e-3 * (self.document.profile.size or 1.0)
        tolerance = coarse / COARSER
        count = self._count(tolerance)
        power = max(0.25, log(count / self._count(coarse)) / log(COARSER))
        for _ in range(TRIES):
            ratio = count / self.triangles
            if 0.95 < ratio < 1.05:
                break
            tolerance *= ratio ** (1.0 / power)
            if self.triangles > MOST_TRIED:
                break
            count = self._count(tolerance)
        return replace(self, tolerance=tolerance, samples=None, triangles=None)

    def _count(self, tolerance: float) -> int:
        return len(exported_mesh(self.document, tolerance=tolerance).triangles)

    @property
    def exported_tolerance(self) -> float | None:
        """The tolerance in the unit and at the scale of the file."""
        if self.tolerance is None or self.format.tolerance is None:
            return None
        unit = self.unit or self.document.unit
        return self.tolerance * self.factor * self.document.unit.factor_to(unit)


@dataclass(frozen=True, slots=True, eq=False)
class Examined:
    """What a plan gives: the mesh, lines that say it in words, and the bytes of the file.

    Of a file whose writing holds up all threads the bytes are a guess.
    """

    plan: ExportPlan
    mesh: Mesh | None
    lines: tuple[str, ...]
    size: int


def examine(plan: ExportPlan) -> Examined:
    """Return what the file of a plan will hold.

    Raises ValueError, one line, where it cannot be written.
    """
    plan = plan.resolved()
    document = plan.exported
    tolerance = plan.exported_tolerance
    samples = plan.samples if plan.meshed else None
    if plan.format.holds_up:
        request = exchange.Request(document, Fineness(tolerance))
        return Examined(plan, None, (plan.format.contents(request),), GUESS)
    if not plan.meshed:
        size = exchange.file_size(document, plan.suffix, tolerance=tolerance)
        request = exchange.Request(document, Fineness(tolerance))
        words = (plan.format.contents(request), f"File: {bytes_text(size)}")
        return Examined(plan, None, words, size)
    mesh = exported_mesh(document, tolerance=tolerance, samples=samples)
    count = len(mesh.triangles)
    if count <= MOST_SIZED:
        size = exchange.file_size(
            document, plan.suffix, tolerance=tolerance, samples=samples, mesh=mesh
        )
    else:
        size = int(count * plan.format.bytes_per_triangle)
    about = "" if count <= MOST_SIZED else "about "
    low, high = mesh.bounds
    unit = document.unit
    sides = " × ".join(f"{side:.4g}" for side in (high - low).tolist())
    closed = "closed body" if mesh.is_watertight else "open surface"
    lines = [
        f"{grouped(count)} triangles, {closed}",
        f"{sides} {unit}",
        _accuracy(plan, document, mesh),
        plan.format.contents(exchange.Request(document)),
        f"File: {about}{bytes_text(size)}",
    ]
    return Examined(plan, mesh, tuple(lines), size)


def _accuracy(plan: ExportPlan, document: Document, mesh: Mesh) -> str:
    unit = document.unit
    if document.solid.kind is BodyKind.SURFACE and relief_of(document.appearance) is not None:
        near = Fineness(plan.exported_tolerance).within(document.profile.size)
        return f"At most {near:.3g} {unit} from the true surface with its relief"
    if document.solid.kind is BodyKind.SURFACE:
        return f"At most {deviation(mesh, document.surface, 5000):.3g} {unit} from the true surface"
    true = document.body().material_volume
    volume = f"volume {signed_percent((mesh.volume - true) / true)}"
    if plan.exported_tolerance is None:
        return f"Against the true body: {volume}"
    return f"At most {plan.exported_tolerance:.3g} {unit} from the true body, {volume}"


def bytes_text(size: int) -> str:
    """Return a size of a file in bytes, kB or MB."""
    if size < 1000:
        return f"{size} bytes"
    return f"{size / 1000:.3g} kB" if size < 1_000_000 else f"{size / 1e6:.3g} MB"
