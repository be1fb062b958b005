"""Named states of the document: kept in its file, switched between, laid over as a ghost."""

from __future__ import annotations

from PySide6.QtCore import QSignalBlocker, QSize, Qt
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import (
    QAbstractItemView,
    QCheckBox,
    QGridLayout,
    QListWidget,
    QListWidgetItem,
    QPushButton,
    QVBoxLayout,
    QWidget,
)

from app.state.presenter import Frame, Presenter
from app.theme import theme
from app.widgets.empty_hint import EmptyHint
from app.widgets.silhouette import SIDE, silhouette
from sgb_core.document import edits
from sgb_core.document.edits.states import free_state_name, present_state
from sgb_core.document.model import Document


class StateList(QListWidget):
    """Enter shows a state, F2 renames it, Delete throws it away."""

    def __init__(self, panel: StatesPanel) -> None:
        super().__init__(panel)
        self._panel = panel
        self.setAccessibleName("States")
        self.setToolTip("Double-click or Enter shows a state, F2 renames it, Del deletes it")
        self.setEditTriggers(QAbstractItemView.EditTrigger.EditKeyPressed)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        key = event.key()
        editing = self.state() == QAbstractItemView.State.EditingState
        if key in (Qt.Key.Key_Return, Qt.Key.Key_Enter) and not editing:
            self._panel.show_chosen()
        elif key == Qt.Key.Key_Delete:
            self._panel.delete_chosen()
        else:
            super().keyPressEvent(event)


