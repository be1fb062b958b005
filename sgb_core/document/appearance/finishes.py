"""What the materials are: the numbers of physically based shading, shared by screen and GLB."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType

from sgb_core.document.appearance.model import Appearance, MaterialName
from sgb_core.values import dataclass


@dataclass(frozen=True, slots=True)
class Finish:
    """``color`` is the material's own, in sRGB; everything else lies from 0 to 1.

    ``coat`` is the strength of a clear layer of glaze and ``coat_roughness`` how dull it is;
    ``soft`` how far light wanders below the surface; ``texture`` is laid on where the document
    names no other.
    """

    title: str
    color: str
    roughness: float
    metallic: float = 0.0
    coat: float = 0.0
    coat_roughness: float = 0.05
    opacity: float = 1.0
    soft: float = 0.0
    texture: str | None = None


FINISHES: Mapping[MaterialName, Finish] = MappingProxyType(
    {
        MaterialName.CLAY: Finish("Clay", "#a9dfb0", 0.55),
        MaterialName.GLAZED: Finish("Glazed ceramic", "#2f5f8f", 0.5, coat=1.0),
        MaterialName.CELADON: Finish("Celadon", "#9fbfa6", 0.45, coat=0.9, soft=0.6),
        MaterialName.PORCELAIN: Finish("Porcelain", "#f1f0ea", 0.4, coat=0.9, soft=0.8),
        MaterialName.TERRACOTTA: Finish("Terracotta", "#b5623f", 0.95),
        MaterialName.RAKU: Finish(
            "Raku", "#d9cfbd", 0.6, coat=0.7, coat_roughness=0.18, texture="raku-crackle"
        ),
        MaterialName.METAL: Finish("Metal", "#d8b476", 0.26, metallic=1.0),
        MaterialName.GLASS: Finish("Glass", "#cfeee8", 0.05, coat=1.0, opacity=0.16),
        MaterialName.PLASTER: Finish("Plaster", "#e9e5dc", 1.0, soft=0.2),
        MaterialName.WOOD: Finish(
            "Wood", "#9a6a3c", 0.7, coat=0.25, coat_roughness=0.35, texture="wood"
        ),
    }
)


def base_color(appearance: Appearance) -> str:
    """Return the colour that is seen where nothing is painted."""
    return appearance.color or FINISHES[appearance.material].color
