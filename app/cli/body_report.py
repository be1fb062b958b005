"""What ``measure`` and ``check`` say of a solid body."""

from __future__ import annotations

from typing import Any

from sgb_core.bodies.body import SolidError
from sgb_core.bodies.solid import BodyKind
from sgb_core.bodies.vessel import vessel_measures
from sgb_core.document.model import Document, Unit
from sgb_core.findings.finding import Finding


def body_measures(document: Document) -> tuple[dict[str, Any], tuple[Finding, ...]]:
    """Return the keys that ``measure --json`` adds for the body, and its findings.

    A bare surface adds none. Where the body cannot be made the values are null and the reason is
    a finding.
    """
    kind = document.solid.kind
    if kind is BodyKind.SURFACE:
        return {}, ()
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
    if kind is BodyKind.FILLED:
        found = {"material_volume": found["material_volume"]}
    return found, findings


def body_rows(measured: dict[str, Any], number: Any) -> list[tuple[str, str]]:
    """Return the lines of the table for people; ``number`` turns values into text."""
    unit = measured["unit"]
    per_millilitre = Unit(unit).millilitres

    def volume(key: str, none: str) -> str:
        value = measured[key]
        return (
            none
            if value is None
            else (f"{number(value)} {unit}³ = {number(value * per_millilitre)} ml")
        )

    rows = []
    if "capacity" in measured:
        rows.append(("capacity", volume("capacity", "none: there is no rim")))
    if "material_volume" in measured:
        rows.append(("material", volume("material_volume", "none: no body can be made")))
    if measured.get("wall_min") is not None:
        rows.append(("smallest wall", f"{number(measured['wall_min'])} {unit}"))
    return rows
