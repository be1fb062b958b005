"""What a traced chain is asked for besides being near its points, as rows of least squares."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Protocol, TypeAlias

import numpy as np
from numpy.typing import NDArray

from sgb_core.arrays import Floats
from sgb_core.curves.basis import bernstein
from sgb_core.design.tracing.chain import (
    END_ANGLE,
    END_PULL,
    START_ANGLE,
    START_PULL,
    Chain,
)
from sgb_core.values import dataclass

# Places of a segment at which the sign of its curvature is watched.
WATCHED = np.linspace(0.0, 1.0, 13)
_FIRST = bernstein(3, WATCHED) @ (4.0 * np.diff(np.eye(5), axis=0))
_SECOND = bernstein(2, WATCHED) @ (12.0 * np.diff(np.eye(5), n=2, axis=0))
# A sagitta of this part of the tolerance is kept, so that nothing bends back between the places.
_MARGIN = 0.02
_AREA_WEIGHT = 100.0


Run: TypeAlias = slice | NDArray[np.intp]


@dataclass(frozen=True, slots=True)
class Rows:
    """The derivatives at hand: of distances by quartic points, and of those by the frames.

    ``distances`` has shape (N, 10), ``runs`` tells which of them are each segment's; ``frames``
    (count, 10, 11) belongs to the quartic points. ``numbering`` (count, 11) says which unknown
    each number of a frame is, −1 what is given.
    """

    distances: Floats
    runs: Sequence[Run]
    frames: Floats
    numbering: NDArray[np.intp]

    def spread(self, segments: NDArray[np.intp], by_points: Floats) -> Floats:
        """Return slopes by the unknowns of R values, those by the points (R, 10) of segments."""
        return self.spread_frames(segments, (by_points[:, None] @ self.frames[segments])[:, 0])

    def spread_frames(self, segments: NDArray[np.intp], by_frames: Floats) -> Floats:
        """Return slopes by the unknowns, (R, unknowns), of those by segments' frames (R, 11)."""
        # The number −1 is the last column, which is left out.
        slopes = np.zeros((len(segments), int(self.numbering.max()) + 2))
        number = np.arange(len(segments))[:, None]
        np.add.at(slopes, (number, self.numbering[segments]), by_frames)
        return slopes[:, :-1]


class Condition(Protocol):
    """Rows that are to vanish."""

    def __call__(self, chain: Chain, distances: Floats, rows: Rows | None) -> tuple[Floats, Floats]:
        """Return values (R,) and, where ``rows`` is given, their slopes (R, unknowns)."""
        ...


_NO_SLOPES = np.zeros((0, 0))


@dataclass(frozen=True, slots=True)
class KeepsVolume:
    """The mean of the distances, each with its share of the swept area, vanishes.

    To first order the volume between points and curve is that mean times the swept area.
    ``shares`` has shape (N,).
    """

    shares: Floats

    def __call__(self, chain: Chain, distances: Floats, rows: Rows | None) -> tuple[Floats, Floats]:
        """Return the one value in tolerances, and its slopes."""
        weight = _AREA_WEIGHT * np.sqrt(len(distances))
        value = np.array([weight * float(self.shares @ distances)])
        if rows is None:
            return value, _NO_SLOPES
        by_points = np.array([self.shares[run] @ rows.distances[run] for run in rows.runs])
        slope = rows.spread(np.arange(len(by_points)), by_points).sum(axis=0)
        return value, weight * slope[None]


