"""What people call the shapes that there are to start from, besides their titles."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType

# By the name of a preset.
SHAPE_WORDS: Mapping[str, str] = MappingProxyType(
    {
        "vase": "flower flowers urn pot vessel",
        "bowl": "cup dish tableware rice soup salad cereal vessel",
        "amphora": "greek roman jar wine urn pottery",
        "bottle": "wine oil flask carafe glass",
        "goblet": "wine glass chalice cup stem drinking",
        "pagoda": "tower temple roof building tiers",
        "lidded-jar": "lid ginger urn box jar storage",
        "candlestick": "candle holder lathe turned wood brass baluster",
        "pawn": "chess figure game piece lathe turned solid",
        "plant-pot": "flower flowerpot planter terracotta pot garden",
        "lantern": "lamp light holes pierced perforated slots",
        "fluted-vase": "flutes lobes twist twisted spiral flower",
        "faceted-tumbler": "mug cup glass beaker drinking facets polygon sides octagon",
        "relief-jar": "carved decoration lotus porcelain pot",
        "jug": "mug pitcher spout pour milk water ewer handle",
        "melon-jar": "lobes lobed pumpkin pot petals",
        "teapot": "tea kettle utah pot",
        "ceramic-pot": "paper pottery vase jar texture",
        "earthen-house": "paper building hakka tulou house",
        "tower": "paper building",
        "figure-2": "paper segment curve plain",
        "sphere": "paper ball globe circle round",
        "ellipsoid-08": "paper egg ball ellipse spheroid",
        "ellipsoid-06": "paper egg lens ellipse spheroid",
        "ring": "paper torus donut doughnut loop closed",
    }
)
BLANK_WORDS = "new empty sheet draw scratch own mug cup plate"
