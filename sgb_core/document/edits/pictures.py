"""The pictures that a document keeps: as long as a texture or a pattern of holes names them."""

from __future__ import annotations

from dataclasses import replace

from sgb_core.document.appearance.model import MAX_PICTURES, Appearance
from sgb_core.document.appearance.picture_file import Picture, PictureError, check_picture
from sgb_core.document.errors import EditError
from sgb_core.document.model import Document
from sgb_core.findings.edits import TooMany


def used_pictures(document: Document, look: Appearance) -> tuple[Picture, ...]:
    """Return the pictures that the document needs in that look: those it names or holes name.

    What the holes need and the look lacks is the document's own.
    """
    cut = {cut_out.picture for cut_out in document.cut_outs}
    used = cut | {texture.image for texture in look.textures}
    kept = tuple(picture for picture in look.pictures if picture.name in used)
    own = document.appearance.pictures
    more = (each for each in own if each.name in cut and look.picture(each.name) is None)
    return (*kept, *more)


def without_unused_pictures(document: Document) -> Document:
    """Return the document without pictures that nothing names any more."""
    look = document.appearance
    kept = used_pictures(document, look)
    if kept == look.pictures:
        return document
    return replace(document, appearance=replace(look, pictures=kept))


def with_picture(document: Document, data: bytes) -> tuple[Document, str]:
    """Return the document with a picture, the bytes of a PNG or JPEG file, and its name.

    Nothing names it yet. Raises EditError for other bytes, and for more than a project keeps.
    """
    try:
        check_picture(data)
    except PictureError as error:
        raise EditError(error.finding) from None
    picture, look = Picture(data), document.appearance
    kept = used_pictures(document, look)
    if look.picture(picture.name) is not None:
        return document, picture.name
    if len(kept) >= MAX_PICTURES:
        raise EditError(TooMany("pictures", MAX_PICTURES))
    return replace(document, appearance=replace(look, pictures=(*kept, picture))), picture.name
