"""The pieces of an outline as straight lines and cubic Bézier curves within a tolerance."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np

from sgb_core.arrays import Floats, frozen
from sgb_core.bodies.outline import Line, Piece, Trace
from sgb_core.surfaces.cubics import cubic_pieces, stretch
from sgb_core.surfaces.fineness import check_tolerance

# A piece is halved at most so often; near a cusp of a moved curve that is less than rounding.
_DEEPEST = 24
_BETWEEN = np.linspace(0.0, 1.0, 10)[1:-1]
# Between samples a cubic may be a little farther off.
_CAUTION = 0.8


def outline_cubics(pieces: Iterable[Piece], tolerance: float) -> tuple[Floats, ...]:
    """Return lines (2, 2) and cubics (4, 2) along the travel, within ``tolerance`` of the pieces.

    Stretches of the drawn curve come as :func:`cubic_pieces` gives them; arcs and moved curves as
    Hermite interpolants of points and derivatives, halved until they are near enough. Raises
    FindingError, a ValueError, unless the tolerance is finite and above 0.
    """
    check_tolerance(tolerance)
    found: list[Floats] = []
    for piece in pieces:
        if isinstance(piece, Line):
            found.append(piece.ends)
        elif isinstance(piece, Trace) and piece.offset == 0.0 and piece.stretch is None:
            quartic = stretch(piece.quartic, piece.start, piece.end)
            found += list(cubic_pieces(quartic, tolerance))
        else:
            found += _hermite(piece, piece.start, piece.end, tolerance)
    return tuple(frozen(each) for each in found)


def _hermite(
    piece: Piece, start: float, end: float, tolerance: float, depth: int = 0
) -> list[Floats]:
    ends = np.array([start, end])
    (first, last), rates = piece.points(ends), piece.velocity(ends) * ((end - start) / 3.0)
    cubic = np.array([first, first + rates[0], last - rates[1], last])
    if depth >= _DEEPEST:
        return [cubic]
    t, s = _BETWEEN[:, None], 1.0 - _BETWEEN[:, None]
    curve = s**3 * cubic[0] + 3 * s**2 * t * cubic[1] + 3 * s * t**2 * cubic[2] + t**3 * cubic[3]
    off = curve - piece.points(start + (end - start) * _BETWEEN)
    if float(np.hypot(off[:, 0], off[:, 1]).max()) <= _CAUTION * tolerance:
        return [cubic]
    middle = 0.5 * (start + end)
    return [
        *_hermite(piece, start, middle, tolerance, depth + 1),
        *_hermite(piece, middle, end, tolerance, depth + 1),
    ]
