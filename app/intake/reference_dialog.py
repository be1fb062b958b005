"""What lies behind the profile: shown or not, how faintly, locked, where, how large, how turned."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

from PySide6.QtWidgets import (
    QCheckBox,
    QDialog,
    QDialogButtonBox,
    QFormLayout,
    QLabel,
    QPushButton,
    QVBoxLayout,
    QWidget,
)

from app.state.presenter import Frame, Presenter
from app.widgets.form import Row, add_rows
from app.widgets.labels import take_labels
from app.widgets.mark_slider import MarkSlider
from app.widgets.number_field import NumberField
from app.widgets.number_kind import limits
from sgb_core.document import edits
from sgb_core.document.model import Document
from sgb_core.document.reference import Reference
from sgb_core.fields.record import table_of

_Change = Callable[[Document, float], Document]


class ReferenceDialog(QDialog):
    """Stays open beside the window; each change is one undo entry."""

    def __init__(
        self, presenter: Presenter, retrace: Callable[[], object], parent: QWidget
    ) -> None:
        super().__init__(parent)
        self.setWindowTitle("Picture behind")
        self._presenter = presenter
        self.source = QLabel("")
        self.source.setWordWrap(True)
        self.shown, self.locked = QCheckBox("Shown"), QCheckBox("Locked")
        self.opacity = MarkSlider(0.0, 1.0, 0.5, 0.05)
        self.scale = NumberField(**limits(table_of(Reference).row("scale").kind), decimals=5)
        self.turn = NumberField(**limits(table_of(Reference).row("turn_deg").kind), step=0.1)
        self.retrace = QPushButton("Axis, scale, trace again…")
        self.remove = QPushButton("Remove")
        for button in (self.retrace, self.remove):
            button.setAutoDefault(False)
        self.retrace.setToolTip(
            "Set the axis and the scale by two points or the height, or trace the picture again"
        )
        self.remove.setToolTip("Take the picture out of the project")
        form = QFormLayout()
        add_rows(
            form,
            (
                Row("From", self.source),
                Row("", self.shown, "Show it behind the editor and in the viewport", "Shown"),
                Row("", self.locked, "Keep the picture tool (B) from moving it", "Locked"),
                Row("Opacity", self.opacity, "How strongly it shows", "Opacity"),
                Row("Scale", self.scale, "Length of a pixel, about r = 0, h = 0", "Scale"),
                Row("Turn", self.turn, "How many degrees its axis leans, to the right", "Turn"),
                Row("", self.retrace),
                Row("", self.remove),
            ),
        )
        buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Close)
        buttons.rejected.connect(self.reject)
        layout = QVBoxLayout(self)
        layout.addLayout(form)
        layout.addWidget(buttons)
        take_labels(self)
        self._connect(retrace)
        presenter.refreshed.connect(self._refreshed)
        self._refreshed(presenter.frame)

    def _connect(self, retrace: Callable[[], object]) -> None:
        self.shown.clicked.connect(
            lambda on: self._do("Show the picture", partial(edits.change_reference, shown=on))
        )
        self.locked.clicked.connect(
            lambda on: self._do("Lock the picture", partial(edits.change_reference, locked=on))
        )
        present = self._presenter
        parts: tuple[tuple[str, _Change, MarkSlider | NumberField], ...] = (
            ("Opacity of the picture", _set_opacity, self.opacity),
            ("Scale the picture", _set_scale, self.scale),
            ("Turn the picture", _set_turn, self.turn),
        )
        for label, set_to, part in parts:
            part.began.connect(lambda label=label: present.begin(label))
            part.changed.connect(lambda value, set_to=set_to: self._change(set_to, value))
            part.ended.connect(present.commit)
            part.cancelled.connect(present.cancel)
        self.retrace.clicked.connect(retrace)
        self.remove.clicked.connect(
            lambda: present.do("Remove the picture", lambda d: edits.set_reference(d, None))
        )

    def _do(self, label: str, edit: Callable[[Document], Document]) -> None:
        self._presenter.do(label, edit)

    def _change(self, change: _Change, value: float) -> None:
        self._presenter.apply(lambda d: change(d, value))

    def _refreshed(self, frame: Frame) -> None:
        source = frame.document.reference
        parts = (self.shown, self.locked, self.opacity, self.scale, self.turn, self.remove)
        for part in parts:
            part.setEnabled(source is not None)
        self.retrace.setEnabled(source is not None and source.picture is not None)
        if source is None:
            self.source.setText("Nothing lies behind; File > Import brings a picture.")
            return
        self.source.setText(source.name or "a source without a name")
        self.shown.setChecked(source.shown)
        self.locked.setChecked(source.locked)
        self.opacity.set_number(source.opacity)
        self.scale.set_value(source.scale)
        self.turn.set_value(source.turn_deg)


def _set_opacity(document: Document, value: float) -> Document:
    return edits.change_reference(document, opacity=value)


def _set_scale(document: Document, value: float) -> Document:
    return edits.change_reference(document, scale=value)


def _set_turn(document: Document, value: float) -> Document:
    return edits.change_reference(document, turn_deg=value)
