"""What a fit searches over: a profile as one vector, its distances from a target, their slopes."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.curves.basis import bernstein, quartic_points
from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import Segment, ShapeParameters
from sgb_core.design.target_curves import TargetCurve

# Samples per segment.
_SEARCH_SAMPLES = 192
_DIFFERENCE = 1e-7


class Unknowns:
    """What a fit searches over, as one vector: leg fractions, then control points.

    A joint that is to stay smooth is given by its point, the leg before it and the ratio of
    the two legs, so that every vector is a chain that keeps its rules.
    """

    def __init__(
        self, profile: Profile, target: TargetCurve, polygon: bool, keep_ends: bool
    ) -> None:
        self._profile = profile
        self._target = target
        self._polygon = polygon
        self._count = len(profile)
        # Called at every step of a search, where it can be stopped.
        self.stepped: Callable[[], None] = lambda: None
        self._rows = bernstein(4, _search_samples())
        points = profile.control_points.copy()
        # One number for an outer leg that keeps its direction, two for a point that is free.
        self._directions = _end_directions(profile) if keep_ends else None
        self._outer = 1 if keep_ends else 2
        if polygon:
            points[0, 0], points[-1, 3] = _ends_in_order(profile, target)
        self._points = points
        self._smooth = [
            rule not in ("free", "G0") and k < self._count - 1
            for k, rule in enumerate(profile.rules)
        ]
        fractions = np.array([s.shape.leg_fractions for s in profile.segments]).ravel()
        self.start = np.concatenate([fractions, self._pack(points)]) if polygon else fractions
        extent = target.size
        self.bounds = [(0.0, 1.0)] * (3 * self._count)
        for value in self.start[3 * self._count :]:
            self.bounds.append((float(value) - 4.0 * extent, float(value) + 4.0 * extent))
        if polygon and keep_ends:
            for place in (3 * self._count, -1):
                self.bounds[place] = (1e-3 * extent, 4.0 * extent)
        for place in self._ratio_places():
            self.bounds[place] = (1e-3, 1e3)

    def scattered(self, rng: np.random.Generator) -> Floats:
        """Return another place to start from."""
        vector = self.start.copy()
        legs = 3 * self._count
        vector[:legs] = rng.uniform(0.1, 0.95, legs)
        vector[legs:] += rng.normal(0.0, 0.25 * self._target.size, len(vector) - legs)
        for place in self._ratio_places():
            vector[place] = rng.uniform(0.5, 2.0)
        return vector

    def distances(self, vector: Floats) -> Floats:
        """Return the signed distances of the samples, flat, in units of the target's size."""
        return self._target.signed_distance(self._samples(vector)).ravel() / self._target.size

    def largest(self, vector: Floats) -> float:
        """Return the largest distance, without its sign."""
        return float(np.abs(self.distances(vector)).max())

    def slopes(self, vector: Floats) -> Floats:
        """Return the derivatives of :meth:`distances`, shape (samples, unknowns).

        By differences, and by the chain rule: a target's distances cost far more than samples.
        """
        self.stepped()
        step = _DIFFERENCE * self._target.size
        samples = self._samples(vector)
        shifted = samples + step * np.eye(2)[:, None, None, :]
        distances = self._target.signed_distance(np.stack([samples, *shifted]))
        gradient = (distances[1:] - distances[0]).reshape(2, -1) / step
        columns = []
        for place in range(len(vector)):
            # Inwards from an upper bound, so that fractions stay in range.
            change = -_DIFFERENCE if vector[place] > 0.5 else _DIFFERENCE
            moved = vector.copy()
            moved[place] += change
            velocity = ((self._samples(moved) - samples) / change).reshape(-1, 2)
            columns.append(np.einsum("ij,ji->j", gradient, velocity))
        return np.stack(columns, axis=-1) / self._target.size

    def _samples(self, vector: Floats) -> Floats:
        fractions, points = self._unpack(vector)
        a, b, c = fractions.T
        samples: Floats = self._rows @ quartic_points(points, (a, b, c))
        return samples

    def profile(self, vector: Floats) -> Profile:
        """Return the profile that a vector describes."""
        fractions, points = self._unpack(np.clip(vector, *np.transpose(self.bounds)))
        return self._profile.with_segments(
            Segment(p, ShapeParameters.from_leg_fractions(*map(float, f)), segment.extra)
            for p, f, segment in zip(points, fractions, self._profile.segments, strict=True)
        )

    def _pack(self, points: Floats) -> Floats:
        parts = [self._pack_outer(points[0, 1] - points[0, 0], 0, points[0, 1])]
        for k in range(self._count - 1):
            joint, before, after = points[k, 3], points[k, 2], points[k + 1, 1]
            parts += [before, joint]
            if self._smooth[k]:
                length = float(np.hypot(*(joint - before))) or 1.0
                parts.append(np.array([float(np.hypot(*(after - joint))) / length or 1.0]))
            else:
                parts.append(after)
        parts.append(self._pack_outer(points[-1, 2] - points[-1, 3], 1, points[-1, 2]))
        return np.concatenate(parts)

    def _pack_outer(self, leg: Floats, end: int, point: Floats) -> Floats:
        if self._directions is None:
            return point
        return np.array([float(leg @ self._directions[end])])

    def _unpack_outer(self, joint: Floats, end: int, values: Floats) -> Floats:
        if self._directions is None:
            return values
        return np.asarray(joint + values[0] * self._directions[end])

    def _unpack(self, vector: Floats) -> tuple[Floats, Floats]:
        legs = 3 * self._count
        fractions = vector[:legs].reshape(self._count, 3)
        if not self._polygon:
            return fractions, self._points
        points, rest = self._points.copy(), vector[legs:]
        place = self._outer
        points[0, 1] = self._unpack_outer(points[0, 0], 0, rest[:place])
        for k in range(self._count - 1):
            before, joint = rest[place : place + 2], rest[place + 2 : place + 4]
            points[k, 2], points[k, 3], points[k + 1, 0] = before, joint, joint
            place += 4
            if self._smooth[k]:
                points[k + 1, 1] = joint + rest[place] * (joint - before)
                place += 1
            else:
                points[k + 1, 1] = rest[place : place + 2]
                place += 2
        points[-1, 2] = self._unpack_outer(points[-1, 3], 1, rest[place : place + self._outer])
        return fractions, points

    def _ratio_places(self) -> list[int]:
        if not self._polygon:
            return []
        places, place = [], 3 * self._count + self._outer
        for smooth in self._smooth[: self._count - 1]:
            place += 4
            if smooth:
                places.append(place)
            place += 1 if smooth else 2
        return places


def _ends_in_order(profile: Profile, target: TargetCurve) -> Floats:
    """Return the target's ends in the order in which the profile runs."""
    ends = target.ends
    first, last = profile.control_points[0, 0], profile.control_points[-1, 3]
    straight = np.hypot(*(first - ends[0])) + np.hypot(*(last - ends[1]))
    crossed = np.hypot(*(first - ends[1])) + np.hypot(*(last - ends[0]))
    return ends if straight <= crossed else ends[::-1]


def _end_directions(profile: Profile) -> tuple[Floats, Floats]:
    """Return unit vectors along the first leg and, backwards, along the last."""
    directions = []
    for chain in (profile.control_points[0], profile.control_points[-1, ::-1]):
        legs = chain[1:] - chain[0]
        lengths = np.hypot(*legs.T)
        # The first point that is not the end itself; a segment that is one point has none.
        number = int(np.argmax(lengths > 0.0))
        directions.append(legs[number] / (lengths[number] or 1.0))
    return directions[0], directions[1]


def _search_samples() -> Floats:
    """Return samples denser towards the ends, where an error curve turns fastest."""
    half = np.linspace(0.0, np.pi, _SEARCH_SAMPLES)
    return np.asarray((1.0 - np.cos(half)) / 2.0)
