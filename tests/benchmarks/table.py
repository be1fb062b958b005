"""The short table at the end of the window's benchmark: its figures beside the first version's.

The first version's figures are medians of commit d7dfca5 on 2 cores without a graphics card. A
ratio tells the whole truth only on such a machine; run that commit in turns with this one to have
it for another.
"""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType

# In milliseconds, except pictures a second; those of a range are its middle.
FIRST: Mapping[str, float] = MappingProxyType(
    {
        "move, vase, slider": 57.0,
        "move, vase, editor": 79.0,
        "move, vase, space": 62.0,
        "move, vase, orbit": 50.0,
        "move, ceramic-pot, slider": 123.0,
        "move, melon-jar, slider": 90.0,
        "move, bowl, slider": 73.0,
        "stream, vase, pictures a second": 19.0,
        "stream, vase, late": 95.0,
        "stream, vase, refined": 750.0,
        "tick, vase": 5.4,
        "tick, ceramic-pot": 16.6,
        "start, painted": 1280.0,
        "start, 3-D": 2480.0,
    }
)


class Table:
    """Takes figures by name and prints each once, the last that was told."""

    def __init__(self) -> None:
        self._figures: dict[str, float] = {}

    def tell(self, what: str, figure: float) -> None:
        """Note a figure, in milliseconds or whatever ``what`` says."""
        self._figures[what] = figure

    def lines(self) -> list[str]:
        """Return the table: what, this run, the first version, their ratio."""
        found = [f"{'':34} {'this run':>9} {'first':>9} {'ratio':>6}"]
        for what, figure in self._figures.items():
            first = FIRST.get(what)
            told = "" if first is None else f"{first:9.1f} {figure / first:6.2f}"
            found.append(f"{what:34} {figure:9.1f} {told}".rstrip())
        return found
