"""The directions of legs as what is kept: tangents that stay while points move."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from sgb_core.arrays import Floats
from sgb_core.design.demands.chain import BLOCK, Chain
from sgb_core.design.demands.joints import Equations
from sgb_core.values import dataclass

# A leg shorter than this, in sizes, has no direction.
_SHORT = 1e-12
_LEGS = ((0, 1), (3, 2))


@dataclass(frozen=True, slots=True)
class KeptDirections:
    """The legs from the ends of each segment keep the directions ``units``.

    ``segments`` and ``ends`` (m,) say whose leg each is; ``units`` has shape (m, 2).
    """

    segments: NDArray[np.intp]
    ends: NDArray[np.intp]
    units: Floats
    name: str = "directions of all legs"

    @classmethod
    def of(cls, chain: Chain) -> KeptDirections:
        """Return the directions that the legs of a chain have; one without length has none."""
        found = []
        for segment in range(len(chain)):
            for end, (near, far) in enumerate(_LEGS):
                leg = chain.points[segment, far] - chain.points[segment, near]
                length = float(np.hypot(leg[0], leg[1]))
                if length > _SHORT:
                    found.append((segment, end, *(leg / length).tolist()))
        table = np.array(found).reshape(-1, 4)
        return cls(table[:, 0].astype(np.intp), table[:, 1].astype(np.intp), table[:, 2:])

    def equations(self, chain: Chain) -> Equations:
        """Return how far each leg's end lies beside its direction, in sizes: u × (P1 − P0)."""
        count = len(self.units)
        near = np.array([leg[0] for leg in _LEGS])[self.ends]
        far = np.array([leg[1] for leg in _LEGS])[self.ends]
        legs = chain.points[self.segments, far] - chain.points[self.segments, near]
        residual = self.units[:, 0] * legs[:, 1] - self.units[:, 1] * legs[:, 0]
        slope = np.zeros((count, chain.blocks.size))
        across = np.stack([-self.units[:, 1], self.units[:, 0]], axis=1)
        rows = np.arange(count)
        for axis in range(2):
            slope[rows, BLOCK * self.segments + 3 + 2 * far + axis] += across[:, axis]
            slope[rows, BLOCK * self.segments + 3 + 2 * near + axis] -= across[:, axis]
        return Equations(residual, slope, (None,) * count)
