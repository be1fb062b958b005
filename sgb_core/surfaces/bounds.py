"""The exact box around a swept surface, whatever its sweep, start angle, laws and placement."""

from __future__ import annotations

from math import ceil, floor, pi

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.curves.nodes import on_nodes
from sgb_core.curves.roots import extremes
from sgb_core.surfaces.angular import angle_edges
from sgb_core.surfaces.revolution import HasSurface, RevolutionSurface, surface_of
from sgb_core.surfaces.variation import varying_quartics


def bounds(surface: RevolutionSurface | HasSurface) -> tuple[Floats, Floats]:
    """Return the lower and upper corner (x, y, z) of the placed surface's box, each shape (3,).

    A coordinate is ρ(θ) r + η h. For a fixed section its greatest value is convex in ρ, so it is
    reached at an end of the range of ρ; there it is the extreme of one quartic. With laws both
    parameters are searched, to about 1e-12 of the size.

    >>> cylinder = sgb.Document(sgb.Profile.of([sgb.line((10, 0), (10, 60))]))
    >>> low, high = sgb.bounds(cylinder)
    >>> low.tolist(), high.tolist()
    ([-10.0, -10.0, 0.0], [10.0, 10.0, 60.0])
    """
    surface = surface_of(surface)
    low, high = np.empty(3), np.empty(3)
    axes = surface.directions(np.array([0.0, pi / 2.0]))
    for k in range(3):
        cosine, sine, along = axes[0, 0, k], axes[1, 0, k], axes[0, 2, k]
        if surface.laws:
            low[k] = -_varying_extreme(surface, -cosine, -sine, -along)
            high[k] = _varying_extreme(surface, cosine, sine, along)
            continue
        values = [
            extremes((quartic @ (factor, along)).tolist())
            for factor in _cosine_range(surface, cosine, sine)
            for quartic in surface.profile.quartics
        ]
        low[k], high[k] = min(v[0] for v in values), max(v[1] for v in values)
    shift = np.asarray(surface.placement.translation)
    return low + shift, high + shift


def section_reach(surface: RevolutionSurface) -> tuple[tuple[float, float], tuple[float, float]]:
    """Return ((r least, greatest), (h least, greatest)) over all sections."""
    if surface.laws:
        sections = varying_quartics(surface.profile, surface.laws, _probe(surface))[0]
    else:
        sections = surface.profile.quartics[None]
    reach = []
    for k in range(2):
        # Of many sections only the one that reaches farthest by its samples is solved exactly.
        samples = on_nodes(sections[..., k : k + 1], np.linspace(0.0, 1.0, 65))[..., 0]
        picked = {
            int(np.argmin(samples.min(axis=(1, 2)))),
            int(np.argmax(samples.max(axis=(1, 2)))),
        }
        values = [
            extremes(quartic[:, k].tolist()) for index in picked for quartic in sections[index]
        ]
        reach.append((min(v[0] for v in values), max(v[1] for v in values)))
    return reach[0], reach[1]


def _cosine_range(surface: RevolutionSurface, cosine: float, sine: float) -> tuple[float, float]:
    """Return the range of cosine·cos θ + sine·sin θ over the sweep."""
    start, end = surface.start, surface.start + surface.sweep
    angles = [start, end]
    peak = float(np.arctan2(sine, cosine))
    angles += [
        peak + pi * k for k in range(ceil((start - peak) / pi), floor((end - peak) / pi) + 1)
    ]
    values = cosine * np.cos(angles) + sine * np.sin(angles)
    if surface.is_full_turn:
        widest = float(np.hypot(cosine, sine))
        return -widest, widest
    return float(values.min()), float(values.max())


def _probe(surface: RevolutionSurface) -> Floats:
    return np.union1d(np.linspace(0.0, surface.sweep, 721), angle_edges(surface))


def _varying_extreme(surface: RevolutionSurface, cosine: float, sine: float, along: float) -> float:
    """Return the greatest ρ(θ) r(s, θ) + η h(s, θ): by a grid, then finer ones about its best."""

    def value(s: Floats, theta: Floats) -> Floats:
        quartics = varying_quartics(surface.profile, surface.laws, theta)[0]
        points = on_nodes(quartics, s)
        angle = surface.start + theta
        factor = cosine * np.cos(angle) + sine * np.sin(angle)
        return np.asarray(factor[:, None, None] * points[..., 0] + along * points[..., 1])

    s, theta = np.linspace(0.0, 1.0, 65), _probe(surface)
    grid = value(s, theta)
    best = float(grid.max())
    # The best few of every segment: the highest sample need not stand beside the highest peak.
    for segment in range(grid.shape[1]):
        part = grid[:, segment]
        for flat in np.argsort(part, axis=None)[-3:]:
            i, j = np.unravel_index(flat, part.shape)
            centre, reach = (theta[i], s[j]), (surface.sweep / 720.0, 1.0 / 64.0)
            for _ in range(24):
                around = np.linspace(-1.0, 1.0, 7)
                angles = np.clip(centre[0] + reach[0] * around, 0.0, surface.sweep)
                params = np.clip(centre[1] + reach[1] * around, 0.0, 1.0)
                local = value(params, angles)[:, segment]
                a, b = np.unravel_index(np.argmax(local), local.shape)
                centre, reach = (angles[a], params[b]), (reach[0] / 2.0, reach[1] / 2.0)
                best = max(best, float(local.max()))
    return best
