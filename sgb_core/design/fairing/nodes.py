"""Where the energies of quartics are integrated.

The integrands are analytic but for branch points where L'² vanishes, that is at the complex roots
of r' + i h' and their mirror images, and for poles where r does (κp). Gauss panels no wider than
their distance from these places converge like 4^(−2N) and worse nowhere: no adaptive search is
needed, and values and derivatives are as exact as the arithmetic.
"""

from __future__ import annotations

from math import comb

import numpy as np
from numpy.typing import NDArray

from sgb_core.arrays import Floats
from sgb_core.curves.nodes import gauss, panels
from sgb_core.design.fairing.energy import Energy, Nodes

Complexes = NDArray[np.complex128]

# Points of a panel, and how often one is halved at most.
_POINTS = 12
_MOST_HALVINGS = 40
# A root so near an end of [0, 1] is at that end.
AT_END = 1e-11
# A search tells places apart down to here; it has so many panels of so many points.
_NEAREST = 1e-5
_PANELS = 12
_PANEL_POINTS = 8
_SPREAD = np.linspace(-1.0, 1.0, 13)


def exact_nodes(energy: Energy, quartics: Floats) -> Nodes:
    """Return nodes (B, N) that integrate the energies of quartics (B, 5, 2) to about 1e-13.

    Places at the very ends are left out: a finite energy is smooth there. Rows with fewer panels
    end in zero weights.
    """
    rows = []
    for places in _places(energy, quartics):
        apart = np.minimum(np.abs(places), np.abs(places - 1.0)) > AT_END
        edges = _edges(places[apart])
        # The edges are short binary numbers: seen from the far end, 1 − s loses no digit either.
        rest = panels(1.0 - edges[::-1], _POINTS)[0][::-1]
        rows.append((*panels(edges, _POINTS), rest))
    most = max(len(s) for s, _, _ in rows)
    nodes, weights = np.full((2, len(rows), most), 0.5), np.zeros((len(rows), most))
    for k, (s, each, rest) in enumerate(rows):
        nodes[:, k, : len(s)], weights[k, : len(s)] = (s, rest), each
    return Nodes.at(nodes[0], weights, nodes[1])


def look_nodes() -> Nodes:
    """Return the nodes for a first look at many shapes: finer towards the ends."""
    x, weights = gauss(32)
    # s = x² (3 − 2x) gathers nodes where short legs turn the curve.
    return Nodes.at(x * x * (3.0 - 2.0 * x), 6.0 * x * (1.0 - x) * weights)


def graded_nodes(energy: Energy, quartics: Floats) -> Nodes:
    """Return nodes (B, N) that integrate the energies of quartics (B, 5, 2) to about 1e-6.

    The panels of one quartic, always the same number, share the places x + iy out evenly by
    ∫ ds/|s − x − iy| = asinh((s − x)/|y|).
    """
    places = _places(energy, quartics)
    x, y = np.clip(places.real, -1.0, 2.0), np.abs(places.imag)
    # A root at an end, or one that would ask for all panels, is graded towards up to a point.
    y = np.maximum(np.hypot(y, np.maximum(np.maximum(-x, x - 1.0), 0.0)), _NEAREST)[..., None]
    x = np.clip(x, 0.0, 1.0)[..., None]
    marks = x + y * np.sinh(np.arcsinh(1.0 / y) * _SPREAD)
    marks = np.clip(marks.reshape(len(quartics), -1), 0.0, 1.0)
    even = np.broadcast_to(np.linspace(0.0, 1.0, 9), (len(quartics), 9))
    marks = np.sort(np.concatenate([marks, even], axis=1), axis=1)
    reach = np.arcsinh((marks[:, None, :] - x) / y).sum(axis=1) + 2.0 * marks
    shares = np.linspace(0.0, 1.0, _PANELS + 1)
    edges = np.array(
        [
            np.interp(low[0] + (low[-1] - low[0]) * shares, low, each)
            for low, each in zip(reach, marks, strict=True)
        ]
    )
    nodes, weights = gauss(_PANEL_POINTS)
    widths = np.diff(edges, axis=1)[..., None]
    s = edges[:, :-1, None] + widths * nodes
    return Nodes.at(s.reshape(len(quartics), -1), (widths * weights).reshape(len(quartics), -1))


def speed_roots(quartics: Floats) -> Complexes:
    """Return the roots (B, 3) of r' + i h': there, and at their mirror images, L'² = 0."""
    steps = np.diff(quartics, axis=1)
    return roots(steps[..., 0] + 1j * steps[..., 1])


def roots(bernstein: Complexes) -> Complexes:
    """Return the complex roots (B, d) of polynomials in Bernstein form (B, d + 1).

    Those at infinity, of polynomials of a lower degree, come out far away.
    """
    degree = bernstein.shape[1] - 1
    # In u = s / (1 − s) it is a plain polynomial; s = u / (1 + u). Nothing cancels at the ends.
    power = np.array([comb(degree, k) for k in range(degree + 1)]) * bernstein
    # A little is added to the lead, so that u stays finite where s = 1 is a root.
    lead = power[:, -1:] + 1e-15 * np.abs(power).max(axis=1, keepdims=True) + 1e-300
    companion = np.zeros((len(power), degree, degree), dtype=np.complex128)
    companion[:, range(1, degree), range(degree - 1)] = 1.0
    companion[:, :, -1] = -power[:, :-1] / lead
    u = np.linalg.eigvals(companion)
    with np.errstate(divide="ignore", invalid="ignore"):
        s = u / (1.0 + u)
    return np.where(np.isfinite(s), s, 1e3)


def _places(energy: Energy, quartics: Floats) -> Complexes:
    """Return the complex places where the integrands are not analytic, (B, 3 or 7)."""
    found = speed_roots(quartics)
    if energy is not Energy.SURFACE:
        return found
    return np.concatenate([found, roots(quartics[..., 0].astype(np.complex128))], axis=1)


def _edges(places: Complexes) -> Floats:
    """Return the edges of panels no wider than their distance from complex places."""
    x, y = places.real.tolist(), np.abs(places.imag).tolist()
    done: list[float] = [0.0]
    pending = [(0.0, 1.0, 0)]
    while pending:
        low, high, depth = pending.pop()
        width = high - low
        for real, imaginary in zip(x, y, strict=True):
            aside = low - real if real < low else real - high if real > high else 0.0
            if aside * aside + imaginary * imaginary < width * width and depth < _MOST_HALVINGS:
                middle = 0.5 * (low + high)
                pending += [(middle, high, depth + 1), (low, middle, depth + 1)]
                break
        else:
            done.append(high)
    return np.array(done)
