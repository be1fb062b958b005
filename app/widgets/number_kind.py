"""Which numbers a field takes, and how it shows them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field
from math import copysign, inf
from typing import TypedDict

from app.widgets.quantity import QuantityError, format_number, parse_number
from sgb_core.fields.kinds import Kind, Range
from sgb_core.values import dataclass


@dataclass(frozen=True, slots=True)
class NumberKind:
    """Numbers from ``minimum`` to ``maximum`` (None: no limit) in a unit.

    ``above_minimum`` leaves out the minimum itself, ``whole`` all but whole numbers. ``words``
    are said in place of values that mean something else, as "never" for 0. ``decimals`` limits
    what is shown, never what is kept.
    """

    minimum: float | None = None
    maximum: float | None = None
    unit: str = ""
    decimals: int = 3
    above_minimum: bool = False
    whole: bool = False
    words: Mapping[float, str] = field(default_factory=dict)

    @property
    def allowed(self) -> str:
        """The allowed range in words."""
        low, high = self.minimum, self.maximum
        suffix = f" {self.unit}" if self.unit else ""
        above = "above " if self.above_minimum else "at least "
        if low is not None and high is not None:
            if self.above_minimum:
                return f"above {low:g} and at most {high:g}{suffix}"
            return f"{low:g} to {high:g}{suffix}"
        if low is not None:
            return f"{above}{low:g}{suffix}"
        return f"at most {high:g}{suffix}" if high is not None else "any number"

    def text(self, value: float) -> str:
        """Return how a value is shown."""
        return self.words.get(value) or format_number(value, self.decimals)

    def parsed(self, text: str) -> float:
        """Return the value of a text; raises QuantityError, one line, where it has none."""
        for value, word in self.words.items():
            if text.strip().casefold() == word.casefold():
                return value
        value = parse_number(text, self.unit)
        if self.whole:
            value = float(round(value))
        low, high = self.minimum, self.maximum
        below = low is not None and (value <= low if self.above_minimum else value < low)
        if below or (high is not None and value > high):
            raise QuantityError(f"{format_number(value)} is out of range; allowed: {self.allowed}")
        return value

    def stepped(self, value: float, steps: float, step: float) -> float:
        """Return the allowed value so many steps on; between whole numbers a step is one at least.

        Rounded far below a step, so that ten steps of 0.1 make 1.
        """
        way = steps * step
        if self.whole:
            way = copysign(max(round(abs(way)), 1.0), way)
        value = round(value + way, 10)
        if self.minimum is not None:
            least = self.minimum if not self.above_minimum else self.minimum + 1e-3 * step
            value = max(value, least)
        return value if self.maximum is None else min(value, self.maximum)


class Limits(TypedDict):
    """What a number field is told of the numbers that it takes."""

    minimum: float | None
    maximum: float | None
    above_minimum: bool
    whole: bool


def limits(kind: Kind, scale: float = 1.0) -> Limits:
    """Return the limits of a field of a record for the control that shows it ``scale`` times."""
    assert isinstance(kind, Range)
    above = kind.above > -inf
    low = kind.above if above else kind.low
    return Limits(
        minimum=scale * low if low > -inf else None,
        maximum=scale * kind.high if kind.high < inf else None,
        above_minimum=above,
        whole=kind.whole,
    )
