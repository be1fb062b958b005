"""The window as a reader of findings: how it counts, and what its controls are called."""

from __future__ import annotations

from sgb_core.findings.errors import FindingError
from sgb_core.findings.finding import Finding
from sgb_core.findings.words import Reader, say

# The window counts segments from 1; a joint is named by the two segments that meet there.
WINDOW = Reader(
    first=1,
    names={
        "profile": "Profile",
        "profile.segments[]": "Segment {}",
        "variation": "Vary",
        "solid": "Solid",
        "solid.kind": "Body",
        "solid.wall": "Wall",
        "solid.side": "Wall lies",
        "solid.base": "Base",
        "solid.rim": "Rim",
        "solid.drain_hole": "Drain hole",
        "solid.foot_ring": "Foot ring",
    },
)


def told(finding: Finding) -> str:
    """Return a finding in one line, as the window tells it."""
    return say(finding, WINDOW)


def why(error: Exception) -> str:
    """Return in one line why something failed, as the window tells it."""
    return error.words(WINDOW) if isinstance(error, FindingError) else str(error)


def sentence(finding: Finding) -> str:
    """Return a finding as a sentence of its own."""
    words = told(finding)
    return f"{words[0].upper()}{words[1:]}."
