"""The exact box around a swept surface: whatever sweep, start, laws, twist and placement."""

from __future__ import annotations

from math import ceil, floor, inf, pi, prod

import numpy as np

from sgb_core.arrays import Floats, Ints, distinct
from sgb_core.curves.basis import bernstein
from sgb_core.curves.roots import extremes_of_all
from sgb_core.surfaces.angular import angle_edges
from sgb_core.surfaces.laws.law import RADIUS
from sgb_core.surfaces.revolution import HasSurface, RevolutionSurface, surface_of
from sgb_core.surfaces.sections import Sections

# Where sections are compared before the one that reaches farthest is solved.
_PLACES = np.linspace(0.0, 1.0, 65)
# The search in angle and parameter: the best few samples, for the highest need not stand beside
# the highest peak, each with rounds of finer ones about it.
_PEAKS, _ROUNDS = 3, 24
_AROUND = np.linspace(-1.0, 1.0, 7)
# Near a peak the reach depends on the square of how far the angle is off it.
_TURNS = 8
_UNIT = np.eye(2)


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
    axes = surface.directions(np.array([0.0, pi / 2.0]))
    # Coordinate k is (waves[k, 0] cos θ + waves[k, 1] sin θ) r + along[k] h.
    waves, along = axes[:, 0].T, axes[0, 2]
    # A twist changes nothing of a full turn of one section.
    twisted = surface.twisting is not None and not (surface.is_full_turn and not surface.laws)
    varying = [
        number
        for number in range(len(surface.profile))
        if twisted or any(law.applies_to(number) for law in surface.laws)
    ]
    reach = [_varying_reach(surface, number, waves, along) for number in varying]
    plain = np.delete(surface.profile.quartics, varying, axis=0)
    if len(plain):
        reach.append(_reach(surface, plain, waves, along))
    low, high = np.array(reach)[..., 0].min(axis=0), np.array(reach)[..., 1].max(axis=0)
    shift = np.asarray(surface.placement.translation)
    return low + shift, high + shift


def _reach(surface: RevolutionSurface, quartics: Floats, waves: Floats, along: Floats) -> Floats:
    """Return the least and greatest of each coordinate on segments without laws, (3, 2)."""
    found = []
    for (cosine, sine), rise in zip(waves.tolist(), along.tolist(), strict=True):
        factors = _cosine_range(surface, cosine, sine)
        values = [extremes_of_all(quartics @ (factor, rise)) for factor in factors]
        found.append((min(v[0] for v in values), max(v[1] for v in values)))
    return np.array(found)


def section_reach(surface: RevolutionSurface) -> tuple[tuple[float, float], tuple[float, float]]:
    """Return ((r least, greatest), (h least, greatest)) over all sections."""
    numbers = range(len(surface.profile))
    varying = [k for k in numbers if any(law.applies_to(k) for law in surface.laws)]
    plain = np.delete(surface.profile.quartics, varying, axis=0)
    hulls = surface.profile.control_points[varying]
    if any(law.parameter == RADIUS for law in surface.laws):
        widest = prod(max(1.0, law.widest) for law in surface.laws if law.parameter == RADIUS)
        hulls = np.concatenate([hulls, hulls * (widest, 1.0)], axis=1)
    known: dict[int, Sections] = {}
    reach = []
    for axis in range(2):
        low, high = extremes_of_all(plain[..., axis]) if len(plain) else (inf, -inf)
        # No section leaves the hull of its control points: few segments can reach farthest.
        for k in np.argsort(hulls[..., axis].min(axis=1)).tolist():
            if hulls[k, :, axis].min() >= low:
                break
            low = min(low, _least_of(surface, varying[k], axis, 1.0, known))
        for k in np.argsort(-hulls[..., axis].max(axis=1)).tolist():
            if hulls[k, :, axis].max() <= high:
                break
            high = max(high, -_least_of(surface, varying[k], axis, -1.0, known))
        reach.append((low, high))
    return reach[0], reach[1]


