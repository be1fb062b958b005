"""What integrals over a section's outline give: volumes and areas that it sweeps, exactly."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TypeAlias

import numpy as np

from sgb_core.arrays import Floats, Ints, distinct
from sgb_core.bodies.outline import Piece, Trace
from sgb_core.bodies.traces import Traces
from sgb_core.curves.nodes import gauss
from sgb_core.surfaces.quadrature import Panels, integrate, integrate_each

# Gauss points along a piece of which a polynomial is integrated.
_SMOOTH = 24
# Parts of an integral's terms that rounding leaves.
_ROUNDING = 1e-15
_RELATIVE = 1e-12
_Density: TypeAlias = Callable[[Floats, Floats, Floats, Floats], Floats]


def flux(pieces: Sequence[Piece]) -> float:
    """Return Σ ∫ r² dh along the travel: 1/π of the volume that a closed outline sweeps."""
    return float(_along(pieces, lambda r, h, dr, dh: r * r * dh, smooth=True).sum())


def swept_area(pieces: Sequence[Piece]) -> float:
    """Return Σ ∫ |r| |dP|: 1/2π of the area that the pieces sweep in a full turn."""
    return float(np.abs(_along(pieces, lambda r, h, dr, dh: np.abs(r) * np.hypot(dr, dh))).sum())


def _along(pieces: Sequence[Piece], density: _Density, smooth: bool = False) -> Floats:
    """Return ∫ density(r, h, r', h') du along the travel of each piece, in no particular order.

    ``smooth``: of what is no moved or stretched curve it is a polynomial.
    """
    pieces = [piece for piece in pieces if piece.start != piece.end]
    traces = [piece for piece in pieces if isinstance(piece, Trace)]
    bent = [piece for piece in traces if not smooth or piece.offset or piece.stretch is not None]
    plain = [piece for piece in traces if smooth and not piece.offset and piece.stretch is None]
    others = [piece for piece in pieces if not isinstance(piece, Trace)]
    return np.concatenate(
        [
            _polynomials(plain, density),
            _bisected(bent, density),
            [_alone(piece, density, smooth) for piece in others],
        ]
    )


def _polynomials(traces: Sequence[Trace], density: _Density) -> Floats:
    """Return integrals of degree 15 at most over drawn curves."""
    values, width = _at_nodes(Traces.of(traces), traces, density)
    return np.asarray(width * (values @ gauss(_SMOOTH)[1]))


def _bisected(traces: Sequence[Trace], density: _Density) -> Floats:
    many = Traces.of(traces)

    def function(u: Floats, k: Ints) -> Floats:
        point, rate = many.points(u, k), many.velocity(u, k)
        return np.asarray(density(point[:, 0], point[:, 1], rate[:, 0], rate[:, 1]))

    # What nearly cancels, as on a level curve, is known to the rounding of its parts.
    values, width = _at_nodes(many, traces, density, parts=True)
    least = _ROUNDING * np.abs(width * (values @ gauss(_SMOOTH)[1]))
    integrals = integrate_each(function, _halves(traces), len(traces), _RELATIVE, least)
    return integrals * np.sign(width)


def _at_nodes(
    many: Traces, traces: Sequence[Trace], density: _Density, parts: bool = False
) -> tuple[Floats, Floats]:
    """Return a density at Gauss points along each trace, (n, 24), and how far each runs, (n,).

    ``parts``: with the sizes of what it is made of, so that nothing cancels.
    """
    nodes = gauss(_SMOOTH)[0]
    start = np.array([piece.start for piece in traces])
    width = np.array([piece.end for piece in traces]) - start
    u = (start[:, None] + width[:, None] * nodes).ravel()
    k = np.repeat(np.arange(len(traces)), len(nodes))
    point, rate = many.points(u, k), many.velocity(u, k)
    if parts:
        point = np.abs(point)
        rate = np.hypot(rate[:, :1], rate[:, 1:]) * np.ones(2)
    values = density(point[:, 0], point[:, 1], rate[:, 0], rate[:, 1])
    return values.reshape(-1, len(nodes)), width


def _halves(traces: Sequence[Trace]) -> Panels:
    """Return both halves of each trace, whichever way it is run.

    Where it is stretched also what lies between the heights of keys.
    """
    marks = []
    for piece in traces:
        low, high = min(piece.start, piece.end), max(piece.start, piece.end)
        edges = np.array([low, (low + high) / 2.0, high])
        if piece.stretch is not None:
            breaks = piece.curve.breaks()
            edges = distinct(edges, breaks[(breaks > low) & (breaks < high)])
        marks.append(edges)
    which = np.repeat(np.arange(len(marks)), [len(edges) - 1 for edges in marks])
    low_ends = [edges[:-1] for edges in marks]
    if not low_ends:
        return np.zeros(0), np.zeros(0), which
    return np.concatenate(low_ends), np.concatenate([edges[1:] for edges in marks]), which


def _alone(piece: Piece, density: _Density, smooth: bool) -> float:
    """Return the integral along an arc or a line, as smooth as three waves of a circle."""
    low, high = min(piece.start, piece.end), max(piece.start, piece.end)

    def function(u: Floats) -> Floats:
        point, rate = piece.points(u), piece.velocity(u)
        return np.asarray(density(point[:, 0], point[:, 1], rate[:, 0], rate[:, 1]))

    if smooth:
        nodes, weights = gauss(_SMOOTH)
        total = (high - low) * float(function(low + (high - low) * nodes) @ weights)
    else:
        total = integrate(function, np.linspace(low, high, 3), _RELATIVE)
    return total if piece.end > piece.start else -total
