"""Where the keyboard goes: from panel to panel by one key, from control to control by Tab."""

from __future__ import annotations

from collections.abc import Callable, Iterable

from PySide6.QtCore import QPoint, Qt
from PySide6.QtWidgets import QApplication, QDockWidget, QWidget

from app.commands.command import Command
from app.widgets.number_field import NumberField
from app.widgets.slider_row import SliderRow

# No window has as many.
_MOST_CONTROLS = 1000


Panels = Callable[[], Iterable[QWidget]]


def walk_commands(panels: Panels) -> list[Command]:
    """Return the commands of the View menu that move the focus to another of the panels."""
    return [
        Command(
            "next_panel",
            "View",
            "Go to next panel",
            lambda: walk(panels(), 1),
            "F6",
            tip="Give the keyboard to the next panel, from left to right and down",
            separator=True,
        ),
        Command(
            "previous_panel",
            "View",
            "Go to previous panel",
            lambda: walk(panels(), -1),
            "Shift+F6",
            tip="Give the keyboard to the panel before",
        ),
    ]


def walk(panels: Iterable[QWidget], by: int) -> None:
    """Give the focus to the panel ``by`` places after the one that has it."""
    shown, focus = in_reading_order(panels), QApplication.focusWidget()
    # Without a focus anywhere the first step leads to the first or the last panel.
    here = -1 if by > 0 else 0
    for number, panel in enumerate(shown):
        if focus is not None and (panel is focus or panel.isAncestorOf(focus)):
            here = number
    if shown:
        enter(shown[(here + by) % len(shown)])


def tab(step: Callable[[], bool]) -> bool:
    """Let Qt's ``step`` move the focus until it lies in sight, past panels behind other tabs.

    Qt alone would stop at controls that nobody sees. The focus chain is not walked from here:
    that makes the wrappers in it children of each other, which a closing window takes with it.
    From a number the focus goes to the next number of its form, past the sliders between, and from
    a slider to the next slider; Return leads from a slider to its number. Returns whether the focus
    has found a place.
    """
    start = QApplication.focusWidget()
    for _ in range(_MOST_CONTROLS):
        if not step():
            return False
        part = QApplication.focusWidget()
        if part is None or not (_is_behind(part) or _is_passed(start, part)):
            return True
    return False


def _is_passed(start: QWidget | None, part: QWidget) -> bool:
    """Whether a part of a row of slider and number lies between two of the other kind."""
    if not isinstance(part.parentWidget(), SliderRow):
        return False
    # A row is entered at its slider, from either side.
    return isinstance(part, NumberField) != isinstance(start, NumberField)


def _is_behind(part: QWidget) -> bool:
    """Whether a control lies in a dock that another tab hides."""
    holder: QWidget | None = part
    while holder is not None and not isinstance(holder, QDockWidget):
        holder = holder.parentWidget()
    return holder is not None and holder.visibleRegion().isEmpty()


def in_reading_order(panels: Iterable[QWidget]) -> list[QWidget]:
    """Return the panels that are to be seen, from left to right and down."""
    shown = [part for part in panels if part.isVisible() and not part.visibleRegion().isEmpty()]

    def place(part: QWidget) -> tuple[int, int]:
        at = part.mapToGlobal(QPoint(0, 0))
        return at.x(), at.y()

    return sorted(shown, key=place)


def enter(panel: QWidget) -> None:
    """Give the focus to a panel, or to the first of its controls."""
    for part in (panel, *panel.findChildren(QWidget)):
        if _takes_tab(part):
            part.setFocus(Qt.FocusReason.TabFocusReason)
            return


def _takes_tab(part: QWidget) -> bool:
    tabs = bool(part.focusPolicy() & Qt.FocusPolicy.TabFocus)
    return tabs and part.isVisible() and part.isEnabled()
