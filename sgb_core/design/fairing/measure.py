"""The energy of whole chains."""

from __future__ import annotations

from math import pi

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.curves.profile import Profile
from sgb_core.design.fairing.energy import Energy, energies
from sgb_core.design.fairing.finite import NOTHING, are_finite, are_straight
from sgb_core.design.fairing.nodes import exact_nodes


def profile_energy(profile: Profile, energy: Energy, sweep: float = 2.0 * pi) -> float | None:
    """Return an energy of a profile, exact to rounding; None where it is infinite.

    ∫ κ² dl in 1/unit, ∫ (dκ/dl)² dl in 1/unit³, ∬ (κm² + κp²) dA a number, for ``sweep`` radians.
    """
    total = float(segment_energies(energy, _unit_quartics(profile)).sum())
    if not np.isfinite(total):
        return None
    turn = sweep if energy is Energy.SURFACE else 1.0
    return total * (profile.size or 1.0) ** energy.dimension * turn


def endless_segments(profile: Profile, energy: Energy) -> tuple[int, ...]:
    """Return which segments of a profile have an infinite energy."""
    infinite = ~np.isfinite(segment_energies(energy, _unit_quartics(profile)))
    return tuple(map(int, np.flatnonzero(infinite)))


def _unit_quartics(profile: Profile) -> Floats:
    # Heights count from the first point: far from the origin no digit is lost.
    moved = profile.quartics - (0.0, profile.segments[0].points[0, 1])
    return np.asarray(moved / (profile.size or 1.0))


def segment_energies(energy: Energy, quartics: Floats) -> Floats:
    """Return the energies (n,) of quartics (n, 5, 2) of a chain of size about 1, for one radian.

    Infinite where they are; segments along the axis sweep no surface.
    """
    result = np.zeros(len(quartics))
    result[~are_finite(energy, quartics)] = np.inf
    if energy is Energy.SURFACE:
        none = (np.abs(quartics[..., 0]) <= NOTHING).all(axis=1)
    else:
        none = are_straight(quartics)
    asked = np.flatnonzero(np.isfinite(result) & ~none)
    if len(asked):
        with np.errstate(all="ignore"):
            chosen = quartics[asked]
            result[asked] = energies(energy, chosen, exact_nodes(energy, chosen))
    return result
