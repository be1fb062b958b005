"""All shapes of laws by name: those that come with the program, and those added to them."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from types import MappingProxyType

from sgb_core.surfaces.laws.cosines import COSINE, RAISED_COSINE
from sgb_core.surfaces.laws.keyframes import KEYFRAMES
from sgb_core.surfaces.laws.lobes import LOBES
from sgb_core.surfaces.laws.paper import PAPER
from sgb_core.surfaces.laws.polygon import POLYGON
from sgb_core.surfaces.laws.ramps import SAWTOOTH, SQUARE
from sgb_core.surfaces.laws.shape import LawShape

_SHIPPED = (PAPER, RAISED_COSINE, COSINE, LOBES, POLYGON, SQUARE, SAWTOOTH, KEYFRAMES)
_shapes = {shape.name: shape for shape in _SHIPPED}
SHAPES: Mapping[str, LawShape] = MappingProxyType(_shapes)


def add_shape(shape: LawShape) -> Callable[[], None]:
    """Let laws have one more shape; returns what takes it away again.

    Raises ValueError where there is one of that name.

    >>> half, still = lambda law, t: 0.5 + 0 * t, lambda law, t, side: 0 * t
    >>> flat = sgb.LawShape("flat", "Flat", "The same all round", half, still)
    >>> take_away = sgb.add_law_shape(flat)
    >>> sgb.Law("omega", "flat", 0.0, 1.0).fraction([0.0, 2.0]).tolist()
    [0.5, 0.5]
    >>> take_away()
    """
    if shape.name in _shapes:
        raise ValueError(f"there is a law {shape.name!r} already")
    _shapes[shape.name] = shape

    def remove() -> None:
        del _shapes[shape.name]

    return remove
