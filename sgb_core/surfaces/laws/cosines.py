"""The cosine laws: even waves around the turn, smooth everywhere."""

from __future__ import annotations

from types import MappingProxyType

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.surfaces.laws.shape import LawShape, Settings


def _raised(law: Settings, theta: Floats) -> Floats:
    return np.asarray((1.0 - np.cos(theta)) / 2.0)


def _raised_rate(law: Settings, theta: Floats, side: Floats) -> Floats:
    return np.asarray(np.sin(theta) / 2.0)


def _waves(law: Settings, theta: Floats) -> Floats:
    return np.asarray((1.0 - np.cos(law.count * theta)) / 2.0)


def _waves_rate(law: Settings, theta: Floats, side: Floats) -> Floats:
    return np.asarray(law.count * np.sin(law.count * theta) / 2.0)


RAISED_COSINE = LawShape(
    "raised-cosine",
    "Raised cosine",
    "Swells once around the turn, smooth everywhere",
    _raised,
    _raised_rate,
)
COSINE = LawShape(
    "cosine",
    "Cosine, n waves",
    "n even waves around the turn, smooth everywhere: flutes and lobes",
    _waves,
    _waves_rate,
    waves=lambda law: law.count,
    brief=lambda law: f"{law.count} waves" if law.count > 1 else "1 wave",
    uses=("count",),
    first=MappingProxyType({"count": 5}),
)
