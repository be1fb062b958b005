"""What the JSON file beside a figure says of how it was made, and how that is read back."""

from __future__ import annotations

import json
from pathlib import Path
from typing import TYPE_CHECKING, Any

from app.cli.figure_options import DPI, LAST_FIGURE
from app.cli.version import PROGRAM, version
from sgb_core.document.file import project_file
from sgb_core.document.file.atomic import write_whole
from sgb_core.document.model import Document
from sgb_core.drawings import fonts
from sgb_core.drawings.page import Drawing
from sgb_core.findings.errors import FindingError
from sgb_core.findings.files import TooManyBytes
from sgb_core.findings.finding import Finding
from sgb_core.findings.line import InFile
from sgb_core.findings.plates import NoRecord, OtherVersion

if TYPE_CHECKING:
    from app.figures.plate import Plate

# A figure's own file is some tens of kilobytes; one with pictures in its project more.
MOST_BYTES = 64 << 20


def of_figure(number: int, record: dict[str, Any], plate: Plate) -> dict[str, Any]:
    """Return the record of one of the paper's figures with what made it."""
    again = ["figures", "--only", str(number), "--dpi", str(plate.dpi)]
    return {**record, "made_by": _made_by(plate, again)}


def of_plate(document: Document, plate: Plate) -> dict[str, Any]:
    """Return the record of a project's plate: what made it, and the whole project."""
    made_by = _made_by(plate, ["plate", "--dpi", str(plate.dpi)])
    return {"made_by": made_by, "document": _plain(document)}


def of_drawing(document: Document, drawing: Drawing, command: list[str]) -> dict[str, Any]:
    """Return the record of a figure on a page: what made it, what it says, the whole project."""
    page = drawing.pages[0]
    look = {"width_mm": page.width, "height_mm": page.height, "font": fonts.FAMILY}
    made_by = _made(look, command)
    return {"made_by": made_by, "says": drawing.subject, "document": _plain(document)}


def write(path: Path, tree: object) -> None:
    """Write a record, whole or not at all."""
    text = json.dumps(tree, ensure_ascii=False, allow_nan=False, indent=1)
    write_whole(path, lambda stream: stream.write(f"{text}\n".encode()))


def _plain(document: Document) -> Any:
    return json.loads(project_file.dumps(document))


def _made_by(plate: Plate, command: list[str]) -> dict[str, Any]:
    # Imported late: the font's name is in the module that draws.
    from app.figures.files import FAMILY

    return _made({"width_mm": plate.width_mm, "dpi": plate.dpi, "font": FAMILY}, command)


def _made(look: dict[str, Any], command: list[str]) -> dict[str, Any]:
    return {"program": PROGRAM, "version": version(), "look": look, "command": command}


def figure_of(path: Path) -> tuple[int, int]:
    """Return the number and the resolution of the figure beside which a file stands.

    Raises FindingError for another file and for one of another version, which may draw otherwise.
    """
    tree = _read(path)
    made_by, number = tree.get("made_by"), tree.get("figure")
    look = made_by.get("look") if isinstance(made_by, dict) else None
    dpi = look.get("dpi") if isinstance(look, dict) else None
    if not isinstance(number, int) or not 1 <= number <= LAST_FIGURE:
        raise _fault(path, NoRecord.NO_FIGURE)
    if not isinstance(dpi, int) or not DPI[0] <= dpi <= DPI[1]:
        raise _fault(path, NoRecord.NO_RESOLUTION)
    _check_version(path, made_by)
    return number, dpi


def document_of(path: Path) -> Document:
    """Return the project of a file, or the one that the file beside a plate or a page holds."""
    if path.suffix.lower() != ".json":
        return project_file.load(path)
    tree = _read(path)
    if not isinstance(tree.get("document"), dict):
        raise _fault(path, NoRecord.NO_PLATE)
    _check_version(path, tree.get("made_by"))
    return project_file.loads(json.dumps(tree["document"]).encode())


def _fault(path: Path, finding: Finding) -> FindingError:
    return FindingError(InFile(str(path), finding))


def _check_version(path: Path, made_by: object) -> None:
    made = made_by.get("version") if isinstance(made_by, dict) else None
    if made != version():
        raise _fault(path, OtherVersion(made, PROGRAM, version()))


def _read(path: Path) -> dict[str, Any]:
    with open(path, "rb") as stream:
        data = stream.read(MOST_BYTES + 1)
    if len(data) > MOST_BYTES:
        raise _fault(path, TooManyBytes(MOST_BYTES))
    try:
        tree = json.loads(data)
    except (ValueError, RecursionError):
        tree = None
    if not isinstance(tree, dict):
        raise _fault(path, NoRecord.NO_FIGURE)
    return tree
