"""The rotation surface: a profile turned about an axis."""

from __future__ import annotations

from collections.abc import Sequence
from enum import StrEnum
from functools import cached_property
from math import isfinite, pi, radians
from typing import Protocol

import numpy as np
from numpy.typing import ArrayLike

from sgb_core.arrays import Floats
from sgb_core.curves.profile import Profile
from sgb_core.curves.roots import extremes_of_all
from sgb_core.curves.segment import ShapeParameters
from sgb_core.surfaces.curvature import meridian_curvature, parallel_curvature
from sgb_core.surfaces.laws.strength import Strength
from sgb_core.surfaces.normals import surface_normals
from sgb_core.surfaces.placement import Placement
from sgb_core.surfaces.quadrature import section_flux
from sgb_core.surfaces.sections import Sections, Stretch
from sgb_core.surfaces.stretched_section import stretched_profile
from sgb_core.surfaces.twist import Twist, Twisting
from sgb_core.surfaces.variation import (
    Law,
    departures,
    parameters,
    radius_factors,
    varying_quartics,
)
from sgb_core.values import dataclass


class Axis(StrEnum):
    """The coordinate axis about which the profile turns, (25)–(27)."""

    X = "x"
    Y = "y"
    Z = "z"

    @property
    def frame(self) -> tuple[int, int, int]:
        """The coordinates of height, of r cos θ and of r sin θ: a right-handed triple."""
        return {Axis.X: (0, 1, 2), Axis.Y: (1, 2, 0), Axis.Z: (2, 0, 1)}[self]


