"""The units of length that a document may have."""

from __future__ import annotations

from enum import StrEnum


class Unit(StrEnum):
    """The length unit of all coordinates."""

    MM = "mm"
    CM = "cm"
    IN = "in"

    @property
    def millimetres(self) -> float:
        """How many millimetres one unit is."""
        return {Unit.MM: 1.0, Unit.CM: 10.0, Unit.IN: 25.4}[self]

    @property
    def millilitres(self) -> float:
        """How many millilitres one cubic unit is."""
        return self.millimetres**3 / 1000.0

    def factor_to(self, other: Unit) -> float:
        """Return by what a length in this unit is multiplied to be in another."""
        return self.millimetres / other.millimetres
