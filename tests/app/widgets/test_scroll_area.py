import pytest
from PySide6.QtWidgets import QApplication, QPushButton, QVBoxLayout, QWidget

from app.theme import theme
from app.widgets import step_burst
from app.widgets.mark_slider import MarkSlider
from app.widgets.scroll_area import PanelArea
from app.widgets.step_burst import ScrollGuard
from app.window.main_window import MainWindow
from tests.app.mouse import wheel


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


def test_a_wheel_that_scrolls_passes_over_the_sliders(qtbot, monkeypatch):
    monkeypatch.setattr(step_burst, "SCROLL_SECONDS", 1e9)
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


def test_the_area_is_as_wide_as_what_it_holds_needs_now(qtbot):
    area, _ = panel(qtbot, 150)
    button = QPushButton("Short", area.widget())
    area.widget().layout().addWidget(button)
    button.setText("A button with a great many words on it")
    qtbot.waitUntil(lambda: area.minimumSizeHint().width() > button.sizeHint().width())
    bar = area.verticalScrollBar().sizeHint().width()
    assert area.minimumSizeHint().width() == area.widget().minimumSizeHint().width() + bar


@pytest.mark.parametrize("percent", [100, 150])
def test_no_panel_is_cut_off_in_a_small_window_with_large_text(qtbot, percent):
    app = QApplication.instance()
    theme.apply(app, "light")
    usual, large = app.font(), app.font()
    large.setPointSizeF(usual.pointSizeF() * percent / 100)
    app.setFont(large)
    try:
        window = MainWindow()
        window.resize(1024, 700)
        window.show()
        for name in ("shape", "turn", "vary", "solid", "measures", "look"):
            window.panels.docks[name].raise_()
            for area in window.panels.docks[name].findChildren(PanelArea):
                qtbot.waitUntil(lambda a=area: a.widget().width() <= a.viewport().width())
        for button in window.panels["states"].findChildren(QPushButton):
            assert button.width() >= button.sizeHint().width(), button.text()
        assert window.width() == 1024
        window.close()
    finally:
        app.setFont(usual)
