"""Pieces of a path: points, what each move to them pushes out, and what the piece is."""

from __future__ import annotations

from enum import IntEnum

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.values import dataclass


class Part(IntEnum):
    """What a move belongs to."""

    TRAVEL = 0
    SKIRT = 1
    FLOOR = 2
    WALL = 3


@dataclass(frozen=True, slots=True, eq=False)
class Strand:
    """One unbroken piece: ``points`` (k, 3) and the ``volumes`` (k − 1,) between them, in mm.

    ``layers`` (k − 1,) is the number of the layer that each move belongs to.
    """

    part: Part
    points: Floats
    volumes: Floats
    layers: np.ndarray


def strand(part: Part, points: Floats, section: Floats, layers: np.ndarray) -> Strand:
    """Return a piece whose bead has the cross-sections ``section`` (k,) mm² at its points."""
    steps = np.sqrt((np.diff(points, axis=0) ** 2).sum(axis=1))
    volumes = steps * (section[:-1] + section[1:]) / 2.0
    return Strand(part, points, volumes, layers[1:])