@dataclass(frozen=True)
class RevolutionSurface:
    """S(segment, s, θ): the profile turned by θ, ``start`` ≤ θ ≤ ``start`` + ``sweep`` (radians).

    Laws make shape parameters or the radius depend on θ − start. ``twist`` turns each slice by
    what its height says, ``placement`` moves the result.
    Raises ValueError unless 0 < sweep ≤ 2π and all else is of its kind.

    >>> profile = sgb.Profile.of([sgb.line((10, 0), (10, 60))])
    >>> quarter = sgb.RevolutionSurface(profile, sweep=math.pi / 2)
    >>> quarter.point(0, 0.5, math.pi / 2).round(6).tolist()
    [0.0, 10.0, 30.0]
    """

    profile: Profile
    axis: Axis = Axis.Z
    start: float = 0.0
    sweep: float = 2.0 * pi
    laws: tuple[Law, ...] = ()
    placement: Placement = Placement()
    twist: Twist = Twist()

    def __post_init__(self) -> None:
        object.__setattr__(self, "axis", Axis(self.axis))
        for name, kind in (("profile", Profile), ("placement", Placement), ("twist", Twist)):
            if not isinstance(getattr(self, name), kind):
                raise ValueError(f"{name} is {getattr(self, name)!r}; allowed is a {kind.__name__}")
        if not all(isinstance(law, Law) for law in self.laws):
            raise ValueError(f"laws is {self.laws!r}; allowed is a tuple of Law")
        if not isfinite(self.start):
            raise ValueError(f"start is {self.start!r} rad; allowed is a finite number")
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
        twist: Twist = Twist(),
    ) -> RevolutionSurface:
        """Return the surface with its angles given in degrees."""
        sweep = 2.0 * pi if sweep_deg == 360.0 else radians(sweep_deg)
        return cls(profile, axis, radians(start_deg), sweep, laws, placement, twist)

    @property
    def is_full_turn(self) -> bool:
        """Whether the last meridian meets the first."""
        return self.sweep == 2.0 * pi

    @cached_property
    def heights(self) -> tuple[float, float]:
        """The lowest and the highest height of the section at the start angle."""
        quartics = self.profile.quartics
        if self.laws:
            quartics = varying_quartics(self.profile, self.laws, 0.0)[0]
        return extremes_of_all(quartics[..., 1])

    @property
    def _is_level(self) -> bool:
        low, high = self.heights
        return high - low <= 1e-12 * self.profile.size

    @cached_property
    def twisting(self) -> Twisting | None:
        """The twist between the lowest and the highest height at the start angle; None: none.

        Neither is there any where all is at one height.
        """
        if self.twist.turns == 0.0 or self._is_level:
            return None
        return Twisting(*self.heights, self.twist.turns, self.twist.ease)

    @cached_property
    def _fading(self) -> tuple[tuple[Law, ...], tuple[Strength, ...]]:
        """The laws whose strength changes along the height, and those strengths."""
        laws = tuple(law for law in self.laws if law.steady is None)
        low, high = self.heights if laws else (0.0, 0.0)
        # At one height all have the strength of the lowest.
        reach = (low, low + (self.profile.size or 1.0)) if self._is_level else (low, high)
        return laws, tuple(Strength.through(law.along, *reach) for law in laws)

    @property
    def fades(self) -> bool:
        """Whether the strength of any law changes along the height."""
        return bool(self._fading[0])

    @property
    def strengths(self) -> tuple[Strength, ...]:
        """The strengths of the laws that change along the height, in their order."""
        return self._fading[1]

    def sections(
        self, theta: ArrayLike, side: ArrayLike = 1, numbers: Sequence[int] | None = None
    ) -> Sections:
        """Return the sections at angles from the start, of shape (*θ.shape, n).

        ``side`` and ``numbers`` as for :func:`parameters`.
        """
        quartics, rates = varying_quartics(self.profile, self.laws, theta, side, numbers)
        laws, strengths = self._fading
        if not laws:
            return Sections(quartics, rates)
        stretch = Stretch(strengths, *departures(self.profile, laws, theta, side, numbers))
        return Sections(quartics, rates, stretch)

    @property
    def section(self) -> Sections:
        """The section at the start angle, shape (n,)."""
        if self.laws:
            return self.sections(0.0)
        return Sections(self.profile.quartics, np.zeros_like(self.profile.quartics))

    def turned(self, theta: Floats, h: Floats) -> Floats:
        """Return the angles to which places of θ come at heights, broadcast."""
        return theta if self.twisting is None else np.asarray(theta + self.twisting.angle(h))

    @cached_property
    def mean_flux(self) -> float:
        """∫ r² h' ds, averaged over the angle where laws hold; its sign says which side is out."""
        if not self.laws:
            return float(section_flux(self.section))
        theta = self.sweep * (np.arange(64) + 0.5) / 64.0
        return float(section_flux(self.sections(theta)).mean())

    @cached_property
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

    def profile_at(self, theta: float) -> Profile:
        """Return the profile with its laws evaluated at an absolute angle in radians.

        Where strengths change along the height it is a chain of cubics near the section.
        """
        if self.fades:
            return stretched_profile(self.sections(theta - self.start), self.profile)
        return self.shape_at(theta)

    def shape_at(self, theta: float) -> Profile:
        """Return that profile without what strengths along the height add: segment by segment."""
        if not self.laws:
            return self.profile
        values = parameters(self.profile, self.laws, theta - self.start)[0]
        factors = radius_factors(self.profile, self.laws, theta - self.start)[0]
        return self.profile.with_segments(
            segment.with_points(segment.points * (factor, 1.0)).with_shape(
                ShapeParameters(*(float(value) for value in row))
            )
            for segment, row, factor in zip(self.profile.segments, values, factors, strict=True)
        )

    def point(self, segment: int, s: ArrayLike, theta: ArrayLike) -> Floats:
        """Return S, (25)–(27) and placed, at broadcast ``s`` and absolute angles ``theta``.

        Shape (*broadcast, 3).
        """
        local = self._local(segment, s, theta)
        r, h = local.derivative(0)[..., 0], local.derivative(0)[..., 1]
        vectors = self.directions(self.turned(local.theta, h))
        placed = r[..., None] * vectors[..., 0, :] + h[..., None] * vectors[..., 2, :]
        return np.asarray(placed + np.asarray(self.placement.translation))

    def partials(self, segment: int, s: ArrayLike, theta: ArrayLike) -> tuple[Floats, Floats]:
        """Return ∂S/∂s and ∂S/∂θ (per radian, laws included), each shape (*broadcast, 3)."""
        local = self._local(segment, s, theta)
        point, first, change = local.derivative(0), local.derivative(1), local.change
        r, h = point[..., 0], point[..., 1]
        vectors = self.directions(self.turned(local.theta, h))
        pull = np.zeros(local.s.shape) if self.twisting is None else r * self.twisting.rate(h)
        along = np.stack([first[..., 0], pull * first[..., 1], first[..., 1]], axis=-1)
        around = np.stack([change[..., 0], r + pull * change[..., 1], change[..., 1]], axis=-1)
        return (
            np.asarray(np.einsum("...i,...ij->...j", along, vectors)),
            np.asarray(np.einsum("...i,...ij->...j", around, vectors)),
        )

    def normal(self, segment: int, s: ArrayLike, theta: ArrayLike) -> Floats:
        """Return the exact outward unit normal, shape (*broadcast, 3); see :attr:`flips`.

        Where a derivative vanishes it is the one-sided limit; on the axis the meridian's.
        """
        local = self._local(segment, s, theta)
        tangents, change = local.tangents, local.change
        slip = change[..., 0] * tangents[..., 1] - change[..., 1] * tangents[..., 0]
        point = local.derivative(0)
        components = surface_normals(tangents, slip, point[..., 0], local.signs, self.profile.size)
        if self.twisting is not None:
            components = self.twisting.normals(components, point)
        outward = -components if self.flips else components
        vectors = self.directions(self.turned(local.theta, point[..., 1]))
        return np.asarray(np.einsum("...i,...ij->...j", outward, vectors))

    def curvatures(self, segment: int, s: ArrayLike, theta: ArrayLike) -> tuple[Floats, Floats]:
        """Return the meridian and the parallel curvature (κm, κp), each of the broadcast shape.

        Positive where the surface bends away from the outward normal: both 1/R on a sphere. They
        are the principal curvatures where no law holds. Infinite at a cone's apex and at ordinary
        vanishing derivatives, with the sign of the limit.
        """
        local = self._local(segment, s, theta)
        size = self.profile.size
        derivatives = tuple(local.derivative(order) for order in range(1, 5))
        meridian = meridian_curvature(derivatives, local.s == 1.0, size)
        r = local.derivative(0)[..., 0]
        parallel = parallel_curvature(r, local.tangents, meridian, size)
        sign = -local.signs if self.flips else local.signs
        return sign * meridian, sign * parallel

    def _local(self, segment: int, s: ArrayLike, theta: ArrayLike) -> _Local:
        s, theta = np.broadcast_arrays(np.asarray(s, np.float64), np.asarray(theta, np.float64))
        if self.laws:
            sections = self.sections(theta - self.start, numbers=(segment,)).of_segment(0)
        else:
            quartic = self.profile.segments[segment].quartic
            quartics = np.broadcast_to(quartic, (*s.shape, 5, 2))
            sections = Sections(quartics, np.zeros_like(quartics))
        return _Local(sections, s, theta, self.profile.size)

    def angles(self, count: int) -> Floats:
        """Return ``count`` + 1 angles in radians at equal steps from start to start + sweep."""
        return self.start + self.sweep * np.linspace(0.0, 1.0, count + 1)


