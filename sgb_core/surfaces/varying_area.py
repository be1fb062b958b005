"""The area of a surface whose shape parameters vary with the angle: adaptive in both variables.

The integrand √((r |L'|)² + J²), J = r_s h_θ − h_s r_θ, with a twist τ(h)
√((r h_s)² + J² + r² (r_s + τ' J)²), is smooth but for tight bends, which can stand
anywhere, and near angles at which an end derivative vanishes. Boxes of the (θ, s) plane are halved
across the variable in which they are rougher until both halvings agree.
"""

from __future__ import annotations

from math import pi

import numpy as np

from sgb_core.arrays import Floats, distinct
from sgb_core.curves.nodes import gauss
from sgb_core.surfaces.angular import angle_edges, different_angles
from sgb_core.surfaces.curvature import cross
from sgb_core.surfaces.revolution import RevolutionSurface

# Gauss points of a box across the angle and along the segment.
_ACROSS, _ALONG = 8, 10
# Of the whole; what is left beyond a halving that agrees to this is smaller by far.
_RELATIVE = 1e-11
_MOST_ROUNDS = 60
# Boxes evaluated at a time, which bounds the memory, and those open at most: a function that
# needs more is known no better.
_AT_ONCE = 1024
_MOST_OPEN = 30_000


def varying_area(surface: RevolutionSurface, number: int) -> float:
    """Return the area that segment ``number`` sweeps under its laws, in unit²."""
    edges, repeats = _once(surface)
    across = np.stack([edges[:-1], edges[1:]], axis=1)
    # Where all angles cross the heights of keys alike, no box lies across one.
    marks = distinct([0.0, 0.5, 1.0], surface.sections(edges[0], numbers=[number])[0].breaks())
    along = np.stack([marks[:-1], marks[1:]], axis=1)
    boxes = np.concatenate(
        [np.repeat(across, len(along), axis=0), np.tile(along, (len(across), 1))], axis=1
    )
    values = _integrals(surface, number, boxes)
    scale, total = float(values.sum()), 0.0
    for _ in range(_MOST_ROUNDS):
        if not len(boxes):
            break
        turned, run = _halved(boxes, 0), _halved(boxes, 2)
        by_turn = _integrals(surface, number, turned.reshape(-1, 4)).reshape(-1, 2)
        by_run = _integrals(surface, number, run.reshape(-1, 4)).reshape(-1, 2)
        off_turn = np.abs(by_turn.sum(axis=1) - values)
        off_run = np.abs(by_run.sum(axis=1) - values)
        open_ = np.maximum(off_turn, off_run) > _RELATIVE * max(scale, total)
        finer = np.where((off_turn > off_run)[:, None], by_turn, by_run)
        # What both halvings change adds up where both are small.
        settled = by_turn.sum(axis=1) + by_run.sum(axis=1) - values
        total += float(settled[~open_].sum())
        if open_.sum() > _MOST_OPEN:
            return repeats * (total + float(finer[open_].sum()))
        halves = np.where((off_turn > off_run)[:, None, None], turned, run)
        boxes, values = halves[open_].reshape(-1, 4), finer[open_].ravel()
    return repeats * (total + float(values.sum() if len(boxes) else 0.0))


def _once(surface: RevolutionSurface) -> tuple[Floats, int]:
    """Return the edges of what repeats itself round the turn, and how often it does."""
    edges = angle_edges(surface, bare=True)
    _, low, wedge = different_angles(surface, np.zeros(1))
    if surface.twisting is not None:
        # A twisted wave is no mirror image of itself: the whole of it repeats.
        wedge *= 2.0
    if not (np.isfinite(wedge) and surface.is_full_turn):
        return edges, 1
    inside = edges[(edges > low) & (edges < wedge - 1e-9)]
    return np.concatenate([[low], inside, [wedge]]), round(2.0 * pi / wedge)


def _halved(boxes: Floats, axis: int) -> Floats:
    """Return both halves of boxes (θ0, θ1, s0, s1), shape (k, 2, 4), across one variable."""
    middle = (boxes[:, axis] + boxes[:, axis + 1]) / 2.0
    halves = np.stack([boxes, boxes], axis=1)
    halves[:, 0, axis + 1] = halves[:, 1, axis] = middle
    return halves


def _integrals(surface: RevolutionSurface, number: int, boxes: Floats) -> Floats:
    """Return the integral over each box (θ0, θ1, s0, s1), shape (k,)."""
    parts = [
        _some(surface, number, boxes[k : k + _AT_ONCE]) for k in range(0, len(boxes), _AT_ONCE)
    ]
    return np.concatenate(parts)


def _some(surface: RevolutionSurface, number: int, boxes: Floats) -> Floats:
    turn_nodes, turn_weights = gauss(_ACROSS)
    run_nodes, run_weights = gauss(_ALONG)
    spread, reach = boxes[:, 1] - boxes[:, 0], boxes[:, 3] - boxes[:, 2]
    theta = boxes[:, 0, None] + spread[:, None] * turn_nodes
    s = boxes[:, 2, None] + reach[:, None] * run_nodes
    sections, at = surface.sections(theta, numbers=[number]).of_segment(0), s[:, None]
    points, velocity, change = sections.on(at), sections.on(at, 1), sections.changes_on(at)
    radius = points[..., 0]
    slip = cross(change, velocity)
    if surface.twisting is None:
        density = np.hypot(radius * np.hypot(velocity[..., 0], velocity[..., 1]), slip)
    else:
        rate = surface.twisting.rate(points[..., 1])
        leaning = radius * (velocity[..., 0] - rate * slip)
        density = np.hypot(np.hypot(radius * velocity[..., 1], slip), leaning)
    return np.asarray(spread * reach * ((density @ run_weights) @ turn_weights))
