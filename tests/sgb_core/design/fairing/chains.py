"""Random chains that satisfy their rules, and an independent search for the fairest."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from math import comb

import numpy as np
from scipy.optimize import minimize

from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import Segment, ShapeParameters
from sgb_core.design.fairing.energy import Energy


def smooth_chain(seed: int, count: int, rule: str, bend: float = 0.35) -> Profile:
    """Return a chain upwards from (3, 0) whose legs are in line at the joints."""
    rng = np.random.default_rng(seed)
    heading = np.pi / 2 + np.cumsum(rng.normal(size=count + 1) * bend)
    places = [np.array([3.0, 0.0])]
    for k in range(count):
        step = rng.uniform(0.8, 1.6) * np.array([np.cos(heading[k]), np.sin(heading[k])])
        places.append(places[-1] + step)
    tangents = []
    for k in range(count + 1):
        angle = heading[min(k, count - 1)] + rng.normal() * bend
        tangents.append(np.array([np.cos(angle), np.sin(angle)]))
    segments = []
    for k in range(count):
        first, last = places[k], places[k + 1]
        lengths = rng.uniform(0.2, 0.6, 2) * np.hypot(*(last - first))
        points = [
            first,
            first + lengths[0] * tangents[k],
            last - lengths[1] * tangents[k + 1],
            last,
        ]
        shape = ShapeParameters.from_leg_fractions(*rng.uniform(0.2, 0.9, 3))
        segments.append(Segment(np.array(points), shape))
    return Profile.of(segments, [rule] * (count - 1))


def rounded_chain(seed: int, count: int, rule: str) -> Profile:
    """Return a chain that turns to one side only: its curvatures can be made to agree."""
    rng = np.random.default_rng(seed)
    angles = np.cumsum(rng.uniform(0.25, 0.6, count + 1)) - 0.5
    radii = 3.0 + rng.uniform(-0.15, 0.15, count + 1)
    places = np.stack([radii * np.cos(angles) + 1.0, radii * np.sin(angles)], axis=1)
    tangents = np.stack([-np.sin(angles), np.cos(angles)], axis=1)
    segments = []
    for k in range(count):
        reach = np.hypot(*(places[k + 1] - places[k]))
        lengths = rng.uniform(0.25, 0.4, 2) * reach
        points = [
            places[k],
            places[k] + lengths[0] * tangents[k],
            places[k + 1] - lengths[1] * tangents[k + 1],
            places[k + 1],
        ]
        shape = ShapeParameters.from_leg_fractions(*rng.uniform(0.4, 0.9, 3))
        segments.append(Segment(np.array(points), shape))
    return Profile.of(segments, [rule] * (count - 1))


def energy(kind: Energy, points: np.ndarray, fractions: np.ndarray) -> float:
    """Return an energy of one segment by its definition and 240 points, finer at the ends."""
    a, b, c = fractions
    p = points
    q = np.array([p[0], p[0] + a * (p[1] - p[0]), p[2] + b * (p[1] - p[2]), 0 * p[3], p[3]])
    q[3] = p[3] + c * (p[2] - p[3])
    (r, _), (r1, h1), (r2, h2), (r3, h3) = ((rows @ q).T for rows in ROWS)
    speed = np.hypot(r1, h1)
    turn = r1 * h2 - h1 * r2
    with np.errstate(all="ignore"):
        curvature = turn / speed**3
        if kind is Energy.BENDING:
            density = curvature**2 * speed
        elif kind is Energy.VARIATION:
            rate = (r1 * h3 - h1 * r3) / speed**3 - 3 * turn * (r1 * r2 + h1 * h2) / speed**5
            density = rate**2 / speed
        else:
            density = (curvature**2 + (h1 / (r * speed)) ** 2) * abs(r) * speed
        value = float(WEIGHTS @ density)
    return value if np.isfinite(value) else 1e30


def _rows(s: np.ndarray) -> list[np.ndarray]:
    """Return what each quartic point counts in the curve and three derivatives at some s."""
    powers = [np.polynomial.Polynomial((0, 1)) ** k for k in range(5)]
    rest = [np.polynomial.Polynomial((1, -1)) ** k for k in range(5)]
    basis = [comb(4, k) * powers[k] * rest[4 - k] for k in range(5)]
    return [np.stack([f.deriv(n)(s) if n else f(s) for f in basis], axis=1) for n in range(4)]


_X, _W = np.polynomial.legendre.leggauss(240)
_X, _W = (_X + 1) / 2, _W / 2
WEIGHTS = _W * 30 * _X**2 * (1 - _X) ** 2
ROWS = _rows(_X**3 * (10 - 15 * _X + 6 * _X**2))


def fairest_alone(kind: Energy, points: np.ndarray, starts: int, seed: int = 0) -> float:
    """Return the least energy of one segment that L-BFGS-B finds from several starts."""
    rng = np.random.default_rng(seed)
    found = [
        minimize(
            lambda f: energy(kind, points, f),
            rng.uniform(0.1, 1.0, 3),
            bounds=[(1e-3, 1), (0, 1), (1e-3, 1)],
            method="L-BFGS-B",
        ).fun
        for _ in range(starts)
    ]
    return float(min(found))


def fairest_together(
    kind: Energy,
    profile: Profile,
    equations: Callable[[np.ndarray], Sequence[float]],
    starts: int,
    seed: int = 0,
) -> float:
    """Return the least energy of a chain under equations of its fractions (n, 3), by SLSQP."""
    points, count = profile.control_points, len(profile)
    rng = np.random.default_rng(seed)
    best = np.inf
    for _ in range(starts):
        found = minimize(
            lambda f: sum(
                energy(kind, p, g) for p, g in zip(points, f.reshape(-1, 3), strict=True)
            ),
            rng.uniform(0.2, 0.95, 3 * count),
            bounds=[(1e-3, 1), (0, 1), (1e-3, 1)] * count,
            constraints={"type": "eq", "fun": lambda f: equations(f.reshape(-1, 3))},
            method="SLSQP",
            options={"maxiter": 300, "ftol": 1e-10},
        )
        if np.abs(equations(found.x.reshape(-1, 3))).max() < 1e-7:
            best = min(best, float(found.fun))
    return best
