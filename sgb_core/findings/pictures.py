"""Why bytes or a name give no picture to lay on a surface."""

from __future__ import annotations

from sgb_core.findings.finding import Finding
from sgb_core.findings.plain import Plain
from sgb_core.findings.words import FILE, Reader, say
from sgb_core.values import dataclass


class NoPicture(Plain):
    """Why the bytes of a file are no picture."""

    OTHER = "this is no PNG or JPEG picture"
    DAMAGED = "the picture is damaged"


@dataclass(frozen=True, slots=True)
class LargePicture(Finding):
    """A picture's file is larger than the ``most`` bytes that a project keeps of one."""

    most: int


@dataclass(frozen=True, slots=True)
class ManyPixels(Finding):
    """A picture has more than the ``most`` pixels that are opened."""

    most: int


@dataclass(frozen=True, slots=True)
class NoTexture(Finding):
    """Neither the document nor the program has a picture of a name."""

    name: str


@say.register
def _(finding: LargePicture, reader: Reader = FILE) -> str:
    return f"the picture is larger than {finding.most >> 20} MB"


@say.register
def _(finding: ManyPixels, reader: Reader = FILE) -> str:
    return f"the picture has more than {finding.most // 1_000_000} million pixels"


@say.register
def _(finding: NoTexture, reader: Reader = FILE) -> str:
    return f"there is no texture {finding.name!r}"
