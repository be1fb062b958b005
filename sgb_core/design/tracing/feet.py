"""Where on a chain of quartics each of many ordered points is nearest."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from sgb_core.arrays import Floats
from sgb_core.values import dataclass

# Samples of a segment among which the nearest is sought, and how many segments to each side.
_SAMPLES = 12
_WINDOW = 1.0
_LONGEST_STEP = 0.2
# Below this part of |L'|² the squared distance is taken as not convex.
_CONVEX = 0.2
# Power coefficients of a quartic from its Bézier points: pₖ = C(4,k) Δᵏ Q₀.
_POWERS = np.array(
    [
        [1.0, 0.0, 0.0, 0.0, 0.0],
        [-4.0, 4.0, 0.0, 0.0, 0.0],
        [6.0, -12.0, 6.0, 0.0, 0.0],
        [-4.0, 12.0, -12.0, 4.0, 0.0],
        [1.0, -4.0, 6.0, -4.0, 1.0],
    ]
)


@dataclass(frozen=True, slots=True)
class Feet:
    """The foot of each point: on which segment, and at which s; both of shape (N,)."""

    segment: NDArray[np.intp]
    s: Floats


def weights(s: Floats) -> Floats:
    """Return the Bernstein polynomials of degree 4 by products alone, shape (*s.shape, 5)."""
    r = 1.0 - s
    s2, r2, sr = s * s, r * r, s * r
    found = np.empty((*s.shape, 5))
    np.multiply(r2, r2, out=found[..., 0])
    np.multiply(4.0 * sr, r2, out=found[..., 1])
    np.multiply(6.0 * sr, sr, out=found[..., 2])
    np.multiply(4.0 * sr, s2, out=found[..., 3])
    np.multiply(s2, s2, out=found[..., 4])
    return found


def followed(quartics: Floats, feet: Feet) -> tuple[Floats, Floats, Floats]:
    """Return the places at the feet and their first and second derivatives, each (2, N)."""
    powers = np.ascontiguousarray((_POWERS @ quartics).reshape(len(quartics), 10).T)
    p0, p1, p2, p3, p4 = powers.take(feet.segment, axis=1).reshape(5, 2, -1)
    s = feet.s
    # Horner's scheme of the quartic, its derivative and half of the second one at once.
    place, half = p4 * s, p4.copy()
    place += p3
    slope = half * s
    slope += place
    place *= s
    place += p2
    for power in (p1, p0):
        half *= s
        half += slope
        slope *= s
        slope += place
        place *= s
        place += power
    half *= 2.0
    return place, slope, half


def improved(
    quartics: Floats, points: Floats, feet: Feet, *, closed: bool, corners: frozenset[int]
) -> Feet:
    """Return the feet after one of Newton's steps; they cross smooth joints."""
    place, slope, bend = followed(quartics, feet)
    off = place - points.T
    full = slope[0] ** 2 + slope[1] ** 2
    under = full + off[0] * bend[0] + off[1] * bend[1]
    under = np.where(under > _CONVEX * full, under, full)
    value = off[0] * slope[0] + off[1] * slope[1]
    step = np.divide(value, under, out=np.zeros_like(value), where=under > 0.0)
    s = feet.s - np.clip(step, -_LONGEST_STEP, _LONGEST_STEP)
    beyond = np.flatnonzero((s > 1.0) | (s < 0.0))
    if not len(beyond):
        return Feet(feet.segment, s)
    count = len(quartics)
    smooth = np.ones(count + 1, dtype=bool)
    smooth[list(corners)] = False
    if closed:
        smooth[count] = smooth[0]
    else:
        smooth[[0, count]] = False
    ahead = s[beyond] > 1.0
    crossing = beyond[smooth[feet.segment[beyond] + ahead]]
    segment = feet.segment.copy()
    if len(crossing):
        ahead, own = s[crossing] > 1.0, segment[crossing]
        other = (own + np.where(ahead, 1, -1)) % count
        ends = np.hypot(*(quartics[:, [1, 4]] - quartics[:, [0, 3]]).transpose(2, 0, 1))
        # Equal lengths, not equal parameters, on both sides of the joint.
        leaving, entering = (
            np.where(ahead, ends[own, 1], ends[own, 0]),
            np.where(ahead, ends[other, 0], ends[other, 1]),
        )
        excess = np.where(ahead, s[crossing] - 1.0, -s[crossing])
        inside = np.minimum(excess * leaving / np.maximum(entering, 1e-12), 0.5)
        s[crossing] = np.where(ahead, inside, 1.0 - inside)
        segment[crossing] = other
    return Feet(segment, np.clip(s, 0.0, 1.0))


def sought(quartics: Floats, points: Floats, feet: Feet, *, closed: bool) -> Feet:
    """Return for each point the nearest of a few samples within a segment of its foot."""
    count = len(quartics)
    marks = (np.arange(_SAMPLES) + 0.5) / _SAMPLES
    chain = (weights(marks) @ quartics).reshape(-1, 2)
    here = np.round((feet.segment + feet.s) * _SAMPLES - 0.5).astype(np.intp)
    reach = int(_WINDOW * _SAMPLES)
    near = here[:, None] + np.arange(-reach, reach + 1)
    total = count * _SAMPLES
    near = near % total if closed else np.clip(near, 0, total - 1)
    # By coordinates: whole arrays side by side are much quicker.
    squares = chain[:, 0].take(near) - points[:, :1]
    squares *= squares
    across = chain[:, 1].take(near) - points[:, 1:]
    across *= across
    squares += across
    nearest = np.argmin(squares, axis=1)
    rows = np.arange(len(points))
    place = followed(quartics, feet)[0] - points.T
    keeps = place[0] ** 2 + place[1] ** 2 <= squares[rows, nearest]
    segment, number = np.divmod(near[rows, nearest], _SAMPLES)
    return Feet(np.where(keeps, feet.segment, segment), np.where(keeps, feet.s, marks[number]))
