"""The law of a regular polygon: what the radius is multiplied by to make n flat sides.

With the corners on the unit circle and one at θ = 0, at the angle ψ from the nearest corner:
the side is a/cos(π/n − ψ), a = cos(π/n). A corner rounded with radius ρ is an arc about the point
c = 1 − ρ/a on its ray, c cos ψ + √(ρ² − c² sin² ψ), up to where it touches the sides, at
tan ψ = ρ sin(π/n)/(c + ρ a).
"""

from __future__ import annotations

from math import atan2, cos, pi, sin
from types import MappingProxyType

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.surfaces.laws.shape import LawShape, Settings, beside, from_nearest


def _corner(law: Settings) -> tuple[float, float, float, float]:
    """Return the apothem, the arc's radius, its centre, and the angle where it ends."""
    half = pi / law.count
    apothem = cos(half)
    radius = min(law.round, apothem)
    centre = 1.0 - radius / apothem
    return apothem, radius, centre, atan2(radius * sin(half), centre + radius * apothem)


def _fraction(law: Settings, theta: Floats) -> Floats:
    apothem, radius, centre, end = _corner(law)
    away = np.abs(from_nearest(law, theta))
    side = apothem / np.cos(pi / law.count - away)
    reach = np.sqrt(np.maximum(radius**2 - (centre * np.sin(away)) ** 2, 0.0))
    return np.where(away < end, centre * np.cos(away) + reach, side)


def _rate(law: Settings, theta: Floats, side: Floats) -> Floats:
    apothem, radius, centre, end = _corner(law)
    turned = from_nearest(law, theta)
    away = np.abs(turned)
    from_side = pi / law.count - away
    straight = -apothem * np.sin(from_side) / np.cos(from_side) ** 2
    reach = np.sqrt(np.maximum(radius**2 - (centre * np.sin(away)) ** 2, 0.0))
    sine, cosine = centre * np.sin(away), centre * np.cos(away)
    arc = -sine - sine * cosine / np.where(reach > 0.0, reach, 1.0)
    way = np.where(from_nearest(law, beside(theta, side)) >= 0.0, 1.0, -1.0)
    return way * np.where(away < end, arc, straight)


def _breaks(law: Settings) -> tuple[float, ...]:
    end, wave = _corner(law)[3], 2.0 * pi / law.count
    if law.round <= 0.0:
        return _corners(law)
    return tuple((k * wave + way) % (2.0 * pi) for k in range(law.count) for way in (-end, end))


def _corners(law: Settings) -> tuple[float, ...]:
    if law.round > 0.0:
        return ()
    return tuple(k * 2.0 * pi / law.count for k in range(law.count))


def _span(law: Settings) -> tuple[float, float]:
    apothem, radius, centre, _ = _corner(law)
    return apothem, centre + radius


POLYGON = LawShape(
    "polygon",
    "Polygon",
    "n flat sides, a regular polygon whose corners lie on the drawn circle, sharp or rounded",
    _fraction,
    _rate,
    breaks=_breaks,
    creases=_corners,
    waves=lambda law: law.count,
    brief=lambda law: f"{law.count} sides",
    advice="From 0 to 1 the sides are flat; with From nearer to 1 they bulge towards the circle.",
    uses=("count", "round"),
    of_radius=True,
    first=MappingProxyType({"count": 6}),
    span=_span,
    least_count=3,
    natural=(0.0, 1.0),
)
