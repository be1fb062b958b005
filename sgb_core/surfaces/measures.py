"""What a surface measures: volume, centroid, sizes, and its generatrix' length and energy.

Volume and centroid are those of the drawn surface, closed to the axis by planes that add nothing:
fluxes through it, ½ ∬ r² h' ds dθ and its moments. Nothing is taken from a mesh. Each function
takes a surface, or what describes one, as a document does.
"""

from __future__ import annotations

from collections.abc import Callable
from math import ceil, cos, sin

import numpy as np

from sgb_core.arrays import Floats, Ints
from sgb_core.curves.nodes import on_nodes, panels
from sgb_core.curves.profile import Profile
from sgb_core.curves.roots import roots_of_each
from sgb_core.surfaces.angular import angle_edges
from sgb_core.surfaces.bounds import bounds, section_reach
from sgb_core.surfaces.energy import bending_energy, surface_bending_energy
from sgb_core.surfaces.pace import halves
from sgb_core.surfaces.quadrature import integrate_each, section_flux
from sgb_core.surfaces.revolution import HasSurface, RevolutionSurface, section_of, surface_of
from sgb_core.surfaces.sections import Sections
from sgb_core.surfaces.stretched_section import section_lengths
from sgb_core.surfaces.varying_area import varying_area

__all__ = [
    "area",
    "bending_energy",
    "bounds",
    "centroid",
    "generatrix_length",
    "height",
    "largest_diameter",
    "segment_lengths",
    "signed_volume",
    "surface_bending_energy",
    "volume",
]


def _sections(surface: RevolutionSurface) -> tuple[Floats, Floats, Sections]:
    """Return angles from the start, their weights, and the sections there, (k, n)."""
    theta, weights = panels(angle_edges(surface), 24)
    return theta, weights, surface.sections(theta)


def signed_volume(surface: RevolutionSurface) -> float:
    """Return ½ ∬ r² ∂h/∂s ds dθ, in unit³; exact without laws: 6 Gauss points a segment.

    Positive where the profile runs up outside (counter-clockwise for a ring).
    """
    if not surface.laws:
        return 0.5 * surface.sweep * float(section_flux(surface.section))
    _, weights, sections = _sections(surface)
    return 0.5 * float(weights @ section_flux(sections))


def volume(surface: RevolutionSurface | HasSurface) -> float:
    """Return |π Σ ∫ r² h' ds|·sweep/2π, in unit³: signs are summed before the absolute value.

    >>> cylinder = sgb.Document(sgb.Profile.of([sgb.line((10, 0), (10, 60))]))
    >>> round(sgb.volume(cylinder) / math.pi, 6)
    6000.0
    """
    return abs(signed_volume(surface_of(surface)))


def centroid(surface: RevolutionSurface | HasSurface) -> Floats | None:
    """Return the placed centroid (x, y, z) of that volume; None where |V| < 1e-12·size³.

    Height from ½ ∬ r² h h', the transverse components from ⅓ ∬ r³ h' cos θ and ⅓ ∬ r³ h' sin θ,
    over the same signed V; degree 15, for which 8 points a segment are exact. A twist turns the
    transverse moments of every slice.

    >>> cylinder = sgb.Document(sgb.Profile.of([sgb.line((10, 0), (10, 60))]))
    >>> sgb.centroid(cylinder).round(6).tolist()
    [0.0, 0.0, 30.0]
    """
    surface = surface_of(surface)
    whole = signed_volume(surface)
    if abs(whole) < 1e-12 * surface.profile.size**3 or whole == 0.0:
        return None
    if surface.laws:
        theta, weights, sections = _sections(surface)
    else:
        theta, weights, sections = np.zeros(1), np.ones(1), surface.section[None]
    lift = sections.integrals(_lift, 8, 12).sum(axis=-1) / 2.0
    reach = sections.integrals(_reach, 8, 18).sum(axis=-1) / 3.0
    start, end = surface.start, surface.start + surface.sweep
    moments: tuple[float, float, float]
    if surface.twisting is not None:
        moments = (_along(surface, weights, lift), *_twisted_moments(surface, theta, weights))
    elif surface.laws:
        angles = surface.start + theta
        moments = (
            float(weights @ lift),
            float(weights @ (reach * np.cos(angles))),
            float(weights @ (reach * np.sin(angles))),
        )
    elif surface.is_full_turn:
        moments = (surface.sweep * lift[0], 0.0, 0.0)
    else:
        moments = (
            surface.sweep * lift[0],
            reach[0] * (sin(end) - sin(start)),
            reach[0] * (cos(start) - cos(end)),
        )
    result = np.zeros(3)
    for coordinate, moment in zip(surface.axis.frame, moments, strict=True):
        result[coordinate] = moment / whole
    return surface.placement.apply(result)


