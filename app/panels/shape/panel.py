"""The shape panel: four sliders for every segment, and what can be done with the segments."""

from __future__ import annotations

from dataclasses import replace
from functools import partial
from typing import cast

from PySide6.QtCore import QSignalBlocker, Qt, QTimer
from PySide6.QtWidgets import (
    QCheckBox,
    QHBoxLayout,
    QVBoxLayout,
    QWidget,
)

from app.commands.command import Command
from app.commands.joint import choose_rule
from app.panels.shape import slide_words
from app.panels.shape.card_content import CardContent
from app.panels.shape.segment_buttons import segment_buttons
from app.panels.shape.segment_card import SegmentCard
from app.state.edit_gesture import EditGesture
from app.state.parameter_animation import Sway, visibly_moved
from app.state.presenter import Frame, Presenter
from app.state.view_state import Hover
from app.state.window_reader import WINDOW
from app.widgets.scroll_area import PanelArea
from sgb_core.curves.constraints import earlier_yields
from sgb_core.curves.profile import JointRule, Profile
from sgb_core.curves.rule_chain import Yielding
from sgb_core.curves.segment import PARAMETER_RANGES, ParameterName
from sgb_core.curves.segment_names import segment_names
from sgb_core.curves.unmet import hindrance_at
from sgb_core.document import edits

# So many cards are made in one turn of the event loop.
_AT_ONCE = 24
# So many are made at once while the hand moves something, as by a stroke that adds a segment.
_IN_A_MOVE = 2
# Up to so many segments all cards are open at first.
_OPEN_AT_FIRST = 3


