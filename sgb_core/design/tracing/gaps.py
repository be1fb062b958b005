"""What a curve may do where there are no points: places it is not to leave far."""

from __future__ import annotations

import numpy as np

from sgb_core.arrays import Floats

# A step is a gap where it is longer than so many tolerances and so many usual steps;
_TOLERANCES, _STEPS = 3.0, 4.0
# where there are as few points as this, every step that is long enough is one.
_FEW = 60
_MOST_PLACES = 8
# A curve may leave the chord of a gap by this many tolerances, and by this part of the chord for
# each radian that the path turns at its ends: somewhat more than the sagitta of an arc, 1/8.
_SLACK, _SAGITTA = 0.5, 0.16


def gap_places(points: Floats, tolerance: float) -> tuple[Floats, Floats, Floats]:
    """Return (places, numbers, slacks) of the chords of gaps among ordered points (N, 2).

    ``numbers`` say where they belong, as fractions between the numbers of the points; a curve
    that leaves a place by less than its slack does nothing wrong.
    """
    chords = np.diff(points, axis=0)
    lengths = np.hypot(chords[:, 0], chords[:, 1])
    usual = float(np.median(lengths))
    least = _TOLERANCES * tolerance
    if len(points) > _FEW:
        least = max(least, _STEPS * usual)
    gaps = np.flatnonzero(lengths > least)
    if not len(gaps):
        return np.zeros((0, 2)), np.zeros(0), np.zeros(0)
    turns = _turns(chords)
    slack = tolerance * _SLACK + _SAGITTA * lengths * np.minimum(turns[:-1], turns[1:])
    places, numbers, slacks = [], [], []
    for gap in gaps.tolist():
        many = int(np.clip(round(lengths[gap] / usual), 1, _MOST_PLACES))
        part = (np.arange(many) + 0.5) / many
        places.append(points[gap] + part[:, None] * chords[gap])
        numbers.append(gap + part)
        slacks.append(np.full(many, slack[gap]))
    return np.concatenate(places), np.concatenate(numbers), np.concatenate(slacks)


def _turns(chords: Floats) -> Floats:
    """Return by how many radians the path turns at each point; the ends as their next but one."""
    cross = chords[:-1, 0] * chords[1:, 1] - chords[:-1, 1] * chords[1:, 0]
    inner = np.abs(np.arctan2(cross, (chords[:-1] * chords[1:]).sum(axis=1)))
    if not len(inner):
        return np.zeros(2)
    second, last = inner[min(1, len(inner) - 1)], inner[max(len(inner) - 2, 0)]
    return np.concatenate([[second], inner, [last]])
