"""The energies of a segment and their exact first and second derivatives.

All three are ∫ φ ds with φ a function of a few products of the curve's derivatives, each linear or
bilinear in the quartic points, so that first and second derivatives follow by the chain rule. With
X = L'×L'', W = |L'|², Z = L'·L'', T = L'×L''':

* bending: κ² |L'| = X² W^(−5/2);
* variation: (dκ/dl)² |L'| = (T W − 3 X Z)² W^(−11/2);
* surface, for one radian of the turn: (κm² + κp²) r |L'| = |r| X² W^(−5/2) + h'² / (|r| W^(1/2)).
"""

from __future__ import annotations

from enum import StrEnum
from math import comb

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.values import dataclass


class Energy(StrEnum):
    """What a fair curve has least of.

    BENDING is ∫ κ² dl, VARIATION ∫ (dκ/dl)² dl and SURFACE ∬ (κm² + κp²) dA.
    """

    BENDING = "bending"
    VARIATION = "variation"
    SURFACE = "surface"

    @property
    def dimension(self) -> int:
        """Under scaling by f the energy is multiplied by f to this power."""
        return {Energy.BENDING: -1, Energy.VARIATION: -3, Energy.SURFACE: 0}[self]


@dataclass(frozen=True, slots=True)
class Moves:
    """Directions in which quartic points move: direction j moves point ``which[j]``.

    ``along`` has shape (B, m, 2), one set for each segment of a batch.
    """

    which: tuple[int, ...]
    along: Floats


@dataclass(frozen=True, slots=True)
class Expansion:
    """Values (B,), gradients (B, m) and Hessians (B, m, m) of an energy along some moves."""

    value: Floats
    gradient: Floats
    hessian: Floats


@dataclass(frozen=True, slots=True)
class Nodes:
    """Nodes and weights on [0, 1], shape (N,) or (B, N).

    ``falls[p][k]``, of that shape, multiplies difference k of order p of the quartic points in
    the derivative of that order.
    """

    s: Floats
    weights: Floats
    falls: tuple[tuple[Floats, ...], ...]

    @classmethod
    def at(cls, s: Floats, weights: Floats, rest: Floats | None = None) -> Nodes:
        """Return the nodes with their Bernstein polynomials, times 4, 12 and 24.

        ``rest`` is 1 − s, where it is known better than s tells it.
        """
        r = 1.0 - s if rest is None else rest
        r2, s2, rs = r * r, s * s, r * s
        falls = (
            (r2 * r2, 4.0 * r2 * rs, 6.0 * rs * rs, 4.0 * rs * s2, s2 * s2),
            (4.0 * r2 * r, 12.0 * r2 * s, 12.0 * r * s2, 4.0 * s2 * s),
            (12.0 * r2, 24.0 * rs, 12.0 * s2),
            (24.0 * r, 24.0 * s),
        )
        return cls(s, weights, falls)

    def row(self, order: int, point: int) -> Floats:
        """Return how much Q_point counts in the derivative of an order, shape of ``s``."""
        falls = self.falls[order]
        total = np.zeros_like(self.s)
        for k in range(max(point - order, 0), min(point, 4 - order) + 1):
            sign = -1.0 if (order - point + k) % 2 else 1.0
            total = total + sign * comb(order, point - k) * falls[k]
        return total


def everywhere(count: int) -> Moves:
    """Return the ten moves of all quartic points along r and h, for a batch of ``count``."""
    along = np.broadcast_to(np.tile(np.eye(2), (5, 1)), (count, 10, 2))
    return Moves(tuple(k for k in range(5) for _ in range(2)), along)


def energies(energy: Energy, quartics: Floats, nodes: Nodes) -> Floats:
    """Return the energies, shape (B,), of quartics (B, 5, 2)."""
    jets = _jets(energy, quartics, nodes)
    density = _local(energy, _products(energy, jets), derivatives=False)[0]
    return np.asarray((density * nodes.weights).sum(axis=-1))


