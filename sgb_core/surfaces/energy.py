"""Bending energies: of the generatrix, and of the surface that it sweeps.

Section 5 of the project's mathematics. Both diverge in ordinary settings, where a random number
would come out of any rule of integration; these are found first.
"""

from __future__ import annotations

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import DEGENERATE_LEG
from sgb_core.surfaces.curvature import cross
from sgb_core.surfaces.normals import unit_tangents
from sgb_core.surfaces.quadrature import inner_roots, integrate, on_nodes, slow_points, speed
from sgb_core.surfaces.revolution import HasSurface, RevolutionSurface, section_of, surface_of

# A tangent steeper than this at the axis makes the apex of a cone, as for the curvatures.
_FLAT = 1e-9
_RELATIVE = 1e-12


def bending_energy(profile: Profile | RevolutionSurface | HasSurface) -> float | None:
    """Return ∫ κ² dl of a profile, in 1/unit; None where it diverges.

    It does at a vanishing derivative (an end with λ = 4 and ω = 1, or a cusp), where κ grows like
    1/s, unless the next derivatives are parallel there: a straight segment has none whatever its
    parameters. Kinks at joints do not count. Of a surface it is that
    of the section at its start angle.

    >>> quarter, _ = sgb.arc((0, 0), 10.0, 0.0, math.pi / 2)
    >>> round(sgb.bending_energy(sgb.Profile.of([quarter])), 4)
    0.1571
    """
    profile = section_of(profile)
    total = 0.0
    for quartic in _at_size_one(profile):
        if _is_straight(quartic):
            continue
        places = np.unique(np.concatenate([[0.0, 1.0], slow_points(quartic)]))
        if _diverges(quartic, places):
            return None

        def density(s: Floats, quartic: Floats = quartic) -> Floats:
            return _bending(quartic, s)

        total += integrate(density, places, _RELATIVE)
    return total / (profile.size or 1.0)


def surface_bending_energy(surface: RevolutionSurface | HasSurface) -> float | None:
    """Return ∬ (κm² + κp²) dA of the drawn surface, a pure number; None where it diverges.

    It is sweep · ∫ (κm² + h'²/(r²|L'|²)) |r| |L'| ds. It diverges where the generatrix' own energy
    does off the axis, and where the profile meets the axis at any angle but a right one: κp grows
    there like 1/r. None too where laws hold, for their sections do not turn on parallels.

    >>> cylinder = sgb.Document(sgb.Profile.of([sgb.line((10, 0), (10, 20))]))
    >>> round(sgb.surface_bending_energy(cylinder) / math.pi, 6)
    4.0
    """
    surface = surface_of(surface)
    if surface.laws:
        return None
    total = 0.0
    for quartic in _at_size_one(surface.profile):
        if (np.abs(quartic[:, 0]) <= DEGENERATE_LEG).all():
            # Along the axis there is no surface.
            continue
        ends = np.array([0.0, 1.0])
        roots, slow = inner_roots(quartic[:, 0]), slow_points(quartic)
        places = np.unique(np.concatenate([ends, roots, slow]))
        on_axis = np.abs(on_nodes(quartic, places)[:, 0]) <= DEGENERATE_LEG
        straight = _is_straight(quartic)
        if _meets_at_an_angle(quartic, places[on_axis]):
            return None
        if not straight and _diverges(quartic, places[~on_axis]):
            return None

        def density(s: Floats, quartic: Floats = quartic, straight: bool = straight) -> Floats:
            r = np.abs(on_nodes(quartic, s)[:, 0])
            below = r * speed(quartic, s)
            still = below == 0.0
            around = on_nodes(quartic, s, 1)[:, 1] ** 2 / np.where(still, 1.0, below)
            along = 0.0 if straight else r * _bending(quartic, s)
            return np.asarray(np.where(still, 0.0, along + around))

        total += integrate(density, places, _RELATIVE)
    return surface.sweep * total


def _at_size_one(profile: Profile) -> Floats:
    """Return the quartics in units of the profile's size: no power of a tiny one underflows."""
    return np.asarray(profile.quartics / (profile.size or 1.0))


def _bending(quartic: Floats, s: Floats) -> Floats:
    """Return κ² |L'| = (L' × L'')² / |L'|⁵; 0 where L' vanishes, a place without weight."""
    turn = cross(on_nodes(quartic, s, 1), on_nodes(quartic, s, 2))
    pace = speed(quartic, s)
    still = pace == 0.0
    return np.asarray(np.where(still, 0.0, turn**2 / np.where(still, 1.0, pace) ** 5))


def _is_straight(quartic: Floats) -> bool:
    steps = quartic - quartic[0]
    longest = steps[np.argmax(np.hypot(steps[:, 0], steps[:, 1]))]
    length = float(np.hypot(longest[0], longest[1]))
    if length <= DEGENERATE_LEG:
        return True
    return bool((np.abs(cross(steps, longest)) <= DEGENERATE_LEG * length).all())


def _diverges(quartic: Floats, s: Floats) -> bool:
    """Whether L' vanishes at one of ``s`` with L'' and L''' (or L''' and L'''') not parallel."""
    first, second, third, fourth = (on_nodes(quartic, s, order) for order in range(1, 5))
    # At an end this is the contract's "leg fraction × leg length < 1e-12·size"; inside, a root
    # known to half the digits leaves a speed of that order.
    limit = np.where((s == 0.0) | (s == 1.0), 4.0 * DEGENERATE_LEG, 1e-7)
    still = np.hypot(first[:, 0], first[:, 1]) < limit
    bends = np.hypot(second[:, 0], second[:, 1]) > 1e-9
    twist = np.where(bends, cross(second, third), cross(third, fourth))
    return bool((still & (np.abs(twist) > 1e-12)).any())


def _meets_at_an_angle(quartic: Floats, s: Floats) -> bool:
    """Whether the true tangent at one of ``s``, all on the axis, is not square to the axis."""
    first, second = on_nodes(quartic, s, 1), on_nodes(quartic, s, 2)
    tangents = unit_tangents(quartic, s, first, second, 1.0)
    return bool((np.abs(tangents[:, 1]) > _FLAT).any())
