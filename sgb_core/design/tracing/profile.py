"""A traced chain as a profile of ordinary segments."""

from __future__ import annotations

import numpy as np

from sgb_core.curves.conversion import Leg, to_segment
from sgb_core.curves.profile import JointRule, Profile
from sgb_core.curves.segment import READY, Segment, ShapeParameters
from sgb_core.design.tracing.chain import END_ANGLE, END_PULL, START_ANGLE, START_PULL, Chain
from sgb_core.design.tracing.prepare import Prepared

# A shape parameter of less is 0.
_ROUNDING = 1e-12


def profile_of(chain: Chain, ready: Prepared, rule: JointRule = JointRule.G1) -> Profile:
    """Return the chain in the coordinates that its points were given in."""
    layout = chain.layout
    quartics = ready.restored(chain.quartics)
    segments = []
    for k in range(layout.count):
        frame, quartic = chain.frames[k], quartics[k]
        if k in layout.straight:
            part = np.linspace(0.0, 1.0, 4)[:, None]
            points = quartic[0] + part * (quartic[4] - quartic[0])
            segments.append(Segment(points, READY))
            continue
        start = Leg(_unit(frame[START_ANGLE]), frame[START_PULL] * ready.size)
        end = Leg(-_unit(frame[END_ANGLE]), frame[END_PULL] * ready.size)
        # The frame says that there is one: the error is rounding.
        found = to_segment(quartic, start, end)[0]
        segments.append(found.with_shape(_told(found.shape)))
    joints = range(1, layout.nodes) if layout.closed else range(1, layout.count)
    rules = [JointRule.G0 if k in layout.corners else rule for k in joints]
    if layout.closed:
        rules.append(JointRule.G0 if 0 in layout.corners else rule)
    return Profile(tuple(segments), tuple(rules), layout.closed)


def _told(shape: ShapeParameters) -> ShapeParameters:
    """Return shape parameters of which none is rounding alone."""
    lambda1, lambda2, lambda3 = (
        value if value > _ROUNDING else 0.0
        for value in (shape.lambda1, shape.lambda2, shape.lambda3)
    )
    return ShapeParameters(lambda1, lambda2, lambda3, shape.omega)


def _unit(angle: float) -> np.ndarray:
    # At multiples of π exactly level.
    return np.array([np.cos(angle), np.sin(angle) if angle % np.pi else 0.0])
