"""The icons: all there, drawn in the theme's colour, sharp at every scale."""

import pytest
from PySide6.QtCore import QSize
from PySide6.QtGui import QIcon
from PySide6.QtWidgets import QToolButton

import resources
from app.theme import icons, theme
from tests.app.waiting import let_turn

NAMES = sorted(
    file.stem for file in resources.path("icons").glob("*.svg") if not file.stem.startswith("style")
)


@pytest.fixture
def app(qapp):
    theme.apply(qapp, "light")
    yield qapp
    theme.apply(qapp, "light")


def ink(image):
    """Return the colour names of all fully opaque pixels."""
    width, height = image.width(), image.height()
    pixels = (image.pixelColor(x, y) for x in range(width) for y in range(height))
    return {pixel.name() for pixel in pixels if pixel.alpha() == 255}


@pytest.mark.parametrize("name", NAMES)
def test_is_drawn_in_one_colour_inside_its_frame(app, name):
    image = icons.pixmap(name, 48, "#ff0000").toImage()
    assert ink(image) == {"#ff0000"}
    border = [image.pixelColor(x, y) for x in (0, 47) for y in range(48)]
    assert all(pixel.alpha() == 0 for pixel in border)


def test_what_the_window_needs_is_there():
    needed = """undo redo new open save export screenshot fit perspective parallel presets show
        mesh theme reset axis-x axis-y axis-z view-top view-front view-side view-iso
        segment-append segment-insert segment-remove segment-reverse segment-split"""
    assert set(needed.split()) <= set(NAMES)


def test_an_unknown_name_is_refused(app):
    with pytest.raises(FileNotFoundError):
        icons.icon("no-such-icon")


def test_is_sharp_on_a_screen_of_scale_two(app):
    pixmap = icons.icon("undo").pixmap(QSize(24, 24), 2.0)
    assert pixmap.width() == 48
    assert theme.LIGHT.text in ink(pixmap.toImage())


def test_a_disabled_icon_is_faint(app):
    image = icons.icon("undo").pixmap(QSize(24, 24), QIcon.Mode.Disabled).toImage()
    assert theme.LIGHT.text not in ink(image)


def test_bound_icons_follow_the_theme(app, qtbot):
    button = QToolButton()
    qtbot.addWidget(button)
    icons.bind(button, "reset")
    theme.apply(app, "dark")
    assert theme.DARK.text in ink(button.icon().pixmap(QSize(48, 48)).toImage())


def test_a_button_that_is_gone_is_forgotten(app, qtbot):
    parent = QToolButton()
    child = QToolButton(parent)
    icons.bind(child, "reset")
    parent.deleteLater()
    let_turn()
    theme.apply(app, "dark")
