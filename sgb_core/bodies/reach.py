"""How far a section reaches: its lowest and highest place, and how far it is from the axis."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np

from sgb_core.bodies.outline import Line, Piece
from sgb_core.bodies.region import Outline

# Parameters looked at between two neighbours, and how often: 2/32 of a step is left each time.
_PLACES, _ROUNDS = 33, 6


def outline_reach(outlines: Iterable[Outline]) -> tuple[float, float, float]:
    """Return (lowest h, highest h, largest |r|) of a section that has some outline.

    The places are those of the exact curves, to rounding.
    """
    pieces = [piece for outline in outlines for ring in outline.rings for piece in ring]
    return (
        -max(_most(piece, 1, -1.0) for piece in pieces),
        max(_most(piece, 1, 1.0) for piece in pieces),
        max(_most(piece, 0, sign) for piece in pieces for sign in (1.0, -1.0)),
    )


def _most(piece: Piece, coordinate: int, sign: float) -> float:
    """Return the largest value of ``sign`` times a coordinate along a piece."""
    low, high = sorted((piece.start, piece.end))
    best = -np.inf
    for _ in range(1 if isinstance(piece, Line) else _ROUNDS):
        u = np.linspace(low, high, _PLACES)
        values = sign * piece.points(u)[:, coordinate]
        place = int(values.argmax())
        best = max(best, float(values[place]))
        low, high = float(u[max(place - 1, 0)]), float(u[min(place + 1, _PLACES - 1)])
    return best
