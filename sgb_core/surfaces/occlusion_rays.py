"""How much of an even sky each point of a turned form sees: its ambient occlusion.

Turning makes this a question of the meridian alone. Straight edges stand for it, each of which
sweeps a frustum; rays leave a point through the half-space before it, denser where light falls
more squarely, and the share of them that meets no frustum is the point's. A ray that starts in
the middle of an edge, along that edge's normal, never meets its own frustum by rounding, however
coarse the edges are.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import lru_cache
from math import pi

import numpy as np
from numpy.typing import NDArray

from sgb_core.arrays import Floats
from sgb_core.values import dataclass

# How far a ray goes before it can be stopped, in sizes of the form.
_AHEAD = 1e-7
# So many numbers at a time stay in the processor's cache.
_CHUNK = 6_000
_GOLDEN = 0.6180339887498949


@dataclass(frozen=True, slots=True, eq=False)
class Edges:
    """Straight pieces of a meridian from ``starts`` to ``ends``, each (k, 2), as (r, h).

    Their outer side is to the right of the way along them. They are turned by ``sweep`` radians
    from the angle 0.
    """

    starts: Floats
    ends: Floats
    sweep: float = 2.0 * pi

    @property
    def middles(self) -> Floats:
        """The points halfway, shape (k, 2)."""
        return (self.starts + self.ends) / 2.0

    @property
    def normals(self) -> Floats:
        """The unit normals of the outer side, shape (k, 2); (0, 0) of an edge without length."""
        r, h = (self.ends - self.starts).T
        length = np.hypot(r, h)[:, None]
        across = np.stack([h, -r], axis=-1)
        return np.asarray(np.divide(across, length, out=across, where=length > 0.0))

    @property
    def size(self) -> float:
        """The larger of the form's diameter and its height."""
        points = np.concatenate([self.starts, self.ends])
        return float(max(2.0 * np.abs(points[:, 0]).max(), np.ptp(points[:, 1])))


@dataclass(frozen=True, slots=True, eq=False)
class Floor:
    """Level ground at ``height``, and how bright it is at ``distances`` from the axis, (k,)."""

    height: float
    distances: Floats
    brightness: Floats


@dataclass(frozen=True, slots=True, eq=False)
class _Rays:
    """Rays of points at (r, h), shape (k, 1), by their parts along r, aside and up, (k, rays)."""

    r: Floats
    h: Floats
    out: Floats
    aside: Floats
    up: Floats


def ambient_occlusion(
    edges: Edges,
    points: Floats,
    normals: Floats,
    rays: tuple[int, int],
    angles: Floats | None = None,
    floor: Floor | None = None,
) -> Floats:
    """Return the ambient occlusion of points, shape (k, angles).

    That is the share of an even sky's light that reaches them: 1 where nothing stands before it.
    ``points`` and unit ``normals``, shape (k, 2), lie in the half-planes (r ≥ 0) at ``angles``;
    None stands for one angle of a full turn, where all are alike. ``rays`` are how many leave
    around the normal, on one side of the meridian, and how many outward from it. What is seen of
    the ``floor`` counts by its brightness, without one as sky.
    """
    places = np.zeros(1) if angles is None else angles
    found = np.empty((len(points), len(places)))
    upright, along, aside = _hemisphere(*rays)
    step = max(1, _CHUNK // (len(upright) * len(edges.starts)))
    for first in range(0, len(points), step):
        part = slice(first, first + step)
        (r, h), (nr, nh) = points[part].T[..., None], normals[part].T[..., None]
        # The meridian's own direction is the normal, turned.
        out, up = upright * nr - along * nh, upright * nh + along * nr
        sent = _Rays(r, h, out, np.broadcast_to(aside, out.shape), up)
        light = 1.0 - _stopped(edges, sent, places)
        if floor is not None:
            light *= _seen_below(floor, sent)[..., None]
        found[part] = light.mean(axis=1)
    return found


@lru_cache(maxsize=8)
def _hemisphere(around: int, outward: int) -> tuple[Floats, Floats, Floats]:
    """Return rays on one side of the meridian: along the normal, along the meridian, aside."""
    ring = np.arange(outward)
    sine = np.sqrt((ring + 0.5) / outward)
    turn = pi * (np.arange(around)[:, None] + np.mod(ring * _GOLDEN, 1.0)) / around
    upright = np.broadcast_to(np.sqrt(1.0 - sine**2), turn.shape)
    return upright.ravel(), (sine * np.cos(turn)).ravel(), (sine * np.sin(turn)).ravel()


def _stopped(edges: Edges, sent: _Rays, angles: Floats) -> Floats:
    """Return which rays meet the form, shape (points, rays, angles); ½: to one side only."""
    shape = sent.out.shape
    if edges.sweep >= 2.0 * pi:
        met = np.zeros(shape, dtype=bool)
        for hit, _, _ in _meetings(edges, sent):
            met |= hit.any(axis=-1)
        return met[..., None].astype(np.float64)
    count = sent.out.size
    sides = np.zeros((2, count, len(angles)), dtype=bool)
    for hit, length, radius in _meetings(edges, sent):
        point, ray, edge = np.nonzero(hit)
        far = length[point, ray, edge]
        aside, out = far * sent.aside[point, ray], far * sent.out[point, ray]
        turned = np.arctan2(aside, sent.r[point, 0] + out)
        turned += np.where(radius[point, ray, edge] < 0.0, pi, 0.0)
        number = point * shape[1] + ray
        for side, sign in zip(sides, (1.0, -1.0), strict=True):
            for column, angle in enumerate(angles):
                there = np.mod(angle + sign * turned, 2.0 * pi) <= edges.sweep
                side[number[there], column] = True
    return np.asarray(sides.mean(axis=0).reshape(*shape, len(angles)))


def _meetings(edges: Edges, sent: _Rays) -> Iterator[tuple[NDArray[np.bool_], Floats, Floats]]:
    """Yield twice: whether rays meet frusta, after what way, and at what r of the edge.

    Each has the shape (points, rays, edges). A ray at the height of the edge's point u, which it
    reaches after t(u), meets the frustum there where its distance from the axis is that of the
    edge: a quadratic equation in u.
    """
    (r0, h0), (dr, dh) = edges.starts.T, (edges.ends - edges.starts).T
    r, out = sent.r[..., None], sent.out[..., None]
    up = sent.up[..., None]
    level = 1.0 - up * up
    least = _AHEAD * edges.size
    # What is level meets no height or all of them, and what it divides is no number: no hit.
    with np.errstate(all="ignore"):
        t0 = (h0 - sent.h[..., None]) / up
        dt = dh / up
        a = level * dt * dt - dr * dr
        b = (r * out + level * t0) * dt - r0 * dr
        c = (2.0 * r * out + level * t0) * t0 + (r * r - r0 * r0)
        root = np.sqrt(b * b - a * c)
        # Of the two ways to write a root the one that loses no digits.
        q = -(b + np.copysign(root, b))
        for u in (q / a, c / q):
            length = t0 + u * dt
            yield (u >= 0.0) & (u <= 1.0) & (length > least), length, r0 + u * dr


def _seen_below(floor: Floor, sent: _Rays) -> Floats:
    """Return how bright what each ray ends at is, if nothing stops it: 1 for the sky."""
    with np.errstate(all="ignore"):
        far = (floor.height - sent.h) / sent.up
        distance = np.hypot(sent.r + far * sent.out, far * sent.aside)
    seen = np.interp(distance, floor.distances, floor.brightness)
    return np.where((sent.up < 0.0) & (far >= 0.0), seen, 1.0)
