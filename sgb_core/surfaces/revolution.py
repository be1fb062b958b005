"""The rotation surface: a profile turned about an axis."""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum
from math import pi, radians

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.curves.profile import Profile
from sgb_core.surfaces.placement import Placement
from sgb_core.surfaces.quadrature import section_flux
from sgb_core.surfaces.variation import Law, varying_quartics


class Axis(StrEnum):
    """The coordinate axis about which the profile turns, (25)–(27)."""

    X = "x"
    Y = "y"
    Z = "z"

    @property
    def frame(self) -> tuple[int, int, int]:
        """The coordinates of height, of r cos θ and of r sin θ: a right-handed triple."""
        return {Axis.X: (0, 1, 2), Axis.Y: (1, 2, 0), Axis.Z: (2, 0, 1)}[self]


@dataclass(frozen=True, slots=True)
class RevolutionSurface:
    """S(segment, s, θ): the profile turned by θ, ``start`` ≤ θ ≤ ``start`` + ``sweep`` (radians).

    Laws make shape parameters depend on θ − start. ``placement`` moves the result.
    Raises ValueError unless 0 < sweep ≤ 2π.
    """

    profile: Profile
    axis: Axis = Axis.Z
    start: float = 0.0
    sweep: float = 2.0 * pi
    laws: tuple[Law, ...] = ()
    placement: Placement = Placement()

    def __post_init__(self) -> None:
        if not 0.0 < self.sweep <= 2.0 * pi:
            raise ValueError(f"sweep is {self.sweep!r} rad; allowed is above 0 and at most 2π")

    @classmethod
    def of_degrees(
        cls,
        profile: Profile,
        axis: Axis = Axis.Z,
        start_deg: float = 0.0,
        sweep_deg: float = 360.0,
        laws: tuple[Law, ...] = (),
        placement: Placement = Placement(),
    ) -> RevolutionSurface:
        """Return the surface with its angles given in degrees."""
        sweep = 2.0 * pi if sweep_deg == 360.0 else radians(sweep_deg)
        return cls(profile, axis, radians(start_deg), sweep, laws, placement)

    @property
    def is_full_turn(self) -> bool:
        """Whether the last meridian meets the first."""
        return self.sweep == 2.0 * pi

    @property
    def mean_flux(self) -> float:
        """∫ r² h' ds, averaged over the angle where laws hold; its sign says which side is out."""
        if not self.laws:
            return float(section_flux(self.profile.quartics))
        theta = self.sweep * (np.arange(64) + 0.5) / 64.0
        return float(section_flux(varying_quartics(self.profile, self.laws, theta)[0]).mean())

    @property
    def flips(self) -> bool:
        """Whether outward is −(∂S/∂θ × ∂S/∂s): where the signed volume is negative.

        ∂S/∂θ × ∂S/∂s = r (h' e_ρ − r' e_h) is outward for a profile that runs up outside. A
        volume that is zero up to rounding flips nothing.
        """
        return self.mean_flux < -1e-12 * self.profile.size**3

    def directions(self, theta: Floats) -> Floats:
        """Return the placed unit vectors e_ρ, e_θ, e_h at absolute angles, shape (*θ.shape, 3, 3).

        Row 0 points away from the axis, row 1 along the turn, row 2 along the axis: a right-handed
        triple.
        """
        height, cosine, sine = self.axis.frame
        vectors = np.zeros((*theta.shape, 3, 3))
        vectors[..., 0, cosine] = vectors[..., 1, sine] = np.cos(theta)
        vectors[..., 0, sine] = np.sin(theta)
        vectors[..., 1, cosine] = -vectors[..., 0, sine]
        vectors[..., 2, height] = 1.0
        return self.placement.apply_to_directions(vectors)

    def angles(self, count: int) -> Floats:
        """Return ``count`` + 1 angles in radians at equal steps from start to start + sweep."""
        return self.start + self.sweep * np.linspace(0.0, 1.0, count + 1)
