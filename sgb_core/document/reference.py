"""What a profile came from: the source's name, its picture or points, and how true the trace is."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field, replace
from math import cos, radians, sin
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from sgb_core.arrays import Floats
from sgb_core.document.appearance.picture_file import PICTURE, Picture
from sgb_core.fields.extra import NO_EXTRA
from sgb_core.fields.kinds import (
    COORDINATE,
    FINITE,
    LENGTH,
    MAX_COORDINATE,
    SHARE,
    Flag,
    Range,
    Schema,
    Text,
)
from sgb_core.fields.lists import Fixed, OrNone, Several
from sgb_core.fields.record import Record, check, says
from sgb_core.findings.finding import Path
from sgb_core.values import dataclass

# So many points of a source are kept at most; what has more is thinned.
MAX_POINTS = 2000
MAX_NAME = 260
_PAIR = Fixed((COORDINATE, COORDINATE), "a pair [r, h]")
_SCALE = Range(above=0.0, high=MAX_COORDINATE)
_TURN = Range(-360.0, 360.0)


@dataclass(frozen=True, slots=True)
class _Points(Several):
    """Points; files of the first tracer have only their number, of which nothing can be shown."""

    def from_plain(self, value: object, path: Path) -> Any:
        if isinstance(value, int) and not isinstance(value, bool):
            return ()
        return Several.from_plain(self, value, path)

    def schema(self, shared: Schema) -> Schema:
        return {"oneOf": [Several.schema(self, shared), {"type": "integer"}]}


@dataclass(frozen=True, slots=True)
class Reference:
    """The ``reference`` section: the source of a profile, shown behind it where it can be.

    ``origin`` is where (r, h) = (0, 0) lies in the source, in pixels from the top left of a
    picture (y down) and in its own units of everything else (y up); ``scale`` is the length of a
    pixel, or of such a unit, and ``turn_deg`` the lean of the axis, positive where it goes to the
    right downwards. ``axis`` is its abscissa, or a point and a direction. ``points`` are (r, h);
    the deviations are those of the source's points from the profile as it was traced.
    """

    RECORD = Record("reference", "What the profile came from, shown behind it.")

    name: str = field(default="", metadata=says(Text(most=MAX_NAME), label="Source"))
    kind: str = field(default="", metadata=says(Text(most=40), brief=True))
    picture: Picture | None = field(
        default=None, repr=False, metadata=says(OrNone(PICTURE), brief=True)
    )
    points: tuple[tuple[float, float], ...] = field(
        default=(), repr=False, metadata=says(_Points(_PAIR, "points", MAX_POINTS), brief=True)
    )
    axis: tuple[float, ...] = field(default=(), metadata=says(Several(FINITE, "numbers", 6)))
    origin: tuple[float, float] = field(
        default=(0.0, 0.0), metadata=says(Fixed((FINITE, FINITE), "a pair [x, y]"))
    )
    scale: float = field(default=1.0, metadata=says(_SCALE, label="Scale"))
    turn_deg: float = field(default=0.0, metadata=says(_TURN, label="Turn"))
    tolerance: float | None = field(default=None, metadata=says(OrNone(LENGTH)))
    largest_deviation: float | None = field(default=None, metadata=says(OrNone(LENGTH)))
    rms_deviation: float | None = field(default=None, metadata=says(OrNone(LENGTH)))
    left_right: float | None = field(default=None, metadata=says(OrNone(LENGTH)))
    opacity: float = field(default=0.5, metadata=says(SHARE, label="Opacity"))
    shown: bool = field(default=True, metadata=says(Flag()))
    locked: bool = field(default=True, metadata=says(Flag()))
    extra: Mapping[str, object] = field(default_factory=lambda: NO_EXTRA, repr=False, hash=False)

    def __post_init__(self) -> None:
        check(self)

    def placed(self, places: ArrayLike) -> Floats:
        """Return the (r, h) where places of the source lie, both of shape (..., 2)."""
        off = np.asarray(places, dtype=np.float64) - self.origin
        if self.picture is not None:
            off = off * (1.0, -1.0)
        c, s = cos(radians(self.turn_deg)), sin(radians(self.turn_deg))
        return np.asarray(off @ np.array([[c, -s], [s, c]]) * self.scale)

    def moved(self, step: tuple[float, float]) -> Reference:
        """Return the reference moved behind the profile by (r, h)."""
        c, s = cos(radians(self.turn_deg)), sin(radians(self.turn_deg))
        dx, dy = (c * step[0] - s * step[1]) / self.scale, (s * step[0] + c * step[1]) / self.scale
        x, y = self.origin
        return replace(self, origin=(x - dx, y + dy if self.picture is not None else y - dy))

    def enlarged(self, factor: float) -> Reference:
        """Return the same reference to an object ``factor`` times as large, in other numbers."""

        def times(length: float | None) -> float | None:
            return None if length is None else length * factor

        return replace(
            self,
            points=tuple((r * factor, h * factor) for r, h in self.points),
            scale=self.scale * factor,
            tolerance=times(self.tolerance),
            largest_deviation=times(self.largest_deviation),
            rms_deviation=times(self.rms_deviation),
            left_right=times(self.left_right),
        )


def thinned_points(points: Floats) -> tuple[tuple[float, float], ...]:
    """Return at most MAX_POINTS of many points, shape (N, 2), evenly chosen, ends included."""
    count = min(len(points), MAX_POINTS)
    chosen = np.unique(np.linspace(0, len(points) - 1, count).round().astype(np.intp))
    return tuple((r, h) for r, h in points[chosen].tolist())
