"""Where a chain of segments crosses itself: boxes are halved, then Newton's method finishes."""

from __future__ import annotations

from math import hypot

import numpy as np

from sgb_core.arrays import Floats, Ints, Mask
from sgb_core.curves.coincidence import joint_touches, single_points
from sgb_core.curves.profile import Profile
from sgb_core.findings.profile import Crossing
from sgb_core.values import dataclass

# Each segment is cut into this many pieces (a power of two) before pairs are looked at.
_FIRST_CUTS = 2
# Pairs are halved this often at most; the pieces are then 1/2¹³ of a segment.
_DEEPEST = 11
# More pairs than this, or so many per segment, mean that stretches coincide; their pieces are
# no longer halved.
_MOST_PAIRS = 1500
_MOST_PAIRS_PER_SEGMENT = 20
# Newton's result counts when the two points are this close, as a part of the size.
_MEETS = 1e-10
# Crossings closer than this in both parameters are one; so near a joint they are the joint.
_SAME = 1e-6
# Coincident stretches would give any number of crossings; this many are reported.
_MOST_PER_PAIR = 16
# Nobody mends more than this at once; looking further would only cost time.
_MOST = 256

# Newton's method may end at s = t; a loop shorter than this would be invisible.
_SHORTEST_LOOP = 1e-4

# So many overlapping boxes fit in some tens of megabytes; more is a heap of equal segments.
_MOST_OVERLAPS = 200_000
# So many pairs of boxes are compared at once.
_AT_ONCE = 1 << 18


@dataclass(frozen=True, slots=True)
class _Pieces:
    """Pieces of segments: which segment, from where, how much of it, their quartic points."""

    segment: Ints
    low: Floats
    width: float
    points: Floats

    def take(self, index: Ints) -> _Pieces:
        return _Pieces(self.segment[index], self.low[index], self.width, self.points[index])

    def halves(self) -> _Pieces:
        """Return the first halves of all pieces, then the second halves."""
        row = self.points
        left, right = [row[:, 0]], [row[:, -1]]
        for _ in range(4):
            row = 0.5 * (row[:, :-1] + row[:, 1:])
            left.append(row[:, 0])
            right.append(row[:, -1])
        points = np.concatenate([np.stack(left, axis=1), np.stack(right[::-1], axis=1)])
        half = 0.5 * self.width
        low = np.concatenate([self.low, self.low + half])
        return _Pieces(np.concatenate([self.segment] * 2), low, half, points)


def self_intersections(profile: Profile) -> tuple[Crossing, ...]:
    """Return where the chain crosses or touches itself, in order; ends that meet do not count.

    Joints that are no neighbours and lie on one point touch; a segment that is a point crosses
    nothing.
    Every transversal crossing is found, up to the first 256; a touching one where rounding lets
    the curves meet within 1e-10 of the size. Of coincident stretches some points are returned:
    the time is bounded whatever the profile.

    >>> loop = sgb.Segment([(10, 0), (60, 60), (0, 60), (50, 0)])
    >>> [crossing] = sgb.self_intersections(sgb.Profile.of([loop]))
    >>> [round(coordinate, 3) for coordinate in crossing.point]
    [30.0, 32.727]
    """
    size = profile.size
    if size == 0.0:
        return ()
    quartics = profile.quartics
    count = len(quartics)
    whole = np.flatnonzero(~single_points(profile))
    pieces = _Pieces(whole, np.zeros(len(whole)), 1.0, quartics[whole])
    for _ in range(_FIRST_CUTS):
        pieces = pieces.halves()
    first, second = _overlapping(pieces.points)
    a, b = _possible(pieces.take(first), pieces.take(second), size)
    most = max(_MOST_PAIRS, _MOST_PAIRS_PER_SEGMENT * count)
    for _ in range(_DEEPEST):
        if not len(a.segment) or len(a.segment) > most:
            break
        a, b = _possible(*_quarters(a, b), size)
    found = _crossings(quartics, a, b, size)
    found += joint_touches(profile, _MOST - len(found))
    return tuple(sorted(found, key=lambda c: (c.segment_a, c.s_a, c.segment_b, c.s_b)))


