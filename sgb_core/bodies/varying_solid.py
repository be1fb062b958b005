"""Bodies whose profile varies with the angle: one topology all round, a section at every column.

Each meridian's wall follows its own normal in its half-plane. A row stands for one place along
the profile or its wall; where a meridian's wall leaves that place out, in a fold or beyond a cut,
the row lies on the corner that took its place, and the mesh welds it there.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from itertools import groupby, pairwise
from math import degrees
from typing import Literal

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.bodies.cross_section import CrossSection
from sgb_core.bodies.meridian import Meridian, SolidError
from sgb_core.bodies.outer_face import OuterFace
from sgb_core.bodies.outline import Line, Piece, Ring, Role, Trace
from sgb_core.bodies.solid import Solid
from sgb_core.bodies.solid_mesh import PieceRows, piece_rows
from sgb_core.findings.bodies import AtAngle, ChangingSection
from sgb_core.interruption import checkpoint
from sgb_core.surfaces.revolution import RevolutionSurface
from sgb_core.surfaces.section import AXIS
from sgb_core.surfaces.sections import Sections
from sgb_core.surfaces.turn import Turn
from sgb_core.values import dataclass

# A row follows the profile where its track is one of these, else the pieces one by one.
_ALONG = (Role.DRAWN, Role.WALL)

Track = tuple[Role, tuple[Piece, ...]]
Build = Callable[[RevolutionSurface, Solid, Sections], CrossSection]


def sections_at(
    surface: RevolutionSurface, solid: Solid, theta: Floats, build: Build
) -> list[CrossSection]:
    """Return the sections at angles from the start, equal ones being made once.

    Raises SolidError naming the angle where one cannot be made.
    """
    size = surface.profile.size or 1.0
    known: dict[bytes, CrossSection] = {}
    found = []
    sections = surface.sections(theta)
    for number, angle in enumerate(theta):
        section = sections[number]
        key = (np.round(section.quartics / size, 11) + 0.0).tobytes()
        if section.stretch is not None:
            key += (np.round(section.stretch.departures, 11) + 0.0).tobytes()
        if key not in known:
            checkpoint()
            try:
                known[key] = build(surface, solid, section)
            except SolidError as error:
                raise SolidError(AtAngle(error.finding, degrees(float(angle)))) from error
        found.append(known[key])
    return found


def varying_rows(
    surface: RevolutionSurface,
    sections: Sequence[CrossSection],
    turn: Turn,
    parameters: Callable[[Piece], Floats],
    face: OuterFace | None = None,
) -> list[list[list[PieceRows]]]:
    """Return for each part and each of its rings the rows of all columns.

    With a ``face`` they know where on it they lie.

    ``sections`` are those of the turn's columns; ``parameters`` samples a whole piece. Raises
    SolidError where the sections do not agree in what they are made of.
    """
    tracked: dict[int, list[list[list[Track]]]] = {}
    for section in sections:
        if id(section) not in tracked:
            parts = [
                [tracks_of(ring, section.meridian) for ring in outline.rings]
                for outline in section.outlines
            ]
            tracked[id(section)] = sorted(parts, key=beginning)
    columns = [tracked[id(section)] for section in sections]
    shape = _shape(columns[0])
    for angle, column in zip(turn.angles, columns, strict=True):
        if _shape(column) != shape:
            raise SolidError(ChangingSection(degrees(float(angle))))
    slips = _Slips(surface, sections, turn)
    return [
        [
            _ring_rows([column[part][ring] for column in columns], parameters, slips, face)
            for ring in range(len(columns[0][part]))
        ]
        for part in range(len(columns[0]))
    ]


def _shape(column: list[list[list[Track]]]) -> list[list[list[tuple[Role, int]]]]:
    return [
        [
            [(role, 0 if role in _ALONG else len(pieces)) for role, pieces in ring]
            for ring in outline
        ]
        for outline in column
    ]


def tracks_of(ring: Ring, meridian: Meridian) -> list[Track]:
    """Return a ring's pieces grouped by role, from the same corner at every angle."""
    size = meridian.size
    pieces = [
        replace(piece, role=Role.AXIS)
        if isinstance(piece, Line) and (np.abs(piece.ends[:, 0]) <= AXIS * size).all()
        else piece
        for piece in ring
    ]
    roles = [piece.role for piece in pieces]
    corners = [k for k in range(len(roles)) if roles[k] != roles[k - 1]]
    if Role.AXIS in roles:
        corners = [roles.index(Role.AXIS) + 1]
    if corners:
        turned = min(
            (pieces[k:] + pieces[:k] for k in corners),
            key=lambda run: [role for role, _ in groupby(piece.role.value for piece in run)],
        )
    else:
        way = 1.0 if _runs_forward(pieces) else -1.0
        k = min(range(len(pieces)), key=lambda k: way * sum(_along(pieces[k])))
        turned = pieces[k:] + pieces[:k]
    period = 2 * len(meridian.quartics) if meridian.closed else 0
    return [
        (role, _unrolled(tuple(run), period))
        for role, run in groupby(turned, key=lambda piece: piece.role)
    ]


