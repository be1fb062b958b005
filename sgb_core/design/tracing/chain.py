"""A chain of SG-Bézier segments as one vector of unknowns: joints stay joined and smooth.

By the key fact a segment is a quartic Bézier curve Q0..Q4. Which quartics are segments? With unit
end tangents e0, e4 and the legs Q1 = Q0 + u0 e0 and Q3 = Q4 − u4 e4, the control points lie at
P1 = Q0 + x e0, x ≥ u0, and P2 = Q4 − y e4, y ≥ u4, and Q2 = b P1 + (1 − b) P2. Written with
p = b (x − u0) and q = (1 − b)(y − u4) that is

    Q2 = b Q1 + (1 − b) Q3 + p e0 − q e4,   0 ≤ b ≤ 1,   p, q ≥ 0.

So each segment is described by eleven numbers, its *frame*,

    (x0, y0, φ0, u0, b, p, q, u4, φ4, x4, y4),   e = (cos φ, sin φ),

with bounds on single numbers only. (b, p, q are one more than needed; every choice is the same
curve.) Neighbours share the numbers of their joint: its place, and its direction φ where it is
smooth. Every vector of unknowns is then a chain that is G1 wherever it is to be.
"""

from __future__ import annotations

from dataclasses import replace
from functools import cached_property, lru_cache

import numpy as np
from numpy.typing import NDArray

from sgb_core.arrays import Floats
from sgb_core.values import dataclass

FRAME = 11
START, START_ANGLE, START_PULL = slice(0, 2), 2, 3
SHARE, START_PUSH, END_PUSH = 4, 5, 6
END_PULL, END_ANGLE, END = 7, 8, slice(9, 11)
# Of the chord: a shorter leg would leave its joint without a say in the tangent.
_SHORTEST = 0.03
# b keeps this distance from 0 and 1, where a control point would go to infinity.
_MARGIN = 0.02
# A segment counts as this long at least, in units of the size.
_LEAST = 1e-6


@dataclass(frozen=True, slots=True)
class Layout:
    """What the unknowns of a chain of ``count`` segments are.

    ``corners`` are the nodes at which the two directions are independent; node k lies before
    segment k, and a closed chain has no node after its last segment. ``straight`` segments are
    lines. ``level`` tells which ends (first, last) keep their direction. The places of an open
    chain's ends are given, not unknown.
    """

    count: int
    closed: bool = False
    corners: frozenset[int] = frozenset()
    straight: frozenset[int] = frozenset()
    level: tuple[bool, bool] = (False, False)

    @property
    def nodes(self) -> int:
        """How many nodes there are, the ends of an open chain included."""
        return self.count if self.closed else self.count + 1

    def end_node(self, segment: int) -> int:
        """Return the node after a segment."""
        return (segment + 1) % self.nodes

    def numbering(self) -> NDArray[np.intp]:
        """Return which unknown each number of each frame is, shape (count, 11); −1: given."""
        return _numbering(self)


@dataclass(frozen=True)
class Chain:
    """A layout with the frames that fill it, shape (count, 11)."""

    layout: Layout
    frames: Floats

    @cached_property
    def quartics(self) -> Floats:
        """The quartic Bézier points, shape (count, 5, 2)."""
        return quartics(self.frames, self.layout.straight)

    def moved(self, step: Floats, numbering: NDArray[np.intp]) -> Chain:
        """Return the chain whose unknowns are changed by ``step``, kept within their bounds."""
        frames = self.frames + np.append(step, 0.0)[numbering]
        low, high = bounds(frames)
        return replace(self, frames=np.clip(frames, low, high))

    @cached_property
    def reach(self) -> Floats:
        """The distance between the ends of each segment, or the length of its legs if more."""
        legs = self.frames[:, START_PULL] + self.frames[:, END_PULL]
        chord = self.frames[:, END] - self.frames[:, START]
        reach: Floats = np.maximum(np.hypot(chord[:, 0], chord[:, 1]), legs)
        return np.maximum(reach, _LEAST)


@lru_cache(maxsize=64)
def _numbering(layout: Layout) -> NDArray[np.intp]:
    places = np.full((layout.count, FRAME), -1, dtype=np.intp)
    following = 0

    def take(many: int) -> NDArray[np.intp]:
        nonlocal following
        following += many
        return np.arange(following - many, following)

    for node in range(layout.nodes):
        after = node if node < layout.count else None
        before = node - 1 if node > 0 else (layout.count - 1 if layout.closed else None)
        if after is not None and before is not None:
            place = take(2)
            places[after, START], places[before, END] = place, place
            if node not in layout.corners:
                angle = take(1)[0]
                places[after, START_ANGLE] = places[before, END_ANGLE] = angle
                continue
        if after is not None and not (node == 0 and not layout.closed and layout.level[0]):
            places[after, START_ANGLE] = take(1)[0]
        if before is not None and not (node == layout.count and layout.level[1]):
            places[before, END_ANGLE] = take(1)[0]
    for segment in range(layout.count):
        if segment in layout.straight:
            places[segment, [START_ANGLE, END_ANGLE]] = -1
        else:
            places[segment, START_PULL : END_PULL + 1] = take(5)
    return places


