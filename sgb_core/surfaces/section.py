"""Cross-sections to sweep: polylines with exact one-sided normals, breaks and arc length.

A generatrix, the polygon of a vessel's wall and one section per angle where laws hold all take
the same way: smooth pieces are assembled into a :class:`Section`, which the tessellator sweeps.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import accumulate, pairwise

import numpy as np
from numpy.typing import NDArray

from sgb_core.arrays import Floats, Ints
from sgb_core.findings.errors import FindingError
from sgb_core.findings.surfaces import NoSurface
from sgb_core.surfaces.grid import varying_normals
from sgb_core.surfaces.normals import radius_signs, unit_tangents
from sgb_core.surfaces.quadrature import derivative_rows, gauss, on_nodes
from sgb_core.surfaces.revolution import RevolutionSurface
from sgb_core.surfaces.turn import Turn
from sgb_core.surfaces.variation import varying_quartics

# Radii below this part of the size lie on the axis.
AXIS = 1e-9
# Samples closer than this part of the size are one: single precision still tells them apart.
MERGE = 1e-6


@dataclass(frozen=True, slots=True, eq=False)
class Piece:
    """A smooth stretch of a section: M versions (1, or one per column) of k samples.

    ``points`` (M, k, 2) are (r, h); ``normals`` (M, k, 3) unit components on e_ρ, e_θ, e_h,
    one-sided at the ends; ``lengths`` (M, k) the arc length from the piece's start.
    """

    points: Floats
    normals: Floats
    lengths: Floats


@dataclass(frozen=True, slots=True, eq=False)
class Section:
    """R render rows, ready to be swept.

    ``points``, ``normals`` and ``lengths`` as in :class:`Piece`, lengths as a share of the whole.
    ``rings`` (R,) number the welded rows: the two sides of a corner are two rows on one ring.
    ``linked`` (R − 1,) says where a strip leads from a row to the next, ``starts`` which rows begin
    a piece. ``merge`` is the distance below which samples are one.
    """

    points: Floats
    normals: Floats
    lengths: Floats
    rings: Ints
    linked: NDArray[np.bool_]
    starts: tuple[int, ...]
    merge: float


def assemble(pieces: Sequence[Piece], size: float, merge: float | None = None) -> Section:
    """Return the section of consecutive pieces.

    Radii within 1e-9·size of 0 become 0. Consecutive samples closer than ``merge`` (default
    1e-6·size) become one; a piece whose samples all do so vanishes. Pieces whose ends meet within
    that distance share a ring, also the last with the first. Raises FindingError if nothing is
    left.
    """
    merge = MERGE * size if merge is None else merge
    kept = [thinned for piece in pieces if (thinned := _thinned(_snapped(piece, size), merge))]
    if not kept:
        raise FindingError(NoSurface.POINT)
    rings: list[Ints] = []
    linked: list[NDArray[np.bool_]] = []
    count = 0
    for k, piece in enumerate(kept):
        meets = k > 0 and _distance(kept[k - 1].points[:, -1], piece.points[:, 0]) <= merge
        first = count - 1 if meets else count
        rings.append(first + np.arange(piece.points.shape[1]))
        count = int(rings[-1][-1]) + 1
        on_axis = (piece.points[..., 0] == 0.0).all(axis=0)
        linked.extend([np.zeros(min(k, 1), dtype=bool), ~(on_axis[1:] & on_axis[:-1])])
    numbers = np.concatenate(rings)
    foot, head = kept[0].points[:, 0], kept[-1].points[:, -1]
    # A pole closes itself; and fewer than three rings go out and back the same way.
    if count > 3 and foot[:, 0].any() and _distance(foot, head) <= merge:
        numbers[-1] = 0
    totals = np.array([piece.lengths[:, -1] for piece in kept])
    offsets = np.cumsum(totals, axis=0) - totals
    lengths = [piece.lengths + offset[:, None] for piece, offset in zip(kept, offsets, strict=True)]
    whole = totals.sum(axis=0)[:, None]
    return Section(
        points=np.concatenate([piece.points for piece in kept], axis=1),
        normals=np.concatenate([piece.normals for piece in kept], axis=1),
        lengths=np.concatenate(lengths, axis=1) / np.where(whole > 0.0, whole, 1.0),
        rings=numbers,
        linked=np.concatenate(linked),
        starts=tuple(accumulate((len(piece_rings) for piece_rings in rings[:-1]), initial=0)),
        merge=merge,
    )


def section_of(
    surface: RevolutionSurface, counts: Sequence[int], turn: Turn, merge: float | None = None
) -> Section:
    """Return the section of a surface with ``counts[k]`` equal steps of s in segment k.

    Where the profile crosses the axis a sample is added on it and the section breaks: the two
    sides face opposite ways. With laws there is one version per render column of ``turn``.
    """
    profile = surface.profile
    if len(counts) != len(profile) or min(counts) < 1:
        raise ValueError("at least one interval for each segment is needed")
    size = profile.size
    pieces: list[Piece] = []
    if surface.laws:
        quartics, rates = varying_quartics(profile, surface.laws, turn.angles, turn.sides)
        for k, count in enumerate(counts):
            pieces.append(_varying_piece(quartics[:, k], rates[:, k], count, size))
    else:
        for quartic, count in zip(profile.quartics, counts, strict=True):
            pieces.extend(_segment_pieces(quartic, count, size))
    return assemble(pieces, size, merge)


def _segment_pieces(quartic: Floats, count: int, size: float) -> list[Piece]:
    roots = _axis_crossings(quartic)
    s = np.union1d(np.linspace(0.0, 1.0, count + 1), roots)
    samples = s.tobytes()
    points, first, second = (derivative_rows(order, samples) @ quartic for order in range(3))
    points[np.isin(s, roots), 0] = 0.0
    tangents = unit_tangents(quartic, s, first, second, size)
    lengths = np.concatenate([[0.0], np.cumsum(_interval_lengths(quartic, s))])
    cuts = np.concatenate([[0], np.searchsorted(s, roots), [len(s) - 1]])
    pieces = []
    for start, stop in pairwise(cuts):
        part = slice(start, stop + 1)
        signs = radius_signs(points[part, 0], size)
        # The piece's own side, so that both its ends on the axis know it.
        sign = 1.0 if signs.sum() >= 0.0 else -1.0
        zero = np.zeros(stop + 1 - start)
        normals = np.stack([tangents[part, 1], zero, -tangents[part, 0]], axis=-1) * sign
        pieces.append(
            Piece(points[None, part], normals[None], (lengths[part] - lengths[start])[None])
        )
    return pieces


def _varying_piece(quartics: Floats, rates: Floats, count: int, size: float) -> Piece:
    s = np.linspace(0.0, 1.0, count + 1)
    matrices = tuple(derivative_rows(order, s.tobytes()) for order in range(3))
    points = matrices[0] @ quartics
    normals = varying_normals(quartics, rates, s, matrices, size)
    steps = np.diff(points, axis=1)
    chords = np.hypot(steps[..., 0], steps[..., 1])
    lengths = np.concatenate([np.zeros((len(points), 1)), np.cumsum(chords, axis=1)], axis=1)
    return Piece(points, normals, lengths)


def _axis_crossings(quartic: Floats) -> Floats:
    """Return the s inside a segment where r changes its sign."""
    r = quartic[:, 0]
    if r.min() >= 0.0 or r.max() <= 0.0:
        return np.zeros(0)
    power = np.array(
        [
            r[4] - 4.0 * r[3] + 6.0 * r[2] - 4.0 * r[1] + r[0],
            4.0 * (r[3] - 3.0 * r[2] + 3.0 * r[1] - r[0]),
            6.0 * (r[2] - 2.0 * r[1] + r[0]),
            4.0 * (r[1] - r[0]),
            r[0],
        ]
    )
    power[np.abs(power) < 1e-14 * np.abs(r).max()] = 0.0
    roots = np.roots(power)
    s = np.unique(roots[np.abs(roots.imag) < 1e-9].real)
    s = s[(s > 1e-9) & (s < 1.0 - 1e-9)]
    between = np.concatenate([[0.0], (s[1:] + s[:-1]) / 2.0, [1.0]]) if len(s) else np.zeros(1)
    if len(s):
        between[0], between[-1] = s[0] / 2.0, (1.0 + s[-1]) / 2.0
    sides = np.sign(on_nodes(quartic, between)[:, 0])
    return s[sides[1:] * sides[:-1] < 0.0]


def _interval_lengths(quartic: Floats, s: Floats) -> Floats:
    nodes, weights = gauss(8)
    inner = (s[:-1, None] + np.diff(s)[:, None] * nodes).ravel()
    velocity = on_nodes(quartic, inner, 1)
    speed = np.hypot(velocity[:, 0], velocity[:, 1]).reshape(-1, len(nodes))
    return np.asarray((speed @ weights) * np.diff(s))


def _snapped(piece: Piece, size: float) -> Piece:
    points = piece.points.copy()
    points[np.abs(points[..., 0]) <= AXIS * size, 0] = 0.0
    return Piece(points, piece.normals, piece.lengths)


def _thinned(piece: Piece, merge: float) -> Piece | None:
    """Return the piece without samples that no version holds apart; both ends stay."""
    points = piece.points
    last = points.shape[1] - 1
    kept = [0]
    for k in range(1, last):
        if _distance(points[:, k], points[:, kept[-1]]) > merge:
            kept.append(k)
    while len(kept) > 1 and _distance(points[:, kept[-1]], points[:, last]) <= merge:
        kept.pop()
    if len(kept) == 1 and _distance(points[:, 0], points[:, last]) <= merge:
        return None
    kept.append(last)
    return Piece(points[:, kept], piece.normals[:, kept], piece.lengths[:, kept])


def _distance(first: Floats, second: Floats) -> float:
    """Return the largest distance between the versions of two samples, shapes (M, 2)."""
    step = first - second
    return float(np.hypot(step[:, 0], step[:, 1]).max())