@dataclass(frozen=True, slots=True)
class KeepsBend:
    """The curvature has the given signs at the watched places of each segment.

    ``signs`` has shape (count, places): 1 turns left, −1 right, 0 is free. Values are sagittas
    of an arc as long as the segment's ``reach`` (count,), in tolerances, times ``weight``.
    """

    signs: Floats
    reach: Floats
    tolerance: float
    weight: float

    def __call__(self, chain: Chain, distances: Floats, rows: Rows | None) -> tuple[Floats, Floats]:
        """Return how far each watched place bends the wrong way, and the slopes of that."""
        control = chain.quartics
        first, second = _FIRST @ control, _SECOND @ control
        speed = np.hypot(first[..., 0], first[..., 1])
        cross = first[..., 0] * second[..., 1] - first[..., 1] * second[..., 0]
        scale = self.reach[:, None] ** 2 / (8.0 * self.tolerance) / np.maximum(speed, 1e-9) ** 3
        lacking = np.where(self.signs != 0.0, _MARGIN - self.signs * cross * scale, 0.0)
        wrong = lacking > 0.0
        values = self.weight * lacking[wrong]
        if rows is None:
            return values, _NO_SLOPES
        # c/|L'|³ with c = L'×L'': the slopes of c, and those of the speed.
        segment, place = np.nonzero(wrong)
        first, second, cross = first[wrong], second[wrong], cross[wrong]
        slower = 3.0 * cross / np.maximum(speed[wrong], 1e-9) ** 2
        turned1 = np.stack([second[:, 1], -second[:, 0]], axis=-1) - slower[:, None] * first
        turned2 = np.stack([-first[:, 1], first[:, 0]], axis=-1)
        by_points = (
            _FIRST[place][:, :, None] * turned1[:, None]
            + _SECOND[place][:, :, None] * turned2[:, None]
        ).reshape(len(place), 10)
        factors = -self.weight * self.signs[wrong] * scale[wrong]
        return values, rows.spread(segment, factors[:, None] * by_points)


@dataclass(frozen=True, slots=True)
class KeepsCurvature:
    """The curvatures of both segments agree at each of some joints: G2.

    ``joints`` are pairs (segment before, segment after). With unit tangents D the end curvatures
    of a quartic are ¾ D×(Q2 − Q0)/|Q1 − Q0|² and ¾ D×(Q2 − Q4)/|Q4 − Q3|².
    """

    joints: Sequence[tuple[int, int]]
    weight: float

    def __call__(self, chain: Chain, distances: Floats, rows: Rows | None) -> tuple[Floats, Floats]:
        """Return the jumps of the curvature times the size, and their slopes."""
        control = chain.quartics
        ends = [
            (_end(chain, control, a, False), _end(chain, control, b, True)) for a, b in self.joints
        ]
        values = np.array([after[0] - before[0] for before, after in ends])
        if rows is None:
            return self.weight * values, _NO_SLOPES
        slopes = np.zeros((len(values), int(rows.numbering.max()) + 1))
        for side, sign in ((0, -1.0), (1, 1.0)):
            segments = np.array([joint[side] for joint in self.joints])
            by_frames = np.array([found[side][1] for found in ends])
            by_points = np.array([found[side][2] for found in ends])
            slopes += sign * rows.spread_frames(segments, by_frames)
            slopes += sign * rows.spread(segments, by_points)
        return self.weight * values, self.weight * slopes


def _end(chain: Chain, control: Floats, segment: int, start: bool) -> tuple[float, Floats, Floats]:
    """Return the curvature at one end, and its derivatives by the frame's leg and the points."""
    frame = chain.frames[segment]
    pull, angle, end = (START_PULL, START_ANGLE, 0) if start else (END_PULL, END_ANGLE, 4)
    u, cosine, sine = float(frame[pull]), np.cos(frame[angle]), np.sin(frame[angle])
    x, y = (control[segment, 2] - control[segment, end]).tolist()
    scale = 0.75 / u**2
    value = scale * (cosine * y - sine * x)
    by_frame = np.zeros(len(frame))
    by_frame[pull], by_frame[angle] = -2.0 * value / u, scale * (-sine * y - cosine * x)
    by_points = np.zeros((5, 2))
    by_points[2] = scale * np.array([-sine, cosine])
    by_points[end] = -by_points[2]
    return float(value), by_frame, by_points.ravel()


@dataclass(frozen=True, slots=True)
class KeepsWithin:
    """No distance is more than ``limit`` tolerances: what there is more vanishes."""

    limit: float
    weight: float

    def __call__(self, chain: Chain, distances: Floats, rows: Rows | None) -> tuple[Floats, Floats]:
        """Return what the distances beyond the limit are more, and the slopes of that."""
        beyond = np.flatnonzero(np.abs(distances) > self.limit)
        values = self.weight * (np.abs(distances[beyond]) - self.limit)
        if rows is None:
            return values, _NO_SLOPES
        segments = np.zeros(len(distances), dtype=np.intp)
        for k, run in enumerate(rows.runs):
            segments[run] = k
        signed = (self.weight * np.sign(distances[beyond]))[:, None] * rows.distances[beyond]
        return values, rows.spread(segments[beyond], signed)
