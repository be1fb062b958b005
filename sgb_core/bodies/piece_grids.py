"""The pieces of a changing section at equal shares of each, whatever the angle."""

from __future__ import annotations

from collections.abc import Sequence
from math import degrees

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.bodies.cross_section import CrossSection
from sgb_core.bodies.meridian import SolidError
from sgb_core.bodies.outline import Role
from sgb_core.bodies.varying_solid import Track, beginning, tracks_of
from sgb_core.findings.bodies import ChangingSection
from sgb_core.values import dataclass


@dataclass(frozen=True, slots=True, eq=False)
class PieceGrid:
    """One piece at M angles: ``points`` (M, k, 2) in its half-planes, run as the outline runs."""

    role: Role
    points: Floats


def piece_grids(
    sections: Sequence[CrossSection], theta: Floats, shares: Floats
) -> tuple[tuple[tuple[PieceGrid, ...], ...], ...]:
    """Return for each part and each of its rings the pieces at ``shares`` from 0 to 1 of each.

    Not mirrored to the side of the axis on which the profile is drawn. Raises SolidError, naming
    the angle, where the sections are not made of the same pieces.
    """
    known: dict[int, list[list[list[Track]]]] = {}
    for section in sections:
        if id(section) not in known:
            parts = [
                [tracks_of(ring, section.meridian) for ring in outline.rings]
                for outline in section.outlines
            ]
            known[id(section)] = sorted(parts, key=beginning)
    columns = [known[id(section)] for section in sections]
    shape = _shape(columns[0])
    for angle, column in zip(theta, columns, strict=True):
        if _shape(column) != shape:
            raise SolidError(ChangingSection(degrees(float(angle))))
    sampled = {key: _sampled(parts, shares) for key, parts in known.items()}
    every = [sampled[id(section)] for section in sections]
    side = np.array([-1.0 if sections[0].meridian.mirrored else 1.0, 1.0])
    return tuple(
        tuple(
            tuple(
                PieceGrid(
                    every[0][part][ring][piece][0],
                    side * np.stack([column[part][ring][piece][1] for column in every]),
                )
                for piece in range(len(every[0][part][ring]))
            )
            for ring in range(len(every[0][part]))
        )
        for part in range(len(every[0]))
    )


def _shape(column: list[list[list[Track]]]) -> list[list[list[tuple[Role, int]]]]:
    return [[[(role, len(pieces)) for role, pieces in ring] for ring in part] for part in column]


def _sampled(
    parts: list[list[list[Track]]], shares: Floats
) -> list[list[list[tuple[Role, Floats]]]]:
    return [
        [
            [
                (role, piece.points(piece.start + (piece.end - piece.start) * shares))
                for role, pieces in ring
                for piece in pieces
            ]
            for ring in part
        ]
        for part in parts
    ]
