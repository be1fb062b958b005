"""Gauss-Legendre points, and the values of quartics and their derivatives at given parameters."""

from __future__ import annotations

from functools import lru_cache

import numpy as np

from sgb_core.arrays import Floats, Ints, frozen
from sgb_core.curves import basis


@lru_cache(maxsize=64)
def gauss(count: int) -> tuple[Floats, Floats]:
    """Return nodes and weights on [0, 1], each shape (count,).

    Exact for polynomials up to degree 2·count − 1; the weights sum to 1.
    """
    nodes, weights = np.polynomial.legendre.leggauss(count)
    return frozen((nodes + 1.0) / 2.0), frozen(weights / 2.0)


def panels(edges: Floats, count: int) -> tuple[Floats, Floats]:
    """Return composite Gauss nodes and weights over consecutive ``edges``.

    ``count`` points in each of the len(edges) − 1 panels; both results are flat and increasing
    with the edges.
    """
    nodes, weights = gauss(count)
    widths = np.diff(edges)[:, None]
    return (edges[:-1, None] + widths * nodes).ravel(), (widths * weights).ravel()


@lru_cache(maxsize=64)
def derivative_rows(order: int, samples: bytes) -> Floats:
    """Return the matrix that takes Q0..Q4 to a derivative at the sampled s, shape (k, 5).

    ``samples`` are the bytes of a float64 array of k parameters.
    """
    s = np.frombuffer(samples)
    matrix = np.eye(5)
    factor = 1.0
    for k in range(order):
        matrix = np.diff(matrix, axis=0)
        factor *= 4 - k
    return frozen(factor * (basis.bernstein(4 - order, s) @ matrix))


@lru_cache(maxsize=64)
def _bernstein_rows(degree: int, samples: bytes) -> Floats:
    return frozen(basis.bernstein(degree, np.frombuffer(samples)))


def on_nodes(quartics: Floats, s: Floats, order: int = 0) -> Floats:
    """Return a derivative of quartics of shape (..., 5, 2) at ``s``, shape (..., len(s), 2).

    Differences are taken first: a profile far from the origin loses no digits to its position.
    """
    control = quartics
    factor = 1.0
    for k in range(order):
        control = control[..., 1:, :] - control[..., :-1, :]
        factor *= 4 - k
    rows = _bernstein_rows(4 - order, np.ascontiguousarray(s).tobytes())
    return np.asarray(factor * (rows @ control))


def at_each(quartics: Floats, k: Ints, s: Floats, order: int = 0) -> Floats:
    """Return a derivative of quartic ``k[i]`` of (n, 5, 2) at ``s[i]`` for each i, shape (m, 2).

    By de Casteljau's scheme: each value is the same to the last bit whatever else is asked for.
    """
    control, factor = np.ascontiguousarray(np.moveaxis(quartics, 0, -1)), 1.0
    for step in range(order):
        control = control[1:] - control[:-1]
        factor *= 4 - step
    row, t = control[..., k], 1.0 - s
    for _ in range(4 - order):
        row = t * row[:-1] + s * row[1:]
    return np.ascontiguousarray(factor * row[0].T)
