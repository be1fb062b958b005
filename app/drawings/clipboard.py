"""What goes to the clipboard: a page, the profile as SVG, its points as a table."""

from __future__ import annotations

from io import BytesIO

from PySide6.QtCore import QMimeData
from PySide6.QtGui import QGuiApplication

from app.drawings.picture import DPI, picture_of
from sgb_core.document.model import Document
from sgb_core.drawings.page import Drawing
from sgb_core.drawings.pdf import pdf_bytes
from sgb_core.drawings.svg import svg_bytes
from sgb_core.exchange.csv_profile import csv_lines, curvature_lines
from sgb_core.exchange.svg import write_svg

SVG = "image/svg+xml"
# What Inkscape asks for, before the standard's own name.
INKSCAPE = "image/x-inkscape-svg"
PDF = "application/pdf"
CSV = "text/csv"


def copy_page(drawing: Drawing, number: int) -> None:
    """Put a page on the clipboard as PDF (of all pages), SVG and a picture."""
    data = QMimeData()
    data.setData(PDF, pdf_bytes(drawing))
    svg = svg_bytes(drawing, number)
    data.setData(INKSCAPE, svg)
    data.setData(SVG, svg)
    data.setImageData(picture_of(drawing.pages[number], DPI))
    QGuiApplication.clipboard().setMimeData(data)


def copy_profile(document: Document) -> None:
    """Put the profile on the clipboard as SVG at true size, for drawing programs."""
    stream = BytesIO()
    write_svg(document, stream)
    data = QMimeData()
    data.setData(INKSCAPE, stream.getvalue())
    data.setData(SVG, stream.getvalue())
    # Illustrator and text editors take the source.
    data.setText(stream.getvalue().decode())
    QGuiApplication.clipboard().setMimeData(data)


def copy_table(document: Document, per_segment: int, curvature: bool = False) -> int:
    """Put points of the profile on the clipboard as a table, and return how many they are.

    Tabs between columns, as spreadsheets paste them, and CSV beside it; ``curvature`` comes with
    arc length and the distance from the plain cubic.
    """
    make = curvature_lines if curvature else csv_lines
    lines = make(document.surface, per_segment)
    data = QMimeData()
    data.setText("\n".join(line.replace(",", "\t") for line in lines) + "\n")
    data.setData(CSV, ("\n".join(lines) + "\n").encode())
    QGuiApplication.clipboard().setMimeData(data)
    return len(lines) - 1
