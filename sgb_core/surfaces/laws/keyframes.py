"""The law through keys: a smooth periodic curve that stays between neighbouring ones."""

from __future__ import annotations

from collections.abc import Sequence
from math import pi
from types import MappingProxyType

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.surfaces.laws.shape import LawShape, Settings


def _knots(keyframes: Sequence[tuple[float, float]]) -> tuple[Floats, Floats]:
    """Return the keys' angles in [0, 2π), increasing, and their values."""
    turned = {degrees % 360.0: value for degrees, value in keyframes}
    order = sorted(turned)
    return np.deg2rad(order), np.array([turned[degrees] for degrees in order])


def _keyframe_curve(
    keyframes: Sequence[tuple[float, float]], theta: Floats
) -> tuple[Floats, Floats]:
    """Return the periodic interpolant of the keys and its rate.

    Piecewise cubic Hermite, C1, with the slopes of Fritsch and Butland (1984): zero at a key
    that is a local extreme, else the weighted harmonic mean of the two neighbouring secants.
    Such slopes satisfy Fritsch and Carlson's condition, so each piece is monotone and stays
    between its two keys.
    """
    angles, values = _knots(keyframes)
    if len(angles) == 1:
        return np.full(theta.shape, values[0]), np.zeros(theta.shape)
    steps = np.diff(angles, append=angles[0] + 2.0 * pi)
    secants = np.diff(values, append=values[0]) / steps
    slopes = monotone_slopes(np.roll(steps, 1), steps, np.roll(secants, 1), secants)
    turn = np.mod(theta - angles[0], 2.0 * pi)
    piece = np.clip(np.searchsorted(angles - angles[0], turn, side="right") - 1, 0, None)
    after = (piece + 1) % len(angles)
    step = steps[piece]
    x = (turn - (angles[piece] - angles[0])) / step
    y0, y1, m0, m1 = values[piece], values[after], slopes[piece] * step, slopes[after] * step
    rise = y1 - y0
    cubic, square = m0 + m1 - 2.0 * rise, 3.0 * rise - 2.0 * m0 - m1
    curve = y0 + x * (m0 + x * (square + x * cubic))
    curve = np.clip(curve, np.minimum(y0, y1), np.maximum(y0, y1))
    return curve, (m0 + x * (2.0 * square + 3.0 * x * cubic)) / step


def monotone_slopes(before: Floats, after: Floats, left: Floats, right: Floats) -> Floats:
    """Return the slopes of Fritsch and Butland at keys, from steps and secants on both sides."""
    w1, w2 = 2.0 * after + before, after + 2.0 * before
    same = left * right > 0.0
    below = np.where(same, w1 * right + w2 * left, 1.0)
    return np.where(same, (w1 + w2) * (left * right) / below, 0.0)


def _span(law: Settings) -> tuple[float, float]:
    values = [value for _, value in law.keyframes]
    return min(values), max(values)


KEYFRAMES = LawShape(
    "keyframes",
    "Keyframes",
    "A curve of your own through keys that you drag",
    lambda law, theta: _keyframe_curve(law.keyframes, theta)[0],
    lambda law, theta, side: _keyframe_curve(law.keyframes, theta)[1],
    breaks=lambda law: tuple(_knots(law.keyframes)[0]),
    waves=lambda law: 0,
    advice="Double-click adds a key, drag moves it, Del removes it.",
    uses=("keyframes",),
    requires=("keyframes",),
    span=_span,
    first=MappingProxyType({"keyframes": ((0.0, 0.0), (120.0, 1.0), (240.0, 0.5))}),
)
