"""Locks as equations for searches that keep them: fairing, targets."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from sgb_core.design.demands.chain import Chain
from sgb_core.design.demands.joints import Equations
from sgb_core.design.locks.gauge import Gauge
from sgb_core.design.locks.hold import Lock
from sgb_core.design.locks.readings import Setting, read
from sgb_core.values import dataclass


@dataclass(frozen=True, slots=True)
class LockEquation:
    """One lock of a profile; told in the size and from the middle of that profile's chain."""

    lock: Lock
    setting: Setting

    @property
    def name(self) -> str:
        """What is locked."""
        return self.lock.dimension.label.lower()

    def equations(self, chain: Chain) -> Equations:
        """Return how far the lock is from holding; infinite where there is no such measure."""
        return LockEquations((self,)).equations(chain)


@dataclass(frozen=True, slots=True)
class LockEquations:
    """All locks of a profile, read from one gauge."""

    locks: Sequence[LockEquation]
    name: str = "locks"

    def equations(self, chain: Chain) -> Equations:
        """Return how far each lock is from holding; infinite where there is no such measure."""
        gauge = Gauge(chain)
        residual = np.full(len(self.locks), np.inf)
        slope = np.zeros((len(self.locks), chain.blocks.size))
        for k, each in enumerate(self.locks):
            found = read(gauge, each.lock.dimension, each.setting)
            if found is not None:
                residual[k] = each.lock.missed(found.value)
                slope[k] = found.slope / each.lock.scale
        return Equations(residual, slope, (None,) * len(self.locks))
