"""Models set right by what they stand for: what a model is to have next, by a secant's step."""

from __future__ import annotations

from collections.abc import Hashable
from dataclasses import field

from sgb_core.values import dataclass

# How much less or more what a model stands for may answer to a change than the model does.
LEAST_RATE = 0.1


@dataclass(slots=True)
class Secants:
    """What each model had the last time, and by how much the object then missed what is wanted."""

    last: dict[Hashable, tuple[float, float]] = field(default_factory=dict)

    def following(self, key: Hashable, had: float, apart: float) -> float:
        """Return what a model is to have that ``had`` a value where the object was ``apart``."""
        rate = 1.0
        if key in self.last and had != self.last[key][0]:
            rate = (apart - self.last[key][1]) / (had - self.last[key][0])
        self.last[key] = had, apart
        return had - apart / (rate if LEAST_RATE <= rate <= 1.0 / LEAST_RATE else 1.0)
