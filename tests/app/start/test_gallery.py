"""The gallery, by real keys and mouse, over a real window."""

import pytest
from PySide6.QtCore import QPoint, QSettings, Qt
from PySide6.QtGui import QImage
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QLabel

import resources
from app.files import thumbnails
from app.start.gallery import NOTHING
from app.start.preset_pictures import LARGEST_FILE, SIDE
from app.start.shape_words import SHAPE_WORDS
from app.theme import theme
from app.widgets.tile_list import WORD_LINES, lines_of, tile_size, words_width
from sgb_core.document.file import project_file
from tests.app.window_stage import WindowStage


@pytest.fixture
def stage(qtbot):
    QSettings().remove("recent_files")
    made = WindowStage(qtbot, wait_for_scene=False)
    yield made
    made.close()


def titles(tiles):
    return [tile.title for tile in tiles.tiles]


def open_gallery(stage):
    QTest.keyClick(stage.window, Qt.Key.Key_N, Qt.KeyboardModifier.ControlModifier)
    gallery = stage.window.welcome.gallery
    assert gallery.isVisible()
    return gallery


def test_letters_typed_over_the_pictures_search_at_once(stage):
    gallery = open_gallery(stage)
    for letter in "gob":
        QTest.keyClicks(stage.window.focusWidget(), letter)
    assert gallery.search.text() == "gob"
    assert titles(gallery.presets) == ["Goblet"]


@pytest.mark.parametrize("preset", resources.presets(), ids=lambda each: each.name)
def test_every_preset_has_a_small_picture_with_a_clear_ground(qapp, preset):
    assert preset.picture.stat().st_size <= LARGEST_FILE
    image = QImage(str(preset.picture))
    assert (image.width(), image.height()) == (SIDE, SIDE)
    assert image.pixelColor(1, 1).alpha() == 0
    solid = [
        image.pixelColor(x, y)
        for x in range(0, SIDE, 4)
        for y in range(0, SIDE, 4)
        if image.pixelColor(x, y).alpha() == 255
    ]
    assert len(solid) > 100
    # It stands out from the ground of both themes.
    mean = sum(colour.lightnessF() for colour in solid) / len(solid)
    for palette in (theme.LIGHT, theme.DARK):
        ground = theme.qt_palette(palette).base().color().lightnessF()
        assert abs(mean - ground) > 0.2


def test_it_opens_by_key_and_escape_leaves_everything_as_it_was(stage):
    before = stage.document
    gallery = open_gallery(stage)
    assert titles(gallery.presets)[0] == "Blank"
    assert len(gallery.presets.tiles) == 1 + len(resources.presets())
    assert not stage.window.isHidden()
    assert not gallery.isWindow()
    QTest.keyClick(stage.window.focusWidget(), Qt.Key.Key_Escape)
    assert gallery.isHidden()
    assert stage.document is before


def test_keys_walk_and_enter_opens(stage):
    gallery = open_gallery(stage)
    assert stage.window.focusWidget() is gallery.presets
    QTest.keyClick(gallery.presets, Qt.Key.Key_Right)
    QTest.keyClick(gallery.presets, Qt.Key.Key_Right)
    QTest.keyClick(gallery.presets, Qt.Key.Key_Return)
    assert gallery.isHidden()
    assert stage.document == project_file.loads(resources.load_preset("bowl"))
    assert stage.window.files.path is None
    assert not stage.session.is_modified


def test_a_click_opens(stage):
    gallery = open_gallery(stage)
    stage.settle()
    item = gallery.presets.findItems("Amphora", Qt.MatchFlag.MatchExactly)[0]
    at = gallery.presets.visualItemRect(item).center()
    QTest.mouseClick(gallery.presets.viewport(), Qt.MouseButton.LeftButton, pos=at)
    assert gallery.isHidden()
    assert stage.document.name == "Amphora"


def test_typing_narrows_and_enter_takes_the_first(stage):
    gallery = open_gallery(stage)
    gallery.search.setFocus()
    QTest.keyClicks(gallery.search, "pagd")
    assert titles(gallery.presets) == ["Pagoda"]
    gallery.search.clear()
    QTest.keyClicks(gallery.search, "terracotta")
    assert titles(gallery.presets) == ["Plant pot"]
    # Shapes answer to what they are used for, in words apart.
    for words, title in (("wine glass", "Goblet"), ("mug", "Jug with a spout"), ("a cup", "Bowl")):
        gallery.search.clear()
        QTest.keyClicks(gallery.search, words)
        assert title in titles(gallery.presets)
    QTest.keyClicks(gallery.search, "zzz")
    said = [w.text() for w in gallery.findChildren(QLabel) if w.isVisible()]
    assert NOTHING in said
    # Nobody is left with nothing: the blank sheet stays.
    assert titles(gallery.presets) == ["Blank"]
    QTest.keyClick(gallery.search, Qt.Key.Key_Down)
    assert stage.window.focusWidget() is gallery.presets
    QTest.keyClick(gallery.search, Qt.Key.Key_Return)
    assert len(stage.document.profile) == 1
    assert gallery.isHidden()


