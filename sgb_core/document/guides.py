"""Guides: lines at a radius or a height by which a person draws; they are no part of the object."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field, replace
from enum import StrEnum

from sgb_core.fields.extra import NO_EXTRA
from sgb_core.fields.kinds import COORDINATE, Choice
from sgb_core.fields.record import Record, check, says
from sgb_core.values import dataclass

MAX_GUIDES = 100


class GuideAt(StrEnum):
    """What a guide holds: a radius, as an upright line, or a height, as a level one."""

    RADIUS = "r"
    HEIGHT = "h"

    @property
    def coordinate(self) -> int:
        """Which coordinate of (r, h) it is."""
        return 0 if self is GuideAt.RADIUS else 1


@dataclass(frozen=True, slots=True)
class Guide:
    """A line at r = ``value`` or h = ``value``, in the document's unit.

    Raises RefusalError, a ValueError, for a value that is not allowed.

    >>> from sgb_core.document.guides import Guide
    >>> Guide("h", 40.0).at.coordinate
    1
    """

    RECORD = Record("guide", "A line to draw by, at a radius or a height.", brief=True)

    at: GuideAt = field(metadata=says(Choice(GuideAt), label="Guide"))
    value: float = field(metadata=says(COORDINATE, label="Place"))
    extra: Mapping[str, object] = field(default_factory=lambda: NO_EXTRA, repr=False, hash=False)

    def __post_init__(self) -> None:
        check(self)

    def enlarged(self, factor: float) -> Guide:
        """Return the guide of an object ``factor`` times as large."""
        return replace(self, value=self.value * factor)
