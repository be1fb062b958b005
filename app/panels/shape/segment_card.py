"""The card of one segment in the shape panel: its sliders and the joint to the next segment."""

from __future__ import annotations

from PySide6.QtCore import QSignalBlocker, Qt, Signal
from PySide6.QtGui import QMouseEvent
from PySide6.QtWidgets import (
    QFrame,
    QHBoxLayout,
    QLabel,
    QPushButton,
    QSizePolicy,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from app.panels.shape import parameter_words
from app.panels.shape.card_content import CardContent
from app.panels.shape.joint_words import RULES, SMOOTH, chip_state, chip_text, details
from app.state.number_edits import PARAMETER_STEPS
from app.state.window_reader import WINDOW, told
from app.theme import icons
from app.widgets.combo_box import QuietComboBox
from app.widgets.slider_row import SliderRow
from sgb_core.curves.segment import (
    PARAMETER_RANGES,
    PARAMETERS,
    SYMBOLS,
    ParameterName,
    neutral,
)


class SegmentCard(QFrame):
    """Shows a segment; tells what the hand does, changes nothing by itself."""

    began = Signal(str)
    changed = Signal(str, float)
    ended = Signal()
    cancelled = Signal()
    hovered = Signal(str, bool)
    refused = Signal(str)
    apply_to_all = Signal(str)
    animate = Signal(str)
    pressed = Signal()
    toggled = Signal(bool)
    rule_chosen = Signal(str)
    yielding_chosen = Signal(str)
    omega_wanted = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setProperty("role", "card")
        self.content: CardContent | None = None
        layout = QVBoxLayout(self)
        layout.setContentsMargins(4, 3, 4, 3)
        layout.setSpacing(0)
        layout.addLayout(self._build_header())
        self.body = QWidget(self)
        body = QVBoxLayout(self.body)
        body.setContentsMargins(5, 2, 2, 5)
        body.setSpacing(2)
        self.rows: dict[ParameterName, SliderRow] = {}
        for parameter in PARAMETERS:
            body.addWidget(self._build_row(parameter))
        body.addWidget(self._build_hint())
        body.addWidget(self._build_joint())
        self.unmet = QLabel(self.body)
        self.unmet.setProperty("role", "muted")
        self.unmet.setWordWrap(True)
        self.unmet.hide()
        body.addWidget(self.unmet)
        layout.addWidget(self.body)
        # The hint wraps, so the height must follow the width; the panel's stretch takes the rest.
        self.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Preferred)

    # Building.

    def _build_header(self) -> QHBoxLayout:
        self.chevron = QToolButton(self)
        self.chevron.setIconSize(self.chevron.iconSize() * 0.75)
        self.chevron.clicked.connect(lambda: self.toggled.emit(self.body.isHidden()))
        self.title = QPushButton(self)
        self.title.setProperty("role", "title")
        self.title.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Preferred)
        self.title.clicked.connect(self.pressed)
        self.chip = QLabel(self)
        self.chip.setProperty("role", "chip")
        self.chip.setProperty("state", "plain")
        self.chip.setSizePolicy(QSizePolicy.Policy.Fixed, QSizePolicy.Policy.Fixed)
        header = QHBoxLayout()
        header.setSpacing(2)
        header.addWidget(self.chevron)
        header.addWidget(self.title, 1)
        header.addWidget(self.chip)
        header.addSpacing(3)
        return header

    def _build_row(self, parameter: ParameterName) -> SliderRow:
        row = SliderRow(
            SYMBOLS[parameter],
            *PARAMETER_RANGES[parameter],
            neutral(parameter),
            PARAMETER_STEPS[parameter],
            for_all=True,
            animated=True,
            parent=self.body,
        )
        row.tell_below(self)
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
        self.hint = QWidget(self.body)
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
        self.joint = QWidget(self.body)
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
        return [self.chevron, self.title, *parts, self.omega_button, self.yielding, self.rule]

    def _rule_activated(self, index: int) -> None:
        joint = self.content.joint if self.content is not None else None
        rule = str(self.rule.itemData(index))
        if joint is not None and joint.rule != rule:
            self.rule_chosen.emit(rule)

    def _yielding_clicked(self) -> None:
        if self.content is not None:
            self.yielding_chosen.emit("later" if self.content.earlier_yields else "earlier")

    # Showing.

    @property
    def is_expanded(self) -> bool:
        """Whether the sliders are shown."""
        return not self.body.isHidden()

    def show_content(self, content: CardContent, *, moving: bool = False) -> None:
        """Show ``content``; parts that are the same objects as before are left alone.

        While the hand is ``moving`` a slider the card keeps its height.
        """
        old, self.content = self.content, content
        same_place = old is not None and (old.index, old.name) == (content.index, content.name)
        if not same_place:
            self._show_title(content)
        laws_same = old is not None and old.laws is content.laws
        if old is None or old.segment is not content.segment or not same_place or not laws_same:
            self._show_values(content)
            self.show_hint(moving=moving)
        if old is None or (old.joint, old.following, old.unmet, old.earlier_yields) != (
            content.joint,
            content.following,
            content.unmet,
            content.earlier_yields,
        ):
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

    def show_joint(self) -> None:
        """Show the document's rule again, after one that cannot be kept was chosen."""
        if self.content is not None:
            self._show_joint(self.content)

    def set_expanded(self, expanded: bool) -> None:
        """Show or fold away the sliders."""
        if self.chevron.icon().isNull() or expanded == self.body.isHidden():
            self.body.setVisible(expanded)
            icons.bind(self.chevron, "chevron-down" if expanded else "chevron-right")
            self._name_chevron()

    def set_selected(self, selected: bool) -> None:
        """Show whether this is the selected segment."""
        state = "true" if selected else "false"
        if self.property("selected") != state:
            self.setProperty("selected", state)
            _repolish(self)

    def finish(self) -> None:
        """End runs of wheel or key steps at once."""
        for row in self.rows.values():
            row.finish()

    def _show_title(self, content: CardContent) -> None:
        number = WINDOW.number(content.index)
        name = f" · {content.name}" if content.name else ""
        self.title.setText(f"{number}{name}" if name else f"Segment {number}")
        self.title.setAccessibleName(f"Select segment {number}{name}")
        self.title.setToolTip(f"Select segment {number}")
        self.setAccessibleName(f"Segment {number}{name}")
        self.rule.setAccessibleName(f"Rule of the joint after segment {number}")
        self.omega_button.setAccessibleName(f"Set ω of segment {number} to 1")
        self._name_chevron()
        for parameter, row in self.rows.items():
            row.set_name(f"{SYMBOLS[parameter]} of segment {number}")

    def _name_chevron(self) -> None:
        if self.content is not None:
            verb = "Fold" if self.is_expanded else "Unfold"
            self.chevron.setAccessibleName(f"{verb} {WINDOW.segment(self.content.index)}")
            self.chevron.setToolTip(f"{verb} the sliders")

    def _show_values(self, content: CardContent) -> None:
        segment = content.segment
        for parameter, row in self.rows.items():
            row.set_number(getattr(segment.shape, parameter))
            law = parameter_words.law_note(content.laws, content.index, parameter)
            row.set_effective(not law and not parameter_words.without_effect(segment, parameter))
            words = parameter_words.tooltip(segment, content.index, parameter)
            row.set_help(f"{words}\n{law}" if law else words)

    def _show_joint(self, content: CardContent, *, moving: bool = False) -> None:
        joint = content.joint
        self._show_unmet(content, moving=moving)
        self.joint.setVisible(joint is not None)
        self.chip.setVisible(joint is not None)
        if joint is None or content.following is None:
            return
        self.joint_label.setText(f"To {WINDOW.number(content.following)}")
        self._show_yielding(content)
        self.chip.setText(chip_text(joint))
        words = details(joint, content.index, content.following)
        self.chip.setToolTip(words)
        self.chip.setAccessibleName(words)
        self.joint.setToolTip(words)
        state = chip_state(joint)
        if self.chip.property("state") != state:
            self.chip.setProperty("state", state)
            _repolish(self.chip)
        with QSignalBlocker(self.rule):
            self.rule.setCurrentIndex(self.rule.findData(joint.rule.value))

    def _show_yielding(self, content: CardContent) -> None:
        own, other = WINDOW.number(content.index), WINDOW.number(content.following or 0)
        moves, holds = (own, other) if content.earlier_yields else (other, own)
        smooth = content.joint is not None and content.joint.rule in SMOOTH
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

    def mousePressEvent(self, event: QMouseEvent) -> None:
        self.pressed.emit()
        event.accept()


def _repolish(widget: QWidget) -> None:
    widget.style().unpolish(widget)
    widget.style().polish(widget)
