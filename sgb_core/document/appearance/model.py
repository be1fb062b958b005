"""How the object looks: material, light, paint and maps, as frozen values of the document.

Positions along the surface are shares from 0 to 1, of its height or of the generatrix' length,
so that a look survives scaling and another unit. Colours are ``#rrggbb``.
"""

from __future__ import annotations

import hashlib
from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import StrEnum
from functools import cached_property

from sgb_core.curves.segment import NO_EXTRA, ParameterName

# What a picture of the user's may be at most.
MAX_PICTURES = 8
MAX_PICTURE_BYTES = 4 * 1024 * 1024
MAX_LAYERS = 200
MAX_REPEATS = 1000.0


class MaterialName(StrEnum):
    """What the object is made of."""

    CLAY = "clay"
    GLAZED = "glazed-ceramic"
    CELADON = "celadon"
    PORCELAIN = "porcelain"
    TERRACOTTA = "terracotta"
    RAKU = "raku"
    METAL = "metal"
    GLASS = "glass"
    PLASTER = "plaster"
    WOOD = "wood"


class Lighting(StrEnum):
    """Where the light comes from."""

    STUDIO = "studio"
    DAYLIGHT = "daylight"
    GALLERY = "gallery"
    TECHNICAL = "technical"


class Background(StrEnum):
    """What is behind the object; "theme" is what the window's theme says."""

    THEME = "theme"
    WHITE = "white"
    DARK = "dark"
    GRADIENT = "gradient"
    TRANSPARENT = "transparent"


class Shading(StrEnum):
    """Whether the facets of the mesh are seen."""

    SMOOTH = "smooth"
    FLAT = "flat"


class LayerKind(StrEnum):
    """What a layer of the drawing paints."""

    GRADIENT = "gradient"
    BAND = "band"
    RINGS = "rings"
    STRIPES = "stripes"
    SEGMENTS = "segments"


class Along(StrEnum):
    """Of what a position is a share: the height, or the generatrix' length from its start."""

    HEIGHT = "height"
    LENGTH = "length"


class MapKind(StrEnum):
    """Which quantity colours the surface."""

    RADIUS = "radius"
    HEIGHT = "height"
    MERIDIAN = "meridian-curvature"
    PARALLEL = "parallel-curvature"
    GAUSSIAN = "gaussian-curvature"
    MEAN = "mean-curvature"
    OVERHANG = "overhang"
    THICKNESS = "wall-thickness"
    INFLUENCE = "influence"
    ZEBRA = "zebra"


class Scale(StrEnum):
    """The colours of a map; "auto" takes a diverging scale where the values change sign."""

    AUTO = "auto"
    VIRIDIS = "viridis"
    CIVIDIS = "cividis"
    INFERNO = "inferno"
    DIVERGING = "diverging"


@dataclass(frozen=True, slots=True)
class Texture:
    """A picture laid around the surface: u by the angle, v by the arc length.

    ``image`` names a texture of the program, or one of the document's pictures by its hash.
    ``repeat`` says how often it is repeated around and along what it covers; along 0 keeps its
    proportions at the widest place. ``offset`` is in repeats. ``segments`` None covers all.
    """

    image: str
    segments: tuple[int, ...] | None = None
    repeat: tuple[float, float] = (8.0, 0.0)
    offset: tuple[float, float] = (0.0, 0.0)
    rotate_deg: float = 0.0
    extra: Mapping[str, object] = field(default_factory=lambda: NO_EXTRA, repr=False, hash=False)


@dataclass(frozen=True, slots=True)
class Layer:
    """One layer of paint between two positions.

    band: all of it; rings: ``count`` rings, each ``width`` of their distance thick; stripes: the
    same around, leaning by ``twist`` turns; gradient: through ``stops`` of (position, colour);
    segments: the segments named, wherever they lie.
    """

    kind: LayerKind
    color: str = "#3b5b92"
    start: float = 0.0
    end: float = 1.0
    by: Along = Along.HEIGHT
    count: int = 3
    width: float = 0.3
    twist: float = 0.0
    stops: tuple[tuple[float, str], ...] = ()
    segments: tuple[int, ...] = ()
    extra: Mapping[str, object] = field(default_factory=lambda: NO_EXTRA, repr=False, hash=False)


@dataclass(frozen=True, slots=True)
class ColourMap:
    """A quantity shown as colour; limits None are taken from the values.

    ``parameter`` and ``segment`` (None: all) say whose influence is meant.
    """

    of: MapKind
    low: float | None = None
    high: float | None = None
    scale: Scale = Scale.AUTO
    parameter: ParameterName = "omega"
    segment: int | None = None
    extra: Mapping[str, object] = field(default_factory=lambda: NO_EXTRA, repr=False, hash=False)


@dataclass(frozen=True)
class Picture:
    """The bytes of a PNG or JPEG file of the user's, named by what they are."""

    data: bytes

    @cached_property
    def name(self) -> str:
        """The SHA-256 of the bytes, in hexadecimal."""
        return hashlib.sha256(self.data).hexdigest()


@dataclass(frozen=True, slots=True)
class Appearance:
    """Everything about the look; the default is plain clay in the theme's light green."""

    material: MaterialName = MaterialName.CLAY
    color: str | None = None
    lighting: Lighting = Lighting.STUDIO
    background: Background = Background.THEME
    shading: Shading = Shading.SMOOTH
    shadow: bool = False
    silhouette: bool = False
    features: bool = False
    textures: tuple[Texture, ...] = ()
    drawing: tuple[Layer, ...] = ()
    map: ColourMap | None = None
    pictures: tuple[Picture, ...] = ()
    extra: Mapping[str, object] = field(default_factory=lambda: NO_EXTRA, repr=False, hash=False)

    def picture(self, name: str) -> Picture | None:
        """Return the document's picture of that name."""
        return next((picture for picture in self.pictures if picture.name == name), None)


PLAIN = Appearance()
