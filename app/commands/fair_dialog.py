"""How the profile is made fair: least of what, by what, and what is kept meanwhile."""

from __future__ import annotations

from PySide6.QtWidgets import (
    QCheckBox,
    QDialog,
    QDialogButtonBox,
    QFormLayout,
    QLabel,
    QVBoxLayout,
    QWidget,
)

from app.commands.fairing import SYMBOLS, FairChoice, Fairing
from app.state.presenter import Frame, Presenter
from app.widgets.combo_box import QuietComboBox
from app.widgets.form import Row, add_rows, offering
from app.widgets.labels import take_labels
from sgb_core.design.fairing.energy import Energy
from sgb_core.design.fairing.findings import Freedom, Keep
from sgb_core.design.fairing.measure import profile_energy

_ENERGIES = {
    Energy.BENDING: "Curvature",
    Energy.VARIATION: "Variation of curvature",
    Energy.SURFACE: "Curvature of the surface",
}
_FREEDOMS = {
    Freedom.SHAPE: "Shape parameters alone",
    Freedom.POINTS: "Inner control points too",
}
_KEEPS = {
    Keep.VOLUME: "volume",
    Keep.HEIGHT: "height",
    Keep.MAX_DIAMETER: "greatest diameter",
    Keep.TANGENTS: "directions of all legs",
}


class FairDialog(QDialog):
    """Stays open beside the window; each time it makes fair is one undo entry."""

    def __init__(self, presenter: Presenter, fairing: Fairing, parent: QWidget) -> None:
        super().__init__(parent)
        self.setWindowTitle("Make fair")
        self._presenter = presenter
        self._fairing = fairing
        self.energy = offering(
            QuietComboBox(),
            [(f"{words}, {SYMBOLS[each]}", each) for each, words in _ENERGIES.items()],
        )
        self.freedom = offering(QuietComboBox(), [(t, each) for each, t in _FREEDOMS.items()])
        self.selection = QCheckBox("Only segments of selected points")
        self.keeps = {each: QCheckBox(words.capitalize()) for each, words in _KEEPS.items()}
        self.present = QLabel()
        self._build()
        self._show_choice()
        for box in (self.energy, self.freedom):
            box.currentIndexChanged.connect(self._take_choice)
        for check in (self.selection, *self.keeps.values()):
            check.toggled.connect(self._take_choice)
        presenter.refreshed.connect(self._refreshed)
        self._refreshed(presenter.frame)

    def _build(self) -> None:
        kept = QVBoxLayout()
        for each, check in self.keeps.items():
            check.setToolTip(f"Keep the {_KEEPS[each]} as it is now")
            kept.addWidget(check)
        form = QFormLayout()
        add_rows(
            form,
            (
                Row("Least", self.energy, "What a fair curve has least of", "Least"),
                Row("By", self.freedom, "What may move; joints and ends stay where they are", "By"),
                Row("", self.selection, "All segments where no point is selected"),
                Row("Keep", kept),
                Row("Now", self.present),
            ),
        )
        buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Close)
        self.make_fair = buttons.addButton("Make fair", QDialogButtonBox.ButtonRole.ApplyRole)
        self.make_fair.setToolTip("Make the profile fair; one step of undo")
        self.make_fair.clicked.connect(self._fairing.start)
        buttons.rejected.connect(self.reject)
        layout = QVBoxLayout(self)
        layout.addLayout(form)
        layout.addWidget(buttons)
        take_labels(self)

    def _show_choice(self) -> None:
        choice = self._fairing.choice
        self.energy.setCurrentIndex(self.energy.findData(choice.energy))
        self.freedom.setCurrentIndex(self.freedom.findData(choice.freedom))
        self.selection.setChecked(choice.selection)
        for each, check in self.keeps.items():
            check.setChecked(each in choice.keep)

    def _take_choice(self) -> None:
        self._fairing.choose(
            FairChoice(
                Energy(self.energy.currentData()),
                Freedom(self.freedom.currentData()),
                self.selection.isChecked(),
                frozenset(each for each, check in self.keeps.items() if check.isChecked()),
            )
        )
        self._refreshed(self._presenter.frame)

    def _refreshed(self, frame: Frame) -> None:
        if frame.dragging:
            return
        surface, energy = frame.evaluation.surface, self._fairing.choice.energy
        value = profile_energy(surface.shape_at(surface.start), energy, surface.sweep)
        self.present.setText("Infinite" if value is None else f"{value:.5g}")
