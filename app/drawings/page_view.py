"""A page as it will be printed, line widths and letters included, as large as there is room."""

from __future__ import annotations

from functools import cache

from PySide6.QtCore import QPointF, QRectF, QSize, Qt
from PySide6.QtGui import (
    QColor,
    QFont,
    QFontDatabase,
    QImage,
    QPainter,
    QPainterPath,
    QPaintEvent,
    QPen,
    QTransform,
)
from PySide6.QtWidgets import QSizePolicy, QWidget

from sgb_core.drawings import fonts
from sgb_core.drawings.page import Anchor, Area, Mark, Page, Path, Stroke, Words
from sgb_core.lettering.fonts import font_path

# Around the sheet, in pixels; the size at which letters are taken from the font.
_AROUND, _LETTERS = 12, 200
_SHADOW = QColor(0, 0, 0, 60)


class PageView(QWidget):
    """Shows one page of a drawing."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._page: Page | None = None
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        self.setMinimumSize(QSize(220, 220))
        self.setAccessibleName("Preview of the page")
        self.setToolTip("The page as it will be printed")

    def show_page(self, page: Page | None) -> None:
        """Show a page, or none."""
        self._page = page
        self.update()

    def paintEvent(self, _: QPaintEvent) -> None:
        if self._page is None:
            return
        page = self._page
        width, height = self.width() - 2 * _AROUND, self.height() - 2 * _AROUND
        scale = min(width / page.width, height / page.height)
        left = 0.5 * (self.width() - scale * page.width)
        top = 0.5 * (self.height() - scale * page.height)
        painter = QPainter(self)
        sheet = QRectF(left, top, scale * page.width, scale * page.height)
        painter.fillRect(sheet.translated(2.0, 2.0), _SHADOW)
        painter.translate(left, top)
        painter.scale(scale, scale)
        paint_page(painter, page)
        painter.end()


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
