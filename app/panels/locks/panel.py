"""All dimensions and locks of the document: typed, locked, added, removed."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QMenu, QToolButton, QVBoxLayout, QWidget

from app.commands.fairing import moved_words
from app.panels.locks.offers import offers
from app.panels.locks.row import DimensionRow
from app.panels.locks.words import factor_of, name_of
from app.state.number_edits import NumberEdits
from app.state.presenter import Edit, Frame, Presenter
from app.theme import icons
from app.widgets.empty_hint import EmptyHint
from sgb_core.design.fairing.fair import changes
from sgb_core.design.locks.dimension import Dimension
from sgb_core.document import edits
from sgb_core.document.model import Document


class LocksPanel(QWidget):
    """Lists what is dimensioned: locked ones hold, the others only tell."""

    def __init__(self, presenter: Presenter, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._presenter = presenter
        self._kinds: list[Dimension] | None = None
        self.rows: list[DimensionRow] = []
        layout = QVBoxLayout(self)
        layout.setContentsMargins(10, 8, 8, 10)
        layout.setSpacing(6)
        self.add_button = QToolButton(self)
        self.add_button.setText("Add a dimension")
        self.add_button.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextBesideIcon)
        self.add_button.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
        self.add_button.setToolTip(
            "Add a dimension of the object, or of the selected points or segment; its padlock "
            "makes it hold while anything else is dragged, slid or typed"
        )
        icons.bind(self.add_button, "ruler")
        menu = QMenu(self.add_button)
        menu.aboutToShow.connect(self._fill_menu)
        self.add_button.setMenu(menu)
        self.empty = EmptyHint("lock", _EMPTY, self)
        self._list = QVBoxLayout()
        self._list.setSpacing(3)
        layout.addWidget(self.add_button)
        layout.addWidget(self.empty)
        layout.addLayout(self._list)
        layout.addStretch(1)

    # What the hand does.

    def add(self, dimension: Dimension) -> None:
        """Add a dimension, which at first only tells; points and joints are locked at once."""
        presenter = self._presenter
        name = name_of(presenter.document, dimension)

        def edit(document: Document) -> Document:
            told = edits.add_dimension(document, dimension)
            if dimension.is_number or told is document:
                return told
            return edits.set_lock(told, len(told.dimensions) - 1, True)

        presenter.do(f"Add {name}", edit)

    def _fill_menu(self) -> None:
        menu, document = self.add_button.menu(), self._presenter.document
        menu.clear()
        view = self._presenter.view
        whole = False
        for dimension in offers(document, view.points, view.segment):
            is_whole = not dimension.facts.points and not dimension.facts.needs
            if is_whole and not whole and not menu.isEmpty():
                menu.addSeparator()
            whole = is_whole
            action = menu.addAction(name_of(document, dimension))
            action.triggered.connect(partial(self._add, dimension))
        if menu.isEmpty():
            menu.addAction("All there is has been added").setEnabled(False)

    def _add(self, dimension: Dimension, _checked: bool = False) -> None:
        self.add(dimension)

    def _lock(self, number: int, locked: bool) -> None:
        name = self.rows[number].label.toolTip()
        label = f"{'Lock' if locked else 'Unlock'} {name}"
        if not self._presenter.do(label, lambda d: edits.set_lock(d, number, locked)):
            self._presenter.refresh_now()

    def _remove(self, number: int) -> None:
        name = self.rows[number].label.toolTip()
        self._presenter.do(f"Remove {name}", lambda d: edits.remove_dimension(d, number))

    def _setting(self, number: int) -> Callable[[float], Edit]:
        def setting(shown: float) -> Edit:
            def edit(document: Document) -> Document:
                dimension = document.dimensions[number]
                value = shown / factor_of(document, dimension)
                return edits.set_dimension(document, number, value).document

            return edit

        return setting

    def _tell(self, number: int) -> None:
        """Say what a value that was entered has moved."""
        session = self._presenter.session
        if session.position == 0 or session.in_the_way is not None:
            return
        before, after = session.history[session.position - 1].document, session.document
        if len(before.profile) != len(after.profile):
            return
        moved = changes(before.profile, after.profile)
        if moved:
            words = f"{self.rows[number].label.toolTip()}: {moved_words(moved)}."
            self._presenter.notify(words, "info", "Undo", self._presenter.undo)

    # Showing.

    def refresh(self, frame: Frame) -> None:
        """Show the dimensions of a frame."""
        dimensions = frame.document.dimensions
        kinds = [each.freed() for each in dimensions]
        if kinds != self._kinds:
            self._kinds = kinds
            self._rebuild(dimensions)
        if self.visibleRegion().isEmpty() and frame.dragging:
            return
        stopped = () if frame.in_the_way is None else frame.in_the_way.numbers
        for number, (row, dimension) in enumerate(zip(self.rows, dimensions, strict=True)):
            row.show_dimension(frame, dimension, in_the_way=number in stopped)

    def _rebuild(self, dimensions: tuple[Dimension, ...]) -> None:
        for row in self.rows:
            self._list.removeWidget(row)
            row.hide()
            row.deleteLater()
        self.rows = []
        for number, dimension in enumerate(dimensions):
            row = DimensionRow(dimension, self)
            row.lock_wanted.connect(partial(self._lock, number))
            row.removed.connect(partial(self._remove, number))
            if dimension.is_number:
                NumberEdits(self._presenter, self).connect(
                    row.field, dimension.label, self._setting(number)
                )
                row.field.ended.connect(partial(self._tell, number))
            self._list.addWidget(row)
            self.rows.append(row)
        self.empty.setVisible(not dimensions)


_EMPTY = (
    "Add what must be, or must stay: a rim of 80 mm, 350 ml, a point in its place. Type a value "
    "and the shape takes it on by the mildest change; lock it and it holds whatever you drag."
)
