"""What a pen draws: anchors placed by clicks and drags, and the segments between them.

Frozen values without a window. An anchor without handles is a corner. A segment between two
corners is straight; one that is curved at one end only leaves the corner towards the other
handle, with a leg of its own, so that each of its shape parameters can move something.
"""

from __future__ import annotations

from dataclasses import replace
from math import hypot

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.curves.profile import JointRule
from sgb_core.curves.segment import READY, Segment
from sgb_core.values import dataclass

Pair = tuple[float, float]

# What is drawn is the plain cubic, and every slider is alive.
DRAWN = READY
# The handle that makes a quarter of a circle from a cubic, as a part of the radius:
# 4/3·(√2 − 1), for which the curve's middle lies on the circle.
QUARTER = 4.0 / 3.0 * (2.0**0.5 - 1.0)
# Two handles are one line where the sine of the angle between them is below this.
_STRAIGHT = 1e-9


@dataclass(frozen=True, slots=True)
class Anchor:
    """A place (r, h) that the pen goes through, and the handles by which it comes and leaves.

    ``incoming`` and ``outgoing`` are the control points beside it, None for no handle. On the
    axis an anchor without handles ends a curve as a round pole, unless it is ``sharp``.
    """

    place: Pair
    incoming: Pair | None = None
    outgoing: Pair | None = None
    sharp: bool = False

    @property
    def smooth(self) -> bool:
        """Whether the pen goes through without a kink: both handles lie on one line."""
        if self.incoming is None or self.outgoing is None:
            return False
        (r, h), (ir, ih), (our, oh) = self.place, self.incoming, self.outgoing
        back, on = (r - ir, h - ih), (our - r, oh - h)
        long = hypot(*back) * hypot(*on)
        cross, dot = back[0] * on[1] - back[1] * on[0], back[0] * on[0] + back[1] * on[1]
        return long > 0.0 and dot > 0.0 and abs(cross) <= _STRAIGHT * long

    @property
    def on_axis(self) -> bool:
        """Whether it lies on the axis, where the surface closes."""
        return self.place[0] == 0.0

    def pulled(self, to: Pair, *, alone: bool = False) -> Anchor:
        """Return it with its leaving handle drawn to a place, the other one mirrored.

        ``alone`` leaves the other one where it is. On the axis both are level and on one side, so
        that the surface closes roundly.
        """
        r, h = self.place
        if to == self.place:
            return self
        if self.on_axis and not alone:
            level = (abs(to[0]), h)
            return self if level == self.place else replace(self, incoming=level, outgoing=level)
        if alone:
            return replace(self, outgoing=to, sharp=True)
        return replace(self, incoming=(2.0 * r - to[0], 2.0 * h - to[1]), outgoing=to)

    def moved(self, to: Pair) -> Anchor:
        """Return it elsewhere, its handles carried."""
        dr, dh = to[0] - self.place[0], to[1] - self.place[1]

        def carried(handle: Pair | None) -> Pair | None:
            return None if handle is None else (handle[0] + dr, handle[1] + dh)

        return replace(
            self, place=to, incoming=carried(self.incoming), outgoing=carried(self.outgoing)
        )

    def broken(self) -> Anchor:
        """Return it without the leaving handle: a corner for what comes next."""
        return replace(self, outgoing=None, sharp=True)

    @classmethod
    def going_on(cls, segment: Segment, *, from_start: bool = False) -> Anchor:
        """Return the anchor at an end of a segment, from which the pen goes on smoothly."""
        drawn = segment.reversed() if from_start else segment
        end, before = drawn.points[3], drawn.points[2]
        way = drawn.end_tangent()
        leg = hypot(*(end - before)) or drawn.size / 3.0
        incoming, outgoing = end - leg * way, end + leg * way
        place = _pair(end)
        if not way.any():
            return cls(place)
        return cls(place, _pair(incoming), _pair(outgoing))


