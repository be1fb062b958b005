"""What a person can say about a source beside its name."""

from __future__ import annotations

from enum import StrEnum
from math import hypot, isfinite, radians

from sgb_core.document.model import Unit
from sgb_core.fields.kinds import Range, Said
from sgb_core.findings.refusal import Argument
from sgb_core.findings.sources import NoSource
from sgb_core.sources.errors import SourceError
from sgb_core.values import dataclass

Point = tuple[float, float]
_POSITIVE = Range(above=0.0)
_BETWEEN = Said("a number between 0 and 1")
# A picture that lies further askew is to be turned first.
MOST_LEAN = radians(45.0)
_UPRIGHT = Said("auto or the abscissa of the upright axis")


class Side(StrEnum):
    """Which side of the axis becomes the profile; both: their mean."""

    LEFT = "left"
    RIGHT = "right"
    BOTH = "both"


@dataclass(frozen=True, slots=True)
class ScaleBar:
    """Two points of a picture, in pixels, and their true distance in the unit."""

    start: Point
    end: Point
    length: float

    def __post_init__(self) -> None:
        if not (self.pixels > 0.0 and isfinite(self.pixels)):
            raise SourceError(Argument("scale_bar", self.pixels, _POSITIVE))
        if not (self.length > 0.0 and isfinite(self.length)):
            raise SourceError(Argument("scale_bar", self.length, _POSITIVE))

    @property
    def pixels(self) -> float:
        """The distance of its ends in pixels."""
        return hypot(self.end[0] - self.start[0], self.end[1] - self.start[1])


@dataclass(frozen=True, slots=True)
class Options:
    """How a source is to be read; lengths are in ``unit``.

    ``axis`` is None for auto, the abscissa of an upright axis, a letter x, y or z, or a point and
    a direction (px, py, pz, dx, dy, dz). ``lean`` is how far a picture's given axis leans from
    upright, in radians, positive where it goes to the right downwards. At most one of ``height``,
    ``scale`` and ``scale_bar`` says how large a picture's pixels are. ``clicks`` are points near
    the line wanted, ``threshold`` in (0, 1) is how far from the ground's brightness towards the
    object's the outline of a picture lies, None for the best. ``path`` is the number of the path
    of a drawing, the likely one first. With ``merge`` exact pieces are traced too. Raises
    SourceError for values that mean nothing.
    """

    unit: Unit = Unit.MM
    tolerance: float | None = None
    height: float | None = None
    scale: float | None = None
    scale_bar: ScaleBar | None = None
    axis: float | str | tuple[float, ...] | None = None
    side: Side = Side.BOTH
    lean: float = 0.0
    clicks: tuple[Point, ...] = ()
    threshold: float | None = None
    path: int = 0
    merge: bool = False

    def __post_init__(self) -> None:
        for name in ("tolerance", "height", "scale"):
            value = getattr(self, name)
            if value is not None and not (isfinite(value) and value > 0.0):
                raise SourceError(Argument(name, value, _POSITIVE))
        given = [self.height, self.scale, self.scale_bar]
        if sum(value is not None for value in given) > 1:
            raise SourceError(NoSource.SCALES)
        if self.clicks and len(self.clicks) < 2:
            raise SourceError(Argument("clicks", len(self.clicks), Said("at least 2 points")))
        if self.threshold is not None and not 0.0 < self.threshold < 1.0:
            raise SourceError(Argument("threshold", self.threshold, _BETWEEN))
        if not abs(self.lean) <= MOST_LEAN:
            raise SourceError(Argument("lean", self.lean, Range(-MOST_LEAN, MOST_LEAN)))

    def upright_axis(self) -> float | None:
        """Return the abscissa of the axis, None for auto; SourceError where it is none."""
        if self.axis is None or isinstance(self.axis, float):
            return self.axis
        raise SourceError(Argument("axis", self.axis, _UPRIGHT))