class ShapePanel(QWidget):
    """Cards of sliders, one per segment; made once, reused, and shown afresh where they differ."""

    def __init__(self, presenter: Presenter, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._presenter = presenter
        self._gesture = EditGesture(presenter)
        self.sway = Sway(presenter, self)
        self._frame: Frame | None = None
        self._names: tuple[Profile | None, tuple[str, ...]] = (None, ())
        # What the user folded or unfolded by hand, by segment; forgotten with the document.
        self._unfolded: dict[int, bool] = {}
        self._auto_open: int | None = None
        self.cards: list[SegmentCard] = []
        self._more = QTimer(self, singleShot=True, interval=0)
        self._more.timeout.connect(self._show_more)
        self.all_segments = QCheckBox("All segments together", self)
        self.all_segments.setToolTip(
            "Move the same slider of every segment at once, to the same value"
        )
        self.all_segments.toggled.connect(self._all_toggled)
        top = QHBoxLayout()
        top.setContentsMargins(10, 6, 8, 4)
        top.addWidget(self.all_segments, 1)
        self._area, self._stack = self._build_area()
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(0)
        layout.addLayout(top)
        layout.addWidget(self._area, 1)
        row, self.buttons, self._conditions = segment_buttons(self, presenter, self._run)
        layout.addLayout(row)

    def _build_area(self) -> tuple[PanelArea, QVBoxLayout]:
        content = QWidget(self)
        stack = QVBoxLayout(content)
        stack.setContentsMargins(8, 2, 8, 8)
        stack.setSpacing(6)
        stack.addStretch(1)
        return PanelArea(content), stack

    def _run(self, command: Command, _checked: bool = False) -> None:
        for card in self.cards:
            card.finish()
        command.run()

    def _new_card(self) -> SegmentCard:
        card = SegmentCard(self._area.widget())
        card.began.connect(partial(self._began, card))
        card.changed.connect(partial(self._changed, card))
        card.ended.connect(partial(self._ended, card))
        card.cancelled.connect(self._gesture.cancel)
        card.hovered.connect(partial(self._hovered, card))
        card.refused.connect(lambda text: self._presenter.notify(text, "warning"))
        card.apply_to_all.connect(partial(self._apply_to_all, card))
        card.animate.connect(partial(self._animate, card))
        card.pressed.connect(partial(self._select, card))
        card.toggled.connect(partial(self._toggled, card))
        card.rule_chosen.connect(partial(self._rule_chosen, card))
        card.yielding_chosen.connect(partial(self._yielding_chosen, card))
        card.omega_wanted.connect(partial(self._omega_wanted, card))
        self._stack.insertWidget(len(self.cards), card)
        self.cards.append(card)
        return card

    def _put_in_tab_order(self, cards: list[SegmentCard]) -> None:
        """Let Tab come to new cards after the cards above them and before the buttons below."""
        above = self.cards[: len(self.cards) - len(cards)]
        before: QWidget = above[-1].controls()[-1] if above else self.all_segments
        new = [part for card in cards for part in card.controls()]
        for part in (*new, *self.buttons.values()):
            QWidget.setTabOrder(before, part)
            before = part

    # Showing.

    def refresh(self, frame: Frame) -> None:
        """Show ``frame``; only what differs from the last one is touched."""
        old, self._frame = self._frame, frame
        if old is None or old.generation != frame.generation:
            self._unfolded.clear()
            self._auto_open = None
        with QSignalBlocker(self.all_segments):
            self.all_segments.setChecked(frame.view.all_segments)
        rests = old is not None and old.dragging and not frame.dragging
        if old is None or old.evaluation is not frame.evaluation or rests:
            self._show_segments(frame)
        if old is not None and old.evaluation is frame.evaluation:
            for card in self.cards:
                card.show_numbers()
                if rests:
                    card.rest()
        self._show_selection(frame, old)
        for button, command in self._conditions:
            if command.enabled is not None:
                button.setEnabled(command.enabled(frame))

    def _add_cards(self, count: int, *, moving: bool) -> None:
        """Make the cards that are wanting, of a long chain the next ones only.

        While the hand is ``moving`` something many wait until it rests.
        """
        missing = count - len(self.cards)
        if missing <= 0 or (moving and missing > _IN_A_MOVE):
            return
        self._put_in_tab_order([self._new_card() for _ in range(min(missing, _AT_ONCE))])
        if len(self.cards) < count:
            self._more.start()

    def _show_more(self) -> None:
        """Go on where the last turn of the event loop left off, so that the window stays alive."""
        frame, first = self._frame, len(self.cards)
        if frame is not None and first < len(frame.document.profile):
            self._show_segments(frame, first)
            self._show_cards(frame, first)

    def _show_segments(self, frame: Frame, first: int = 0) -> None:
        profile, laws = frame.document.profile, frame.document.variation
        names = self._segment_names(frame)
        joints = {report.joint: report for report in frame.evaluation.joints}
        count = len(profile.segments)
        self._add_cards(count, moving=frame.dragging)
        shown = enumerate(profile.segments[first : len(self.cards)], start=first)
        for index, segment in shown:
            card, joint = self.cards[index], joints.get(index)
            following = None if joint is None else (index + 1) % count
            content = CardContent(index, names[index], segment, laws, joint, following)
            # Of many cards a hand that drags changes one or two.
            if not (frame.dragging and content.follows(card.content)):
                if joint is not None:
                    unmet = hindrance_at(profile, index, joint)
                    earlier = earlier_yields(profile, index)
                    content = replace(content, unmet=unmet, earlier_yields=earlier)
                card.show_content(content, moving=frame.dragging)
            if card.isHidden():
                card.setVisible(True)
        for card in self.cards[count:]:
            card.setVisible(False)

    def _segment_names(self, frame: Frame) -> tuple[str, ...]:
        # Names keep still while the hand moves: a belly must not become a neck under it.
        profile, names = self._names
        now = frame.document.profile
        if now is not profile and not (frame.dragging and len(names) == len(now)):
            names = segment_names(now)
            self._names = (now, names)
        return names

    def _show_selection(self, frame: Frame, old: Frame | None) -> None:
        count, selected = len(frame.document.profile), frame.view.segment
        moved = (
            old is None
            or old.view.segment != selected
            or len(old.document.profile) != count
            or old.generation != frame.generation
        )
        if moved:
            self._unfold_selected(selected, count)
        if moved or old is None or old.view.all_segments != frame.view.all_segments:
            self._show_cards(frame)
        if moved and old is not None and not frame.dragging:
            # After the layout has settled, so that the whole card comes into view.
            QTimer.singleShot(0, self._reveal_selected)

    def _show_cards(self, frame: Frame, first: int = 0) -> None:
        """Mark and unfold what is chosen, from a card on."""
        count, selected = len(frame.document.profile), frame.view.segment
        for index, card in enumerate(self.cards[first:count], start=first):
            card.set_selected(index == selected or frame.view.all_segments)
            card.set_expanded(self._is_open(index, count))

    def _unfold_selected(self, selected: int, count: int) -> None:
        """Open the selected card; the one opened that way before it closes again.

        Where the selected card is open already nothing folds, so that nothing moves away under
        the pointer.
        """
        if not self._is_open(selected, count) or self._auto_open is None:
            self._unfolded.pop(selected, None)
            self._auto_open = selected

    def _is_open(self, index: int, count: int) -> bool:
        default = count <= _OPEN_AT_FIRST or index == self._auto_open
        return self._unfolded.get(index, default)

    def _reveal_selected(self) -> None:
        if self._frame is not None and self._frame.view.segment < len(self.cards):
            self._area.ensureWidgetVisible(self.cards[self._frame.view.segment], 0, 6)

    # What the hand does.

    def _segment(self, card: SegmentCard) -> int | None:
        """Return the segment that an edit of ``card`` is for, None for all."""
        return None if self._presenter.view.all_segments else self._index(card)

    def _index(self, card: SegmentCard) -> int:
        return self.cards.index(card)

    def _began(self, card: SegmentCard, parameter: str) -> None:
        self._select(card)
        segment, name = self._segment(card), cast(ParameterName, parameter)
        document = self._presenter.document
        notice = slide_words.sleep_notice(document, name, segment)
        if notice is not None:
            self._presenter.notify(notice)
        self._gesture.begin(slide_words.slide_label(document, name, segment))

    def _changed(self, card: SegmentCard, parameter: str, value: float) -> None:
        segment, name = self._segment(card), cast(ParameterName, parameter)
        if not self._gesture.apply(
            lambda document: edits.slide_shape_parameter(document, segment, name, value)
        ):
            card.show_numbers()

    def _ended(self, card: SegmentCard) -> None:
        self._gesture.commit()
        card.show_numbers()

    def _hovered(self, card: SegmentCard, parameter: str, inside: bool) -> None:
        hover = Hover(cast(ParameterName, parameter), self._segment(card))
        if inside:
            self._presenter.set_view(hover=hover)
        elif self._presenter.view.hover == hover:
            self._presenter.set_view(hover=None)

    def _apply_to_all(self, card: SegmentCard, parameter: str) -> None:
        name = cast(ParameterName, parameter)
        value = card.rows[name].number
        self._presenter.do(
            slide_words.label(name, None),
            lambda document: edits.slide_shape_parameter(document, None, name, value),
        )

    def _animate(self, card: SegmentCard, parameter: str) -> None:
        segment, name = self._segment(card), cast(ParameterName, parameter)
        self._select(card)
        self.sway.start(
            f"Animate {slide_words.label(name, segment)}",
            *PARAMETER_RANGES[name],
            lambda value: lambda document: visibly_moved(document, segment, name, value),
        )

    def _select(self, card: SegmentCard) -> None:
        index = self._index(card)
        if self._presenter.view.segment != index:
            self._presenter.select(index)

    def _toggled(self, card: SegmentCard, expanded: bool) -> None:
        self._unfolded[self._index(card)] = expanded
        card.set_expanded(expanded)

    def _rule_chosen(self, card: SegmentCard, rule: str) -> None:
        if not choose_rule(self._presenter, self._index(card), JointRule(rule)):
            card.show_joint()

    def _yielding_chosen(self, card: SegmentCard, side: str) -> None:
        joint = self._index(card)
        between = WINDOW.joint(*self._presenter.document.profile.neighbours(joint))
        self._presenter.do(
            f"Which side yields at {between}",
            lambda document: edits.set_yielding(document, joint, cast(Yielding, side)),
        )

    def hand_over(self, segment: int, parameter: ParameterName) -> None:
        """Give the keyboard to the slider of a parameter of a segment, which lights it up."""
        self._presenter.select(segment)
        self._presenter.refresh_now()
        self._reveal_selected()
        self.cards[segment].rows[parameter].slider.setFocus(Qt.FocusReason.OtherFocusReason)

    def _omega_wanted(self, card: SegmentCard) -> None:
        segment = self._segment(card)
        self._presenter.do(
            slide_words.label("omega", segment),
            lambda document: edits.set_shape_parameter(document, segment, "omega", 1.0),
        )

    def _all_toggled(self, checked: bool) -> None:
        self._presenter.set_view(all_segments=checked)
