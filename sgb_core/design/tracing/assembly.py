"""The points as the search sees them, and the chain of what it finds between corners."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.design.tracing.chain import Chain, Layout
from sgb_core.design.tracing.corners import Corner
from sgb_core.design.tracing.feet import Feet
from sgb_core.design.tracing.gaps import gap_places
from sgb_core.design.tracing.guide import Guide, guide_of
from sgb_core.design.tracing.prepare import Prepared
from sgb_core.design.tracing.search import fewest
from sgb_core.design.tracing.solver import Cloud, State, joined, measured
from sgb_core.design.tracing.thinning import thinned
from sgb_core.values import dataclass

_SAME = 1e-9


def cloud_of(ready: Prepared, guide: Guide) -> Cloud:
    """Return the points with, in their gaps, the places that a curve is not to leave far."""
    points = ready.points
    swept = np.abs(points[:, 0]) * np.gradient(guide.along) * ready.weights
    shares = swept / float(swept.sum())
    places, numbers, slack = gap_places(points, ready.tolerance)
    own = np.arange(len(points), dtype=np.float64)
    order = np.argsort(np.concatenate([own, numbers]), kind="stable")
    none = np.zeros(len(places))
    return Cloud(
        np.concatenate([points, places])[order],
        np.concatenate([ready.weights, none + 1.0])[order],
        np.concatenate([guide.along, np.interp(numbers, own, guide.along)])[order],
        np.concatenate([shares, none])[order],
        np.concatenate([np.zeros(len(points)), slack])[order],
        ready.tolerance,
    )


def begun_at(cloud: Cloud, start: float, length: float) -> Cloud:
    """Return the points of a closed outline numbered from another place on."""
    along = np.mod(cloud.along - start, length)
    order = np.argsort(along, kind="stable")
    return replace(cloud.part(order), along=along[order])


def assembled(
    ready: Prepared, guide: Guide, found: Sequence[Corner], cloud: Cloud
) -> tuple[State, Cloud]:
    """Return the chain of what was found between corners, and the points it was found for."""
    if ready.closed:
        start = found[0].along
        places = [corner.place for corner in (*found, found[0])]
        marks = [*(corner.along - start for corner in found), guide.length]
    else:
        places = [ready.points[0], *(corner.place for corner in found), ready.points[-1]]
        marks = [0.0, *(corner.along for corner in found), guide.length]
    states, clouds = [], []
    for k, (low, high) in enumerate(pairwise(marks)):
        last = k == len(marks) - 2
        own = cloud.part(np.flatnonzero((cloud.along >= low) & ((cloud.along < high) | last)))
        own, path = thinned(own), _path(own, places[k], places[k + 1], low, high)
        states.append(fewest(replace(own, along=path.lengths_at(own.along)), path.guide))
        clouds.append(own)
    counts = [state.chain.layout.count for state in states]
    nodes = np.cumsum(counts)
    corners = set(nodes[:-1].tolist()) | ({0} if ready.closed else set())
    layout = Layout(int(nodes[-1]), closed=ready.closed, corners=frozenset(corners))
    chain = Chain(layout, np.concatenate([state.chain.frames for state in states]))
    segment = [
        state.feet.segment + first for state, first in zip(states, nodes - counts, strict=True)
    ]
    feet = Feet(np.concatenate(segment), np.concatenate([state.feet.s for state in states]))
    few = joined(clouds)
    return measured(chain, few, feet), few


@dataclass(frozen=True, slots=True)
class _Path:
    """The guide between two corners, and which lengths along the whole one its knots have."""

    guide: Guide
    along: Floats

    def lengths_at(self, along: Floats) -> Floats:
        """Return the lengths along this guide for lengths along the whole one."""
        return np.interp(along, self.along, self.guide.along)


def _path(own: Cloud, start: Floats, end: Floats, low: float, high: float) -> _Path:
    real = (own.slack == 0.0) & (own.along > low) & (own.along < high)
    points = np.concatenate([[start], own.points[real], [end]])
    along = np.concatenate([[low], own.along[real], [high]])
    apart = np.append(True, np.hypot(*np.diff(points, axis=0).T) > _SAME)
    apart[-1] = True
    return _Path(guide_of(points[apart], own.tolerance), along[apart])
