"""Areas under laws with sharp bends, against nested quadrature of another kind."""

from __future__ import annotations

from itertools import pairwise
from math import pi

import numpy as np
import pytest

from sgb_core.surfaces.angular import angle_edges
from sgb_core.surfaces.measures import area
from sgb_core.surfaces.revolution import RevolutionSurface
from sgb_core.surfaces.variation import Law, varying_quartics
from tests.sgb_core.surfaces.chains import TOWER, chain

KINDS = ("paper", "raised-cosine", "cosine", "keyframes")
TOPS = {"lambda1": 4.0, "lambda2": 6.0, "lambda3": 4.0, "omega": 1.0}


def tanh_sinh(low: float, high: float, level: int) -> tuple[np.ndarray, np.ndarray]:
    """Return double-exponential nodes and weights, which bear any singularity at the ends."""
    k = np.arange(-level * 4, level * 4 + 1) / level
    x = np.tanh(pi / 2 * np.sinh(k))
    w = pi / 2 * np.cosh(k) / np.cosh(pi / 2 * np.sinh(k)) ** 2 / level
    return (low + high) / 2 + (high - low) / 2 * x, (high - low) / 2 * w


def nested(surface: RevolutionSurface) -> float:
    """Return ∬ |S_s × S_θ|: double-exponential along, over some hundred panels across."""
    total = 0.0
    edges = angle_edges(surface)
    theta = np.unique(np.concatenate([np.linspace(a, b, 12) for a, b in pairwise(edges)]))
    nodes, weights = np.polynomial.legendre.leggauss(6)
    angles = (theta[:-1, None] + np.diff(theta)[:, None] * (nodes + 1) / 2).ravel()
    turned = (np.diff(theta)[:, None] * weights / 2).ravel()
    pieces = [tanh_sinh(a, a + 1 / 24, 24) for a in np.arange(24) / 24]
    s, w = (np.concatenate(part) for part in zip(*pieces, strict=True))
    t = 1 - s
    at = np.stack([t**4, 4 * s * t**3, 6 * s**2 * t**2, 4 * s**3 * t, s**4], axis=1)
    slope = 4 * np.stack([t**3, 3 * s * t**2, 3 * s**2 * t, s**3], axis=1)
    for angle, weight in zip(angles, turned, strict=True):
        q, dq = varying_quartics(surface.profile, surface.laws, angle)
        r, change = (at @ q)[..., 0], at @ dq
        v = slope @ np.diff(q, axis=-2)
        bent = change[..., 0] * v[..., 1] - change[..., 1] * v[..., 0]
        total += weight * float((np.hypot(r * np.hypot(v[..., 0], v[..., 1]), bent) @ w).sum())
    return total


def sharp(seed: int) -> RevolutionSurface:
    """Return a segment with long legs that fold back, under two random laws."""
    rng = np.random.default_rng(seed)
    points = rng.uniform(-60, 100, (4, 2)) + np.array([120.0, 0.0])
    shape = [rng.uniform(0, top) for top in TOPS.values()]
    shape[3] = 1.0 if seed % 3 == 0 else shape[3]
    shape[0] = 4.0 if seed % 3 == 0 else shape[0]
    laws = []
    for name in rng.choice(list(TOPS), 2, replace=False):
        ends = rng.uniform(0, TOPS[name], 2)
        keys = tuple(map(tuple, np.stack([rng.uniform(0, 360, 3), rng.random(3)], axis=1).tolist()))
        laws.append(Law(str(name), KINDS[rng.integers(4)], *ends.tolist(), count=2, keyframes=keys))
    return RevolutionSurface.of_degrees(
        chain([points.tolist()], tuple(shape)), laws=tuple(laws), sweep_deg=(360.0, 148.2)[seed % 2]
    )


@pytest.mark.parametrize("seed", range(12))
def test_random_laws_on_sharp_bends(seed: int) -> None:
    surface = sharp(seed)
    assert area(surface) == pytest.approx(nested(surface), rel=1e-9)


def test_what_repeats_is_measured_once_and_counted_as_often() -> None:
    profile = chain(TOWER, (2, 4, 1, 0.7))
    waves = Law("lambda2", "cosine", 1.0, 5.0, count=7)
    whole = RevolutionSurface.of_degrees(profile, laws=(waves,))
    wedge = RevolutionSurface.of_degrees(profile, laws=(waves,), sweep_deg=360.0 / 7)
    assert area(whole) == pytest.approx(7 * area(wedge), rel=1e-11)


def test_segments_without_a_law_are_measured_plainly() -> None:
    profile = chain(TOWER, (2, 4, 1, 0.7))
    still = Law("lambda2", "cosine", 4.0, 4.0, count=3, segments=(1,))
    assert area(RevolutionSurface.of_degrees(profile, laws=(still,))) == pytest.approx(
        area(RevolutionSurface(profile)), rel=1e-12
    )
