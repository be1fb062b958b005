"""What ``measure`` says of a solid body, as lines of its table."""

from __future__ import annotations

from typing import Any

from sgb_core.document.model import Unit


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
    if "filled" in measured:
        at = f"{number(measured['fill_height'])} {unit}"
        rows.append((f"to the line at {at}", volume("filled", "–")))
    if "material_volume" in measured:
        rows.append(("material", volume("material_volume", "none: no body can be made")))
    if measured.get("holes") is not None:
        rows.append(("holes", number(measured["holes"])))
    if measured.get("relief_volume") is not None:
        within = f", of a mesh within {number(measured['relief_within'])} {unit}"
        rows.append(("of it relief", volume("relief_volume", "") + within))
    if measured.get("wall_min") is not None:
        rows.append(("smallest wall", f"{number(measured['wall_min'])} {unit}"))
    return rows
