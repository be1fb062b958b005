"""Whether an energy is finite at all.

Off the axis it is not where L' vanishes, unless the next derivatives are parallel there (and the
curvature stationary, for the variation). The surface's is not either where the profile meets the
axis at any angle but a right one.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from sgb_core.arrays import Floats
from sgb_core.design.fairing.energy import Energy
from sgb_core.design.fairing.nodes import AT_END, roots, speed_roots

Truths = NDArray[np.bool_]

# A root so near the real axis is a cusp on the curve.
_CUSP = 1e-9
# Relative to the segment's size: what counts as nothing.
NOTHING = 1e-12
# A tangent steeper than this where the profile meets the axis makes the apex of a cone.
_FLAT = 1e-9


def are_straight(points: Floats) -> Truths:
    """Return which of some polygons (B, k, 2) lie on one line, or are one point."""
    steps = points - points[:, :1]
    lengths = np.hypot(steps[..., 0], steps[..., 1])
    longest = np.take_along_axis(steps, lengths.argmax(axis=1)[:, None, None], axis=1)
    aside = np.abs(steps[..., 0] * longest[..., 1] - steps[..., 1] * longest[..., 0])
    return np.asarray((aside <= NOTHING * lengths.max(axis=1, keepdims=True) ** 2).all(axis=1))


def are_finite(energy: Energy, quartics: Floats) -> Truths:
    """Return which of some quartics (B, 5, 2) have a finite energy."""
    sizes = np.ptp(quartics, axis=1).max(axis=1)
    unit = quartics / np.where(sizes > 0.0, sizes, 1.0)[:, None, None]
    places = speed_roots(unit)
    smooth = ~(_inside(places).any(axis=1))
    for end in (unit, unit[:, ::-1]):
        smooth &= _rest_well(energy, end)
    finite = smooth | are_straight(unit)
    if energy is Energy.SURFACE:
        finite &= _meet_axis_well(unit)
    return np.asarray(finite)


def _inside(places: NDArray[np.complex128]) -> Truths:
    between = (places.real > AT_END) & (places.real < 1.0 - AT_END)
    return np.asarray(between & (np.abs(places.imag) < _CUSP))


def _rest_well(energy: Energy, quartics: Floats) -> Truths:
    """Return which energies stay finite at the first end of quartics of size 1.

    Where Q1 = Q0, L' = s M(s), M = m0 + m1 s + …: κ is finite where m0×m1 = 0, that is Q0, Q2
    and Q3 in line, and dκ/dl where also m1 = 0: Q3 − Q2 = 2 (Q2 − Q0).
    """
    steps = np.diff(quartics, axis=1)
    lengths = np.hypot(steps[..., 0], steps[..., 1])
    well = lengths[:, 0] > NOTHING
    if energy is Energy.SURFACE:
        # On the axis the weight r makes up for it.
        well |= np.abs(quartics[:, 0, 0]) <= NOTHING
    first, second = steps[:, 1], steps[:, 2]
    across = first[:, 0] * second[:, 1] - first[:, 1] * second[:, 0]
    rests = (lengths[:, 1] > NOTHING) & (np.abs(across) <= NOTHING)
    if energy is Energy.VARIATION:
        pull = second - 2.0 * first
        rests &= np.hypot(pull[:, 0], pull[:, 1]) <= NOTHING
    return np.asarray(well | rests)


def _meet_axis_well(quartics: Floats) -> Truths:
    r = quartics[..., 0]
    # Inside it crosses or touches; only a level tangent would do, and it would not stay so.
    well = ~_inside(roots(r.astype(np.complex128))).any(axis=1)
    for points in (quartics, quartics[:, ::-1]):
        steps = points[:, 1:] - points[:, :1]
        lengths = np.hypot(steps[..., 0], steps[..., 1])
        first = (lengths > NOTHING).argmax(axis=1)
        rows = np.arange(len(points))
        level = np.abs(steps[rows, first, 1]) <= _FLAT * lengths[rows, first]
        well &= level | (np.abs(points[:, 0, 0]) > NOTHING)
    return np.asarray(well | (np.abs(r) <= NOTHING).all(axis=1))
