"""Edits of how the object looks."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import replace

from sgb_core.document.appearance.model import MAX_PICTURES, Appearance, Texture
from sgb_core.document.appearance.picture_file import Picture, PictureError, check_picture
from sgb_core.document.edits.checks import checked
from sgb_core.document.errors import EditError
from sgb_core.document.model import Document
from sgb_core.fields.record import table_of


def set_appearance(document: Document, **changes: object) -> Document:
    """Set fields of the appearance, held to the checks that reading a file makes.

    Pictures that no texture names any more are dropped. Raises EditError.
    """
    old = document.appearance
    for key in changes:
        if key not in Appearance.__dataclass_fields__ or key == "extra":
            raise EditError(f"the appearance has no {key!r}")
    pictures: Iterable[Picture] = changes.get("pictures", old.pictures)  # type: ignore[assignment]
    textures: Iterable[Texture] = changes.get("textures", old.textures)  # type: ignore[assignment]
    used = {texture.image for texture in textures}
    kept = tuple(picture for picture in pictures if picture.name in used)
    new = checked(lambda: replace(old, **{**changes, "pictures": kept}))  # type: ignore[arg-type]
    return document if new == old else replace(document, appearance=new)


def add_picture(document: Document, data: bytes) -> Document:
    """Lay a picture of the user's (a PNG or JPEG file's bytes) over the whole surface.

    It replaces the texture that covers all, and is kept inside the project. Raises EditError.
    """
    try:
        check_picture(data)
    except PictureError as error:
        raise EditError(str(error)) from None
    appearance = document.appearance
    picture = Picture(data)
    textures = tuple(each for each in appearance.textures if each.segments is not None)
    textures = (Texture(picture.name, repeat=(1.0, 0.0)), *textures)
    others = tuple(each for each in appearance.pictures if each.name != picture.name)
    used = {texture.image for texture in textures}
    kept = tuple(each for each in others if each.name in used)
    if len(kept) >= MAX_PICTURES:
        raise EditError(f"a project holds at most {MAX_PICTURES} pictures")
    return set_appearance(document, textures=textures, pictures=(*kept, picture))


def apply_look(document: Document, section: Mapping[str, object]) -> Document:
    """Replace the appearance by one given as the section of a project file; raises EditError."""
    read = checked(lambda: table_of(Appearance).from_plain(section, ("appearance",)))
    return document if read == document.appearance else replace(document, appearance=read)
