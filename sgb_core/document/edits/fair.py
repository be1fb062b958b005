"""The edit that makes a document's profile fair."""

from __future__ import annotations

from collections.abc import Collection

from sgb_core.design.fairing.energy import Energy
from sgb_core.design.fairing.fair import fair
from sgb_core.design.fairing.findings import Faired, Freedom, Keep
from sgb_core.document.edits.checks import segment_number, with_profile
from sgb_core.document.errors import EditError
from sgb_core.document.lock_plan import lock_equations
from sgb_core.document.model import Document
from sgb_core.findings.fairing import NoFairing


def fair_profile(
    document: Document,
    energy: Energy = Energy.BENDING,
    free: Freedom = Freedom.SHAPE,
    *,
    segments: Collection[int] | None = None,
    keep: Collection[Keep] = (),
) -> tuple[Document, Faired]:
    """Return the document with the fairest profile that keeps its locks, and what was found.

    Raises LocksExcludeError where nothing keeps all that is asked for, EditError for a segment
    that is not there and for an energy that is not known.
    """
    for segment in segments or ():
        segment_number(document, segment)
    if document.variation and energy is Energy.SURFACE:
        raise EditError(NoFairing.LAWS)
    locks = lock_equations(document)
    found = fair(document.surface, energy, free, segments=segments, keep=keep, locks=locks)
    return with_profile(document, found.profile), found
