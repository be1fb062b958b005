"""Laws by which a shape parameter depends on the rotation angle."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import StrEnum

from sgb_core.curves.segment import NO_EXTRA, ParameterName


class LawKind(StrEnum):
    """The shapes of f(θ) in value = from + (to − from)·f(θ); θ counts from the start angle."""

    PAPER = "paper"
    RAISED_COSINE = "raised-cosine"
    COSINE = "cosine"
    KEYFRAMES = "keyframes"


@dataclass(frozen=True, slots=True)
class Law:
    """One shape parameter of some segments as a function of the angle.

    ``segments`` is None for all of them. ``count`` is the n of the n-fold cosine and
    ``keyframes`` holds (degrees, f) pairs, f in [0, 1].
    """

    parameter: ParameterName
    kind: LawKind
    start: float
    end: float
    segments: tuple[int, ...] | None = None
    count: int = 1
    keyframes: tuple[tuple[float, float], ...] = ()
    extra: Mapping[str, object] = field(default=NO_EXTRA, repr=False)
