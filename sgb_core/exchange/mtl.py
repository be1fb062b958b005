"""MTL: the material that an OBJ file names, with its picture beside it."""

from __future__ import annotations

from sgb_core.exchange.skin import Skin

# The name by which the OBJ file calls its one material.
NAME = "surface"


def mtl_text(skin: Skin, picture: str) -> str:
    """Return a material library; ``picture`` is the name of the picture's file.

    The classic terms first, then those of physically based shading that most programs read.
    """
    material = skin.material
    white = "1 1 1"
    plain = " ".join(f"{part:.4f}" for part in skin.color)
    diffuse = white if skin.picture is not None else plain
    shine = max(material.coat * 0.5, material.metallic, 0.5 * (1.0 - material.roughness))
    lines = [
        "# SGB Studio",
        f"newmtl {NAME}",
        f"Ka {diffuse}",
        f"Kd {diffuse}",
        f"Ks {shine:.4f} {shine:.4f} {shine:.4f}",
        f"Ns {10.0 + 500.0 * (1.0 - _gloss(skin)):.1f}",
        f"d {material.opacity:.4f}",
        "illum 2",
        f"Pr {material.roughness:.4f}",
        f"Pm {material.metallic:.4f}",
        f"Pc {material.coat:.4f}",
        f"Pcr {material.coat_roughness:.4f}",
    ]
    if skin.picture is not None:
        lines.append(f"map_Kd {picture}")
    return "\n".join(lines) + "\n"


def _gloss(skin: Skin) -> float:
    material = skin.material
    return material.coat_roughness if material.coat > 0.5 else material.roughness
