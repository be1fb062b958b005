"""A printer as its data file describes it: bed, nozzle, limits, how it feeds, and its lines.

``python -m sgb_core.toolpaths.printer`` prints the schema of the files, as ``resources/`` has it.
"""

from __future__ import annotations

import json
import os
import sys
from collections.abc import Mapping
from dataclasses import field
from enum import StrEnum
from math import pi
from typing import Any

from sgb_core.fields.extra import NO_EXTRA
from sgb_core.fields.kinds import Choice, Flag, Range, Said, Text
from sgb_core.fields.lists import OrNone, Several
from sgb_core.fields.record import Part, Record, check, says, table_of
from sgb_core.findings.refusal import MISSING
from sgb_core.values import dataclass

# Millimetres; no printer of vessels is larger, no nozzle wider.
_SIZE = Range(above=0.0, high=20_000.0)
_WIDTH = Range(above=0.0, high=200.0)
_SPEED = Range(above=0.0, high=2_000.0)
_LINE = Text(0, 200, "[^\r\n]*", "a line of at most 200 characters")
_SLUG = Text(1, 40, "[a-z0-9][a-z0-9-]*", "small letters, digits and hyphens, at most 40")
_MOST_LINES = 100
# No printer's file is larger.
_MOST_BYTES = 1_000_000
FORMAT = "sgb-printer"


class BedShape(StrEnum):
    """The outline of a bed."""

    RECTANGLE = "rectangle"
    CIRCLE = "circle"


class Origin(StrEnum):
    """Where on the bed x = y = 0 is."""

    CORNER = "corner"
    CENTRE = "centre"


class Firmware(StrEnum):
    """The dialect that the printer reads."""

    MARLIN = "marlin"
    KLIPPER = "klipper"
    REPRAPFIRMWARE = "reprapfirmware"


class Feeding(StrEnum):
    """In which unit a file says how much is pushed out; none: a motor runs at its own speed."""

    FILAMENT = "filament"
    VOLUMETRIC = "volumetric"
    NONE = "none"


class Stuff(StrEnum):
    """What is printed with."""

    PLASTIC = "plastic"
    CLAY = "clay"


@dataclass(frozen=True, slots=True)
class Bed:
    """The space that can be printed in, in mm; of a circle ``width`` is the diameter."""

    RECORD = Record("bed")

    width: float = field(metadata=says(_SIZE, label="Bed width"))
    depth: float = field(metadata=says(_SIZE, label="Bed depth"))
    height: float = field(metadata=says(_SIZE, label="Height"))
    shape: BedShape = field(default=BedShape.RECTANGLE, metadata=says(Choice(BedShape)))
    origin: Origin = field(default=Origin.CORNER, metadata=says(Choice(Origin)))
    extra: Mapping[str, object] = field(default_factory=lambda: NO_EXTRA, repr=False, hash=False)

    def __post_init__(self) -> None:
        check(self)

    @property
    def middle(self) -> tuple[float, float]:
        """Where the middle of the bed is, in the printer's coordinates."""
        return (0.0, 0.0) if self.origin is Origin.CENTRE else (self.width / 2.0, self.depth / 2.0)


@dataclass(frozen=True, slots=True)
class Limits:
    """What is usual and what is possible of a width or a height, in mm."""

    RECORD = Record("limits")

    usual: float = field(metadata=says(_WIDTH))
    least: float = field(metadata=says(_WIDTH))
    most: float = field(metadata=says(_WIDTH))
    extra: Mapping[str, object] = field(default_factory=lambda: NO_EXTRA, repr=False, hash=False)

    def __post_init__(self) -> None:
        check(self)
        if not self.least <= self.usual <= self.most:
            allowed = Said(f"a number from {self.least:g} to {self.most:g}, the least and the most")
            raise allowed.refusal(self.usual, ("limits", "usual"))


@dataclass(frozen=True, slots=True)
class Feed:
    """How material is fed.

    ``filament`` is its diameter in mm. Where nothing is fed by the file, ``flow`` in mm³/s is what
    the auger pushes at its speed, and the nozzle moves as fast as that asks for.
    """

    RECORD = Record("feed")

    unit: Feeding = field(metadata=says(Choice(Feeding)))
    filament: float = field(default=1.75, metadata=says(_WIDTH, label="Filament ⌀"))
    absolute: bool = field(default=False, metadata=says(Flag()))
    flow: float = field(default=0.0, metadata=says(Range(0.0, 1e6), label="Flow"))
    extra: Mapping[str, object] = field(default_factory=lambda: NO_EXTRA, repr=False, hash=False)

    def __post_init__(self) -> None:
        check(self)
        if self.unit is Feeding.NONE and self.flow == 0.0:
            raise Said("a number above 0 where the file feeds nothing").refusal(
                0.0, ("feed", "flow")
            )

    @property
    def e_per_mm3(self) -> float:
        """How many units of E push out a cubic millimetre; 0 where E says nothing."""
        if self.unit is Feeding.FILAMENT:
            return 4.0 / (pi * self.filament**2)
        return 1.0 if self.unit is Feeding.VOLUMETRIC else 0.0


@dataclass(frozen=True, slots=True)
class Speeds:
    """Speeds of the nozzle in mm/s.

    They are limited by ``largest_flow`` (mm³/s, 0: any) and the least time of a layer in s.
    """

    RECORD = Record("speeds")

    wall: float = field(metadata=says(_SPEED))
    floor: float = field(metadata=says(_SPEED))
    travel: float = field(metadata=says(_SPEED))
    slowest: float = field(metadata=says(_SPEED))
    largest_flow: float = field(default=0.0, metadata=says(Range(0.0, 1e6)))
    layer_time: float = field(default=0.0, metadata=says(Range(0.0, 3_600.0)))
    extra: Mapping[str, object] = field(default_factory=lambda: NO_EXTRA, repr=False, hash=False)

    def __post_init__(self) -> None:
        check(self)


