"""How thick a wall truly is in space, where the profile varies with the angle."""

from __future__ import annotations

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.surfaces.body import Body, WallSide
from sgb_core.surfaces.normals import tangents_at
from sgb_core.surfaces.quadrature import on_nodes
from sgb_core.surfaces.revolution import RevolutionSurface
from sgb_core.surfaces.variation import varying_quartics

# Meridians and places along each segment from which the search starts.
AROUND = 96
ALONG = 25


def least_distance(surface: RevolutionSurface, body: Body) -> float:
    """Return the least distance from points of the moved curve to the drawn surface, in space.

    Each meridian's wall follows the normal in its own half-plane, which is not the surface's where
    the profile changes with the angle: the wall is thinner than asked for by about the cosine of
    the angle between the two. The nearest point is found by Gauss-Newton steps in (s, θ).
    """
    size = surface.profile.size
    theta = surface.sweep * (np.arange(AROUND) + 0.5) / AROUND
    s = np.linspace(0.02, 0.98, ALONG)
    quartics, _ = varying_quartics(surface.profile, surface.laws, theta)
    drawn = on_nodes(quartics, s)
    tangents = tangents_at(quartics, s, size)
    rise = float(surface.profile.quartics[-1, 4, 1] - surface.profile.quartics[0, 0, 1])
    upward = rise if abs(rise) > 1e-9 * size and not surface.profile.closed else surface.mean_flux
    side = (1.0 if upward >= 0.0 else -1.0) * (1.0 if body.side is WallSide.INSIDE else -1.0)
    normals = np.stack([-tangents[..., 1], tangents[..., 0]], axis=-1)
    moved = drawn + side * body.wall * normals
    inside = moved[..., 0] * np.sign(drawn[..., 0]) > 0.0
    directions = surface.directions(surface.start + theta)[:, None, None]
    shift = np.asarray(surface.placement.translation)
    points = moved[..., :1] * directions[..., 0, :] + moved[..., 1:] * directions[..., 2, :] + shift
    angles = np.broadcast_to((surface.start + theta)[:, None, None], drawn.shape[:-1])
    best = body.wall
    for segment in range(drawn.shape[1]):
        kept = inside[:, segment]
        if kept.any():
            places = np.broadcast_to(s, kept.shape)[kept]
            found = _nearest(
                surface, segment, points[:, segment][kept], places, angles[:, segment][kept]
            )
            best = min(best, float(found.min()))
    return best


def _nearest(
    surface: RevolutionSurface, segment: int, points: Floats, s: Floats, theta: Floats
) -> Floats:
    """Return the distances of points (k, 3) to a segment's surface, from starts (s, θ)."""
    least = np.linalg.norm(points - surface.point(segment, s, theta), axis=1)
    end = surface.start + surface.sweep
    for _ in range(12):
        gap = points - surface.point(segment, s, theta)
        along, around = surface.partials(segment, s, theta)
        a, b, c = (along**2).sum(1), (along * around).sum(1), (around**2).sum(1)
        p, q = (along * gap).sum(1), (around * gap).sum(1)
        det = a * c - b * b
        still = det <= 1e-12 * a * c
        det = np.where(still, 1.0, det)
        s = np.clip(s + np.where(still, 0.0, (p * c - q * b) / det), 0.0, 1.0)
        theta = np.clip(theta + np.where(still, 0.0, (q * a - p * b) / det), surface.start, end)
        least = np.minimum(least, np.linalg.norm(points - surface.point(segment, s, theta), axis=1))
    return np.asarray(least)