def _overlapping(points: Floats) -> tuple[Ints, Ints]:
    """Return the pairs i < j of pieces whose boxes overlap, a bounded number of them.

    Sorted by where the boxes begin, each is compared only with those that begin before it ends.
    """
    low, high = points.min(axis=1), points.max(axis=1)
    # Sweep along the coordinate in which the boxes are spread more widely.
    axis = int(np.argmax(np.ptp(low, axis=0) / np.maximum((high - low).mean(axis=0), 1e-300)))
    order = np.argsort(low[:, axis], kind="stable")
    low, high = low[order], high[order]
    last = np.searchsorted(low[:, axis], high[:, axis], side="right")
    low, high = low[:, 1 - axis], high[:, 1 - axis]
    # How many begin before each ends; of as many at once as fill a block.
    begun = np.concatenate([[0], np.cumsum(last - np.arange(1, len(order) + 1))])
    first: list[Ints] = []
    second: list[Ints] = []
    total = start = 0
    while start < len(order) and total <= _MOST_OVERLAPS:
        stop = int(np.searchsorted(begun, begun[start] + _AT_ONCE, side="right")) - 1
        stop = max(stop, start + 1)
        i = np.repeat(np.arange(start, stop), np.diff(begun[start : stop + 1]))
        j = i + 1 + np.arange(begun[start], begun[stop]) - begun[i]
        meets = (low[j] <= high[i]) & (high[j] >= low[i])
        i, j = i[meets], j[meets]
        beyond = _MOST_OVERLAPS - total
        if len(i) > beyond:
            # Of the piece that goes beyond all are kept.
            kept = int(np.searchsorted(i, i[beyond], side="right"))
            i, j = i[:kept], j[:kept]
        first.append(i)
        second.append(j)
        total += len(i)
        start = stop
    i, j = order[np.concatenate(first)], order[np.concatenate(second)]
    return np.minimum(i, j), np.maximum(i, j)


def _quarters(a: _Pieces, b: _Pieces) -> tuple[_Pieces, _Pieces]:
    """Return each half of the one with each half of the other."""
    count = len(a.segment)
    index = np.arange(2 * count)
    crossed = np.concatenate([index, index])
    swapped = np.concatenate([index, (index + count) % (2 * count)])
    return a.halves().take(crossed), b.halves().take(swapped)


def _possible(a: _Pieces, b: _Pieces, size: float) -> tuple[_Pieces, _Pieces]:
    """Return the pairs that may cross: boxes overlap, and not only in a shared end."""
    apart = (a.points.min(axis=1) > b.points.max(axis=1)) | (
        b.points.min(axis=1) > a.points.max(axis=1)
    )
    kept = np.flatnonzero(~apart.any(axis=1))
    a, b = a.take(kept), b.take(kept)
    kept = np.flatnonzero(~_meet_in_ends_only(a.points, b.points, size))
    return a.take(kept), b.take(kept)


def _meet_in_ends_only(a: Floats, b: Floats, size: float) -> Mask:
    """Whether pairs of pieces share an end and a line through it separates them otherwise."""
    separated = np.zeros(len(a), dtype=bool)
    for i in (0, 4):
        for j in (0, 4):
            joint = a[:, i]
            shared = np.abs(joint - b[:, j]).max(axis=1) <= 1e-12 * size
            if not shared.any():
                continue
            arms_a = np.delete(a[shared], i, axis=1) - joint[shared, None]
            arms_b = np.delete(b[shared], j, axis=1) - joint[shared, None]
            normal = _mean_direction(arms_a) - _mean_direction(arms_b)
            above = np.einsum("nkc,nc->nk", arms_a, normal).min(axis=1)
            below = np.einsum("nkc,nc->nk", arms_b, normal).max(axis=1)
            separated[shared] |= (above >= 0.0) & (below <= 0.0) & (above > below)
    return separated


def _mean_direction(arms: Floats) -> Floats:
    lengths = np.hypot(arms[..., 0], arms[..., 1])[..., None]
    mean = np.divide(arms, lengths, out=np.zeros_like(arms), where=lengths > 0.0).sum(axis=1)
    length = np.hypot(mean[:, 0], mean[:, 1])[:, None]
    unit: Floats = np.divide(mean, length, out=np.zeros_like(mean), where=length > 0.0)
    return unit