@dataclass(frozen=True, slots=True)
class Heat:
    """Temperatures in °C and the fan in percent, for plastic."""

    RECORD = Record("heat")

    nozzle: float = field(metadata=says(Range(0.0, 500.0)))
    bed: float = field(default=0.0, metadata=says(Range(0.0, 200.0)))
    fan: float = field(default=100.0, metadata=says(Range(0.0, 100.0)))
    extra: Mapping[str, object] = field(default_factory=lambda: NO_EXTRA, repr=False, hash=False)

    def __post_init__(self) -> None:
        check(self)


@dataclass(frozen=True, slots=True)
class Printer:
    """A machine.

    ``largest_lean`` is the sideways step from turn to turn, in beads, that the stuff can bridge.
    ``tube`` is what a filling holds in ml (0: endless), ``wet_density`` is in g/cm³.
    ``start`` and ``end`` are lines of G-code in which {nozzle}, {bed} and {fan} stand for the
    temperatures and the fan's 0 to 255. ``sources`` say where the facts are from, ``unconfirmed``
    what could not be confirmed.
    """

    RECORD = Record("printer", "A printer; lengths in mm, times in s.", reserved=("format",))

    name: str = field(metadata=says(_SLUG, label="Name"))
    title: str = field(metadata=says(Text(1, 80), label="Title"))
    stuff: Stuff = field(metadata=says(Choice(Stuff), label="Prints"))
    firmware: Firmware = field(metadata=says(Choice(Firmware), label="Firmware"))
    bed: Bed = field(metadata=says(Part(Bed)))
    nozzle: float = field(metadata=says(_WIDTH, label="Nozzle ⌀"))
    layer: Limits = field(metadata=says(Part(Limits), label="Layer"))
    bead: Limits = field(metadata=says(Part(Limits), label="Bead"))
    feed: Feed = field(metadata=says(Part(Feed)))
    speeds: Speeds = field(metadata=says(Part(Speeds)))
    heat: Heat | None = field(default=None, metadata=says(OrNone(Part(Heat))))
    retraction: float = field(default=0.0, metadata=says(Range(0.0, 50.0)))
    skirt: int = field(default=0, metadata=says(Range(0, 50, whole=True)))
    largest_lean: float = field(default=0.5, metadata=says(Range(above=0.0, high=1.0)))
    tube: float = field(default=0.0, metadata=says(Range(0.0, 1e6), label="Tube"))
    wet_density: float = field(
        default=0.0, metadata=says(Range(0.0, 100.0), label="Density as printed")
    )
    start: tuple[str, ...] = field(default=(), metadata=says(Several(_LINE, "lines", _MOST_LINES)))
    end: tuple[str, ...] = field(default=(), metadata=says(Several(_LINE, "lines", _MOST_LINES)))
    sources: tuple[str, ...] = field(default=(), metadata=says(Several(Text(0, 400), "texts", 20)))
    unconfirmed: tuple[str, ...] = field(
        default=(), metadata=says(Several(Text(0, 400), "texts", 20))
    )
    extra: Mapping[str, object] = field(default_factory=lambda: NO_EXTRA, repr=False, hash=False)

    def __post_init__(self) -> None:
        check(self)

    def lines(self, written: tuple[str, ...]) -> list[str]:
        """Return lines with the temperatures put in."""
        heat = self.heat or Heat(0.0)
        values = {
            "{nozzle}": f"{heat.nozzle:g}",
            "{bed}": f"{heat.bed:g}",
            "{fan}": f"{round(heat.fan * 2.55)}",
        }
        found = []
        for line in written:
            for key, value in values.items():
                line = line.replace(key, value)
            found.append(line)
        return found


def printer_of(text: str | bytes) -> Printer:
    """Return the printer of a data file, JSON.

    Raises RefusalError, a ValueError, that names the field and what is allowed.
    """
    try:
        tree = json.loads(text)
    except (ValueError, RecursionError) as error:
        reason = " ".join(str(error).split())
        raise Said("a printer as JSON").refusal(f"not JSON ({reason})"[:200], ()) from None
    if not isinstance(tree, dict) or tree.get("format") != FORMAT:
        given = tree.get("format", MISSING) if isinstance(tree, dict) else tree
        raise Said(f'"{FORMAT}"').refusal(given, ("format",))
    found: Printer = table_of(Printer).from_plain(tree, ())
    return found


def read_printer(path: str | os.PathLike[str]) -> Printer:
    """Return the printer of a data file on the disk.

    Raises RefusalError as :func:`printer_of` does, and OSError where the system refuses.
    """
    with open(path, "rb") as stream:
        data = stream.read(_MOST_BYTES + 1)
    if len(data) > _MOST_BYTES:
        raise Said(f"a file of at most {_MOST_BYTES} bytes").refusal("a larger one", ())
    return printer_of(data)


def printer_text(printer: Printer) -> str:
    """Return the data file of a printer."""
    tree = {"format": FORMAT, **table_of(Printer).to_plain(printer)}
    return json.dumps(tree, ensure_ascii=False, indent=2) + "\n"


def schema() -> dict[str, Any]:
    """Return the JSON Schema of a printer's data file, of the draft 2020-12."""
    shared: dict[str, Any] = {}
    found = table_of(Printer).schema(shared)
    return {
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": "A printer of SGB Studio",
        **found,
        "required": ["format", *found["required"]],
        "properties": {"format": {"const": FORMAT}, **found["properties"]},
        "$defs": shared,
    }


if __name__ == "__main__":
    sys.stdout.write(json.dumps(schema(), ensure_ascii=False, indent=2) + "\n")
