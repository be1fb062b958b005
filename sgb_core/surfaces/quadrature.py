"""The flux integral that volume and orientation share, and integrals by bisected panels."""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeAlias

import numpy as np

from sgb_core.arrays import Floats, Ints
from sgb_core.curves.nodes import gauss, on_nodes
from sgb_core.surfaces.sections import Sections


def section_flux(sections: Sections) -> Floats:
    """Return Σ ∫ r² h' ds over the segments of sections of shape (..., n), shape (...).

    The integrand has degree 11, for which 6 Gauss points are exact; a strength along the height
    adds 24. Half of it, integrated over the angle, is the signed volume: positive where the
    surface's side (h', −r') is outward.
    """

    def flux(some: Sections, s: Floats) -> Floats:
        r = some.on(s)[..., 0]
        return np.asarray(r * r * on_nodes(some.quartics, s, 1)[..., 1])

    return np.asarray(sections.integrals(flux, 6, 12).sum(axis=-1))


# Panels (low, high, which): shape (m,) each, ``which`` of many integrals a panel is a part of.
Panels: TypeAlias = tuple[Floats, Floats, Ints]
# Even a dozen singular points leave some hundred panels open.
_MOST_OPEN = 4096
# So many panels open, and no nearer than half after so many halvings, show rounding.
_MANY_OPEN, _HALVINGS = 200, 3
_MOST_HALVINGS = 50
# Integrals at a time, which bounds the memory where all are hard.
_AT_ONCE = 256


def integrate(
    function: Callable[[Floats], Floats],
    edges: Floats,
    relative: float = 1e-13,
    least: float = 0.0,
) -> float:
    """Return ∫ function over [edges[0], edges[-1]] by bisected Gauss panels.

    ``function`` takes and returns a flat array; the rest as for :func:`integrate_each`.
    """
    panels = edges[:-1], edges[1:], np.zeros(len(edges) - 1, dtype=np.int64)
    return float(integrate_each(lambda s, _: function(s), panels, 1, relative, least)[0])


def integrate_each(
    function: Callable[[Floats, Ints], Floats],
    panels: Panels,
    count: int,
    relative: float = 1e-13,
    least: float | Floats = 0.0,
) -> Floats:
    """Return ``count`` integrals, each the sum over its own bisected Gauss panels, (count,).

    ``function`` takes flat arrays of places and of the integrals they belong to. A panel is halved
    until its 12 points agree with those of its halves to ``relative`` of its whole integral or to
    ``least``, or it has been halved 50 times, so that kinks and near-singular points (also
    unannounced ones) cost digits nowhere else. Where hundreds of panels of one integral are open
    and halving brings them no nearer, or thousands are, its function itself is known no better:
    rounding is all that is left.
    """
    low, high, which = panels
    limits = np.broadcast_to(np.asarray(least, dtype=np.float64), (count,))
    result = np.zeros(count)
    for first in range(0, count, _AT_ONCE):
        stop = min(first + _AT_ONCE, count)
        ours = (which >= first) & (which < stop)

        def some(s: Floats, k: Ints, first: int = first) -> Floats:
            return function(s, k + first)

        some_panels = low[ours], high[ours], which[ours] - first
        result[first:stop] = _bisected(some, some_panels, relative, limits[first:stop])
    return result


def _bisected(
    function: Callable[[Floats, Ints], Floats], panels: Panels, relative: float, least: Floats
) -> Floats:
    nodes, weights = gauss(12)
    count = len(least)

    def panel_sums(low: Floats, high: Floats, which: Ints) -> Floats:
        width = high - low
        places = (low[:, None] + width[:, None] * nodes).ravel()
        values = function(places, np.repeat(which, len(nodes)))
        return np.asarray((values.reshape(-1, len(nodes)) @ weights) * width)

    def by_integral(values: Floats, which: Ints) -> Floats:
        return np.bincount(which, values, count).astype(np.float64)

    low, high, which = panels
    coarse = panel_sums(low, high, which)
    scale = by_integral(np.abs(coarse), which)
    total, rest = np.zeros(count), list[Floats]()
    for _ in range(_MOST_HALVINGS):
        if not len(low):
            break
        middle = (low + high) / 2.0
        left, right = panel_sums(low, middle, which), panel_sums(middle, high, which)
        fine = left + right
        off = np.abs(fine - coarse)
        open_ = off > np.maximum(relative * np.maximum(scale, np.abs(total)), least)[which]
        rest.append(by_integral(np.where(open_, off, 0.0), which))
        stuck = len(rest) > _HALVINGS and rest[-1] > 0.5 * rest[-1 - _HALVINGS]
        hopeless = np.bincount(which[open_], minlength=count) > np.where(
            stuck, _MANY_OPEN, _MOST_OPEN
        )
        open_ &= ~hopeless[which]
        total += by_integral(np.where(open_, 0.0, fine), which)
        low, high = (
            np.concatenate([low[open_], middle[open_]]),
            np.concatenate([middle[open_], high[open_]]),
        )
        which = np.tile(which[open_], 2)
        coarse = np.concatenate([left[open_], right[open_]])
        scale = by_integral(np.abs(coarse), which)
    return total + by_integral(coarse, which)
