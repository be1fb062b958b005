"""The points table: every control point with its exact coordinates, to be typed."""

from __future__ import annotations

import numpy as np
from PySide6.QtCore import (
    QAbstractTableModel,
    QItemSelection,
    QItemSelectionModel,
    QModelIndex,
    QPoint,
    QSize,
    Qt,
)
from PySide6.QtGui import QColor
from PySide6.QtWidgets import QAbstractItemView, QHeaderView, QVBoxLayout, QWidget

from app.hand.coordinates import decimals_for, number
from app.hand.hit_test import PointId, canonical, distinct_points, twin_among
from app.hand.readout import point_name
from app.panels.points.cell_editor import COORDINATES, Index, PointDelegate
from app.panels.points.grid import HEIGHT, POINT, RADIUS, SEGMENT, PointGrid
from app.state.presenter import Frame, Presenter
from app.state.view_state import ViewChanges
from app.state.window_reader import WINDOW
from app.theme import theme
from sgb_core.curves.profile import Profile
from sgb_core.document.model import Document

_COORDINATES = dict(zip((RADIUS, HEIGHT), COORDINATES, strict=True))
# Shown with a ten-thousandth of the profile's size; an editor shows every digit.
_SHOWN = 1e-4

_NOWHERE = QModelIndex()


