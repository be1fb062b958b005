"""A picture of the user's, kept as the bytes of its file, and as it stands in a project."""

from __future__ import annotations

import base64
import binascii
import hashlib
import io
from functools import cached_property

from sgb_core.fields.kinds import Kind, Schema
from sgb_core.findings.errors import FindingError
from sgb_core.findings.finding import Path
from sgb_core.findings.pictures import LargePicture, ManyPixels, NoPicture
from sgb_core.findings.refusal import Refusal, RefusalError
from sgb_core.values import dataclass

MAX_PICTURE_BYTES = 4 * 1024 * 1024
# What keeps the memory that a picture takes, opened, below 50 MB.
MAX_PIXELS = 16_000_000
FORMATS = ("PNG", "JPEG")


class PictureError(FindingError):
    """What cannot be used as a picture."""


def check_picture(data: bytes) -> None:
    """Raise PictureError unless the bytes are a PNG or JPEG within the limits."""
    from PIL import Image, UnidentifiedImageError

    if len(data) > MAX_PICTURE_BYTES:
        raise PictureError(LargePicture(MAX_PICTURE_BYTES))
    try:
        # Reads the header alone.
        with Image.open(io.BytesIO(data), formats=FORMATS) as image:
            width, height = image.size
    except (UnidentifiedImageError, OSError, ValueError, SyntaxError, Image.DecompressionBombError):
        raise PictureError(NoPicture.OTHER) from None
    if width * height > MAX_PIXELS:
        raise PictureError(ManyPixels(MAX_PIXELS))


@dataclass(frozen=True)
class Picture:
    """The bytes of a PNG or JPEG file of the user's, named by what they are.

    Raises RefusalError, a ValueError, for other bytes.
    """

    data: bytes

    def __post_init__(self) -> None:
        try:
            check_picture(self.data)
        except (PictureError, TypeError):
            raise RefusalError(Refusal(("picture",), self.data, PICTURE)) from None

    @cached_property
    def name(self) -> str:
        """The SHA-256 of the bytes, in hexadecimal."""
        return hashlib.sha256(self.data).hexdigest()


@dataclass(frozen=True, slots=True)
class _PictureKind(Kind):
    """A picture; base64 text in the file."""

    @property
    def exact(self) -> type:
        return Picture

    @property
    def words(self) -> str:
        return (
            f"a PNG or JPEG picture as base64 text of at most {MAX_PICTURE_BYTES >> 20} MB, or the "
            "SHA-256 of one that stands elsewhere in the file"
        )

    def take(self, value: object, path: Path) -> Picture:
        if isinstance(value, Picture):
            return value
        raise self.refusal(value, path)

    def from_plain(self, value: object, path: Path) -> Picture:
        if isinstance(value, Picture):
            return value
        if not isinstance(value, str) or len(value) > MAX_PICTURE_BYTES * 3 // 2:
            raise self.refusal(value, path)
        try:
            return Picture(base64.b64decode(value, validate=True))
        except (binascii.Error, RefusalError, ValueError):
            raise self.refusal(value, path) from None

    def to_plain(self, value: Picture) -> object:
        return base64.b64encode(value.data).decode("ascii")

    def schema(self, shared: Schema) -> Schema:
        return {"type": "string"}


PICTURE = _PictureKind()