def expand(energy: Energy, quartics: Floats, nodes: Nodes, moves: Moves) -> Expansion:
    """Return the energies of quartics (B, 5, 2) with both derivatives along ``moves``."""
    jets = _jets(energy, quartics, nodes)
    values = _products(energy, jets)
    value, first, second = _local(energy, values)
    first = [part * nodes.weights for part in first]
    slopes, bends = _slopes(energy, jets, nodes, moves, first)
    gradient = sum(
        (slope @ part[:, :, None])[:, :, 0] for part, slope in zip(first, slopes, strict=True)
    )
    hessian = bends
    for i, slope in enumerate(slopes):
        leaning = sum(
            (second[min(i, j), max(i, j)] * nodes.weights)[:, None, :] * other
            for j, other in enumerate(slopes)
            if (min(i, j), max(i, j)) in second
        )
        hessian = hessian + slope @ np.swapaxes(leaning, 1, 2)
    return Expansion((value * nodes.weights).sum(axis=-1), np.asarray(gradient), hessian)


@dataclass(frozen=True, slots=True)
class _Jets:
    """Radius (B, N) and the first derivatives (B, 2, N) at the nodes."""

    radius: Floats
    of: tuple[Floats, ...]


def _jets(energy: Energy, quartics: Floats, nodes: Nodes) -> _Jets:
    """Differences are taken first: short legs and far places lose no digits."""
    steps, found = quartics, []
    for falls in nodes.falls[1 : 4 if energy is Energy.VARIATION else 3]:
        steps = steps[:, 1:] - steps[:, :-1]
        found.append(_combined(falls, steps))
    radius = found[0][:, 0]
    if energy is Energy.SURFACE:
        radius = _combined(nodes.falls[0], quartics[:, :, :1])[:, 0]
    return _Jets(radius, tuple(found))


def _combined(falls: tuple[Floats, ...], values: Floats) -> Floats:
    """Return Σ falls[k] values[:, k] as (B, 2, N), of values (B, K, 2)."""
    rows = np.stack(np.broadcast_arrays(*falls), axis=-2)
    return np.asarray(np.swapaxes(values, 1, 2) @ rows)


def _products(energy: Energy, jets: _Jets) -> list[Floats]:
    first, second = jets.of[:2]
    turn, square = _cross(first, second), _dot(first, first)
    if energy is Energy.BENDING:
        return [turn, square]
    if energy is Energy.VARIATION:
        return [turn, square, _dot(first, second), _cross(first, jets.of[2])]
    return [turn, square, jets.radius, first[:, 1]]


def _slopes(
    energy: Energy, jets: _Jets, nodes: Nodes, moves: Moves, weights: list[Floats]
) -> tuple[list[Floats], Floats]:
    """Return the products' derivatives along the moves, (B, m, N), and Σ weights · the second.

    A product u_p∘v_q of derivatives p and q has the second derivative D_p,j D_q,k (e_j∘e_k) +
    D_q,j D_p,k (e_k∘e_j), of moves j and k.
    """
    count, e = len(moves.which), moves.along
    rows = {
        order: np.stack([nodes.row(order, k) for k in moves.which], axis=-2)
        for order in range(0 if energy is Energy.SURFACE else 1, len(jets.of) + 1)
    }
    slopes: list[Floats] = []
    bends = np.zeros((len(e), count, count))

    def add(p: int, q: int, across: bool) -> None:
        u, v = jets.of[p - 1], jets.of[q - 1]
        sign = -1.0 if across else 1.0
        # e × v = e · (v_h, −v_r).
        others = [np.stack([c[:, 1], -c[:, 0]], axis=1) if across else c for c in (u, v)]
        slopes.append(rows[p] * (e @ others[1]) + sign * rows[q] * (e @ others[0]))
        pairs = e @ (np.stack([e[..., 1], -e[..., 0]], axis=1) if across else e.swapaxes(1, 2))
        half = (rows[p] * weights[len(slopes) - 1][:, None, :]) @ np.swapaxes(rows[q], -1, -2)
        bends[...] += (half + sign * np.swapaxes(half, 1, 2)) * pairs

    add(1, 2, across=True)
    add(1, 1, across=False)
    if energy is Energy.VARIATION:
        add(1, 2, across=False)
        add(1, 3, across=True)
    if energy is Energy.SURFACE:
        slopes += [rows[0] * e[..., 0, None], rows[1] * e[..., 1, None]]
    return slopes, bends


