"""The look panel, driven as a hand would, on a real presenter."""

import numpy as np
import pytest
from PySide6.QtCore import QPoint, Qt, QTimer
from PySide6.QtGui import QColor, QCursor
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QFileDialog, QToolButton

import resources
from app.panels.look.panel import LookPanel
from app.state.presenter import Presenter
from sgb_core.document.appearance.model import (
    PLAIN,
    LayerKind,
    MapKind,
    MaterialName,
    Scale,
    Shading,
)
from sgb_core.document.appearance.pictures import encode_png
from sgb_core.document.edits import apply_look
from sgb_core.document.session import Session
from tests.app.mouse import drag
from tests.app.viewport.helpers import document
from tests.app.waiting import let_turn


@pytest.fixture
def panel(qtbot):
    presenter = Presenter(Session(document()))
    panel = LookPanel(presenter)
    qtbot.addWidget(panel)
    presenter.add_view(panel)
    presenter.refresh_now()
    panel.show()
    return panel


def look(panel):
    panel.material.presenter.refresh_now()
    return panel.material.presenter.document.appearance


def choose(box, value):
    index = box.findData(value)
    assert index >= 0
    box.setCurrentIndex(index)
    box.activated.emit(index)


def enter(field, text):
    field.setFocus()
    field.selectAll()
    field.setText(text)
    field.setModified(True)
    field.clearFocus()
    field.take_text()


def test_material_light_and_ground(panel, qtbot):
    part = panel.material
    choose(part.material, MaterialName.CELADON)
    choose(part.lighting, "gallery")
    choose(part.background, "dark")
    for box in (part.shadow, part.silhouette, part.features, part.flat):
        qtbot.mouseClick(box, Qt.MouseButton.LeftButton, pos=box.rect().center() / 4)
    found = look(panel)
    assert (found.material, found.lighting, found.background) == ("celadon", "gallery", "dark")
    assert (found.shadow, found.silhouette, found.features) == (True, True, True)
    assert found.shading is Shading.FLAT
    for _ in range(7):
        part.presenter.undo()
    assert look(panel) == PLAIN
    assert part.material.currentData() == MaterialName.CLAY
    assert not part.shadow.isChecked()


def test_a_colour_is_seen_while_it_is_chosen_and_is_one_entry(panel):
    button = panel.material.colour_button
    button.click()
    button._dialog.setCurrentColor(QColor("#204060"))
    assert look(panel).color == "#204060"
    button._dialog.reject()
    assert look(panel).color is None
    button.click()
    button._dialog.setCurrentColor(QColor("#102030"))
    button._dialog.setCurrentColor(QColor("#a0b0c0"))
    button._dialog.accept()
    assert look(panel).color == "#a0b0c0"
    panel.material.own.click()
    assert look(panel).color is None
    panel.material.presenter.undo()
    panel.material.presenter.undo()
    assert look(panel) == PLAIN


def test_textures_on_everything_and_on_one_segment(panel):
    part = panel.texture
    assert not part.around.isEnabled()
    choose(part.image, "lotus")
    assert part.presenter.session.undo_label == "Texture lotus"
    enter(part.around, "6")
    choose(part.where, 1)
    assert part.image.currentData() is None
    choose(part.image, "brick")
    enter(part.turn, "90")
    found = look(panel).textures
    assert [(each.image, each.segments) for each in found] == [("lotus", None), ("brick", (1,))]
    assert found[0].repeat[0] == 6.0
    assert found[1].rotate_deg == 90.0
    choose(part.image, None)
    assert part.presenter.session.undo_label == "Texture none"
    assert [each.image for each in look(panel).textures] == ["lotus"]
    choose(part.where, None)
    assert part.around.value == 6.0


def test_a_picture_from_a_file(panel, tmp_path):
    path = tmp_path / "own.png"
    path.write_bytes(encode_png(np.zeros((4, 4, 3), np.uint8)))
    panel.texture.take_picture(path)
    assert len(look(panel).pictures) == 1
    assert panel.texture.presenter.session.undo_label == "Picture own.png"
    assert panel.texture.image.currentText() == "own"
    assert not panel.texture.image.itemIcon(panel.texture.image.currentIndex()).isNull()
    notices = []
    panel.texture.presenter.noticed.connect(notices.append)
    path.write_bytes(b"no picture")
    panel.texture.take_picture(path)
    panel.texture.take_picture(tmp_path / "missing.png")
    assert len(notices) == 2


def test_a_picture_from_a_file_covers_the_chosen_segment_alone(panel, tmp_path, monkeypatch):
    part = panel.texture
    choose(part.image, "lotus")
    choose(part.where, 1)
    choose(part.image, "brick")
    choose(part.where, 0)
    path = tmp_path / "own.png"
    path.write_bytes(encode_png(np.zeros((4, 4, 3), np.uint8)))
    monkeypatch.setattr(QFileDialog, "getOpenFileName", lambda *_: (str(path), ""))
    choose(part.image, "own picture")
    name = look(panel).pictures[0].name
    found = [(each.image, each.segments) for each in look(panel).textures]
    assert found == [("lotus", None), ("brick", (1,)), (name, (0,))]
    assert part.image.currentText() == "own"
    # What the project has is offered for other parts too, and goes with its last use.
    choose(part.where, 1)
    choose(part.image, name)
    assert part.presenter.session.undo_label == "Texture own"
    assert [each.image for each in look(panel).textures] == ["lotus", name, name]
    part.presenter.undo()
    part.presenter.undo()
    part.refresh(part.presenter.frame)
    assert part.image.findData(name) == -1
    assert [each.image for each in look(panel).textures] == ["lotus", "brick"]


