"""The card of one segment in the shape panel: what it is called, and its sliders when unfolded."""

from __future__ import annotations

from PySide6.QtCore import Signal
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

from app.commands.joint_words import chip_state, chip_text, details
from app.panels.shape.card_body import CardBody
from app.panels.shape.card_content import CardContent
from app.state.window_reader import WINDOW, segment_title
from app.theme import icons
from app.widgets.slider_row import SliderRow
from sgb_core.curves.segment import ParameterName


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
        self._body: CardBody | None = None
        layout = QVBoxLayout(self)
        layout.setContentsMargins(4, 3, 4, 3)
        layout.setSpacing(0)
        layout.addLayout(self._build_header())
        self._column = layout
        # The hint wraps, so the height must follow the width; the panel's stretch takes the rest.
        self.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Preferred)

    # Building.

    def _build_header(self) -> QHBoxLayout:
        self.chevron = QToolButton(self)
        self.chevron.setIconSize(self.chevron.iconSize() * 0.75)
        self.chevron.clicked.connect(lambda: self.toggled.emit(not self.is_expanded))
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

    def _build_body(self) -> CardBody:
        body = CardBody(self)
        body.hide()
        body.began.connect(self.began)
        body.changed.connect(self.changed)
        body.ended.connect(self.ended)
        body.cancelled.connect(self.cancelled)
        body.hovered.connect(self.hovered)
        body.refused.connect(self.refused)
        body.apply_to_all.connect(self.apply_to_all)
        body.animate.connect(self.animate)
        body.rule_chosen.connect(self.rule_chosen)
        body.yielding_chosen.connect(self.yielding_chosen)
        body.omega_wanted.connect(self.omega_wanted)
        self._column.addWidget(body)
        before: QWidget = self.title
        for part in body.controls():
            QWidget.setTabOrder(before, part)
            before = part
        if self.content is not None:
            body.show_content(self.content)
        return body

    @property
    def body(self) -> CardBody:
        """What the card unfolds, made when first asked for."""
        if self._body is None:
            self._body = self._build_body()
        return self._body

    @property
    def rows(self) -> dict[ParameterName, SliderRow]:
        """The sliders."""
        return self.body.rows

    def controls(self) -> list[QWidget]:
        """Return what Tab comes to, from top to bottom."""
        inside = [] if self._body is None else self._body.controls()
        return [self.chevron, self.title, *inside]

    # Showing.

    @property
    def is_expanded(self) -> bool:
        """Whether the sliders are shown."""
        return self._body is not None and not self._body.isHidden()

    def show_content(self, content: CardContent, *, moving: bool = False) -> None:
        """Show ``content``; parts that are the same objects as before are left alone.

        While the hand is ``moving`` a slider the card keeps its height.
        """
        old, self.content = self.content, content
        if old is None or (old.index, old.name) != (content.index, content.name):
            self._show_title(content)
        if old is None or not content.has_joint_of(old):
            self._show_chip(content)
        if self._body is not None:
            self._body.show_content(content, moving=moving)

    def show_numbers(self) -> None:
        """Show the document's numbers where the hand has left others, as a refused edit does."""
        if self._body is not None:
            self._body.show_numbers()

    def rest(self) -> None:
        """Say what waited until the hand rested: hints and tooltips."""
        if self._body is not None:
            self._body.show_hint()
            self._body.show_help()

    def show_joint(self) -> None:
        """Show the document's rule again, after one that cannot be kept was chosen."""
        if self._body is not None:
            self._body.show_joint()

    def set_expanded(self, expanded: bool) -> None:
        """Show or fold away the sliders."""
        if self.chevron.icon().isNull() or expanded != self.is_expanded:
            if expanded or self._body is not None:
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
        if self._body is not None:
            self._body.finish()

    def _show_title(self, content: CardContent) -> None:
        number = WINDOW.number(content.index)
        name = f" · {content.name}" if content.name else ""
        self.title.setText(segment_title(content.index, content.name))
        self.title.setAccessibleName(f"Select segment {number}{name}")
        self.title.setToolTip(f"Select segment {number}")
        self.setAccessibleName(f"Segment {number}{name}")
        self._name_chevron()

    def _name_chevron(self) -> None:
        if self.content is not None:
            verb = "Fold" if self.is_expanded else "Unfold"
            self.chevron.setAccessibleName(f"{verb} {WINDOW.segment(self.content.index)}")
            self.chevron.setToolTip(f"{verb} the sliders")

    def _show_chip(self, content: CardContent) -> None:
        joint = content.joint
        self.chip.setVisible(joint is not None)
        if joint is None or content.following is None:
            return
        words = details(joint, content.index, content.following)
        self.chip.setText(chip_text(joint))
        self.chip.setToolTip(words)
        self.chip.setAccessibleName(words)
        state = chip_state(joint)
        if self.chip.property("state") != state:
            self.chip.setProperty("state", state)
            _repolish(self.chip)

    def mousePressEvent(self, event: QMouseEvent) -> None:
        self.pressed.emit()
        event.accept()


def _repolish(widget: QWidget) -> None:
    widget.style().unpolish(widget)
    widget.style().polish(widget)
