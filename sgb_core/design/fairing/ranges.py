"""What each leg fraction may be while a chain is made fair."""

from __future__ import annotations

from collections.abc import Collection, Sequence

import numpy as np
from numpy.typing import NDArray

from sgb_core.arrays import Floats
from sgb_core.curves.profile import JointRule, Profile
from sgb_core.curves.segment import DEGENERATE_LEG
from sgb_core.design.demands.chain import Chain
from sgb_core.design.fairing.energy import Energy
from sgb_core.design.fairing.finite import are_finite, are_straight
from sgb_core.design.fairing.segments import LEAST, Box, quartics_of
from sgb_core.surfaces.laws.law import Law
from sgb_core.values import dataclass

# At a G2 joint both fractions stay this large: the equation, cleared of its denominators, would
# also be met where a curvature grows without bound.
_LEAST_CURVED = 1e-3
_PARTS = ("lambda1", "lambda2", "lambda3")


@dataclass(frozen=True, slots=True)
class Ranges:
    """The box of each segment's fractions, ``low`` and ``high`` (n, 3), and what cannot be fair.

    ``present`` (n, 3) are the fractions before; ``endless`` the segments whose energy is infinite
    whatever their fractions.
    """

    box: Box
    present: Floats
    endless: tuple[int, ...]

    @property
    def moving(self) -> NDArray[np.bool_]:
        """Which segments have a fraction to change, shape (n,): to choose, or to set right."""
        low, high = self.box.low, self.box.high
        return np.asarray(((low < high) | (self.present < low) | (self.present > high)).any(axis=1))


def ranges(
    chain: Chain,
    profile: Profile,
    energy: Energy,
    segments: Collection[int],
    laws: Sequence[Law] = (),
) -> Ranges:
    """Return what the fractions of these segments may be, the others staying as they are.

    A parameter that a law governs stays at its value at θ = 0, and ω with it. Where a leg has no
    length, its energy is finite only with the far fraction at 1 (the variation's also with the
    curvature stationary: b = 2/3). A G2 joint between polygons that turn to different sides has
    no curvature: Q2 lies on P2 before it and on P1 after it.
    """
    low, high = chain.fractions.copy(), chain.fractions.copy()
    straight = are_straight(chain.points)
    for k in sorted(segments):
        omega = profile.segments[k].shape.omega
        least, most = _reach(omega, low[k], [law for law in laws if law.applies_to(k)])
        least, most = _with_still_ends(energy, chain.points[k], least, most)
        if not straight[k] and (least <= most).all():
            low[k], high[k] = least, most
    finite = are_finite(energy, quartics_of(chain.points, (low + high) / 2.0))
    low[~finite] = high[~finite] = chain.fractions[~finite]
    _prepare_curvatures(chain, profile, low, high)
    return Ranges(Box(low, high), chain.fractions, tuple(np.flatnonzero(~finite).tolist()))


def _reach(omega: float, fractions: Floats, laws: Sequence[Law]) -> tuple[Floats, Floats]:
    if not laws:
        return np.array([LEAST, 0.0, LEAST]), np.ones(3)
    # Away from the cubic's fractions by what ω allows.
    low = np.array([0.75 * (1.0 - omega), 0.5 * (1.0 - omega), 0.75 * (1.0 - omega)])
    high = np.array([0.25 * (3.0 + omega), 0.5 * (1.0 + omega), 0.25 * (3.0 + omega)])
    for k, name in enumerate(_PARTS):
        if any(law.parameter == name for law in laws):
            low[k] = high[k] = fractions[k]
    return np.maximum(low, [LEAST, 0.0, LEAST]), high


def _with_still_ends(
    energy: Energy, points: Floats, low: Floats, high: Floats
) -> tuple[Floats, Floats]:
    """Return the ranges in which ends whose leg has no length have a finite energy."""
    low, high = low.copy(), high.copy()
    for end, leg, own, far in ((0, 1, 0, 2), (3, 2, 2, 0)):
        step = points[leg] - points[end]
        if np.hypot(step[0], step[1]) > DEGENERATE_LEG:
            continue
        low[own] = high[own] = min(max(0.75, low[own]), high[own])
        if energy is Energy.SURFACE and abs(points[end, 0]) <= DEGENERATE_LEG:
            continue
        low[far] = high[far]
        if high[far] < 1.0:
            low[far] = 2.0
        if energy is Energy.VARIATION:
            wanted = 2.0 / 3.0 if end == 0 else 1.0 / 3.0
            low[1], high[1] = max(low[1], wanted), min(high[1], wanted)
    return low, high


def _prepare_curvatures(chain: Chain, profile: Profile, low: Floats, high: Floats) -> None:
    points = chain.points
    legs = np.diff(points, axis=1)
    turns = legs[:, :-1, 0] * legs[:, 1:, 1] - legs[:, :-1, 1] * legs[:, 1:, 0]
    for joint, rule in enumerate(profile.rules):
        if rule is not JointRule.G2:
            continue
        before, after = profile.neighbours(joint)
        for segment, end in ((before, 2), (after, 0)):
            if low[segment, end] < high[segment, end]:
                low[segment, end] = max(low[segment, end], _LEAST_CURVED)
        if turns[before, 1] * turns[after, 0] > 0.0:
            continue
        if turns[before, 1] != 0.0 and low[before, 1] <= 0.0:
            high[before, 1] = 0.0
        if turns[after, 0] != 0.0 and high[after, 1] >= 1.0:
            low[after, 1] = 1.0
