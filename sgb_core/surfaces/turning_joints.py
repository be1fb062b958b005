"""What joints truly are over the whole turn, where laws let them vary with the angle.

The leg fractions depend on the angle, and the radius by a factor. A class drops at single angles
only where an end derivative vanishes, which happens at an extreme, a key or a break of a law;
these are looked at exactly. What varies smoothly is followed from there to its largest. All joints
are searched at once, by arrays; what is found at an angle is then measured as that of one joint.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise
from math import degrees, pi

import numpy as np
from numpy.typing import NDArray

from sgb_core.arrays import Floats, Ints
from sgb_core.curves import basis
from sgb_core.curves.continuity import (
    EndView,
    JointClass,
    JointReport,
    end_view,
    measure_ends,
    measure_joint,
    start_view,
    stretched,
)
from sgb_core.curves.many_joints import RANKS, ManyEnds, ManyJoints, measure_many
from sgb_core.curves.segment import PARAMETERS
from sgb_core.surfaces.angular import angle_edges, different_angles
from sgb_core.surfaces.laws.law import RADIUS
from sgb_core.surfaces.revolution import RevolutionSurface
from sgb_core.surfaces.sections import Stretch
from sgb_core.surfaces.stretched_end import StretchedEnd, stretched_ends
from sgb_core.surfaces.variation import law_value, parameters, radius_factors
from sgb_core.values import dataclass

# Angles looked at between two special ones.
_BETWEEN = 7
# The search for a largest value: rounds of so many angles inside the bracket, each of which leaves
# two parts of it; the value is then known to the square of what is left.
_ROUNDS = 5
_INSIDE = 15
# What is followed to its largest, as the fields of ManyJoints.
_FOLLOWED = ("kink", "jump", "off")
# Rounding alone makes no angle better than an earlier one.
_BETTER = 1.0 + 1e-12
# Joints times angles that are measured at once, so that a long chain fills no memory.
_AT_ONCE = 200_000

Known = tuple[RevolutionSurface, tuple[JointReport, ...]]


def measure_turning_joints(
    surface: RevolutionSurface, known: Known | None = None
) -> tuple[JointReport, ...]:
    """Return what every joint truly is over θ in [0, sweep], in order.

    Without laws the joints of the profile. With laws each report has the lowest class at any
    angle, the largest kink and curvature jump (in size), and the speed ratio farthest from 1, in
    its logarithm; None where one is not bounded. ``at_deg`` is the angle where the class is
    lowest; of several the one with the largest kink, then the smallest angle.

    ``known`` is another surface with what its joints are: reports of joints between the very same
    two segments under the very same laws are taken over.
    """
    profile = surface.profile
    if not surface.laws:
        return tuple(measure_joint(profile, joint) for joint in profile.joints)
    found = _taken_over(surface, known)
    turning = []
    for joint in profile.joints:
        if joint in found:
            continue
        if any(law.applies_to(k) for law in surface.laws for k in profile.neighbours(joint)):
            turning.append(joint)
        else:
            found[joint] = replace(measure_joint(profile, joint), at_deg=0.0)
    if turning:
        angles = _first_angles(surface)
        most = max(1, _AT_ONCE // len(angles))
        for start in range(0, len(turning), most):
            joints = turning[start : start + most]
            found |= zip(joints, _over_turn(_Joints.of(surface, joints), angles), strict=True)
    return tuple(found[joint] for joint in profile.joints)


def _taken_over(surface: RevolutionSurface, known: Known | None) -> dict[int, JointReport]:
    """Return the reports, by joint, that are those of another surface."""
    if known is None:
        return {}
    before, reports = known
    now, then = surface.profile, before.profile
    if (
        surface.laws != before.laws
        or surface.sweep != before.sweep
        or len(now) != len(then)
        or now.rules != then.rules
        or now.size != then.size
    ):
        return {}
    same = [one is other for one, other in zip(now.segments, then.segments, strict=True)]
    pairs = ((joint, *now.neighbours(joint)) for joint in now.joints)
    return {joint: reports[joint] for joint, a, b in pairs if same[a] and same[b]}


def _first_angles(surface: RevolutionSurface) -> Floats:
    """Return breaks, keys and extremes of the laws in what the turn repeats, and some between."""
    edges = angle_edges(surface, bare=True)
    _, _, last = different_angles(surface, np.zeros(1))
    if np.isfinite(last) and surface.is_full_turn:
        edges = np.append(edges[edges < last - 1e-9], last)
    between = [np.linspace(low, high, _BETWEEN + 2)[:-1] for low, high in pairwise(edges)]
    return np.concatenate([*between, edges[-1:]])


@dataclass(frozen=True, slots=True, eq=False)
class _Joints:
    """Some joints of a surface: their segments, shape (K, 2), and what no law changes in them."""

    surface: RevolutionSurface
    numbers: Ints
    joints: Sequence[int]

    @classmethod
    def of(cls, surface: RevolutionSurface, joints: Sequence[int]) -> _Joints:
        """Return some joints of a surface."""
        pairs = [surface.profile.neighbours(joint) for joint in joints]
        return cls(surface, np.array(pairs, np.int64), joints)

    def chosen(self, places: NDArray[np.intp]) -> _Joints:
        """Return those at some places, which may come again."""
        return _Joints(self.surface, self.numbers[places], [self.joints[k] for k in places])

    def measure(self, theta: Floats) -> ManyJoints:
        """Return what the joints are at angles of shape (K or 1, A), each of shape (K, A)."""
        profile, numbers = self.surface.profile, self.numbers
        values = profile.shape_values[numbers[:, None]]
        values = np.broadcast_to(values, (len(numbers), theta.shape[1], 2, 4)).copy()
        factors = np.ones(values.shape[:3])
        stretch, fading = False, list[Floats]()
        for law in self.surface.laws:
            applies = self._governed(law.segments)[:, None]
            value = law_value(law, theta)[..., None]
            if law.steady is None:
                fading.append(np.where(applies, value - 1.0, 0.0))
            elif law.parameter == RADIUS:
                stretch = True
                factors = np.where(applies, factors * value, factors)
            else:
                k = PARAMETERS.index(law.parameter)
                values[..., k] = np.where(applies, value, values[..., k])
        fractions = basis.leg_fractions(*np.moveaxis(values, -1, 0))
        (c1, a2), (b1, b2), (a1, c2) = (
            (fractions[near][..., 0], fractions[far][..., 1])
            for near, far in ((2, 0), (1, 1), (0, 2))
        )
        points = profile.control_points
        ends = []
        for place, (order, part) in enumerate(
            (((3, 2, 1, 0), (c1, b1, a1)), ((0, 1, 2, 3), (a2, 1.0 - b2, c2)))
        ):
            walked = points[numbers[:, place]][:, order].transpose(1, 0, 2)[:, :, None]
            at, legs = walked[0], np.diff(walked, axis=0)
            if stretch:
                wider = np.stack([factors[..., place], np.ones_like(theta + part[0])], axis=-1)
                at, legs = at * wider, legs * wider
            end = ManyEnds(at, legs, *part)
            if fading:
                aways = np.stack([away[..., place] for away in fading], axis=-1)
                by_height = Stretch(self.surface.strengths, aways, np.zeros_like(aways))
                end = stretched_ends(end, by_height, profile.size)
            ends.append(end)
        before, after = ends
        return measure_many(before, after, profile.size)

    def _governed(self, segments: tuple[int, ...] | None) -> NDArray[np.bool_]:
        """Return which of the joints' segments a law governs, shape (K, 2)."""
        if segments is None:
            return np.ones(self.numbers.shape, np.bool_)
        return np.isin(self.numbers, segments)

    def report(self, place: int, theta: float) -> JointReport:
        """Return what one of them is at one angle."""
        profile, laws = self.surface.profile, self.surface.laws
        joint, pair = self.joints[place], tuple(self.numbers[place].tolist())
        values = parameters(profile, laws, theta, numbers=pair)[0].tolist()
        factors = radius_factors(profile, laws, theta, numbers=pair)[0].tolist()
        a1, b1, c1 = basis.leg_fractions(*values[0])
        a2, b2, c2 = basis.leg_fractions(*values[1])
        before, after = end_view(profile.segments[pair[0]]), start_view(profile.segments[pair[1]])
        back = stretched(EndView(before.at, before.legs, c1, b1, a1), factors[0])
        ahead = stretched(EndView(after.at, after.legs, a2, 1.0 - b2, c2), factors[1])
        stretch = self.surface.sections(theta, numbers=pair).stretch
        if stretch is not None:
            back = StretchedEnd.of(back, stretch[0], profile.size)
            ahead = StretchedEnd.of(ahead, stretch[1], profile.size)
        return measure_ends(back, ahead, joint, profile.rules[joint], profile.size)


