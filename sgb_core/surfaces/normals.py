"""Exact unit tangents and normals of sections, with one-sided limits where L' vanishes."""

from __future__ import annotations

import numpy as np

from sgb_core.arrays import Floats, Ints
from sgb_core.curves.nodes import on_nodes
from sgb_core.curves.segment import DEGENERATE_LEG

# Below this part of the size L' vanishes.
STILL = 4.0 * DEGENERATE_LEG


def end_tangents(quartics: Floats, size: float) -> tuple[Floats, Floats]:
    """Return the true unit tangents at s = 0 and s = 1 in the direction of travel.

    ``quartics`` has shape (..., 5, 2), the results (..., 2): the direction of the first quartic
    point that differs from the end by more than 1e-12 of ``size``; (0, 0) where none does.
    """
    return _first_step(quartics, size), -_first_step(quartics[..., ::-1, :], size)


def _first_step(quartics: Floats, size: float) -> Floats:
    steps = quartics[..., 1:, :] - quartics[..., :1, :]
    lengths = np.hypot(steps[..., 0], steps[..., 1])
    apart = lengths > DEGENERATE_LEG * size
    first = np.argmax(apart, axis=-1)[..., None]
    step = np.take_along_axis(steps, first[..., None], axis=-2)[..., 0, :]
    length = np.take_along_axis(lengths, first, axis=-1)
    found = np.any(apart, axis=-1, keepdims=True)
    return np.where(found, step / np.where(found, length, 1.0), 0.0)


def tangents_at(quartics: Floats, s: Floats, size: float) -> Floats:
    """Return the unit tangents of :func:`unit_tangents` where no derivative is at hand.

    The second one, which counts only where the first vanishes, is taken only there.
    """
    first = on_nodes(quartics, s, 1)
    speed = np.hypot(first[..., 0], first[..., 1])
    if (speed > STILL * size).all():
        return np.asarray(first / speed[..., None])
    return unit_tangents(quartics, s, first, on_nodes(quartics, s, 2), size)


def tangents_of_each(quartics: Floats, k: Ints, s: Floats, first: Floats, size: float) -> Floats:
    """Return the unit tangent of quartic ``k[i]`` of (n, 5, 2) at ``s[i]``, shape (m, 2).

    ``first`` are the derivatives there, (m, 2).
    """
    speed = np.hypot(first[:, 0], first[:, 1])
    still = speed <= STILL * size
    tangents = np.asarray(first / np.where(still, 1.0, speed)[:, None])
    for at in np.flatnonzero(still).tolist():
        tangents[at] = tangents_at(quartics[k[at]], s[at : at + 1], size)[0]
    return tangents


def unit_tangents(
    quartics: Floats, s: Floats, first: Floats, second: Floats, size: float
) -> Floats:
    """Return unit tangents at increasing ``s``, shape (..., k, 2).

    ``first`` and ``second`` are L' and L'' there, shape (..., k, 2). Where L' vanishes at s = 0 or
    s = 1 the tangent is the one-sided limit; at a cusp inside it is that of the outgoing branch;
    where the segment is a single point it is (0, 1), so that its normal points away from the axis.
    """
    speed = np.hypot(first[..., 0], first[..., 1])
    still = speed <= STILL * size
    if not still.any():
        return np.asarray(first / speed[..., None])
    tangents = np.where(still[..., None], 0.0, first / np.where(still, 1.0, speed)[..., None])
    bend = np.hypot(second[..., 0], second[..., 1])
    cusp = still & (bend > DEGENERATE_LEG * size)
    tangents = np.where(cusp[..., None], second / np.where(cusp, bend, 1.0)[..., None], tangents)
    start, end = end_tangents(quartics, size)
    at_start, at_end = (still & (s == 0.0))[..., None], (still & (s == 1.0))[..., None]
    tangents = np.where(at_start, start[..., None, :], tangents)
    tangents = np.where(at_end, end[..., None, :], tangents)
    lost = ~tangents.any(axis=-1)
    tangents[lost] = (0.0, 1.0)
    return np.asarray(tangents)


def radius_signs(r: Floats, size: float) -> Floats:
    """Return ±1 for radii along the last axis: which side of the axis each sample lies on.

    A sample on the axis (|r| ≤ 1e-9·size) takes its next neighbour's side, the last one its
    predecessor's; +1 where the neighbours are on the axis as well.
    """
    signs = np.where(np.abs(r) <= 1e-9 * size, 0.0, np.sign(r))
    if signs.all():
        return np.asarray(signs)
    following = np.concatenate([signs[..., 1:], signs[..., -2:-1]], axis=-1)
    signs = np.where(signs == 0.0, following, signs)
    return np.where(signs == 0.0, 1.0, signs)


def surface_normals(
    tangents: Floats, slip: Floats, r: Floats, signs: Floats, size: float
) -> Floats:
    """Return unit normals along ∂S/∂θ × ∂S/∂s as components on e_ρ, e_θ, e_h, shape (..., 3).

    The normal is r (h_s e_ρ − r_s e_h) − (r_θ h_s − h_θ r_s) e_θ, here divided by |r| |L'|:
    ``tangents`` (..., 2) are L'/|L'|, ``slip`` is r_θ t_h − h_θ t_r, zero without laws and at the
    ends of segments, which do not move with θ. On the axis the meridian's own normal counts.
    """
    off_axis = np.abs(r) > 1e-9 * size
    lean = np.where(off_axis, slip / np.where(off_axis, np.abs(r), 1.0), 0.0)
    normals = np.stack([signs * tangents[..., 1], -lean, -signs * tangents[..., 0]], axis=-1)
    return np.asarray(normals / np.sqrt(1.0 + lean * lean)[..., None])