def beginning(part: list[list[Track]]) -> tuple[str, float]:
    """Order parts by where they begin along the curves: which is the largest may change."""
    ways = [
        (role.value, min(min(_along(piece)) for piece in pieces))
        for role, pieces in part[0]
        if role in _ALONG
    ]
    return min(ways, default=("", 0.0))


def _unrolled(run: tuple[Piece, ...], period: int) -> tuple[Piece, ...]:
    """Return pieces along a closed profile with places that go on where its segments begin anew.

    ``period`` is the number of places once around, 0 where the profile is open.
    """
    way = 1 if _runs_forward(run) else -1
    result, shift = [run[0]], 0
    for before, piece in pairwise(run):
        if period and way * (_along(piece)[0] - _along(before)[1]) <= -period / 2:
            shift += way * period
        result.append(replace(piece, place=piece.place + shift))
    return tuple(result)


@dataclass(frozen=True, slots=True, eq=False)
class _Slips:
    """How fast the curves move with the angle, at each column."""

    size: float
    runs: tuple[Floats, ...]
    sections: Sections
    reverse: bool
    mirrored: bool

    def __init__(
        self, surface: RevolutionSurface, sections: Sequence[CrossSection], turn: Turn
    ) -> None:
        meridian = sections[0].meridian
        object.__setattr__(self, "size", surface.profile.size)
        # Columns between two creases, over which everything changes smoothly.
        object.__setattr__(self, "runs", np.split(turn.angles, np.flatnonzero(~turn.linked) + 1))
        object.__setattr__(self, "reverse", meridian.reverse)
        object.__setattr__(self, "mirrored", meridian.mirrored)
        object.__setattr__(self, "sections", surface.sections(turn.angles, turn.sides))

    def lean(
        self, columns: Sequence[int], trace: Trace, u: Floats, normals: Floats, r: Floats
    ) -> Floats:
        """Return −(∂L/∂θ · n)/r at columns of one section, shape (columns, len(u)).

        Moving along the normal does not change ∂L/∂θ · n.
        """
        places = 1.0 - u if self.reverse else u
        change = self.sections[list(columns), trace.segment].changes_on(places)
        if self.mirrored:
            change = change * (-1.0, 1.0)
        away = r > AXIS * self.size
        slip = (change * normals).sum(axis=-1)
        return np.where(away, -slip / np.where(away, r, 1.0), 0.0)

    def lean_of(self, points: Floats, normals: Floats) -> Floats:
        """Return −(∂P/∂θ · n)/r of what is no curve of the profile, (M, k) for (M, k, 2) each.

        Arcs and lines hang on curves that move; how fast is told from neighbouring columns.
        """
        rates, first = np.zeros_like(points), 0
        for angles in self.runs:
            run = slice(first, first + len(angles))
            first = run.stop
            if len(angles) > 1:
                order: Literal[1, 2] = 2 if len(angles) > 2 else 1
                rates[run] = np.gradient(points[run], angles, axis=0, edge_order=order)
        r = points[..., 0]
        away = r > AXIS * self.size
        slip = (rates * normals).sum(axis=-1)
        return np.where(away, -slip / np.where(away, r, 1.0), 0.0)


def _ring_rows(
    columns: Sequence[Sequence[Track]],
    parameters: Callable[[Piece], Floats],
    slips: _Slips,
    face: OuterFace | None,
) -> list[PieceRows]:
    rows: list[PieceRows] = []
    for number, (role, pieces) in enumerate(columns[0]):
        versions = [column[number][1] for column in columns]
        if role in _ALONG:
            rows += _rows_along(role, versions, parameters, slips, face)
            continue
        for k in range(len(pieces)):
            u = _whole(pieces[k], parameters)
            same = [_at(version[k], u) for version in versions]
            points = np.stack([points for points, _ in same])
            normals = np.stack([normals for _, normals in same])
            rows.append(piece_rows(role, points, _leant(points, normals, slips), slips.size))
    return rows


