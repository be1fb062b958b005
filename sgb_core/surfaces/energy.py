"""Bending energies: of the generatrix, and of the surface that it sweeps.

Both diverge in ordinary settings, where a random number would come out of any rule of
integration; these are found first.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from sgb_core.arrays import Floats, Ints
from sgb_core.curves.profile import Profile
from sgb_core.curves.roots import roots_of_each
from sgb_core.curves.segment import DEGENERATE_LEG
from sgb_core.surfaces.curvature import cross
from sgb_core.surfaces.pace import Halves, halves
from sgb_core.surfaces.quadrature import Panels, integrate_each
from sgb_core.surfaces.revolution import HasSurface, RevolutionSurface, section_of, surface_of
from sgb_core.surfaces.stretched_section import section_energy

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
    if not isinstance(profile, Profile) and surface_of(profile).fades:
        surface = surface_of(profile)
        # A vanishing derivative does so whatever stretches the section.
        if bending_energy(surface.shape_at(surface.start)) is None:
            return None
        return section_energy(surface.section)
    profile = section_of(profile)
    size = profile.size or 1.0
    both = halves(profile, size)
    bent = ~_are_straight(profile.quartics / size)[np.arange(len(both)) // 2]
    places, of = _standstills(both)
    places, of = places[bent[of]], of[bent[of]]
    if _diverges(both, places, of).any():
        return None
    panels = _only(both.panels(), bent)

    def density(s: Floats, k: Ints) -> Floats:
        return _bending(both, s, k)

    return float(integrate_each(density, panels, len(both), _RELATIVE).sum()) / size


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
    both = halves(surface.profile, size)
    quartics = surface.profile.quartics / size
    # Along the axis there is no surface.
    radii = np.abs(quartics[:, :, 0]).max(axis=1)
    swept = (radii > DEGENERATE_LEG)[np.arange(len(both)) // 2]
    straight = _are_straight(quartics)[np.arange(len(both)) // 2]
    # Where r is least it may touch the axis up to rounding.
    places, of = _together(
        roots_of_each(both.radii), roots_of_each(np.diff(both.radii, axis=1)), _standstills(both)
    )
    kept = swept[of] & (places <= 0.5)
    places, of = places[kept], of[kept]
    on_axis = np.abs(both.radius(places, of)) <= DEGENERATE_LEG
    if _meets_at_an_angle(both, places[on_axis], of[on_axis]):
        return None
    bent = ~on_axis & ~straight[of]
    if _diverges(both, places[bent], of[bent]).any():
        return None

    def density(s: Floats, k: Ints) -> Floats:
        r = np.abs(both.radius(s, k))
        below = r * both.speed(s, k)
        still = below == 0.0
        around = both.climb(s, k) ** 2 / np.where(still, 1.0, below)
        along = np.where(straight[k], 0.0, r * _bending(both, s, k))
        return np.asarray(np.where(still, 0.0, along + around))

    panels = _only(both.panels(places, of), swept)
    return surface.sweep * float(integrate_each(density, panels, len(both), _RELATIVE).sum())


def _only(panels: Panels, wanted: NDArray[np.bool_]) -> Panels:
    """Return those panels whose half is wanted."""
    low, high, which = panels
    kept = wanted[which]
    return low[kept], high[kept], which[kept]


def _together(*parts: tuple[Floats, Ints]) -> tuple[Floats, Ints]:
    places, of = (np.concatenate(each) for each in zip(*parts, strict=True))
    return places, of


def _bending(both: Halves, s: Floats, k: Ints) -> Floats:
    """Return κ² |L'|; 0 where L' vanishes, a place without weight."""
    pace = both.speed(s, k)
    still = pace == 0.0
    return np.asarray(np.where(still, 0.0, both.turning(s, k) ** 2 / np.where(still, 1.0, pace)))


def _standstills(both: Halves) -> tuple[Floats, Ints]:
    """Return the s in [0, ½] where L' may vanish: the ends, and zeros that are real; whose."""
    zeros = both.zeros
    inside = (np.abs(zeros.imag) <= _REAL) & (zeros.real > 0.0) & (zeros.real <= 0.5)
    each = np.arange(len(both))
    return _together((np.zeros(len(both)), each), (zeros.real[inside], np.nonzero(inside)[0]))


def _are_straight(quartics: Floats) -> NDArray[np.bool_]:
    """Whether each quartic, shape (n, 5, 2), is a straight line or a point, shape (n,)."""
    steps = quartics - quartics[:, :1]
    lengths = np.hypot(steps[..., 0], steps[..., 1])
    each = np.arange(len(quartics))
    farthest = np.argmax(lengths, axis=1)
    longest, length = steps[each, farthest], lengths[each, farthest]
    off = np.abs(cross(steps, longest[:, None])) <= DEGENERATE_LEG * length[:, None]
    return np.asarray((length <= DEGENERATE_LEG) | off.all(axis=1))


def _diverges(both: Halves, s: Floats, k: Ints) -> NDArray[np.bool_]:
    """Whether L' vanishes at each ``s`` with the two derivatives after it not parallel."""
    first, second, third, fourth = (both.derivative(s, k, order) for order in range(1, 5))
    # At an end: leg fraction × leg length < 1e-12·size. Inside a zero is known to _REAL.
    limit = np.where(s == 0.0, 4.0 * DEGENERATE_LEG, 100.0 * _REAL)
    still = np.abs(first) < limit
    bends = np.abs(second) > 1e-9
    twist = np.where(bends, (second.conj() * third).imag, (third.conj() * fourth).imag)
    return np.asarray(still & (np.abs(twist) > 1e-12))


def _meets_at_an_angle(both: Halves, s: Floats, k: Ints) -> bool:
    """Whether the true tangent at one of ``s``, all on the axis, is not square to the axis."""
    first, second = both.derivative(s, k, 1), both.derivative(s, k, 2)
    tangent = np.where(np.abs(first) > 4.0 * DEGENERATE_LEG, first, second)
    return bool((np.abs(tangent.imag) > _FLAT * np.abs(tangent)).any())
