"""Bending energies: of the generatrix, and of the surface that it sweeps.

Both diverge in ordinary settings, where a random number would come out of any rule of
integration; these are found first.
"""

from __future__ import annotations

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.curves.profile import Profile
from sgb_core.curves.roots import real_roots
from sgb_core.curves.segment import DEGENERATE_LEG
from sgb_core.surfaces.curvature import cross
from sgb_core.surfaces.pace import HalfSegment, halves
from sgb_core.surfaces.quadrature import integrate
from sgb_core.surfaces.revolution import HasSurface, RevolutionSurface, section_of, surface_of

# A tangent steeper than this at the axis makes the apex of a cone, as for the curvatures.
_FLAT = 1e-9
_RELATIVE = 1e-12
# A zero of L' as near as this to the real axis lies on it: rounding leaves no more.
_REAL = 1e-13


def bending_energy(profile: Profile | RevolutionSurface | HasSurface) -> float | None:
    """Return ∫ κ² dl of a profile, in 1/unit; None where it diverges.

    It does at a vanishing derivative (an end with λ = 4 and ω = 1, or a cusp), where κ grows like
    1/s, unless the next derivatives are parallel there: a straight segment has none whatever its
    parameters. Kinks at joints do not count. Near a cusp inside it grows as the inverse square of
    the distance, near a vanishing end as (1 − ω)⁻². Of a surface it is that of the section at its
    start angle.

    >>> quarter, _ = sgb.arc((0, 0), 10.0, 0.0, math.pi / 2)
    >>> round(sgb.bending_energy(sgb.Profile.of([quarter])), 4)
    0.1571
    """
    profile = section_of(profile)
    size = profile.size or 1.0
    total = 0.0
    for segment, both in zip(profile.segments, halves(profile, size), strict=True):
        if _is_straight(segment.quartic / size):
            continue
        if any(_diverges(half, _standstills(half)) for half in both):
            return None
        for half in both:

            def density(s: Floats, half: HalfSegment = half) -> Floats:
                return _bending(half, s)

            total += integrate(density, half.edges(np.zeros(0)), _RELATIVE)
    return total / size


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
    size = surface.profile.size or 1.0
    total = 0.0
    for segment, both in zip(surface.profile.segments, halves(surface.profile, size), strict=True):
        quartic = segment.quartic / size
        if (np.abs(quartic[:, 0]) <= DEGENERATE_LEG).all():
            # Along the axis there is no surface.
            continue
        straight = _is_straight(quartic)
        for half in both:
            # Where r is least it may touch the axis up to rounding.
            least = [*real_roots(half.radii.tolist()), *real_roots(np.diff(half.radii).tolist())]
            places = np.unique([0.0, *(s for s in least if s <= 0.5), *_standstills(half)])
            on_axis = np.abs(half.radius(places)) <= DEGENERATE_LEG
            if _meets_at_an_angle(half, places[on_axis]):
                return None
            if not straight and _diverges(half, places[~on_axis]):
                return None

            def density(s: Floats, half: HalfSegment = half, straight: bool = straight) -> Floats:
                r = np.abs(half.radius(s))
                below = r * half.speed(s)
                still = below == 0.0
                around = half.climb(s) ** 2 / np.where(still, 1.0, below)
                along = 0.0 if straight else r * _bending(half, s)
                return np.asarray(np.where(still, 0.0, along + around))

            total += integrate(density, half.edges(places), _RELATIVE)
    return surface.sweep * total


def _bending(half: HalfSegment, s: Floats) -> Floats:
    """Return κ² |L'|; 0 where L' vanishes, a place without weight."""
    pace = half.speed(s)
    still = pace == 0.0
    return np.asarray(np.where(still, 0.0, half.turning(s) ** 2 / np.where(still, 1.0, pace)))


def _standstills(half: HalfSegment) -> Floats:
    """Return the s in [0, ½] where L' may vanish: the end, and zeros that are real."""
    zeros = half.zeros[np.abs(half.zeros.imag) <= _REAL]
    inside = zeros.real[(zeros.real > 0.0) & (zeros.real <= 0.5)]
    return np.unique(np.append(inside, 0.0))


def _is_straight(quartic: Floats) -> bool:
    steps = quartic - quartic[0]
    longest = steps[np.argmax(np.hypot(steps[:, 0], steps[:, 1]))]
    length = float(np.hypot(longest[0], longest[1]))
    if length <= DEGENERATE_LEG:
        return True
    return bool((np.abs(cross(steps, longest)) <= DEGENERATE_LEG * length).all())


def _diverges(half: HalfSegment, s: Floats) -> bool:
    """Whether L' vanishes at one of ``s`` with the two derivatives after it not parallel."""
    first, second, third, fourth = (half.derivative(s, order) for order in range(1, 5))
    # At an end: leg fraction × leg length < 1e-12·size. Inside a zero is known to _REAL.
    limit = np.where(s == 0.0, 4.0 * DEGENERATE_LEG, 100.0 * _REAL)
    still = np.abs(first) < limit
    bends = np.abs(second) > 1e-9
    twist = np.where(bends, (second.conj() * third).imag, (third.conj() * fourth).imag)
    return bool((still & (np.abs(twist) > 1e-12)).any())


def _meets_at_an_angle(half: HalfSegment, s: Floats) -> bool:
    """Whether the true tangent at one of ``s``, all on the axis, is not square to the axis."""
    first, second = half.derivative(s, 1), half.derivative(s, 2)
    tangent = np.where(np.abs(first) > 4.0 * DEGENERATE_LEG, first, second)
    return bool((np.abs(tangent.imag) > _FLAT * np.abs(tangent)).any())
