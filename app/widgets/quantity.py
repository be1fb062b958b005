"""Reading a number as a person types it: sums, fractions, units, a decimal comma.

Grammar (spaces are free except inside numbers)::

    sum     = term (("+" | "-") term)*
    term    = signed (("*" | "/") signed)*
    signed  = ("+" | "-")* (number | "(" sum ")") unit?
    number  = digits, or digits and a fraction: "1 1/2"

A unit after a quotient or product of plain numbers means the whole of it, so "1/2 in" is half
an inch. A plain number added to a length is in the document's unit.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from math import isfinite, pi
from types import MappingProxyType

from sgb_core.values import dataclass

LENGTHS: Mapping[str, float] = MappingProxyType(
    {
        "µm": 0.001,
        "um": 0.001,
        "mm": 1.0,
        "cm": 10.0,
        "dm": 100.0,
        "m": 1000.0,
        "in": 25.4,
        '"': 25.4,
        "″": 25.4,
        "ft": 304.8,
        "'": 304.8,
        "′": 304.8,
    }
)
ANGLES: Mapping[str, float] = MappingProxyType(
    {"°": 1.0, "deg": 1.0, "rad": 180.0 / pi, "turn": 360.0}
)
VOLUMES: Mapping[str, float] = MappingProxyType(
    {
        "ml": 1.0,
        "cl": 10.0,
        "dl": 100.0,
        "l": 1000.0,
        "mm³": 0.001,
        "mm3": 0.001,
        "cm³": 1.0,
        "cm3": 1.0,
        "in³": 16.387064,
        "in3": 16.387064,
        "oz": 29.5735295625,
    }
)
MASSES: Mapping[str, float] = MappingProxyType(
    {"g": 1.0, "kg": 1000.0, "oz": 28.349523125, "lb": 453.59237}
)
RATIOS: Mapping[str, float] = MappingProxyType({"%": 0.01})

_KINDS = (LENGTHS, ANGLES, VOLUMES, MASSES)

# Deeper nesting than this is a slip of the finger, and must not exhaust the stack.
_MAX_DEPTH = 40
_MAX_LENGTH = 200

_TOKEN = re.compile(
    r"\s*(?:(?P<number>(?:\d+(?:[.,]\d*)?|[.,]\d+)(?:[eE][+-]?\d+)?)"
    r"|(?P<unit>[A-Za-zµμ]+(?:³|3(?![\d.,]))?|[°%\"'″′])"
    r"|(?P<op>[-+*/()])"
    r"|(?P<bad>\S))"
)
_SAME_SIGN = str.maketrans({"−": "-", "–": "-", "×": "*", "·": "*", "÷": "/", "μ": "µ"})


class QuantityError(ValueError):
    """The text is not a number; the message says why in one line."""


@dataclass(frozen=True, slots=True)
class _Quantity:
    """A value with the power of its unit: 0 is a plain number, 1 a length (or angle)."""

    value: float
    power: int = 0


def parse_number(text: str, unit: str = "mm") -> float:
    """Return the value of ``text`` in ``unit``: "mm", "in", ..., "deg", "ml", "g", "" for none.

    Raises QuantityError, a ValueError, where the text is not a number of that kind.
    """
    return _Parser(text, unit).result()


class _Parser:
    def __init__(self, text: str, unit: str) -> None:
        if len(text) > _MAX_LENGTH:
            raise QuantityError("too long for a number")
        self._units = next((table for table in _KINDS if unit in table), RATIOS)
        self._unit = self._units.get(unit, 1.0)
        self._text = text.translate(_SAME_SIGN).strip()
        if not self._text:
            raise QuantityError("type a number")
        self._tokens = [
            (match.lastgroup or "bad", match.group(match.lastgroup or "bad"), match.end())
            for match in _TOKEN.finditer(self._text)
        ]
        self._at = 0
        self._depth = 0

    def result(self) -> float:
        quantity = self._sum()
        if self._at < len(self._tokens):
            raise QuantityError(f"“{self._peek()[1]}” is not expected here")
        if quantity.power not in (0, 1):
            raise QuantityError("multiply or divide by a plain number, not by one with a unit")
        if not isfinite(quantity.value):
            raise QuantityError("the number is too large")
        return quantity.value

    def _peek(self) -> tuple[str, str]:
        if self._at < len(self._tokens):
            kind, text, _ = self._tokens[self._at]
            return kind, text
        return "end", ""

    def _take(self, *texts: str) -> str | None:
        kind, text = self._peek()
        if kind == "op" and text in texts:
            self._at += 1
            return text
        return None

    def _sum(self) -> _Quantity:
        total = self._term()
        while sign := self._take("+", "-"):
            other = self._term()
            if {total.power, other.power} - {0, 1}:
                raise QuantityError("only lengths and plain numbers can be added")
            # Plain numbers are already in the document's unit.
            value = total.value + other.value if sign == "+" else total.value - other.value
            total = _Quantity(value, max(total.power, other.power))
        return total

    def _term(self) -> _Quantity:
        total = self._signed(units_allowed=True)
        while sign := self._take("*", "/"):
            # With a plain number so far, a unit at the end belongs to the whole term.
            factor = self._signed(units_allowed=total.power != 0)
            if sign == "*":
                total = _Quantity(total.value * factor.value, total.power + factor.power)
            elif factor.value == 0.0:
                raise QuantityError("division by zero")
            else:
                total = _Quantity(total.value / factor.value, total.power - factor.power)
            if total.power == 0:
                total = self._with_unit(total)
        return total

    def _signed(self, *, units_allowed: bool) -> _Quantity:
        sign = 1.0
        while taken := self._take("+", "-"):
            sign = -sign if taken == "-" else sign
        kind, text = self._peek()
        if kind == "number":
            self._at += 1
            found = _Quantity(_digits(text) + self._fraction(text))
        elif self._take("("):
            self._depth += 1
            if self._depth > _MAX_DEPTH:
                raise QuantityError("too many brackets")
            found = self._sum()
            self._depth -= 1
            if not self._take(")"):
                raise QuantityError("a closing bracket “)” is missing")
        elif kind == "end":
            raise QuantityError("something is missing at the end")
        else:
            raise QuantityError(f"“{text}” is not a number")
        if units_allowed and found.power == 0:
            found = self._with_unit(found)
        return _Quantity(sign * found.value, found.power)

    def _fraction(self, whole: str) -> float:
        """Take the fraction of a mixed number such as "1 1/2"; 0 where there is none."""
        ahead = self._tokens[self._at : self._at + 3]
        if [kind for kind, _, _ in ahead] != ["number", "op", "number"] or ahead[1][1] != "/":
            return 0.0
        parts = (whole, ahead[0][1], ahead[2][1])
        if not all(part.isdigit() for part in parts) or int(parts[2]) == 0:
            return 0.0
        self._at += 3
        return int(parts[1]) / int(parts[2])

    def _with_unit(self, quantity: _Quantity) -> _Quantity:
        kind, name = self._peek()
        if kind != "unit":
            return quantity
        factor = self._units.get(name, self._units.get(name.lower()))
        if factor is None:
            known = ", ".join(
                unit for unit in self._units if unit.removesuffix("³").isalpha() or unit in "°%"
            )
            raise QuantityError(f"“{name}” is not a unit here; known: {known}")
        self._at += 1
        # The document's own unit must not cost a rounding.
        scale = 1.0 if factor == self._unit else factor / self._unit
        return _Quantity(quantity.value * scale, 1)


def _digits(text: str) -> float:
    return float(text.replace(",", "."))


def format_number(value: float, decimals: int = 3) -> str:
    """Return ``value`` with at most ``decimals`` digits after the point, and no idle zeros."""
    if not isfinite(value):
        return "–"
    if value != 0.0 and not 0.5 * 10.0**-decimals <= abs(value) < 1e9:
        return f"{value:.{max(decimals, 1)}g}"
    text = f"{value:.{decimals}f}"
    if "." in text:
        text = text.rstrip("0").rstrip(".")
    return "0" if text == "-0" else text


def signed_percent(part: float) -> str:
    """Return a part as a percentage of at least two digits, with a plus or a true minus sign."""
    percent = 100.0 * part
    text = f"{percent:+.0f}" if abs(percent) >= 100.0 else f"{percent:+.2g}"
    return f"{text} %" if percent >= 0.0 else f"−{text[1:]} %"


def grouped(count: int) -> str:
    """Return a whole number with thin spaces between its thousands."""
    return f"{count:,}".replace(",", "\u2009")
