"""Curvature at many places of a profile, for a comb in the editor and a plot beside it."""

from __future__ import annotations

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.curves import basis
from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import DEGENERATE_LEG
from sgb_core.fields.kinds import Said
from sgb_core.findings.errors import FindingError
from sgb_core.findings.refusal import Argument
from sgb_core.values import dataclass

# Typical is what this part of the length stays below, so that one cusp does not flatten the rest.
_TYPICAL = 0.95


@dataclass(frozen=True, slots=True)
class Comb:
    """Samples at equal steps of s, ends included; n segments, K samples each.

    ``positions`` and unit ``normals`` have shape (n, K, 2), ``curvature`` (n, K). The normal is
    the tangent turned by +90°, so positive curvature bends towards it. ``distance``, shape
    (n, K), is the length run through so far, as a polyline of the samples. Curvature and normal
    are nan where the derivative vanishes.
    """

    positions: Floats
    normals: Floats
    curvature: Floats
    distance: Floats


def comb(profile: Profile, per_segment: int) -> Comb:
    """Return the curvature of a profile at ``per_segment`` ≥ 2 places of each segment.

    >>> belly, _ = sgb.arc((10, 30), 30.0, -1.5, 1.5)
    >>> comb = sgb.comb(sgb.Profile.of([belly]), 5)
    >>> comb.curvature.round(3).tolist()
    [[0.033, 0.033, 0.033, 0.033, 0.033]]
    """
    if per_segment < 2:
        raise FindingError(Argument("the number of samples", per_segment, Said("2 or more")))
    s = np.linspace(0.0, 1.0, per_segment)
    control = profile.quartics
    slopes = 4.0 * np.diff(control, axis=1)
    bends = 3.0 * np.diff(slopes, axis=1)
    positions = basis.bernstein(4, s) @ control
    d1, d2 = basis.bernstein(3, s) @ slopes, basis.bernstein(2, s) @ bends
    speed = np.hypot(d1[..., 0], d1[..., 1])
    # At an end the derivative is 4 × leg fraction × leg length.
    vanishes = speed <= 4.0 * DEGENERATE_LEG * profile.size
    safe = np.where(vanishes, 1.0, speed)
    normals = np.stack([-d1[..., 1], d1[..., 0]], axis=-1) / safe[..., None]
    curvature = (d1[..., 0] * d2[..., 1] - d1[..., 1] * d2[..., 0]) / safe**3
    normals[vanishes], curvature[vanishes] = np.nan, np.nan
    steps = np.hypot(*np.moveaxis(np.diff(positions, axis=1), -1, 0))
    runs = np.concatenate([np.zeros((len(control), 1)), np.cumsum(steps, axis=1)], axis=1)
    before = np.concatenate([[0.0], np.cumsum(runs[:, -1])[:-1]])
    return Comb(positions, normals, curvature, before[:, None] + runs)


def typical_curvature(found: Comb) -> float:
    """Return the curvature that combs and plots are scaled to, 0 for straight lines."""
    keep = np.isfinite(found.curvature)
    if not keep.any():
        return 0.0
    lengths = found.distance[:, -1:] - found.distance[:, :1]
    weights = np.broadcast_to(lengths, found.curvature.shape)[keep]
    bends = np.abs(found.curvature[keep])
    order = np.argsort(bends)
    share = np.cumsum(weights[order])
    place = int(np.searchsorted(share, _TYPICAL * share[-1]))
    return float(bends[order][min(place, len(order) - 1)])


def outward_sign(profile: Profile) -> float:
    """Return +1 where positive curvature bulges away from the axis, else −1.

    That is so for a profile that runs upwards on the outside, or counter-clockwise in a ring.
    """
    ends = profile.segments[0].points[0], profile.segments[-1].points[3]
    if not profile.closed:
        return 1.0 if ends[1][1] >= ends[0][1] else -1.0
    r, h = profile.control_points.reshape(-1, 2).T
    turned = float((r * np.roll(h, -1) - h * np.roll(r, -1)).sum())
    return 1.0 if turned >= 0.0 else -1.0
