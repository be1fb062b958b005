"""Cross-sections to sweep: polylines with exact one-sided normals, breaks and arc length.

A generatrix, the polygon of a vessel's wall and one section per angle where laws hold all take
the same way: smooth pieces are assembled into a :class:`Section`, which the tessellator sweeps.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import field, replace
from itertools import accumulate, pairwise
from typing import Protocol, TypeVar

import numpy as np
from numpy.typing import NDArray

from sgb_core.arrays import Floats, Ints, distinct
from sgb_core.curves.nodes import derivative_rows, gauss, on_nodes
from sgb_core.curves.roots import real_roots
from sgb_core.findings.errors import FindingError
from sgb_core.findings.surfaces import NoSurface
from sgb_core.surfaces.normals import radius_signs, unit_tangents
from sgb_core.surfaces.relief import NEAR, refined
from sgb_core.surfaces.revolution import RevolutionSurface
from sgb_core.surfaces.sections import Sections
from sgb_core.surfaces.turn import Turn
from sgb_core.values import dataclass

# Radii below this part of the size lie on the axis.
AXIS = 1e-9
# Samples closer than this part of the size are one: single precision still tells them apart.
MERGE = 1e-6


@dataclass(frozen=True, slots=True, eq=False)
class Rows:
    """A smooth stretch of a section: M versions (1, or one per column) of k samples.

    ``points`` (M, k, 2) are (r, h); ``normals`` (M, k, 3) unit components on e_ρ, e_θ, e_h,
    one-sided at the ends; ``lengths`` (M, k) the arc length from the piece's start. ``shares`` (k,)
    say where on the generatrix samples of an outer face lie that may be raised.
    """

    points: Floats
    normals: Floats
    lengths: Floats
    shares: Floats | None = field(default=None, kw_only=True)


AnyRows = TypeVar("AnyRows", bound=Rows)


@dataclass(frozen=True, slots=True, eq=False)
class Section:
    """R render rows, ready to be swept.

    ``points``, ``normals`` and ``lengths`` as in :class:`Rows`, lengths as a share of the whole.
    ``rings`` (R,) number the welded rows: the two sides of a corner are two rows on one ring.
    ``linked`` (R − 1,) says where a strip leads from a row to the next, ``starts`` which rows begin
    a piece. ``merge`` is the distance below which samples are one. ``shares`` (R,) are those of
    the rows, not a number where they stay; None where all do.
    """

    points: Floats
    normals: Floats
    lengths: Floats
    rings: Ints
    linked: NDArray[np.bool_]
    starts: tuple[int, ...]
    merge: float
    shares: Floats | None = None


def assemble(pieces: Sequence[Rows], size: float, merge: float | None = None) -> Section:
    """Return the section of consecutive pieces.

    Radii within 1e-9·size of 0 become 0. Consecutive samples closer than ``merge`` (default
    1e-6·size) become one; a piece whose samples all do so vanishes. Pieces whose ends meet within
    that distance share a ring, also the last with the first. Raises FindingError if nothing is
    left.
    """
    merge = MERGE * size if merge is None else merge
    on_axis = (replace(piece, points=snapped(piece.points, size)) for piece in pieces)
    kept = [thin for piece in on_axis if (thin := thinned(piece, merge))]
    if not kept:
        raise FindingError(NoSurface.POINT)
    shared = [
        _distance(before.points[:, -1], after.points[:, 0]) <= merge
        for before, after in pairwise(kept)
    ]
    foot, head = kept[0].points[:, 0], kept[-1].points[:, -1]
    # A pole closes itself; and fewer than three rings go out and back the same way.
    count = sum(piece.points.shape[1] for piece in kept) - sum(shared)
    closed = count > 3 and bool(foot[:, 0].any()) and _distance(foot, head) <= merge
    return joined(kept, shared, closed, merge)


def joined(pieces: Sequence[Rows], shared: Sequence[bool], closed: bool, merge: float) -> Section:
    """Return the section of pieces that are snapped and thinned already.

    ``shared`` says of each piece but the last whether the next one starts on its last ring,
    ``closed`` whether the last ring is the first.
    """
    rings: list[Ints] = []
    linked: list[NDArray[np.bool_]] = []
    count = 0
    for k, piece in enumerate(pieces):
        first = count - 1 if k > 0 and shared[k - 1] else count
        rings.append(first + np.arange(piece.points.shape[1]))
        count = int(rings[-1][-1]) + 1
        on_axis = (piece.points[..., 0] == 0.0).all(axis=0)
        linked.extend([np.zeros(min(k, 1), dtype=bool), ~(on_axis[1:] & on_axis[:-1])])
    numbers = np.concatenate(rings)
    if closed:
        numbers[-1] = 0
    totals = np.array([piece.lengths[:, -1] for piece in pieces])
    offsets = np.cumsum(totals, axis=0) - totals
    lengths = [
        piece.lengths + offset[:, None] for piece, offset in zip(pieces, offsets, strict=True)
    ]
    whole = totals.sum(axis=0)[:, None]
    return Section(
        points=np.concatenate([piece.points for piece in pieces], axis=1),
        normals=np.concatenate([piece.normals for piece in pieces], axis=1),
        lengths=np.concatenate(lengths, axis=1) / np.where(whole > 0.0, whole, 1.0),
        rings=numbers,
        linked=np.concatenate(linked),
        starts=tuple(accumulate((len(piece_rings) for piece_rings in rings[:-1]), initial=0)),
        merge=merge,
        shares=_shares(pieces),
    )


def _shares(pieces: Sequence[Rows]) -> Floats | None:
    if all(piece.shares is None for piece in pieces):
        return None
    own = [
        np.full(piece.points.shape[1], np.nan) if piece.shares is None else piece.shares
        for piece in pieces
    ]
    return np.concatenate(own)


class MoreRows(Protocol):
    """What asks for rows of its own, and knows where on the generatrix rows lie."""

    @property
    def rows(self) -> Mapping[int, Floats]:
        """By segment the parameters of more rows."""
        ...

    def share(self, segment: int, s: Floats) -> Floats:
        """Return the shares of the generatrix' length at parameters of a segment."""
        ...


