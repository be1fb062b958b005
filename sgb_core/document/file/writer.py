"""A document as the tree of plain values that its project file holds."""

from __future__ import annotations

from sgb_core.bodies.solid import Solid
from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import Segment
from sgb_core.document.appearance.model import PLAIN
from sgb_core.document.file.appearance import appearance_tree
from sgb_core.document.file.manufacture import manufacture_tree
from sgb_core.document.file.plate import plate_tree
from sgb_core.document.model import Document, Revolution
from sgb_core.surfaces.placement import Placement
from sgb_core.surfaces.variation import Law, LawKind

FORMAT = "sgb-document"
VERSION = 1


def tree_of(document: Document) -> dict[str, object]:
    """Return the file's tree: known keys in a fixed order, then the unknown ones.

    Sections that say nothing but the defaults are left out, except those that every file has.
    """
    tree: dict[str, object] = {"format": FORMAT, "version": VERSION, **_parts(document)}
    if document.states:
        tree["states"] = [{**_parts(each), **each.extra} for each in document.states]
    if document.plate is not None:
        tree["plate"] = plate_tree(document.plate)
    return {**tree, **document.extra}


def _parts(document: Document) -> dict[str, object]:
    """Return what a document and a state of it alike consist of."""
    tree: dict[str, object] = {
        "name": document.name,
        "unit": str(document.unit),
        "profile": _profile(document.profile),
        "revolution": revolution_tree(document.revolution),
    }
    if document.variation:
        tree["variation"] = [law_tree(law) for law in document.variation]
    if document.solid != Solid():
        tree["solid"] = solid_tree(document.solid)
    if document.placement != Placement():
        tree["placement"] = placement_tree(document.placement)
    if document.appearance != PLAIN:
        tree["appearance"] = appearance_tree(document.appearance)
    return {**tree, **manufacture_tree(document.manufacture)}


def _profile(profile: Profile) -> dict[str, object]:
    segments = [
        {
            "points": segment.points.tolist(),
            "lambda": [segment.shape.lambda1, segment.shape.lambda2, segment.shape.lambda3],
            "omega": segment.shape.omega,
            **_holds(segment),
            **segment.extra,
        }
        for segment in profile.segments
    ]
    return {
        "closed": profile.closed,
        "segments": segments,
        "joints": [str(rule) for rule in profile.rules],
        **profile.extra,
    }


def _holds(segment: Segment) -> dict[str, object]:
    ends = {"start": segment.holds_start, "end": segment.holds_end}
    names = [name for name, held in ends.items() if held]
    return {"holds": names} if names else {}


def revolution_tree(revolution: Revolution) -> dict[str, object]:
    """Return the ``revolution`` section."""
    return {
        "axis": str(revolution.axis),
        "start_deg": revolution.start_deg,
        "sweep_deg": revolution.sweep_deg,
        **revolution.extra,
    }


def law_tree(law: Law) -> dict[str, object]:
    """Return one law of the ``variation`` section."""
    tree: dict[str, object] = {
        "segments": "all" if law.segments is None else list(law.segments),
        "parameter": law.parameter,
        "law": str(law.kind),
        "from": law.start,
        "to": law.end,
    }
    if law.kind is LawKind.COSINE or law.count != 1:
        tree["n"] = law.count
    if law.keyframes:
        tree["keyframes"] = [list(key) for key in law.keyframes]
    return {**tree, **law.extra}


def solid_tree(solid: Solid) -> dict[str, object]:
    """Return the ``solid`` section."""
    return {
        "kind": str(solid.kind),
        "wall": solid.wall,
        "side": str(solid.side),
        "base": solid.base,
        "rim": str(solid.rim),
        "drain_hole": solid.drain_hole,
        "foot_ring": solid.foot_ring,
        **solid.extra,
    }


def placement_tree(placement: Placement) -> dict[str, object]:
    """Return the ``placement`` section."""
    return {
        "rotation_deg": list(placement.rotation_deg),
        "translation": list(placement.translation),
        **placement.extra,
    }
