from PySide6.QtWidgets import QVBoxLayout, QWidget

from app.gesture import ScrollGuard
from app.mark_slider import MarkSlider
from app.panel_area import PanelArea
from tests.app.hand import wheel


def panel(qtbot, height):
    content = QWidget()
    layout = QVBoxLayout(content)
    sliders = [MarkSlider(0.0, 4.0, 1.0, 0.1) for _ in range(12)]
    for slider in sliders:
        slider.setFixedHeight(40)
        layout.addWidget(slider)
    area = PanelArea(content)
    area.resize(200, height)
    qtbot.addWidget(area)
    area.show()
    return area, sliders


def test_a_wheel_that_scrolls_passes_over_the_sliders(qtbot):
    area, sliders = panel(qtbot, 150)
    assert wheel(area.viewport(), -1) is not None
    assert ScrollGuard.scrolling()
    before = area.verticalScrollBar().value()
    wheel(sliders[0], -1)
    assert sliders[0].number == 1.0
    assert area.verticalScrollBar().value() > before > 0


def test_where_nothing_scrolls_the_sliders_turn(qtbot):
    area, sliders = panel(qtbot, 900)
    wheel(area.viewport(), -1)
    wheel(sliders[0], -1)
    assert sliders[0].number < 1.0
