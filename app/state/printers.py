"""The printers to choose from: those that the program knows, then one's own; the one chosen."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import resources
from app.state import preferences, user_folders
from sgb_core.document.file.atomic import write_whole
from sgb_core.findings.errors import FindingError
from sgb_core.toolpaths.printer import Printer, printer_text, read_printer


def known() -> list[Printer]:
    """Return the program's printers and one's own, which may replace them by name.

    A file of one's own that cannot be read is left out: it never stops the others.
    """
    found = {printer.name: printer for printer in map(read_printer, resources.printers())}
    folder = user_folders.printers()
    for path in sorted(folder.glob("*.json")) if folder.is_dir() else ():
        try:
            printer = read_printer(path)
        except (FindingError, OSError):
            continue
        found[printer.name] = printer
    return list(found.values())


def add(path: Path) -> Printer:
    """Take a printer from a file into one's own, and return it; raises as read_printer does."""
    printer = read_printer(path)
    folder = user_folders.printers()
    folder.mkdir(parents=True, exist_ok=True)
    text = printer_text(printer).encode()
    write_whole(folder / f"{printer.name}.json", lambda stream: stream.write(text))
    return printer


def chosen(among: Sequence[Printer]) -> tuple[Printer, float]:
    """Return the printer that was chosen last, or the first, and the layer in mm for it."""
    wanted = preferences.current()
    by_name = {printer.name: printer for printer in among}
    printer = by_name.get(wanted.printer, among[0])
    limits, layer = printer.layer, wanted.print_layer
    fits = printer.name == wanted.printer and limits.least <= layer <= limits.most
    return printer, layer if fits else limits.usual


def choose(printer: Printer, layer: float) -> None:
    """Remember the printer and the layer in mm that were chosen."""
    preferences.change(printer=printer.name, print_layer=layer)