def _rows_along(
    role: Role,
    versions: Sequence[tuple[Piece, ...]],
    parameters: Callable[[Piece], Floats],
    slips: _Slips,
    face: OuterFace | None,
) -> list[PieceRows]:
    """Return one piece of rows for each place that any meridian has, in the order of travel."""
    samples: dict[int, Floats] = {}
    for piece in {id(piece): piece for version in versions for piece in version}.values():
        u = parameters(replace(piece, start=0.0, end=1.0))
        if len(u) > len(samples.get(piece.place, ())):
            samples[piece.place] = u
    forward = _runs_forward(max(versions, key=len))
    rows = []
    alike: dict[int, list[int]] = {}
    for column, version in enumerate(versions):
        alike.setdefault(id(version), []).append(column)
    for place in sorted(samples, reverse=not forward):
        u = samples[place] if forward else samples[place][::-1]
        places, full = np.empty((len(versions), len(u), 2)), np.zeros((len(versions), len(u), 3))
        curved = np.zeros(full.shape[:2], dtype=bool)
        for columns in alike.values():
            checkpoint()
            points, normals, traced = _clamped(versions[columns[0]], place + u, forward)
            places[columns] = points
            leans = np.zeros((len(columns), len(u)))
            for trace, at in traced:
                own = np.flatnonzero(np.isfinite(at))
                r = np.maximum(points[own, 0], 0.0)
                leans[:, own] = slips.lean(columns, trace, at[own], normals[own], r)
                curved[np.array(columns)[:, None], own] = True
            full[columns, :, 0], full[columns, :, 2] = normals.T
            full[columns, :, 1] = leans
        hung = np.where(curved, full[..., 1], slips.lean_of(places, full[..., ::2]))
        full[..., 1] = hung
        full /= np.linalg.norm(full, axis=-1)[..., None]
        shares = None if face is None else face.shares(role, place, u)
        rows.append(piece_rows(role, places, full, slips.size, shares))
    return rows


def _runs_forward(pieces: Sequence[Piece]) -> bool:
    """Whether pieces run from the foot to the rim."""
    return sum(piece.end - piece.start for piece in pieces if isinstance(piece, Trace)) >= 0.0


def _along(piece: Piece) -> tuple[float, float]:
    """Return the places of a piece's start and end."""
    return piece.place + piece.start, piece.place + piece.end


def _clamped(
    version: tuple[Piece, ...], places: Floats, forward: bool
) -> tuple[Floats, Floats, list[tuple[Trace, Floats]]]:
    """Return points and normals at places, those left out being those of the nearest corner."""
    spans = np.array([sorted(_along(piece)) for piece in version])
    below, above = spans[:, :1] - places, places - spans[:, 1:]
    owner = np.argmin(np.maximum(np.maximum(below, above), 0.0), axis=0)
    points, normals = np.empty((len(places), 2)), np.empty((len(places), 2))
    traced = []
    for k in np.unique(owner).tolist():
        piece = version[k]
        own = np.flatnonzero(owner == k)
        u = np.clip(places[own], *spans[k]) - piece.place
        points[own], normals[own] = piece.points(u), piece.normals(u)
        if isinstance(piece, Trace):
            at = np.full(len(places), np.nan)
            at[own] = u
            traced.append((piece, at))
    return points, normals, traced


def _whole(piece: Piece, parameters: Callable[[Piece], Floats]) -> Floats:
    """Return shares of a piece's own stretch, 0 to 1, at which all versions are sampled."""
    u = parameters(piece)
    if piece.start == piece.end:
        # Neighbours that meet have left nothing of it at this angle.
        return np.linspace(0.0, 1.0, len(u))
    return (u - piece.start) / (piece.end - piece.start)


def _at(piece: Piece, shares: Floats) -> tuple[Floats, Floats]:
    u = piece.start + (piece.end - piece.start) * shares
    return piece.points(u), piece.normals(u)


def _leant(points: Floats, normals: Floats, slips: _Slips) -> Floats:
    """Return unit normals on e_ρ, e_θ, e_h of points that move with the angle, (M, k, 3)."""
    lean = slips.lean_of(points, normals)
    full = np.stack([normals[..., 0], lean, normals[..., 1]], axis=-1)
    return np.asarray(full / np.linalg.norm(full, axis=-1)[..., None])
