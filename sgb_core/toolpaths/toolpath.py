"""The path of a printer: its moves, what each pushes out and how fast, and what it comes to."""

from __future__ import annotations

from dataclasses import field
from math import ceil

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.findings.finding import Finding
from sgb_core.toolpaths.settings import Plan
from sgb_core.toolpaths.strand import Part, Strand
from sgb_core.values import dataclass


@dataclass(frozen=True, slots=True, eq=False)
class Toolpath:
    """The nozzle's tip from the first point on, in mm, before it is laid on the bed.

    ``points`` has the shape (k, 3); the move to each has its ``parts`` number (:class:`Part`),
    its ``layers`` number, the ``volumes`` that it pushes out in mm³ and its ``speeds`` in mm/s, all
    (k,); the first is the approach. ``steps`` and ``turns``, (k,), are how far sideways of the turn
    below a point of the wall lies, in mm, and the number of its turn; elsewhere 0 and −1. ``scale``
    is what the document's lengths were multiplied by, ``ground`` the height, so scaled, that lies
    on the bed.
    """

    plan: Plan
    points: Floats
    parts: np.ndarray
    layers: np.ndarray
    volumes: Floats
    speeds: Floats
    steps: Floats
    turns: np.ndarray
    material_volume: float
    scale: float
    ground: float
    findings: tuple[Finding, ...] = field(default=())

    @property
    def lengths(self) -> Floats:
        """The lengths of the moves, that of the approach taken as 0, shape (k,)."""
        steps = np.sqrt((np.diff(self.points, axis=0) ** 2).sum(axis=1))
        return np.concatenate([[0.0], steps])

    @property
    def times(self) -> Floats:
        """How long each move takes in s, without acceleration, shape (k,)."""
        return np.asarray(self.lengths / self.speeds)

    @property
    def length(self) -> float:
        """The length of all moves that push something out, or would with a bead above 0."""
        return float(self.lengths[self.parts != Part.TRAVEL].sum())

    @property
    def time(self) -> float:
        """How long printing takes in s, without acceleration and heating."""
        return float(self.times.sum())

    @property
    def extruded_volume(self) -> float:
        """What is pushed out in mm³."""
        return float(self.volumes.sum())

    @property
    def grams(self) -> float | None:
        """The mass of what is pushed out, as wet as it is printed; None without a density."""
        density = self.plan.printer.wet_density
        return self.extruded_volume / 1000.0 * density if density else None

    @property
    def refills(self) -> int:
        """How often the tube is filled again; 0 for an endless one."""
        tube = self.plan.printer.tube * 1000.0
        return max(0, ceil(self.extruded_volume / tube) - 1) if tube else 0

    @property
    def layer_count(self) -> int:
        """How many layers of the floor and turns of the wall there are."""
        return int(self.layers.max()) + 1

    @property
    def largest_step(self) -> float:
        """How far sideways of the turn below the wall lies at most, in mm."""
        return float(self.steps.max(initial=0.0))

    @property
    def bounds(self) -> tuple[Floats, Floats]:
        """The lower and upper corner of the box around the points, each shape (3,)."""
        return self.points.min(axis=0), self.points.max(axis=0)

    @property
    def on_bed(self) -> Floats:
        """The points in the printer's coordinates, the axis over the middle of the bed, (k, 3)."""
        return np.asarray(self.points + np.array([*self.plan.printer.bed.middle, 0.0]))

    @property
    def layer_times(self) -> Floats:
        """How long each layer takes in s, shape (layers,)."""
        return np.asarray(np.bincount(self.layers, self.times, self.layer_count), np.float64)


@dataclass(frozen=True, slots=True, eq=False)
class Moves:
    """Pieces of a path in their order, with the moves between; fields as in :class:`Toolpath`."""

    points: Floats
    parts: np.ndarray
    layers: np.ndarray
    volumes: Floats

    @property
    def lengths(self) -> Floats:
        """The lengths of the moves, that of the approach taken as 0, shape (k,)."""
        steps = np.sqrt((np.diff(self.points, axis=0) ** 2).sum(axis=1))
        return np.concatenate([[0.0], steps])


def joined(strands: list[Strand]) -> Moves:
    """Return pieces in their order; one that begins where the last ended follows at once."""
    points: list[np.ndarray] = []
    parts: list[np.ndarray] = []
    layers: list[np.ndarray] = []
    volumes: list[np.ndarray] = []
    last: Floats | None = None
    for piece in strands:
        if last is None or np.abs(piece.points[0] - last).max() > 1e-6:
            points.append(piece.points[:1])
            parts.append(np.array([Part.TRAVEL]))
            layers.append(piece.layers[:1])
            volumes.append(np.zeros(1))
        points.append(piece.points[1:])
        parts.append(np.full(len(piece.volumes), piece.part))
        layers.append(piece.layers)
        volumes.append(piece.volumes)
        last = piece.points[-1]
    return Moves(
        np.concatenate(points),
        np.concatenate(parts).astype(np.int8),
        np.concatenate(layers),
        np.concatenate(volumes),
    )
