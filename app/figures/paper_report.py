"""What the JSON file beside a figure says of a panel: its parameters and what was measured."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from sgb_core.curves.head_to_tail import joined_head_to_tail
from sgb_core.document.edits.renumber_laws import follow
from sgb_core.document.evaluation import evaluate
from sgb_core.document.measures import measures
from sgb_core.document.model import Document
from sgb_core.fields.record import table_of
from sgb_core.surfaces.laws.law import Law

# A smaller angle is written as smooth: no drawing shows it.
VISIBLE_KINK = 0.05


def measured(document: Document) -> dict[str, Any]:
    """Return joints, volume, area and more; rings printed in halves are measured head to tail."""
    facts = measures(evaluate(document))
    ordered = joined_head_to_tail(document.profile)
    joints = facts["joints"]
    if ordered is not None:
        laws = follow(document.variation, ordered.origin, ordered.backwards)
        whole = replace(document, profile=ordered.profile, variation=laws)
        joints = measures(evaluate(whole))["joints"]
    result = {
        "joints": joints,
        "volume": facts["volume"],
        "area": facts["area"],
        "generatrix_length": facts["generatrix_length"],
        "bending_energy": facts["bending_energy"],
        "bounds": facts["bounds"],
    }
    if ordered is not None:
        result["joints_measured"] = "head to tail"
    return result


def panel_record(label: str, document: Document, facts: dict[str, Any]) -> dict[str, Any]:
    """Return one entry of "panels": lists hold one item for each segment.

    Parameters are those at θ = 0, as ``sample`` and ``measure`` take them; "variation" says how
    they go on.
    """
    surface = document.surface
    segments = surface.shape_at(surface.start).segments
    record: dict[str, Any] = {
        "label": label,
        "points": document.profile.control_points.tolist(),
        "lambda": [[s.shape.lambda1, s.shape.lambda2, s.shape.lambda3] for s in segments],
        "omega": [s.shape.omega for s in segments],
        "axis": document.revolution.axis.value,
        "sweep_deg": document.revolution.sweep_deg,
    }
    if document.variation:
        record["variation"] = [table_of(Law).to_plain(law) for law in document.variation]
    record["measured"] = facts
    return record


def joints_line(joints: list[dict[str, Any]]) -> str:
    """Return the caption's words on the true joints of a composite."""
    words = []
    for joint in joints:
        kink = joint["kink_deg"]
        visible = joint["measured"] == "G0" and kink is not None and kink >= VISIBLE_KINK
        place = f" at {joint['at_deg']:.0f}°" if visible and joint.get("at_deg") is not None else ""
        words.append(f"kink {kink:.1f}°{place}" if visible else joint["measured"])
    return "joints: " + ", ".join(words)