def _crossings(quartics: Floats, a: _Pieces, b: _Pieces, size: float) -> list[Crossing]:
    """Finish each remaining pair with Newton's method and keep each crossing once."""
    found: dict[tuple[int, int], list[Crossing]] = {}
    straight = _are_straight(quartics, size)
    total = 0
    for k in range(len(a.segment)):
        if total == _MOST:
            break
        i, j = int(a.segment[k]), int(b.segment[k])
        s, t = float(a.low[k]) + 0.5 * a.width, float(b.low[k]) + 0.5 * b.width
        if (i, s) > (j, t):
            i, j, s, t = j, i, t, s
        known = found.setdefault((i, j), [])
        # Lines cross once; a line that runs back over itself, or over another, is one fault too.
        if len(known) >= (1 if straight[i] and straight[j] else _MOST_PER_PAIR):
            continue
        if any(max(abs(s - c.s_a), abs(t - c.s_b)) <= a.width for c in known):
            continue
        meeting = _newton(quartics[i].tolist(), quartics[j].tolist(), s, t, size)
        if meeting is None:
            continue
        s, t, point = meeting
        at_ends = min(s, 1.0 - s) < _SAME and min(t, 1.0 - t) < _SAME
        if at_ends or (i == j and abs(s - t) < _SHORTEST_LOOP):
            continue
        if i == j and s > t:
            s, t = t, s
        if all(max(abs(s - c.s_a), abs(t - c.s_b)) > _SAME for c in known):
            known.append(Crossing(i, s, j, t, point))
            total += 1
    return [crossing for known in found.values() for crossing in known]


def _are_straight(quartics: Floats, size: float) -> Mask:
    """Return which segments lie on a line."""
    arms = quartics[:, 1:] - quartics[:, :1]
    lengths = np.hypot(arms[..., 0], arms[..., 1])
    longest = np.take_along_axis(arms, lengths.argmax(axis=1)[:, None, None], axis=1)
    cross = arms[..., 0] * longest[..., 1] - arms[..., 1] * longest[..., 0]
    straight: Mask = (np.abs(cross) <= 1e-12 * size * lengths.max(axis=1)[:, None]).all(axis=1)
    return straight


def _newton(
    a: list[list[float]], b: list[list[float]], s: float, t: float, size: float
) -> tuple[float, float, tuple[float, float]] | None:
    """Return (s, t, point) with A(s) = B(t) near a first guess, or None."""
    for _ in range(20):
        (ax, ay), (ux, uy) = _at(a, s)
        (bx, by), (vx, vy) = _at(b, t)
        x, y = bx - ax, by - ay
        # Slightly damped normal equations: parallel tangents leave no unique solution.
        uu, uv, vv = ux * ux + uy * uy, ux * vx + uy * vy, vx * vx + vy * vy
        damping = 1e-14 * (uu + vv)
        determinant = (uu + damping) * (vv + damping) - uv * uv
        if determinant <= 0.0:
            break
        p, q = ux * x + uy * y, -(vx * x + vy * y)
        ds = (p * (vv + damping) + q * uv) / determinant
        dt = (q * (uu + damping) + p * uv) / determinant
        # Steps stay near the boxes that were found to overlap.
        ds, dt = min(max(ds, -0.05), 0.05), min(max(dt, -0.05), 0.05)
        s, t = min(max(s + ds, 0.0), 1.0), min(max(t + dt, 0.0), 1.0)
        if abs(ds) + abs(dt) < 1e-15:
            break
    (ax, ay), (bx, by) = _at(a, s)[0], _at(b, t)[0]
    if hypot(bx - ax, by - ay) > _MEETS * size:
        return None
    return s, t, (0.5 * (ax + bx), 0.5 * (ay + by))


def _at(q: list[list[float]], s: float) -> tuple[tuple[float, float], tuple[float, float]]:
    """Return a quartic's point and derivative."""
    r = 1.0 - s
    w = (r**3, 3.0 * r * r * s, 3.0 * r * s * s, s**3)
    low = [sum(w[k] * q[k][c] for k in range(4)) for c in (0, 1)]
    high = [sum(w[k] * q[k + 1][c] for k in range(4)) for c in (0, 1)]
    return (
        (r * low[0] + s * high[0], r * low[1] + s * high[1]),
        (4.0 * (high[0] - low[0]), 4.0 * (high[1] - low[1])),
    )
