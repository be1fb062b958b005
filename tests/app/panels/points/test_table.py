import numpy as np
import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import QApplication

from app.panels.points.grid import HEIGHT, POINT, RADIUS, SEGMENT
from app.panels.points.table import PointModel, PointTable
from app.state.presenter import Presenter
from sgb_core.curves.profile import Profile
from sgb_core.curves.segment import Segment
from sgb_core.document.model import Document
from sgb_core.document.session import Session
from tests.app.mouse import double_click
from tests.benchmarks.window import chain

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
        editor = self.view.delegate.editor
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


def open_cell(bench, row, column):
    bench.table.setCurrentIndex(bench.view.model.index(row, column))
    bench.qtbot.keyClick(bench.table, Qt.Key.Key_F2)
    return bench.view.delegate.editor


def offers(bench, editor):
    return {action.text(): action for action in editor.menu(bench.table).actions()}


def test_an_open_cell_steps_and_escape_takes_the_steps_back_before_it_closes(bench):
    editor = open_cell(bench, 1, RADIUS)
    bench.qtbot.keyClick(editor, Qt.Key.Key_Up)
    bench.settle()
    assert bench.presenter.document.profile.segments[0].points[1][0] > 45.0
    bench.qtbot.keyClick(editor, Qt.Key.Key_Escape)
    bench.settle()
    assert bench.presenter.document.profile.segments[0].points[1][0] == 45.0
    assert bench.undo_entries == []
    assert editor.isVisible()
    bench.qtbot.keyClick(editor, Qt.Key.Key_Escape)
    bench.qtbot.waitUntil(lambda: bench.table.state() == bench.table.State.NoState)


def test_an_open_cell_offers_what_every_number_does(bench):
    bench.type(1, RADIUS, "50")
    editor = open_cell(bench, 1, RADIUS)
    assert "Animate" in offers(bench, editor)
    offers(bench, editor)["Reset to 45"].trigger()
    bench.settle()
    assert bench.presenter.document.profile.segments[0].points[1].tolist() == [45.0, 10.0]


def test_a_coordinate_is_applied_to_all_selected_points_as_one_step(bench):
    bench.presenter.set_view(points=frozenset({(0, 1), (0, 2)}))
    bench.settle()
    editor = open_cell(bench, 2, RADIUS)
    bench.presenter.set_view(points=frozenset({(0, 1), (0, 2)}))
    offers(bench, editor)["Apply to all selected points"].trigger()
    bench.settle()
    assert [p[0] for p in bench.presenter.document.profile.segments[0].points[1:3]] == [52.0, 52.0]
    assert bench.undo_entries == ["Same r for 2 points"]


def test_a_double_click_on_its_name_puts_a_point_back(bench):
    bench.type(1, RADIUS, "50")
    bench.type(1, HEIGHT, "12")
    cell = bench.table.visualRect(bench.view.model.index(1, 1)).center()
    # As the window system sends it: the table takes a double click only where it was pressed.
    bench.qtbot.mouseClick(bench.table.viewport(), Qt.MouseButton.LeftButton, pos=cell)
    double_click(bench.table.viewport(), cell)
    bench.settle()
    assert bench.presenter.document.profile.segments[0].points[1].tolist() == [45.0, 10.0]
    assert bench.undo_entries[-1] == "Reset P1 of segment 1"


def test_tab_leaves_the_table_after_the_last_coordinate_and_before_the_first(bench):
    model, table = bench.view.model, bench.table
    left = []
    table.window().focusNextPrevChild = lambda forward: left.append(forward) or True
    for row, column, key in (
        (model.rowCount() - 1, HEIGHT, Qt.Key.Key_Tab),
        (0, RADIUS, Qt.Key.Key_Backtab),
    ):
        table.setCurrentIndex(model.index(row, column))
        table.setFocus()
        bench.qtbot.keyClick(table, key)
        assert table.currentIndex() == model.index(row, column)
    assert left == [True, False]


def test_another_document_is_shown_from_its_first_point(qtbot):
    bench = Bench(qtbot)
    bench.view.resize(320, 120)
    bench.table.scrollToBottom()
    assert bench.table.verticalScrollBar().value() > 0
    bench.presenter.replace_document(document())
    bench.settle()
    assert bench.table.verticalScrollBar().value() == 0


def test_a_long_chain_is_measured_where_names_are_widest(bench, monkeypatch):
    named, real = [], PointModel._names
    monkeypatch.setattr(
        PointModel, "_names", lambda model, point: named.append(point) or real(model, point)
    )
    asked = []
    for count in (40, 160):
        named.clear()
        bench.presenter.replace_document(chain(count))
        bench.settle()
        asked.append(len(named))
    assert asked[1] < 1.2 * asked[0] < 1000
    for column in (SEGMENT, POINT):
        hints = [
            bench.table.sizeHintForIndex(bench.view.model.index(row, column)).width()
            for row in range(bench.view.model.rowCount())
        ]
        assert bench.table.columnWidth(column) >= max(hints)