def test_add_does_not_stay_pressed_when_the_list_moves_it(panel, qtbot):
    add = next(b for b in panel.findChildren(QToolButton) if b.text() == "Add")
    QCursor.setPos(add.mapToGlobal(add.rect().center()))
    qtbot.waitUntil(add.underMouse)

    def choose_stripes():
        menu = add.menu()
        entry = next(each for each in menu.actions() if each.text() == "Stripes")
        QTest.mouseClick(menu, Qt.LeftButton, pos=menu.actionGeometry(entry).center())

    QTimer.singleShot(0, choose_stripes)
    QTest.mouseClick(add, Qt.LeftButton)
    QCursor.setPos(add.mapToGlobal(QPoint(-60, -60)))
    assert look(panel).drawing[0].kind is LayerKind.STRIPES
    qtbot.waitUntil(lambda: not (add.isDown() or add.underMouse()))


def test_layers_are_added_set_raised_and_removed(panel):
    part = panel.drawing
    part.add(LayerKind.BAND)
    enter(part.start, "10")
    enter(part.end, "20")
    part.add(LayerKind.RINGS)
    enter(part.count, "5")
    part.add(LayerKind.SEGMENTS)
    part.segments.setText("1, 3")
    part.segments.setModified(True)
    part.segments.editingFinished.emit()
    drawing = look(panel).drawing
    assert [each.kind for each in drawing] == ["band", "rings", "segments"]
    assert (drawing[0].start, drawing[0].end) == (0.1, 0.2)
    assert drawing[1].count == 5
    assert drawing[2].segments == (0, 2)
    part.layers.setCurrentRow(0)
    part.raise_layer()
    assert [each.kind for each in look(panel).drawing] == ["rings", "band", "segments"]
    assert part.layers.currentRow() == 1
    part.remove()
    assert [each.kind for each in look(panel).drawing] == ["rings", "segments"]


def test_a_gradient_is_edited_in_place(panel, qtbot):
    part = panel.drawing
    part.add(LayerKind.GRADIENT)
    bar = part.stops
    look(panel)
    bar.add(0.5)
    assert len(look(panel).drawing[0].stops) == 3
    let_turn()
    drag(bar, *(QPoint(round(bar._x(x)), 28) for x in (0.5, 0.75)))
    assert look(panel).drawing[0].stops[1][0] == pytest.approx(0.75, abs=2.0 / bar.width())
    qtbot.keyClick(bar, Qt.Key.Key_Delete)
    assert len(look(panel).drawing[0].stops) == 2
    qtbot.keyClick(bar, Qt.Key.Key_Delete)
    assert len(look(panel).drawing[0].stops) == 2


def test_maps_and_their_limits(panel, qtbot):
    part = panel.map
    choose(part.of, MapKind.RADIUS)
    assert look(panel).map.of is MapKind.RADIUS
    assert part.auto.isChecked()
    choose(part.scale, Scale.CIVIDIS)
    part.auto.click()
    found = look(panel).map
    assert found.low == pytest.approx(16.0, rel=0.2)
    enter(part.high, "80")
    assert look(panel).map.high == 80.0
    notices = []
    part.presenter.noticed.connect(notices.append)
    enter(part.low, "90")
    assert look(panel).map.low < 80.0
    part.auto.click()
    assert look(panel).map.high is None
    choose(part.of, None)
    assert look(panel).map is None


def test_everything_off_again(panel):
    choose(panel.material.material, MaterialName.WOOD)
    panel.drawing.add(LayerKind.BAND)
    panel.plain.click()
    assert look(panel) == PLAIN


def test_every_control_has_a_name_and_a_tip(panel):
    for part in (panel.material, panel.texture, panel.drawing, panel.map):
        for name in ("QComboBox", "QLineEdit", "QToolButton", "QCheckBox"):
            for widget in part.findChildren(object):
                if widget.metaObject().className() == name and widget.objectName()[:3] != "qt_":
                    assert widget.toolTip() or widget.parent().toolTip(), widget


def test_ready_made_looks(panel):
    part = panel.material
    part.ready.setCurrentIndex(1)
    part.ready.activated.emit(1)
    assert look(panel).material is MaterialName.PORCELAIN
    part.presenter.undo()
    assert look(panel) == PLAIN


def test_every_ready_made_look_can_be_read():
    for each in resources.looks():
        found = apply_look(document(), each.appearance).appearance
        assert found != PLAIN
        for texture in found.textures:
            assert resources.texture(texture.image)


@pytest.mark.parametrize("row", ["shift_u", "shift_v", "around", "along", "turn"])
def test_a_texture_takes_every_number_that_its_field_allows(panel, row):
    part = panel.texture
    choose(part.image, "lotus")
    field = getattr(part, row)
    for least in (field.kind.minimum, field.kind.maximum):
        enter(field, f"{least:g}")
        found = look(panel).textures[0]
        assert least in (*found.offset, *found.repeat, found.rotate_deg)
    enter(field, "1001")
    assert 1001.0 not in (*found.offset, *found.repeat, found.rotate_deg)
    assert field.value == field.kind.maximum
