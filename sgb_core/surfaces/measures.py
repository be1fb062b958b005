"""What a surface measures: volume, centroid, sizes, and its generatrix' length and energy.

Section 5 of the project's mathematics. Volume and centroid are those of the drawn surface, closed
to the axis by planes that add nothing; they are formulas, not taken from a mesh. Each function
takes a surface, or what describes one, as a document does.
"""

from __future__ import annotations

from math import cos, sin

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.curves.profile import Profile
from sgb_core.surfaces.angular import angle_edges
from sgb_core.surfaces.bounds import bounds, section_reach
from sgb_core.surfaces.curvature import cross
from sgb_core.surfaces.energy import bending_energy, surface_bending_energy
from sgb_core.surfaces.quadrature import (
    gauss,
    inner_roots,
    integrate,
    on_nodes,
    panels,
    section_flux,
    slow_points,
    speed,
)
from sgb_core.surfaces.revolution import HasSurface, RevolutionSurface, section_of, surface_of
from sgb_core.surfaces.variation import varying_quartics

__all__ = [
    "area",
    "bending_energy",
    "bounds",
    "centroid",
    "generatrix_length",
    "height",
    "largest_diameter",
    "signed_volume",
    "surface_bending_energy",
    "volume",
]


def _sections(surface: RevolutionSurface) -> tuple[Floats, Floats, Floats]:
    """Return angles from the start, their weights, and the quartics there, (k, n, 5, 2)."""
    theta, weights = panels(angle_edges(surface), 24)
    return theta, weights, varying_quartics(surface.profile, surface.laws, theta)[0]


def signed_volume(surface: RevolutionSurface) -> float:
    """Return ½ ∬ r² ∂h/∂s ds dθ, in unit³; exact without laws: 6 Gauss points a segment.

    Positive where the profile runs up outside (counter-clockwise for a ring).
    """
    if not surface.laws:
        return 0.5 * surface.sweep * float(section_flux(surface.profile.quartics))
    _, weights, quartics = _sections(surface)
    return 0.5 * float(weights @ section_flux(quartics))


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
    over the same signed V; degree 15, for which 8 points a segment are exact.

    >>> cylinder = sgb.Document(sgb.Profile.of([sgb.line((10, 0), (10, 60))]))
    >>> sgb.centroid(cylinder).round(6).tolist()
    [0.0, 0.0, 30.0]
    """
    surface = surface_of(surface)
    whole = signed_volume(surface)
    if abs(whole) < 1e-12 * surface.profile.size**3 or whole == 0.0:
        return None
    nodes, node_weights = gauss(8)
    if surface.laws:
        theta, weights, quartics = _sections(surface)
    else:
        theta, weights, quartics = np.zeros(1), np.ones(1), surface.profile.quartics[None]
    point, rate = on_nodes(quartics, nodes), on_nodes(quartics, nodes, 1)
    r, h, dh = point[..., 0], point[..., 1], rate[..., 1]
    lift = ((r * r * h * dh) @ node_weights).sum(axis=-1) / 2.0
    reach = ((r**3 * dh) @ node_weights).sum(axis=-1) / 3.0
    start, end = surface.start, surface.start + surface.sweep
    moments: tuple[float, float, float]
    if surface.laws:
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


def area(surface: RevolutionSurface | HasSurface) -> float:
    """Return the area ∬ |S_s × S_θ| of the drawn surface, in unit²; near-exact (1e-10 relative).

    Without laws sweep · ∫ |r| |L'| ds by bisected Gauss panels, split where r changes its sign.

    >>> cylinder = sgb.Document(sgb.Profile.of([sgb.line((10, 0), (10, 60))]))
    >>> round(sgb.area(cylinder) / math.pi, 6)
    1200.0
    """
    surface = surface_of(surface)
    if surface.laws:
        return _varying_area(surface)
    total = 0.0
    for quartic in surface.profile.quartics:
        edges = np.concatenate([[0.0, 1.0], inner_roots(quartic[:, 0]), slow_points(quartic)])

        def density(s: Floats, quartic: Floats = quartic) -> Floats:
            return np.asarray(np.abs(on_nodes(quartic, s)[:, 0]) * speed(quartic, s))

        total += integrate(density, np.unique(edges))
    return surface.sweep * total


def _varying_area(surface: RevolutionSurface) -> float:
    """Integrate √(r²|L'|² + (r_θ h_s − h_θ r_s)²) over panels graded towards all edges.

    Near an angle where an end derivative vanishes the integrand is smooth in neither variable;
    panels that halve towards s = 0, s = 1 and the laws' special angles keep ten digits.
    """
    theta, weights = panels(_graded(angle_edges(surface, bare=True), 10), 8)
    s, s_weights = panels(_graded(np.array([0.0, 1.0]), 12), 10)
    total = 0.0
    # Some hundred angles at a time bound the memory whatever the number of laws.
    for part in np.array_split(np.arange(len(theta)), len(theta) // 128 + 1):
        quartics, rates = varying_quartics(surface.profile, surface.laws, theta[part])
        point, velocity, change = (
            on_nodes(quartics, s),
            on_nodes(quartics, s, 1),
            on_nodes(rates, s),
        )
        pace = np.hypot(velocity[..., 0], velocity[..., 1])
        density = np.hypot(point[..., 0] * pace, cross(change, velocity))
        total += float(weights[part] @ (density @ s_weights).sum(axis=-1))
    return total


def _graded(edges: Floats, levels: int) -> Floats:
    """Return edges with each interval halved towards both its ends ``levels`` times."""
    toward = 0.5 ** np.arange(levels, 0, -1)
    shares = np.concatenate([[0.0], toward, 1.0 - toward[-2::-1]])
    inner = edges[:-1, None] + np.diff(edges)[:, None] * shares
    return np.append(inner.ravel(), edges[-1])


def generatrix_length(profile: Profile | RevolutionSurface | HasSurface) -> float:
    """Return the arc length of a profile, in unit, to about 1e-13.

    Of a surface it is that of the section at its start angle.

    >>> sgb.generatrix_length(sgb.Profile.of([sgb.line((0, 0), (30, 40))]))
    50.0
    """
    total = 0.0
    for quartic in section_of(profile).quartics:
        edges = np.unique(np.concatenate([[0.0, 1.0], slow_points(quartic)]))

        def density(s: Floats, quartic: Floats = quartic) -> Floats:
            return speed(quartic, s)

        total += integrate(density, edges)
    return total


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
