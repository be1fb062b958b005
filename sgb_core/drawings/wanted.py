"""What kind of drawing is wanted, on which paper and how large: values that check themselves."""

from __future__ import annotations

from datetime import date
from enum import StrEnum

from sgb_core.drawings.scales import Paper, Scale
from sgb_core.fields.kinds import Choice, Range, Said
from sgb_core.findings.errors import FindingError
from sgb_core.findings.refusal import Argument
from sgb_core.values import dataclass

MOST_NUMBER = 1_000_000


class Style(StrEnum):
    """A dimensioned section for the workshop, or a plate as archaeologists publish it."""

    SECTION = "section"
    VESSEL = "vessel"


class Side(StrEnum):
    """On which side of the axis the section stands."""

    LEFT = "left"
    RIGHT = "right"


class Fill(StrEnum):
    """How the material of a section is shown."""

    HATCHED = "hatched"
    FILLED = "filled"


@dataclass(frozen=True, slots=True)
class Wanted:
    """How to draw: without ``paper`` or ``scale`` those are taken that fit.

    Without ``fill`` a section is hatched and the walls of a plate are filled. ``first`` is the
    number of the first vessel of a plate. ``day`` is YYYY-MM-DD, or empty for none. Raises
    FindingError, a ValueError, for a value that is not allowed.
    """

    style: Style = Style.SECTION
    paper: Paper | None = None
    scale: Scale | None = None
    side: Side = Side.RIGHT
    fill: Fill | None = None
    day: str = ""
    first: int = 1

    def __post_init__(self) -> None:
        Choice(Style).take(self.style, ("style",))
        Choice(Side).take(self.side, ("section",))
        if self.paper is not None:
            Choice(Paper).take(self.paper, ("paper",))
        if self.fill is not None:
            Choice(Fill).take(self.fill, ("fill",))
        if not 0 <= self.first <= MOST_NUMBER:
            allowed = Range(0, MOST_NUMBER, whole=True)
            raise FindingError(Argument("the first number", self.first, allowed))
        if self.day and not _is_day(self.day):
            raise FindingError(Argument("the date", self.day, Said("a date such as 2026-03-31")))

    @property
    def mirror(self) -> float:
        """1 where the section stands on the right, −1 where it stands on the left."""
        return 1.0 if self.side is Side.RIGHT else -1.0


def _is_day(text: str) -> bool:
    try:
        date.fromisoformat(text)
    except ValueError:
        return False
    return len(text) == 10
