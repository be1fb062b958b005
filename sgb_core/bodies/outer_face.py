"""Which part of a section is its outer face, on which a relief may stand."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import pairwise
from math import cos, radians

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.bodies.cross_section import CrossSection
from sgb_core.bodies.outline import Piece, Role, Trace
from sgb_core.bodies.solid import BodyKind, Solid, WallSide
from sgb_core.surfaces.normals import end_tangents
from sgb_core.surfaces.relief import Run
from sgb_core.surfaces.revolution import RevolutionSurface
from sgb_core.surfaces.uv import UVMap
from sgb_core.values import dataclass

# A corner by less is smoothed over: both of its sides move along their common normal.
KINK = radians(10.0)
# Beside a wall's arc nothing is.
_SMOOTH = radians(1e-3)
# Shares of the length that are one.
_SAME = 1e-9
# Of the size: a gap between segments.
_GAP = 1e-6

Share = Callable[[int, Floats], Floats]


@dataclass(frozen=True, slots=True)
class OuterFace:
    """Where the rows of a body's outer face lie on the generatrix.

    ``role`` is that of the pieces on the outside; ``numbers`` are the profile's segments from foot
    to rim, whose parameters are turned round where ``reverse``. ``share`` says where on the
    generatrix a segment's parameters lie.
    """

    role: Role
    numbers: tuple[int, ...]
    reverse: bool
    share: Share

    @classmethod
    def of(cls, section: CrossSection, solid: Solid, share: Share) -> OuterFace:
        """Return the outer face of a body."""
        outside = solid.kind is BodyKind.VESSEL and solid.side is WallSide.OUTSIDE
        meridian = section.meridian
        return cls(Role.WALL if outside else Role.DRAWN, meridian.numbers, meridian.reverse, share)

    def shares(self, role: Role, place: int, u: Floats) -> Floats:
        """Return the shares of samples of a piece, not a number off the outer face."""
        number = place // 2
        if role is not self.role or place % 2 or not 0 <= number < len(self.numbers):
            return np.full(len(u), np.nan)
        return self.share(self.numbers[number], 1.0 - u if self.reverse else u)

    def parameters(self, piece: Piece, s: Floats) -> Floats:
        """Return where on a piece a segment's parameters lie, increasing; none off the face."""
        if piece.role is not self.role or not isinstance(piece, Trace):
            return np.zeros(0)
        return np.sort(1.0 - s if self.reverse else s)

    def runs(self, section: CrossSection) -> tuple[Run, ...]:
        """Return the runs of shares along which a section's outer face has no kink."""
        found = []
        for outline in section.outlines:
            for piece in (piece for ring in outline.rings for piece in ring):
                if piece.role is not self.role or not isinstance(piece, Trace):
                    continue
                u = np.sort(np.array([piece.start, piece.end]))
                shares, ways = self.shares(piece.role, piece.place, u), piece.tangents(u)
                if shares[0] > shares[1]:
                    shares, ways = shares[::-1], -ways[::-1]
                found.append((shares, ways, piece.points(u)[:: -1 if self.reverse else 1]))
        found.sort(key=lambda each: float(each[0][0]))
        smooth = KINK if self.role is Role.DRAWN else _SMOOTH
        return joined_runs(found, smooth, _GAP * section.meridian.size)


def drawn_runs(surface: RevolutionSurface, uv_map: UVMap) -> tuple[Run, ...]:
    """Return the runs of a bare surface: between its ends, kinks and places on the axis."""
    profile = surface.profile
    size = profile.size
    quartics = profile.quartics
    starts, ends = end_tangents(quartics, size)
    borders = uv_map.borders
    found = [
        (borders[k : k + 2], np.stack([starts[k], ends[k]]), quartics[k][[0, 4]])
        for k in range(len(profile))
    ]
    runs = joined_runs(found, KINK, _GAP * size)
    radius, shares = uv_map.points[:, 0], uv_map.shares
    crossing = np.flatnonzero(radius[1:] * radius[:-1] < 0.0)
    cuts = shares[crossing] + np.diff(shares)[crossing] / 2.0
    return tuple(
        (float(low), float(high))
        for first, last in runs
        for low, high in _divided(first, last, cuts)
    )


def _divided(first: float, last: float, cuts: Floats) -> list[Run]:
    marks = [first, *cuts[(cuts > first) & (cuts < last)].tolist(), last]
    return list(pairwise(marks))


def joined_runs(
    found: Sequence[tuple[Floats, Floats, Floats]], smooth: float, gap: float
) -> tuple[Run, ...]:
    """Return increasing stretches as runs, joined where the next goes on smoothly.

    Each has shares (2,), unit tangents (2, 2) and points (2, 2) of its ends. A place on the axis
    divides.
    """
    runs: list[list[float]] = []
    last: tuple[Floats, Floats, Floats] | None = None
    for each in found:
        shares, ways, points = each
        goes_on = (
            last is not None
            and abs(float(shares[0] - last[0][1])) <= _SAME
            and float(np.dot(ways[0], last[1][1])) >= cos(smooth)
            and float(np.hypot(*(points[0] - last[2][1]))) <= gap
            and abs(float(points[0, 0])) > gap
        )
        if goes_on:
            runs[-1][1] = float(shares[1])
        else:
            runs.append([float(shares[0]), float(shares[1])])
        last = each
    return tuple((low, high) for low, high in runs)
