"""The floor: spirals, alternately inwards and outwards, joined without a jump.

A layer fills the moved surface's outline at its height. Where a layer ends at that outline, or at
a drain hole, one turn climbs to the next and one levels it, as the wall itself does.
"""

from __future__ import annotations

from math import ceil

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.findings.toolpaths import NoPath
from sgb_core.toolpaths.errors import ToolpathError
from sgb_core.toolpaths.helix import TURN, Angles
from sgb_core.toolpaths.moved_wall import MovedWall
from sgb_core.toolpaths.settings import Plan
from sgb_core.toolpaths.strand import Part, Strand, strand
from sgb_core.values import dataclass


@dataclass(frozen=True, slots=True, eq=False)
class _Layer:
    """One layer: its number, height, thickness, and the inner edge and spacing of its spiral.

    Both are parts of the outline's distance from the axis.
    """

    number: int
    z: float
    thick: float
    inner: float
    turns: int

    @property
    def spacing(self) -> float:
        return (1.0 - self.inner) / self.turns


@dataclass(frozen=True, slots=True, eq=False)
class _Disc:
    """Makes pieces of the floor from how far out (1 is the outline) and how high they run."""

    wall: MovedWall
    angles: Angles
    bead: float

    def outline(self, z: Floats, angle: Floats, row: np.ndarray) -> Floats:
        return self.angles.place(angle, self.wall.at(z, row))

    def circle(
        self, first: _Layer, last: _Layer, inner: bool, section: tuple[float, float]
    ) -> Strand:
        """Return one turn from a layer's height to another's, sections rising or falling evenly."""
        angle, row = self.angles.until(TURN)
        share = (angle / TURN)[:, None]
        ends = []
        for layer in (first, last):
            outline = self.outline(np.full(len(angle), layer.z), angle, row)
            ends.append((layer.inner if inner else 1.0) * outline)
        z = first.z + share * (last.z - first.z)
        if inner or first is last:
            xy = ends[0] + share * (ends[1] - ends[0])
        else:
            xy = self.outline(z[:, 0], angle, row)
        area = section[0] + share[:, 0] * (section[1] - section[0])
        return self._strand(np.column_stack([xy, z]), area, last)

    def spiral(self, layer: _Layer, outwards: bool, below: float) -> Strand:
        """Return a layer's spiral; from the middle it climbs in its first turn from ``below``."""
        angle, row = self.angles.until(TURN * layer.turns)
        turned = angle / TURN
        part = layer.inner + layer.spacing * turned if outwards else 1.0 - layer.spacing * turned
        outline = self.outline(np.full(len(angle), layer.z), angle, row)
        apart = layer.spacing * np.hypot(outline[:, 0], outline[:, 1])
        if layer.inner or not outwards:
            apart = apart * np.minimum(turned, 1.0)
        z = np.full(len(angle), layer.z)
        if outwards and not layer.inner:
            z = below + (layer.z - below) * np.minimum(turned, 1.0)
        return self._strand(
            np.column_stack([part[:, None] * outline, z]), layer.thick * apart, layer
        )

    def apart(self, layer: _Layer) -> float:
        """Return the distance of a spiral's turns at the starting angle."""
        outline = self.outline(np.array([layer.z]), np.zeros(1), np.zeros(1, dtype=np.intp))
        return layer.spacing * float(np.hypot(*outline[0]))

    def _strand(self, points: Floats, section: Floats, layer: _Layer) -> Strand:
        return strand(Part.FLOOR, points, section, np.full(len(points), layer.number))


def floor(wall: MovedWall, plan: Plan, angles: Angles, hole: float) -> list[Strand]:
    """Return the pieces of the floor from the bed up to its top, where the wall begins.

    ``hole`` is the diameter of a drain hole in mm. Raises ToolpathError where no layer is wide
    enough for a bead.
    """
    if plan.floor_layers == 0 or plan.bead == 0.0:
        return []
    disc = _Disc(wall, angles, plan.bead)
    layers = _layers(wall, plan, hole)
    pieces: list[Strand] = []
    for place, layer in enumerate(layers):
        outwards = (len(layers) - 1 - place) % 2 == 0
        full = plan.bead * layer.thick
        if place:
            before = layers[place - 1]
            if not outwards or layer.inner:
                pieces.append(disc.circle(before, layer, outwards, (0.0, full)))
                pieces.append(disc.circle(layer, layer, outwards, (full, 0.0)))
        elif not outwards or layer.inner:
            pieces.append(disc.circle(layer, layer, outwards, (full, full)))
        below = layers[place - 1].z if place else layer.z
        pieces.append(disc.spiral(layer, outwards, below))
        if outwards or layer.inner:
            closing = disc.apart(layer) * layer.thick
            pieces.append(disc.circle(layer, layer, not outwards, (closing, 0.0)))
    return pieces


def _layers(wall: MovedWall, plan: Plan, hole: float) -> list[_Layer]:
    found: list[_Layer] = []
    rows = np.arange(len(wall.nodes))
    below = 0.0
    inside = (hole + plan.bead) / 2.0 if hole else 0.0
    for number in range(plan.floor_layers):
        z = plan.layer * (number + 1)
        radii = wall.at(np.full(len(rows), z), rows)[:, 0]
        widest = float(radii.max())
        if float(radii.min()) < inside + plan.bead:
            # Nothing that wide yet: the next layer rests on the bed instead.
            if found:
                raise ToolpathError(NoPath.TOO_NARROW)
            continue
        inner = inside / widest
        turns = max(1, ceil((1.0 - inner) * widest / plan.bead - 1e-9))
        found.append(_Layer(number, z, z - below, inner, turns))
        below = z
    if not found:
        raise ToolpathError(NoPath.TOO_NARROW)
    return found
