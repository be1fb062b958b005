"""The flux integral that volume and orientation share, and integrals by bisected panels."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.curves.nodes import gauss, on_nodes


def section_flux(quartics: Floats) -> Floats:
    """Return Σ ∫ r² h' ds over the segments of sections of shape (..., n, 5, 2), shape (...).

    The integrand has degree 11, for which 6 Gauss points are exact. Half of it, integrated over
    the angle, is the signed volume: positive where the surface's side (h', −r') is outward.
    """
    nodes, weights = gauss(6)
    r = on_nodes(quartics, nodes)[..., 0]
    dh = on_nodes(quartics, nodes, 1)[..., 1]
    flux: Floats = ((r * r * dh) @ weights).sum(axis=-1)
    return flux


# Even a dozen singular points leave some hundred panels open.
_MOST_OPEN = 4096
# So many panels open, and no nearer than half after so many halvings, show rounding.
_MANY_OPEN, _HALVINGS = 200, 3


def integrate(
    function: Callable[[Floats], Floats],
    edges: Floats,
    relative: float = 1e-13,
    least: float = 0.0,
) -> float:
    """Return ∫ function over [edges[0], edges[-1]] by bisected Gauss panels.

    ``function`` takes and returns a flat array. A panel is halved until its 12 points agree with
    those of its halves to ``relative`` of the whole or to ``least``, or it has been halved 50
    times, so that kinks and near-singular points (also unannounced ones) cost digits nowhere
    else. Where hundreds of panels are open and halving brings them no nearer, or thousands are,
    the function itself is known no better: rounding is all that is left.
    """
    nodes, weights = gauss(12)

    def panel_sums(low: Floats, high: Floats) -> Floats:
        width = high - low
        values = function((low[:, None] + width[:, None] * nodes).ravel())
        return np.asarray((values.reshape(len(low), -1) @ weights) * width)

    low, high = edges[:-1], edges[1:]
    coarse = panel_sums(low, high)
    scale = float(np.abs(coarse).sum())
    total, rest = 0.0, list[float]()
    for _ in range(50):
        middle = (low + high) / 2.0
        left, right = panel_sums(low, middle), panel_sums(middle, high)
        fine = left + right
        off = np.abs(fine - coarse)
        open_ = off > max(relative * max(scale, abs(total)), least)
        rest.append(float(off[open_].sum()))
        total += float(fine[~open_].sum())
        if not open_.any():
            return total
        stuck = len(rest) > _HALVINGS and rest[-1] > 0.5 * rest[-1 - _HALVINGS]
        if open_.sum() > (_MANY_OPEN if stuck else _MOST_OPEN):
            return total + float(fine[open_].sum())
        low, high = (
            np.concatenate([low[open_], middle[open_]]),
            np.concatenate([middle[open_], high[open_]]),
        )
        coarse = np.concatenate([left[open_], right[open_]])
        scale = float(np.abs(coarse).sum())
    return total + float(coarse.sum())


def speed(quartic: Floats, s: Floats) -> Floats:
    """Return |L'| of a quartic of shape (5, 2) at ``s``, shape (len(s),)."""
    velocity = on_nodes(quartic, s, 1)
    return np.asarray(np.hypot(velocity[:, 0], velocity[:, 1]))
