"""The law of lobes: n swellings around the turn, round or drawn out to a ridge."""

from __future__ import annotations

from math import pi
from types import MappingProxyType

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.surfaces.laws.shape import LawShape, Settings, beside


def _fraction(law: Settings, theta: Floats) -> Floats:
    half = law.count * theta / 2.0
    round_, ridged = (1.0 - np.cos(2.0 * half)) / 2.0, 1.0 - np.abs(np.cos(half))
    return np.asarray((1.0 - law.sharp) * round_ + law.sharp * ridged)


def _rate(law: Settings, theta: Floats, side: Floats) -> Floats:
    n, half = law.count, law.count * theta / 2.0
    falling = np.sign(np.cos(law.count * beside(theta, side) / 2.0))
    ridged = (n / 2.0) * np.sin(half) * falling
    return np.asarray((1.0 - law.sharp) * (n / 2.0) * np.sin(2.0 * half) + law.sharp * ridged)


def _ridges(law: Settings) -> tuple[float, ...]:
    if law.sharp == 0.0:
        return ()
    return tuple((2 * k + 1) * pi / law.count for k in range(law.count))


LOBES = LawShape(
    "lobes",
    "Lobes",
    "n swellings around the turn: round ones, or drawn out to ridges with hollows between",
    _fraction,
    _rate,
    breaks=_ridges,
    creases=_ridges,
    waves=lambda law: law.count,
    brief=lambda law: f"{law.count} lobes" if law.count > 1 else "1 lobe",
    advice="Sharp 0 is an even wave, 1 a ridge between round hollows, as of a fluted column. "
    "With From and To exchanged the ridges become grooves.",
    uses=("count", "sharp"),
    of_radius=True,
    first=MappingProxyType({"count": 8}),
)
