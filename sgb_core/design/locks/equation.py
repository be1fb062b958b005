"""A lock as an equation for searches that keep it: fairing, targets."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from sgb_core.design.demands.chain import Chain
from sgb_core.design.demands.joints import Equations
from sgb_core.design.locks.gauge import Gauge
from sgb_core.design.locks.hold import Lock
from sgb_core.design.locks.readings import Setting, read


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
        found = read(Gauge(chain), self.lock.dimension, self.setting)
        if found is None:
            return Equations(np.array([np.inf]), np.zeros((1, chain.blocks.size)), (None,))
        residual = np.array([self.lock.missed(found.value)])
        return Equations(residual, found.slope[None] / self.lock.scale, (None,))
