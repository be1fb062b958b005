"""Where the keyboard goes: from panel to panel by one key, from control to control by Tab."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QPoint, Qt
from PySide6.QtWidgets import QApplication, QDockWidget, QWidget

from app.commands import Command

if TYPE_CHECKING:
    from app.main_window import MainWindow


def walk_commands(window: MainWindow) -> list[Command]:
    """Return the commands of the View menu that move the focus to another panel."""
    return [
        Command(
            "next_panel",
            "View",
            "Go to next panel",
            lambda: walk(window, 1),
            "F6",
            tip="Give the keyboard to the next panel, from left to right and down",
            separator=True,
        ),
        Command(
            "previous_panel",
            "View",
            "Go to previous panel",
            lambda: walk(window, -1),
            "Shift+F6",
            tip="Give the keyboard to the panel before",
        ),
    ]


def walk(window: MainWindow, by: int) -> None:
    """Give the focus to the panel ``by`` places after the one that has it."""
    shown, focus = shown_panels(window), QApplication.focusWidget()
    # Without a focus anywhere the first step leads to the first or the last panel.
    here = -1 if by > 0 else 0
    for number, panel in enumerate(shown):
        if focus is not None and (panel is focus or panel.isAncestorOf(focus)):
            here = number
    if shown:
        _enter(shown[(here + by) % len(shown)])


def next_control(window: QWidget, forward: bool) -> QWidget | None:
    """Return the control that Tab leads to, or Shift+Tab; panels behind tabs are passed by.

    Qt itself would walk through them, with a focus that nobody sees.
    """
    focus = QApplication.focusWidget()
    start = window if focus is None or focus.window() is not window else focus
    part, found = start.nextInFocusChain(), None
    # Forwards only: the chain's way back is not always the same one.
    while part is not start and (found is None or not forward):
        reached = part.window() is window and part.focusProxy() is None
        if reached and _takes_tab(part) and not _is_behind(part):
            found = part
        part = part.nextInFocusChain()
    return found


def _is_behind(part: QWidget) -> bool:
    """Whether a control lies in a dock that another tab hides."""
    holder: QWidget | None = part
    while holder is not None and not isinstance(holder, QDockWidget):
        holder = holder.parentWidget()
    return holder is not None and holder.visibleRegion().isEmpty()


def shown_panels(window: MainWindow) -> list[QWidget]:
    """Return the panels that are to be seen, in the order of reading."""
    viewport = window.surface_view
    parts = [viewport.plotter or viewport, *(dock.widget() for dock in window.docks.values())]
    shown = [part for part in parts if part.isVisible() and not part.visibleRegion().isEmpty()]

    def place(part: QWidget) -> tuple[int, int]:
        at = part.mapToGlobal(QPoint(0, 0))
        return at.x(), at.y()

    return sorted(shown, key=place)


def _enter(panel: QWidget) -> None:
    """Give the focus to a panel, or to the first of its controls."""
    part = panel
    while not _takes_tab(part):
        part = part.nextInFocusChain()
        if part is panel or not (part is panel or panel.isAncestorOf(part)):
            return
    part.setFocus(Qt.FocusReason.TabFocusReason)


def _takes_tab(part: QWidget) -> bool:
    tabs = bool(part.focusPolicy() & Qt.FocusPolicy.TabFocus)
    return tabs and part.isVisible() and part.isEnabled()
