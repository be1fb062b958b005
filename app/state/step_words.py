"""A step of the history in words: its name, and from what to what where it is one value."""

from __future__ import annotations

from app.widgets.quantity import format_number
from sgb_core.document.changes import Changed, only_change
from sgb_core.document.model import Unit
from sgb_core.document.session import HistoryEntry
from sgb_core.fields.kinds import Range
from sgb_core.fields.lists import OrNone


def step_words(before: HistoryEntry, after: HistoryEntry) -> str:
    """Return the step that led to ``after``: "Wall 3 → 4 mm"."""
    change = only_change(before.document, after.document)
    if change is None:
        return after.label
    unit = _unit(change, after.document.unit)
    old, new = _text(change, change.before), _text(change, change.after)
    if new is None or old is None or new.lower() in after.label.lower():
        return after.label
    return f"{after.label} {old} → {new}{unit}"


def _unit(change: Changed, unit: Unit) -> str:
    kind = change.row.kind
    if isinstance(kind, OrNone):
        kind = kind.inner
    if isinstance(kind, Range) and kind.length:
        return f" {unit}"
    return "°" if str(change.path[-1]).endswith("_deg") else ""


def _text(change: Changed, value: object) -> str | None:
    """Return a value in words, None for one that has none of its own, as a list or a switch."""
    if isinstance(value, bool):
        return None
    if isinstance(value, int | float):
        return format_number(float(value))
    if isinstance(value, str):
        return change.row.titles.get(value, str(value)) or None
    if isinstance(value, tuple) and value and all(isinstance(v, int | float) for v in value):
        return f"({', '.join(format_number(each) for each in value)})"
    return None
