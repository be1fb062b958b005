"""Runs of segments that meet only when some of them are reversed, as the paper prints rings."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise
from math import dist
from typing import TypeAlias

from sgb_core.curves.profile import GAP, JointRule, Profile
from sgb_core.values import dataclass

Point: TypeAlias = list[float]
# The start and the end of every segment.
Ends: TypeAlias = list[tuple[Point, Point]]


@dataclass(frozen=True, slots=True)
class Ordered:
    """A profile put head to tail, and the numbers of its segments that now run backwards.

    ``origin[k]`` is the number that segment k had before.
    """

    profile: Profile
    origin: tuple[int, ...]
    backwards: frozenset[int]


def joined_head_to_tail(profile: Profile) -> Ordered | None:
    """Return the profile with whole runs of joined segments reversed so that they meet.

    Taken in the file's order: each run is reversed, or the chain before it, until its start
    meets the chain's end. A chain whose ends then meet becomes a ring; the joints that are
    closed get the rule G0. None where the profile is a ring, has no gap, or where some runs
    meet in no direction.
    """
    points = [(s.points[0].tolist(), s.points[3].tolist()) for s in profile.segments]
    size = profile.size
    apart = [
        joint
        for joint in profile.joints
        if not _meet(points[joint][1], points[(joint + 1) % len(points)][0], size)
    ]
    if profile.closed or not apart:
        return None
    cuts = [0, *(joint + 1 for joint in apart), len(profile)]
    runs = [list(range(a, b)) for a, b in pairwise(cuts)]
    # Segments of the chain so far, as (number, runs backwards).
    chain = [(number, False) for number in runs[0]]
    for run in runs[1:]:
        following = [(number, False) for number in run]
        for first, second in (
            (chain, following),
            (chain, _turned(following)),
            (_turned(chain), following),
            (_turned(chain), _turned(following)),
        ):
            if _meet(_end(points, first[-1]), _start(points, second[0]), size):
                chain = [*first, *second]
                break
        else:
            return None
    return _rebuilt(profile, chain, points, size)


def _rebuilt(
    profile: Profile, chain: Sequence[tuple[int, bool]], points: Ends, size: float
) -> Ordered:
    segments = []
    for number, backwards in chain:
        segment = profile.segments[number]
        segments.append(segment.reversed() if backwards else segment)
    rules = []
    for (before, backwards), (after, _) in pairwise(chain):
        # Inside a run the joint between two neighbours is the one it was.
        joint = after if backwards else before
        neighbours = abs(before - after) == 1 and joint == min(before, after)
        kept = profile.rules[joint] if neighbours else JointRule.FREE
        rules.append(JointRule.G0 if kept is JointRule.FREE else kept)
    closed = _meet(_end(points, chain[-1]), _start(points, chain[0]), size)
    if closed:
        rules.append(JointRule.G0)
    return Ordered(
        replace(profile, segments=tuple(segments), rules=tuple(rules), closed=closed),
        tuple(number for number, _ in chain),
        frozenset(k for k, (_, backwards) in enumerate(chain) if backwards),
    )


def _turned(chain: Sequence[tuple[int, bool]]) -> list[tuple[int, bool]]:
    return [(number, not backwards) for number, backwards in reversed(chain)]


def _start(points: Ends, part: tuple[int, bool]) -> Point:
    number, backwards = part
    return points[number][1 if backwards else 0]


def _end(points: Ends, part: tuple[int, bool]) -> Point:
    number, backwards = part
    return points[number][0 if backwards else 1]


def _meet(end: Point, start: Point, size: float) -> bool:
    return dist(end, start) <= GAP * size
