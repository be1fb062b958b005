"""The dark parts of a picture as shapes, which cut-outs take away."""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from itertools import pairwise

import numpy as np
import shapely

from sgb_core.arrays import Floats
from sgb_core.bodies.cut_outs import CutOut, HoleShape
from sgb_core.bodies.hole_pattern import Pattern
from sgb_core.bodies.stencil import Shapes
from sgb_core.document.appearance.model import Appearance
from sgb_core.document.appearance.picture_file import Picture
from sgb_core.document.appearance.pictures import GREY, picture_named

# A picture is taken at so many pixels across at most; a line of it is straight within so many.
_WIDE = 400.0
_STRAIGHT = 0.15
# Weights of a pixel and its neighbours: a bell of one pixel's deviation.
_BELL = np.array([1.0, 4.0, 6.0, 4.0, 1.0]) / 16.0
# A dark part with fewer pixels is noise.
_LEAST = 6.0


def patterns_of(cut_outs: Sequence[CutOut], appearance: Appearance) -> tuple[Pattern, ...]:
    """Return cut-outs with the shapes of their pictures; raises PictureError for one unknown."""
    return tuple(_pattern(cut_out, appearance) for cut_out in cut_outs)


def _pattern(cut_out: CutOut, appearance: Appearance) -> Pattern:
    if cut_out.shape is not HoleShape.PICTURE:
        return Pattern(cut_out)
    own = appearance.picture(cut_out.picture)
    return Pattern(cut_out, dark_parts(cut_out.picture, own, cut_out.threshold))


@lru_cache(maxsize=16)
def dark_parts(name: str, own: Picture | None, threshold: float) -> Shapes:
    """Return what is darker than a threshold, from 0 to 1, in a picture that is 1 wide.

    ``own`` is the document's picture of that name, where it is one. Raises PictureError.
    """
    # Imported late: it takes a while to load.
    from contourpy import FillType, contour_generator

    look = Appearance() if own is None else Appearance(pictures=(own,))
    tile = picture_named(look, name, _WIDE)
    cover = tile[..., 3:] / 255.0
    grey = ((tile[..., :3] * cover + 255.0 * (1.0 - cover)) @ GREY) / 255.0
    width = grey.shape[1]
    # A margin of white closes what the picture's edge cuts.
    padded = _softened(np.pad(grey, 3, constant_values=1.0))
    lines = contour_generator(z=padded, fill_type=FillType.OuterOffset)
    points, offsets, *_ = lines.filled(-1.0, max(threshold, 1e-6))
    parts = []
    for outline, starts in zip(points, offsets, strict=True):
        assert outline is not None
        assert starts is not None
        rings = [outline[a:b] for a, b in pairwise(starts)]
        parts += _polygons(rings)
    scaled = (shapely.transform(part, lambda points: points / width) for part in parts)
    return Shapes(tuple(sorted(scaled, key=lambda part: part.bounds[0])))


def _softened(grey: Floats) -> Floats:
    """Return a picture whose pixels' steps are gone from its outlines."""
    for axis in (0, 1):
        parts = (
            weight * np.roll(grey, shift, axis)
            for shift, weight in zip(range(-2, 3), _BELL, strict=True)
        )
        grey = np.sum(list(parts), axis=0)
    return grey


def _polygons(rings: Sequence[Floats]) -> list[shapely.Polygon]:
    """Return the polygons of an outline in pixels and what it leaves out, without noise."""
    holes = [ring for ring in rings[1:] if shapely.Polygon(ring).area > _LEAST]
    whole = shapely.make_valid(shapely.Polygon(rings[0], holes).simplify(_STRAIGHT))
    parts = shapely.get_parts(whole)
    return [each for each in parts if isinstance(each, shapely.Polygon) and each.area > _LEAST]