def _over_turn(joints: _Joints, angles: Floats) -> list[JointReport]:
    """Return the report of the worst of each joint, seen at increasing angles and between."""
    seen = joints.measure(angles[None])
    kinks, jumps, ratios = _largest(joints, angles, seen)
    lowest = seen.rank.min(axis=1)
    # Kinks that differ by rounding alone are one.
    rounded = np.round(np.nan_to_num(seen.kink), 9)
    rounded[seen.rank != lowest[:, None]] = -np.inf
    places = rounded.argmax(axis=1)
    degenerate = np.any(seen.degenerate, axis=1).tolist()
    found = []
    for k, place in enumerate(places.tolist()):
        theta = float(angles[place])
        report = joints.report(k, theta)
        worst, *others = (each[k] for each in (kinks, jumps, ratios))
        kink = None if worst is None else joints.report(k, worst)
        jump, ratio = (None if at is None else joints.report(k, at) for at in others)
        if RANKS[lowest[k]] is JointClass.G0 and kink is not None and worst is not None:
            here, there = (round(each.kink_deg or 0.0, 9) for each in (report, kink))
            if (-there, worst) < (-here, theta):
                theta, report = worst, kink
        found.append(
            replace(
                report,
                kink_deg=None if kink is None else kink.kink_deg,
                curvature_jump=None if jump is None else jump.curvature_jump,
                speed_ratio=None if ratio is None else ratio.speed_ratio,
                degenerate=degenerate[k],
                at_deg=degrees(theta) % 360.0 if theta < 2.0 * pi else 360.0,
            )
        )
    return found


