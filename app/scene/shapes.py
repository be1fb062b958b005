"""The geometry of the overlays as plain arrays: lines, circles, marks. Nothing here draws."""

from __future__ import annotations

from collections.abc import Iterable
from math import pi
from typing import Any

import numpy as np
from numpy.typing import NDArray

from sgb_core.document.evaluation import Evaluation
from sgb_core.surfaces.revolution import RevolutionSurface

Array = NDArray[Any]

MARKS_PER_TURN = 32
CIRCLE_STEPS = 96
# The marks of more segments than this would lie on each other: each circle has fewer.
_UNCROWDED = 24


def place(surface: RevolutionSurface, radius: Array, height: Array, angle: Array) -> Array:
    """Return points of the placed surface's space, (25)–(27), shape (*broadcast, 3), float64."""
    points = np.empty((*np.broadcast(radius, height, angle).shape, 3))
    h, u, v = surface.axis.frame
    points[..., h] = height
    points[..., u] = radius * np.cos(angle)
    points[..., v] = radius * np.sin(angle)
    return surface.placement.apply(points)


def in_profile_plane(surface: RevolutionSurface, points: Array) -> Array:
    """Return (r, h) points, shape (..., 2), placed in the half-plane where the sweep starts."""
    return place(surface, points[..., 0], points[..., 1], np.asarray(surface.start))


def circle_lines(surface: RevolutionSurface) -> Array:
    """Return the circles, or arcs, swept by each P1 and P2: shape (2, n, steps + 1, 3)."""
    inner = surface.profile.control_points[:, 1:3].swapaxes(0, 1)
    steps = max(8, round(CIRCLE_STEPS * surface.sweep / (2 * pi)))
    angles = surface.angles(steps)
    return place(surface, inner[..., None, 0], inner[..., None, 1], angles)


def circle_marks(surface: RevolutionSurface) -> Array:
    """Return where the marks stand along the circles, shape (2, n, marks, 3)."""
    inner = surface.profile.control_points[:, 1:3].swapaxes(0, 1)
    crowding = max(1.0, len(surface.profile) / _UNCROWDED)
    count = max(2, round(MARKS_PER_TURN / crowding * surface.sweep / (2 * pi)))
    angles = surface.angles(count)
    if surface.is_full_turn:
        angles = angles[:-1]
    return place(surface, inner[..., None, 0], inner[..., None, 1], angles)


def meridians(surface: RevolutionSurface, angles: Array, along: int) -> Array:
    """Return the sections at angles as lines, one for each segment: (k·n, along + 1, 3)."""
    placed = surface.sections(angles - surface.start).on(np.linspace(0.0, 1.0, along + 1))
    lines = place(surface, placed[..., 0], placed[..., 1], angles[:, None, None])
    return lines.reshape(-1, along + 1, 3)


def axis_line(surface: RevolutionSurface) -> Array:
    """Return the rotation axis as a centre line, long and short dashes: shape (dashes, 2, 3)."""
    points = surface.profile.control_points.reshape(-1, 2)
    low, high = points[:, 1].min(), points[:, 1].max()
    reach = max(high - low, np.abs(points[:, 0]).max())
    low, high = low - 0.16 * reach, high + 0.16 * reach
    # An odd number of periods of a long dash, a gap, a short dash and a gap, ending on a long one.
    periods = 13
    starts = np.arange(periods + 1)
    dashes = np.stack([[starts, starts + 0.62], [starts + 0.76, starts + 0.86]])
    dashes = dashes.transpose(2, 0, 1).reshape(-1, 2)[:-1] / (periods + 0.62)
    heights = low + (high - low) * dashes
    return place(surface, np.zeros(1), heights, np.zeros(1))


def net_lines(
    segments: int, per_segment: int, columns: int, rows_at: int, columns_at: int
) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """Return a decimated net over a sweep grid: the lengths of its lines, and their vertices.

    A parallel after every ``rows_at`` intervals of each segment, the ends included, and a
    meridian after every ``columns_at`` columns.
    """
    width = columns + 1
    rows = np.arange(segments * (per_segment + 1)).reshape(segments, per_segment + 1)
    drawn = np.concatenate([rows[:, ::rows_at].ravel(), rows[:, -1]])
    parallels = drawn[:, None] * width + np.arange(width)
    meridians = rows[:, None, :] * width + np.arange(0, width, columns_at)[:, None]
    lengths = np.repeat(
        (width, per_segment + 1), (len(parallels), meridians.shape[0] * meridians.shape[1])
    )
    return lengths, np.concatenate([parallels.ravel(), meridians.ravel()])


def star() -> tuple[Array, Array]:
    """Return an asterisk of three bars: points (V, 2) in the unit circle, triangles (T, 3)."""
    half = 0.16
    bar = np.array([[-1, -half], [1, -half], [1, half], [-1, half]])
    angles = pi / 2 + np.arange(3) * pi / 3
    turns = np.array([[[np.cos(a), np.sin(a)], [-np.sin(a), np.cos(a)]] for a in angles])
    corners = np.array([[0, 1, 2], [0, 2, 3]])
    return (bar @ turns).reshape(-1, 2), np.concatenate([corners + 4 * k for k in range(3)])


def ring(sides: int = 18, inner: float = 0.56) -> tuple[Array, Array]:
    """Return an 'o': points (V, 2) in the unit circle and triangles (T, 3)."""
    angles = np.arange(sides) * (2 * pi / sides)
    circle = 0.86 * np.stack([np.cos(angles), np.sin(angles)], axis=-1)
    k = np.arange(sides)
    n = (k + 1) % sides
    first = np.stack([k, n, n + sides], axis=-1)
    second = np.stack([k, n + sides, k + sides], axis=-1)
    return np.concatenate([circle, circle * inner]), np.concatenate([first, second])


def disc(sides: int = 16) -> tuple[Array, Array]:
    """Return a filled dot: points (V, 2) and triangles (T, 3)."""
    angles = np.arange(sides) * (2 * pi / sides)
    circle = np.stack([np.cos(angles), np.sin(angles)], axis=-1)
    k = np.arange(1, sides - 1)
    return circle, np.stack([np.zeros_like(k), k, k + 1], axis=-1)


def diamond() -> tuple[Array, Array]:
    """Return a filled diamond: points (4, 2) and triangles (2, 3)."""
    points = np.array([[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.0]])
    return points, np.array([[0, 1, 2], [0, 2, 3]])


def offending_runs(evaluation: Evaluation) -> Iterable[Array]:
    """Yield the stretches of the generatrix that lie beyond the axis, each (33, 3)."""
    surface = evaluation.surface
    radii = surface.profile.control_points[..., 0]
    # One-sided control points certify a one-sided curve: nothing to search for.
    if radii.min() >= 0.0 or radii.max() <= 0.0:
        return
    for stretch in evaluation.axis_crossings:
        s = np.linspace(stretch.s0, stretch.s1, 33)
        points = surface.profile.point(stretch.segment, s)
        yield in_profile_plane(surface, points)


def is_closed(surface: RevolutionSurface) -> bool:
    """Whether no inside can be seen: a full turn of a profile with both ends on the axis."""
    profile = surface.profile
    points = profile.control_points
    radii = points[..., 0]
    near = 1e-9 * profile.size
    at_axis = max(abs(radii[0, 0]), abs(radii[-1, 3])) <= near
    joined = np.abs(points[:-1, 3] - points[1:, 0]).max(initial=0.0) <= near
    whole = surface.is_full_turn and joined and (at_axis or profile.closed)
    return bool(whole and (radii.min() >= 0.0 or radii.max() <= 0.0))
