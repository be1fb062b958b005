"""Where the finished surface stands: a rotation, then a translation."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.fields.extra import NO_EXTRA
from sgb_core.fields.kinds import COORDINATE, FINITE
from sgb_core.fields.lists import Several
from sgb_core.fields.record import Record, check, says
from sgb_core.values import dataclass


@dataclass(frozen=True, slots=True)
class Placement:
    """Rotations in degrees about the fixed x, y, z axes in that order, then a translation.

    Raises RefusalError, a ValueError, for a value that is not allowed.

    >>> placement = sgb.Placement(rotation_deg=(0, 0, 90), translation=(0, 0, 5))
    >>> placement.apply([10, 0, 0]).round(6).tolist()
    [0.0, 10.0, 5.0]
    """

    RECORD = Record(
        "placement", "Rotations about the fixed x, y, z axes in that order, then a translation."
    )

    rotation_deg: tuple[float, float, float] = field(
        default=(0.0, 0.0, 0.0),
        metadata=says(Several(FINITE, "numbers", 3, 3), label="Rotate"),
    )
    translation: tuple[float, float, float] = field(
        default=(0.0, 0.0, 0.0),
        metadata=says(Several(COORDINATE, "numbers", 3, 3), label="Move"),
    )
    extra: Mapping[str, object] = field(default_factory=lambda: NO_EXTRA, repr=False, hash=False)

    def __post_init__(self) -> None:
        check(self)

    @property
    def is_identity(self) -> bool:
        """Whether nothing is moved."""
        return not any(self.rotation_deg) and not any(self.translation)

    @property
    def matrix(self) -> Floats:
        """The rotation as a matrix of shape (3, 3) that acts on column vectors."""
        rotation: Floats = np.eye(3)
        for axis, degrees in enumerate(self.rotation_deg):
            angle = np.deg2rad(degrees)
            i, j = (axis + 1) % 3, (axis + 2) % 3
            turn = np.eye(3)
            turn[i, i] = turn[j, j] = np.cos(angle)
            turn[j, i] = np.sin(angle)
            turn[i, j] = -turn[j, i]
            rotation = np.asarray(turn @ rotation)
        return rotation

    def apply(self, points: Floats) -> Floats:
        """Return placed points, shape (..., 3)."""
        if self.is_identity:
            return points
        placed: Floats = points @ self.matrix.T + np.asarray(self.translation)
        return placed

    def apply_to_directions(self, vectors: Floats) -> Floats:
        """Return rotated, not translated, vectors of shape (..., 3)."""
        if not any(self.rotation_deg):
            return vectors
        turned: Floats = vectors @ self.matrix.T
        return turned