def _largest(joints: _Joints, angles: Floats, seen: ManyJoints) -> list[list[float | None]]:
    """Return where each value of _FOLLOWED is largest, per joint; None where it is not bounded."""
    known = np.stack([getattr(seen, name) for name in _FOLLOWED])
    bounded = ~np.isnan(known).any(axis=-1)
    known = np.nan_to_num(known)
    top = (known >= known.max(axis=-1, keepdims=True) / _BETTER).argmax(axis=-1)
    best = np.take_along_axis(known, top[..., None], axis=-1)[..., 0]
    at = angles[top]
    varies = bounded & (known.min(axis=-1) < best / _BETTER)
    which, places = np.nonzero(varies)
    if len(which):
        near, some = top[varies], joints.chosen(places)
        low = angles[np.maximum(near - 1, 0)]
        high = angles[np.minimum(near + 1, len(angles) - 1)]
        size, where = best[varies], at[varies]
        each = np.arange(len(which))
        for _ in range(_ROUNDS):
            inner = np.ascontiguousarray(np.linspace(low, high, _INSIDE + 2, axis=-1))
            measured = some.measure(inner)
            sizes = np.stack([getattr(measured, name) for name in _FOLLOWED])[which, each]
            sizes = np.nan_to_num(sizes)
            k = sizes.argmax(axis=-1)
            better = sizes[each, k] > size * _BETTER
            size = np.where(better, sizes[each, k], size)
            where = np.where(better, inner[each, k], where)
            low = inner[each, np.maximum(k - 1, 0)]
            high = inner[each, np.minimum(k + 1, _INSIDE + 1)]
        at[varies] = where
    return [
        [theta if holds else None for theta, holds in zip(*row, strict=True)]
        for row in zip(at.tolist(), bounded.tolist(), strict=True)
    ]
