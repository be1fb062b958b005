"""Points along known curves, for the tracer to find again."""

from __future__ import annotations

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.curves.profile import Profile


def polyline(corners: list[tuple[float, float]], count: int) -> Floats:
    """Return about ``count`` points along straight lines, the corners among them."""
    vertices = np.array(corners, dtype=np.float64)
    lengths = np.hypot(*np.diff(vertices, axis=0).T)
    parts = [
        start
        + np.linspace(0.0, 1.0, max(round(count * length / lengths.sum()), 2), endpoint=False)[
            :, None
        ]
        * (end - start)
        for start, end, length in zip(vertices[:-1], vertices[1:], lengths, strict=True)
    ]
    return np.concatenate([*parts, vertices[-1:]])


def semicircle(radius: float, count: int) -> Floats:
    """Return points of a semicircle from the lower pole to the upper one."""
    angle = np.linspace(-np.pi / 2, np.pi / 2, count)
    points = np.stack([radius * np.cos(angle), radius * np.sin(angle)], axis=1)
    points[[0, -1], 0] = 0.0
    return points


def wavy(count: int) -> Floats:
    """Return points of a smooth shape with eight inflections, pole to pole."""
    angle = np.linspace(-np.pi / 2, np.pi / 2, count)
    r = 1.0 + 0.2 * np.cos(7.0 * angle) + 0.1 * np.sin(3.0 * angle)
    points = np.stack([80.0 * r * np.cos(angle), 100.0 * r * np.sin(angle)], axis=1)
    points[[0, -1], 0] = 0.0
    return points


def frusta(points: Floats) -> float:
    """Return the volume of the cone frusta through points."""
    r0, r1 = points[:-1, 0], points[1:, 0]
    return abs(float((np.pi / 3 * (r0**2 + r0 * r1 + r1**2) * np.diff(points[:, 1])).sum()))


def volume(profile: Profile) -> float:
    """Return |π∫r² dh| of a profile by the trapezoid rule on many points."""
    dense = profile.sample(4001)
    return abs(sum(np.pi * np.trapezoid(part[:, 0] ** 2, part[:, 1]) for part in dense))


def sign_changes(profile: Profile) -> int:
    """Return how often the curvature changes its sign along the smooth runs of a profile."""
    marks = np.linspace(0.0, 1.0, 301)
    changes, last = 0, np.zeros(0)
    for number, segment in enumerate(profile.segments):
        bend = segment.curvature(marks) * profile.size
        signs = np.sign(bend[np.abs(bend) > 1e-6])
        if number and profile.rules[number - 1] != "G0":
            signs = np.concatenate([last, signs])
        changes += int((np.diff(signs) != 0).sum())
        last = signs[-1:]
    return changes


def farthest(profile: Profile, points: Floats) -> float:
    """Return the largest distance of a point from a dense polyline along the profile."""
    chain = profile.sample(3001).reshape(-1, 2)
    gaps = [np.hypot(*(chain - point).T).min() for point in points]
    return float(max(gaps))
