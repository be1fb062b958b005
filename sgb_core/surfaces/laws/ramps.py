"""Laws of straight ramps: the square wave with its flanks, and the sawtooth."""

from __future__ import annotations

from math import pi, radians
from types import MappingProxyType

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.surfaces.laws.shape import LawShape, Settings, beside, from_nearest


def _wave(law: Settings) -> tuple[float, float]:
    """Return the width of a wave and that of a flank, at most half of it, in radians."""
    wave = 2.0 * pi / law.count
    return wave, min(radians(law.flank), wave / 2.0)


def _square(law: Settings, theta: Floats) -> Floats:
    wave, flank = _wave(law)
    away = np.abs(from_nearest(law, theta))
    return np.asarray(np.clip((away - wave / 4.0) / flank + 0.5, 0.0, 1.0))


def _square_rate(law: Settings, theta: Floats, side: Floats) -> Floats:
    wave, flank = _wave(law)
    turned = from_nearest(law, beside(theta, side))
    inside = np.abs(np.abs(turned) - wave / 4.0) < flank / 2.0
    return np.where(inside, np.where(turned >= 0.0, 1.0, -1.0) / flank, 0.0)


def _square_breaks(law: Settings) -> tuple[float, ...]:
    wave, flank = _wave(law)
    ends = [wave / 4.0 - flank / 2.0, wave / 4.0 + flank / 2.0]
    ends += [wave - end for end in ends]
    # Flanks that meet have one end in common.
    if flank == wave / 2.0:
        ends = [0.0, wave / 2.0]
    return tuple(k * wave + end for k in range(law.count) for end in ends)


def _sawtooth(law: Settings, theta: Floats) -> Floats:
    wave, flank = _wave(law)
    turned = np.mod(theta, wave)
    return np.asarray(np.minimum(turned / (wave - flank), (wave - turned) / flank))


def _sawtooth_rate(law: Settings, theta: Floats, side: Floats) -> Floats:
    wave, flank = _wave(law)
    rising = np.mod(beside(theta, side), wave) < wave - flank
    return np.where(rising, 1.0 / (wave - flank), -1.0 / flank)


def _sawtooth_breaks(law: Settings) -> tuple[float, ...]:
    wave, flank = _wave(law)
    return tuple(k * wave + end for k in range(law.count) for end in (0.0, wave - flank))


SQUARE = LawShape(
    "square",
    "Square wave",
    "n flat tops and n flat hollows with straight flanks between: staves, keyways, gear-like rims",
    _square,
    _square_rate,
    breaks=_square_breaks,
    creases=_square_breaks,
    waves=lambda law: law.count,
    brief=lambda law: f"{law.count} steps" if law.count > 1 else "1 step",
    advice="Flanks as wide as half a wave meet: a wave of straight lines.",
    uses=("count", "flank"),
    of_radius=True,
    first=MappingProxyType({"count": 8}),
)
SAWTOOTH = LawShape(
    "sawtooth",
    "Sawtooth",
    "n slow rises, each with a steep flank back: a ratchet, overlapping leaves",
    _sawtooth,
    _sawtooth_rate,
    breaks=_sawtooth_breaks,
    creases=_sawtooth_breaks,
    # No wave is its own mirror image.
    waves=lambda law: 0,
    brief=lambda law: f"{law.count} teeth" if law.count > 1 else "1 tooth",
    advice="A flank is at most half a tooth wide.",
    uses=("count", "flank"),
    of_radius=True,
    first=MappingProxyType({"count": 12}),
)
