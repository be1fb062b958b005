"""True corners among ordered points: turns of more than 30° at the scale of the tolerance."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.values import dataclass

CORNER_DEG = 30.0
# A side of a corner reaches over so many tolerances, and farther where noise hides its direction:
_REACH = 4.0
# until that is known to so many radians. It has so many points at least,
_SURE = 0.07
_POINTS = 4
# and reaches over this part of the length at most. Noise that is no longer than a side is told
# from a corner by sides so many times longer.
_LONGEST = 0.15
_WIDER = 2.5
_LARGER = 1.5
# How many standard deviations of the turn stay above 30°.
_SIGMAS = 2.0
# A first look asks for this part of the turn only.
_SUSPECT = 0.6
# A corner has to be so likely, against a smooth bend, in the logarithm of the odds.
_ODDS = 10.0
# Below this part of the tolerance a bend fits as well as a corner;
_FITS = 0.02
# this much nearer than the bend, in the root mean square, the corner needs no second look.
_EVIDENT = 0.05
# Two sides that miss the points by more are not known well enough to say where they meet.
_MISSES = 0.7
# How many points to each side of the suspected place the corner is tried.
_PLACES = 3
# The tip of a sharp corner lies so many times farther than the chord across it is long, at most.
_BEYOND = 4.0


@dataclass(frozen=True, slots=True)
class Corner:
    """A corner at a place, shape (2,), ``along`` the length of the guide, and how much it turns."""

    place: Floats
    along: float
    turn_deg: float


@dataclass(frozen=True, slots=True)
class _Bend:
    """How well a corner and a smooth bend follow ``count`` points, in mean squares."""

    corner: Corner
    sharp: float
    smooth: float
    count: float

    def is_likely(self, most: float = np.inf) -> bool:
        """Whether the corner turns enough and is much more likely than the bend.

        The corner has twelve unknowns; the points count as ``most`` at most.
        """
        freedom = max(2.0 * min(self.count, most) - 12.0, 2.0)
        likely = self.smooth > self.sharp * (1.0 + 2.0 * _ODDS / freedom)
        return likely and self.corner.turn_deg > CORNER_DEG


# The direction over so many parts of all points is that of the path, whatever its noise.
_WIDE = 40


def noise_of(points: Floats) -> float:
    """Return the standard deviation of the noise across ordered points, estimated robustly.

    From fourth differences, which take out what is smooth; only their part across the path.
    """
    return _across(points, 1)


def scatter_of(points: Floats) -> float:
    """Return that deviation across the direction that a path has over a twentieth of its points.

    Where points scatter by more than they are apart, from one to the next there is no direction.
    """
    return _across(points, max(1, len(points) // _WIDE))


def _across(points: Floats, reach: int) -> float:
    if len(points) < 7:
        return 0.0
    fourth = np.diff(points, n=4, axis=0) / np.sqrt(70.0)
    middle = np.arange(2, len(points) - 2)
    last = len(points) - 1
    along = points[np.minimum(middle + reach, last)] - points[np.maximum(middle - reach, 0)]
    length = np.hypot(along[:, 0], along[:, 1])
    length = np.where(length > 0.0, length, 1.0)
    across = (fourth[:, 0] * along[:, 1] - fourth[:, 1] * along[:, 0]) / length
    return 1.4826 * float(np.median(np.abs(across)))


def corners_of(
    points: Floats, along: Floats, tolerance: float, noise: float, *, closed: bool = False
) -> list[Corner]:
    """Return the corners of ordered points, shape (N, 2), at lengths ``along`` (N,), in order.

    At a corner two parabolas that meet at an angle follow the points on both sides much better
    than a smooth quartic does.
    """
    length = float(along[-1])
    if len(points) < 2 * _POINTS + 1 or length <= 0.0:
        return []
    if closed:
        # One turn more on either side, so that every corner has two sides.
        points = np.concatenate([points[:-1], points[:-1], points])
        along = np.concatenate([along[:-1] - length, along[:-1], along + length])
    look = _Look(points, along, np.gradient(along), tolerance, noise)
    corners: list[tuple[Corner, float]] = []
    for reach in _reaches(along, length, tolerance, noise):
        for suspect in _suspects(points, along, reach):
            if closed and not 0.0 <= suspect < length:
                continue
            corner = look.corner(suspect, reach)
            if corner is not None:
                corners.append((corner, reach))
    kept: list[Corner] = []
    # What a shorter side tells is told more exactly.
    for corner, reach in corners:
        apart = [abs(corner.along - other.along) for other in kept]
        if closed:
            apart = [min(gap, length - gap) for gap in apart]
        if all(gap > 0.75 * reach for gap in apart):
            kept.append(corner)
    return sorted(kept, key=lambda corner: corner.along)


def with_known(
    found: list[Corner], known: Sequence[int], points: Floats, along: Floats, tolerance: float
) -> list[Corner]:
    """Return the corners found and those known by their points' numbers, ends left out.

    A corner found within a side's reach of a known one is that one.
    """
    sure = [Corner(points[k], float(along[k]), 180.0) for k in known if 0 < k < len(points) - 1]
    reach = _REACH * tolerance
    others = [c for c in found if all(abs(c.along - other.along) > reach for other in sure)]
    return sorted([*sure, *others], key=lambda corner: corner.along)


def _reaches(along: Floats, length: float, tolerance: float, noise: float) -> list[float]:
    """Return how far the sides of corners are looked at, from the shortest reach on."""
    spacing = float(np.median(np.diff(along)))
    reach = max(_REACH * tolerance, (_POINTS + 0.5) * spacing)
    found = [min(reach, _LONGEST * length)]
    while found[-1] < _LONGEST * length and _doubt(noise, found[-1], found[-1] / spacing) > _SURE:
        found.append(min(found[-1] * _LARGER, _LONGEST * length))
    return found


def _doubt(noise: float, reach: float, count: float) -> float:
    """Return the standard deviation of a parabola's slope at its end, in radians.

    noise · √(192 / points) / reach where the points are evenly spread.
    """
    return float(noise * np.sqrt(192.0 / max(count, 1.0)) / reach)


def _suspects(points: Floats, along: Floats, reach: float) -> list[float]:
    """Return the lengths where the path turns most, by the mean directions on both sides."""
    # Means over equal lengths, not over the points, which may crowd in a bend.
    spread = np.gradient(along)
    sums = np.concatenate([np.zeros((1, 2)), np.cumsum(points * spread[:, None], axis=0)])
    shares = np.append(0.0, np.cumsum(spread))

    def mean(low: Floats, high: Floats) -> Floats:
        first = np.searchsorted(along, low, side="left")
        last = np.maximum(np.searchsorted(along, high, side="right"), first + 1)
        last = np.minimum(last, len(points))
        first = np.minimum(first, last - 1)
        share = np.maximum(shares[last] - shares[first], 1e-300)
        return np.asarray((sums[last] - sums[first]) / share[:, None])

    # Between the points too: a corner need not have a point of its own.
    places = np.unique(np.concatenate([along, 0.5 * (along[1:] + along[:-1])]))
    places = places[(places >= along[0] + 0.5 * reach) & (places <= along[-1] - 0.5 * reach)]
    if not len(places):
        return []
    half = 0.5 * reach
    before = mean(places - half, places) - mean(places - reach, places - half)
    after = mean(places + half, places + reach) - mean(places, places + half)
    cross = before[:, 0] * after[:, 1] - before[:, 1] * after[:, 0]
    turn = np.abs(np.arctan2(cross, (before * after).sum(axis=1)))
    found: list[float] = []
    for k in np.argsort(-turn, kind="stable"):
        if turn[k] < np.radians(_SUSPECT * CORNER_DEG):
            break
        if all(abs(float(places[k]) - other) > 0.75 * reach for other in found):
            found.append(float(places[k]))
    return found


@dataclass(frozen=True, slots=True)
class _Look:
    points: Floats
    along: Floats
    spread: Floats
    tolerance: float
    noise: float

    def corner(self, suspect: float, reach: float) -> Corner | None:
        """Return the corner about a place, or None where the path is smooth or too little known."""
        bend = self.bend(suspect, reach)
        if bend is None or not bend.is_likely():
            return None
        if bend.sharp <= _EVIDENT**2 * bend.smooth:
            return bend.corner
        doubt = np.degrees(_doubt(self.noise, reach, bend.count / 2.5))
        if bend.corner.turn_deg - _SIGMAS * doubt <= CORNER_DEG:
            return None
        # Noise of the side's own length makes corners too: a longer side sees through it.
        # Points closer than the tolerance may share their errors: they count by length.
        wide = self.bend(bend.corner.along, _WIDER * reach, here=True)
        most = 1.0 + 2.5 * _WIDER * reach / self.tolerance
        return bend.corner if wide is not None and wide.is_likely(most) else None

    def bend(self, suspect: float, reach: float, *, here: bool = False) -> _Bend | None:
        """Return the best corner about a place, or just ``here``; None where a bend fits."""
        low, place, high = np.searchsorted(
            self.along, [suspect - 1.25 * reach, suspect, suspect + 1.25 * reach]
        ).tolist()
        # One side may have fewer points to the length than the other.
        low, high = min(low, max(place - _POINTS - 1, 0)), max(high, place + _POINTS + 1)
        part, marks = self.points[low:high], self.along[low:high]
        if len(part) < 2 * _POINTS:
            return None
        share = self.spread[low:high]
        total = float(share.sum())
        heavy = np.sqrt(share / total)[:, None]
        smooth = _misfit(np.vander((marks - suspect) / reach, 5), part, heavy)[0]
        if smooth <= (_FITS * self.tolerance) ** 2:
            return None
        first = int(np.searchsorted(marks, suspect))
        splits = [first] if here else range(first - _PLACES, first + _PLACES + 1)
        best: tuple[float, int, Floats, Floats] | None = None
        for split in splits:
            if not _POINTS <= split <= len(part) - _POINTS:
                continue
            sides = []
            for side in (slice(None, split), slice(split, None)):
                rows = np.vander((marks[side] - suspect) / reach, 3)
                sides.append(_misfit(rows, part[side], heavy[side]))
            squares = sides[0][0] + sides[1][0]
            if best is None or squares < best[0]:
                best = (squares, split, sides[0][1], sides[1][1])
        if best is None or best[0] > (_MISSES * self.tolerance) ** 2:
            return None
        squares, split, before, after = best
        ends = (marks[[split - 1, split]] - suspect) / reach
        corner = _meeting(before, after, ends)
        place = suspect + reach * corner[1]
        return _Bend(Corner(corner[0], place, corner[2]), squares, smooth, float(len(part)))


def _meeting(before: Floats, after: Floats, ends: Floats) -> tuple[Floats, float, float]:
    """Return where two parabolas (3, 2) meet beyond their ends: place, mark, turn in degrees.

    By their tangents there.
    """
    (p, v), (q, w) = (
        (np.polyval(side, end), 2.0 * side[0] * end + side[1])
        for side, end in ((before, float(ends[0])), (after, float(ends[1])))
    )
    cross = float(v[0] * w[1] - v[1] * w[0])
    gap = float(ends[1] - ends[0])
    off = q - p
    turn = float(np.degrees(abs(np.arctan2(cross, float(v @ w)))))
    ahead = float(off[0] * w[1] - off[1] * w[0]) / cross if cross else -1.0
    if not -0.5 * gap <= ahead <= _BEYOND * gap:
        if float(v @ w) >= 0.0:
            return np.asarray((p + q) / 2.0), float(ends.mean()), turn
        # The tip of a path that comes straight back.
        tip, mark = (p, ends[0]) if float(off @ v) < 0.0 else (q, ends[1])
        return np.asarray(tip), float(mark), turn
    return p + ahead * v, float(ends[0]) + min(max(ahead, 0.0), gap), turn


def _misfit(rows: Floats, points: Floats, heavy: Floats) -> tuple[float, Floats]:
    """Return the weighted mean square that a linear model leaves, and its solution."""
    solution: Floats = np.asarray(np.linalg.lstsq(rows * heavy, points * heavy, rcond=None)[0])
    return float((((points - rows @ solution) * heavy) ** 2).sum()), solution