def bounds(frames: Floats) -> tuple[Floats, Floats]:
    """Return the least and greatest values of the numbers of frames, each (count, 11)."""
    low, high = np.full(frames.shape, -np.inf), np.full(frames.shape, np.inf)
    chord = frames[:, END] - frames[:, START]
    least = _SHORTEST * np.hypot(chord[:, 0], chord[:, 1])
    low[:, START_PULL] = low[:, END_PULL] = least
    low[:, SHARE], high[:, SHARE] = _MARGIN, 1.0 - _MARGIN
    low[:, START_PUSH] = low[:, END_PUSH] = 0.0
    return low, high


def quartics(frames: Floats, straight: frozenset[int] = frozenset()) -> Floats:
    """Return the quartic Bézier points of frames, shape (count, 5, 2)."""
    points = np.empty((len(frames), 5, 2))
    start, end = frames[:, START], frames[:, END]
    forward, onward = _unit(frames[:, START_ANGLE]), _unit(frames[:, END_ANGLE])
    share = frames[:, SHARE, None]
    points[:, 0], points[:, 4] = start, end
    points[:, 1] = start + frames[:, START_PULL, None] * forward
    points[:, 3] = end - frames[:, END_PULL, None] * onward
    points[:, 2] = share * points[:, 1] + (1.0 - share) * points[:, 3]
    points[:, 2] += frames[:, START_PUSH, None] * forward - frames[:, END_PUSH, None] * onward
    for segment in straight:
        part = np.linspace(0.0, 1.0, 5)[:, None]
        points[segment] = start[segment] + part * (end[segment] - start[segment])
    return points


def slopes(frames: Floats, straight: frozenset[int] = frozenset()) -> Floats:
    """Return the derivatives of the quartic points by their frame, shape (count, 10, 11).

    The rows are Q0's r, Q0's h, Q1's r and so on.
    """
    matrix = np.zeros((len(frames), 5, 2, FRAME))
    forward, onward = _unit(frames[:, START_ANGLE]), _unit(frames[:, END_ANGLE])
    left, turned = _turned(forward), _turned(onward)
    u0, share, p, q, u4 = frames[:, START_PULL : END_PULL + 1].T[:, :, None]
    for k in range(2):
        matrix[:, 0, k, k] = matrix[:, 1, k, k] = 1.0
        matrix[:, 3, k, 9 + k] = matrix[:, 4, k, 9 + k] = 1.0
        matrix[:, 2, k, k] = share[:, 0]
        matrix[:, 2, k, 9 + k] = 1.0 - share[:, 0]
    matrix[:, 1, :, START_PULL], matrix[:, 1, :, START_ANGLE] = forward, u0 * left
    matrix[:, 3, :, END_PULL], matrix[:, 3, :, END_ANGLE] = -onward, -u4 * turned
    middle = matrix[:, 2]
    middle[:, :, START_PULL], middle[:, :, END_PULL] = share * forward, (share - 1.0) * onward
    middle[:, :, START_PUSH], middle[:, :, END_PUSH] = forward, -onward
    middle[:, :, START_ANGLE] = (share * u0 + p) * left
    middle[:, :, END_ANGLE] = -((1.0 - share) * u4 + q) * turned
    chord = frames[:, END] - frames[:, START]
    middle[:, :, SHARE] = u0 * forward + u4 * onward - chord
    for segment in straight:
        matrix[segment] = 0.0
        for point in range(5):
            for k in range(2):
                matrix[segment, point, k, k] = 1.0 - point / 4.0
                matrix[segment, point, k, 9 + k] = point / 4.0
    return matrix.reshape(len(frames), 10, FRAME)


def frames_of(points: Floats) -> Floats:
    """Return the frames of quartics, shape (count, 5, 2), whose legs do not vanish.

    Where a quartic is no segment, Q2 is moved to where it is one.
    """
    first, last = points[:, 1] - points[:, 0], points[:, 4] - points[:, 3]
    frames = np.zeros((len(points), FRAME))
    frames[:, START], frames[:, END] = points[:, 0], points[:, 4]
    for leg, pull, angle in ((first, START_PULL, START_ANGLE), (last, END_PULL, END_ANGLE)):
        frames[:, pull] = np.hypot(leg[:, 0], leg[:, 1])
        frames[:, angle] = np.arctan2(leg[:, 1], leg[:, 0])
    forward, onward = _unit(frames[:, START_ANGLE]), _unit(frames[:, END_ANGLE])
    shares = np.linspace(_MARGIN, 1.0 - _MARGIN, 37)
    for k in range(len(points)):
        # The middle one of those b for which p and q come out as they must.
        system = np.column_stack([forward[k], -onward[k]])
        base = shares[:, None] * points[k, 1] + (1.0 - shares)[:, None] * points[k, 3]
        pushes = np.linalg.lstsq(system, (points[k, 2] - base).T, rcond=1e-6)[0]
        pushes = np.maximum(pushes, 0.0)
        missed = np.hypot(*(base.T + system @ pushes - points[k, 2][:, None]))
        good = np.flatnonzero(missed <= missed.min() + 1e-12)
        chosen = int(good[len(good) // 2])
        frames[k, SHARE] = shares[chosen]
        frames[k, START_PUSH], frames[k, END_PUSH] = pushes[:, chosen]
    return frames


def _unit(angle: Floats) -> Floats:
    unit = np.empty((len(angle), 2))
    np.cos(angle, out=unit[:, 0])
    np.sin(angle, out=unit[:, 1])
    return unit


def _turned(directions: Floats) -> Floats:
    return np.stack([-directions[:, 1], directions[:, 0]], axis=-1)
