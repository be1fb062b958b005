"""Everything that is measured of a document, as plain values under the names that files give."""

from __future__ import annotations

from math import isfinite
from typing import Any

from sgb_core.bodies.body import SolidError
from sgb_core.bodies.solid import BodyKind
from sgb_core.bodies.vessel import capacity_to, vessel_measures
from sgb_core.design.locks.dimension import Dimension
from sgb_core.document.appearance.relief import relief_of
from sgb_core.document.dimensions import measured_dimensions, missed_locks
from sgb_core.document.evaluation import Evaluation
from sgb_core.document.model import Document
from sgb_core.fields.record import table_of
from sgb_core.findings.errors import FindingError
from sgb_core.findings.finding import Finding
from sgb_core.findings.words import say
from sgb_core.surfaces import measures as of

Measures = dict[str, Any]


def measures(evaluation: Evaluation) -> Measures:
    """Return the object that ``measure --json`` prints: plain values, None for what is not finite.

    Lengths in the document's unit, areas and volumes in its powers, energies in its inverse,
    angles in degrees. With laws the section at the start angle is measured.
    """
    document, surface = evaluation.document, evaluation.surface
    centroid = of.centroid(surface)
    lower, upper = of.bounds(surface)
    section = surface.shape_at(surface.start)
    lengths = of.segment_lengths(surface).tolist()
    of_body, body_findings = body_measured(document)
    return {
        "name": document.name,
        "unit": document.unit.value,
        "volume": _finite(of.volume(surface)),
        "area": _finite(of.area(surface)),
        "centroid": None if centroid is None else [_finite(value) for value in centroid],
        "bounds": [[_finite(value) for value in corner] for corner in (lower, upper)],
        "generatrix_length": _finite(sum(lengths)),
        "bending_energy": _finite(of.bending_energy(surface)),
        "surface_bending_energy": _finite(of.surface_bending_energy(surface)),
        **{key: _finite(value) for key, value in of_body.items()},
        "segments": [
            {
                "leg_fractions": list(segment.shape.leg_fractions),
                "length": _finite(length),
            }
            for segment, length in zip(section.segments, lengths, strict=True)
        ],
        "joints": [
            {
                "rule": joint.rule.value,
                "measured": joint.measured.value,
                "kink_deg": _finite(joint.kink_deg),
                "speed_ratio": _finite(joint.speed_ratio),
                "curvature_jump": _finite(joint.curvature_jump),
                **({} if joint.at_deg is None else {"at_deg": joint.at_deg}),
            }
            for joint in evaluation.joints
        ],
        "dimensions": [
            {**table_of(Dimension).to_plain(each.freed()), "locked": each.locked, "value": value}
            for each, value in measured_dimensions(document)
        ],
        "warnings": [
            say(each) for each in (*evaluation.findings, *body_findings, *missed_locks(document))
        ],
    }


def body_measured(document: Document) -> tuple[dict[str, Any], tuple[Finding, ...]]:
    """Return the keys that ``measure --json`` adds for the body, and its findings.

    A bare surface adds none; a vessel with a fill line also how high that is and what it holds to
    there. Where the body cannot be made the values are null and the reason is
    a finding.
    """
    kind, raised = document.solid.kind, relief_of(document.appearance) is not None
    if kind is BodyKind.SURFACE:
        return {}, _worked(document, 0.0)[1] if raised else ()
    try:
        measured = vessel_measures(document.surface, document.solid)
    except SolidError as error:
        found: dict[str, Any] = {"capacity": None, "material_volume": None, "wall_min": None}
        findings: tuple[Finding, ...] = (error.finding,)
    else:
        found = {
            "capacity": measured.capacity,
            "material_volume": measured.material_volume,
            "wall_min": measured.wall_min,
        }
        findings = measured.findings
        if document.cut_outs or raised:
            worked, more = _worked(document, measured.material_volume)
            found, findings = {**found, **worked}, (*findings, *more)
        if document.fill_height is not None and kind is BodyKind.VESSEL:
            found["fill_height"] = document.fill_height
            found["filled"] = capacity_to(document.surface, document.solid, document.fill_height)
    if kind is BodyKind.FILLED:
        found = {
            key: found[key]
            for key in ("material_volume", "relief_volume", "relief_within")
            if key in found
        }
    return found, findings


def _worked(document: Document, whole: float) -> tuple[dict[str, Any], tuple[Finding, ...]]:
    """Return what relief and cut-outs make of the ``whole`` material, and what is to be said."""
    raised = relief_of(document.appearance) is not None
    try:
        worked = document.body().worked
    except FindingError as error:
        keys = ["material_volume"] + ["holes"] * bool(document.cut_outs)
        return dict.fromkeys(keys + ["relief_volume", "wall_min"] * raised), (error.finding,)
    found: dict[str, Any] = {"material_volume": whole + worked.added - worked.removed}
    found["wall_min"] = worked.wall_min
    if document.cut_outs:
        found["holes"] = worked.count
    if not raised:
        return found, worked.doubts
    # With relief the material is that of a mesh so near to the true body; all else is exact.
    return {**found, "relief_volume": worked.added, "relief_within": worked.within}, worked.doubts


def _finite(value: float | None) -> float | None:
    # Adding 0.0 makes −0.0 a plain 0.
    return float(value) + 0.0 if value is not None and isfinite(value) else None
