"""The surface as exact rational tensor-product Bézier patches, for NURBS formats."""

from __future__ import annotations

from itertools import pairwise
from math import ceil, cos, pi

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.surfaces.laws.paper import PAPER
from sgb_core.surfaces.revolution import RevolutionSurface
from sgb_core.surfaces.variation import Law, varying_quartics
from sgb_core.values import dataclass


@dataclass(frozen=True, slots=True, eq=False)
class RationalPatch:
    """One segment over one arc: degree (p, q) in (s, u), both in [0, 1].

    ``points`` (p + 1, q + 1, 3) are placed control points, ``weights`` (p + 1, q + 1) positive; the
    surface is Σ B B w P / Σ B B w. ``segment`` and the absolute angles ``start`` and ``end``, in
    radians, say which part it is.
    """

    points: Floats
    weights: Floats
    segment: int
    start: float
    end: float


def rational_patches(surface: RevolutionSurface) -> tuple[RationalPatch, ...]:
    """Return the surface exactly, arcs of at most 90°, segment by segment: degree (4, 2).

    The arc's weights are 1, cos(Δθ/2), 1; √2/2 for quarter turns. Raises ValueError where laws
    hold: see :func:`paper_law_half_turn` for the one that stays rational.

    >>> cylinder = sgb.Document(sgb.Profile.of([sgb.line((10, 0), (10, 60))]))
    >>> [patch.points.shape for patch in sgb.rational_patches(cylinder.surface)]
    [(5, 3, 3), (5, 3, 3), (5, 3, 3), (5, 3, 3)]
    """
    if surface.laws:
        raise ValueError("a surface whose shape varies with the angle has no such exact form")
    count = max(1, ceil(surface.sweep / (pi / 2.0) - 1e-9))
    angles = surface.angles(count)
    half = surface.sweep / count / 2.0
    weights = np.tile([1.0, cos(half), 1.0], (5, 1))
    patches = []
    for segment, quartic in enumerate(surface.profile.quartics):
        for start, end in pairwise(angles):
            at = np.array([start, (start + end) / 2.0, end])
            # The middle point lies where the end tangents of the arc meet.
            reach = quartic[:, :1] * np.array([1.0, 1.0 / cos(half), 1.0])
            points = _placed(surface, reach, np.tile(quartic[:, 1:], (1, 3)), at)
            patches.append(RationalPatch(points, weights, segment, float(start), float(end)))
    return tuple(patches)


def paper_law_half_turn(surface: RevolutionSurface, segment: int) -> RationalPatch:
    """Return the first half turn of a segment under the paper's law for ω, degree (4, 3) in (s, t).

    With ω = from + (to − from) t the quartic points are linear in t; times the half turn (24),
    quadratic with weight 2t² − 2t + 1, they are exactly cubic with weights 1, ⅓, ⅓, 1. Raises
    ValueError where the segment's only law is not the paper's for ω, or the sweep is below π.
    """
    laws = [law for law in surface.laws if law.applies_to(segment)]
    if not laws or not all(_is_paper_omega(law) for law in laws) or surface.sweep < pi:
        raise ValueError("the paper's law for ω over half a turn is needed")
    quartics = varying_quartics(surface.profile, surface.laws, np.array([0.0, pi]))[0]
    first, last = quartics[0, segment], quartics[1, segment]
    # Homogeneous Bernstein coefficients of degree 2 of weight, w cos θ and w sin θ over t.
    conic = np.array([[1.0, 0.0, 1.0], [1.0, 0.0, -1.0], [0.0, 1.0, 0.0]])
    weights = _raised(conic[0], np.ones(1), np.ones(1))
    cosine = _raised(conic[1], first[:, 0], last[:, 0]) / weights
    sine = _raised(conic[2], first[:, 0], last[:, 0]) / weights
    height = _raised(conic[0], first[:, 1], last[:, 1]) / weights
    axes = surface.directions(np.array([surface.start, surface.start + pi / 2.0]))
    points = (
        cosine[..., None] * axes[0, 0]
        + sine[..., None] * axes[1, 0]
        + height[..., None] * axes[0, 2]
    ) + np.asarray(surface.placement.translation)
    return RationalPatch(
        points, np.tile(weights, (5, 1)), segment, surface.start, surface.start + pi
    )


def _is_paper_omega(law: Law) -> bool:
    return law.shape is PAPER and law.parameter == "omega"


def _raised(conic: Floats, first: Floats, last: Floats) -> Floats:
    """Return the cubic Bernstein coefficients of conic(t)·((1 − t) first + t last), (k, 4)."""
    product = np.zeros((len(first), 4))
    factors = (1.0, 2.0, 1.0)
    for k in range(3):
        product[:, k] += factors[k] * conic[k] * first
        product[:, k + 1] += factors[k] * conic[k] * last
    return np.asarray(product / np.array([1.0, 3.0, 3.0, 1.0]))


def _placed(surface: RevolutionSurface, r: Floats, h: Floats, theta: Floats) -> Floats:
    vectors = surface.directions(theta)
    points: Floats = r[..., None] * vectors[:, 0] + h[..., None] * vectors[:, 2]
    return np.asarray(points + np.asarray(surface.placement.translation))
