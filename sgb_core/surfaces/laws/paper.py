"""The law of the paper: even steps of the rational parameter t over each half turn."""

from __future__ import annotations

from math import pi

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.surfaces.laws.shape import LawShape, Settings, beside
from sgb_core.surfaces.transfinite import half_turn_parameter


def _fraction(law: Settings, theta: Floats) -> Floats:
    return half_turn_parameter(pi - np.abs(np.mod(theta, 2.0 * pi) - pi))


def _rate(law: Settings, theta: Floats, side: Floats) -> Floats:
    turn = np.mod(beside(theta, side), 2.0 * pi)
    t = _fraction(law, theta)
    return np.where(turn < pi, 0.5, -0.5) * (2.0 * t * t - 2.0 * t + 1.0)


def _creases(law: Settings) -> tuple[float, ...]:
    return (0.0, pi)


PAPER = LawShape(
    "paper",
    "Paper’s law",
    "The law of the paper: even steps of its rational parameter t.\n"
    "It leaves a crease on two meridians, at the start and opposite",
    _fraction,
    _rate,
    breaks=_creases,
    creases=_creases,
    advice="The paper’s law leaves a crease on two meridians: at the start angle and opposite. "
    "The cosine laws are smooth.",
    # Steepest halfway.
    keys_a_wave=12,
)