def section_of(
    surface: RevolutionSurface,
    counts: Sequence[int],
    turn: Turn,
    merge: float | None = None,
    more: MoreRows | None = None,
) -> Section:
    """Return the section of a surface with ``counts[k]`` equal steps of s in segment k.

    Rows that ``more`` asks for are added, and the rows get its shares. Where the profile crosses
    the axis a sample is added on it and the section breaks: the two sides face opposite ways. With
    laws there is one version per render column of ``turn``.
    """
    profile = surface.profile
    if len(counts) != len(profile) or min(counts) < 1:
        raise ValueError("at least one interval for each segment is needed")
    size = profile.size
    pieces: list[Rows] = []
    if surface.laws:
        sections = surface.sections(turn.angles, turn.sides)
        for k, s in enumerate(_samples(counts, more)):
            pieces.append(_shared(more, k, s, _varying_piece(sections[:, k], s, size)))
    else:
        for k, s in enumerate(_samples(counts, more)):
            for at, piece in _segment_pieces(profile.quartics[k], s, size):
                pieces.append(_shared(more, k, at, piece))
    return assemble(pieces, size, merge)


def _samples(counts: Sequence[int], more: MoreRows | None) -> Iterator[Floats]:
    """Yield the parameters of each segment's rows."""
    for k, count in enumerate(counts):
        even = np.linspace(0.0, 1.0, count + 1)
        yield even if more is None else refined(even, more.rows[k], NEAR)


def _shared(more: MoreRows | None, segment: int, s: Floats, piece: Rows) -> Rows:
    return piece if more is None else replace(piece, shares=more.share(segment, s))


def _segment_pieces(quartic: Floats, s: Floats, size: float) -> list[tuple[Floats, Rows]]:
    """Return a segment's pieces between the places where it crosses the axis, with their s."""
    roots = _axis_crossings(quartic)
    s = distinct(s, roots)
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
        rows = Rows(points[None, part], normals[None], (lengths[part] - lengths[start])[None])
        pieces.append((s[part], rows))
    return pieces


def _varying_piece(sections: Sections, s: Floats, size: float) -> Rows:
    points, normals = sections.on(s), sections.normals_on(s, size)
    steps = np.diff(points, axis=1)
    chords = np.hypot(steps[..., 0], steps[..., 1])
    lengths = np.concatenate([np.zeros((len(points), 1)), np.cumsum(chords, axis=1)], axis=1)
    return Rows(points, normals, lengths)


def _axis_crossings(quartic: Floats) -> Floats:
    """Return the s inside a segment where r changes its sign."""
    r = quartic[:, 0]
    if r.min() >= 0.0 or r.max() <= 0.0:
        return np.zeros(0)
    s = np.array([root for root in real_roots(r.tolist()) if 1e-9 < root < 1.0 - 1e-9])
    marks = np.concatenate([[0.0], s, [1.0]])
    sides = np.sign(on_nodes(quartic, (marks[1:] + marks[:-1]) / 2.0)[:, 0])
    return s[sides[1:] * sides[:-1] < 0.0]


def _interval_lengths(quartic: Floats, s: Floats) -> Floats:
    nodes, weights = gauss(8)
    inner = (s[:-1, None] + np.diff(s)[:, None] * nodes).ravel()
    velocity = on_nodes(quartic, inner, 1)
    speed = np.hypot(velocity[:, 0], velocity[:, 1]).reshape(-1, len(nodes))
    return np.asarray((speed @ weights) * np.diff(s))


def snapped(points: Floats, size: float) -> Floats:
    """Return points (..., 2) with the radii within 1e-9·size of the axis put on it."""
    result = points.copy()
    result[np.abs(result[..., 0]) <= AXIS * size, 0] = 0.0
    return result


def thinned(piece: AnyRows, merge: float) -> AnyRows | None:
    """Return the piece without samples that no version holds more than ``merge`` apart.

    Both ends stay; None where they too are one.
    """
    points = piece.points
    last = points.shape[1] - 1
    from_end = _distances(points[:, :-1], points[:, -1:]) > merge
    if last > 0 and from_end.all() and (_distances(points[:, :-1], points[:, 1:]) > merge).all():
        return piece
    kept = [0]
    for k in range(1, last):
        if from_end[k] and _distance(points[:, k], points[:, kept[-1]]) > merge:
            kept.append(k)
    if len(kept) == 1 and not (last > 0 and from_end[0]):
        return None
    kept.append(last)
    return replace(
        piece,
        points=points[:, kept],
        normals=piece.normals[:, kept],
        lengths=piece.lengths[:, kept],
        shares=None if piece.shares is None else piece.shares[kept],
    )


def _distance(first: Floats, second: Floats) -> float:
    """Return the largest distance between the versions of two samples, shapes (M, 2)."""
    return float(_distances(first, second))


def _distances(first: Floats, second: Floats) -> Floats:
    """Return the largest distances between the versions of samples (M, ..., 2), shape (...)."""
    step = first - second
    return np.asarray(np.hypot(step[..., 0], step[..., 1]).max(axis=0))
