"""What stays the same while a slider moves is painted once."""

from dataclasses import replace

import pytest
from PySide6.QtCore import QSize, Qt
from PySide6.QtGui import QFont, QImage, QPainter, QPen

from app.hand.canvas import Canvas
from app.hand.coordinates import Area, Transform
from app.profile_editor.cached_layer import CachedLayer
from app.theme.palette import DARK, LIGHT

SIZE = QSize(40, 30)


@pytest.fixture
def sheet(qapp):
    image = QImage(SIZE, QImage.Format.Format_ARGB32)
    image.fill(Qt.GlobalColor.white)
    painter = QPainter(image)
    canvas = Canvas(painter, Transform(1.0, 0.0, 0.0), LIGHT, Area(0, 0, 40, 30), QFont())
    yield canvas, image
    painter.end()


def test_a_layer_is_painted_again_only_when_something_changes(sheet):
    canvas, image = sheet
    layer, painted = CachedLayer(), []

    def paint(on):
        painted.append(on)
        on.painter.setPen(QPen(Qt.GlobalColor.black, 4))
        on.painter.drawLine(0, 15, 40, 15)

    for _ in range(3):
        image.fill(Qt.GlobalColor.white)
        layer.draw(canvas, SIZE, "this", paint)
        assert image.pixelColor(20, 15) == Qt.GlobalColor.black
        assert image.pixelColor(20, 3) == Qt.GlobalColor.white
    assert len(painted) == 1
    layer.draw(canvas, SIZE, "that", paint)
    layer.draw(replace(canvas, palette=DARK), SIZE, "that", paint)
    layer.draw(replace(canvas, transform=Transform(2.0, 0.0, 0.0)), SIZE, "that", paint)
    layer.draw(canvas, QSize(50, 30), "that", paint)
    assert len(painted) == 5
