"""The window as a reader of findings: how it counts, and what its controls are called."""

from __future__ import annotations

from collections.abc import Mapping

from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import ShapeParameters
from sgb_core.curves.segment_names import segment_names
from sgb_core.design.target_curves import SuperellipseArc
from sgb_core.document.model import Document
from sgb_core.document.plates import Variation
from sgb_core.fields.record import labels
from sgb_core.findings.errors import FindingError
from sgb_core.findings.finding import Finding
from sgb_core.findings.words import Reader, say
from sgb_core.surfaces.laws.law import Law


def _without_signs(names: Mapping[str, str]) -> dict[str, str]:
    """Return names of controls as they are said: without the sign of a diameter."""
    return {path: name.removesuffix(" ⌀") for path, name in names.items()}


# The window counts segments from 1; every field is called as its control is.
WINDOW = Reader(
    first=1,
    names={
        **_without_signs(labels(Document)),
        **labels(ShapeParameters),
        **labels(Law, "law."),
        **labels(Variation, "vary."),
        **labels(SuperellipseArc, "target."),
        "profile": "Profile",
        "profile.segments[]": "Segment {}",
        "profile.joints[]": "Rule of joint {}",
        "profile.closed": "Ring",
        "states[].name": "Name of state {}",
        "dimensions[]": "Dimension {}",
        "variation[].keyframes": "Keys of law {}",
        "variation": "Vary",
        "solid": "Solid",
        "cut_outs": "Holes",
        "appearance": "Look",
        "twist": "Twist",
    },
)


def segment_title(index: int, name: str) -> str:
    """Return what a segment is called in cards and lists: "3 · belly", "Segment 3" without name."""
    return f"{WINDOW.number(index)} · {name}" if name else WINDOW.segment(index).capitalize()


def segment_titles(profile: Profile) -> list[str]:
    """Return that of each segment of a profile."""
    return [segment_title(index, name) for index, name in enumerate(segment_names(profile))]


def told(finding: Finding) -> str:
    """Return a finding in one line, as the window tells it."""
    return say(finding, WINDOW)


def why(error: Exception) -> str:
    """Return in one line why something failed, as the window tells it."""
    if isinstance(error, FindingError):
        return error.words(WINDOW)
    if isinstance(error, OSError):
        place = f"{error.filename}: " if error.filename else ""
        return f"{place}{error.strerror or error}"
    if isinstance(error, MemoryError):
        return "there is not enough memory for this"
    return f"something went wrong ({type(error).__name__})"


def sentence(finding: Finding) -> str:
    """Return a finding as a sentence of its own."""
    return as_sentence(told(finding))


def reason(error: Exception) -> str:
    """Return why something failed as a sentence of its own."""
    return as_sentence(why(error))


def as_sentence(words: str) -> str:
    """Return words with a capital at their beginning and a stop at their end."""
    return words[:1].upper() + words[1:] + ("" if words.endswith((".", "…", "?")) else ".")
