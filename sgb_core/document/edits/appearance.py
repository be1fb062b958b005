"""Edits of how the object looks."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from enum import Enum
from typing import Final

from sgb_core.document.appearance.model import (
    Appearance,
    Background,
    ColourMap,
    Layer,
    Lighting,
    MaterialName,
    Shading,
    Texture,
)
from sgb_core.document.appearance.picture_file import Picture
from sgb_core.document.edits.checks import changed, checked
from sgb_core.document.edits.pictures import used_pictures, with_picture
from sgb_core.document.model import Document
from sgb_core.fields.record import table_of


class Unchanged(Enum):
    """The default of what may be None: stays as it is."""

    UNCHANGED = "unchanged"


UNCHANGED: Final = Unchanged.UNCHANGED


def set_appearance(
    document: Document,
    *,
    material: MaterialName | str | None = None,
    color: str | Unchanged | None = UNCHANGED,
    lighting: Lighting | str | None = None,
    background: Background | str | None = None,
    shading: Shading | str | None = None,
    shadow: bool | None = None,
    silhouette: bool | None = None,
    features: bool | None = None,
    textures: tuple[Texture, ...] | None = None,
    drawing: tuple[Layer, ...] | None = None,
    paint: bool | None = None,
    map: ColourMap | Unchanged | None = UNCHANGED,
    pictures: tuple[Picture, ...] | None = None,
) -> Document:
    """Set fields of the appearance; what is not given stays as it is.

    ``color`` None is the material's own, ``map`` None none. Raises EditError.

    >>> cylinder = sgb.Document(sgb.Profile.of([sgb.line((10, 0), (10, 60))]))
    >>> str(sgb.edits.set_appearance(cylinder, material="celadon", shadow=True).appearance.material)
    'celadon'
    """
    look = changed(
        document.appearance,
        material=material,
        lighting=lighting,
        background=background,
        shading=shading,
        shadow=shadow,
        silhouette=silhouette,
        features=features,
        textures=textures,
        drawing=drawing,
        paint=paint,
        pictures=pictures,
    )
    if color is not UNCHANGED:
        look = checked(lambda: replace(look, color=color))
    if map is not UNCHANGED:
        look = checked(lambda: replace(look, map=map))
    return replace_appearance(document, look)


def replace_appearance(document: Document, wanted: Appearance) -> Document:
    """Put another appearance in place of the document's, held to the checks of reading a file.

    Pictures that no texture and no pattern of holes names any more are dropped; those whose dark
    parts are cut out of the wall stay. Raises EditError.
    """
    old = document.appearance
    new = checked(lambda: replace(wanted, pictures=used_pictures(document, wanted)))
    return document if new == old else replace(document, appearance=new)


def without_paint(document: Document) -> Document:
    """Return the document in plain clay: of its look only what is raised or sunk is left."""
    look = document.appearance
    textures = tuple(each for each in look.textures if each.relief != 0.0)
    drawing = tuple(each for each in look.drawing if each.relief != 0.0)
    bare = Appearance(textures=textures, drawing=drawing, pictures=look.pictures)
    return replace_appearance(document, replace(bare, paint=not (textures or drawing)))


def add_picture(
    document: Document, data: bytes, segments: tuple[int, ...] | None = None
) -> Document:
    """Lay a picture of the user's (a PNG or JPEG file's bytes) over some segments; None is all.

    It replaces the texture of just these, what covers other parts stays, and the picture is kept
    inside the project. Raises EditError.
    """
    others = _textures_with(document.appearance.textures, segments, None)
    kept, name = with_picture(set_appearance(document, textures=others), data)
    texture = Texture(name, repeat=(1.0, 0.0), segments=segments)
    return set_appearance(kept, textures=_textures_with(others, segments, texture))


def with_texture(
    look: Appearance, segments: tuple[int, ...] | None, texture: Texture | None
) -> Appearance:
    """Return a look whose texture of just these segments is another; None is none.

    What covers everything lies below what covers some segments.
    """
    return replace(look, textures=_textures_with(look.textures, segments, texture))


def _textures_with(
    textures: tuple[Texture, ...], segments: tuple[int, ...] | None, texture: Texture | None
) -> tuple[Texture, ...]:
    others = [each for each in textures if each.segments != segments]
    if texture is not None:
        others.insert(0 if texture.segments is None else len(others), texture)
    return tuple(others)


def apply_look(document: Document, section: Mapping[str, object]) -> Document:
    """Replace the appearance by one given as the section of a project file; raises EditError."""
    read = checked(lambda: table_of(Appearance).from_plain(section, ("appearance",)))
    return replace_appearance(document, read)
