"""What a STEP file holds: solids and shells, each as runs of curves to be turned."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TypeAlias

import numpy as np

from sgb_core.exchange.step.curves import Curve, bezier
from sgb_core.values import dataclass

Run: TypeAlias = tuple[Curve, ...]


@dataclass(frozen=True, slots=True, eq=False)
class StepPart:
    """Runs of curves, head to tail, that turned about the axis bound one solid, or are a surface.

    Each run of a solid leads from the axis to the axis, or round a ring; the first bounds it
    outside and those that follow bound its voids. No curve lies on the axis. A surface has one.
    """

    runs: tuple[Run, ...]
    solid: bool

    @property
    def curves(self) -> Run:
        """All curves."""
        return tuple(curve for run in self.runs for curve in run)

    @property
    def deviations(self) -> tuple[float, ...]:
        """How far each of the faces that the curves sweep is off."""
        return tuple(curve.deviation for curve in self.curves)

    def loops(self) -> tuple[Run, ...]:
        """Return what bounds the solid's section: runs, joined along the axis where they reach it.

        The end faces of a part turn have these as their edges.
        """
        rings = [run for run in self.runs if run[0].ends[0, 0] != 0.0]
        poles = [run for run in self.runs if run[0].ends[0, 0] == 0.0]
        if not poles:
            return tuple(rings)
        loop = list(poles[0])
        inner = sorted(poles[1:], key=_foot)
        # Back along the axis to where the run began, around each void that lies on the way.
        if poles[0][-1].ends[1, 1] > _foot(poles[0]):
            inner.reverse()
        for run in inner:
            _lead(loop, run)
            loop += run
        _lead(loop, loop)
        return (tuple(loop), *rings)


def _foot(run: Run) -> float:
    return float(run[0].ends[0, 1])


def _lead(loop: list[Curve], run: Sequence[Curve]) -> None:
    """Add the line along the axis from a loop's end to the start of a run."""
    line = np.array([loop[-1].ends[1], run[0].ends[0]])
    if line[0, 1] != line[1, 1]:
        loop.append(bezier(line))
