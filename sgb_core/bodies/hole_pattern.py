"""A pattern of holes with the shapes that it cuts: outlines, a line of text, parts of a picture."""

from __future__ import annotations

from functools import lru_cache

import numpy as np
import shapely
from shapely.geometry.base import BaseGeometry

from sgb_core.arrays import Floats, frozen
from sgb_core.bodies.cut_outs import CutOut, HoleShape, place_count
from sgb_core.bodies.meridian import SolidError
from sgb_core.bodies.stencil import Shapes, Stencil, stencil_of
from sgb_core.findings.cut_outs import IslandsFallOut, NothingToCut, TooManyHoles
from sgb_core.lettering.fonts import FontName
from sgb_core.lettering.outlines import text_letters
from sgb_core.values import dataclass

# Outlines of all holes have at most so many points: more would take minutes to cut.
MOST_POINTS = 1_000_000
# Of the least bridge: how far what stands beside one may be drawn straighter.
_GIVES = 0.1


@dataclass(frozen=True, slots=True)
class Pattern:
    """A pattern, and where it is drawn the ``shapes`` of its picture, which is 1 wide."""

    cut_out: CutOut
    shapes: Shapes | None = None


@dataclass(frozen=True, slots=True, eq=False)
class Drawn:
    """What one place of a pattern cuts: ``outlines`` (k, 2) each, and the ``union`` of them.

    ``extent`` is the width and the height of all.
    """

    outlines: tuple[Floats, ...]
    union: BaseGeometry
    extent: tuple[float, float]


def drawn_of(
    pattern: Pattern, number: int, whole: bool, lean: float = 0.0, within: float | None = None
) -> Drawn:
    """Return what a pattern cuts at each of its places; ``number`` is the pattern's own.

    Outlines are ``within`` so much of what was asked for; without it they are as fine as any use
    needs. The union always is, so that what is refused does not depend on it.

    A twist that makes shapes ``lean`` so much around for each unit up narrows bridges: drawn ones
    are as much wider.

    Raises SolidError where islands would fall out, where there is nothing to cut, and for more
    than can be cut.
    """
    cut_out = pattern.cut_out
    if cut_out.shape.is_drawn:
        stencil = _stencil(pattern, lean)
        if stencil is None:
            raise SolidError(IslandsFallOut(number, cut_out.bridge))
        if not stencil.pieces:
            raise SolidError(NothingToCut(number, cut_out.shape is HoleShape.TEXT))
        outlines = stencil.outlines
        if within is not None:
            # Neighbours that both give way must not meet.
            slack = min(within, _GIVES * cut_out.bridge)
            outlines = tuple(_straighter(outline, slack) for outline in outlines)
        drawn = Drawn(outlines, stencil.shapes, (stencil.width, stencil.height))
    else:
        outline = frozen(cut_out.outline(within))
        drawn = Drawn((outline,), shapely.Polygon(cut_out.outline()), cut_out.extent)
    points = sum(map(len, drawn.outlines))
    places = place_count(cut_out, whole)
    if places * points > MOST_POINTS:
        raise SolidError(TooManyHoles(number, places * len(drawn.outlines)))
    return drawn


def _straighter(outline: Floats, slack: float) -> Floats:
    """Return an outline within ``slack`` of one, of fewer points where that is possible."""
    found = shapely.Polygon(outline).simplify(slack)
    if not isinstance(found, shapely.Polygon) or found.is_empty or not found.is_valid:
        return outline
    return frozen(shapely.get_coordinates(shapely.orient_polygons(found).exterior)[:-1])


def _stencil(pattern: Pattern, lean: float) -> Stencil | None:
    cut_out = pattern.cut_out
    # The shear by k shortens no length by more than to (√(k² + 4) − k)/2 of it.
    bridge = cut_out.bridge * 2.0 / (np.sqrt(lean * lean + 4.0) - lean)
    if cut_out.shape is HoleShape.TEXT:
        shapes = _letters(cut_out.text, cut_out.font)
        return stencil_of(shapes, cut_out.height, bridge, True)
    return stencil_of(pattern.shapes or Shapes(()), cut_out.width, bridge, False)


@lru_cache(maxsize=16)
def _letters(text: str, font: FontName) -> Shapes:
    return Shapes(text_letters(text, font))
