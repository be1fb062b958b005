"""The relief of a document's look, as far as a path can follow it."""

from __future__ import annotations

from functools import lru_cache

import numpy as np

from sgb_core.arrays import Floats, Ints, Singles
from sgb_core.bodies.body_mesh import STEPS
from sgb_core.bodies.outer_face import drawn_runs
from sgb_core.document.appearance.relief import relief_of
from sgb_core.document.model import Document
from sgb_core.findings.errors import FindingError
from sgb_core.findings.surfaces import TooManyTriangles
from sgb_core.findings.toolpaths import NoPath
from sgb_core.surfaces.relief import Heights, ReliefField
from sgb_core.surfaces.revolution import RevolutionSurface
from sgb_core.surfaces.uv import UVMap, uv_map_of
from sgb_core.toolpaths.errors import ToolpathError
from sgb_core.values import dataclass

# A relief is followed at no more angles than these, nor more closely than so many mm: less no
# nozzle shows. Where it needs more angles it is followed less closely, so many times at most.
_MOST, _CLOSE, _COARSER = 2_048, 0.02, 6


@dataclass(frozen=True, slots=True, eq=False)
class Raised:
    """How far a surface is raised, in the document's unit.

    ``table`` (R, C) has the heights at ``rows`` (R,), shares of the generatrix' length, and
    ``columns`` (C,), shares of the turn; between them they are nearly straight.
    """

    uv_map: UVMap
    rows: Floats
    columns: Floats
    table: Singles

    def at(self, turned: Floats, segment: Ints, s: Floats) -> Floats:
        """Return heights at shares of the turn and at places of segments, shape (k,) each."""
        per = self.uv_map.per_segment
        own = self.uv_map.shares.reshape(-1, per + 1)
        node = np.clip((s * per).astype(np.intp), 0, per - 1)
        low = own[segment, node]
        share = low + (s * per - node) * (own[segment, node + 1] - low)
        i, up = _between(self.rows, share)
        j, on = _between(self.columns, turned)
        left = (1.0 - up) * self.table[i, j] + up * self.table[i + 1, j]
        right = (1.0 - up) * self.table[i, j + 1] + up * self.table[i + 1, j + 1]
        return np.asarray((1.0 - on) * left + on * right)


def _between(samples: Floats, places: Floats) -> tuple[np.ndarray, Floats]:
    low = np.clip(np.searchsorted(samples, places, side="right") - 1, 0, len(samples) - 2)
    part = (places - samples[low]) / (samples[low + 1] - samples[low])
    return low, np.asarray(np.clip(part, 0.0, 1.0))


def raised_of(document: Document, chord: float, scale: float) -> Raised | None:
    """Return what a path that cuts corners by ``chord`` mm follows; None without a relief.

    ``scale`` is what lengths are multiplied by. Raises ToolpathError for a relief that is too fine.
    """
    relief = relief_of(document.appearance)
    if relief is None:
        return None
    return _raised(document.surface, relief, max(chord, _CLOSE) / scale)


@lru_cache(maxsize=2)
def _raised(surface: RevolutionSurface, relief: Heights, limit: float) -> Raised:
    uv_map = uv_map_of(surface, STEPS)
    faces = (drawn_runs(surface, uv_map),)
    field = ReliefField(relief, uv_map, surface.sweep, surface.is_full_turn, faces)
    for times in 2.0 ** np.arange(_COARSER):
        try:
            columns, rows = field.grid(4.0 * float(times) * limit)
        except FindingError as error:
            if not isinstance(error.finding, TooManyTriangles):
                raise
            continue
        if len(columns) <= _MOST:
            table = field.at(columns, rows).astype(np.float32)
            return Raised(uv_map, rows, columns, table)
    raise ToolpathError(NoPath.FINE_RELIEF)
