"""A page of a drawing painted: on the screen, and as a picture of the user's resolution."""

from __future__ import annotations

from functools import cache
from types import MappingProxyType

from PySide6.QtCore import QBuffer, QPointF, QRectF, Qt
from PySide6.QtGui import (
    QColor,
    QFont,
    QFontDatabase,
    QImage,
    QImageWriter,
    QPainter,
    QPainterPath,
    QPen,
    QTransform,
)

from app.state.user_folders import PROGRAM
from sgb_core.drawings import fonts
from sgb_core.drawings.drawing import WRITERS, Writers
from sgb_core.drawings.errors import DrawingError
from sgb_core.drawings.page import Anchor, Area, Drawing, Mark, Page, Path, Stroke, Words
from sgb_core.findings.drawings import TooFine
from sgb_core.lettering.fonts import font_path

PNG = ".png"
# Pixels to the inch where none are asked for, and the most pixels of a picture: A2 at 600.
DPI, MOST_PIXELS = 300.0, 150_000_000
# The size at which letters are taken from the font.
_LETTERS = 200


def writers(dpi: float = DPI) -> Writers:
    """Return what makes the bytes of a drawing by suffix, a picture of so many dpi among them."""
    return MappingProxyType({**WRITERS, PNG: lambda drawing: png_bytes(drawing, dpi)})


def png_bytes(drawing: Drawing, dpi: float) -> bytes:
    """Return the first page as a PNG file of so many pixels to the inch, titled as the drawing.

    Raises DrawingError for more than MOST_PIXELS pixels.
    """
    page, per_mm = drawing.pages[0], dpi / 25.4
    if page.width * page.height * per_mm**2 > MOST_PIXELS:
        most = 25.4 * (MOST_PIXELS / (page.width * page.height)) ** 0.5
        raise DrawingError(TooFine(dpi, int(most)))
    image = picture_of(page, dpi)
    for key, text in (
        ("Title", drawing.title),
        ("Description", drawing.subject),
        ("Software", PROGRAM),
    ):
        image.setText(key, text)
    buffer = QBuffer()
    buffer.open(QBuffer.OpenModeFlag.WriteOnly)
    QImageWriter(buffer, b"png").write(image)
    return bytes(buffer.data().data())


def picture_of(page: Page, dpi: float) -> QImage:
    """Return a page as a picture of so many pixels to the inch."""
    per_mm = dpi / 25.4
    image = QImage(
        round(page.width * per_mm), round(page.height * per_mm), QImage.Format.Format_RGB32
    )
    image.setDotsPerMeterX(round(1000.0 * per_mm))
    image.setDotsPerMeterY(round(1000.0 * per_mm))
    painter = QPainter(image)
    painter.scale(image.width() / page.width, image.height() / page.height)
    paint_page(painter, page)
    painter.end()
    return image


def paint_page(painter: QPainter, page: Page) -> None:
    """Paint a page where a unit is a millimetre and the sheet's top left corner is (0, 0)."""
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    painter.fillRect(QRectF(0.0, 0.0, page.width, page.height), QColor("white"))
    # y upwards, as pages have it.
    painter.setTransform(QTransform(1.0, 0.0, 0.0, -1.0, 0.0, page.height), True)
    for layer in page.layers:
        for mark in page.of_layer(layer):
            _paint(painter, mark)


def _paint(painter: QPainter, mark: Mark) -> None:
    if isinstance(mark, Stroke):
        pen = QPen(QColor(mark.pen.colour), mark.pen.width)
        pen.setCapStyle(Qt.PenCapStyle.FlatCap)
        pen.setJoinStyle(Qt.PenJoinStyle.RoundJoin)
        if mark.pen.dashes:
            # Qt counts dashes in widths of the pen.
            pen.setDashPattern([length / mark.pen.width for length in mark.pen.dashes])
        for path in mark.paths:
            painter.strokePath(_outline((path,)), pen)
    elif isinstance(mark, Area):
        painter.fillPath(_outline(mark.paths), QColor(mark.colour))
    else:
        painter.fillPath(_letters(mark), QColor("black"))


def _outline(paths: tuple[Path, ...]) -> QPainterPath:
    outline = QPainterPath()
    outline.setFillRule(Qt.FillRule.OddEvenFill)
    for path in paths:
        outline.moveTo(QPointF(*path.pieces[0][0].tolist()))
        for piece in path.pieces:
            points = [QPointF(*point) for point in piece[1:].tolist()]
            if len(points) == 1:
                outline.lineTo(points[0])
            else:
                outline.cubicTo(*points)
        if path.closed:
            outline.closeSubpath()
    return outline


@cache
def _font() -> QFont:
    """Return the very font that files carry."""
    number = QFontDatabase.addApplicationFont(str(font_path()))
    families = QFontDatabase.applicationFontFamilies(number) or [fonts.FAMILY]
    font = QFont(families[0])
    font.setPixelSize(_LETTERS)
    font.setHintingPreference(QFont.HintingPreference.PreferNoHinting)
    return font


def _letters(words: Words) -> QPainterPath:
    share = {Anchor.START: 0.0, Anchor.MIDDLE: 0.5, Anchor.END: 1.0}[words.anchor]
    path = QPainterPath()
    path.addText(QPointF(), _font(), words.text)
    size = fonts.em(words.height) / _LETTERS
    place = QTransform().translate(*words.at).rotate(words.turn_deg)
    place.translate(-share * fonts.width(words.text, words.height), 0.0)
    return place.scale(size, -size).map(path)
