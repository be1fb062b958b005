"""A page as frozen values in millimetres: lines, areas and words on layers, y upwards.

Widths and dashes are those of ISO 128-20: wide lines of 0.5 mm, narrow ones half as wide.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import field
from enum import StrEnum
from types import MappingProxyType

import numpy as np

from sgb_core.arrays import Floats, frozen
from sgb_core.values import dataclass

WIDE, NARROW, FINE = 0.5, 0.25, 0.18
BLACK = "#000000"
# Long dashes and dots of a line 0.25 wide: 24, 3, 0.5 and 3 times that.
CENTRE_DASHES = (6.0, 0.75, 0.125, 0.75)


class Layer(StrEnum):
    """What a mark belongs to, from what lies at the back to what lies on top."""

    PAINT = "paint"
    MATERIAL = "material"
    HATCH = "hatch"
    OUTLINE = "outline"
    EDGES = "edges"
    AXIS = "axis"
    DIMENSIONS = "dimensions"
    SCALE = "scale"
    CUT = "cut"
    CROSSES = "crosses"
    FRAME = "frame"
    TEXT = "text"


class Anchor(StrEnum):
    """Which end of words stands at their place."""

    START = "start"
    MIDDLE = "middle"
    END = "end"


@dataclass(frozen=True, slots=True)
class Pen:
    """How a line is drawn: its width, dashes and gaps in millimetres, and its colour."""

    width: float = NARROW
    dashes: tuple[float, ...] = ()
    colour: str = BLACK


PENS: Mapping[Layer, Pen] = MappingProxyType(
    {
        Layer.PAINT: Pen(FINE),
        Layer.MATERIAL: Pen(FINE),
        Layer.HATCH: Pen(FINE),
        Layer.OUTLINE: Pen(WIDE),
        Layer.EDGES: Pen(NARROW),
        Layer.AXIS: Pen(NARROW, CENTRE_DASHES),
        Layer.DIMENSIONS: Pen(NARROW),
        Layer.SCALE: Pen(NARROW),
        Layer.CUT: Pen(0.35),
        Layer.CROSSES: Pen(NARROW),
        Layer.FRAME: Pen(NARROW),
        Layer.TEXT: Pen(NARROW),
    }
)


@dataclass(frozen=True, slots=True, eq=False)
class Path:
    """A run of straight lines, each (2, 2), and cubic Bézier curves, each (4, 2), end to start."""

    pieces: tuple[Floats, ...]
    closed: bool = False

    @classmethod
    def through(cls, points: Iterable[tuple[float, float]], closed: bool = False) -> Path:
        """Return straight lines from point to point, and back to the first where ``closed``."""
        corners = np.array(list(points), dtype=np.float64)
        ends = np.roll(corners, -1, axis=0) if closed else corners[1:]
        starts = corners if closed else corners[:-1]
        steps = zip(starts, ends, strict=True)
        return cls(tuple(frozen(np.stack(step)) for step in steps), closed)

    def moved(self, scale: float, shift: tuple[float, float], mirrored: bool = False) -> Path:
        """Return the path enlarged about (0, 0), mirrored at x = 0 if so, and then shifted."""
        factor = np.array([-scale if mirrored else scale, scale])
        pieces = tuple(frozen(piece * factor + shift) for piece in self.pieces)
        return Path(pieces, self.closed)

    def flat(self, per_curve: int = 24) -> Floats:
        """Return points of the path, shape (k, 2), the ends of all pieces among them."""
        t = np.linspace(0.0, 1.0, per_curve + 1)[:, None]
        found = [self.pieces[0][:1]]
        for piece in self.pieces:
            if len(piece) == 2:
                found.append(piece[1:])
                continue
            a, b, c, d = piece
            s = 1.0 - t
            curve = s**3 * a + 3 * s**2 * t * b + 3 * s * t**2 * c + t**3 * d
            found.append(curve[1:])
        return np.concatenate(found)


@dataclass(frozen=True, slots=True, eq=False)
class Stroke:
    """Paths drawn with a pen, by default that of the layer."""

    layer: Layer
    paths: tuple[Path, ...]
    pen: Pen = field(default=Pen())

    @classmethod
    def of(cls, layer: Layer, *paths: Path, pen: Pen | None = None) -> Stroke:
        """Return paths drawn with the layer's own pen, or with another."""
        return cls(layer, paths, PENS[layer] if pen is None else pen)


@dataclass(frozen=True, slots=True, eq=False)
class Area:
    """What closed paths bound, filled; paths inside others leave holes (even-odd)."""

    layer: Layer
    paths: tuple[Path, ...]
    colour: str = BLACK


@dataclass(frozen=True, slots=True)
class Words:
    """A line of text; ``height`` is that of its capitals, ``turn_deg`` anticlockwise."""

    text: str
    at: tuple[float, float]
    height: float
    anchor: Anchor = Anchor.START
    turn_deg: float = 0.0
    layer: Layer = Layer.TEXT


Mark = Stroke | Area | Words


@dataclass(frozen=True, slots=True, eq=False)
class Page:
    """One sheet: its size, the margins (left, right, bottom, top) and what is drawn on it.

    ``scale`` is how many millimetres of paper show one of the object, ``origin`` where the
    axis crosses the height 0 of the (first) object.
    """

    width: float
    height: float
    margins: tuple[float, float, float, float]
    marks: tuple[Mark, ...]
    scale: float = 1.0
    origin: tuple[float, float] = (0.0, 0.0)

    def of_layer(self, layer: Layer) -> tuple[Mark, ...]:
        """Return the marks of one layer."""
        return tuple(mark for mark in self.marks if mark.layer is layer)

    @property
    def layers(self) -> tuple[Layer, ...]:
        """The layers that have marks, from the back to the front."""
        used = {mark.layer for mark in self.marks}
        return tuple(layer for layer in Layer if layer in used)

    @property
    def letters(self) -> str:
        """Each letter that stands on the page, once."""
        return "".join(
            sorted({c for mark in self.marks if isinstance(mark, Words) for c in mark.text})
        )


@dataclass(frozen=True, slots=True, eq=False)
class Drawing:
    """Pages with what a file says of them; ``date`` is YYYY-MM-DD or empty.

    Curves on the paper stay within ``tolerance`` (mm) of what they show.
    """

    pages: tuple[Page, ...]
    title: str
    subject: str
    tolerance: float
    date: str = ""
    keywords: tuple[str, ...] = ()
