"""The drawing dialog: from choices to a page seen, told, copied and written."""

from __future__ import annotations

from xml.etree import ElementTree

import numpy as np
import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QGuiApplication, QImage
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QDialog, QFileDialog

from app.drawings import clipboard
from app.drawings.commands import draw_on_paper
from app.drawings.dialog import DrawingDialog
from app.drawings.page_view import PageView
from app.drawings.picture import picture_of
from app.drawings.sort import Sort
from sgb_core.bodies.solid import WallSide
from sgb_core.design.comparison import compared
from sgb_core.document.file import project_file
from sgb_core.drawings.drawing import draw
from sgb_core.drawings.page import Layer, Stroke
from sgb_core.drawings.scales import Paper
from sgb_core.drawings.wanted import Fill, Side, Wanted
from tests.sgb_core.drawings.pdf_reading import read_pdf
from tests.sgb_core.drawings.shapes import BENT, CUP, OTHERS, preset


@pytest.fixture
def dialog(qtbot):
    found = DrawingDialog(CUP)
    qtbot.addWidget(found, before_close_func=lambda each: each.done(0))
    found.show()
    drawn(qtbot, found)
    return found


def drawn(qtbot, dialog):
    qtbot.waitUntil(lambda: dialog.drawing is not None, timeout=60_000)
    return dialog.drawing


def choose(box, value) -> None:
    box.setCurrentIndex(box.findData(value))


def test_a_section_is_shown_first_and_told(dialog) -> None:
    assert dialog.told.text() == "Dimensioned section, 2:1 on A4 portrait."
    assert dialog.where.text() == "Page 1 of 1"
    assert dialog.save.isEnabled()
    assert dialog.suffix == ".pdf"


def test_paper_scale_side_and_fill_change_the_page(qtbot, dialog) -> None:
    choices = dialog.choices
    choose(choices.paper, Paper.A3)
    choose(choices.side, Side.LEFT)
    choose(choices.fill, Fill.FILLED)
    assert dialog.drawing is None
    assert not dialog.save.isEnabled()
    (page,) = drawn(qtbot, dialog).pages
    assert {page.width, page.height} == {297.0, 420.0}
    (area,) = page.of_layer(Layer.MATERIAL)
    assert area.paths[0].flat()[:, 0].max() < page.origin[0] + 1e-6


def test_a_plate_takes_vessels_of_other_files(qtbot, dialog, tmp_path, monkeypatch) -> None:
    assert not dialog.files.isVisibleTo(dialog)
    choose(dialog.choices.sort, Sort.VESSEL)
    assert dialog.files.isVisibleTo(dialog)
    other = tmp_path / "bent.sgb"
    project_file.save(BENT, other)
    monkeypatch.setattr(QFileDialog, "getOpenFileNames", lambda *_: ([str(other)], ""))
    dialog.add_files.click()
    assert drawn(qtbot, dialog).title == f"{CUP.name}, Bent"
    dialog.others.setCurrentRow(0)
    dialog.remove_file.click()
    assert drawn(qtbot, dialog).title == CUP.name


def test_a_file_that_is_none_is_said_in_a_line(qtbot, dialog, tmp_path, monkeypatch) -> None:
    wrong = tmp_path / "wrong.sgb"
    wrong.write_text("{")
    monkeypatch.setattr(QFileDialog, "getOpenFileNames", lambda *_: ([str(wrong)], ""))
    choose(dialog.choices.sort, Sort.VESSEL)
    drawn(qtbot, dialog)
    dialog.add_files.click()
    assert dialog.told.text().startswith("wrong.sgb: ")
    assert dialog.others.count() == 0


def test_a_template_has_its_own_choices_and_pages(qtbot) -> None:
    dialog = DrawingDialog(preset("vase"))
    qtbot.addWidget(dialog, before_close_func=lambda each: each.done(0))
    dialog.show()
    choose(dialog.choices.sort, Sort.TEMPLATE)
    assert not dialog.choices.scale.isVisibleTo(dialog)
    assert dialog.choices.wall.isVisibleTo(dialog)
    assert [dialog.format.itemData(k) for k in range(dialog.format.count())] == [".pdf"]
    assert len(drawn(qtbot, dialog).pages) == 2
    assert not dialog.back.isEnabled()
    dialog.forth.click()
    assert dialog.where.text() == "Page 2 of 2"
    assert not dialog.forth.isEnabled()
    choose(dialog.choices.wall, WallSide.INSIDE)
    assert "inside of the wall" in drawn(qtbot, dialog).subject