class PointModel(QAbstractTableModel):
    """One row per control point, a joined joint once; coordinates are written as edits."""

    def __init__(self, presenter: Presenter, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._presenter = presenter
        self._frame = presenter.frame
        self._points = distinct_points(self.profile)
        self._joined = self.profile.joined
        self._decimals = self._wanted_decimals()

    @property
    def profile(self) -> Profile:
        """The profile that is shown."""
        return self._frame.document.profile

    @property
    def points(self) -> list[PointId]:
        """The control point of each row."""
        return self._points

    def show(self, frame: Frame) -> bool:
        """Show a frame; return whether the rows themselves have changed."""
        old, self._frame = self._frame, frame
        if old.document is frame.document:
            return False
        if same_points(old.document, frame.document):
            return False
        points = distinct_points(self.profile)
        self._joined = self.profile.joined
        self._decimals = self._wanted_decimals()
        if points != self._points:
            self.beginResetModel()
            self._points = points
            self.endResetModel()
            return True
        # The first two columns say the same as before; they would be measured again for it.
        self.dataChanged.emit(self.index(0, RADIUS), self.index(len(points) - 1, HEIGHT))
        if old.document.unit is not frame.document.unit:
            self.headerDataChanged.emit(Qt.Orientation.Horizontal, RADIUS, HEIGHT)
        return False

    def rowCount(self, parent: Index = _NOWHERE) -> int:
        return 0 if parent.isValid() else len(self._points)

    def columnCount(self, parent: Index = _NOWHERE) -> int:
        return 0 if parent.isValid() else 4

    def flags(self, index: Index) -> Qt.ItemFlag:
        flags = Qt.ItemFlag.ItemIsEnabled | Qt.ItemFlag.ItemIsSelectable
        return flags | Qt.ItemFlag.ItemIsEditable if index.column() in _COORDINATES else flags

    def headerData(
        self, section: int, orientation: Qt.Orientation, role: int = Qt.ItemDataRole.DisplayRole
    ) -> object:
        if orientation is not Qt.Orientation.Horizontal:
            return None
        unit = self._frame.document.unit
        if role == Qt.ItemDataRole.TextAlignmentRole and section in _COORDINATES:
            return Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter
        if role == Qt.ItemDataRole.DisplayRole:
            return ("#", "Point", f"r ({unit})", f"h ({unit})")[section]
        if role == Qt.ItemDataRole.ToolTipRole:
            return (
                "The segment; at a joint the segments that meet there",
                "✱ P1 and ○ P2 are handles, ■ an end, ◆ a joint of two segments",
                "Distance from the axis; sums and units may be typed: 12.5/2, 3 cm",
                "Height along the axis; sums and units may be typed: 12.5/2, 3 cm",
            )[section]
        return None

    def data(self, index: Index, role: int = Qt.ItemDataRole.DisplayRole) -> object:
        if not index.isValid():
            return None
        point, column = self._points[index.row()], index.column()
        if column in _COORDINATES:
            return self._coordinate(point, column, role)
        if role == Qt.ItemDataRole.DisplayRole:
            return self._names(point)[column]
        if role == Qt.ItemDataRole.ForegroundRole:
            palette = theme.current()
            colors = {1: palette.circle_p1, 2: palette.circle_p2}
            return QColor(colors.get(point[1], palette.polygon) if column else palette.text_muted)
        if role == Qt.ItemDataRole.TextAlignmentRole and column == SEGMENT:
            return Qt.AlignmentFlag.AlignCenter
        if role == Qt.ItemDataRole.AccessibleTextRole:
            return point_name(self.profile, point)
        return None

    def coordinate_at(self, index: Index) -> tuple[PointId, int]:
        """Return the control point of a cell, and which of its coordinates: 0 for r, 1 for h."""
        return self._points[index.row()], index.column() - RADIUS

    def _coordinate(self, point: PointId, column: int, role: int) -> object:
        value = float(self.profile.segments[point[0]].points[point[1], column - RADIUS])
        if role == Qt.ItemDataRole.DisplayRole:
            return number(value, self._decimals)
        if role == Qt.ItemDataRole.EditRole:
            return repr(value)
        if role == Qt.ItemDataRole.TextAlignmentRole:
            return Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter
        if role == Qt.ItemDataRole.AccessibleTextRole:
            name = point_name(self.profile, point)
            return f"{_COORDINATES[column]} of {name}: {number(value, self._decimals)}"
        if role == Qt.ItemDataRole.ForegroundRole and column == RADIUS and value < 0.0:
            return QColor(theme.current().error)
        if role == Qt.ItemDataRole.ToolTipRole:
            beyond = column == RADIUS and value < 0.0
            return f"{value!r}, beyond the axis" if beyond else repr(value)
        return None

    def _names(self, point: PointId) -> tuple[str, str]:
        segment, index = point
        other = twin_among(self._joined, len(self.profile), point)
        if other is not None:
            before, after = (segment, other[0]) if index == 3 else (other[0], segment)
            return f"{WINDOW.number(before)}–{WINDOW.number(after)}", "◆ joint"
        return str(WINDOW.number(segment)), f"{'■✱○■'[index]} P{index}"

    def _wanted_decimals(self) -> int:
        return min(8, decimals_for(_SHOWN * (self.profile.size or 1.0)))


def same_points(old: Document, new: Document) -> bool:
    """Whether two documents have equal control points and unit, as while a slider moves."""
    return (
        old.unit is new.unit
        and old.profile.closed == new.profile.closed
        and np.array_equal(old.profile.control_points, new.profile.control_points)
    )


class PointTable(QWidget):
    """The table of control points; its selection is the profile editor's."""

    def __init__(self, presenter: Presenter, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._presenter = presenter
        self._syncing = False
        self._generation = presenter.frame.generation
        self.model = PointModel(presenter, self)
        self.table = PointGrid(self)
        self.table.setModel(self.model)
        self.delegate = PointDelegate(presenter, self.model, self.table)
        self.table.setItemDelegate(self.delegate)
        self.table.doubleClicked.connect(self._double_clicked)
        self.table.menu_wanted.connect(self._open_menu)
        self.table.setAccessibleName("Control points")
        self.table.setToolTip(
            "Type a coordinate; arrows walk, Enter edits.\n"
            "A double click on its name puts a point back to where it was when last saved."
        )
        self.table.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
        self.table.setAlternatingRowColors(True)
        self.table.setShowGrid(False)
        self.table.setWordWrap(False)
        self.table.setEditTriggers(
            QAbstractItemView.EditTrigger.DoubleClicked
            | QAbstractItemView.EditTrigger.EditKeyPressed
            | QAbstractItemView.EditTrigger.AnyKeyPressed
        )
        self.table.verticalHeader().hide()
        self.table.verticalHeader().setDefaultSectionSize(self.fontMetrics().height() + 8)
        header = self.table.horizontalHeader()
        header.setHighlightSections(False)
        header.setMinimumSectionSize(30)
        for column in (SEGMENT, POINT):
            header.setSectionResizeMode(column, QHeaderView.ResizeMode.ResizeToContents)
        for column in _COORDINATES:
            header.setSectionResizeMode(column, QHeaderView.ResizeMode.Stretch)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(self.table)
        self.setFocusProxy(self.table)
        self.table.selectionModel().selectionChanged.connect(self._selected)
        theme.notifier().changed.connect(self._theme_changed)
        self.refresh(presenter.frame)

    def sizeHint(self) -> QSize:
        return QSize(280, 200)

    def refresh(self, frame: Frame) -> None:
        """Show a frame; the selection follows the profile editor's."""
        self._syncing = True
        try:
            current = self.table.currentIndex()
            row, column = current.row(), current.column()
            rows_changed = self.model.show(frame)
            if rows_changed and 0 <= row < self.model.rowCount():
                self.table.selectionModel().setCurrentIndex(
                    self.model.index(row, column), QItemSelectionModel.SelectionFlag.NoUpdate
                )
            if frame.generation != self._generation:
                self._generation = frame.generation
                self.table.scrollToTop()
            self._select(canonical(frame.document.profile, frame.view.points))
        finally:
            self._syncing = False

    def _select(self, points: list[PointId]) -> None:
        selection = self.table.selectionModel()
        wanted = {self.model.points.index(point) for point in points}
        if wanted == {index.row() for index in selection.selectedRows()}:
            return
        chosen = QItemSelection()
        for row in wanted:
            chosen.select(self.model.index(row, 0), self.model.index(row, HEIGHT))
        selection.select(chosen, QItemSelectionModel.SelectionFlag.ClearAndSelect)
        if wanted and self.table.currentIndex().row() not in wanted:
            first = self.model.index(min(wanted), RADIUS)
            selection.setCurrentIndex(first, QItemSelectionModel.SelectionFlag.NoUpdate)
            self.table.scrollTo(first)

    def _selected(self) -> None:
        if self._syncing:
            return
        rows = sorted(index.row() for index in self.table.selectionModel().selectedRows())
        points = frozenset(self.model.points[row] for row in rows)
        changes: ViewChanges = {"points": points}
        touched = {self._presenter.view.segment} & {segment for segment, _ in points}
        if points and not touched:
            changes["segment"] = self.model.points[rows[0]][0]
        self._presenter.set_view(**changes)

    def _double_clicked(self, index: QModelIndex) -> None:
        """Take a double click on a point's name as one on the label of its numbers."""
        if index.column() not in _COORDINATES:
            self.delegate.put_back(self.model.points[index.row()])

    def _open_menu(self, index: QModelIndex, at: QPoint) -> None:
        """Open the cell, whose number field has the menu."""
        if index.column() in _COORDINATES:
            # A point that is selected among others stays so.
            self.table.selectionModel().setCurrentIndex(
                index, QItemSelectionModel.SelectionFlag.NoUpdate
            )
            self.table.edit(index)
            if self.delegate.editor is not None:
                self.delegate.editor.popup_menu(self.table, at)

    def _theme_changed(self, _palette: object) -> None:
        self.table.viewport().update()