class StatesPanel(QWidget):
    """The list of states and what can be done with the chosen one; all of it undoable."""

    def __init__(self, presenter: Presenter, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._presenter = presenter
        self._names: list[str] | None = None
        self._marked: object = None
        self._drawn: tuple[Document, ...] = ()
        self.list = StateList(self)
        self.store_button = self._button(
            "Store", "Keep the document as it is now as a state of its own", self.store
        )
        self.show_button = self._button("Show", "Go to the chosen state", self.show_chosen)
        self.update_button = self._button(
            "Update", "Replace the chosen state by the document as it is now", self.update_chosen
        )
        self.rename_button = self._button("Rename", "Give the state another name (F2)", self.rename)
        self.copy_button = self._button("Duplicate", "Copy the chosen state", self.duplicate)
        self.delete_button = self._button(
            "Delete", "Throw the chosen state away (Del)", self.delete_chosen
        )
        self.ghost = QCheckBox("Overlay as ghost", self)
        self.ghost.setToolTip("Lay the chosen state over the document as a ghost, to compare")
        self.ghost.toggled.connect(self._ghost_toggled)
        grid = QGridLayout()
        grid.setSpacing(4)
        for place, button in enumerate(self._buttons()):
            grid.addWidget(button, place // 3, place % 3)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(8, 6, 8, 8)
        self.empty = EmptyHint(
            "copy",
            "Store keeps the shape as it is now under a name, to come back to, to compare or "
            "to lay over the present one.",
            self,
        )
        self.list.setIconSize(QSize(SIDE, SIDE))
        layout.addWidget(self.list, 1)
        layout.addWidget(self.empty, 1)
        layout.addWidget(self.ghost)
        layout.addLayout(grid)
        self.list.itemDoubleClicked.connect(lambda _item: self.show_chosen())
        self.list.itemChanged.connect(self._renamed)
        self.list.currentRowChanged.connect(lambda _row: self._chosen_changed())
        theme.notifier().changed.connect(self._recolour)

    def _buttons(self) -> tuple[QPushButton, ...]:
        return (
            self.store_button,
            self.show_button,
            self.update_button,
            self.rename_button,
            self.copy_button,
            self.delete_button,
        )

    def _button(self, text: str, tip: str, run: object) -> QPushButton:
        button = QPushButton(text, self)
        button.setToolTip(tip)
        button.setAccessibleName(f"{text} state")
        button.clicked.connect(run)
        return button

    # What the hand does.

    @property
    def chosen(self) -> str | None:
        """The name of the chosen state."""
        row = self.list.currentRow()
        return self._names[row] if self._names and 0 <= row < len(self._names) else None

    def store(self) -> None:
        """Keep the document as a new state under the next free name."""
        name = free_state_name(self._presenter.document)
        self._presenter.do(f"Store state {name}", lambda d: edits.store_state(d, name))
        self._follow()
        self.choose(name)

    def choose(self, name: str) -> None:
        """Choose a state in the list."""
        if self._names and name in self._names:
            self.list.setCurrentRow(self._names.index(name))

    def step(self, by: int) -> None:
        """Go to the state ``by`` places after the one shown or chosen, round the end."""
        names = [state.name for state in self._presenter.document.states]
        if names:
            now = present_state(self._presenter.document) or self.chosen
            start = names.index(now) if now in names else -1
            self.choose(names[(start + by) % len(names)])
            self.show_chosen()

    def show_chosen(self) -> None:
        """Go to the chosen state."""
        name = self.chosen
        if name is not None:
            self._presenter.do(f"Show state {name}", lambda d: edits.switch_state(d, name))

    def update_chosen(self) -> None:
        """Replace the chosen state by the document as it is now."""
        name = self.chosen
        if name is not None:
            self._presenter.do(f"Update state {name}", lambda d: edits.store_state(d, name))

    def rename(self) -> None:
        """Edit the name of the chosen state in its place."""
        item = self.list.currentItem()
        if item is not None:
            item.setText(self.chosen or "")
            self.list.editItem(item)

    def duplicate(self) -> None:
        """Copy the chosen state under the next free name."""
        name = self.chosen
        if name is None:
            return
        copy = free_state_name(self._presenter.document)
        self._presenter.do(
            f"Duplicate state {name}", lambda d: edits.duplicate_state(d, name, copy)
        )
        self._follow()
        self.choose(copy)

    def delete_chosen(self) -> None:
        """Throw the chosen state away."""
        name = self.chosen
        if name is not None:
            self._presenter.do(f"Delete state {name}", lambda d: edits.delete_state(d, name))

    def _renamed(self, item: QListWidgetItem) -> None:
        old, new = self.chosen, item.text().strip()
        if old is None or self._names is None or self.list.row(item) != self.list.currentRow():
            return
        if new != old and not self._presenter.do(
            f"Rename state {old}", lambda d: edits.rename_state(d, old, new)
        ):
            self._names = None
        elif self._presenter.view.ghost_state == old:
            self._presenter.set_view(ghost_state=new)
        self._presenter.refresh_now()

    def _chosen_changed(self) -> None:
        self._enable()
        if self.ghost.isChecked():
            self._presenter.set_view(ghost_state=self.chosen)

    def _ghost_toggled(self, on: bool) -> None:
        self._presenter.set_view(ghost_state=self.chosen if on else None)

    # Showing.

    def _follow(self) -> None:
        """Show what was just done, whether the panel can be seen or not."""
        self._presenter.refresh_now()
        self.refresh(self._presenter.frame)

    def refresh(self, frame: Frame) -> None:
        """Show the states of ``frame``; the one that the document equals carries a mark."""
        states = frame.document.states
        names = [state.name for state in states]
        refilled = names != self._names
        if refilled:
            self._fill(names)
        if refilled or states is not self._drawn:
            self._draw(states)
        if not frame.dragging and (refilled or frame.document is not self._marked):
            self._marked = frame.document
            self._mark(present_state(frame.document))
        if frame.view.ghost_state is not None and frame.view.ghost_state not in names:
            self._presenter.set_view(ghost_state=None)
        with QSignalBlocker(self.ghost):
            self.ghost.setChecked(frame.view.ghost_state is not None)
        self._enable()

    def _fill(self, names: list[str]) -> None:
        chosen, row = self.chosen, self.list.currentRow()
        with QSignalBlocker(self.list):
            self.list.clear()
            self._names = names
            for name in names:
                item = QListWidgetItem(name)
                item.setFlags(item.flags() | Qt.ItemFlag.ItemIsEditable)
                self.list.addItem(item)
            if chosen in names:
                row = names.index(chosen)
            self.list.setCurrentRow(min(max(row, 0), len(names) - 1))

    def _draw(self, states: tuple[Document, ...]) -> None:
        self._drawn = states
        with QSignalBlocker(self.list):
            for row, state in enumerate(states):
                self.list.item(row).setIcon(silhouette(state.profile, self.devicePixelRatioF()))
        self.list.setVisible(bool(states))
        self.empty.setVisible(not states)

    def _recolour(self, _palette: object) -> None:
        self._draw(self._presenter.document.states)

    def _mark(self, present: str | None) -> None:
        with QSignalBlocker(self.list):
            for row, name in enumerate(self._names or []):
                item, shown = self.list.item(row), name == present
                font = item.font()
                font.setBold(shown)
                item.setFont(font)
                item.setToolTip(f"{name}: shown now" if shown else f"Double-click to show {name}")

    def _enable(self) -> None:
        some = self.chosen is not None
        for button in self._buttons()[1:]:
            button.setEnabled(some)
        self.ghost.setEnabled(some or self.ghost.isChecked())
