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
_MARGIN = 1e-2
_SIGN_WEIGHT = 30.0
_AREA_WEIGHT = 100.0


Run: TypeAlias = slice | NDArray[np.intp]


@dataclass(frozen=True, slots=True)
class Rows:
    """The derivatives at hand: of distances by quartic points, of those by the unknowns.

    ``distances`` has shape (N, 10), ``runs`` tells which of them are each segment's; ``points``
    (count, 10, unknowns) belongs to the quartic points, ``frames`` (count, 10, unknowns) to the
    frames.
    """

    distances: Floats
    runs: Sequence[Run]
    points: Floats
    frames: Floats


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
        slope = sum(
            self.shares[run] @ rows.distances[run] @ rows.points[k]
            for k, run in enumerate(rows.runs)
        )
        return value, weight * np.atleast_2d(slope)


@dataclass(frozen=True, slots=True)
class KeepsBend:
    """The curvature has the given signs at the watched places of each segment.

    ``signs`` has shape (count, places): 1 turns left, −1 right, 0 is free. Values are sagittas
    of an arc as long as the segment's ``reach`` (count,), in tolerances.
    """

    signs: Floats
    reach: Floats
    tolerance: float

    def __call__(self, chain: Chain, distances: Floats, rows: Rows | None) -> tuple[Floats, Floats]:
        """Return how far each watched place bends the wrong way, and the slopes of that."""
        control = chain.quartics
        first, second = _FIRST @ control, _SECOND @ control
        speed = np.hypot(first[..., 0], first[..., 1])
        cross = first[..., 0] * second[..., 1] - first[..., 1] * second[..., 0]
        scale = self.reach[:, None] ** 2 / (8.0 * self.tolerance) / np.maximum(speed, 1e-9) ** 3
        lacking = np.where(self.signs != 0.0, _MARGIN - self.signs * cross * scale, 0.0)
        wrong = lacking > 0.0
        values = _SIGN_WEIGHT * lacking[wrong]
        if rows is None:
            return values, _NO_SLOPES
        # c/|L'|³ with c = L'×L'': the slopes of c, and those of the speed.
        slower = 3.0 * cross / np.maximum(speed, 1e-9) ** 2
        turned1 = np.stack([second[..., 1], -second[..., 0]], axis=-1)
        turned1 -= slower[..., None] * first
        turned2 = np.stack([-first[..., 1], first[..., 0]], axis=-1)
        by_points = (
            _FIRST[None, :, :, None] * turned1[:, :, None, :]
            + _SECOND[None, :, :, None] * turned2[:, :, None, :]
        ).reshape(*cross.shape, 10)
        slope = (-_SIGN_WEIGHT * self.signs * scale)[..., None] * (by_points @ rows.points)
        return values, slope[wrong]


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
        slopes = [
            after[1] @ rows.frames[b]
            + after[2] @ rows.points[b]
            - before[1] @ rows.frames[a]
            - before[2] @ rows.points[a]
            for (a, b), (before, after) in zip(self.joints, ends, strict=True)
        ]
        return self.weight * values, self.weight * np.array(slopes)


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
