"""How thick a wall truly is in space, where the profile varies with the angle."""

from __future__ import annotations

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.bodies.solid import Solid, WallSide
from sgb_core.interruption import checkpoint
from sgb_core.surfaces.angular import different_angles
from sgb_core.surfaces.revolution import RevolutionSurface

# Meridians and places along each segment from which the search starts.
AROUND = 96
ALONG = 25
STEPS = 12
# A search ends where a step moves it by less than this part of the size.
SETTLED = 1e-9


def least_distance(surface: RevolutionSurface, solid: Solid) -> float:
    """Return the least distance from points of the moved curve to the drawn surface, in space.

    Each meridian's wall follows the normal in its own half-plane, which is not the surface's where
    the profile changes with the angle: the wall is thinner than asked for by about the cosine of
    the angle between the two; a twist slants it once more. The nearest point is found by
    Gauss-Newton steps in (s, θ).
    """
    size = surface.profile.size
    even = surface.sweep * (np.arange(AROUND) + 0.5) / AROUND
    theta, low, high = different_angles(surface, even)
    if surface.twisting is not None:
        # Twisted waves are no mirror images of themselves.
        whole = surface.is_full_turn
        theta, low, high = even, *((-np.inf, np.inf) if whole else (0.0, surface.sweep))
    s = np.linspace(0.02, 0.98, ALONG)
    sections = surface.sections(theta)
    drawn, tangents = sections.on(s), sections.tangents_on(s, size)
    rise = float(surface.profile.quartics[-1, 4, 1] - surface.profile.quartics[0, 0, 1])
    upward = rise if abs(rise) > 1e-9 * size and not surface.profile.closed else surface.mean_flux
    side = (1.0 if upward >= 0.0 else -1.0) * (1.0 if solid.side is WallSide.INSIDE else -1.0)
    normals = np.stack([-tangents[..., 1], tangents[..., 0]], axis=-1)
    moved = drawn + side * solid.wall * normals
    inside = moved[..., 0] * np.sign(drawn[..., 0]) > 0.0
    angles = np.broadcast_to(theta[:, None], drawn.shape[:1] + s.shape)
    best = solid.wall
    for segment in range(drawn.shape[1]):
        kept = inside[:, segment]
        if kept.any():
            places = np.broadcast_to(s, kept.shape)[kept]
            found = _nearest(
                surface, segment, moved[:, segment][kept], places, angles[kept], (low, high)
            )
            best = min(best, float(found.min()))
    return best


def _nearest(
    surface: RevolutionSurface,
    segment: int,
    points: Floats,
    s: Floats,
    theta: Floats,
    bounds: tuple[float, float],
) -> Floats:
    """Return the distances of points (k, 2) at angles ``theta`` to a segment's surface.

    Angles count from the start; the surface is searched between the ``bounds``. Searches start
    from the point's own (s, θ); those that no longer move are done.
    """
    least = np.full(len(points), np.inf)
    open_ = np.arange(len(points))
    own, settled = theta, SETTLED * surface.profile.size
    for step in range(STEPS + 1):
        checkpoint()
        r, h = points[open_].T
        place, along, around = _jet(surface, segment, s, theta, bounds[1])
        # Towards the point, on e_ρ, e_θ and e_h of the place reached.
        turned = own[open_] - theta
        if surface.twisting is not None:
            twist = surface.twisting.angle
            turned = turned + twist(h) - twist(place[:, 2])
        gap = np.stack([r * np.cos(turned), r * np.sin(turned), h], axis=-1) - place
        least[open_] = np.minimum(least[open_], np.linalg.norm(gap, axis=-1))
        if step == STEPS:
            break
        a, b, c = (along**2).sum(1), (along * around).sum(1), (around**2).sum(1)
        p, q = (along * gap).sum(1), (around * gap).sum(1)
        det = a * c - b * b
        still = det <= 1e-12 * a * c
        det = np.where(still, 1.0, det)
        to_s = np.clip(s + np.where(still, 0.0, (p * c - q * b) / det), 0.0, 1.0)
        to_theta = theta + np.where(still, 0.0, (q * a - p * b) / det)
        to_theta = np.clip(to_theta, *bounds)
        moving = (to_s - s) ** 2 * a + (to_theta - theta) ** 2 * c > settled**2
        if not moving.any():
            break
        open_, s, theta = open_[moving], to_s[moving], to_theta[moving]
    return least


def _jet(
    surface: RevolutionSurface, segment: int, s: Floats, theta: Floats, end: float
) -> tuple[Floats, Floats, Floats]:
    """Return S, ∂S/∂s and ∂S/∂θ on e_ρ, e_θ, e_h of their own angle, (k, 3) each.

    At the angle ``end`` the derivative is that from before it: the paper's law may have a crease.
    """
    side = np.where(theta < end, 1, -1)
    curves = surface.sections(theta, side, numbers=(segment,))[:, 0]
    place, along, slip = curves.of_each(s), curves.of_each(s, 1), curves.changes_of_each(s)
    zero, r = np.zeros(len(s)), place[:, 0]
    pull = zero if surface.twisting is None else r * surface.twisting.rate(place[:, 1])
    return (
        np.stack([r, zero, place[:, 1]], axis=-1),
        np.stack([along[:, 0], pull * along[:, 1], along[:, 1]], axis=-1),
        np.stack([slip[:, 0], r + pull * slip[:, 1], slip[:, 1]], axis=-1),
    )
