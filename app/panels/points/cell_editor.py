"""The number field that opens in a cell of the points table."""

from __future__ import annotations

from functools import partial
from typing import Protocol

from PySide6.QtCore import (
    QAbstractItemModel,
    QEvent,
    QModelIndex,
    QObject,
    QPersistentModelIndex,
    Qt,
)
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import QStyledItemDelegate, QStyleOptionViewItem, QWidget

from app.hand.coordinates import nice_step
from app.hand.hit_test import PointId, canonical
from app.hand.readout import point_name
from app.state.number_edits import NumberEdits
from app.state.presenter import Edit, Presenter
from app.widgets.number_field import NumberField
from sgb_core.document import edits
from sgb_core.document.model import Document

# An editor shows every digit.
_DIGITS = 12
# A step of the wheel, and how far an animation reaches to both sides, in parts of the size.
_STEP = 0.003
_REACH = 0.1
COORDINATES = ("r", "h")

Index = QModelIndex | QPersistentModelIndex


class Cells(Protocol):
    """The table's model, as far as an editor needs it."""

    def coordinate_at(self, index: Index) -> tuple[PointId, int]:
        """Return the control point of a cell, and which of its coordinates: 0 for r, 1 for h."""


class PointDelegate(QStyledItemDelegate):
    """Opens cells as number fields, which edit the document by themselves."""

    def __init__(self, presenter: Presenter, cells: Cells, parent: QWidget) -> None:
        super().__init__(parent)
        self._presenter = presenter
        self._cells = cells
        self._edits = NumberEdits(presenter, parent)
        self.sway = self._edits.sway
        self.editor: NumberField | None = None

    def createEditor(self, parent: QWidget, option: QStyleOptionViewItem, index: Index) -> QWidget:
        point, axis = self._cells.coordinate_at(index)
        document = self._presenter.document
        size = document.profile.size or 1.0
        field = NumberField(
            unit=document.unit.value,
            decimals=_DIGITS,
            step=nice_step(_STEP * size),
            reset=partial(self.before, point, axis),
            parent=parent,
        )
        field.setFrame(False)
        # The column's head says the unit.
        field.set_suffix("")
        field.setAccessibleName(str(index.data(Qt.ItemDataRole.AccessibleTextRole)))
        name = f"{COORDINATES[axis]} of {point_name(document.profile, point)}"
        value = float(document.profile.segments[point[0]].points[point[1], axis])
        self._edits.connect(
            field,
            f"Set {name}",
            partial(_moved, point, axis),
            lambda: (value - _REACH * size, value + _REACH * size),
        )
        field.offer("Apply to all selected points", partial(self._apply_to_all, axis, field))
        self.editor = field
        return field

    def setEditorData(self, editor: QWidget, index: Index) -> None:
        if isinstance(editor, NumberField):
            fresh = editor.text() == ""
            editor.set_value(float(index.data(Qt.ItemDataRole.EditRole)))
            if fresh or editor.hasSelectedText():
                editor.selectAll()

    def setModelData(self, editor: QWidget, model: QAbstractItemModel, index: Index) -> None:
        if isinstance(editor, NumberField):
            editor.finish()
            editor.take_text()

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        # What has been stepped or typed is taken back before the editor closes.
        if isinstance(watched, NumberField) and isinstance(event, QKeyEvent) and watched.is_busy:
            pressed = event.type() == QEvent.Type.KeyPress
            if pressed and event.key() == Qt.Key.Key_Escape:
                return False
        return super().eventFilter(watched, event)

    def before(self, point: PointId, axis: int) -> float | None:
        """Return where a point was when the document was opened or last saved, if it was there."""
        document, origin = self._presenter.document, self._edits.origin
        if len(origin.profile) != len(document.profile):
            return None
        factor = origin.unit.factor_to(document.unit)
        return factor * float(origin.profile.segments[point[0]].points[point[1], axis])

    def put_back(self, point: PointId) -> None:
        """Move a point to where it was when the document was opened or last saved."""
        r, h = self.before(point, 0), self.before(point, 1)
        if r is None or h is None:
            self._presenter.notify("There were other segments when this was opened or last saved.")
            return
        name = point_name(self._presenter.document.profile, point)
        self._presenter.do(f"Reset {name}", lambda d: edits.move_point(d, *point, (r, h)))

    def _apply_to_all(self, axis: int, field: NumberField) -> None:
        value, profile = field.value, self._presenter.document.profile
        places = {}
        for segment, index in canonical(profile, self._presenter.view.points):
            place = profile.segments[segment].points[index].tolist()
            place[axis] = value
            places[segment, index] = place
        label = f"Same {COORDINATES[axis]} for {len(places)} points"
        self._presenter.do(label, lambda d: edits.place_points(d, places))


def _moved(point: PointId, axis: int, value: float) -> Edit:
    def edit(document: Document) -> Document:
        place = document.profile.segments[point[0]].points[point[1]].tolist()
        place[axis] = value
        return edits.move_point(document, *point, tuple(place))

    return edit
