"""What other kinds of curves come to under a document's joints and locks."""

from __future__ import annotations

from dataclasses import replace

from sgb_core.design import best_curves as design
from sgb_core.design.comparison import Compared
from sgb_core.document.dimensions import dimension_value
from sgb_core.document.edits.checks import with_profile
from sgb_core.document.lock_plan import lock_equations, locked_points
from sgb_core.document.model import Document


def best_curves(document: Document) -> tuple[Compared, ...]:
    """Return the fairest curves of four kinds between a document's joints, its locks kept.

    Under laws it is the section at the start that is compared, and what is locked keeps what it
    measures there; bodies are held by their models.
    """
    if document.variation:
        section = document.surface.shape_at(document.surface.start)
        document = _held(with_profile(replace(document, variation=()), section))
    return design.best_curves(document.profile, lock_equations(document), locked_points(document))


def _held(document: Document) -> Document:
    """Return a document each of whose locks holds what is now measured; others are left out."""
    held = []
    for each in document.dimensions:
        if each.value is not None:
            value = dimension_value(document, each)
            if value is None:
                continue
            each = each.held_at(value)
        held.append(each)
    return replace(document, dimensions=tuple(held))
