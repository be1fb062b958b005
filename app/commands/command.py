"""One table of everything the window can be told to do, as menus, toolbar and palette show it."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from PySide6.QtGui import QAction, QKeySequence
from PySide6.QtWidgets import QMainWindow, QMenu

from app.state.presenter import Frame
from app.state.unforeseen import guarded
from app.theme import icons
from sgb_core.values import dataclass

Shortcut = str | QKeySequence.StandardKey | None


@dataclass(frozen=True, slots=True)
class Command:
    """One action: its place in the menus ("Segment" or "View/Standard views"), and its state.

    ``state`` says whether a checkable action is checked, ``enabled`` whether it can be done and
    ``label`` what it is called just now, each from the newest frame.
    """

    name: str
    menu: str
    text: str
    run: Callable[[], object]
    shortcut: Shortcut = None
    icon: str = ""
    tip: str = ""
    separator: bool = False
    state: Callable[[Frame], bool] | None = None
    enabled: Callable[[Frame], bool] | None = None
    label: Callable[[Frame], str] | None = None


class CommandSet:
    """The QActions of a window, built from commands and kept true to each frame.

    ``menus`` are those that the window has already, by their titles.
    """

    def __init__(
        self, window: QMainWindow, commands: list[Command], menus: Mapping[str, QMenu]
    ) -> None:
        self._window = window
        self._menus = dict(menus)
        self._last: Frame | None = None
        self.commands = {command.name: command for command in commands}
        self._words: dict[str, str] = {}
        self.actions = {command.name: self._build(command) for command in commands}

    def __getitem__(self, name: str) -> QAction:
        return self.actions[name]

    def menu(self, path: str) -> QMenu:
        """Return the menu at ``path``, made on first use."""
        if path not in self._menus:
            parent, _, title = path.rpartition("/")
            holder = self.menu(parent) if parent else self._window.menuBar()
            self._menus[path] = holder.addMenu(title if parent else f"&{title}")
            self._menus[path].setToolTipsVisible(True)
        return self._menus[path]

    def adopt(self, name: str, menu: QMenu, action: QAction, words: str) -> None:
        """Take in an action made elsewhere, so that it has a place in palette and keys too."""
        action.setObjectName(name)
        menu.addAction(action)
        self._window.addAction(action)
        self.actions[name] = action
        self._words[name] = words

    def words(self, name: str) -> str:
        """Return what an action is called where its menu is not seen beside it."""
        if name in self._words:
            return self._words[name]
        text, command = self.actions[name].text(), self.commands.get(name)
        group = "" if command is None else command.menu.partition("/")[2]
        return f"{group}: {text}" if group else text

    def refresh(self, frame: Frame) -> None:
        """Bring check marks, enabling and labels up to date.

        In the middle of a drag nobody opens a menu: what its first frame said holds to its end.
        """
        last, self._last = self._last, frame
        if last is not None and last.dragging and frame.dragging and last.view == frame.view:
            return
        # One that fails keeps no other from saying what holds now.
        show = guarded(self._show)
        for name in self.commands:
            show(name, frame)

    def _show(self, name: str, frame: Frame) -> None:
        command, action = self.commands[name], self.actions[name]
        if command.state is not None:
            action.setChecked(command.state(frame))
        if command.enabled is not None:
            action.setEnabled(command.enabled(frame))
        if command.label is not None:
            action.setText(command.label(frame))

    def retip(self, name: str) -> None:
        """Say an action's new key in its tooltip."""
        if name in self.commands:
            self.actions[name].setToolTip(_tip(self.commands[name], self.actions[name]))

    def _build(self, command: Command) -> QAction:
        action = QAction(command.text, self._window)
        action.setObjectName(command.name)
        if command.shortcut is not None:
            action.setShortcut(QKeySequence(command.shortcut))
        if command.icon:
            icons.bind(action, command.icon)
        action.setToolTip(_tip(command, action))
        action.setStatusTip("")
        action.setCheckable(command.state is not None)
        # The checked flag is not passed on: the frame that follows says what is checked.
        action.triggered.connect(lambda _checked=False: command.run())
        menu = self.menu(command.menu)
        if command.separator:
            menu.addSeparator()
        menu.addAction(action)
        # Keys work too while the menu bar is hidden.
        self._window.addAction(action)
        return action


def _tip(command: Command, action: QAction) -> str:
    keys = action.shortcut().toString(QKeySequence.SequenceFormat.NativeText)
    words = command.tip or command.text.rstrip("…")
    return f"{words} ({keys})" if keys else words
