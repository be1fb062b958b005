"""First chains for given cuts, from which the search for the best one starts."""

from __future__ import annotations

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.design.tracing.breaks import near_quartics
from sgb_core.design.tracing.chain import END_ANGLE, START_ANGLE, Chain, Layout, frames_of
from sgb_core.design.tracing.feet import Feet
from sgb_core.design.tracing.guide import Guide

# Stations of the guide for each segment, and at least.
_PER_SEGMENT, _STATIONS = 12, 96


def hermite_start(guide: Guide, cuts: Floats, along: Floats) -> tuple[Chain, Feet]:
    """Return an open chain and the feet on it of points at the lengths ``along`` (N,).

    It is the nearest C1 chain of cubics in the length along the guide, cut at the lengths
    ``cuts``, shape (count + 1,); its ends are the guide's.
    """
    count = len(cuts) - 1
    lengths = np.diff(cuts)
    marks = np.linspace(0.0, guide.length, max(_STATIONS, _PER_SEGMENT * count))
    stations = guide.at(marks)
    piece = np.clip(np.searchsorted(cuts, marks, side="right") - 1, 0, count - 1)
    s = (marks - cuts[piece]) / lengths[piece]
    rows = np.arange(len(marks))
    matrix = np.zeros((len(marks), 2 * count + 2))
    # Hermite's basis: places of the nodes first, then derivatives by the length.
    matrix[rows, piece] = (1.0 + 2.0 * s) * (1.0 - s) ** 2
    matrix[rows, piece + 1] = s * s * (3.0 - 2.0 * s)
    matrix[rows, count + 1 + piece] = s * (1.0 - s) ** 2 * lengths[piece]
    matrix[rows, count + 2 + piece] = s * s * (s - 1.0) * lengths[piece]
    solution = np.zeros((2 * count + 2, 2))
    ends = [0, count]
    solution[ends] = guide.knots[[0, -1]]
    free = np.setdiff1d(np.arange(2 * count + 2), ends)
    wanted = stations - matrix[:, ends] @ solution[ends]
    solution[free] = np.linalg.lstsq(matrix[:, free], wanted, rcond=None)[0]
    nodes, slopes = solution[: count + 1], solution[count + 1 :]
    chord = np.diff(nodes, axis=0)
    # A station too few leaves a slope without a say.
    flat = np.hypot(slopes[:, 0], slopes[:, 1]) < 1e-3
    slopes[flat] = (
        np.concatenate([chord, chord[-1:]])[flat] / np.append(lengths, lengths[-1])[flat, None]
    )
    legs = slopes[:-1] * lengths[:, None] / 4.0, slopes[1:] * lengths[:, None] / 4.0
    points = np.empty((count, 5, 2))
    points[:, 0], points[:, 4] = nodes[:-1], nodes[1:]
    points[:, 1], points[:, 3] = nodes[:-1] + legs[0], nodes[1:] - legs[1]
    points[:, 2] = (points[:, 0] + points[:, 4]) / 2.0 + (legs[0] - legs[1]) * (2.0 / 3.0)
    return Chain(Layout(count), frames_of(points)), feet_along(along, cuts)


def quartic_start(guide: Guide, cuts: Floats, along: Floats) -> tuple[Chain, Feet]:
    """Return an open chain as ``hermite_start`` does, of the quartic nearest to each stretch.

    They are moved to meet half way, and turned to the mean of their directions there.
    """
    points, _ = near_quartics(guide, cuts[:-1], cuts[1:])
    first, last = points[:, 1] - points[:, 0], points[:, 4] - points[:, 3]
    pulls = [np.hypot(leg[:, 0], leg[:, 1]) for leg in (first, last)]
    chord = points[:, 4] - points[:, 0]
    units = [
        np.where((pull > 0.0)[:, None], leg, chord) / np.where(pull > 0.0, pull, 1.0)[:, None]
        for leg, pull in zip((first, last), pulls, strict=True)
    ]
    directions = np.concatenate([units[0][:1], units[1][:-1] + units[0][1:], units[1][-1:]])
    angles = np.unwrap(np.arctan2(directions[:, 1], directions[:, 0]))
    directions = np.stack([np.cos(angles), np.sin(angles)], axis=1)
    nodes = np.concatenate(
        [guide.knots[:1], 0.5 * (points[:-1, 4] + points[1:, 0]), guide.knots[-1:]]
    )
    points[:, 2] += 0.5 * (nodes[:-1] - points[:, 0] + nodes[1:] - points[:, 4])
    points[:, 0], points[:, 4] = nodes[:-1], nodes[1:]
    points[:, 1] = points[:, 0] + pulls[0][:, None] * directions[:-1]
    points[:, 3] = points[:, 4] - pulls[1][:, None] * directions[1:]
    frames = frames_of(points)
    frames[:, START_ANGLE], frames[:, END_ANGLE] = angles[:-1], angles[1:]
    return Chain(Layout(len(points)), frames), feet_along(along, cuts)


def feet_along(along: Floats, cuts: Floats) -> Feet:
    """Return feet at lengths ``along`` (N,) where the segments are cut at ``cuts``."""
    count = len(cuts) - 1
    piece = np.clip(np.searchsorted(cuts, along, side="right") - 1, 0, count - 1)
    return Feet(piece, np.clip((along - cuts[piece]) / np.diff(cuts)[piece], 0.0, 1.0))
