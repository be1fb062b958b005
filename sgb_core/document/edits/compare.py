"""States of a document that the present one can be laid over: the saved one, the plain cubic."""

from __future__ import annotations

from dataclasses import replace

from sgb_core.document.edits.whole import set_unit
from sgb_core.document.model import Document


def plain_cubic(document: Document) -> Document:
    """Return the document with ω = 0 everywhere: the cubic Bézier curves of the same points.

    No point moves, whatever the rules; laws have no effect then and are left out.
    """
    profile = document.profile
    cubic = profile.with_segments(
        s.with_shape(replace(s.shape, omega=0.0)) for s in profile.segments
    )
    return replace(document, profile=cubic, variation=())


def at_true_size(other: Document, document: Document) -> Document:
    """Return another state in the unit of the document, to be laid over it."""
    return set_unit(other, document.unit, convert=True)
