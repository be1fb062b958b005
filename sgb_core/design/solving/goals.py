"""What can be a target, as an equation of a chain's numbers.

What a body holds, and its material, are the model of :mod:`sgb_core.design.locks.held_volume`: it
tells how a volume changes; whoever uses it sets it right by the body's own measure.
"""

from __future__ import annotations

from collections.abc import Mapping
from enum import StrEnum
from types import MappingProxyType

import numpy as np

from sgb_core.bodies.solid import BodyKind
from sgb_core.design.demands.chain import Chain
from sgb_core.design.demands.joints import Equations
from sgb_core.design.locks.dimension import Dimension, DimensionKind
from sgb_core.design.locks.gauge import Gauge
from sgb_core.design.locks.readings import Setting, read
from sgb_core.findings.errors import FindingError
from sgb_core.findings.solving import NoTarget
from sgb_core.values import dataclass


class Goal(StrEnum):
    """What can be a target, in the document's unit and its powers.

    FILLED is what is held to the fill line, MATERIAL the volume of the material.
    """

    CAPACITY = "capacity"
    FILLED = "filled"
    VOLUME = "volume"
    MATERIAL = "material"
    HEIGHT = "height"
    MAX_DIAMETER = "max_diameter"
    RIM_DIAMETER = "rim_diameter"
    FOOT_DIAMETER = "foot_diameter"


DIMENSIONS: Mapping[Goal, Dimension] = MappingProxyType(
    {goal: Dimension(DimensionKind(goal.value)) for goal in Goal}
)
# Those that are a body's, and whose model is not the measure itself.
OF_BODY = frozenset({Goal.CAPACITY, Goal.FILLED, Goal.MATERIAL})


@dataclass(frozen=True, slots=True)
class Target:
    """A goal that is to have a value; residuals are parts of it."""

    goal: Goal
    setting: Setting
    value: float

    @property
    def name(self) -> str:
        """What it is called."""
        return self.goal.value

    def missed(self, chain: Chain) -> float:
        """Return by what part of the value a chain misses it, infinite without such a measure."""
        found = read(Gauge(chain, slopes=False), DIMENSIONS[self.goal], self.setting)
        return np.inf if found is None else (found.value - self.value) / self.value

    def equations(self, chain: Chain) -> Equations:
        """Return by what part of the value a chain misses it, by all its numbers."""
        found = read(Gauge(chain), DIMENSIONS[self.goal], self.setting)
        if found is None:
            return Equations(np.array([np.inf]), np.zeros((1, chain.blocks.size)), (None,))
        residual = np.array([(found.value - self.value) / self.value])
        return Equations(residual, found.slope[None] / self.value, (None,))


def target(goal: Goal, setting: Setting, value: float, start: Chain) -> Target:
    """Return a target for chains that come from ``start``.

    Raises FindingError for a goal that this profile or body does not have.
    """
    kind = setting.solid.kind
    if goal in OF_BODY and kind is BodyKind.SURFACE:
        raise FindingError(NoTarget.NO_BODY)
    if goal in (Goal.CAPACITY, Goal.FILLED) and (kind is not BodyKind.VESSEL or setting.closed):
        raise FindingError(NoTarget.NO_CAPACITY)
    if goal is Goal.FILLED and setting.fill is None and setting.below_rim is None:
        raise FindingError(NoTarget.NO_LINE)
    if goal in (Goal.RIM_DIAMETER, Goal.FOOT_DIAMETER) and setting.closed:
        raise FindingError(NoTarget.NO_ENDS)
    found = read(Gauge(start, slopes=False), DIMENSIONS[goal], setting)
    if found is None or not found.value > 0.0:
        raise FindingError(NoTarget.FLAT)
    return Target(goal, setting, value)
