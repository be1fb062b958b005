"""The heads-up label: where it stands."""

from PySide6.QtGui import QFont

from app.hand.coordinates import Area, ScreenPoint
from app.hand.readout import Label


def test_a_label_stays_inside_when_the_hand_has_left(qtbot):
    label = Label.of(["P1 of segment 2", "r 10  h 20"], QFont())
    area = Area(0.0, 0.0, 400.0, 300.0)
    for x, y in ((-50.0, -50.0), (500.0, 400.0), (200.0, 330.0)):
        box = label.beside(ScreenPoint(x, y), area)
        assert box.left() >= 0.0
        assert box.top() >= 0.0
        assert box.right() <= 400.0
        assert box.bottom() <= 300.0
