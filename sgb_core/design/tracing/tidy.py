"""What the points do not speak against: straight lines, level poles, no needless inflections.

Each simplification is a hypothesis: the chain is fitted again under it, and it is kept where the
points are still within the tolerance and no worse fitted than noise explains.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.curves.basis import bernstein
from sgb_core.design.tracing.chain import END_ANGLE, START_ANGLE, Chain
from sgb_core.design.tracing.conditions import WATCHED, Condition, KeepsBend, KeepsVolume
from sgb_core.design.tracing.search import divided, settled, within
from sgb_core.design.tracing.solver import Cloud, State, least_squares
from sgb_core.design.tracing.straying import fault
from sgb_core.values import dataclass

# A simpler chain may have this much more in the mean square, in parts and in tolerances².
_PART, _MORE = 0.1, 0.06**2
# A line is bound to its two ends, noisy as they are: twice as much again is noise.
_PART_OF_LINE = 2.0
# How much bending the wrong way costs against the squares of all points: first, and in the end.
_SOFT, _FIRM, _FIRM_ROUNDS = 3.0, 30.0, 6
# A chain that bends one way only may cost this much more,
_MORE_AT_WIGGLE = 0.25**2
# and one segment more where it bulges by more than this part of the tolerance the other way.
_TELLS = 0.12
# A right angle at a pole is what a round body has; it may cost this much.
_MORE_AT_POLE = 0.2**2
_ROUNDS = 10
# A pole may be level where its tangent is within so many radians of it.
_NEARLY_LEVEL = np.radians(20.0)
# A stretch that bulges by more tolerances bends for good. One that bulges by B adds about B²/10
# to its own points' mean square when it is bent the other way.
_BULGE, _ADDED = 2.0, 0.1
_TRIES = 8
# A hypothesis under which a point is so many tolerances away at first is not looked into.
_FAR_OFF = 4.0
# In a chain of more segments a hypothesis is taken as it stands, without fitting all again.
_LONG = 60
# Places of each segment at which the sign of its curvature is read,
_READ = np.linspace(0.0, 1.0, 33)
_READ_FIRST = bernstein(3, _READ) @ (4.0 * np.diff(np.eye(5), axis=0))
_READ_SECOND = bernstein(2, _READ) @ (12.0 * np.diff(np.eye(5), n=2, axis=0))
# and this much, in s, about a true inflection where no sign is asked for.
_LOOSE = 0.08


@dataclass(frozen=True, slots=True)
class Stretch:
    """A stretch of one sign of curvature: from ``start`` to ``end``, as segment number plus s.

    ``bulge`` is its largest distance from its chord.
    """

    start: float
    end: float
    sign: float
    bulge: float


def straightened(state: State, cloud: Cloud) -> State:
    """Return the chain with those segments straight that lie alone between corners or ends."""
    layout = state.chain.layout
    for segment in range(layout.count):
        nodes = {segment, layout.end_node(segment)}
        sharp = layout.corners if layout.closed else layout.corners | {0, layout.count}
        if not nodes <= sharp or any(
            layout.level[k] and n in nodes for k, n in ((0, 0), (1, layout.count))
        ):
            continue
        trial = replace(layout, straight=layout.straight | {segment})
        straight = Chain(trial, state.chain.frames)
        state = _under(state, cloud, straight, part=_PART_OF_LINE, own=segment)
        layout = state.chain.layout
    return state


def levelled(state: State, cloud: Cloud, poles: tuple[bool, bool]) -> State:
    """Return the chain with those poles at a right angle to the axis that nearly are."""
    for number, (segment, place) in enumerate(((0, START_ANGLE), (-1, END_ANGLE))):
        angle = float(state.chain.frames[segment, place])
        level = np.pi * np.round(angle / np.pi)
        straight = (segment % state.chain.layout.count) in state.chain.layout.straight
        if not poles[number] or straight or abs(angle - level) > _NEARLY_LEVEL:
            continue
        frames = state.chain.frames.copy()
        frames[segment, place] = level
        was = state.chain.layout.level
        layout = replace(
            state.chain.layout, level=(True, was[1]) if number == 0 else (was[0], True)
        )
        state = _under(state, cloud, Chain(layout, frames), more=_MORE_AT_POLE)
    return state


def without_wiggles(state: State, cloud: Cloud) -> tuple[State, KeepsBend]:
    """Return the chain without needless inflections, and the condition that keeps it so.

    Where a segment cannot do without one that tells, one more is tried, once.
    """
    state, needed = _ironed(state, cloud)
    told = [stretch for stretch in needed if stretch.bulge > _TELLS * cloud.tolerance]
    if told:
        middle = 0.5 * (told[0].start + told[0].end)
        more = divided(state, cloud, int(middle) % state.chain.layout.count)
        more, _ = _ironed(within(least_squares(more, cloud, _ROUNDS), cloud), cloud)
        fewer = _changes(stretches(more.chain)) < _changes(stretches(state.chain))
        if fewer and fault(more, cloud) <= 1.0:
            state = more
    runs = stretches(state.chain)
    return state, _kept_bend(runs, state.chain, cloud, _FIRM)


def _bulge(state: State, stretch: Stretch) -> float:
    """Return how far, in tolerances, a stretch may bulge so that it may be worth ironing out."""
    place = state.feet.segment + state.feet.s
    count = state.chain.layout.count
    inside = ((place >= stretch.start) & (place <= stretch.end)).mean()
    inside += (place <= stretch.end - count).mean()
    allowed = _PART * float((state.distances**2).mean()) + _MORE
    return min(_BULGE, float(np.sqrt(allowed / (_ADDED * max(inside, 1e-3)))))


def _ironed(state: State, cloud: Cloud) -> tuple[State, list[Stretch]]:
    """Return the chain without the small stretches it can do without, and those it cannot."""
    needed: list[Stretch] = []
    together = True
    for _ in range(_TRIES):
        runs = stretches(state.chain)
        small = [
            (stretch.bulge, run, number)
            for run, found in enumerate(runs)
            for number, stretch in enumerate(found)
            if len(found) > 1
            and stretch.bulge < _bulge(state, stretch) * cloud.tolerance
            and not any(_overlap(stretch, other) for other in needed)
        ]
        if not small:
            break
        # All at once, and where that is too much one after the other.
        chosen = sorted(small) if together else [min(small)]
        wanted = [list(found) for found in runs]
        for run in {run for _, run, _ in chosen}:
            wanted[run] = _without(wanted[run], {n for _, own, n in chosen if own == run})
        trial = _bent(state, cloud, wanted)
        if _changes(stretches(trial.chain)) < _changes(runs):
            state = trial
        elif len(chosen) > 1:
            together = False
        else:
            _, run, number = chosen[0]
            needed.append(runs[run][number])
    return state, needed


def _bent(state: State, cloud: Cloud, wanted: Sequence[Sequence[Stretch]]) -> State:
    """Return the chain bent as it is wanted where the points allow it, else the given one."""
    volume = KeepsVolume(cloud.shares)
    soft = _kept_bend(wanted, state.chain, cloud, _SOFT)
    trial = _under(state, cloud, state.chain, [soft, volume], more=_MORE_AT_WIGGLE)
    if trial is state:
        return state
    firm = _kept_bend(wanted, trial.chain, cloud, _FIRM)
    last = least_squares(trial, cloud, _FIRM_ROUNDS, [firm, volume])
    return last if fault(last, cloud) <= max(1.0, fault(trial, cloud)) else trial


def stretches(chain: Chain) -> list[list[Stretch]]:
    """Return the stretches of one sign of curvature of each smooth run between corners."""
    control, layout = chain.quartics, chain.layout
    first, second = _READ_FIRST @ control, _READ_SECOND @ control
    cross = first[..., 0] * second[..., 1] - first[..., 1] * second[..., 0]
    speed = np.hypot(first[..., 0], first[..., 1])
    sagitta = cross * chain.reach[:, None] ** 2 / np.maximum(speed, 1e-12) ** 3
    signs = np.where(np.abs(sagitta) > 1e-9, np.sign(sagitta), 0.0)
    places = bernstein(4, _READ) @ control
    runs: list[list[Stretch]] = []
    borders = sorted(layout.corners | ({0} if not layout.closed else set())) or [0]
    ends = [*borders[1:], layout.count + (borders[0] if layout.closed else 0)]
    for start, end in zip(borders, ends, strict=True):
        numbers = [k % layout.count for k in range(start, end)]
        if numbers and numbers[0] in layout.straight:
            runs.append([])
            continue
        run_signs = np.concatenate([signs[k] for k in numbers])
        run_places = np.concatenate([places[k] for k in numbers])
        marks = np.concatenate([start + j + _READ for j in range(len(numbers))])
        runs.append(_runs_of(run_signs, run_places, marks))
    return runs


def _runs_of(signs: Floats, places: Floats, marks: Floats) -> list[Stretch]:
    told = np.flatnonzero(signs)
    found: list[Stretch] = []
    if not len(told):
        return found
    breaks = np.flatnonzero(np.diff(signs[told]) != 0.0)
    firsts = [0, *(told[breaks + 1]).tolist()]
    lasts = [*(told[breaks + 1]).tolist(), len(signs) - 1]
    for first, last in zip(firsts, lasts, strict=True):
        part = places[first : last + 1]
        chord = part[-1] - part[0]
        length = float(np.hypot(*chord))
        off = part - part[0]
        across = np.abs(off[:, 0] * chord[1] - off[:, 1] * chord[0])
        bulge = float(across.max()) / length if length > 0.0 else 0.0
        inside = signs[first : last + 1]
        sign = float(inside[inside != 0.0][0])
        found.append(Stretch(float(marks[first]), float(marks[last]), sign, bulge))
    return found


def _without(run: list[Stretch], numbers: set[int]) -> list[Stretch]:
    """Return the run with some stretches given the sign of those before or after them."""
    kept: list[Stretch] = []
    for number, stretch in enumerate(run):
        if number not in numbers:
            start = kept[-1].end if kept else run[0].start
            if kept and kept[-1].sign == stretch.sign:
                start = kept.pop().start
            kept.append(replace(stretch, start=start))
        elif kept:
            kept[-1] = replace(kept[-1], end=stretch.end)
    # Where all bend little the largest of them says which way.
    return kept or [replace(max(run, key=_by_bulge), start=run[0].start, end=run[-1].end)]


def _by_bulge(stretch: Stretch) -> float:
    return stretch.bulge


def _kept_bend(
    runs: Sequence[Sequence[Stretch]], chain: Chain, cloud: Cloud, firm: float
) -> KeepsBend:
    weight = firm * float(np.sqrt(cloud.weights.sum()))
    return KeepsBend(_signs(runs, chain), chain.reach, cloud.tolerance, weight)


def _signs(runs: Sequence[Sequence[Stretch]], chain: Chain) -> Floats:
    """Return the wanted signs at the watched places, 0 about inflections, (count, places)."""
    count = chain.layout.count
    signs = np.zeros((count, len(WATCHED)))
    for run in runs:
        for number, stretch in enumerate(run):
            low = stretch.start + (_LOOSE if number > 0 else -1e-9)
            high = stretch.end - (_LOOSE if number < len(run) - 1 else -1e-9)
            for k in range(int(stretch.start), int(np.ceil(stretch.end))):
                inside = (k + WATCHED >= low) & (k + WATCHED <= high)
                signs[k % count, inside] = stretch.sign
    return signs


def _changes(runs: list[list[Stretch]]) -> int:
    return sum(max(len(run) - 1, 0) for run in runs)


def _overlap(first: Stretch, second: Stretch) -> bool:
    """Whether two stretches are the same one, found again on a chain that moved a little."""
    common = min(first.end, second.end) - max(first.start, second.start)
    return common > 0.5 * min(first.end - first.start, second.end - second.start)


def _under(
    state: State,
    cloud: Cloud,
    chain: Chain,
    conditions: Sequence[Condition] = (),
    part: float = _PART,
    more: float = _MORE,
    own: int | None = None,
) -> State:
    """Return a simpler chain fitted again where the points allow it, else the given one.

    Where it is simpler in its ``own`` segment alone, the points there are asked.
    """
    simpler = settled(chain, cloud, state.feet)
    if simpler.largest <= _FAR_OFF and chain.layout.count <= _LONG:
        simpler = least_squares(simpler, cloud, _ROUNDS, conditions)
        # Pressing the largest distance down only adds to the squares.
        if _costs_little(state, simpler, part, more, own):
            simpler = within(simpler, cloud, conditions)
    allowed = max(1.0, fault(state, cloud))
    if not _costs_little(state, simpler, part, more, own) or fault(simpler, cloud) > allowed:
        return state
    return simpler


def _costs_little(state: State, simpler: State, part: float, more: float, own: int | None) -> bool:
    inside = state.feet.segment == own
    asked = inside if inside.any() else slice(None)
    was, now = (float((found.distances[asked] ** 2).mean()) for found in (state, simpler))
    return now - was <= part * was + more
