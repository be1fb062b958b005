"""What the command palette offers of a window: its actions, and the panels to go to."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from PySide6.QtGui import QAction
from PySide6.QtWidgets import QDockWidget, QWidget

from app.commands.command import CommandSet


class NamedActions:
    """The actions of one window by the names that say of what they are.

    The action of a panel goes to it, also where a menu would hide it.
    """

    def __init__(
        self,
        commands: CommandSet,
        docks: Mapping[str, QDockWidget],
        go_to: Callable[[QDockWidget], object],
        window: QWidget,
    ) -> None:
        self._commands = commands
        self._docks = docks
        self._go_to = go_to
        self._window = window
        self._shows: dict[str, QAction] = {}

    def entries(self) -> list[tuple[str, QAction]]:
        """Return every action but the palette's own, and what it is called."""
        return [
            (self._commands.words(name), self._shown(name, action))
            for name, action in self._commands.actions.items()
            if name != "palette"
        ]

    def _shown(self, name: str, action: QAction) -> QAction:
        dock = self._docks.get(name.removeprefix("panel_"))
        if not name.startswith("panel_") or dock is None:
            return action
        shows = self._shows.get(name)
        if shows is None:
            shows = self._shows[name] = QAction(action.text(), self._window)
            shows.setObjectName(name)
            shows.setToolTip(f"Go to the panel {action.text()}")
            shows.triggered.connect(lambda _checked=False: self._go_to(dock))
        return shows
