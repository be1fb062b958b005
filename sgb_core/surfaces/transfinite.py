"""The half turn as the paper constructs it, and its closed form.

A rotation surface is the transfinite interpolant through the profile A0, its quarter turn A½
and its half turn A1: a Thiele-type continued fraction in t with the Samelson inverse of
vectors (bivariate Thiele-type vector-valued rational interpolation, BTVRI).
"""

from __future__ import annotations

from math import pi

import numpy as np
from numpy.typing import ArrayLike

from sgb_core.arrays import Floats


def samelson_inverse(vectors: ArrayLike) -> Floats:
    """Return v/|v|², (9), of vectors of shape (..., k). Undefined (raises) for a zero vector."""
    v = np.asarray(vectors, dtype=np.float64)
    square = np.sum(v * v, axis=-1, keepdims=True)
    if not np.all(square > 0.0):
        raise ValueError("the Samelson inverse of a zero vector is undefined")
    return np.asarray(v / square)


def interpolant(start: ArrayLike, quarter: ArrayLike, half: ArrayLike, t: ArrayLike) -> Floats:
    """Return R(t) = V0 + t/(V1 + (t − ½)/V2) of (10) and (21), nodes t = 0, ½, 1.

    ``start``, ``quarter``, ``half`` are A0, A½, A1 of (17), shape (..., 3); ``t`` broadcasts
    against their leading axes. V0..V2 are (18)–(20). Raises ValueError at r = 0, where the
    Samelson inverse is undefined; :func:`closed_form` is the limit there.
    """
    a0, a_half, a1 = (np.asarray(a, dtype=np.float64) for a in (start, quarter, half))
    t = np.asarray(t, dtype=np.float64)[..., None]
    first = 0.5 * samelson_inverse(a_half - a0)
    f02 = samelson_inverse(a1 - a0)
    second = 0.5 * samelson_inverse(f02 - first)
    # At t = 0 and ½ a numerator vanishes; the fraction then ends there.
    tail = first + (t - 0.5) * samelson_inverse(second)
    return np.asarray(a0 + t * samelson_inverse(tail))


def half_turn_cosine_sine(t: ArrayLike) -> tuple[Floats, Floats]:
    """Return cos θ = (1−2t)/(2t²−2t+1) and sin θ = (2t−2t²)/(2t²−2t+1) of (24)."""
    t = np.asarray(t, dtype=np.float64)
    weight = 2.0 * t * t - 2.0 * t + 1.0
    return np.asarray((1.0 - 2.0 * t) / weight), np.asarray(2.0 * t * (1.0 - t) / weight)


def closed_form(start: ArrayLike, quarter: ArrayLike, half: ArrayLike, t: ArrayLike) -> Floats:
    """Return the half turn (24) through A0, A½, A1, shapes (..., 3); defined at r = 0 too."""
    a0, a_half, a1 = (np.asarray(a, dtype=np.float64) for a in (start, quarter, half))
    on_axis = (a0 + a1) / 2.0
    cosine, sine = (c[..., None] for c in half_turn_cosine_sine(t))
    return np.asarray(on_axis + cosine * (a0 - on_axis) + sine * (a_half - on_axis))


def half_turn_parameter(theta: ArrayLike) -> Floats:
    """Return t = sin(θ/2)/(sin(θ/2) + cos(θ/2)) for θ in [0, π], so that R(t) is turned by θ."""
    half = np.asarray(theta, dtype=np.float64) / 2.0
    sine, cosine = np.sin(half), np.cos(half)
    return np.asarray(sine / (sine + cosine))


def turn_parameter(theta: ArrayLike) -> Floats:
    """Return the rational parameter of θ in [0, 2π], running 0..1 over R and 1..2 back over R̃."""
    theta = np.asarray(theta, dtype=np.float64)
    mirrored = half_turn_parameter(pi - np.abs(theta - pi))
    return np.where(theta <= pi, mirrored, 2.0 - mirrored)


def turn_angle(parameter: ArrayLike) -> Floats:
    """Return the angle in [0, 2π] whose :func:`turn_parameter` this is, in [0, 2]."""
    u = np.asarray(parameter, dtype=np.float64)
    t = 1.0 - np.abs(1.0 - u)
    theta = 2.0 * np.arctan2(t, 1.0 - t)
    return np.where(u <= 1.0, theta, 2.0 * pi - theta)
