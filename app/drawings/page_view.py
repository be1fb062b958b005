"""A page as it will be printed, line widths and letters included, as large as there is room."""

from __future__ import annotations

from PySide6.QtCore import QRectF, QSize
from PySide6.QtGui import QColor, QPainter, QPaintEvent
from PySide6.QtWidgets import QSizePolicy, QWidget

from app.drawings.picture import paint_page
from sgb_core.drawings.page import Page

# Around the sheet, in pixels.
_AROUND = 12
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
