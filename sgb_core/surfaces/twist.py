"""Twist: each horizontal slice of a body turned about the axis by what its height says.

The slice at height h is turned by τ(h) = 2π·turns·e(u), u = (h − h0)/(h1 − h0) held within
[0, 1], with e(u) = u or 3u² − 2u³. A slice stays what it is: volumes and horizontal sections keep
their size exactly. In cylindrical parts a tangent (a_ρ, a_θ, a_h) becomes
(a_ρ, a_θ + r τ' a_h, a_h), a normal (n_ρ, n_θ, n_h − r τ' n_θ), both turned by τ.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field
from enum import StrEnum
from math import pi

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.fields.extra import NO_EXTRA
from sgb_core.fields.kinds import Choice, Range
from sgb_core.fields.record import Record, check, says
from sgb_core.values import dataclass

# More turns than this in either direction no mesh shows.
MAX_TURNS = 100.0


class Ease(StrEnum):
    """How the twist sets in along the height."""

    LINEAR = "linear"
    SMOOTH = "smooth"


@dataclass(frozen=True, slots=True)
class Twist:
    """How far a body's top is turned against its foot; positive adds to the angle.

    Raises RefusalError, a ValueError, for a value that is not allowed.

    >>> tube = sgb.Document(sgb.Profile.of([sgb.line((20, 0), (20, 60))]))
    >>> lobed = sgb.edits.add_law(tube, sgb.Law("radius", "lobes", 0.9, 1.1, count=8))
    >>> twisted = sgb.edits.set_twist(lobed, turns=0.5)
    >>> twisted.volume == lobed.volume, twisted.area > lobed.area
    (True, True)
    """

    RECORD = Record("twist", "Horizontal slices turned about the axis by what their height says.")

    turns: float = field(
        default=0.0,
        metadata=says(
            Range(-MAX_TURNS, MAX_TURNS),
            label="Twist",
            tip="By how many turns the top is turned against the foot. Volume, capacity and "
            "material stay exactly what they are.",
        ),
    )
    ease: Ease = field(
        default=Ease.LINEAR,
        metadata=says(
            Choice(Ease),
            label="Ease",
            titles={Ease.LINEAR: "Even", Ease.SMOOTH: "Eased"},
            tips={
                Ease.LINEAR: "The same twist at every height",
                Ease.SMOOTH: "Sets in gently at the foot and fades out at the rim",
            },
        ),
    )
    extra: Mapping[str, object] = field(default_factory=lambda: NO_EXTRA, repr=False, hash=False)

    def __post_init__(self) -> None:
        check(self)


@dataclass(frozen=True, slots=True)
class Twisting:
    """A twist between two heights: the angles τ in radians that it turns slices by."""

    low: float
    high: float
    turns: float
    ease: Ease

    def _shares(self, h: Floats) -> Floats:
        return np.clip((h - self.low) / (self.high - self.low), 0.0, 1.0)

    def angle(self, h: Floats) -> Floats:
        """Return τ at heights."""
        u = self._shares(h)
        eased = u if self.ease is Ease.LINEAR else u * u * (3.0 - 2.0 * u)
        return np.asarray(2.0 * pi * self.turns * eased)

    def rate(self, h: Floats) -> Floats:
        """Return dτ/dh at heights: at the ends that of the inside, beyond them 0."""
        u = self._shares(h)
        slope = np.ones_like(u) if self.ease is Ease.LINEAR else 6.0 * u * (1.0 - u)
        reach = self.high - self.low
        slack = 1e-12 * reach
        inside = (h >= self.low - slack) & (h <= self.high + slack)
        return np.where(inside, 2.0 * pi * self.turns / reach * slope, 0.0)

    def steepest(self) -> float:
        """Return the largest |dτ/dh|."""
        most = 1.0 if self.ease is Ease.LINEAR else 1.5
        return abs(2.0 * pi * self.turns / (self.high - self.low)) * most

    def normals(self, normals: Floats, points: Floats) -> Floats:
        """Return unit normals of twisted places, on the axes that turn with them, (..., 3).

        ``normals`` (..., 3) are those without twist on e_ρ, e_θ, e_h, ``points`` (..., 2) the
        places' (r, h).
        """
        r, h = points[..., 0], points[..., 1]
        found = np.array(
            np.broadcast_to(normals, (*np.broadcast_shapes(r.shape, normals.shape[:-1]), 3))
        )
        found[..., 2] -= r * self.rate(h) * found[..., 1]
        return np.asarray(found / np.linalg.norm(found, axis=-1)[..., None])
