"""What a slide of a shape parameter is called in the history, and what is said where it sleeps."""

from __future__ import annotations

from app.state.window_reader import WINDOW
from sgb_core.curves.segment import SYMBOLS, ParameterName
from sgb_core.document import edits
from sgb_core.document.model import Document


def label(name: ParameterName, segment: int | None) -> str:
    """Return what a change of a parameter of one segment, or of all (None), is called."""
    return f"{SYMBOLS[name]} of {whose(segment)}"


def whose(segment: int | None) -> str:
    """Return a segment within a sentence, or all of them."""
    return "all segments" if segment is None else WINDOW.segment(segment)


def slide_label(document: Document, name: ParameterName, segment: int | None) -> str:
    """Return what a slide is called, which may wake ω too."""
    wakes = any(edits.wakes(document, k, name) for k in _numbers(document, segment))
    return label(name, segment) + (", ω → 1" if wakes else "")


def sleep_notice(document: Document, name: ParameterName, segment: int | None) -> str | None:
    """Return why a slide shows nothing where a law holds ω at 0; None where it shows."""
    still = [k for k in _numbers(document, segment) if document.profile[k].shape.omega == 0.0]
    if name == "omega" or not any(edits.omega_law(document, k) for k in still):
        return None
    where = "the segments" if segment is None else WINDOW.segment(segment)
    return f"ω of {where} follows a law: {SYMBOLS[name]} shows where that is above 0."


def _numbers(document: Document, segment: int | None) -> range | list[int]:
    return range(len(document.profile)) if segment is None else [segment]
