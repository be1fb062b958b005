"""The fairest chain under equations, as a problem for sequential quadratic programming."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.design.demands.chain import BLOCK, Chain
from sgb_core.design.demands.joints import Equations, JointEquation, joint_equations
from sgb_core.design.demands.kept import Kept, diagonal
from sgb_core.design.demands.sqp import Model
from sgb_core.design.demands.unknowns import Unknowns
from sgb_core.design.fairing.energy import Energy, Moves, energies, everywhere, expand
from sgb_core.design.fairing.nodes import exact_nodes, graded_nodes
from sgb_core.values import dataclass

# A part of the Hessian's size by which directions without energy are held.
_HOLD = 1e-9


@dataclass(frozen=True, slots=True)
class FairProblem:
    """The energy of some segments of a chain, by its unknowns, and what is kept meanwhile.

    ``exact`` integrates to rounding instead of the search's seven digits. Where only leg
    fractions are unknown, ``points_move`` is false and three moves a segment stand for ten.
    """

    unknowns: Unknowns
    energy: Energy
    segments: Sequence[int]
    joints: Sequence[JointEquation]
    measures: Sequence[Kept]
    points_move: bool
    exact: bool

    def values(self, y: Floats) -> tuple[float, Floats]:
        """Return energy and residuals at y."""
        chain = self.unknowns.chain(y)
        with np.errstate(all="ignore"):
            return self._value(chain), self._equations(chain, second=False).residual

    def value(self, y: Floats) -> float:
        """Return the energy at y, infinite where there is none."""
        return self._value(self.unknowns.chain(y))

    def _value(self, chain: Chain) -> float:
        quartics = chain.quartics[list(self.segments)]
        with np.errstate(all="ignore"):
            nodes = (exact_nodes if self.exact else graded_nodes)(self.energy, quartics)
            value = float(energies(self.energy, quartics, nodes).sum())
        return value if np.isfinite(value) else np.inf

    def equations(self, y: Floats) -> tuple[Floats, Floats]:
        """Return the residuals at y, and their slopes by the unknowns."""
        with np.errstate(all="ignore"):
            found = self._equations(self.unknowns.chain(y), second=False)
            return found.residual, found.slope @ self.unknowns.matrix

    def expand(self, y: Floats, multipliers: Floats) -> Model:
        """Return energy and equations at y to second order."""
        chain, chosen = self.unknowns.chain(y), list(self.segments)
        quartics = chain.quartics[chosen]
        part = Chain(chain.blocks[chosen], chain.size, chain.middle)
        with np.errstate(all="ignore"):
            nodes = (exact_nodes if self.exact else graded_nodes)(self.energy, quartics)
            if self.points_move:
                found = expand(self.energy, quartics, nodes, everywhere(len(quartics)))
                moves = part.slopes()
                slope = np.einsum("nq,nqj->nj", found.gradient, moves)
                blocks = np.swapaxes(moves, 1, 2) @ found.hessian @ moves
                blocks += part.bends(found.gradient)
            else:
                points = part.points
                along = points[:, [1, 1, 2]] - points[:, [0, 2, 3]]
                found = expand(self.energy, quartics, nodes, Moves((1, 2, 3), along))
                slope = np.zeros((len(chosen), BLOCK))
                blocks = np.zeros((len(chosen), BLOCK, BLOCK))
                slope[:, :3], blocks[:, :3, :3] = found.gradient, found.hessian
        count, matrix = len(chain), self.unknowns.matrix
        gradient = np.zeros((count, BLOCK))
        gradient[chosen] = slope
        bends = np.zeros((count, BLOCK, BLOCK))
        bends[chosen] = blocks
        hessian = diagonal(bends)
        equations = self._equations(chain, second=True)
        for multiplier, bend in zip(multipliers.tolist(), equations.bends, strict=True):
            if bend is not None and multiplier:
                hessian[np.ix_(bend[0], bend[0])] += multiplier * bend[1]
        reduced = matrix.T @ hessian @ matrix
        reduced[np.diag_indices(len(reduced))] += _HOLD * np.abs(reduced).max(initial=0.0)
        return Model(
            float(found.value.sum()),
            matrix.T @ gradient.ravel(),
            reduced,
            equations.residual,
            equations.slope @ matrix,
        )

    def _equations(self, chain: Chain, second: bool) -> Equations:
        equations = joint_equations(chain, list(self.joints), second)
        for kept in self.measures:
            equations = equations + kept.equations(chain)
        return equations
