"""How few segments follow a run of points within the tolerance, and which."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.design.tracing.breaks import Cuts
from sgb_core.design.tracing.chain import (
    END,
    END_ANGLE,
    END_PULL,
    START,
    START_ANGLE,
    START_PULL,
    Chain,
    Layout,
    frames_of,
)
from sgb_core.design.tracing.conditions import Condition, KeepsVolume, KeepsWithin
from sgb_core.design.tracing.feet import Feet
from sgb_core.design.tracing.guide import Guide
from sgb_core.design.tracing.solver import Cloud, State, least_squares, measured
from sgb_core.design.tracing.start import hermite_start, quartic_start
from sgb_core.design.tracing.straying import fault
from sgb_core.values import dataclass

# Rounds of a first look, of a try, of the one that keeps the volume too, and of the last one.
_LOOK, _ROUNDS, _KEEPING, _LONG = 5, 12, 4, 40
# So many starts are followed to their end.
_FOLLOWED = 2
# What counts as beyond the tolerance, how much it costs against the squares of all points,
_BOUND, _FIRM = 0.97, 4.0
# rounds of a try under that bound, the fault that half of them may leave, and rounds in the end.
_PRESSING, _FAR, _PATIENT = 16, 1.3, 30
# A chain whose least squares leave more tolerances than this is not pressed.
_PRESSABLE = 2.0
_HOPELESS = 4.0
# How much the places where cuts may be crowd in bends, in the ways that are tried.
_CROWDING = (0.5, 0.8)
MOST = 200
# After so many counts tried the best chain so far is taken.
_TRIES = 24
# A chain is given up where so many strides leave this much of a hopeless fault.
_GIVEN_UP, _STUCK = 3, 0.8
# and where so many leave this much of what is beyond the tolerance: more segments are no nearer.
_PATIENCE, _SAME = 6, 0.8
# How many pairs of neighbours are looked at for the one to be joined.
_PAIRS = 10
# So many of them are tried, and joints exchanged where no more than this is amiss.
_JOINED, _NEARLY = 2, 1.1
# Newton's steps from the nearest sample to a foot.
_SETTLING = 3
# How many more segments are tried at once while the chain is hopeless, in parts of their number.
_STRIDES = 0.25


def fewest(cloud: Cloud, guide: Guide, *, closed: bool = False) -> State:
    """Return the best chain found of the fewest segments that keep within the tolerance.

    The chain is smooth throughout; an open one keeps the ends of the guide. Where not even as
    many segments as there is room for keep the tolerance, the best chain found is returned.
    """
    cuts = tuple(Cuts(guide, cloud.tolerance, crowding) for crowding in _CROWDING)
    return _Search(cloud, guide, closed, cuts).run()


@dataclass(slots=True)
class _Search:
    cloud: Cloud
    guide: Guide
    closed: bool
    _cuts: tuple[Cuts, ...]

    def run(self) -> State:
        least = 2 if self.closed else 1
        most = max(min(MOST, len(self.guide.knots) - 1), least)
        count = min(max(self._cuts[0].enough(self.cloud.tolerance), least), most)
        state = self._best(*self._fresh(count))
        tries = 0
        faults: list[float] = []
        beyond: list[float] = []
        while (missed := fault(state, self.cloud)) > 1.0 and count < most and tries < _TRIES:
            tries += 1
            faults.append(missed)
            before = faults[-1 - _GIVEN_UP] if len(faults) > _GIVEN_UP else np.inf
            if missed > max(_HOPELESS, _STUCK * before):
                # About twice the segments are hardly nearer: these points follow no path.
                break
            beyond.append(_beyond(state))
            if len(beyond) > _PATIENCE and beyond[-1] > _SAME * beyond[-1 - _PATIENCE]:
                break
            # Far from the aim it takes longer strides; one too long is taken back below.
            stride = max(1, round(_STRIDES * count)) if missed > _HOPELESS else 1
            wider = state
            for _ in range(min(stride, most - count)):
                wider = divided(wider, self.cloud)
            count = wider.chain.layout.count
            state = self._best(wider, *self._fresh(count))
        if fault(state, self.cloud) > 1.0 or tries:
            return self._settled(state)
        # What holds at once is tried with one fewer.
        while fault(state, self.cloud) <= 1.0 and count > least and tries < _TRIES:
            tries += 1
            count -= 1
            starts = [*self._joined(state, _JOINED), *self._fresh(count)]
            fewer = self._exchanged(self._best(*starts))
            if fault(fewer, self.cloud) > 1.0:
                break
            state = fewer
        return self._settled(state)

    def _settled(self, state: State) -> State:
        """Return the chain after least squares that go on for long: the tries end early."""
        volume = [KeepsVolume(self.cloud.shares)]
        found = least_squares(state, self.cloud, _LONG, volume)
        found = within(found, self.cloud, volume)
        return found if fault(found, self.cloud) <= max(1.0, fault(state, self.cloud)) else state

    def _exchanged(self, state: State) -> State:
        """Return a chain with a joint moved from where it does least to where most is amiss.

        Least squares lets joints slide, but not past each other.
        """
        missed = fault(state, self.cloud)
        if not 1.0 < missed <= _NEARLY:
            return state
        wider = least_squares(divided(state, self.cloud), self.cloud, _ROUNDS)
        other = self._best(*self._joined(wider, _JOINED))
        return other if fault(other, self.cloud) < missed else state

    def _best(self, *starts: State) -> State:
        """Return the best of what is found from some starts, or the first that will do.

        All are followed for a while, and the most promising ones to their end.
        """
        volume = [KeepsVolume(self.cloud.shares)]
        found = [least_squares(start, self.cloud, _LOOK, hopeless=_HOPELESS) for start in starts]
        found.sort(key=self._squares)
        best, least = found[0], np.inf
        for state in found[:_FOLLOWED]:
            state = least_squares(state, self.cloud, _ROUNDS, hopeless=_HOPELESS)
            if state.largest <= _PRESSABLE:
                state = least_squares(state, self.cloud, _KEEPING, volume)
                state = within(state, self.cloud, volume, _PRESSING, _FAR)
            missed = fault(state, self.cloud)
            if missed < least:
                best, least = state, missed
            if least <= 1.0:
                break
        return best

    def _squares(self, state: State) -> float:
        return float(self.cloud.weights @ state.distances**2)

    def _fresh(self, count: int) -> list[State]:
        found = []
        for cuts in self._cuts:
            places = cuts.places(count)
            for start in (quartic_start, hermite_start):
                chain, feet = start(self.guide, places, self.cloud.along)
                found.append(settled(self._closing(chain), self.cloud, feet))
        return found

    def _closing(self, chain: Chain) -> Chain:
        if not self.closed:
            return chain
        frames = chain.frames.copy()
        # The angle half way between the directions at both ends.
        turn = np.angle(np.exp(1j * (frames[-1, END_ANGLE] - frames[0, START_ANGLE])))
        frames[0, START_ANGLE] += turn / 2.0
        frames[-1, END_ANGLE] = frames[0, START_ANGLE]
        return Chain(Layout(len(frames), closed=True), frames)

    def _joined(self, state: State, most: int) -> list[State]:
        """Return the chain with two neighbours made one, in the ways that cost least."""
        frames, count = state.chain.frames, state.chain.layout.count
        tries = []
        # The shortest pairs first: only so many are worth a look.
        pairs = state.chain.reach[:-1] + state.chain.reach[1:]
        for node in (np.argsort(pairs)[:_PAIRS] + 1).tolist():
            before, after = node - 1, node
            joined = _joined_frame(frames[before], frames[after])
            others = np.concatenate([frames[:before], [joined], frames[after + 1 :]])
            chain = Chain(Layout(count - 1, closed=self.closed), others)
            place = state.feet.segment + state.feet.s
            lengths = state.chain.reach[[before, after]]
            share = lengths[0] / lengths.sum()
            marks = np.array([0.0, before, node, node + 1.0, count])
            to = np.array([0.0, before, before + share, before + 1.0, count - 1.0])
            place = np.interp(place, marks, to)
            tries.append(settled(chain, self.cloud, feet_at(place, count - 1)))
        tries.sort(key=lambda found: float(self.cloud.weights @ found.distances**2))
        return tries[:most]


def _beyond(state: State) -> float:
    """Return the sum of the squares of what distances are beyond the tolerance."""
    return float((np.maximum(np.abs(state.distances) - 1.0, 0.0) ** 2).sum())


def settled(chain: Chain, cloud: Cloud, feet: Feet) -> State:
    """Return a chain with feet of the points that were only guessed before."""
    state = measured(chain, cloud, feet, seek=True)
    for _ in range(_SETTLING):
        state = measured(chain, cloud, state.feet)
    return state


def feet_at(places: Floats, count: int) -> Feet:
    """Return the feet at places given as segment number plus s."""
    segment = np.clip(np.floor(places), 0, count - 1).astype(np.intp)
    return Feet(segment, np.clip(places - segment, 0.0, 1.0))


def divided(state: State, cloud: Cloud, segment: int | None = None) -> State:
    """Return the chain with one segment cut in two, by default about where it is worst."""
    worst = int(np.argmax(np.abs(state.distances)))
    s = 0.5
    if segment is None:
        segment, s = int(state.feet.segment[worst]), float(state.feet.s[worst])
        s = min(max(s, 0.3), 0.7)
    layout = state.chain.layout
    frames = np.insert(state.chain.frames, segment, 0.0, axis=0)
    frames[segment : segment + 2] = frames_of(_halves(state.chain.quartics[segment], s))
    wider = replace(
        layout,
        count=layout.count + 1,
        corners=frozenset(node + (node > segment) for node in layout.corners),
        straight=frozenset(k + (k > segment) for k in layout.straight),
    )
    # The halves run from the angle of one end to that of the other, whole turns included.
    whole = state.chain.frames[segment]
    frames[segment, START_ANGLE] = whole[START_ANGLE]
    turn = frames[segment, END_ANGLE] - whole[START_ANGLE]
    frames[segment, END_ANGLE] -= 2.0 * np.pi * np.round(turn / (2.0 * np.pi))
    frames[segment + 1, START_ANGLE] = frames[segment, END_ANGLE]
    frames[segment + 1, END_ANGLE] = whole[END_ANGLE]
    place = state.feet.segment + state.feet.s
    inside = state.feet.segment == segment
    part = state.feet.s[inside]
    split = np.where(part <= s, part / s, 1.0 + (part - s) / (1.0 - s))
    place = np.where(state.feet.segment > segment, place + 1.0, place)
    place[inside] = segment + split
    return settled(Chain(wider, frames), cloud, feet_at(place, wider.count))


def within(
    state: State,
    cloud: Cloud,
    conditions: Sequence[Condition] = (),
    rounds: int = _PATIENT,
    hopeless: float = np.inf,
) -> State:
    """Return the chain with its largest distance pressed down to the tolerance, where it can be.

    What distances are more than the tolerance costs so much that the squares hardly hold against
    it: least squares under a bound. Half of the rounds that leave more than ``hopeless`` are all.
    """
    if not 1.0 < state.largest <= _PRESSABLE:
        return state
    bound = KeepsWithin(_BOUND, _FIRM * float(np.sqrt(cloud.weights.sum())))
    found = least_squares(state, cloud, rounds, [*conditions, bound], hopeless=hopeless)
    return found if found.largest < state.largest else state


def _halves(quartic: Floats, s: float) -> Floats:
    row = quartic
    left, right = [row[0]], [row[-1]]
    while len(row) > 1:
        row = row[:-1] + s * np.diff(row, axis=0)
        left.append(row[0])
        right.append(row[-1])
    return np.array([left, right[::-1]])


def _joined_frame(first: Floats, second: Floats) -> Floats:
    """Return the frame of one segment with the outer ends and directions of two."""
    reach = [float(np.hypot(*(frame[END] - frame[START]))) for frame in (first, second)]
    total = sum(reach)
    points = np.empty((5, 2))
    points[0], points[4] = first[START], second[END]
    for end, sign, frame, pull, angle, part in (
        (0, 1.0, first, START_PULL, START_ANGLE, reach[0]),
        (4, -1.0, second, END_PULL, END_ANGLE, reach[1]),
    ):
        length = sign * float(frame[pull]) * total / max(part, 1e-9)
        direction = np.array([np.cos(frame[angle]), np.sin(frame[angle])])
        points[1 if end == 0 else 3] = points[end] + length * direction
    # The joined curve passes where the two met.
    points[2] = (16.0 * first[END] - points[0] - points[4] - 4.0 * (points[1] + points[3])) / 6.0
    whole: Floats = frames_of(points[None])[0]
    whole[[START_ANGLE, END_ANGLE]] = first[START_ANGLE], second[END_ANGLE]
    return whole
