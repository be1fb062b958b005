"""Numbers typed in the middle of a drag: what is in the hand goes exactly there."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from PySide6.QtCore import Qt

from app.widgets.mark_slider import NUMBER_BEGINS
from app.widgets.number_kind import NumberKind
from app.widgets.quantity import QuantityError, format_number
from app.widgets.unit_edit import sign
from sgb_core.values import dataclass

# What a number may begin with; more signs, and letters of units, may follow.
_FIRST = frozenset(NUMBER_BEGINS)
_MORE = _FIRST | frozenset("+*/)° ³'\"%µ")
_LONGEST = 40
_CURSOR = "▏"


@dataclass(frozen=True, slots=True)
class TypedField:
    """One number that can be typed: what it is called, and what it takes.

    Numbers of different ``pair``s say the same in other ways: only one pair is typed at a time.
    """

    name: str
    kind: NumberKind
    pair: str = ""


@dataclass(frozen=True, slots=True)
class Typed:
    """The numbers of one drag as far as they are typed; the one at ``at`` takes the keys."""

    fields: tuple[TypedField, ...]
    texts: tuple[str, ...]
    at: int = 0

    @classmethod
    def of(cls, fields: tuple[TypedField, ...]) -> Typed:
        """Return fields in which nothing is typed yet."""
        return cls(fields, ("",) * len(fields))

    def wants(self, key: int, text: str) -> bool:
        """Return whether a key would be typed."""
        if key in (Qt.Key.Key_Backspace, Qt.Key.Key_Return, Qt.Key.Key_Enter):
            return any(self.texts)
        if len(text) != 1:
            return False
        begun = bool(self.texts[self.at])
        return text in _FIRST or (begun and (text in _MORE or text.isalpha()))

    def with_key(self, key: int, text: str) -> Typed:
        """Return the numbers after a key that is wanted."""
        typed = self.texts[self.at]
        typed = typed[:-1] if key == Qt.Key.Key_Backspace else (typed + text)[:_LONGEST]
        texts = (*self.texts[: self.at], typed, *self.texts[self.at + 1 :])
        if typed:
            pair = self.fields[self.at].pair
            texts = tuple(
                each if field.pair == pair else ""
                for each, field in zip(texts, self.fields, strict=True)
            )
        return replace(self, texts=texts)

    def next(self, forward: bool) -> Typed:
        """Return the same with the keys going to the next number, or the one before."""
        return replace(self, at=(self.at + (1 if forward else -1)) % len(self.fields))

    @property
    def values(self) -> Mapping[str, float]:
        """The numbers that are typed and in order, by their names."""
        found = {}
        for field, text in zip(self.fields, self.texts, strict=True):
            try:
                found[field.name] = field.kind.parsed(text)
            except QuantityError:
                continue
        return found

    def lines(self) -> list[str]:
        """Return what the heads-up label says of the numbers."""
        lines = []
        for k, (field, text) in enumerate(zip(self.fields, self.texts, strict=True)):
            if not text and k != self.at:
                continue
            unit = sign(field.kind.unit)
            shown = f"{field.name} = {text}{_CURSOR if k == self.at else ''}"
            try:
                value = field.kind.parsed(text) if text else None
            except QuantityError as error:
                lines += [shown, str(error)]
                continue
            if value is not None and text != format_number(value, 12):
                shown += f" = {format_number(value)}"
            lines.append(f"{shown} {unit}".rstrip())
        if len(self.fields) > 1:
            following = self.fields[(self.at + 1) % len(self.fields)].name
            lines.append(f"Tab: {following}, Enter: done")
        return lines
