"""A profile from a source comes in: in place of the present one or after it; what lies behind."""

from __future__ import annotations

from dataclasses import replace

from sgb_core.bodies.solid import BodyKind, WallSide
from sgb_core.curves.profile import Profile
from sgb_core.document.edits.checks import as_edit_error, changed, with_profile
from sgb_core.document.edits.clip import paste_run
from sgb_core.document.edits.renumber_laws import follow
from sgb_core.document.edits.whole import set_solid
from sgb_core.document.model import Document
from sgb_core.document.reference import Reference

_UNNAMED = "Untitled"


@as_edit_error()
def take_profile(
    document: Document,
    profile: Profile,
    reference: Reference | None = None,
    *,
    wall: float | None = None,
    name: str = "",
) -> Document:
    """Return the document with a profile from a source, in its unit, in place of its own.

    Laws and paint of single segments go with the old ones. With ``wall`` it becomes a vessel of
    that wall inside the profile. ``name`` is given to a document that has none of its own.

    >>> cylinder = sgb.Document(sgb.Profile.of([sgb.line((10, 0), (10, 60))]))
    >>> cone = sgb.Profile.of([sgb.line((10, 0), (0, 60))])
    >>> round(sgb.edits.take_profile(cylinder, cone).volume / cylinder.volume, 6)
    0.333333
    """
    origin = [None] * len(profile)
    taken = with_profile(document, profile, follow(document.variation, origin), origin)
    if wall is not None:
        taken = set_solid(taken, kind=BodyKind.VESSEL, wall=wall, side=WallSide.INSIDE)
    if name and document.name == _UNNAMED:
        taken = replace(taken, name=name)
    return set_reference(taken, reference)


def add_profile(
    document: Document, profile: Profile, reference: Reference | None = None
) -> Document:
    """Return the document with a profile from a source moved to its end and added there."""
    return set_reference(paste_run(document, len(document.profile) - 1, profile), reference)


def set_reference(document: Document, reference: Reference | None) -> Document:
    """Set what lies behind the profile, None for nothing."""
    if reference == document.reference:
        return document
    return replace(document, reference=reference)


def change_reference(
    document: Document,
    *,
    origin: tuple[float, float] | None = None,
    scale: float | None = None,
    turn_deg: float | None = None,
    opacity: float | None = None,
    shown: bool | None = None,
    locked: bool | None = None,
) -> Document:
    """Change fields of the reference that are not None; a document without one stays as it is."""
    if document.reference is None:
        return document
    wanted = changed(
        document.reference,
        origin=origin,
        scale=scale,
        turn_deg=turn_deg,
        opacity=opacity,
        shown=shown,
        locked=locked,
    )
    return set_reference(document, wanted)