def test_what_cannot_be_drawn_is_said_and_not_saved(qtbot) -> None:
    dialog = DrawingDialog(OTHERS["huge"])
    qtbot.addWidget(dialog, before_close_func=lambda each: each.done(0))
    dialog.show()
    choose(dialog.choices.sort, Sort.TEMPLATE)
    qtbot.waitUntil(lambda: "at most 100 are made" in dialog.told.text(), timeout=60_000)
    assert dialog.told.text().startswith("At true size it takes ")
    assert not dialog.save.isEnabled()


def test_the_keyboard_alone_reaches_all(qtbot, dialog) -> None:
    dialog.activateWindow()
    dialog.choices.sort.setFocus()
    QTest.keyClick(dialog.choices.sort, Qt.Key.Key_Down)
    assert dialog.choices.chosen_sort is Sort.VESSEL
    drawn(qtbot, dialog)
    seen = set()
    for _ in range(30):
        widget = dialog.focusWidget()
        seen.add(widget)
        QTest.keyClick(widget, Qt.Key.Key_Tab)
    for widget in (dialog.choices.paper, dialog.add_files, dialog.format, dialog.save, dialog.copy):
        assert widget in seen


def test_every_control_says_what_it_is_for(dialog) -> None:
    choices = dialog.choices
    for control in (
        choices.sort,
        choices.paper,
        choices.scale,
        choices.side,
        choices.fill,
        choices.stage,
        choices.wall,
        dialog.others,
        dialog.add_files,
        dialog.copy,
        dialog.remove_file,
        dialog.format,
        dialog.back,
        dialog.forth,
        dialog.save,
    ):
        assert control.accessibleName()
        assert control.toolTip()


def test_the_preview_is_the_page(qtbot) -> None:
    """Each line of the page is dark in the picture, at its own place."""
    page = draw([CUP], Wanted()).pages[0]
    image = picture_of(page, 254.0).convertToFormat(QImage.Format.Format_Grayscale8)
    width, height = image.width(), image.height()
    assert (width, height) == (2100, 2970)
    grey = np.frombuffer(image.constBits(), np.uint8).reshape(height, image.bytesPerLine())
    for mark in page.of_layer(Layer.OUTLINE):
        assert isinstance(mark, Stroke)
        for path in mark.paths:
            middle = path.flat()[:2].mean(axis=0)
            assert grey[round((page.height - middle[1]) * 10) - 1, round(middle[0] * 10)] < 100
    # Letters are drawn too: the words of the title lie within their boxes.
    dark = np.argwhere(grey < 100)
    low = dark[:, 0].max() / 10.0
    assert low == pytest.approx(page.height - page.margins[2], abs=0.6)


def test_a_page_fits_its_widget_whatever_its_shape(qtbot) -> None:
    view = PageView()
    qtbot.addWidget(view)
    view.resize(300, 600)
    view.show_page(draw([OTHERS["plate"]], Wanted()).pages[0])
    shown = view.grab().toImage()
    middle = shown.pixelColor(150, 300)
    assert middle.lightness() > 200 or middle.lightness() < 60
    assert shown.pixelColor(3, 3).lightness() == shown.pixelColor(296, 596).lightness()


def test_the_page_goes_to_the_clipboard(qtbot, dialog) -> None:
    dialog.copy.click()
    data = QGuiApplication.clipboard().mimeData()
    pdf = bytes(data.data(clipboard.PDF).data())
    assert read_pdf(pdf).about["Title"] == CUP.name
    root = ElementTree.fromstring(bytes(data.data(clipboard.SVG).data()))
    assert root.get("width") == "210mm"
    assert data.hasImage()
    assert dialog.told.text() == "Copied the page to the clipboard."


def test_the_profile_goes_to_the_clipboard_as_svg(qtbot) -> None:
    clipboard.copy_profile(BENT)
    data = QGuiApplication.clipboard().mimeData()
    root = ElementTree.fromstring(bytes(data.data(clipboard.SVG).data()))
    assert any(path.get("id") == "generatrix" for path in root.iter() if "path" in path.tag)
    assert bytes(data.data(clipboard.INKSCAPE).data()) == bytes(data.data(clipboard.SVG).data())


