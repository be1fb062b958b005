"""Why no plate, film or picture can be made as it is asked for."""

from __future__ import annotations

from dataclasses import dataclass

from sgb_core.findings.finding import Finding
from sgb_core.findings.plain import Plain
from sgb_core.findings.words import FILE, Reader, say


class NoPlate(Plain):
    """Why there is no figure plate to draw."""

    NONE = "the project holds no figure plate; make one in Export > Figure studio"
    NO_VALUES = "a list of values is empty"
    NO_STATES = "no state is ticked"


class NoFilm(Plain):
    """Why a film cannot be made."""

    NO_ENCODER = (
        "MP4 needs the package imageio-ffmpeg (pip install 'sgb-studio[video]'); "
        "GIF and PNG need nothing"
    )
    NO_GOAL = "--from needs --to: which state to go to"


@dataclass(frozen=True, slots=True)
class NotNumbers(Finding):
    """A text where numbers are listed that are none."""

    text: str


@say.register
def _(finding: NotNumbers, reader: Reader = FILE) -> str:
    return f"{finding.text!r} is not a list of numbers"
