"""One end of a chain moved across, and the curve beside it with it, less and less."""

from __future__ import annotations

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.curves.continuity import JointClass, measure_joints
from sgb_core.curves.profile import Profile

# How far along the curve its end is followed, as a multiple of the way the end goes: the curve
# turns by no more than atan(1.5 / 4), 21°, since the steepest slope of the weight is 1.5.
REACH = 4.0
_SAMPLES = 17


def flared(profile: Profile, *, last: bool, step: float, after: int = 0) -> Floats:
    """Return the control points, (n, 4, 2), of an open chain with one end moved by ``step`` in r.

    ``last`` says which end; ``after`` so many segments, it is their end that moves, and they are
    scaled across. A place at the arc length s from it moves by step·w(s/R) with
    w(x) = (1 − x)²(1 + 2x), no more beyond R: REACH times the step, at least the end's own segment,
    at most as far as the curve first meets the axis. At a joint its handles move as a shear does
    that has w's slope there, so that tangents go on as they were; what is straight between
    kinks stays straight.
    """
    points = np.array(profile.control_points)
    whole = points if not last else points[::-1, ::-1]
    bottom, chain = whole[:after], whole[after:]
    if after:
        bottom[..., 0] *= 1.0 + step / bottom[-1, 3, 0]
        if not len(chain):
            return points
    sampled = _sampled(profile, last)[after:]
    lengths = np.hypot(*np.moveaxis(np.diff(sampled, axis=1), 2, 0)).sum(axis=1)
    starts = np.concatenate([[0.0], np.cumsum(lengths)])
    reach = _reach(chain, starts, step)
    if reach <= 0.0:
        return points
    x = np.clip(starts / reach, 0.0, 1.0)
    weights, slopes = (1.0 - x) ** 2 * (1.0 + 2.0 * x), -6.0 * x * (1.0 - x) / reach
    legs = np.hypot(*np.moveaxis(np.diff(chain, axis=1), 2, 0))
    kinked = _kinked(profile, last)[after:]
    for k in range(len(chain)):
        before, after = weights[k], weights[k + 1]
        moves = np.array(
            [before, before + slopes[k] * legs[k, 0], after - slopes[k + 1] * legs[k, 2], after]
        )
        if kinked[k] and kinked[k + 1] and _straight(chain[k]):
            moves = before + (after - before) * np.arange(4) / 3.0
        # A view of the points, whichever way the chain is walked.
        chain[k, :, 0] += step * moves
    return points


def _sampled(profile: Profile, last: bool) -> Floats:
    samples = profile.sample(_SAMPLES)
    return samples[::-1, ::-1] if last else samples


def _reach(chain: Floats, starts: Floats, step: float) -> float:
    """Return how far the end is followed: never as far as a control point on the axis."""
    wanted = max(REACH * abs(step), float(starts[1]))
    met = np.flatnonzero((chain[..., 0] <= 0.0).any(axis=1))
    most = float(starts[met[0]]) if len(met) else float(starts[-1])
    return min(wanted, most)


def _kinked(profile: Profile, last: bool) -> list[bool]:
    """Return for both ends and each joint between, in the order walked, whether it may turn."""
    smooth = {JointClass.G1, JointClass.C1, JointClass.G2}
    inner = [report.measured not in smooth for report in measure_joints(profile)]
    return [True, *(reversed(inner) if last else inner), True]


def _straight(points: Floats) -> bool:
    even = points[0] + (points[3] - points[0]) * np.arange(4)[:, None] / 3.0
    return bool(np.abs(points - even).max() <= 1e-9 * np.abs(points[3] - points[0]).max())
