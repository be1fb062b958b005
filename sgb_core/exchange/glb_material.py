"""The material part of a GLB file: base colour or texture, glaze as a clear coat, glass."""

from __future__ import annotations

from typing import Any

from sgb_core.exchange.skin import MapSkin, Skin

_REPEAT, _CLAMP = 10497, 33071
_LINEAR, _MIPMAPPED = 9729, 9987


def material_parts(skin: Skin, view: int) -> dict[str, Any]:
    """Return the glTF properties ``materials``, ``textures``, ... of a look.

    ``view`` is the number of the buffer view that holds the picture, where there is one. Extensions
    used are of the KHR kind that viewers may leave out.
    """
    material = skin.material
    surface: dict[str, Any] = {
        "baseColorFactor": [*skin.linear_color, material.opacity],
        "metallicFactor": material.metallic,
        "roughnessFactor": material.roughness,
    }
    parts: dict[str, Any] = {}
    if skin.png:
        surface["baseColorFactor"] = [1.0, 1.0, 1.0, material.opacity]
        surface["baseColorTexture"] = {"index": 0}
        parts = {
            "textures": [{"sampler": 0, "source": 0}],
            "images": [{"bufferView": view, "mimeType": "image/png", "name": "paint"}],
            "samplers": [
                {
                    "magFilter": _LINEAR,
                    "minFilter": _LINEAR if isinstance(skin, MapSkin) else _MIPMAPPED,
                    "wrapS": _CLAMP if isinstance(skin, MapSkin) else _REPEAT,
                    "wrapT": _CLAMP,
                }
            ],
        }
    described: dict[str, Any] = {"name": material.title, "pbrMetallicRoughness": surface}
    if material.opacity < 1.0:
        described["alphaMode"] = "BLEND"
    if isinstance(skin, MapSkin):
        # Its colours are to be read, whatever the light.
        described["extensions"] = {"KHR_materials_unlit": {}}
        parts["extensionsUsed"] = ["KHR_materials_unlit"]
    elif material.coat > 0.0:
        described["extensions"] = {
            "KHR_materials_clearcoat": {
                "clearcoatFactor": material.coat,
                "clearcoatRoughnessFactor": material.coat_roughness,
            }
        }
        parts["extensionsUsed"] = ["KHR_materials_clearcoat"]
    return {**parts, "materials": [described]}
