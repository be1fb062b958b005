"""The twist in the Vary panel: how far the top is turned against the foot, and how it sets in."""

from __future__ import annotations

from functools import partial

from PySide6.QtCore import QSignalBlocker, Qt
from PySide6.QtWidgets import QHBoxLayout, QLabel, QToolButton, QVBoxLayout, QWidget

from app.state.number_edits import NumberEdits
from app.state.presenter import Presenter
from app.widgets.combo_box import QuietComboBox
from app.widgets.labels import take_labels
from app.widgets.slider_row import SliderRow
from sgb_core.document import edits
from sgb_core.document.model import Document
from sgb_core.fields.record import table_of
from sgb_core.surfaces.laws.law import RADIUS, Law
from sgb_core.surfaces.laws.lobes import LOBES
from sgb_core.surfaces.twist import MAX_TURNS, Ease, Twist

# The slider reaches to a turn either way, in steps of nine degrees.
_REACH, _STEP, _GRAIN = 1.0, 0.025, 0.0125
NOTHING_SHOWS = "Without laws every slice is a circle: only paint and textures turn."
KEPT = "Volume, capacity and material stay exactly what they are."


class TwistSection(QWidget):
    """Slider and number of the twist, its ease, and what to know of it."""

    def __init__(self, presenter: Presenter, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._presenter = presenter
        self._edits = NumberEdits(presenter, self, lambda: self.show_document(presenter.document))
        self.sway = self._edits.sway
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(5)
        heading = QLabel("Twist", self)
        heading.setProperty("role", "heading")
        layout.addWidget(heading)
        table = table_of(Twist)
        self.turns = SliderRow(
            "Turns",
            -_REACH,
            _REACH,
            0.0,
            _STEP,
            grain=_GRAIN,
            typed=(-MAX_TURNS, MAX_TURNS),
            parent=self,
        )
        self.turns.set_name("Twist in turns")
        self.turns.set_help(table.row("turns").tip)
        self._edits.connect(
            self.turns,
            "Twist",
            lambda value: partial(edits.set_twist, turns=value),
            lambda: self.turns.range,
        )
        layout.addWidget(self.turns)
        layout.addLayout(self._build_ease())
        self.note = QLabel(self)
        self.note.setWordWrap(True)
        self.note.setProperty("role", "muted")
        layout.addWidget(self.note)
        self.lobes = QToolButton(self)
        self.lobes.setText("Add lobes")
        self.lobes.setToolTip("Let the radius swell eight times around the turn, so that it shows")
        self.lobes.setAccessibleName("Add lobes, so that the twist shows")
        self.lobes.setProperty("segment", "only")
        self.lobes.clicked.connect(self._add_lobes)
        layout.addWidget(self.lobes, 0, Qt.AlignmentFlag.AlignLeft)
        take_labels(self)

    def _build_ease(self) -> QHBoxLayout:
        row = QHBoxLayout()
        row.setSpacing(8)
        field = table_of(Twist).row("ease")
        self.ease = QuietComboBox(self)
        for line, ease in enumerate(Ease):
            self.ease.addItem(field.titles[ease], ease)
            self.ease.setItemData(line, field.tips[ease], Qt.ItemDataRole.ToolTipRole)
        self.ease.setAccessibleName("How the twist sets in")
        self.ease.setToolTip("How the twist sets in along the height")
        self.ease.activated.connect(self._choose_ease)
        label = QLabel(field.label, self)
        label.setBuddy(self.ease)
        row.addWidget(label)
        row.addWidget(self.ease, 1)
        return row

    def _choose_ease(self, line: int) -> None:
        ease = tuple(Ease)[line]
        self._presenter.do("Ease of the twist", lambda d: edits.set_twist(d, ease=ease))

    def _add_lobes(self) -> None:
        law = Law(RADIUS, LOBES.name, *LOBES.natural, **LOBES.first)
        self._presenter.do("Add lobes", lambda d: edits.add_law(d, law))

    def show_document(self, document: Document) -> None:
        """Show a document's twist; controls leave alone what they show already."""
        twist, plain = document.twist, not document.variation
        self.turns.set_number(twist.turns)
        with QSignalBlocker(self.ease):
            self.ease.setCurrentIndex(tuple(Ease).index(twist.ease))
        self.ease.setEnabled(twist.turns != 0.0)
        words = NOTHING_SHOWS if plain else KEPT
        if self.note.text() != words:
            self.note.setText(words)
        self.note.setVisible(twist.turns != 0.0)
        self.lobes.setVisible(plain and twist.turns != 0.0)

    def finish(self) -> None:
        """End runs of wheel or key steps at once."""
        self.turns.finish()