_Local = tuple[Floats, list[Floats], dict[tuple[int, int], Floats]]


def _local(energy: Energy, values: list[Floats], derivatives: bool = True) -> _Local:
    """Return φ of the products, its first derivatives and the upper half of its second ones."""
    if energy is Energy.BENDING:
        return _bending(values[0], values[1], derivatives)
    if energy is Energy.VARIATION:
        x, w, z, t = values
        return _variation(x, w, z, t, derivatives)
    x, w, r, k = values
    return _surface(x, w, r, k, derivatives)


def _bending(x: Floats, w: Floats, derivatives: bool) -> _Local:
    power = 1.0 / (w * w * np.sqrt(w))
    value = x * x * power
    if not derivatives:
        return value, [], {}
    first = [2.0 * x * power, -2.5 * value / w]
    second = {
        (0, 0): 2.0 * power,
        (0, 1): -2.5 * first[0] / w,
        (1, 1): -3.5 * first[1] / w,
    }
    return value, first, second


def _variation(x: Floats, w: Floats, z: Floats, t: Floats, derivatives: bool) -> _Local:
    y = t * w - 3.0 * x * z
    slopes = [-3.0 * z, t, -3.0 * x, w]
    w2 = w * w
    power = 1.0 / (w2 * w2 * w * np.sqrt(w))
    value = y * y * power
    if not derivatives:
        return value, [], {}
    double = 2.0 * y * power
    first = [double * slope for slope in slopes]
    second = {(i, j): 2.0 * power * slopes[i] * slopes[j] for i in range(4) for j in range(i, 4)}
    second[0, 2] = second[0, 2] - 3.0 * double
    second[1, 3] = second[1, 3] + double
    # W stands in the power as well.
    fall = -5.5 / w
    for i in range(4):
        key = (min(i, 1), max(i, 1))
        second[key] = second[key] + (2.0 if i == 1 else 1.0) * fall * first[i]
    second[1, 1] = second[1, 1] + 35.75 * value / (w * w)
    first[1] = first[1] + fall * value
    return value, first, second


def _surface(x: Floats, w: Floats, r: Floats, k: Floats, derivatives: bool) -> _Local:
    side = np.where(r < 0.0, -1.0, 1.0)
    bend, bends, bends2 = _bending(x, w, derivatives)
    below = side / (r * np.sqrt(w))
    around = k * k * below
    value = np.abs(r) * bend + around
    if not derivatives:
        return value, [], {}
    first = [
        np.abs(r) * bends[0],
        np.abs(r) * bends[1] - 0.5 * around / w,
        side * bend - around / r,
        2.0 * k * below,
    ]
    second = {
        (0, 0): np.abs(r) * bends2[0, 0],
        (0, 1): np.abs(r) * bends2[0, 1],
        (1, 1): np.abs(r) * bends2[1, 1] + 0.75 * around / (w * w),
        (0, 2): side * bends[0],
        (1, 2): side * bends[1] + 0.5 * around / (w * r),
        (2, 2): 2.0 * around / (r * r),
        (1, 3): -k * below / w,
        (2, 3): -2.0 * k * below / r,
        (3, 3): 2.0 * below,
    }
    return value, first, second


def _cross(u: Floats, v: Floats) -> Floats:
    return u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0]


def _dot(u: Floats, v: Floats) -> Floats:
    return u[:, 0] * v[:, 0] + u[:, 1] * v[:, 1]