def _least_of(
    surface: RevolutionSurface, number: int, axis: int, sign: float, known: dict[int, Sections]
) -> float:
    """Return the least r or h (``axis``), times ``sign``, of a segment over the angles of laws.

    ``known`` keeps the segments' sections.
    """
    if number not in known:
        angles = _probe(surface)
        known[number] = surface.sections(angles, numbers=[number])[:, 0]
    sections = known[number]
    samples = sign * sections.on(_PLACES)[..., axis]
    best, place = np.unravel_index(int(np.argmin(samples)), samples.shape)
    turn, run = float(_probe(surface)[best]), float(_PLACES[place])
    if sections.stretch is None or axis == 1:
        # Of many sections only the one that reaches farthest by its samples is solved exactly,
        # and the farthest about it.
        turn = _turned_farthest(surface, number, sign * _UNIT[axis], run, turn)
        found = surface.sections(np.array([turn]), numbers=[number])[:, 0].quartics
        both = np.concatenate([sections.quartics[[best]], found])
        return extremes_of_all(sign * both[..., axis])[0]
    # A stretched section is highest where the angle and the place together make it so.
    reach, least = (surface.sweep / 720.0, float(_PLACES[1])), float(samples[best, place])
    for _ in range(_ROUNDS):
        angles = np.clip(turn + reach[0] * _AROUND, 0.0, surface.sweep)
        places = np.clip(run + reach[1] * _AROUND, 0.0, 1.0)
        values = sign * surface.sections(angles, numbers=[number])[:, 0].on(places)[..., 0]
        k, m = np.unravel_index(int(np.argmin(values)), values.shape)
        turn, run, reach = float(angles[k]), float(places[m]), (reach[0] / 2.0, reach[1] / 2.0)
        least = min(least, float(values.min()))
    return least


def _turned_farthest(
    surface: RevolutionSurface, number: int, way: Floats, run: float, turn: float
) -> float:
    """Return the angle about ``turn`` where ``way`` · (r, h) at the parameter ``run`` is least."""
    reach = surface.sweep / 720.0
    for _ in range(_TURNS):
        angles = np.clip(turn + reach * _AROUND, 0.0, surface.sweep)
        curves = surface.sections(angles, numbers=[number])[:, 0].quartics
        turn = float(angles[int(np.argmin(bernstein(4, run) @ curves @ way))])
        reach /= 3.0
    return turn


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
    even, edges = np.linspace(0.0, surface.sweep, 721), angle_edges(surface)
    return distinct(even, edges, angle_edges(surface, bare=True))


def _varying_reach(surface: RevolutionSurface, number: int, waves: Floats, along: Floats) -> Floats:
    """Return the least and greatest of each coordinate on a segment under laws, (3, 2)."""
    # Both ways along each axis: six directions whose greatest is wanted.
    waves, along = np.concatenate([-waves, waves]), np.concatenate([-along, along])
    fineness = 64 * (1 + ceil(abs(surface.twist.turns)))
    s, theta = np.linspace(0.0, 1.0, fineness + 1), _probe(surface)
    way = np.repeat(np.arange(6), _PEAKS)

    def values(k: Ints | slice, params: Floats, angles: Floats) -> Floats:
        """Return directions ``k`` at (..., a) angles and (..., b) parameters, (..., a, b)."""
        sections = surface.sections(angles, numbers=[number]).of_segment(0)
        r, h = np.moveaxis(sections.on(params[..., None, :]), -1, 0)
        turn = surface.turned(surface.start + angles[..., None], h)
        factor = waves[k, 0, None, None] * np.cos(turn) + waves[k, 1, None, None] * np.sin(turn)
        return np.asarray(factor * r + along[k, None, None] * h)

    grid = values(slice(None), s, theta)
    best = grid.max(axis=(1, 2))
    peaks = np.argpartition(grid.reshape(6, -1), -_PEAKS, axis=1)[:, -_PEAKS:].ravel()
    i, j = np.unravel_index(peaks, grid.shape[1:])
    turn, run = theta[i], s[j]
    reach = (surface.sweep / 720.0, 1.0 / fineness)
    each = np.arange(len(way))
    for _ in range(_ROUNDS):
        angles = np.clip(turn[:, None] + reach[0] * _AROUND, 0.0, surface.sweep)
        params = np.clip(run[:, None] + reach[1] * _AROUND, 0.0, 1.0)
        local = values(way, params, angles)
        a, b = np.unravel_index(local.reshape(len(way), -1).argmax(axis=1), local.shape[1:])
        turn, run, reach = angles[each, a], params[each, b], (reach[0] / 2.0, reach[1] / 2.0)
        np.maximum.at(best, way, local.max(axis=(1, 2)))
    return np.stack([-best[:3], best[3:]], axis=1)
