"""Edits of guides: the lines by which a person draws."""

from __future__ import annotations

from dataclasses import replace

from sgb_core.document.edits.checks import checked
from sgb_core.document.errors import EditError
from sgb_core.document.guides import MAX_GUIDES, Guide
from sgb_core.document.model import Document
from sgb_core.findings.edits import NoSuch, TooMany


def add_guide(document: Document, guide: Guide) -> Document:
    """Add a guide, the same document where one lies there already.

    >>> cup = sgb.Document(sgb.Profile.of([sgb.line((20, 0), (40, 60))]))
    >>> len(sgb.edits.add_guide(cup, sgb.Guide("r", 25.0)).guides)
    1
    """
    if any((each.at, each.value) == (guide.at, guide.value) for each in document.guides):
        return document
    if len(document.guides) >= MAX_GUIDES:
        raise EditError(TooMany("guides", MAX_GUIDES))
    return replace(document, guides=(*document.guides, guide))


def move_guide(document: Document, number: int, value: float) -> Document:
    """Put a guide at another radius, or height."""
    guide = _numbered(document, number)
    moved = checked(lambda: replace(guide, value=value))
    guides = tuple(moved if k == number else each for k, each in enumerate(document.guides))
    return replace(document, guides=guides)


def remove_guide(document: Document, number: int) -> Document:
    """Remove a guide."""
    _numbered(document, number)
    rest = tuple(each for k, each in enumerate(document.guides) if k != number)
    return replace(document, guides=rest)


def remove_guides(document: Document) -> Document:
    """Remove all guides."""
    return replace(document, guides=()) if document.guides else document


def _numbered(document: Document, number: int) -> Guide:
    count = len(document.guides)
    if not 0 <= number < count:
        raise EditError(NoSuch("guide", number, count))
    return document.guides[number]