def test_recent_files_come_with_their_pictures(qtbot, tmp_path):
    stage = WindowStage(qtbot)
    QSettings().remove("recent_files")
    path = tmp_path / "jar.sgb"
    project_file.save(stage.document, path)
    # Never seen here: its outline on nothing.
    assert thumbnails.picture_of(path).isNull()
    outline = thumbnails.outline_of(path)
    assert outline.pixelColor(1, 1).alpha() == 0
    assert outline.pixelColor(outline.width() // 2, outline.height() // 2).alpha() == 255
    assert stage.window.files.open_path(path)
    qtbot.waitUntil(lambda: not thumbnails.picture_of(path).isNull())
    picture = thumbnails.picture_of(path).toImage()
    middle = picture.pixelColor(thumbnails.SIDE // 2, thumbnails.SIDE * 3 // 5)
    assert middle.green() > middle.red()
    gallery = open_gallery(stage)
    assert titles(gallery.recent) == ["jar"]
    stage.window.files.new_blank()
    QTest.keyClick(gallery.recent, Qt.Key.Key_Return)
    assert stage.window.files.path == path
    assert gallery.isHidden()
    stage.close()


def test_outlines_are_read_aside_and_put_into_their_tiles(qtbot, stage, tmp_path):
    for name in ("jar", "pot"):
        project_file.save(stage.document, tmp_path / f"{name}.sgb")
        stage.window.files.recent.add(tmp_path / f"{name}.sgb")
    gallery = open_gallery(stage)
    assert [tile.picture.isNull() for tile in gallery.recent.tiles] == [True, True]
    qtbot.waitUntil(lambda: not any(tile.picture.isNull() for tile in gallery.recent.tiles))
    gallery.search.setText("pot")
    assert titles(gallery.recent) == ["pot"]
    assert not gallery.recent.tiles[0].picture.isNull()


def test_a_file_that_cannot_be_read_has_no_picture(qapp, tmp_path):
    path = tmp_path / "broken.sgb"
    assert thumbnails.outline_of(path).isNull()
    path.write_text("{")
    assert thumbnails.outline_of(path).isNull()


def test_a_no_to_losing_work_stays_in_the_gallery(stage, monkeypatch):
    stage.window.commands["append_segment"].trigger()
    before = stage.document
    gallery = open_gallery(stage)
    with monkeypatch.context() as patch:
        patch.setattr(stage.window.files, "may_discard", lambda: False)
        QTest.keyClick(gallery.presets, Qt.Key.Key_Return)
    assert gallery.isVisible()
    assert stage.document is before


def test_it_stays_inside_the_window(stage):
    gallery = open_gallery(stage)
    for size in ((1024, 700), (1500, 940)):
        stage.window.resize(*size)
        stage.settle()
        assert stage.window.rect().contains(gallery.geometry())
        corner = gallery.mapTo(stage.window, QPoint(0, 0))
        assert corner.x() > 0


def test_the_window_behind_is_dimmed_and_a_click_there_leaves(stage):
    before, bright = stage.document, stage.window.grab().toImage().pixelColor(4, 200).lightnessF()
    gallery = open_gallery(stage)
    assert gallery.scrim.geometry() == stage.window.rect()
    dim = stage.window.grab().toImage().pixelColor(4, 200).lightnessF()
    assert dim < 0.8 * bright
    stage.window.resize(1400, 900)
    stage.settle()
    assert gallery.scrim.geometry() == stage.window.rect()
    QTest.mouseClick(gallery.scrim, Qt.MouseButton.LeftButton, pos=QPoint(4, 200))
    assert gallery.isHidden()
    assert gallery.scrim.isHidden()
    assert stage.document is before
    again = stage.window.grab().toImage().pixelColor(4, 200).lightnessF()
    assert again == pytest.approx(bright, abs=0.02)


def test_escape_leaves_the_gallery_and_not_the_notice_under_it(stage):
    stage.presenter.notify("Something is wrong.", "warning", stays=True)
    gallery = open_gallery(stage)
    for place in (gallery.presets, gallery.search, gallery.close_button):
        stage.window.welcome.show_gallery()
        place.setFocus()
        QTest.keyClick(stage.window.windowHandle(), Qt.Key.Key_Escape)
        assert gallery.isHidden()
        assert stage.window.notice_bar.isVisible()
    QTest.keyClick(stage.window.windowHandle(), Qt.Key.Key_Escape)
    stage.until(stage.window.notice_bar.isHidden)


def test_every_preset_has_other_words_and_its_description_is_read_whole(stage):
    assert set(SHAPE_WORDS) == {each.name for each in resources.presets()}
    gallery = open_gallery(stage)
    stage.settle()
    width = words_width(tile_size(gallery.presets).width())
    for tile in gallery.presets.tiles:
        assert len(lines_of(tile.words, gallery.presets.font(), width)) <= WORD_LINES, tile.title