def between(start: Anchor, end: Anchor) -> Segment:
    """Return the segment from one anchor to the next, with λ = (1, 3, 1) and ω = 1.

    >>> straight = between(Anchor((10.0, 0.0)), Anchor((10.0, 30.0)))
    >>> straight.points.tolist()
    [[10.0, 0.0], [10.0, 10.0], [10.0, 20.0], [10.0, 30.0]]
    """
    p0, p3 = np.array(start.place), np.array(end.place)
    leaving, coming = start.outgoing, end.incoming
    if leaving is None and coming is not None:
        leaving = _towards(start, np.array(coming), p3)
    elif coming is None and leaving is not None:
        coming = _towards(end, np.array(leaving), p0)
    p1 = p0 + (p3 - p0) / 3.0 if leaving is None else _beside(start, leaving, end)
    p2 = p3 + (p0 - p3) / 3.0 if coming is None else _beside(end, coming, start)
    return Segment(np.stack([p0, p1, p2, p3]), DRAWN)


def _beside(anchor: Anchor, handle: Pair, other: Anchor) -> Floats:
    """Return an anchor's handle; that of a round pole on the side on which the other end lies."""
    if anchor.on_axis and not anchor.sharp and other.place[0] < 0.0:
        return np.array((-handle[0], handle[1]))
    return np.array(handle)


def _towards(anchor: Anchor, handle: Floats, other: Floats) -> Pair:
    """Return the handle of an anchor that has none, given the other end's handle and place."""
    place = np.array(anchor.place)
    if anchor.on_axis and not anchor.sharp and other[0] != 0.0:
        return float(QUARTER * other[0]), anchor.place[1]
    return _pair(place + (handle - place) / 3.0)


def rule_at(anchor: Anchor) -> JointRule:
    """Return the rule of the joint at an anchor: G1 where it is smooth, else G0."""
    return JointRule.G1 if anchor.smooth else JointRule.G0


@dataclass(frozen=True, slots=True)
class PenPath:
    """What one run of the pen has placed, in order; the first anchor may be of an older curve.

    >>> path = PenPath().placed((0.0, 0.0)).placed((30.0, 0.0)).pulled((40.0, 10.0))
    >>> path.last.incoming, path.segment.points[1].tolist()
    ((20.0, -10.0), [16.568542494923804, 0.0])
    """

    anchors: tuple[Anchor, ...] = ()

    @property
    def last(self) -> Anchor:
        """The anchor placed last. Raises IndexError where there is none."""
        return self.anchors[-1]

    @property
    def segment(self) -> Segment:
        """The segment that ends at the last anchor. Raises IndexError with less than two."""
        return between(self.anchors[-2], self.anchors[-1])

    @property
    def rule(self) -> JointRule:
        """The rule of the joint at which that segment begins."""
        return rule_at(self.anchors[-2])

    def placed(self, place: Pair, *, sharp: bool = False) -> PenPath:
        """Return the path with one more corner."""
        return PenPath((*self.anchors, Anchor(place, sharp=sharp)))

    def pulled(self, to: Pair, *, alone: bool = False) -> PenPath:
        """Return the path with the last anchor's handles drawn out: a smooth point."""
        return self.with_last(self.last.pulled(to, alone=alone))

    def with_last(self, anchor: Anchor) -> PenPath:
        """Return the path with another last anchor."""
        return PenPath((*self.anchors[:-1], anchor))

    def coming(self, place: Pair) -> Segment | None:
        """Return the segment that a click would add; None where it would be a point."""
        if not self.anchors or place == self.last.place:
            return None
        return between(self.last, Anchor(place))

    def onto(self, start: Anchor) -> PenPath:
        """Return the path led back onto an anchor, which keeps the handle it leaves by."""
        incoming = start.incoming if start.smooth else None
        return PenPath((*self.anchors, replace(start, incoming=incoming)))


def closing_handle(start: Anchor, to: Pair) -> Pair | None:
    """Return the handle by which a closing segment comes in, when the hand draws it to a place.

    It goes on smoothly into the curve that leaves there: along its line, as long as the hand is
    far; None where the hand is on the place itself.
    """
    r, h = start.place
    long = hypot(to[0] - r, to[1] - h)
    if long == 0.0:
        return None
    if start.outgoing is not None:
        dr, dh = start.outgoing[0] - r, start.outgoing[1] - h
        leg = hypot(dr, dh)
        if leg > 0.0:
            return r - dr / leg * long, h - dh / leg * long
    return 2.0 * r - to[0], 2.0 * h - to[1]


def _pair(values: Floats) -> Pair:
    return float(values[0]), float(values[1])
