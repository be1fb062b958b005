"""Whether a chain stays near the path also between its points."""

from __future__ import annotations

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.design.tracing.feet import Feet, followed
from sgb_core.design.tracing.solver import Cloud, State

# Where a chain is looked at between the feet of neighbouring points.
_BETWEEN = (0.25, 0.5, 0.75)
# How far it may be from their chord: so many tolerances, and this part of the chord.
_SLACK, _SAGITTA = 1.5, 0.25
# Feet closer than this, in s, leave no room to stray.
_ROOM = 0.01


def fault(state: State, cloud: Cloud) -> float:
    """Return the largest distance in tolerances, or above 1 how far the chain strays, if more."""
    return max(state.largest, _straying(state, cloud))


def _straying(state: State, cloud: Cloud) -> float:
    count = state.chain.layout.count
    real = np.flatnonzero(cloud.slack == 0.0)
    place = (state.feet.segment + state.feet.s)[real]
    steps = np.diff(place)
    if state.chain.layout.closed:
        steps -= count * np.round(steps / count)
    wide = np.flatnonzero(np.abs(steps) > _ROOM)
    if not len(wide):
        return 0.0
    start, end = cloud.points[real[wide]], cloud.points[real[wide + 1]]
    chord = end - start
    length = np.hypot(chord[:, 0], chord[:, 1])
    off = np.abs(state.distances[real])
    allowed = _SLACK + np.maximum(off[wide], off[wide + 1]) + _SAGITTA * length / cloud.tolerance
    worst = 0.0
    for part in _BETWEEN:
        middle = np.clip(place[wide] + part * steps[wide], 0.0, None) % count
        segment = np.minimum(middle.astype(np.intp), count - 1)
        found = followed(state.chain.quartics, Feet(segment, middle - segment))[0].T
        distance = _to_chord(found, start, chord, length) / cloud.tolerance
        worst = max(worst, float((distance - allowed).max()))
    return 1.0 + worst if worst > 0.0 else 0.0


def _to_chord(points: Floats, start: Floats, chord: Floats, length: Floats) -> Floats:
    part = ((points - start) * chord).sum(axis=1) / np.maximum(length**2, 1e-300)
    off = points - start - np.clip(part, 0.0, 1.0)[:, None] * chord
    return np.asarray(np.hypot(off[:, 0], off[:, 1]))
