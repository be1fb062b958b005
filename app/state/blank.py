"""The blank document, and how to tell that nobody has touched it."""

from __future__ import annotations

from app.state import preferences
from sgb_core.curves.primitives import cubic
from sgb_core.curves.profile import Profile
from sgb_core.document import edits
from sgb_core.document.model import Document, Unit

# Its middle leg lies across the curve, so that every slider visibly reshapes it.
_WALL = ((26.0, 0.0), (64.0, 22.0), (20.0, 66.0), (34.0, 100.0))


def blank_document(unit: Unit | None = None) -> Document:
    """Return the plainest beginning, in the preferred unit: a belly and a waist, cup-high."""
    document = Document(Profile.of([cubic(_WALL)]))
    wanted = preferences.current().new_unit if unit is None else unit
    return edits.set_unit(document, wanted, convert=True)


def is_blank(document: Document) -> bool:
    """Whether the profile is still the one that a blank document begins with."""
    return document.profile == blank_document(document.unit).profile