def _lift(sections: Sections, s: Floats) -> Floats:
    r, h = np.moveaxis(sections.on(s), -1, 0)
    return np.asarray(r * r * h * on_nodes(sections.quartics, s, 1)[..., 1])


def _reach(sections: Sections, s: Floats) -> Floats:
    return np.asarray(sections.on(s)[..., 0] ** 3 * on_nodes(sections.quartics, s, 1)[..., 1])


def _along(surface: RevolutionSurface, weights: Floats, lift: Floats) -> float:
    return float(weights @ lift) if surface.laws else surface.sweep * float(lift[0])


def _twisted_moments(
    surface: RevolutionSurface, theta: Floats, weights: Floats
) -> tuple[float, float]:
    """Return ⅓ ∬ r³ h' cos(θ + τ) and ⅓ ∬ r³ h' sin(θ + τ), θ from the sweep's own start."""
    twisting = surface.twisting
    assert twisting is not None
    if surface.is_full_turn and not surface.laws:
        return 0.0, 0.0
    parts = 2 + ceil(8.0 * abs(surface.twist.turns))
    whole = 0.0j

    def part(turn: Callable[[Floats], Floats]) -> Callable[[Sections, Floats], Floats]:
        return lambda some, s: _reach(some, s) * turn(twisting.angle(some.on(s)[..., 1]))

    for number in range(len(surface.profile)):
        sections = surface.sections(theta, numbers=[number])[:, 0]
        cosine, sine = (sections.integrals(part(turn), 12, 6, parts) for turn in (np.cos, np.sin))
        reach = (cosine + 1j * sine) / 3.0
        if surface.laws:
            whole += complex(weights @ (reach * np.exp(1j * (surface.start + theta))))
        else:
            ends = np.exp(1j * (surface.start + np.array([0.0, surface.sweep])))
            whole += complex(reach[0] * (ends[1] - ends[0]) / 1j)
    return whole.real, whole.imag


def area(surface: RevolutionSurface | HasSurface) -> float:
    """Return the area ∬ |S_s × S_θ| of the drawn surface, in unit²; near-exact (1e-9 relative).

    Of a segment without laws sweep · ∫ |r| |L'| ds, whose panels shrink towards the zeros of r
    and of L'.

    >>> cylinder = sgb.Document(sgb.Profile.of([sgb.line((10, 0), (10, 60))]))
    >>> round(sgb.area(cylinder) / math.pi, 6)
    1200.0
    """
    surface = surface_of(surface)
    size = surface.profile.size or 1.0
    varying = [
        number
        for number in range(len(surface.profile))
        if any(law.applies_to(number) for law in surface.laws)
    ]
    total = sum((varying_area(surface, number) for number in varying), 0.0)
    if len(varying) == len(surface.profile):
        return total
    both = halves(surface.profile, size)

    def density(s: Floats, k: Ints) -> Floats:
        return np.asarray(np.abs(both.radius(s, k)) * both.speed(s, k))

    low, high, which = both.panels(*roots_of_each(both.radii))
    kept = ~np.isin(which // 2, varying)
    panels = low[kept], high[kept], which[kept]
    swept = float(integrate_each(density, panels, len(both)).sum())
    return total + surface.sweep * size**2 * swept


def generatrix_length(profile: Profile | RevolutionSurface | HasSurface) -> float:
    """Return the arc length of a profile, in unit, to about 1e-13.

    Of a surface it is that of the section at its start angle.

    >>> round(sgb.generatrix_length(sgb.Profile.of([sgb.line((0, 0), (30, 40))])), 9)
    50.0
    """
    return float(segment_lengths(profile).sum())


def segment_lengths(profile: Profile | RevolutionSurface | HasSurface) -> Floats:
    """Return the arc length of each segment, in unit, shape (n,); as :func:`generatrix_length`."""
    if not isinstance(profile, Profile) and surface_of(profile).fades:
        return section_lengths(surface_of(profile).section)
    profile = section_of(profile)
    size = profile.size or 1.0
    both = halves(profile, size)
    lengths = integrate_each(both.speed, both.panels(), len(both))
    return np.asarray(size * lengths.reshape(-1, 2).sum(axis=1))


def height(surface: RevolutionSurface | HasSurface) -> float:
    """Return how far the surface reaches along its axis, in unit.

    >>> cylinder = sgb.Document(sgb.Profile.of([sgb.line((10, 0), (10, 60))]))
    >>> sgb.height(cylinder)
    60.0
    """
    low, high = section_reach(surface_of(surface))[1]
    return high - low


def largest_diameter(surface: RevolutionSurface | HasSurface) -> float:
    """Return twice the largest distance from the axis, in unit.

    >>> cylinder = sgb.Document(sgb.Profile.of([sgb.line((10, 0), (10, 60))]))
    >>> sgb.largest_diameter(cylinder)
    20.0
    """
    low, high = section_reach(surface_of(surface))[0]
    return 2.0 * max(abs(low), abs(high))
