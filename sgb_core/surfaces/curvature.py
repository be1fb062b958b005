"""Curvature of plane quartics and of the surfaces they sweep, with limits where L' vanishes."""

from __future__ import annotations

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.curves.segment import DEGENERATE_LEG


def cross(u: Floats, v: Floats) -> Floats:
    """Return the plane cross product of vectors of shape (..., 2)."""
    return np.asarray(u[..., 0] * v[..., 1] - u[..., 1] * v[..., 0])


def meridian_curvature(derivatives: tuple[Floats, ...], at_end: Floats, size: float) -> Floats:
    """Return (r'h'' − r''h')/|L'|³ from L', L'', L''', L'''' of shape (..., 2), or its limit.

    Where L' vanishes the limit is that of the outgoing branch (of the incoming one where
    ``at_end``): infinite with its sign at an ordinary degenerate end or cusp, finite where L''' is
    parallel to L'', 0 on a straight line.
    """
    d1, d2, d3, d4 = derivatives
    speed = np.hypot(d1[..., 0], d1[..., 1])
    still = speed <= 4.0 * DEGENERATE_LEG * size
    ordinary = cross(d1, d2) / np.where(still, 1.0, speed) ** 3
    if not still.any():
        return np.asarray(ordinary)
    noise = 1e-12 * size * size
    bend = np.hypot(d2[..., 0], d2[..., 1])
    bends = bend > DEGENERATE_LEG * size
    # L = L''s²/2 + L'''s³/6 + L''''s⁴/24: κ → ±∞ as cross(L'', L''')/s, else the next order.
    blow = np.where(bends, cross(d2, d3), cross(d3, d4))
    side = np.where(at_end, -1.0, 1.0)
    finite = side * np.where(bends, cross(d2, d4) / (3.0 * np.where(bends, bend, 1.0) ** 3), 0.0)
    limit = np.where(np.abs(blow) > noise, np.copysign(np.inf, blow), finite)
    return np.where(still, limit, ordinary)


def parallel_curvature(r: Floats, tangents: Floats, meridian: Floats, size: float) -> Floats:
    """Return h'/(r |L'|) from unit tangents (..., 2): the curvature across the meridian.

    At r = 0 it is the meridian's where the tangent is square to the axis, else infinite (the apex
    of a cone); on the axis itself, running along it, 0 would be meaningless and infinite is given.
    """
    on_axis = np.abs(r) <= 1e-12 * size
    flat = np.abs(tangents[..., 1]) <= 1e-9
    ordinary = tangents[..., 1] / np.where(on_axis, 1.0, r)
    limit = np.where(flat, meridian, np.copysign(np.inf, tangents[..., 1]))
    return np.where(on_axis, limit, ordinary)
