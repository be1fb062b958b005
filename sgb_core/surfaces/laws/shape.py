"""The shapes of laws: f(θ) in [0, 1] under a name, with all that others need to know of it.

A shape is declared in a module of its own and stands in :mod:`sgb_core.surfaces.laws.shapes`;
files, panels, schema and meshes ask for no more.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import field
from math import pi
from types import MappingProxyType
from typing import Any, Protocol

import numpy as np

from sgb_core.arrays import Floats
from sgb_core.values import dataclass


class Settings(Protocol):
    """What a law says beyond its shape's name; a shape reads those it ``uses``."""

    @property
    def count(self) -> int:
        """n, how often the shape is repeated in a turn."""

    @property
    def keyframes(self) -> tuple[tuple[float, float], ...]:
        """(degrees, f) of points that the curve runs through."""

    @property
    def sharp(self) -> float:
        """How far lobes are drawn out to ridges, 0 to 1."""

    @property
    def round(self) -> float:
        """The radius of a polygon's corners as a part of the circle's."""

    @property
    def flank(self) -> float:
        """The width of a steep flank, in degrees."""


Angles = Callable[[Settings], tuple[float, ...]]


def _nowhere(law: Settings) -> tuple[float, ...]:
    return ()


def _once(law: Settings) -> int:
    return 1


def _whole(law: Settings) -> tuple[float, float]:
    return 0.0, 1.0


def beside(theta: Floats, side: Floats) -> Floats:
    """Return angles just after (side +1) or before them (−1): a step far below any distance."""
    return np.asarray(theta + 1e-12 * side)


def from_nearest(law: Settings, theta: Floats) -> Floats:
    """Return the angles from the middle of the nearest of n equal waves, in [−π/n, π/n]."""
    wave = 2.0 * pi / law.count
    return np.asarray(np.mod(theta + wave / 2.0, wave) - wave / 2.0)


@dataclass(frozen=True, slots=True, eq=False)
class LawShape:
    """f(θ) of a law; θ in radians from the start angle, period 2π.

    ``fraction`` is f, ``rate`` df/dθ per radian, at creases from the side (+1 after, −1 before)
    that its last argument names. ``breaks`` are the angles in [0, 2π) where f is not smooth,
    ``creases`` those where the rate jumps. ``waves`` is how often f repeats itself in a turn,
    each wave the mirror image of itself about its extremes at θ = 0 and after half of it; 0 says
    that there is no such symmetry.

    ``title`` and ``tip`` are its words in a list, ``brief`` those of one law in a line, ``advice``
    what is good to know of it. ``uses`` are the fields of a law that it reads, those that it
    ``requires`` are not empty, and ``first`` holds what a new law has for them.
    ``keys_a_wave`` keyframes follow a wave of its curve closely. ``span`` gives the least and the
    greatest f, ``least_count`` the smallest n that makes sense, and ``natural`` the from and to of
    a new law of the radius; ``of_radius``: what a new law of this shape varies is the radius.
    """

    name: str
    title: str
    tip: str
    fraction: Callable[[Settings, Floats], Floats]
    rate: Callable[[Settings, Floats, Floats], Floats]
    breaks: Angles = _nowhere
    creases: Angles = _nowhere
    waves: Callable[[Settings], int] = _once
    brief: Callable[[Settings], str] | None = None
    advice: str = "Double-click the curve to shape it by keys of your own."
    uses: tuple[str, ...] = ()
    requires: tuple[str, ...] = ()
    first: Mapping[str, Any] = field(default_factory=lambda: MappingProxyType({}))
    keys_a_wave: int = 8
    span: Callable[[Settings], tuple[float, float]] = _whole
    least_count: int = 1
    natural: tuple[float, float] = (0.95, 1.05)
    of_radius: bool = False

    @property
    def is_smooth(self) -> bool:
        """Whether no law of this shape leaves creases."""
        return self.creases is _nowhere

    def words(self, law: Settings) -> str:
        """Return a law of this shape in few words, as "5 waves"."""
        return self.title.lower() if self.brief is None else self.brief(law)
