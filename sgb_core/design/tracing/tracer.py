"""From points to a profile: as few segments as keep the tolerance."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

from sgb_core.curves.profile import JointRule, Profile
from sgb_core.design.tracing.assembly import assembled, begun_at, cloud_of
from sgb_core.design.tracing.conditions import Condition, KeepsVolume
from sgb_core.design.tracing.corners import corners_of, noise_of, with_known
from sgb_core.design.tracing.curvature import with_equal_curvature
from sgb_core.design.tracing.errors import TraceError
from sgb_core.design.tracing.guide import guide_of
from sgb_core.design.tracing.outliers import FAR, are_many, isolated_outliers
from sgb_core.design.tracing.prepare import Prepared, prepare
from sgb_core.design.tracing.profile import profile_of
from sgb_core.design.tracing.result import Trace, distances, trace_of
from sgb_core.design.tracing.search import divided, feet_at, fewest, settled, within
from sgb_core.design.tracing.solver import Cloud, State, least_squares
from sgb_core.design.tracing.straying import fault
from sgb_core.design.tracing.symmetry import is_symmetric, symmetrized
from sgb_core.design.tracing.thinning import thinned
from sgb_core.design.tracing.tidy import levelled, straightened, without_wiggles
from sgb_core.fields.kinds import Said
from sgb_core.findings.refusal import Argument

_FINISH = 8
# How often a chain that misses a point in the end gets one segment more, and its rounds.
_REPAIRS, _REPAIRING = 12, 12


def trace(
    points: ArrayLike,
    tolerance: float | None = None,
    *,
    weights: ArrayLike | None = None,
    corners: Sequence[int] = (),
    closed: bool | None = None,
    smoothness: JointRule = JointRule.G1,
) -> Trace:
    """Return the profile of as few segments as keep within ``tolerance`` of ordered points.

    ``points`` has shape (N, 2): r and h along the profile. The default tolerance is 1e-3 of the
    size. The chain keeps the ends; one within the tolerance of the axis becomes a pole there.
    Joints are G1, or G2 where ``smoothness`` says so, except at corners: turns of more than 30° at
    the scale of the tolerance, and at the points that ``corners`` number. ``weights`` (N,) say how
    much points count in the least squares, and ``closed`` whether they go round; by default they
    do where the ends meet. Isolated points farther than three tolerances are left out. The volume
    that the points enclose is kept.

    Raises TraceError, a ValueError, for points that are no profile.

    >>> import numpy as np
    >>> angle = np.linspace(-np.pi / 2, np.pi / 2, 181)
    >>> found = trace(np.stack([50 * np.cos(angle), 50 * np.sin(angle)], axis=1), 0.1)
    >>> len(found.profile), found.largest_deviation < 0.1
    (1, True)
    """
    smoothness = JointRule(smoothness)
    if smoothness not in (JointRule.G1, JointRule.G2):
        raise TraceError(Argument("smoothness", smoothness.value, Said("G1 or G2")))
    ready = prepare(points, tolerance, weights, corners, closed)
    found, left_out = _profile(ready, smoothness)
    far = _far(found, ready, ready.outliers)
    if len(far) < len(ready.outliers):
        # What was taken for an outlier and is near the curve after all counts.
        ready = prepare(points, tolerance, weights, corners, closed, left_out=far)
        found, left_out = _profile(ready, smoothness)
    outliers = np.union1d(ready.outliers, _far(found, ready, left_out))
    return trace_of(found, ready.given, ready.tolerance * ready.size, outliers)


def _far(found: Profile, ready: Prepared, numbers: NDArray[np.intp]) -> NDArray[np.intp]:
    """Return those of some given points that are farther from a profile than outliers may be."""
    off = distances(found, ready.given[numbers])
    return numbers[off > FAR * ready.tolerance * ready.size]


def _profile(ready: Prepared, smoothness: JointRule) -> tuple[Profile, NDArray[np.intp]]:
    """Return the profile, and the numbers of the given points that were left out for it."""
    state, traced = _traced(ready, smoothness)
    return profile_of(state.chain, traced, smoothness), traced.outliers


def _traced(ready: Prepared, smoothness: JointRule) -> tuple[State, Prepared]:
    """Return the chain, and the points that it was traced from."""
    many = are_many(len(ready.outliers), len(ready.given))
    if many:
        # What lies alone less far off is of their kind.
        ready = _without_alone(ready)
    state, few, cloud = _searched(ready)
    if fault(state, few) > 1.0 and not many:
        # There may be some that no curve along the others comes within the tolerance of.
        fewer = _without_alone(ready)
        if len(fewer.points) < len(ready.points):
            ready = fewer
            state, few, cloud = _searched(ready)
    state = straightened(state, few)
    state = levelled(state, few, ready.poles)
    state, bend = without_wiggles(state, few)
    return _finished(state, few, cloud, bend, smoothness), ready


def _without_alone(ready: Prepared) -> Prepared:
    return ready.without(isolated_outliers(ready.points, ready.tolerance / FAR))


def _searched(ready: Prepared) -> tuple[State, Cloud, Cloud]:
    """Return the first chain, the points it was sought for, and all points."""
    points, tolerance = ready.points, ready.tolerance
    noise = noise_of(points)
    guide = guide_of(points, min(4.0 * noise, tolerance))
    found = corners_of(points, guide.along, tolerance, noise, closed=ready.closed)
    found = with_known(found, ready.corners, points, guide.along, tolerance)
    cloud = cloud_of(ready, guide)
    if ready.closed and not found:
        few = thinned(cloud)
        state = fewest(few, guide_of(points, tolerance), closed=True)
    else:
        if ready.closed:
            cloud = begun_at(cloud, found[0].along, guide.length)
        state, few = assembled(ready, guide, found, cloud)
    return state, few, cloud


def _finished(
    state: State, few: Cloud, cloud: Cloud, bend: Condition, smoothness: JointRule
) -> State:
    """Return the chain after its last rounds, with all points, within the tolerance."""
    if few is not cloud:
        place = np.interp(cloud.along, few.along, state.feet.segment + state.feet.s)
        state = settled(state.chain, cloud, feet_at(place, state.chain.layout.count))
    conditions: list[Condition] = [bend, KeepsVolume(cloud.shares)]
    base = _last_rounds(state, cloud, conditions)
    state = _as_smooth(base, cloud, conditions, smoothness)
    for _ in range(_REPAIRS):
        missed = fault(state, cloud)
        if missed <= 1.0:
            break
        worst = int(state.feet.segment[np.argmax(np.abs(state.distances))])
        at = None if state is base else worst
        base = least_squares(divided(base, cloud, at), cloud, _REPAIRING, conditions[1:])
        base = _last_rounds(base, cloud, conditions[1:])
        more = _as_smooth(base, cloud, conditions[1:], smoothness)
        if fault(more, cloud) < missed:
            state = more
        elif smoothness is JointRule.G1:
            break
    mean = symmetrized(state.chain) if is_symmetric(cloud.points, cloud.tolerance) else None
    if mean is not None:
        balanced = settled(mean, cloud, state.feet)
        if fault(balanced, cloud) <= max(1.0, fault(state, cloud)):
            return balanced
    return state


def _last_rounds(state: State, cloud: Cloud, conditions: list[Condition]) -> State:
    """Return the chain after its last rounds; the last conditions are those that must hold."""
    last = within(least_squares(state, cloud, _FINISH, conditions), cloud, conditions)
    if fault(last, cloud) > 1.0:
        # Least squares may have left what the search had pressed down: on from there.
        pressed = within(state, cloud, conditions[-1:])
        last = min(last, pressed, key=lambda found: fault(found, cloud))
    return last if fault(last, cloud) <= max(1.0, fault(state, cloud)) else state


def _as_smooth(
    state: State, cloud: Cloud, conditions: list[Condition], smoothness: JointRule
) -> State:
    if smoothness is JointRule.G1:
        return state
    return with_equal_curvature(state, cloud, conditions)