def test_points_go_to_the_clipboard_as_a_table(qtbot) -> None:
    assert clipboard.copy_table(BENT, 5) == 10
    data = QGuiApplication.clipboard().mimeData()
    head, *rows = data.text().splitlines()
    assert head.split("\t") == ["segment", "s", "r", "h"]
    values = np.array([[float(v) for v in row.split("\t")] for row in rows])
    assert np.array_equal(values[:, 2:], BENT.profile.sample(5).reshape(-1, 2))
    assert bytes(data.data(clipboard.CSV).data()).decode().count(",") == 33


class _Exporting:
    def __init__(self, target) -> None:
        self.target, self.asked = target, []

    def ask_path(self, title: str, suffix: str):
        self.asked.append((title, suffix))
        return self.target

    def write(self, path, work) -> None:
        work(lambda _: None)


class _Presenter:
    document = CUP


@pytest.mark.parametrize("suffix", [".pdf", ".svg", ".dxf", ".png"])
def test_what_is_shown_is_what_is_written(suffix, qtbot, tmp_path, monkeypatch) -> None:
    def accept(dialog) -> QDialog.DialogCode:
        dialog.show()
        choose(dialog.format, suffix)
        drawn(qtbot, dialog)
        dialog.accept()
        return QDialog.DialogCode.Accepted

    monkeypatch.setattr(DrawingDialog, "exec", accept)
    exporting = _Exporting(tmp_path / f"cup{suffix}")
    draw_on_paper(exporting, _Presenter(), None)
    assert exporting.asked == [("Drawing on paper", suffix)]
    assert exporting.target.stat().st_size > 1000


def test_curves_are_compared_in_numbers_and_as_a_plate(qtbot, dialog) -> None:
    choose(dialog.choices.sort, Sort.CURVES)
    drawing = drawn(qtbot, dialog)
    words = dialog.told.text()
    for each in compared(CUP.profile)[:3]:
        assert f"{each.energy:.4g}/{CUP.unit}" in words
    cubic = compared(CUP.profile)[1]
    assert f"plain cubic {cubic.energy:.4g}/mm, up to {cubic.deviation:.3g} mm off" in words
    assert len(drawing.pages) == 1
    assert not dialog.choices.paper.isVisibleTo(dialog)
    assert [dialog.format.itemData(k) for k in range(dialog.format.count())] == [
        ".pdf",
        ".svg",
        ".dxf",
        ".png",
    ]


def test_the_command_for_curves_begins_with_them(qtbot) -> None:
    found = DrawingDialog(CUP, None, Sort.CURVES)
    qtbot.addWidget(found, before_close_func=lambda each: each.done(0))
    assert found.choices.chosen_sort is Sort.CURVES
    assert drawn(qtbot, found).subject.startswith("Curves on one control polygon")


def test_curvature_along_the_profile_is_a_figure_and_a_table(qtbot, dialog) -> None:
    choose(dialog.choices.sort, Sort.CURVATURE)
    drawing = drawn(qtbot, dialog)
    assert drawing.subject.startswith("Curvature and distance from the plain cubic")
    assert not dialog.choices.paper.isVisibleTo(dialog)
    assert not dialog.choices.scale.isVisibleTo(dialog)
    count = clipboard.copy_table(BENT, 5, curvature=True)
    head, *rows = QGuiApplication.clipboard().text().splitlines()
    assert head.split("\t")[-3:] == ["length", "curvature", "deviation"]
    assert len(rows) == count == 5 * len(BENT.profile)


def test_a_picture_is_as_fine_as_is_asked(qtbot, tmp_path, monkeypatch) -> None:
    def accept(dialog) -> QDialog.DialogCode:
        dialog.show()
        assert not dialog.dpi.isVisible()
        choose(dialog.format, ".png")
        assert dialog.dpi.isVisible()
        dialog.dpi.set_value(100.0)
        drawn(qtbot, dialog)
        dialog.accept()
        return QDialog.DialogCode.Accepted

    monkeypatch.setattr(DrawingDialog, "exec", accept)
    exporting = _Exporting(tmp_path / "cup.png")
    draw_on_paper(exporting, _Presenter(), None, Sort.CURVATURE)
    image = QImage(str(exporting.target))
    assert (image.width(), image.height()) == (round(175 / 0.254), round(120 / 0.254))
