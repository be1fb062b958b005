"""What can be left away to look into a body, each choice declared once. Loads nothing."""

from __future__ import annotations

from enum import StrEnum
from math import pi


class Cut(StrEnum):
    """What is left away, by its name.

    ``words`` is what people read, ``keys`` its shortcut, ``tip`` says more; ``wedge`` are the
    absolute angles between which the body is left away: towards the three-quarter view, or all in
    front of the plane that the profile editor shows.
    """

    words: str
    keys: str
    tip: str
    wedge: tuple[float, float]

    NONE = "none", "Whole", "Ctrl+F5", "Show the whole object", (0.0, 0.0)
    QUARTER = (
        "quarter",
        "Without a quarter",
        "Ctrl+F6",
        "Leave a quarter away to see the wall",
        (-pi / 2.0, 0.0),
    )
    HALF = (
        "half",
        "Without the front half",
        "Ctrl+F7",
        "Leave the front half away to see the wall",
        (-pi, 0.0),
    )
    SECTION = (
        "section",
        "Section only",
        "Ctrl+F8",
        "Show nothing but the cross-section, flat",
        (-pi, 0.0),
    )

    def __new__(cls, name: str, words: str, keys: str, tip: str, wedge: tuple[float, float]) -> Cut:
        """Make a member whose value is its name."""
        member = str.__new__(cls, name)
        member._value_ = name
        member.words, member.keys, member.tip, member.wedge = words, keys, tip, wedge
        return member
