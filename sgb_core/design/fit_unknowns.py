"""What a fit searches over: a profile as one vector, its distances from a target, their slopes."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.curves.basis import bernstein
from sgb_core.curves.profile import JointRule, Profile
from sgb_core.curves.segment import Segment, ShapeParameters
from sgb_core.design.fit_mirror import Name, symmetric_vectors
from sgb_core.design.target_curves import TargetCurve

# Samples of all segments, and of a segment at least and at most.
_SAMPLES, _FEWEST, _MOST = 384, 48, 192
# Legs of a smooth joint, and those that keep their direction, are no shorter, in the target's size.
_SHORTEST, _LONGEST = 1e-3, 8.0
_FARTHEST = 4.0


class Unknowns:
    """What a fit searches over, as one vector: leg fractions, then control points.

    Lengths are in units of the target's size. A joint that is to stay smooth is given by its
    point, the angle of its tangent and the lengths of its two legs, so that every vector is a
    chain that keeps its rules. Where chain and rules are their own mirror image, as every target
    is, only symmetric polygons are searched.
    """

    def __init__(
        self,
        profile: Profile,
        target: TargetCurve,
        polygon: bool,
        keep_ends: bool,
        slide_poles: bool = False,
    ) -> None:
        self._profile, self._target = profile, target
        self._unit = target.size
        self._last: tuple[Floats, tuple[Floats, Floats, Floats]] | None = None
        count = len(profile)
        samples = min(max(_SAMPLES // count, _FEWEST), _MOST)
        # Denser towards the ends, where an error curve turns fastest.
        self._rows = bernstein(4, 0.5 - 0.5 * np.cos(np.linspace(0.0, np.pi, samples)))
        self._smooth = [rule not in (JointRule.FREE, JointRule.G0) for rule in profile.rules]
        self._directions = _end_directions(profile) if keep_ends and not profile.closed else None
        self._slides = slide_poles
        self._ends = None if profile.closed else _ends_in_order(profile, target)
        self._polygon = polygon
        self._fixed = profile.control_points / self._unit
        if polygon and self._ends is not None:
            self._fixed[0, 0], self._fixed[-1, 3] = self._ends / self._unit
        self.names = self._named()
        self.place = {name: k for k, name in enumerate(self.names)}
        own = self._pack(self._fixed, [s.shape.leg_fractions for s in profile.segments])
        along = self._pack(self._along_target(), [(0.75, 0.5, 0.75)] * count) if polygon else own
        self._base, self._spread = self._searched(along)
        places = np.abs(self._spread).argmax(axis=0)
        bounds = [self._bound(k, float(along[k])) for k in range(len(self.names))]
        self.bounds = [bounds[place] for place in places]
        self.start = self._spread_to(own)
        self.along = self._spread_to(along)

    def scattered(self, rng: np.random.Generator) -> Floats:
        """Return another place to start from."""
        vector = self.start + rng.normal(0.0, 0.25, len(self.start))
        for number, (low, high) in enumerate(self.bounds):
            if (low, high) == (0.0, 1.0):
                vector[number] = rng.uniform(0.1, 0.95)
        return np.asarray(np.clip(vector, *np.transpose(self.bounds)))

    def distances(self, vector: Floats) -> Floats:
        """Return the signed distances of the samples, flat, in units of the target's size."""
        return self._measured(vector)[0]

    def largest(self, vector: Floats) -> float:
        """Return the largest distance, without its sign."""
        return float(np.abs(self.distances(vector)).max())

    def squares(self, vector: Floats) -> float:
        """Return the sum of the squares of the distances."""
        return float((self.distances(vector) ** 2).sum())

    def slopes(self, vector: Floats) -> Floats:
        """Return the derivatives of :meth:`distances`, shape (samples, unknowns), in closed form.

        A distance changes by what its point moves along the normal at its foot.
        """
        _, normal, changes = self._measured(vector)
        moved = np.einsum("si,kicu->kscu", self._rows, changes)
        slopes: Floats = np.einsum("ksc,kscu->ksu", normal, moved).reshape(-1, len(vector))
        return slopes

    def _measured(self, vector: Floats) -> tuple[Floats, Floats, Floats]:
        """Return distances, normals and the quartic points' derivatives, kept for the next call."""
        last = self._last
        if last is None or not np.array_equal(last[0], vector):
            quartics, changes = self._quartics(vector)
            distances, normal = self._target.distance_and_normal(self._rows @ quartics * self._unit)
            last = vector.copy(), (distances.ravel() / self._unit, normal, changes)
            self._last = last
        return last[1]

    def profile(self, vector: Floats) -> Profile:
        """Return the profile that a vector describes."""
        full = self._base + self._spread @ np.clip(vector, *np.transpose(self.bounds))
        fractions, points, _ = self._unpack(full)
        points = points * self._unit
        if not self._polygon:
            points = self._profile.control_points
        elif self._ends is not None and not self._slides:
            points[0, 0], points[-1, 3] = self._ends
        return self._profile.with_segments(
            Segment(
                p, ShapeParameters.from_leg_fractions(*np.clip(f, 0.0, 1.0).tolist()), segment.extra
            )
            for p, f, segment in zip(points, fractions, self._profile.segments, strict=True)
        )

    # The vector.

    def _named(self) -> list[Name]:
        count = len(self._profile)
        names: list[Name] = [("fraction", k, leg) for k in range(count) for leg in range(3)]
        if not self._polygon:
            return names
        for joint in self._profile.joints:
            names += [("joint", joint, 0), ("joint", joint, 1)]
            if self._smooth[joint]:
                names += [("angle", joint, 0), ("before", joint, 0), ("after", joint, 0)]
            else:
                names += [(what, joint, c) for what in ("P2", "P1") for c in (0, 1)]
        if self._profile.closed:
            return names
        for end in (0, 1):
            if self._slides:
                names.append(("pole", end, 0))
            if self._directions is not None:
                names.append(("outer", end, 0))
            else:
                names += [("free", end, 0), ("free", end, 1)]
        return names

    def _bound(self, place: int, value: float) -> tuple[float, float]:
        what = self.names[place][0]
        if what == "fraction":
            return 0.0, 1.0
        if what in ("before", "after", "outer"):
            return _SHORTEST, _LONGEST
        return value - _FARTHEST, value + _FARTHEST

    def _pack(self, points: Floats, fractions: Sequence[Sequence[float]]) -> Floats:
        """Return the numbers of a chain, by their names."""
        values = [
            fractions[number][part]
            if what == "fraction"
            else self._read(points, what, number, part)
            for what, number, part in self.names
        ]
        return np.array(values, dtype=np.float64)

    def _read(self, points: Floats, what: str, number: int, part: int) -> float:
        if what in ("pole", "outer", "free"):
            end, leg = (points[-1, 3], points[-1, 2]) if number else (points[0, 0], points[0, 1])
            if what == "outer" and self._directions is not None:
                return float((leg - end) @ self._directions[number])
            return float(end[1] if what == "pole" else leg[part])
        following = (number + 1) % len(points)
        if what in ("joint", "P2", "P1"):
            place = {"joint": points[number, 3], "P2": points[number, 2]}.get(what)
            return float(points[following, 1, part] if place is None else place[part])
        before = points[number, 3] - points[number, 2]
        after = points[following, 1] - points[following, 0]
        if what == "angle":
            along = before if before.any() else after
            return float(np.arctan2(along[1], along[0]))
        return float(np.hypot(*(before if what == "before" else after)))

    def _unpack(self, full: Floats) -> tuple[Floats, Floats, Floats]:
        """Return leg fractions (n, 3), points (n, 4, 2), and the points' derivatives (…, N)."""
        count, size = len(self._profile), len(full)
        fractions = full[: 3 * count].reshape(count, 3)
        points, change = self._fixed.copy(), np.zeros((count, 4, 2, size))
        for (what, number, part), place in self.place.items():
            value, following = full[place], (number + 1) % count
            if what == "joint":
                for segment, index in ((number, 3), (following, 0)):
                    points[segment, index, part] = value
                    change[segment, index, part, place] = 1.0
            elif what in ("P1", "P2", "free"):
                segment, index = {"P1": (following, 1), "P2": (number, 2)}.get(
                    what, (-1, 2) if number else (0, 1)
                )
                points[segment, index, part] = value
                change[segment, index, part, place] = 1.0
            elif what == "pole":
                segment, index = (-1, 3) if number else (0, 0)
                points[segment, index, 1] = value
                change[segment, index, 1, place] = 1.0
        # Legs hang on joints and poles, which stand by now.
        for (what, number, _), place in self.place.items():
            if what == "angle":
                self._turn(points, change, number, full, place)
            elif what == "outer" and self._directions is not None:
                end, leg = ((-1, 3), (-1, 2)) if number else ((0, 0), (0, 1))
                points[leg] = points[end] + full[place] * self._directions[number]
                change[leg] = change[end]
                change[leg][:, place] += self._directions[number]
        return fractions, points, change

    def _turn(self, points: Floats, change: Floats, joint: int, full: Floats, place: int) -> None:
        """Lay the two legs of a smooth joint along its tangent."""
        following = (joint + 1) % len(points)
        cosine, sine = np.cos(full[place]), np.sin(full[place])
        along, across = np.array([cosine, sine]), np.array([-sine, cosine])
        for leg, sign, name in (((joint, 2), -1.0, "before"), ((following, 1), 1.0, "after")):
            at = self.place[(name, joint, 0)]
            points[leg] = points[joint, 3] + sign * full[at] * along
            change[leg] = change[joint, 3]
            change[leg][:, place] += sign * full[at] * across
            change[leg][:, at] += sign * along

    def _quartics(self, vector: Floats) -> tuple[Floats, Floats]:
        """Return the quartic points (n, 5, 2) and their derivatives (n, 5, 2, unknowns)."""
        full = self._base + self._spread @ vector
        fractions, p, dp = self._unpack(full)
        a, b, c = (fractions[:, leg, None] for leg in range(3))
        q = [p[:, 0], p[:, 0] + a * (p[:, 1] - p[:, 0]), p[:, 2] + b * (p[:, 1] - p[:, 2])]
        q += [p[:, 3] + c * (p[:, 2] - p[:, 3]), p[:, 3]]
        a, b, c = a[..., None], b[..., None], c[..., None]
        dq = [dp[:, 0], dp[:, 0] + a * (dp[:, 1] - dp[:, 0]), dp[:, 2] + b * (dp[:, 1] - dp[:, 2])]
        dq += [dp[:, 3] + c * (dp[:, 2] - dp[:, 3]), dp[:, 3]]
        for segment in range(len(p)):
            for leg, (end, inner) in enumerate(((0, 1), (2, 1), (3, 2))):
                dq[leg + 1][segment, :, 3 * segment + leg] += p[segment, inner] - p[segment, end]
        changes: Floats = np.stack(dq, axis=1) @ self._spread
        return np.stack(q, axis=1), changes

    # Where to search.

    def _searched(self, along: Floats) -> tuple[Floats, Floats]:
        """Return base and spread: the full vectors searched are base + spread · vector."""
        found = None
        if self._polygon:
            found = symmetric_vectors(
                self.names,
                along,
                len(self._profile),
                self._profile.closed,
                self._smooth,
                2.0 * self._target.middle / self._unit,
            )
            if found is not None and self._directions is not None:
                first, last = self._directions
                if not np.allclose(first * (1.0, -1.0), last, atol=1e-9):
                    found = None
        return found or (np.zeros(len(along)), np.eye(len(along)))

    def _spread_to(self, full: Floats) -> Floats:
        """Return the vector nearest to a full one."""
        nearest = np.linalg.lstsq(self._spread, full - self._base, rcond=None)[0]
        return np.asarray(np.clip(nearest, *np.transpose(self.bounds)))

    def _along_target(self) -> Floats:
        """Return control points on the target: joints at equal steps, legs along its tangents."""
        count, fine = len(self._profile), 60
        curve = self._target.points(fine * count + 1) / self._unit
        if self._ends is not None:
            if np.array_equal(self._ends[0], self._target.ends[1]):
                curve = curve[::-1]
        else:
            curve = self._turned(curve[:-1], fine)
        points = self._fixed.copy()
        for k in range(count):
            run = curve[fine * k : fine * (k + 1) + 1]
            points[k, 0], points[k, 3] = run[0], run[-1]
            points[k, 1] = run[0] + (run[1] - run[0]) * fine / 3.0
            points[k, 2] = run[-1] + (run[-2] - run[-1]) * fine / 3.0
        return points

    def _turned(self, curve: Floats, fine: int) -> Floats:
        """Return a closed target begun and run through as the profile is, joints symmetric."""
        corners = self._fixed[:, 0]
        middle = curve.mean(axis=0)
        path = np.concatenate([self._profile.sample(9)[:, :-1].reshape(-1, 2)]) / self._unit
        x, y = (path - path.mean(axis=0)).T
        backwards = float(np.sum(x * np.roll(y, -1) - np.roll(x, -1) * y)) < 0.0
        if backwards:
            curve = np.roll(curve[::-1], 1, axis=0)
        # At multiples of half a segment's step the joints are symmetric about the middle.
        angle = np.arctan2(*(corners[0] - middle)[::-1])
        nearest = int(np.argmin(np.hypot(*(curve - middle - (np.cos(angle), np.sin(angle))).T)))
        half = fine // 2
        curve = np.roll(curve, -half * round(nearest / half), axis=0)
        return np.concatenate([curve, curve[:1]])


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
