"""How finely a twisted body is sampled along its height, so that its mesh stays near helices.

Between two samples that are turned by Δτ against each other, Δr apart, a straight edge lies off
the twisted curve by r Δτ²/8 and Δτ Δr/4; beside a column whose radius jumps by Δr it is the same
again. Shares of the tolerance add up with those of the untwisted mesh.
"""

from __future__ import annotations

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.surfaces.revolution import RevolutionSurface
from sgb_core.surfaces.turn import column_angles
from sgb_core.surfaces.twist import Twisting
from sgb_core.values import dataclass

# The rest of the mesh is made for this part of the tolerance where there is a twist.
UNTWISTED = 0.5
# A row's turn against the next as a part of a column's: chords across both are 1.4 columns wide.
_OF_A_COLUMN = 0.4
# The part of the tolerance that a corner cut off may take.
_CUT = 0.1
_PLACES = np.linspace(0.0, 1.0, 33)


@dataclass(frozen=True, slots=True)
class HelixLimits:
    """The largest Δτ between two samples, and the largest Δτ·Δr; None where Δr is free."""

    turn: float
    slant: float | None

    def refined(self, u: Floats, points: Floats, twisting: Twisting) -> Floats:
        """Return parameters with others between them, even ones, where two are too far apart.

        ``points`` (k, 2) are the (r, h) at ``u``; between two they run nearly straight.
        """
        if len(u) < 2:
            return u
        angle = twisting.angle(points[:, 1])
        step = np.abs(np.diff(angle))
        parts = step / self.turn
        if self.slant is not None:
            across = np.abs(np.diff(points[:, 0]))
            parts = np.maximum(parts, np.sqrt(step * across / self.slant))
            middle = twisting.angle((points[1:, 1] + points[:-1, 1]) / 2.0)
            bend = np.abs(middle - (angle[1:] + angle[:-1]) / 2.0)
            widest = np.maximum(np.abs(points[1:, 0]), np.abs(points[:-1, 0]))
            parts = np.maximum(parts, np.sqrt(4.0 * bend * widest / self.slant))
        counts = np.maximum(np.ceil(parts - 1e-9), 1.0).astype(np.int64)
        if counts.max() == 1:
            return u
        start = np.repeat(u[:-1], counts)
        wide = np.repeat(np.diff(u) / counts, counts)
        number = np.arange(len(start)) - np.repeat(np.cumsum(counts) - counts, counts)
        return np.append(start + wide * number, u[-1])


def helix_limits(surface: RevolutionSurface, columns: int, tolerance: float) -> HelixLimits:
    """Return how far apart samples along a section may be where ``columns`` stand around."""
    angles = column_angles(surface, columns)
    turn = _OF_A_COLUMN * float(
        np.diff(angles).min() if not surface.laws else np.median(np.diff(angles))
    )
    if not surface.laws and surface.is_full_turn:
        return HelixLimits(turn, None)
    if surface.laws:
        radii = surface.sections(angles).on(np.linspace(0.0, 1.0, 5))[..., 0]
        jump = float(np.abs(np.diff(radii, axis=0)).max())
        if jump > 0.0:
            turn = min(turn, 4.0 * _CUT * tolerance / jump)
    return HelixLimits(turn, 4.0 * _CUT * tolerance)


def twisted_counts(
    surface: RevolutionSurface, counts: Floats, columns: int, tolerance: float
) -> Floats:
    """Return the equal intervals of each segment that a twist needs, at least ``counts``."""
    twisting = surface.twisting
    if twisting is None:
        return counts
    limits = helix_limits(surface, columns, tolerance)
    angles = surface.sweep * np.linspace(0.0, 1.0, 9)
    sections = surface.sections(angles)
    found = counts.copy()
    for number in range(len(found)):
        for row in range(len(angles) if surface.laws else 1):
            section = sections[row, number]
            points, rate = section.on(_PLACES), section.on(_PLACES, 1)
            turn = np.abs(twisting.rate(points[:, 1]) * rate[:, 1])
            least = float(turn.max()) / limits.turn
            if limits.slant is not None:
                slant = float((turn * np.abs(rate[:, 0])).max()) / limits.slant
                bend = np.abs(np.gradient(twisting.rate(points[:, 1]) * rate[:, 1], _PLACES))
                round_ = float((np.abs(points[:, 0]) * bend).max()) / (2.0 * limits.slant)
                least = max(least, np.sqrt(slant), np.sqrt(round_))
            found[number] = max(found[number], np.ceil(least - 1e-9))
    return found
