"""The Vary panel: laws by which shape parameters change around the turn."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

from PySide6.QtCore import QSignalBlocker, QSize
from PySide6.QtWidgets import (
    QHBoxLayout,
    QLabel,
    QListWidget,
    QMenu,
    QSizePolicy,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from app.panels.laws.form import LawForm
from app.panels.laws.pictures import shape_picture
from app.panels.laws.twist import TwistSection
from app.panels.laws.words import default_law, offered, row_text
from app.state.edit_gesture import EditGesture
from app.state.parameter_animation import Sway
from app.state.presenter import Frame, Presenter
from app.theme import theme
from app.widgets.empty_hint import EmptyHint
from app.widgets.menu_button import open_menu
from sgb_core.document import edits
from sgb_core.document.model import Document
from sgb_core.surfaces.laws.law import Law
from sgb_core.surfaces.laws.shape import LawShape

_EMPTY = (
    "The profile is the same at every angle. Add a law, and λ1, λ2, λ3, ω or the radius change "
    "around the turn: flutes, lobes, sides."
)
_ROWS_SHOWN = 4


class VariationPanel(QWidget):
    """Shows the document's laws, the chosen one with its angle curve; edits them as gestures."""

    def __init__(self, presenter: Presenter, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._presenter = presenter
        self._gesture = EditGesture(presenter)
        self.sway = Sway(presenter, self)
        self._frame: Frame | None = None
        self._index = 0
        layout = QVBoxLayout(self)
        layout.setContentsMargins(12, 8, 8, 10)
        layout.setSpacing(6)
        heading = QLabel("Laws over the angle", self)
        heading.setProperty("role", "heading")
        layout.addWidget(heading)
        layout.addLayout(self._build_head())
        self.empty = EmptyHint("lobes", _EMPTY, self)
        layout.addWidget(self.empty)
        self.list = QListWidget(self)
        self.list.setAccessibleName("Laws")
        self.list.setToolTip("Where two laws name the same parameter of a segment the later counts")
        self.list.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        self._row_height = self.list.fontMetrics().height() + 8
        self.list.currentRowChanged.connect(self._chosen)
        layout.addWidget(self.list)
        self.form = LawForm(self)
        self.form.began.connect(self._gesture.begin)
        self.form.changed.connect(self._changed)
        self.form.ended.connect(self._ended)
        self.form.cancelled.connect(self._cancelled)
        self.form.refused.connect(lambda text: presenter.notify(text, "warning"))
        self.form.chosen.connect(self._do)
        self.form.for_all.connect(self._do_for_all)
        self.form.animated.connect(self._animate)
        self.form.removed.connect(self._remove)
        self.form.omega_wanted.connect(self._raise_omega)
        self.form.keys_wanted.connect(self._offer_keys)
        self.form.hovered.connect(lambda angle: presenter.set_view(angle=angle))
        layout.addWidget(self.form)
        layout.addSpacing(8)
        self.twist = TwistSection(presenter, self)
        layout.addWidget(self.twist)
        layout.addStretch(1)

    # Building.

    def _build_head(self) -> QHBoxLayout:
        row = QHBoxLayout()
        row.setSpacing(0)
        self.add_button = self._button("Add", "Let a parameter vary with the angle", "first")
        self.add_button.setText("+ Add")
        menu = QMenu(self.add_button)
        menu.setToolTipsVisible(True)
        self.add_actions = {}
        for shape in offered():
            action = menu.addAction(shape_picture(shape), shape.title)
            action.setToolTip(shape.tip)
            action.triggered.connect(partial(self._add, shape))
            self.add_actions[shape.name] = action
        theme.notifier().changed.connect(self._paint_pictures)
        open_menu(self.add_button, menu)
        self.up_button = self._button("↑", "Move the law up: later ones count more", "middle")
        self.down_button = self._button("↓", "Move the law down: later ones count more", "middle")
        self.remove_button = self._button("Remove", "Remove the law", "last")
        self.up_button.clicked.connect(lambda: self._move(-1))
        self.down_button.clicked.connect(lambda: self._move(1))
        self.remove_button.clicked.connect(self._remove)
        for button in (self.add_button, self.up_button, self.down_button, self.remove_button):
            button.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
            row.addWidget(button, 2 if button in (self.add_button, self.remove_button) else 1)
        return row

    def _paint_pictures(self, _palette: object = None) -> None:
        """Draw the shapes in the theme's colours, which may have changed."""
        for shape in offered():
            self.add_actions[shape.name].setIcon(shape_picture(shape))
        self.form.paint_pictures()

    def _button(self, text: str, tip: str, place: str) -> QToolButton:
        button = QToolButton(self)
        button.setText(text)
        button.setToolTip(tip)
        button.setAccessibleName(tip)
        button.setProperty("segment", place)
        return button

    # What the hand does.

    def _changed(self, change: Callable[[Law], Law]) -> None:
        index = self._index
        if not self._gesture.apply(
            lambda d: edits.replace_law(d, index, change(d.variation[index]))
        ):
            self._show(self._presenter.frame)

    def _ended(self) -> None:
        self._gesture.commit()
        self._show(self._presenter.frame)

    def _cancelled(self) -> None:
        self._gesture.cancel()
        self._show(self._presenter.frame)

    def _do(self, label: str, change: Callable[[Law], Law]) -> None:
        self._finish()
        index = self._index
        self._presenter.do(label, lambda d: edits.replace_law(d, index, change(d.variation[index])))
        self._show(self._presenter.frame)

    def _do_for_all(self, label: str, change: Callable[[Law], Law]) -> None:
        """Change every law of the parameter that the shown one governs, as one step."""
        parameter = self._presenter.document.variation[self._index].parameter

        def edit(document: Document) -> Document:
            for index, law in enumerate(document.variation):
                if law.parameter == parameter:
                    document = edits.replace_law(document, index, change(law))
            return document

        self._finish()
        self._presenter.do(label, edit)

    def _animate(
        self, label: str, low: float, high: float, to: Callable[[float], Callable[[Law], Law]]
    ) -> None:
        index = self._index
        self.sway.start(
            f"Animate {label}",
            low,
            high,
            lambda value: lambda d: edits.replace_law(d, index, to(value)(d.variation[index])),
        )

    def _finish(self) -> None:
        self.form.finish()

    def _add(self, shape: LawShape, _checked: bool = False) -> None:
        self._finish()
        view, document = self._presenter.view, self._presenter.document
        everything = view.all_segments or len(document.profile) == 1
        law = default_law(document, shape, None if everything else (view.segment,))
        if self._presenter.do(f"Add {shape.title.lower()}", lambda d: edits.add_law(d, law)):
            self._index = len(self._presenter.document.variation) - 1
            self.form.forget_keys()
            self._show(self._presenter.frame)

    def _remove(self) -> None:
        self._finish()
        index = self._index
        if self._presenter.do("Remove law", lambda d: edits.remove_law(d, index)):
            self.form.forget_keys()
            self._show(self._presenter.frame)

    def _move(self, step: int) -> None:
        self._finish()
        index = self._index
        if self._presenter.do("Move law", lambda d: edits.move_law(d, index, index + step)):
            self._index = index + step
            self._show(self._presenter.frame)

    def _offer_keys(self, count: int) -> None:
        waves = self._presenter.document.variation[self._index].waves or 1
        self._presenter.notify(
            f"This law has {waves} waves; as a curve of your own it has {count} keys to move.",
            "info",
            f"Make {count} keys",
            lambda: self._do("Curve of your own", edits.as_keyframes),
        )

    def _raise_omega(self) -> None:
        law = self._presenter.document.variation[self._index]

        def edit(document: Document) -> Document:
            for segment in range(len(document.profile)):
                if law.applies_to(segment):
                    document = edits.set_shape_parameter(document, segment, "omega", 1.0)
            return document

        self._presenter.do("ω → 1", edit)

    # Showing.

    def _chosen(self, row: int) -> None:
        if row >= 0 and row != self._index:
            self._finish()
            self._index = row
            self.form.forget_keys()
            self._show(self._presenter.frame)

    def refresh(self, frame: Frame) -> None:
        """Show ``frame``; nothing is touched where the laws and shapes are the same."""
        old, self._frame = self._frame, frame
        if old is not None and old.evaluation is frame.evaluation:
            return
        self._show(frame)

    def _show(self, frame: Frame) -> None:
        laws = frame.document.variation
        self.twist.show_document(frame.document)
        self._index = min(max(self._index, 0), max(len(laws) - 1, 0))
        self.empty.setVisible(not laws)
        self.list.setVisible(bool(laws))
        self.form.setVisible(bool(laws))
        self.remove_button.setEnabled(bool(laws))
        self.up_button.setEnabled(self._index > 0)
        self.down_button.setEnabled(self._index < len(laws) - 1)
        self._show_list(laws)
        if laws:
            self.form.show_law(frame.document, self._index)

    def _show_list(self, laws: tuple[Law, ...]) -> None:
        texts = [row_text(law) for law in laws]
        with QSignalBlocker(self.list):
            if [self.list.item(k).text() for k in range(self.list.count())] != texts:
                while self.list.count() > len(texts):
                    self.list.takeItem(self.list.count() - 1)
                for k, text in enumerate(texts):
                    if k >= self.list.count():
                        self.list.addItem(text)
                        self.list.item(k).setSizeHint(QSize(0, self._row_height))
                    self.list.item(k).setText(text)
                    self.list.item(k).setToolTip(text)
            if self.list.currentRow() != self._index:
                self.list.setCurrentRow(self._index)
        rows = min(max(len(texts), 1), _ROWS_SHOWN)
        self.list.setFixedHeight(self._row_height * rows + 6)
