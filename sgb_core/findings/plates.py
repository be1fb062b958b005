"""Why no plate, film or picture can be made as it is asked for."""

from __future__ import annotations

from sgb_core.findings.finding import Finding
from sgb_core.findings.plain import Plain
from sgb_core.findings.words import FILE, Reader, say
from sgb_core.values import dataclass


class NoPlate(Plain):
    """Why there is no figure plate to draw."""

    NONE = "the project holds no figure plate; make one in Export > Figure studio"
    NO_VALUES = "a list of values is empty"
    NO_STATES = "no state is ticked"


class NoRecord(Plain):
    """Why a file tells not how a figure was made."""

    NO_FIGURE = "it is not the file of a figure"
    NO_PLATE = "it is not the file of a plate"
    NO_RESOLUTION = "it does not say at which resolution the figure was made"


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


@dataclass(frozen=True, slots=True)
class OtherVersion(Finding):
    """A figure was made by another version of the program than the ``present`` one."""

    version: object
    program: str
    present: str


@say.register
def _(finding: OtherVersion, reader: Reader = FILE) -> str:
    return (
        f"it was made by version {finding.version} of {finding.program}; this is "
        f"{finding.present}, which may draw otherwise"
    )


@say.register
def _(finding: NotNumbers, reader: Reader = FILE) -> str:
    return f"{finding.text!r} is not a list of numbers"
