"""How the object looks: material, light, paint and maps, as frozen values of the document.

Positions along the surface are shares from 0 to 1, of its height or of the generatrix' length,
so that a look survives scaling and another unit. Colours are ``#rrggbb``.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field
from enum import StrEnum

from sgb_core.curves.profile import MAX_SEGMENTS
from sgb_core.curves.segment import PARAMETER_RANGES, ParameterName
from sgb_core.document.appearance.picture_file import PICTURE, Picture
from sgb_core.fields.extra import NO_EXTRA
from sgb_core.fields.kinds import (
    IMAGE,
    LENGTH,
    LINE,
    MAX_COORDINATE,
    SHARE,
    Choice,
    Colour,
    Flag,
    Range,
    Said,
)
from sgb_core.fields.lists import Fixed, OrNone, Several
from sgb_core.fields.record import Part, Record, check, says
from sgb_core.lettering.fonts import TITLES, FontName
from sgb_core.values import dataclass

# What a look holds at most.
MAX_PICTURES = 8
MAX_LAYERS = 200
MAX_REPEATS = 1000.0
# Of a quantity shown as colour.
_LIMIT = Range(-1e12, 1e12)
_SEGMENT = Range(
    0, MAX_SEGMENTS - 1, whole=True, said=f"a segment number from 0 to {MAX_SEGMENTS - 1}"
)
_SEGMENTS = Several(_SEGMENT, "segment numbers", MAX_SEGMENTS)


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
    TEXT = "text"


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


class Raised(StrEnum):
    """Which parts of a picture stand at the full depth of its relief; grey lies between."""

    LIGHT = "light"
    DARK = "dark"


_SHIFT = Range(-MAX_REPEATS, MAX_REPEATS)
_DEPTH = Range(
    -MAX_COORDINATE,
    MAX_COORDINATE,
    length=True,
    said="a number from -1e9 to 1e9, in the document's unit",
)
_RELIEF = says(
    _DEPTH,
    label="Relief",
    tip="How far it is raised, or sunk where negative, in the document's unit; 0 is paint.",
    brief=True,
)
_EDGE = says(
    LENGTH,
    label="Soft edge",
    tip="How wide the soft edge of the relief is, in the document's unit.",
    brief=True,
)


@dataclass(frozen=True, slots=True)
class Texture:
    """A picture laid around the surface: u by the angle, v by the arc length.

    ``image`` names a texture of the program, or one of the document's pictures by its hash.
    ``repeat`` says how often it is repeated around and along what it covers; along 0 keeps its
    proportions at the widest place. ``offset`` is in repeats. ``segments`` None covers all.
    ``relief`` and ``edge`` are as a layer's; the depth goes with the grey: see :class:`Raised`.
    """

    RECORD = Record("texture", "A picture around the surface: u by the angle, v by the arc length.")

    image: str = field(metadata=says(IMAGE))
    segments: tuple[int, ...] | None = field(default=None, metadata=says(OrNone(_SEGMENTS, "all")))
    repeat: tuple[float, float] = field(
        default=(8.0, 0.0),
        metadata=says(
            Fixed((Range(1.0, MAX_REPEATS), Range(0.0, MAX_REPEATS)), "a list of 2 numbers"),
            tip="Around and along; along 0 keeps the picture's proportions at the widest place.",
        ),
    )
    offset: tuple[float, float] = field(
        default=(0.0, 0.0),
        metadata=says(Fixed((_SHIFT, _SHIFT), "a list of 2 numbers")),
    )
    rotate_deg: float = field(default=0.0, metadata=says(Range(-360.0, 360.0)))
    relief: float = field(default=0.0, kw_only=True, metadata=_RELIEF)
    edge: float = field(default=1.0, kw_only=True, metadata=_EDGE)
    raised: Raised = field(
        default=Raised.LIGHT,
        kw_only=True,
        metadata=says(
            Choice(Raised),
            label="Full depth",
            tip="Which parts of the picture the relief moves by its full depth.",
            brief=True,
        ),
    )
    extra: Mapping[str, object] = field(default_factory=lambda: NO_EXTRA, repr=False, hash=False)

    def __post_init__(self) -> None:
        check(self)


_STOP = Fixed((SHARE, Colour()), "a pair [position, colour]")
_STOPS = Several(_STOP, "pairs [position, colour]", 50)
_GRADIENT = Several(_STOP, "pairs [position, colour]", 50, 2)


@dataclass(frozen=True, slots=True)
class Layer:
    """One layer of paint between two positions.

    band: all of it; rings: ``count`` rings, each ``width`` of their distance thick; stripes: the
    same around, leaning by ``twist`` turns; gradient: through ``stops`` of (position, colour);
    segments: the segments named, wherever they lie; text: ``count`` times around, standing on the
    lower position, its capitals as high as the upper. ``relief`` (in the unit) raises what it
    paints, or sinks it where negative, on the outside of the body; its edge slopes over ``edge``.
    """

    RECORD = Record(
        "layer",
        "Paint between two positions; later layers lie over earlier ones.",
        brief=True,
        rules=lambda: {
            "if": {"properties": {"kind": {"const": "gradient"}}},
            "then": {"required": ["stops"], "properties": {"stops": {"minItems": 2}}},
        },
    )

    kind: LayerKind = field(metadata=says(Choice(LayerKind)))
    color: str = field(default="#3b5b92", metadata=says(Colour()))
    start: float = field(default=0.0, metadata=says(SHARE, key="from"))
    end: float = field(default=1.0, metadata=says(SHARE, key="to"))
    by: Along = field(default=Along.HEIGHT, metadata=says(Choice(Along)))
    count: int = field(default=3, metadata=says(Range(1, 1000, whole=True)))
    width: float = field(default=0.3, metadata=says(SHARE))
    twist: float = field(default=0.0, metadata=says(Range(-100.0, 100.0)))
    stops: tuple[tuple[float, str], ...] = field(default=(), metadata=says(_STOPS))
    segments: tuple[int, ...] = field(default=(), metadata=says(_SEGMENTS))
    text: str = field(default="Text", kw_only=True, metadata=says(LINE))
    font: FontName = field(
        default=FontName.SANS_BOLD, kw_only=True, metadata=says(Choice(FontName), titles=TITLES)
    )
    shift: float = field(
        default=0.0,
        kw_only=True,
        metadata=says(Range(-1.0, 1.0), tip="How far text is moved around, in parts of the turn."),
    )
    relief: float = field(default=0.0, kw_only=True, metadata=_RELIEF)
    edge: float = field(default=1.0, kw_only=True, metadata=_EDGE)
    extra: Mapping[str, object] = field(default_factory=lambda: NO_EXTRA, repr=False, hash=False)

    def __post_init__(self) -> None:
        check(self)
        if len(self.stops) < 2 and (self.stops or self.kind is LayerKind.GRADIENT):
            raise _GRADIENT.refusal(self.stops, ("layer", "stops"))
        stops = tuple(sorted(self.stops, key=lambda stop: stop[0]))
        if stops != self.stops:
            object.__setattr__(self, "stops", stops)

    @property
    def varies_around(self) -> bool:
        """Whether it differs from angle to angle."""
        return self.kind in (LayerKind.STRIPES, LayerKind.TEXT)


@dataclass(frozen=True, slots=True)
class ColourMap:
    """A quantity shown as colour; limits None are taken from the values.

    ``parameter`` and ``segment`` (None: all) say whose influence is meant.
    """

    RECORD = Record("map", "A quantity shown as colour.", brief=True)

    of: MapKind = field(metadata=says(Choice(MapKind)))
    low: float | None = field(default=None, metadata=says(OrNone(_LIMIT, absent=True)))
    high: float | None = field(default=None, metadata=says(OrNone(_LIMIT, absent=True)))
    scale: Scale = field(default=Scale.AUTO, metadata=says(Choice(Scale)))
    parameter: ParameterName = field(default="omega", metadata=says(Choice(PARAMETER_RANGES)))
    segment: int | None = field(default=None, metadata=says(OrNone(_SEGMENT, absent=True)))
    extra: Mapping[str, object] = field(default_factory=lambda: NO_EXTRA, repr=False, hash=False)

    def __post_init__(self) -> None:
        check(self)
        if self.low is not None and self.high is not None and not self.low < self.high:
            raise Said("a number above the lower limit").refusal(self.high, ("map", "high"))


OWN_PICTURE = Said("the SHA-256 of a picture under appearance.pictures")


@dataclass(frozen=True, slots=True)
class Appearance:
    """Everything about the look; the default is plain clay in the theme's light green."""

    RECORD = Record(
        "appearance",
        "How the object looks; positions are shares of its height or length.",
        brief=True,
    )

    material: MaterialName = field(default=MaterialName.CLAY, metadata=says(Choice(MaterialName)))
    color: str | None = field(
        default=None,
        metadata=says(OrNone(Colour(), absent=True), tip="Default: the material's own."),
    )
    lighting: Lighting = field(default=Lighting.STUDIO, metadata=says(Choice(Lighting)))
    background: Background = field(default=Background.THEME, metadata=says(Choice(Background)))
    shading: Shading = field(default=Shading.SMOOTH, metadata=says(Choice(Shading)))
    shadow: bool = field(default=False, metadata=says(Flag()))
    silhouette: bool = field(default=False, metadata=says(Flag()))
    features: bool = field(default=False, metadata=says(Flag()))
    textures: tuple[Texture, ...] = field(
        default=(), metadata=says(Several(Part(Texture), "textures", MAX_LAYERS))
    )
    drawing: tuple[Layer, ...] = field(
        default=(), metadata=says(Several(Part(Layer), "layers", MAX_LAYERS))
    )
    paint: bool = field(
        default=True,
        kw_only=True,
        metadata=says(
            Flag(),
            tip="Whether textures and layers are painted; else they are only raised or sunk.",
        ),
    )
    map: ColourMap | None = field(default=None, metadata=says(OrNone(Part(ColourMap), absent=True)))
    pictures: tuple[Picture, ...] = field(
        default=(),
        metadata=says(
            Several(PICTURE, "pictures", MAX_PICTURES),
            tip="PNG or JPEG files as base64, named by the SHA-256 of their bytes.",
        ),
    )
    extra: Mapping[str, object] = field(default_factory=lambda: NO_EXTRA, repr=False, hash=False)

    def __post_init__(self) -> None:
        check(self)
        for place, texture in enumerate(self.textures):
            if len(texture.image) == 64 and self.picture(texture.image) is None:
                raise OWN_PICTURE.refusal(texture.image, ("appearance", "textures", place, "image"))

    def picture(self, name: str) -> Picture | None:
        """Return the document's picture of that name."""
        return next((picture for picture in self.pictures if picture.name == name), None)


PLAIN = Appearance()