class HasSurface(Protocol):
    """What describes a rotation surface, as a document does."""

    @property
    def surface(self) -> RevolutionSurface:
        """The surface described."""
        ...


def surface_of(thing: RevolutionSurface | HasSurface) -> RevolutionSurface:
    """Return the surface that is meant: the thing itself, or the one that it describes."""
    return thing if isinstance(thing, RevolutionSurface) else thing.surface


def section_of(thing: Profile | RevolutionSurface | HasSurface) -> Profile:
    """Return the profile that is meant: the thing itself, or a surface's at its start angle."""
    if isinstance(thing, Profile):
        return thing
    surface = surface_of(thing)
    return surface.profile_at(surface.start)


@dataclass(frozen=True, slots=True)
class _Local:
    """Sections, each evaluated at its own s and θ, all of one shape."""

    sections: Sections
    s: Floats
    theta: Floats
    size: float

    def derivative(self, order: int) -> Floats:
        """Return the ``order``-th derivative of L by s, shape (*s.shape, 2)."""
        return self.sections.of_each(self.s, order)

    @property
    def change(self) -> Floats:
        """∂L/∂θ, shape (*s.shape, 2)."""
        return self.sections.changes_of_each(self.s)

    @property
    def tangents(self) -> Floats:
        """Unit tangents, shape (*s.shape, 2)."""
        return self.sections.tangents_of_each(self.s, self.size)

    @property
    def signs(self) -> Floats:
        """The side of the axis; on it, that of the segment a thousandth further inside."""
        r = self.derivative(0)[..., 0]
        inside = self.sections.of_each(np.where(self.s < 0.5, 1e-3, -1e-3) + self.s)
        side = np.where(np.abs(r) <= 1e-9 * self.size, inside[..., 0], r)
        return np.where(side < 0.0, -1.0, 1.0)
