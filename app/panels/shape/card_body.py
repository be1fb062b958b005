"""What a segment's card unfolds: its sliders and the joint to the next segment."""

from __future__ import annotations

from PySide6.QtCore import QSignalBlocker, Qt, Signal
from PySide6.QtWidgets import QHBoxLayout, QLabel, QToolButton, QVBoxLayout, QWidget

from app.commands.joint_words import RULES, details
from app.panels.shape import parameter_words
from app.panels.shape.card_content import CardContent
from app.panels.shape.parameter_picture import ParameterPicture
from app.state.number_edits import PARAMETER_STEPS
from app.state.window_reader import WINDOW, told
from app.widgets.combo_box import QuietComboBox
from app.widgets.slider_row import SliderRow
from sgb_core.curves.profile import SMOOTH_RULES
from sgb_core.curves.segment import (
    PARAMETER_RANGES,
    PARAMETERS,
    SYMBOLS,
    ParameterName,
    Segment,
    neutral,
)


class CardBody(QWidget):
    """Made when a card is first unfolded: a long chain has hundreds of cards that never are."""

    began = Signal(str)
    changed = Signal(str, float)
    ended = Signal()
    cancelled = Signal()
    hovered = Signal(str, bool)
    refused = Signal(str)
    apply_to_all = Signal(str)
    animate = Signal(str)
    rule_chosen = Signal(str)
    yielding_chosen = Signal(str)
    omega_wanted = Signal()

    def __init__(self, card: QWidget) -> None:
        super().__init__(card)
        self._card = card
        self.content: CardContent | None = None
        # Of which segment the sliders' tooltips tell.
        self._helped: Segment | None = None
        layout = QVBoxLayout(self)
        layout.setContentsMargins(5, 2, 2, 5)
        layout.setSpacing(2)
        self.rows: dict[ParameterName, SliderRow] = {}
        self.pictures: dict[ParameterName, ParameterPicture] = {}
        for parameter in PARAMETERS:
            layout.addWidget(self._build_row(parameter))
        layout.addWidget(self._build_hint())
        layout.addWidget(self._build_joint())
        self.unmet = QLabel(self)
        self.unmet.setProperty("role", "muted")
        self.unmet.setWordWrap(True)
        self.unmet.hide()
        layout.addWidget(self.unmet)

    # Building.

    def _build_row(self, parameter: ParameterName) -> SliderRow:
        row = SliderRow(
            SYMBOLS[parameter],
            *PARAMETER_RANGES[parameter],
            neutral(parameter),
            PARAMETER_STEPS[parameter],
            for_all=True,
            animated=True,
            parent=self,
        )
        self.pictures[parameter] = picture = ParameterPicture(parameter, row)
        row.put_before(picture)
        row.tell_below(self._card)
        row.label.setMinimumWidth(row.label.fontMetrics().horizontalAdvance("λ3") + 3)
        row.began.connect(lambda: self.began.emit(parameter))
        row.changed.connect(lambda value: self.changed.emit(parameter, value))
        row.ended.connect(self.ended)
        row.cancelled.connect(self.cancelled)
        row.refused.connect(self.refused)
        row.hovered.connect(lambda inside: self.hovered.emit(parameter, inside))
        row.apply_to_all.connect(lambda: self.apply_to_all.emit(parameter))
        row.animate.connect(lambda: self.animate.emit(parameter))
        self.rows[parameter] = row
        return row

    def _build_hint(self) -> QWidget:
        self.hint = QWidget(self)
        self.hint_text = QLabel(self.hint)
        self.hint_text.setProperty("role", "muted")
        self.hint_text.setWordWrap(True)
        self.omega_button = QToolButton(self.hint)
        self.omega_button.setText("ω → 1")
        self.omega_button.setProperty("segment", "only")
        self.omega_button.setToolTip("Set ω to 1, so that the three λ take full effect")
        self.omega_button.clicked.connect(self.omega_wanted)
        layout = QHBoxLayout(self.hint)
        layout.setContentsMargins(0, 2, 3, 2)
        layout.addWidget(self.hint_text, 1)
        layout.addWidget(self.omega_button, 0, Qt.AlignmentFlag.AlignVCenter)
        return self.hint

    def _build_joint(self) -> QWidget:
        self.joint = QWidget(self)
        self.joint_label = QLabel(self.joint)
        self.joint_label.setProperty("role", "muted")
        self.rule = QuietComboBox(self.joint)
        for rule, words in RULES.items():
            self.rule.addItem(words, rule.value)
        self.rule.setSizeAdjustPolicy(
            QuietComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon
        )
        self.rule.setMinimumContentsLength(9)
        self.rule.setToolTip("The rule that the joint after this segment keeps while you edit")
        self.rule.activated.connect(self._rule_activated)
        layout = QHBoxLayout(self.joint)
        layout.setContentsMargins(0, 4, 3, 0)
        self.yielding = QToolButton(self.joint)
        self.yielding.setProperty("segment", "only")
        self.yielding.setAccessibleName("Side that yields to the rule")
        self.yielding.setToolTip("Which side of the joint moves for its rule")
        self.yielding.clicked.connect(self._yielding_clicked)
        layout.addWidget(self.joint_label, 1)
        layout.addWidget(self.yielding)
        layout.addWidget(self.rule)
        QWidget.setTabOrder(self.yielding, self.rule)
        return self.joint

    def controls(self) -> list[QWidget]:
        """Return what Tab comes to, from top to bottom."""
        rows = self.rows.values()
        parts = [part for row in rows for part in (row.slider, row.field, row.reset_button)]
        return [*parts, self.omega_button, self.yielding, self.rule]

    def _rule_activated(self, index: int) -> None:
        joint = self.content.joint if self.content is not None else None
        rule = str(self.rule.itemData(index))
        if joint is not None and joint.rule != rule:
            self.rule_chosen.emit(rule)

    def _yielding_clicked(self) -> None:
        if self.content is not None:
            self.yielding_chosen.emit("later" if self.content.earlier_yields else "earlier")

    # Showing.

    def show_content(self, content: CardContent, *, moving: bool = False) -> None:
        """Show ``content``; parts that are the same objects as before are left alone.

        While the hand is ``moving`` a slider the card keeps its height.
        """
        old, self.content = self.content, content
        if old is None or old.index != content.index:
            self._show_names(WINDOW.number(content.index))
        if old is None or not content.has_values_of(old):
            if old is None or old.laws is not content.laws or old.index != content.index:
                self._helped = None
            self._show_values(content)
            self.show_hint(moving=moving)
            if not moving:
                self.show_help()
        if old is None or not content.has_joint_of(old):
            self._show_joint(content, moving=moving)

    def show_numbers(self) -> None:
        """Show the document's numbers where the hand has left others, as a refused edit does."""
        if self.content is not None:
            for parameter, row in self.rows.items():
                row.set_number(getattr(self.content.segment.shape, parameter))

    def show_hint(self, *, moving: bool = False) -> None:
        """Say which sliders do nothing; the line appears and goes only when the hand rests."""
        if self.content is None:
            return
        segment = self.content.segment
        # No line may end in the middle of "ω = 0".
        words = parameter_words.hint(segment).replace(" = ", "\u00a0=\u00a0")
        self.hint.setMinimumHeight(self.hint.height() if moving and self.hint.isVisible() else 0)
        if self.hint_text.text() != words:
            self.hint_text.setText(words)
        self.omega_button.setVisible(segment.shape.omega == 0.0)
        if not moving:
            self.hint.setVisible(bool(words))

    def show_help(self) -> None:
        """Say what each slider does; nobody reads it while the hand moves one."""
        content = self.content
        if content is None or content.segment is self._helped:
            return
        self._helped = content.segment
        for parameter, row in self.rows.items():
            law = parameter_words.law_note(content.laws, content.index, parameter)
            words = parameter_words.tooltip(content.segment, content.index, parameter)
            row.set_caption(parameter_words.caption(content.segment, parameter))
            self.pictures[parameter].show_segment(content.segment)
            row.set_help(f"{words}\n{law}" if law else words)

    def show_joint(self) -> None:
        """Show the document's rule again, after one that cannot be kept was chosen."""
        if self.content is not None:
            self._show_joint(self.content)

    def finish(self) -> None:
        """End runs of wheel or key steps at once."""
        for row in self.rows.values():
            row.finish()

    def _show_names(self, number: int) -> None:
        self.rule.setAccessibleName(f"Rule of the joint after segment {number}")
        self.omega_button.setAccessibleName(f"Set ω of segment {number} to 1")
        for parameter, row in self.rows.items():
            row.set_name(f"{SYMBOLS[parameter]} of segment {number}")

    def _show_values(self, content: CardContent) -> None:
        segment = content.segment
        for parameter, row in self.rows.items():
            row.set_number(getattr(segment.shape, parameter))
            law = parameter_words.law_note(content.laws, content.index, parameter)
            row.set_effective(not law and not parameter_words.without_effect(segment, parameter))

    def _show_joint(self, content: CardContent, *, moving: bool = False) -> None:
        joint = content.joint
        self._show_unmet(content, moving=moving)
        self.joint.setVisible(joint is not None)
        if joint is None or content.following is None:
            return
        self.joint_label.setText(f"To {WINDOW.number(content.following)}")
        self._show_yielding(content)
        self.joint.setToolTip(details(joint, content.index, content.following))
        with QSignalBlocker(self.rule):
            self.rule.setCurrentIndex(self.rule.findData(joint.rule.value))

    def _show_yielding(self, content: CardContent) -> None:
        own, other = WINDOW.number(content.index), WINDOW.number(content.following or 0)
        moves, holds = (own, other) if content.earlier_yields else (other, own)
        smooth = content.joint is not None and content.joint.rule in SMOOTH_RULES
        self.yielding.setVisible(smooth and own != other)
        self.yielding.setText(f"{moves} yields")
        self.yielding.setToolTip(
            f"Where the rule needs a side to move, segment {moves} does and segment {holds} holds."
            "\nClick to let the other one yield."
        )
        self.yielding.setAccessibleName(f"Segment {moves} yields at joint {own}–{other}")

    def _show_unmet(self, content: CardContent, *, moving: bool) -> None:
        """Say why the rule does not hold; the line comes and goes only when the hand rests."""
        joint = content.joint
        if content.unmet is not None and joint is not None:
            self.unmet.setText(f"{joint.rule} is not kept: {told(content.unmet)}.")
        if not moving or (content.unmet is not None and self.unmet.isVisible()):
            self.unmet.setVisible(content.unmet is not None)
