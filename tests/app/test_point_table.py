import numpy as np
import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import QApplication, QLineEdit

from app.point_table import HEIGHT, RADIUS, PointTable
from app.presenter import Presenter
from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import Segment
from sgb_core.document.model import Document
from sgb_core.document.session import Session

ROWS = [(0, 0), (0, 1), (0, 2), (0, 3), (1, 1), (1, 2), (1, 3)]


def document():
    return Document(
        Profile.of(
            [
                Segment(np.array([(20.0, 0), (45, 10), (52, 40), (38, 60)])),
                Segment(np.array([(38.0, 60), (24, 80), (14, 95), (1 / 3, 112)])),
            ]
        )
    )


class Bench:
    def __init__(self, qtbot):
        self.qtbot = qtbot
        self.presenter = Presenter(Session(document()))
        self.view = PointTable(self.presenter)
        self.table = self.view.table
        self.presenter.add_view(self.view)
        self.notices = []
        self.presenter.noticed.connect(self.notices.append)
        qtbot.addWidget(self.view)
        self.view.resize(320, 300)
        with qtbot.waitExposed(self.view):
            self.view.show()
        self.settle()

    def settle(self):
        self.presenter.refresh_now()
        QApplication.processEvents()

    def text(self, row, column):
        return self.view.model.index(row, column).data()

    def type(self, row, column, text):
        self.table.setCurrentIndex(self.view.model.index(row, column))
        self.qtbot.keyClick(self.table, Qt.Key.Key_F2)
        editor = self.table.findChild(QLineEdit)
        self.qtbot.keyClicks(editor, text)
        self.qtbot.keyClick(editor, Qt.Key.Key_Return)
        self.settle()

    @property
    def undo_entries(self):
        return [entry.label for entry in self.presenter.session.history[1:]]


@pytest.fixture
def bench(qtbot):
    return Bench(qtbot)


def test_every_point_has_a_row_and_a_joint_only_one(bench):
    assert bench.view.model.points == ROWS
    assert [bench.text(row, 0) for row in range(7)] == ["1", "1", "1", "1–2", "2", "2", "2"]
    assert bench.text(1, 1) == "✱ P1"
    assert bench.text(3, 1) == "◆ joint"
    assert float(bench.text(1, RADIUS)) == 45.0


def test_typing_sets_the_exact_value_as_one_undo_entry(bench):
    bench.type(1, RADIUS, "12.5/2 + 3cm")
    assert bench.presenter.document.profile.segments[0].points[1].tolist() == [36.25, 10.0]
    assert bench.undo_entries == ["Set r of P1 of segment 1"]


def test_the_joint_stays_joined(bench):
    bench.type(3, HEIGHT, "64")
    segments = bench.presenter.document.profile.segments
    assert segments[0].points[3].tolist() == segments[1].points[0].tolist() == [38.0, 64.0]


def test_what_is_no_number_is_refused_with_a_message(bench):
    before = bench.presenter.document
    bench.type(1, RADIUS, "twelve")
    assert bench.presenter.document is before
    assert bench.undo_entries == []
    assert "twelve" in bench.notices[-1].text
    assert "r of P1 of segment 1" in bench.notices[-1].text


def test_looking_into_a_cell_changes_nothing(bench):
    before = bench.presenter.document
    bench.type(6, RADIUS, "")
    assert bench.presenter.document is before
    assert bench.undo_entries == []
    assert bench.notices == []


def test_a_cell_shows_few_digits_and_its_editor_all(bench):
    assert bench.text(6, RADIUS) == "0.33"
    index = bench.view.model.index(6, RADIUS)
    assert float(index.data(Qt.ItemDataRole.EditRole)) == 1 / 3


def test_selection_is_shared_both_ways(bench):
    bench.presenter.select(1, 2)
    bench.settle()
    assert [i.row() for i in bench.table.selectionModel().selectedRows()] == [5]
    bench.table.selectRow(3)
    bench.settle()
    assert bench.presenter.view.points == {(0, 3)}
    bench.presenter.select(1, 0)
    bench.settle()
    assert [i.row() for i in bench.table.selectionModel().selectedRows()] == [3]
    assert bench.presenter.view.points == {(1, 0)}


def test_the_selection_outlives_an_edit(bench):
    bench.presenter.select(0, 1)
    bench.settle()
    bench.type(1, RADIUS, "44")
    assert [i.row() for i in bench.table.selectionModel().selectedRows()] == [1]


def test_tab_walks_from_coordinate_to_coordinate(bench):
    bench.table.setCurrentIndex(bench.view.model.index(0, RADIUS))
    bench.table.setFocus()
    cells = []
    for _ in range(3):
        bench.qtbot.keyClick(bench.table, Qt.Key.Key_Tab)
        cells.append((bench.table.currentIndex().row(), bench.table.currentIndex().column()))
    assert cells == [(0, HEIGHT), (1, RADIUS), (1, HEIGHT)]


def test_copy_takes_every_digit(bench):
    bench.table.selectRow(6)
    bench.qtbot.keyClick(bench.table, Qt.Key.Key_C, Qt.KeyboardModifier.ControlModifier)
    assert QGuiApplication.clipboard().text() == f"{1 / 3!r}\t112.0"


def test_rows_follow_the_number_of_segments(bench):
    bench.presenter.replace_document(Document(Profile.of(document().profile.segments[:1])))
    bench.settle()
    assert bench.view.model.rowCount() == 4
