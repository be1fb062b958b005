"""A measure that is to have a value, as an equation of a chain's numbers."""

from __future__ import annotations

from collections.abc import Callable
from typing import Protocol

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.design.demands.chain import Chain
from sgb_core.design.demands.joints import Equations
from sgb_core.design.demands.measures import Measured
from sgb_core.values import dataclass


class Kept(Protocol):
    """Something that is to go on holding."""

    @property
    def name(self) -> str:
        """What it is called where it is in the way."""
        ...

    def equations(self, chain: Chain) -> Equations:
        """Return how far it is from holding, by all numbers of the chain."""
        ...


@dataclass(frozen=True, slots=True)
class KeptMeasure:
    """A measure of a chain that has, or is to have, a value; residuals are parts of ``scale``."""

    name: str
    measure: Callable[[Chain], Measured]
    value: float
    scale: float

    def equations(self, chain: Chain) -> Equations:
        """Return how far the measure is from its value, by all numbers of the chain."""
        found = self.measure(chain)
        moves = chain.slopes()
        slope = np.einsum("nq,nqj->nj", found.slope, moves).ravel() / self.scale
        residual = np.array([(found.value - self.value) / self.scale])
        bends = None
        if found.bend is not None:
            blocks = np.swapaxes(moves, 1, 2) @ found.bend @ moves + chain.bends(found.slope)
            bends = (np.arange(chain.blocks.size), diagonal(blocks) / self.scale)
        return Equations(residual, slope[None], (bends,))


def diagonal(blocks: Floats) -> Floats:
    """Return the matrix with these blocks (n, k, k) on its diagonal."""
    count, size = blocks.shape[:2]
    whole = np.zeros((count, size, count, size))
    whole[range(count), :, range(count)] = blocks
    return whole.reshape(count * size, count * size)
