"""From documents to a drawing, and from a drawing to the file that its suffix names."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping, Sequence
from pathlib import PurePath
from types import MappingProxyType

from sgb_core.document.file.atomic import write_whole
from sgb_core.document.model import Document
from sgb_core.drawings.dxf import drawing_dxf
from sgb_core.drawings.errors import DrawingError
from sgb_core.drawings.page import Drawing
from sgb_core.drawings.pdf import pdf_bytes
from sgb_core.drawings.plate import plate_page
from sgb_core.drawings.section import TOLERANCE, section_page
from sgb_core.drawings.svg import svg_bytes
from sgb_core.drawings.wanted import Style, Wanted
from sgb_core.findings.drawings import NoDrawing, NoDrawingFormat

# By suffix: what makes the bytes of a drawing; and which of them hold several pages.
Writers = Mapping[str, Callable[[Drawing], bytes]]
WRITERS: Writers = MappingProxyType({".svg": svg_bytes, ".pdf": pdf_bytes, ".dxf": drawing_dxf})
_MANY_PAGES = (".pdf",)


def writer_for(
    path: str | os.PathLike[str], writers: Writers = WRITERS
) -> Callable[[Drawing], bytes]:
    """Return what makes the bytes of a file; raises DrawingError that names the suffixes."""
    found = writers.get(PurePath(path).suffix.lower())
    if found is None:
        raise DrawingError(NoDrawingFormat(os.fspath(path), tuple(writers)))
    return found


def draw(documents: Sequence[Document], wanted: Wanted) -> Drawing:
    """Return the drawing of documents: sections a page each, vessels of a plate on one page.

    Raises DrawingError for what cannot be drawn so and SolidError where there is no body.
    """
    if wanted.style is Style.VESSEL:
        made = [plate_page(documents, wanted)]
        kind = "Vessel plate"
    else:
        made = [section_page(document, wanted) for document in documents]
        kind = "Dimensioned section"
    title = ", ".join(document.name for document in documents)
    subject = f"{kind}, {'; '.join(dict.fromkeys(told for _, told in made))}"
    pages = tuple(page for page, _ in made)
    return Drawing(pages, title, subject, TOLERANCE, wanted.day, (str(wanted.style), "SGB Studio"))


def write_drawing(
    drawing: Drawing, path: str | os.PathLike[str], writers: Writers = WRITERS
) -> None:
    """Write a drawing to a file whose suffix names the format, whole or not at all.

    ``writers`` are the formats there are. Raises DrawingError for another suffix, and for several
    pages in a format of one.
    """
    make = writer_for(path, writers)
    if len(drawing.pages) > 1 and PurePath(path).suffix.lower() not in _MANY_PAGES:
        raise DrawingError(NoDrawing.ONE_PAGE)
    data = make(drawing)
    write_whole(path, lambda stream: stream.write(data))
